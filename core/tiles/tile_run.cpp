// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_run.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/background_release.hpp"
#include "core/base/process_usage.hpp"
#include "core/io/export.hpp"
#include "core/tiles/cell_tile.hpp"
#include "core/tiles/tile_regions.hpp"
#include "core/tiles/tile_stage.hpp"

namespace footfall::detail {
namespace {

// What a process holds without any triangle, and for each block, triangle and floor of a cell. A city takes half of it;
// other levels cut their floors into more pieces.
constexpr std::uint64_t kOfProcess = std::uint64_t{64} << 20;
constexpr std::uint64_t kOfBlock = 256, kOfFace = 500, kOfFloor = 1000;
constexpr std::uint64_t kDoesNotFit = ~std::uint64_t{0};
constexpr std::uint64_t kMegabyte = std::uint64_t{1} << 20;

std::string inMegabytes(std::uint64_t bytes) { return std::to_string((bytes + kMegabyte - 1) / kMegabyte) + " MB"; }

/// The grid of all vertices but those that ignored faces alone have. Looks at all blocks, and keeps none.
Grid gridOf(const PackedEnvironment& environment, const std::vector<PartRole>& roles, RunContext& context) {
  constexpr std::size_t kReleased = 256;
  Grid grid;
  const auto include = [&grid](const std::array<double, 3>& place) {
    for (const double x : place) grid.include(x);
  };
  for (std::size_t i = 0; i < environment.blocks().size(); ++i) {
    context.checkCancelled();
    const BlockArrays block = environment.block(i);
    const auto isIgnored = [&](std::size_t face) {
      return roles[block.parts.empty() ? 0 : block.parts[face]] == PartRole::Ignored;
    };
    if (roles.empty() || block.faces.empty()) {  // vertices of no face are in blocks of their own
      std::for_each(block.places.begin(), block.places.end(), include);
    } else {
      for (std::size_t f = 0; f < block.faces.size(); ++f)
        if (!isIgnored(f))
          for (const std::uint16_t corner : block.corners[f]) include(block.places[corner]);
    }
    if (i % kReleased == kReleased - 1) environment.forgetBlocks();
  }
  environment.forgetBlocks();
  return grid;
}

/// What collecting has to know; no roles where all parts are floors.
FloorRule ruleOf(const CellSteps& steps, const std::vector<PartRole>& roles) {
  FloorRule rule = floorRuleOf(steps);
  const auto isFloor = [](PartRole role) { return role == PartRole::Floor; };
  if (!std::all_of(roles.begin(), roles.end(), isFloor)) rule.roles = roles;
  return rule;
}

[[noreturn]] void failTooLittle(const std::string& source, std::uint64_t memory, std::uint64_t least) {
  throw InputError(
      FOOTFALL_TEXT("%1: a memory of %2 is too little; give %3 or more, or run without the bound, with all of "
                    "the environment in memory"),
      source, inMegabytes(memory), inMegabytes(least));
}

/// Removes what was written unless the run ends well.
class WrittenFiles {
 public:
  explicit WrittenFiles(const std::string& folder) : folder_(folder) {}
  ~WrittenFiles() {
    std::error_code ignored;
    for (const std::string& file : files_) std::filesystem::remove(folder_ / file, ignored);
  }
  WrittenFiles(const WrittenFiles&) = delete;
  WrittenFiles& operator=(const WrittenFiles&) = delete;

  void add(const std::string& file) { files_.push_back(file); }
  void keep() { files_.clear(); }

 private:
  std::filesystem::path folder_;
  std::vector<std::string> files_;
};

class TileRun {
 public:
  TileRun(const PackedEnvironment& environment, const Pipeline& pipeline, const TileRunOptions& options,
          TileStore& store, RunContext& context)
      : environment_(environment),
        steps_(stepsOfCells(pipeline)),
        options_(options),
        store_(store),
        context_(context),
        rule_(ruleOf(steps_, options.roles)),
        collector_(environment, rule_) {
    checkSlice(steps_, options.slice);
    fixed_ = kOfProcess + kOfBlock * environment.blocks().size();
    if (options.memory <= fixed_ + kOfFace + kOfFloor) failTooLittle(fixed_ + kMegabyte);
    result_.set.frame = environment.head().frame();
    result_.set.bothSides = environment.head().bothSides;
    result_.set.environment = environment.tableSum();
    result_.set.slice = options.slice;
    result_.set.roles = rule_.roles;
    result_.set.pipeline = formatPipeline(pipeline);
    result_.set.triangles = environment.faceCount();
  }

  TileRunResult run() {
    const Stopwatch watch;
    grid_ = gridOf(environment_, rule_.roles, context_);
    const bool isTwice = steps_.step && steps_.minimumArea;
    runAllCells(isTwice ? kTileRunSteps / 2 : kTileRunSteps);
    if (isTwice) linkAfterArea();
    runGaps();
    if (steps_.minimumArea && !isTwice) dropSmallRegions(*steps_.minimumArea);
    if (steps_.minimumLinkedArea) dropSmallRegions(*steps_.minimumLinkedArea);
    if (!steps_.global.empty()) runGlobalSteps();
    result_.wallMs = watch.wallMs();
    result_.cpuMs = watch.cpuMs();
    return std::move(result_);
  }

 private:
  // Faces of the slices up to that one.
  [[nodiscard]] std::uint64_t endOfSlice(std::uint64_t number) const {
    const std::uint64_t faces = collector_.faceCount(), slices = options_.slice.count;
    return faces / slices * number + faces % slices * number / slices;
  }

  /// Whether tiles are to keep what filters over their borders need to know.
  [[nodiscard]] bool isExact() const { return !steps_.global.empty(); }

  [[nodiscard]] std::uint64_t needed(const CellSize& size) const {
    return fixed_ + kOfFace * size.faces + kOfFloor * size.floors;
  }

  [[noreturn]] void failTooLittle(std::uint64_t least) const {
    detail::failTooLittle(environment_.head().source, options_.memory, least);
  }

  // So many triangles as fill the memory if they have as much around them as those before; with some room, and never
  // many more at once, since it may get denser.
  [[nodiscard]] std::uint64_t nextSize(std::uint64_t size, const CellSize& found) const {
    const double room = 0.85 * static_cast<double>(options_.memory - fixed_);
    const double used = static_cast<double>(std::max({needed(found) - fixed_, neededForTile_, kOfFace}));
    const double next = static_cast<double>(size) * std::clamp(room / used, 0.5, 2.0);
    return std::clamp(static_cast<std::uint64_t>(next), std::uint64_t{1},
                      std::max<std::uint64_t>(options_.mostFaces, 1));
  }

  struct MadeCell {
    CellSize size;
    MadeTile made;
  };

  // Empty when the cell does not fit.
  std::optional<MadeCell> makeCell(const OwnFloors& own, const CellCollector::Fits& fits,
                                   const RegionSums::Inspect& inspect = {}) {
    for (reach_ = kUsualReach;; reach_ *= 2) {
      context_.checkCancelled();
      CellSize size;
      std::optional<MadeTile> made = tryCell(own, fits, inspect, size);
      if (size.faces == kDoesNotFit) return std::nullopt;
      if (made) return MadeCell{size, std::move(*made)};
    }
  }

  // Empty when the cell does not fit, with a size that says so, or does not reach far enough.
  std::optional<MadeTile> tryCell(const OwnFloors& own, const CellCollector::Fits& fits,
                                  const RegionSums::Inspect& inspect, CellSize& size) {
    size.faces = kDoesNotFit;
    const std::optional<CellFaces> cell = collector_.collect(own, fits, context_, nullptr, reach_);
    environment_.forgetBlocks();
    if (!cell) return std::nullopt;
    size = {cell->faces.faceNumbers.size(), cell->floors};
    result_.largestCell = std::max(result_.largestCell, size.faces);
    result_.collected += size.faces;
    const CellWork work{steps_.local, isLinked_ && steps_.step ? &*steps_.step : nullptr, &dropped_, isExact()};
    return makeTile(*cell, environment_.head(), grid_, work, context_, inspect);
  }

  // All within the bound, one behind the other; up to `steps` of progress.
  void runAllCells(std::size_t steps) {
    isLinked_ = !steps_.minimumArea;
    const std::uint64_t begin = endOfSlice(options_.slice.number - 1), count = endOfSlice(options_.slice.number);
    std::uint64_t size = std::min(
        options_.mostFaces, (options_.memory - fixed_) / (kOfFace + kOfFloor + (isExact() ? 2 * kOfUnionTriangle : 0)));
    for (std::uint64_t first = begin; first < count;) {
      const FaceRange range{first, std::min(first + size, count)};
      context_.beginStep(steps * (first - begin) / (count - begin), "cell " + std::to_string(result_.cells + 1));
      if (const std::optional<CellSize> found = runCell(range)) {
        first = range.last;
        size = nextSize(range.size(), *found);
        continue;
      }
      ++result_.refused;
      if (range.size() == 1 && neededForTile_ != 0) failTooLittle(fixed_ + neededForTile_);
      if (range.size() == 1) failTooLittle({range});
      size = range.size() / 2;
    }
  }

  [[nodiscard]] CellCollector::Fits withinMemory() const {
    return [this](const CellSize& size) { return needed(size) <= options_.memory; };
  }
  [[noreturn]] void failTooLittle(const OwnFloors& own) {
    failTooLittle(needed(collector_.measure(own, context_, reach_)));
  }

  // What it held; empty when the cell does not fit.
  std::optional<CellSize> runCell(const FaceRange& range) {
    const OwnFloors own{range};
    neededForTile_ = 0;
    std::optional<MadeCell> cell = makeCell(own, withinMemory());
    if (!cell) return std::nullopt;
    if (isExact()) neededForTile_ = 2 * kOfUnionTriangle * cell->made.tile.triangles.size();  // with as much beside it
    if (fixed_ + neededForTile_ > options_.memory) return std::nullopt;
    ++result_.cells;
    keepGaps(cell->made);
    addTile(own, cell->made.tile);
    const CellSize found = cell->size;
    cell.reset();
    returnFreedMemory();
    return found;
  }
  void addTile(const OwnFloors& own, const Tile& tile) {
    if (tile.triangles.empty()) return;
    store_.add(tile);
    cells_.push_back(own);
  }
  void keepGaps(const MadeTile& made) { atGaps_.add(made.atGaps); }

  // Filters that see over the borders of tiles, one after another; then nobody needs to know what vertices are made of.
  void runGlobalSteps() {
    TileStage stage{store_, cells_.size(), {}, grid_, options_.memory - fixed_, {}};
    stage.failTooLittle = [this](std::uint64_t bytes) { failTooLittle(fixed_ + bytes); };
    for (std::size_t i = 0; i < cells_.size(); ++i)
      if (const Tile tile = store_.read(i); !tile.triangles.empty()) stage.tiles.push_back(storedTileOf(i, tile));
    bool isSimplified = false;  // else triangles lie in their own faces, one behind the other
    for (const PipelineStep& step : steps_.global) {
      context_.beginStep(kTileRunSteps - 1, std::string(step.filter->name));
      if (step.filter->type == FilterType::Simplification) {
        isSimplified = true;
        simplifyTiles(stage, context_);
      } else {
        layTiles(stage, context_);
      }
      returnFreedMemory();
    }
    for (const StoredTile& stored : stage.tiles) {
      Tile tile = store_.read(stored.number);
      tile.geometry = {};
      if (!isSimplified) tile.pieces = {};
      store_.replace(stored.number, tile);
    }
  }

  // What gaps change, of all cells.
  void runGaps() {
    if (atGaps_.floors.empty()) return;
    atGaps_.sort();
    fixed_ += atGaps_.bytes();
    context_.beginStep(kTileRunSteps - 1, "gaps");
    const OwnFloors own{{}, &atGaps_};
    std::optional<MadeCell> cell = makeCell(own, withinMemory());
    if (!cell) failTooLittle(own);
    ++result_.cells;
    addTile(own, cell->made.tile);
    cell.reset();
    returnFreedMemory();
  }

  // Regions hang together over borders: what each tile knows of its own is put together. For each tile, which of its
  // regions stay.
  std::vector<std::vector<char>> largeRegions(double minimum) {
    context_.beginStep(kTileRunSteps - 1, "areas");
    RegionSums sums(grid_);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const Tile tile = store_.read(i);
      sums.add(tile, findTileRegions(tile, grid_, context_));
      returnFreedMemory();
    }
    const auto findAgain = [this](std::size_t number, const RegionSums::Inspect& inspect) {
      makeCell(
          cells_[number], [](const CellSize&) { return true; }, inspect);
      returnFreedMemory();
    };
    return sums.largerThan(minimum, findAgain, context_);
  }

  // Calls drop(tile, its number, its regions, which of them stay) where some go.
  template <class Drop>
  void forTilesWithSmallRegions(double minimum, const Drop& drop) {
    const std::vector<std::vector<char>> keeps = largeRegions(minimum);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (std::all_of(keeps[i].begin(), keeps[i].end(), [](char keep) { return keep != 0; })) continue;
      const Tile tile = store_.read(i);
      drop(tile, i, findTileRegions(tile, grid_, context_).regionOf, keeps[i]);
      returnFreedMemory();
    }
  }

  void dropSmallRegions(double minimum) {
    forTilesWithSmallRegions(minimum, [this](const Tile& tile, std::size_t number, const std::vector<Index>& regionOf,
                                             const std::vector<char>& keeps) {
      store_.replace(number, withoutRegions(tile, regionOf, keeps));
    });
  }

  // Steps join what an area has left, of neighbours as well: the same cells run once more.
  void linkAfterArea() {
    forTilesWithSmallRegions(*steps_.minimumArea,
                             [this](const Tile& tile, std::size_t, const std::vector<Index>& regionOf,
                                    const std::vector<char>& keeps) { dropped_.add(tile, regionOf, keeps); });
    dropped_.sort();
    fixed_ += dropped_.bytes();
    isLinked_ = true;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      context_.beginStep(kTileRunSteps / 2 * (i + cells_.size()) / cells_.size(),
                         "steps of cell " + std::to_string(i + 1));
      std::optional<MadeCell> cell = makeCell(cells_[i], withinMemory());
      if (!cell) failTooLittle(cells_[i]);
      keepGaps(cell->made);
      store_.replace(i, cell->made.tile);
      cell.reset();
      returnFreedMemory();
    }
  }

  const PackedEnvironment& environment_;
  CellSteps steps_;
  TileRunOptions options_;
  TileStore& store_;
  RunContext& context_;
  FloorRule rule_;
  CellCollector collector_;
  std::uint64_t fixed_ = 0;
  std::uint64_t neededForTile_ = 0;  ///< of the last cell, for filters that see over the borders of tiles; or 0
  Grid grid_;
  FloorsAtGaps atGaps_;
  int reach_ = kUsualReach;       ///< of the last cell
  bool isLinked_ = false;         ///< cells have their steps now
  DroppedTriangles dropped_;      ///< before the steps
  std::vector<OwnFloors> cells_;  ///< of each tile
  TileRunResult result_;
};

/// Files of a folder.
class TileFolder : public TileStore {
 public:
  TileFolder(const std::string& folder, RunContext& context) : folder_(folder), context_(context), written_(folder) {}

  void add(const Tile& tile) override {
    entries_.push_back(writeTile(folder_, entries_.size() + 1, tile, context_));
    written_.add(entries_.back().file);
  }
  Tile read(std::size_t number) override { return readTile(folder_, entries_[number], &context_); }
  void replace(std::size_t number, const Tile& tile) override {
    entries_[number] = writeTile(folder_, number + 1, tile, context_);
  }

  /// Leaves the folder with its index.
  void finish(TileSet& set) {
    std::error_code ignored;  // what the index does not name does no harm
    for (const TileEntry& entry : entries_) {
      if (entry.triangles > 0)
        set.tiles.push_back(entry);
      else
        std::filesystem::remove(std::filesystem::path(folder_) / entry.file, ignored);
    }
    written_.add(kTileIndex);
    writeFileSafely((std::filesystem::path(folder_) / kTileIndex).string(), formatTileIndex(set));
    written_.keep();
  }

 private:
  std::string folder_;
  RunContext& context_;
  WrittenFiles written_;
  std::vector<TileEntry> entries_;
};

}  // namespace

void checkSlice(const CellSteps& steps, const TileSlice& slice) {
  if (slice.count == 1) return;
  const auto fail = [](std::string_view filter) {
    throw InputError(FOOTFALL_TEXT("%1 sees over the borders of slices; leave it out, or run all slices at once"),
                     filter);
  };
  if (steps.step && steps.step->values[1] > 0)
    throw InputError(FOOTFALL_TEXT(
        "StepFilter with a gap sees over the borders of slices; give it a gap of 0, or run all slices at once"));
  if (steps.minimumArea || steps.minimumLinkedArea) fail(filterDescriptor(FilterType::Area).name);
  if (!steps.global.empty()) fail(steps.global.front().filter->name);
}

void checkMemory(const std::string& source, std::uint64_t memory) {
  if (memory <= kOfProcess + kOfFace + kOfFloor) failTooLittle(source, memory, kOfProcess + kMegabyte);
}

TileRunResult runCells(const PackedEnvironment& environment, const Pipeline& pipeline, const TileRunOptions& options,
                       TileStore& store, RunContext& context) {
  return TileRun(environment, pipeline, options, store, context).run();
}

TileRunResult runIntoTiles(const PackedEnvironment& environment, const Pipeline& pipeline, const std::string& folder,
                           const TileRunOptions& options, RunContext& context) {
  TileFolder tiles(folder, context);
  TileRunResult result = runCells(environment, pipeline, options, tiles, context);
  tiles.finish(result.set);
  return result;
}

}  // namespace footfall::detail
