// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "app/command_list.hpp"
#include "app/command_session.hpp"
#include "app/export_options.hpp"
#include "core/base/counted_text.hpp"
#include "core/base/worker_arena.hpp"
#include "core/io/export.hpp"
#include "core/tiles/tile_join.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/report.hpp"

namespace footfall::app {
using namespace detail;
namespace {

struct JoinOptions {
  std::vector<std::string> folders;
  ExportCommandOptions exported;
  std::string statistics;
  int threads = 0;
  bool quiet = false;
};

void protectTiles(WriteTargets& targets, const std::string& folder, const TileSet& set) {
  const auto protect = [&](const std::string& file) {
    targets.protect((std::filesystem::path(folder) / file).string(), Pattern{"a part of the tiles"});
  };
  protect(kTileIndex);
  for (const TileEntry& tile : set.tiles) protect(tile.file);
}

void join(JoinOptions& options) {
  options.exported.finish();
  options.exported.check();
  WriteTargets targets;
  checkEnding(options.statistics, "--stats", ".json");
  targets.add(options.exported.output, Pattern{"the export"});
  targets.add(options.statistics, Pattern{"the statistics"});
  CommandSession session(options.threads, options.quiet);
  RunContext& context = session.context();
  session.begin("joining");
  const JoinedTiles joined = onThreads(options.threads, [&](int) { return joinTiles(options.folders, context); });
  std::size_t tiles = 0;
  for (std::size_t i = 0; i < joined.sets.size(); ++i) {
    protectTiles(targets, options.folders[i], joined.sets[i]);
    tiles += joined.sets[i].tiles.size();
  }
  const Pipeline pipeline = parsePipeline(joined.sets.front().pipeline, options.folders.front());
  session.begin("exporting");
  const double error = writeExport(options.exported, *joined.mesh, pipeline, targets, context);
  if (!options.statistics.empty()) writeFileSafely(options.statistics, formatMeshStatistics(*joined.mesh), context);
  session.end();
  if (options.quiet) return;
  printLosses(*joined.mesh, options.exported, error);
  print(options.exported.output + ": " +
        countedText(joined.mesh->triangles.size(), Pattern{"1 triangle"}, Pattern{"%1 triangles"}).str() + " of " +
        countedText(tiles, Pattern{"1 tile"}, Pattern{"%1 tiles"}).str() + '\n' + formatMeshSummary(*joined.mesh));
}

}  // namespace

void addJoinCommand(CLI::App& app) {
  const auto options = std::make_shared<JoinOptions>();
  CLI::App& command = *app.add_subcommand("join", "Join the tiles of `footfall run --memory` into one file");
  command
      .add_option("FOLDER", options->folders,
                  "The folder with the tiles and their index; for a run in slices, all folders")
      ->required();
  options->exported.addTo(command)->required();
  command.add_option("--stats", options->statistics, "Write counts, links and components to this file")
      ->check(hasName())
      ->type_name("FILE.json");
  addThreads(command, options->threads);
  command.add_flag("--quiet", options->quiet, "No progress bar, no notes and no summary");
  command.callback([options] { join(*options); });
}

}  // namespace footfall::app
