// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tile_command.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include "app/command_session.hpp"
#include "core/base/worker_arena.hpp"
#include "core/distributed/rank_group.hpp"
#include "core/environment/part_rules.hpp"
#include "core/io/export.hpp"
#include "core/io/file_frame.hpp"
#include "core/io/packed/pack.hpp"
#include "core/tiles/cell_runner.hpp"
#include "core/tiles/cell_tile.hpp"
#include "core/tiles/tile_folder.hpp"
#include "core/tiles/tile_report.hpp"
#include "core/tiles/tile_run.hpp"
#include "core/tiles/tile_target.hpp"
#include "footfall/errors.hpp"

namespace footfall::app {
using namespace detail;
namespace {

namespace fs = std::filesystem;

void packInto(const std::string& target, const TileCommandOptions& options, CommandSession& session) {
  session.begin("packing");
  const PackResult packed = packEnvironment(options.environment.path, target, options.environment.import(),
                                            &session.context(), packingWithin(options.memory));
  session.end();
  if (options.quiet) return;
  if (!packed.isStreamed)
    std::cerr << "footfall: note: " << options.environment.path << " was read into memory as a whole\n";
}

/// The given pipeline; empty where the default one is meant. Throws InputError where its filters cannot keep to a
/// bound.
std::optional<Pipeline> checkedPipeline(const PipelineOptions& options, const TileSlice& slice,
                                        const RunContext& context) {
  std::optional<Pipeline> pipeline = options.given(&context);
  if (pipeline) {
    checkSlice(stepsOfCells(*pipeline), slice);
    return pipeline;
  }
  try {
    checkSlice(stepsOfCells(defaultPipeline({})), slice);
  } catch (const InputError& error) {
    throw InputError(
        std::string("--memory: the default pipeline cannot be used: ") + error.what() +
        "; give another pipeline, such as --filter \"SlopeFilter 45\" --filter \"VerticalClearanceFilter 2\"");
  }
  return pipeline;
}

void checkOptions(const TileCommandOptions& options) {
  if (options.folder.empty()) throw InputError("--memory: give the folder for the tiles with -o");
}

/// The checks of rank 0 before anything runs. Returns the folder.
std::shared_ptr<TileTarget> makeTarget(const TileCommandOptions& options) {
  WriteTargets targets = targetsBeside(options.environment, options.pipeline);
  checkEnding(options.statistics, "--stats", ".json");
  checkOutside(options.statistics, options.folder,
               FOOTFALL_TEXT("--stats %1: this file is in the folder of the tiles; choose another place"));
  checkOutside(
      options.environment.path, options.folder,
      FOOTFALL_TEXT("%1: this file is in the folder of the tiles; move it, or choose another folder for the tiles"));
  targets.add(options.statistics, Pattern{"the statistics"});
  return std::make_shared<TileTarget>(options.folder);
}

/// The environment, packed; all ranks read the same file.
TileRunResult runPacked(const std::string& file, const TileCommandOptions& options, TileRunOptions bounds,
                        std::optional<Pipeline> pipeline, RankGroup& ranks, CommandSession& session) {
  const bool isPacked = file == options.environment.path;
  const PackedEnvironment environment(file, isPacked ? options.environment.import() : ImportOptions{});
  if (!options.quiet)
    for (const Text& note : environment.head().notes) std::cerr << "footfall: note: " << note.str() << '\n';
  bounds.roles = rolesOf(environment.head(), options.environment.rules(environment.head()));
  if (std::ranges::all_of(bounds.roles, [](PartRole role) { return role == PartRole::Ignored; }))
    throw InputError("--ignore: nothing of " + options.environment.path + " is left; ignore fewer meshes or materials");
  if (!pipeline) pipeline = defaultPipeline(environment.head());
  if (!options.quiet)
    bounds.note = [](const Text& note) { std::cerr << "footfall: note: --memory: " << note.str() << '\n'; };
  session.begin("running in cells", kTileRunSteps);
  TileRunResult made = runIntoTiles(environment, *pipeline, options.folder, bounds, ranks, session.context());
  session.end();
  return made;
}

}  // namespace

void runIntoFolder(const TileCommandOptions& options, RunProgram& program, CommandSession& session) {
  checkOptions(options);
  TileRunOptions bounds;
  bounds.memory = options.memory;
  bounds.slice = parseSlice(options.slice);
  checkMemory(options.environment.path, options.memory);
  OneRank alone;
  RankGroup& ranks = program.group() != nullptr ? *program.group() : alone;
  RunContext& context = session.context();
  const std::optional<Pipeline> pipeline = checkedPipeline(options.pipeline, bounds.slice, context);
  const auto inFolder = [&](const char* name) { return (fs::path(options.folder) / name).string(); };
  // Rank 0 removes what is only there for the run, in this order from the last one on.
  std::shared_ptr<TileTarget> folder;
  std::shared_ptr<FileOfRun> seen, copy;
  const auto ofRun = [&](std::string path) {
    const auto file = std::make_shared<FileOfRun>(std::move(path));
    program.dropAtEnd(file);
    return file;
  };
  if (ranks.isFirst()) program.dropAtEnd(folder = makeTarget(options));
  if (ranks.size() > 1) {
    if (ranks.isFirst()) seen = ofRun(inFolder(kSeenByRanks));
    checkShared(inFolder(kSeenByRanks), options.folder, ranks, context);
  }
  const bool isPacked = lowerExtension(options.environment.path) == kPackedExtension;
  const auto run = [&](int) {
    if (isPacked) return runPacked(options.environment.path, options, bounds, pipeline, ranks, session);
    const std::string packed = inFolder(kPackedForRun);
    if (ranks.isFirst()) {
      copy = ofRun(packed);
      packInto(packed, options, session);
    }
    ranks.fromFirst({}, context);
    return runPacked(packed, options, bounds, pipeline, ranks, session);
  };
  TileRunResult result;
  try {
    result = onThreads(options.threads, run);
  } catch (const Cancelled&) {
    // mpirun cancels the others when it loses a rank: the next run goes on from there.
    if (ranks.isFirst() && ranks.size() > 1 && !ranks.hasFailed()) folder->keep();
    throw;
  }
  if (!ranks.isFirst()) return;
  folder->keep();
  if (!options.statistics.empty())
    writeFileSafely(options.statistics, formatTileStatistics(options.environment.path, options.memory, result),
                    context);
  if (options.quiet) return;
  if (peakOf(result) > options.memory)
    std::cerr << "footfall: note: the run used more than --memory, because floors that many obstacles cut took more "
                 "than usual; give a smaller value\n";
  print(tileSummary(options.folder, result));
}

}  // namespace footfall::app
