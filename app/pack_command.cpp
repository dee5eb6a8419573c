// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "app/command_list.hpp"
#include "app/command_session.hpp"
#include "core/base/counted_text.hpp"
#include "core/base/worker_arena.hpp"
#include "core/io/file_frame.hpp"
#include "core/io/packed/pack.hpp"
#include "core/io/packed/packed_format.hpp"
#include "footfall/errors.hpp"

namespace footfall::app {
using namespace detail;
namespace {

struct PackCommandOptions {
  EnvironmentOptions environment;
  std::string output;
  int threads = 0;
  bool quiet = false;
};

std::string summaryOf(const std::string& output, const PackResult& result) {
  const PackedCounts& counts = result.counts;
  return output + ": " + countedText(counts.faces, Pattern{"1 triangle"}, Pattern{"%1 triangles"}).str() + ", " +
         countedText(counts.vertices, Pattern{"1 vertex"}, Pattern{"%1 vertices"}).str() + ", " +
         countedText(counts.blocks, Pattern{"1 block"}, Pattern{"%1 blocks"}).str() + ", " +
         countedText(counts.bytes, Pattern{"1 byte"}, Pattern{"%1 bytes"}).str() + '\n';
}

void pack(const PackCommandOptions& options) {
  if (lowerExtension(options.output) != kPackedExtension)
    throw InputError("--output: a packed environment ends in .ffenv; give a name that does");
  const ImportOptions import = options.environment.import();
  WriteTargets targets;
  targets.protectEnvironment(options.environment.path);
  targets.add(options.output, Pattern{"the packed environment"});
  CommandSession session(options.threads, options.quiet);
  session.begin("packing");
  const PackResult result = onThreads(options.threads, [&](int) {
    return packEnvironment(options.environment.path, options.output, import, &session.context());
  });
  session.end();
  if (!options.quiet) {
    for (const Text& note : result.notes) std::cerr << "footfall: note: " << note.str() << '\n';
    if (!result.isStreamed)
      std::cerr << "footfall: note: " << options.environment.path << " was read into memory as a whole\n";
  }
  print(summaryOf(options.output, result));
}

}  // namespace

void addPackCommand(CLI::App& app) {
  const auto options = std::make_shared<PackCommandOptions>();
  CLI::App& command = *app.add_subcommand(
      "pack", "Write an environment in blocks that can be opened at any size, for all commands and the editor");
  options->environment.addFileTo(command);
  command.add_option("-o,--output", options->output, "The packed environment to write")
      ->required()
      ->check(hasName())
      ->type_name("LEVEL.ffenv");
  addThreads(command, options->threads);
  command.add_flag("--quiet", options->quiet, "No progress bar and no notes");
  command.callback([options] { pack(*options); });
}

}  // namespace footfall::app
