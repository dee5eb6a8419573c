// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tile_command.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "app/command_session.hpp"
#include "core/base/counted_text.hpp"
#include "core/base/process_usage.hpp"
#include "core/base/worker_arena.hpp"
#include "core/distributed/rank_group.hpp"
#include "core/environment/part_rules.hpp"
#include "core/io/export.hpp"
#include "core/io/file_frame.hpp"
#include "core/io/packed/pack.hpp"
#include "core/tiles/cell_runner.hpp"
#include "core/tiles/cell_tile.hpp"
#include "core/tiles/tile_folder.hpp"
#include "core/tiles/tile_run.hpp"
#include "footfall/errors.hpp"
#include "footfall/version.hpp"

namespace footfall::app {
using namespace detail;
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMegabyte = std::uint64_t{1} << 20;

/// A lock on a folder that lives as long as the process. On file systems without folder locks, it always succeeds.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder) : file_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (file_ < 0 || ::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    ::close(file_);
    throw InputError("--output: another run is using " + folder.string() + "; wait for it, or give a new name");
  }
  ~FolderLock() {
    if (file_ >= 0) ::close(file_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_;
};

/// The folder of the tiles; where nothing comes of it, it becomes what it was.
class TargetFolder {
 public:
  explicit TargetFolder(const std::string& path) : path_(path) {
    std::error_code error, ignored;
    isMade_ = fs::create_directory(path_, error);
    if (!isMade_ && !fs::exists(path_, ignored))
      throw RunError(path + ": cannot be made: " + error.message() + "; choose another place");
    if (isMade_ || fs::is_directory(path_, error)) lock_.emplace(path_);
    if (isMade_) return;
    isKept_ = hasUnfinished(path);                                   // the run goes on from there
    if (!isKept_ && hasLeftoversOnly(path)) removeUnfinished(path);  // of a run that was killed as it began
    if (!isKept_ && (!fs::is_directory(path_, error) || !fs::is_empty(path_, error)))
      throw InputError("--output: " + path + " already exists and is not an empty folder; give a new name");
  }
  ~TargetFolder() {
    if (isKept_) return;
    removeUnfinished(path_.string());
    std::error_code ignored;
    if (isMade_) fs::remove(path_, ignored);
  }
  TargetFolder(const TargetFolder&) = delete;
  TargetFolder& operator=(const TargetFolder&) = delete;

  void keep() { isKept_ = true; }

 private:
  fs::path path_;
  bool isMade_ = false, isKept_ = false;
  std::optional<FolderLock> lock_;
};

/// A file that is only there for this run.
class FileOfRun {
 public:
  explicit FileOfRun(std::string path) : path_(std::move(path)) {}
  ~FileOfRun() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  FileOfRun(const FileOfRun&) = delete;
  FileOfRun& operator=(const FileOfRun&) = delete;

 private:
  std::string path_;
};

/// Half of the bound: lists of what was read, and as much again while they are sorted.
PackingMemory packingWithin(std::uint64_t memory) {
  PackingMemory packing;
  const auto share = [memory](std::uint64_t part) { return static_cast<std::size_t>(memory / part); };
  packing.scratch = std::min(packing.scratch, share(16));
  packing.cachedPages = std::min(packing.cachedPages, std::max<std::size_t>(share(16) / 49152, 3));
  packing.sortedFaces = std::min(packing.sortedFaces, std::max<std::size_t>(share(8) / 104, 500));
  packing.merged = std::min(packing.merged, share(16));
  return packing;
}

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

/// "2/8".
TileSlice sliceFrom(const std::string& text) {
  TileSlice slice;
  if (text.empty()) return slice;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, slice.number);
  const bool isDivided = number.ec == std::errc() && number.ptr != end && *number.ptr == '/';
  const auto count = isDivided ? std::from_chars(number.ptr + 1, end, slice.count) : number;
  if (!isDivided || count.ec != std::errc() || count.ptr != end || slice.number < 1 || slice.number > slice.count)
    throw InputError("--slice: \"" + text + "\" is not a slice; give K/N, such as 1/8 for the first of eight");
  return slice;
}

void checkOptions(const TileCommandOptions& options) {
  if (options.folder.empty()) throw InputError("--memory: give the folder for the tiles with -o");
}

std::uint64_t peakOf(const TileRunResult& result) {
  std::uint64_t peak = peakRssBytes();
  for (const TileRankStatistics& rank : result.ranks) peak = std::max(peak, rank.peakBytes);
  return peak;
}

std::string formatTileStatistics(const TileCommandOptions& options, const TileRunResult& result) {
  nlohmann::ordered_json json;
  json["footfall"] = FOOTFALL_VERSION;
  json["environment"] = {{"source", options.environment.path}, {"triangles", result.set.triangles}};
  json["pipeline"] = result.set.pipeline;
  json["memory"] = {{"bound_bytes", options.memory}, {"peak_bytes", peakOf(result)}};
  json["cells"] = {{"count", result.counts.cells},
                   {"made_smaller", result.counts.refused},
                   {"taken_over", result.counts.takenOver},
                   {"triangles_read", result.counts.collected},
                   {"most_triangles_at_once", result.counts.largestCell}};
  std::uint64_t triangles = 0, links = 0;
  for (const TileEntry& tile : result.set.tiles) {
    triangles += tile.triangles;
    links += tile.links;
  }
  json["tiles"] = {{"count", result.set.tiles.size()}, {"triangles", triangles}, {"links", links}};
  json["times_ms"] = {{"wall", result.wallMs}, {"cpu", result.cpuMs}};
  json["ranks"] = nlohmann::ordered_json::array();
  for (const TileRankStatistics& rank : result.ranks)
    json["ranks"].push_back({{"rank", json["ranks"].size()},
                             {"cells", rank.counts.cells},
                             {"triangles_read", rank.counts.collected},
                             {"bytes_read", rank.bytesRead},
                             {"peak_bytes", rank.peakBytes},
                             {"wall_ms", rank.wallMs},
                             {"cpu_ms", rank.cpuMs}});
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string summaryOf(const TileCommandOptions& options, const TileRunResult& result) {
  std::uint64_t triangles = 0;
  for (const TileEntry& tile : result.set.tiles) triangles += tile.triangles;
  const auto counted = [](std::uint64_t count, const char* one, const char* many) {
    return countedText(count, Pattern{one}, Pattern{many}).str();
  };
  return options.folder + ": " + counted(result.set.tiles.size(), "1 tile", "%1 tiles") + ", " +
         counted(triangles, "1 walkable triangle", "%1 walkable triangles") + " of " +
         counted(result.set.triangles, "1 triangle", "%1 triangles") + "; peak memory " +
         std::to_string((peakOf(result) + kMegabyte - 1) / kMegabyte) + " MB" +
         (result.ranks.size() > 1 ? ", the most of " + std::to_string(result.ranks.size()) + " ranks\n" : "\n");
}

/// The folder of the tiles may contain only tiles and their index.
void checkOutside(const std::string& path, const std::string& folder, Pattern problem) {
  if (path.empty()) return;
  std::error_code ignored;
  const fs::path file = fs::weakly_canonical(fs::absolute(path), ignored);
  const fs::path tiles = fs::weakly_canonical(fs::absolute(folder), ignored);
  if (file == tiles || file.parent_path() == tiles) throw InputError(problem, path);
}

/// The checks of rank 0 before anything runs. Returns the folder.
std::shared_ptr<TargetFolder> makeTarget(const TileCommandOptions& options) {
  WriteTargets targets = targetsBeside(options.environment, options.pipeline);
  checkEnding(options.statistics, "--stats", ".json");
  checkOutside(options.statistics, options.folder,
               FOOTFALL_TEXT("--stats %1: this file is in the folder of the tiles; choose another place"));
  checkOutside(
      options.environment.path, options.folder,
      FOOTFALL_TEXT("%1: this file is in the folder of the tiles; move it, or choose another folder for the tiles"));
  targets.add(options.statistics, Pattern{"the statistics"});
  return std::make_shared<TargetFolder>(options.folder);
}

/// Throws RunError where the folder of rank 0 is not that of this rank: it must have the file. A network may take a
/// while to show it.
void checkShared(const std::string& file, const std::string& folder, RankGroup& ranks, RunContext& context) {
  constexpr double kPatienceMs = 10000;
  if (ranks.isFirst()) writeFileSafely(file, "The ranks look for this file.\n");
  ranks.fromFirst({}, context);
  const Stopwatch watch;
  std::error_code ignored;
  while (!fs::exists(file, ignored)) {
    context.checkCancelled();
    if (watch.wallMs() > kPatienceMs)
      throw RunError("--output: " + folder + " is not the folder that rank 0 made; give one that all machines share");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ranks.gather({}, context);
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
  bounds.slice = sliceFrom(options.slice);
  checkMemory(options.environment.path, options.memory);
  OneRank alone;
  RankGroup& ranks = program.group() != nullptr ? *program.group() : alone;
  RunContext& context = session.context();
  const std::optional<Pipeline> pipeline = checkedPipeline(options.pipeline, bounds.slice, context);
  const auto inFolder = [&](const char* name) { return (fs::path(options.folder) / name).string(); };
  // Rank 0 removes what is only there for the run, in this order from the last one on.
  std::shared_ptr<TargetFolder> folder;
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
  if (!options.statistics.empty()) writeFileSafely(options.statistics, formatTileStatistics(options, result), context);
  if (options.quiet) return;
  if (peakOf(result) > options.memory)
    std::cerr << "footfall: note: the run used more than --memory, because floors that many obstacles cut took more "
                 "than usual; give a smaller value\n";
  print(summaryOf(options, result));
}

}  // namespace footfall::app
