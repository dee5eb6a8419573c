// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tile_command.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "app/command_session.hpp"
#include "core/base/counted_text.hpp"
#include "core/base/process_usage.hpp"
#include "core/base/worker_arena.hpp"
#include "core/environment/part_rules.hpp"
#include "core/io/export.hpp"
#include "core/io/file_frame.hpp"
#include "core/io/packed/pack.hpp"
#include "core/tiles/cell_tile.hpp"
#include "core/tiles/tile_run.hpp"
#include "footfall/errors.hpp"
#include "footfall/version.hpp"

namespace footfall::app {
using namespace detail;
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMegabyte = std::uint64_t{1} << 20;

/// The folder of the tiles; where it was made for them and nothing comes of it, it is removed again.
class TargetFolder {
 public:
  explicit TargetFolder(const std::string& path) : path_(path) {
    std::error_code error;
    if (fs::exists(path_, error)) {
      if (!fs::is_directory(path_, error) || !fs::is_empty(path_, error))
        throw InputError("--output: " + path + " is there already and is no empty folder; give a new name");
      return;
    }
    isMade_ = fs::create_directory(path_, error);
    if (!isMade_) throw RunError(path + ": cannot be made: " + error.message() + "; choose another place");
  }
  ~TargetFolder() {
    std::error_code ignored;
    if (isMade_) fs::remove(path_, ignored);
  }
  TargetFolder(const TargetFolder&) = delete;
  TargetFolder& operator=(const TargetFolder&) = delete;

  void keep() { isMade_ = false; }

 private:
  fs::path path_;
  bool isMade_ = false;
};

/// A packed environment that is only there for this run.
class PackedCopy {
 public:
  explicit PackedCopy(const std::string& folder) : path_((fs::path(folder) / "environment.ffenv").string()) {}
  ~PackedCopy() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  PackedCopy(const PackedCopy&) = delete;
  PackedCopy& operator=(const PackedCopy&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

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

void packInto(const PackedCopy& copy, const TileCommandOptions& options, CommandSession& session) {
  session.begin("packing");
  const PackResult packed = packEnvironment(options.environment.path, copy.path(), options.environment.import(),
                                            &session.context(), packingWithin(options.memory));
  session.end();
  if (options.quiet) return;
  if (!packed.isStreamed)
    std::cerr << "footfall: note: " << options.environment.path << " was read as a whole, into memory\n";
}

/// The given pipeline; empty where the default one is meant. Throws InputError where its filters cannot keep to a
/// bound.
std::optional<Pipeline> checkedPipeline(const PipelineOptions& options, const TileSlice& slice) {
  std::optional<Pipeline> pipeline = options.given();
  if (pipeline) {
    checkSlice(stepsOfCells(*pipeline), slice);
    return pipeline;
  }
  try {
    checkSlice(stepsOfCells(defaultPipeline({})), slice);
  } catch (const InputError& error) {
    throw InputError(std::string("--memory: the default pipeline does not do: ") + error.what() +
                     "; give one of your own, such as --filter \"SlopeFilter 45\" --filter "
                     "\"VerticalClearanceFilter 2\"");
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
    throw InputError("--slice: \"" + text + "\" is no slice; give K/N, such as 1/8 for the first of eight");
  return slice;
}

void checkOptions(const TileCommandOptions& options) {
  if (options.folder.empty()) throw InputError("--memory: give the folder for the tiles with -o");
}

std::string formatTileStatistics(const TileCommandOptions& options, const TileRunResult& result) {
  nlohmann::ordered_json json;
  json["footfall"] = FOOTFALL_VERSION;
  json["environment"] = {{"source", options.environment.path}, {"triangles", result.set.triangles}};
  json["pipeline"] = result.set.pipeline;
  json["memory"] = {{"bound_bytes", options.memory}, {"peak_bytes", peakRssBytes()}};
  json["cells"] = {{"count", result.cells},
                   {"made_smaller", result.refused},
                   {"triangles_read", result.collected},
                   {"most_triangles_at_once", result.largestCell}};
  std::uint64_t triangles = 0, links = 0;
  for (const TileEntry& tile : result.set.tiles) {
    triangles += tile.triangles;
    links += tile.links;
  }
  json["tiles"] = {{"count", result.set.tiles.size()}, {"triangles", triangles}, {"links", links}};
  json["times_ms"] = {{"wall", result.wallMs}, {"cpu", result.cpuMs}};
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
         std::to_string((peakRssBytes() + kMegabyte - 1) / kMegabyte) + " MB\n";
}

/// Nothing but tiles and their index goes into their folder.
void checkOutside(const std::string& statistics, const std::string& folder) {
  namespace fs = std::filesystem;
  if (statistics.empty()) return;
  std::error_code ignored;
  const fs::path file = fs::weakly_canonical(fs::absolute(statistics), ignored);
  const fs::path tiles = fs::weakly_canonical(fs::absolute(folder), ignored);
  if (file == tiles || file.parent_path() == tiles)
    throw InputError(FOOTFALL_TEXT("--stats %1: this is in the folder of the tiles; name a file elsewhere"),
                     statistics);
}

}  // namespace

void runIntoFolder(const TileCommandOptions& options) {
  checkOptions(options);
  TileRunOptions bounds;
  bounds.memory = options.memory;
  bounds.slice = sliceFrom(options.slice);
  checkMemory(options.environment.path, options.memory);
  std::optional<Pipeline> pipeline = checkedPipeline(options.pipeline, bounds.slice);
  WriteTargets targets = targetsBeside(options.environment, options.pipeline);
  checkEnding(options.statistics, "--stats", ".json");
  checkOutside(options.statistics, options.folder);
  targets.add(options.statistics, Pattern{"the statistics"});
  TargetFolder folder(options.folder);
  CommandSession session(options.threads, options.quiet);
  const TileRunResult result = onThreads(options.threads, [&](int) {
    const bool isPacked = lowerExtension(options.environment.path) == kPackedExtension;
    const PackedCopy copy(options.folder);
    if (!isPacked) packInto(copy, options, session);
    const PackedEnvironment environment(isPacked ? options.environment.path : copy.path(),
                                        isPacked ? options.environment.import() : ImportOptions{});
    if (!options.quiet)
      for (const Text& note : environment.head().notes) std::cerr << "footfall: note: " << note.str() << '\n';
    bounds.roles = rolesOf(environment.head(), options.environment.rules(environment.head()));
    if (std::ranges::all_of(bounds.roles, [](PartRole role) { return role == PartRole::Ignored; }))
      throw InputError("--ignore: nothing of " + options.environment.path +
                       " is left; ignore fewer meshes or materials");
    if (!pipeline) pipeline = defaultPipeline(environment.head());
    session.begin("running in cells", kTileRunSteps);
    TileRunResult made = runIntoTiles(environment, *pipeline, options.folder, bounds, session.context());
    session.end();
    return made;
  });
  folder.keep();
  if (!options.statistics.empty()) writeFileSafely(options.statistics, formatTileStatistics(options, result));
  if (options.quiet) return;
  if (peakRssBytes() > options.memory)
    std::cerr << "footfall: note: the run held more than --memory: floors that many obstacles cut take more than they "
                 "usually do; give less\n";
  print(summaryOf(options, result));
}

}  // namespace footfall::app
