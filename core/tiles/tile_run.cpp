// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_run.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "core/base/background_release.hpp"
#include "core/base/byte_stream.hpp"
#include "core/base/process_usage.hpp"
#include "core/environment/area_on_grid.hpp"
#include "core/tiles/cell_runner.hpp"
#include "core/tiles/gap_groups.hpp"
#include "core/tiles/tile_folder.hpp"
#include "core/tiles/tile_regions.hpp"
#include "core/tiles/tile_stage.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/version.hpp"

namespace footfall::detail {
namespace {

std::string encode(const TileRankStatistics& rank) {
  ByteWriter out;
  for (const std::uint64_t count : {rank.bytesRead, rank.peakBytes}) out.number(count);
  for (const double ms : {rank.wallMs, rank.cpuMs}) out.real(ms);
  out.bytes += encodeOutcomes({}, rank.counts);
  return std::move(out.bytes);
}

TileRankStatistics decodeRank(const std::string& bytes) {
  ByteReader in(bytes);
  TileRankStatistics rank;
  for (std::uint64_t* count : {&rank.bytesRead, &rank.peakBytes}) *count = in.number();
  for (double* ms : {&rank.wallMs, &rank.cpuMs}) *ms = in.real();
  std::vector<CellOutcome> none;
  decodeOutcomes(in.rest(), none, rank.counts);
  return rank;
}

/// The cells are run by all ranks. Everything else is done by rank 0.
class TileRun {
 public:
  TileRun(const PackedEnvironment& environment, const Pipeline& pipeline, const TileRunOptions& options,
          TileStore& store, RankGroup& ranks, RunContext& context)
      : environment_(environment),
        steps_(stepsOfCells(pipeline)),
        options_(options),
        store_(store),
        ranks_(ranks),
        context_(context),
        runner_(environment, steps_, options.roles, options.memory, context) {
    checkSlice(steps_, options.slice);
    result_.set.frame = environment.head().frame();
    result_.set.bothSides = environment.head().bothSides;
    result_.set.environment = environment.tableSum();
    result_.set.slice = options.slice;
    result_.set.roles = runner_.roles();
    result_.set.pipeline = formatPipeline(pipeline);
    result_.set.triangles = environment.faceCount();
  }

  TileRunResult run() {
    const Stopwatch watch;
    checkSame();
    const BlockSurvey survey = surveyAll();
    grid_ = survey.grid;
    runner_.setGrid(grid_);
    expectLayers(survey);
    const bool isTwice = steps_.step && steps_.minimumArea;
    if (steps_.step && !isTwice) runner_.link({});
    runPlan(planOf(survey), 0, isTwice ? kTileRunSteps / 2 : kTileRunSteps);
    if (isTwice) linkAfterArea();
    if (ranks_.isFirst()) runBehindCells(!isTwice);
    tellStatistics(watch);
    return std::move(result_);
  }

 private:
  /// Groups of floors at gaps from `first` up to, not including, `last`.
  struct GroupRange {
    std::size_t first = 0, last = 0;
    [[nodiscard]] std::size_t size() const { return last - first; }
  };

  // Faces of the slices up to that one.
  [[nodiscard]] std::uint64_t endOfSlice(std::uint64_t number) const {
    const std::uint64_t faces = environment_.faceCount(), slices = options_.slice.count;
    return faces / slices * number + faces % slices * number / slices;
  }

  void checkSame() {
    const std::string own = formatTileIndex(result_.set) + std::to_string(options_.memory) + ' ' +
                            std::to_string(options_.mostFaces) + ' ' + FOOTFALL_VERSION;
    const bool goesOn = ranks_.isFirst() && store_.begin(own);
    const std::string told = ranks_.fromFirst((goesOn ? 'y' : 'n') + own, context_);
    if (told.substr(1) != own) throw RunError(differsFromFirst());
    if (told[0] == 'y') store_.goOn();
  }

  // Each rank reads a part of the blocks, all of them what was found.
  BlockSurvey surveyAll() {
    const std::size_t count = environment_.blocks().size(), ranks = static_cast<std::size_t>(ranks_.size());
    const auto endOf = [&](std::size_t part) { return count / ranks * part + count % ranks * part / ranks; };
    const auto rank = static_cast<std::size_t>(ranks_.rank());
    const BlockSurvey own = surveyOf(environment_, runner_.collector(), endOf(rank), endOf(rank + 1), context_);
    BlockSurvey all;
    for (const std::string& part : ranks_.gather(encodeSurvey(own), context_)) all.add(decodeSurvey(part));
    return decodeSurvey(ranks_.fromFirst(encodeSurvey(all), context_));
  }

  // A message about too little memory for cells names enough for the layers of their floors, too. A note says before
  // the first cell that they will not fit.
  void expectLayers(const BlockSurvey& survey) {
    const bool hasLayers = std::any_of(steps_.global.begin(), steps_.global.end(), [](const PipelineStep& step) {
      return step.filter->type == FilterType::LayerSubdivision;
    });
    if (!hasLayers) return;
    const std::uint64_t floors = std::accumulate(survey.floors.begin(), survey.floors.end(), std::uint64_t{0});
    const std::uint64_t expected = floors * (kOfLayerTriangle + kUsualPairs * kOfLayerPair);
    runner_.expect(expected);
    if (floors * (kOfLayerTriangle + kFewPairs * kOfLayerPair) <= runner_.free()) return;
    if (ranks_.isFirst() && options_.note)
      options_.note(Text(FOOTFALL_TEXT("a memory of %1 is probably too little for layers, which come last; %2 are "
                                       "probably enough"),
                         inMegabytes(options_.memory), inMegabytes(runner_.leastFor(expected))));
  }

  // Cells see a different amount beside their own faces in each environment and pipeline, so some are measured when
  // there are many.
  std::vector<FaceRange> planOf(const BlockSurvey& survey) {
    constexpr double kInCity = 1.2, kInCityWithSteps = 1.7;
    constexpr std::size_t kMostSamples = 4, kCellsOfSample = 8;
    const FaceRange faces{endOfSlice(options_.slice.number - 1), endOfSlice(options_.slice.number)};
    const auto planFor = [&](double seen) {
      return planCells(environment_.blocks(), survey.floors, faces, runner_.limits(options_.mostFaces, seen));
    };
    const std::vector<FaceRange> usual = planFor(steps_.step ? kInCityWithSteps : kInCity);
    const std::size_t samples = std::min(usual.size() / kCellsOfSample, kMostSamples);
    if (samples == 0) return usual;
    double seen = 1;
    for (std::size_t i = 0; i < samples; ++i) {
      const std::size_t number = usual.size() * (2 * i + 1) / (2 * samples);
      // The rank that is to begin there usually measures it.
      if (number * static_cast<std::size_t>(ranks_.size()) / usual.size() != static_cast<std::size_t>(ranks_.rank()))
        continue;
      const FaceRange& cell = usual[number];
      const std::uint64_t own =
          runningBytes(environment_.blocks(), survey.floors, cell, runner_.limits(options_.mostFaces, 1));
      seen = std::max(seen, static_cast<double>(runner_.measure({cell})) / static_cast<double>(own));
    }
    const auto bytesOf = [](double number) {
      ByteWriter out;
      out.real(number);
      return std::move(out.bytes);
    };
    for (const std::string& part : ranks_.gather(bytesOf(seen), context_))
      seen = std::max(seen, ByteReader(part).real());
    const std::string all = ranks_.fromFirst(bytesOf(seen), context_);
    return planFor(ByteReader(all).real());
  }

  // Cells are tasks for whoever is free; their tiles are numbered in the order of the plan. Steps of progress are those
  // from `begin` up to `end`, as if all ranks were as fast as this one.
  void runPlan(const std::vector<FaceRange>& plan, std::size_t begin, std::size_t end) {
    std::vector<CellOutcome> own;
    ranks_.beginTasks(plan.size());
    while (const std::optional<std::size_t> cell = ranks_.nextTask(context_)) {
      const std::size_t done = std::min(own.size() * static_cast<std::size_t>(ranks_.size()), plan.size() - 1);
      context_.beginStep(begin + (end - begin) * done / plan.size(), "cell " + std::to_string(*cell + 1));
      own.push_back(runCell(*cell, plan[*cell], begin));
    }
    const std::vector<std::string> all = ranks_.gather(encodeOutcomes(own, {}), context_);
    own.clear();
    CellCounts none;
    for (const std::string& part : all) decodeOutcomes(part, own, none);
    std::sort(own.begin(), own.end(), [](const CellOutcome& a, const CellOutcome& b) { return a.cell < b.cell; });
    for (const CellOutcome& outcome : own) takeCell(outcome);
  }

  CellOutcome runCell(std::size_t cell, const FaceRange& range, std::size_t round) {
    const std::string name = "cell-" + std::to_string(round) + '-' + std::to_string(cell);
    if (std::optional<CellOutcome> kept = keptCell(name, cell)) return std::move(*kept);
    CellOutcome outcome{cell, {}, {}};
    runner_.run(range, [&](const FaceRange& piece, MadeTile& made) {
      outcome.atGaps.add(made.atGaps);
      const std::string tile = name + '-' + std::to_string(outcome.pieces.size());
      outcome.pieces.push_back({piece, made.tile.triangles.empty() ? std::string() : store_.write(tile, made.tile)});
    });
    store_.keepCell(name, encodeOutcomes({outcome}, {}));
    return outcome;
  }

  // The outcome of a cell that a killed run left.
  std::optional<CellOutcome> keptCell(const std::string& name, std::size_t cell) try {
    const std::string bytes = store_.keptCell(name);
    if (bytes.empty()) return std::nullopt;
    std::vector<CellOutcome> outcomes;
    CellCounts none;
    decodeOutcomes(bytes, outcomes, none);
    if (outcomes.size() != 1 || outcomes[0].cell != cell) return std::nullopt;
    for (const CellOutcome::Piece& piece : outcomes[0].pieces)
      if (!piece.written.empty() && !store_.has(piece.written)) return std::nullopt;
    ++takenOver_;
    return std::move(outcomes[0]);
  } catch (const BadBytes&) {  // Another build wrote it: the cell runs again.
    return std::nullopt;
  }

  // Cells that ran before have a tile each, which the first piece replaces.
  void takeCell(const CellOutcome& outcome) {
    atGaps_.add(outcome.atGaps);
    bool isKnown = isAgain_;
    for (const CellOutcome::Piece& piece : outcome.pieces) {
      const std::size_t number = std::exchange(isKnown, false) ? outcome.cell : cells_.size();
      if (piece.written.empty()) {
        if (number < cells_.size()) store_.replace(number, {});
        continue;
      }
      store_.take(number, piece.written);
      if (number == cells_.size()) cells_.emplace_back();
      cells_[number] = piece.range;
    }
  }

  // Steps join what an area has left, of neighbours as well: the cells with triangles run once more.
  void linkAfterArea() {
    DroppedTriangles dropped;
    ByteWriter out;
    if (ranks_.isFirst()) {
      forTilesWithSmallRegions(areaOnGrid(environment_.head().grid, *steps_.minimumArea),
                               [&dropped](const Tile& tile, std::size_t, const std::vector<Index>& regionOf,
                                          const std::vector<char>& keeps) { dropped.add(tile, regionOf, keeps); });
      dropped.sort();
      dropped.write(out);
      out.number(cells_.size());
      for (const FaceRange& cell : cells_) {
        out.number(cell.first);
        out.number(cell.last);
      }
    }
    const std::string told = ranks_.fromFirst(std::move(out.bytes), context_);
    ByteReader in(told);
    dropped.read(in);
    std::vector<FaceRange> plan(in.count(2));
    for (FaceRange& cell : plan) {
      cell.first = in.number();
      cell.last = in.number();
    }
    runner_.link(std::move(dropped));
    isAgain_ = true;
    runPlan(plan, kTileRunSteps / 2, kTileRunSteps);
  }

  void runBehindCells(bool hasAreas) {
    runGaps();
    if (steps_.minimumArea && hasAreas) dropSmallRegions(areaOnGrid(environment_.head().grid, *steps_.minimumArea));
    if (steps_.minimumLinkedArea) dropSmallRegions(areaOnGrid(environment_.head().grid, *steps_.minimumLinkedArea));
    if (!steps_.global.empty()) runGlobalSteps();
  }

  // Runs filters that need several tiles, one after another; afterwards the provenance of vertices is not needed any
  // more.
  void runGlobalSteps() {
    TileStage stage{store_, tileCount(), {}, grid_, runner_.free(), {}};
    stage.failTooLittle = [this](std::uint64_t bytes) { runner_.failTooLittle(bytes); };
    for (std::size_t i = 0; i < stage.count; ++i)
      if (const Tile tile = store_.read(i); !tile.triangles.empty()) stage.tiles.push_back(storedTileOf(i, tile));
    bool isSimplified = false;  // else triangles lie in their own faces, one behind the other
    for (const PipelineStep& step : steps_.global) {
      context_.beginStep(kTileRunSteps - 1, std::string(step.filter->name));
      if (step.filter->type == FilterType::Simplification) {
        isSimplified = true;
        simplifyTiles(stage, context_);
      } else {
        runner_.expectNothing();
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

  // Runs the floors that gaps change, of all cells: groups of them together, as many as fit.
  void runGaps() {
    if (atGaps_.floors.empty()) return;
    context_.beginStep(kTileRunSteps - 1, "gaps");
    if (const std::uint64_t bytes = GapGroups::bytesToMake(atGaps_); bytes > runner_.free())
      runner_.failTooLittle(bytes);
    groups_ = GapGroups(std::exchange(atGaps_, {}), steps_.step->values[1], Poll(context_));
    runner_.charge(groups_.bytes());
    std::vector<GroupRange> left{{0, groups_.count()}};
    while (!left.empty()) {
      const GroupRange range = left.back();
      left.pop_back();
      if (runGroups(range)) continue;
      if (range.size() == 1) runner_.failTooLittle(OwnFloors{{}, &listed_});
      const std::size_t middle = groups_.middleOf(range.first, range.last);
      left.push_back({middle, range.last});
      left.push_back({range.first, middle});
    }
  }

  // False where they do not fit.
  bool runGroups(const GroupRange& range) {
    listed_ = groups_.list(range.first, range.last);
    if (range.size() > 1 && listed_.floors.size() > options_.mostFaces) return false;
    const std::optional<MadeTile> made = runner_.runListed(listed_);
    if (!made) return false;
    if (!made->tile.triangles.empty()) {
      store_.add(made->tile);
      ofGroups_.push_back(range);
    }
    returnFreedMemory();
    return true;
  }

  // Unites regions over the borders of tiles. Returns one flag per region of each tile: it stays.
  std::vector<std::vector<char>> largeRegions(double minimum) {
    context_.beginStep(kTileRunSteps - 1, "areas");
    RegionSums sums(grid_);
    for (std::size_t i = 0; i < tileCount(); ++i) {
      const Tile tile = store_.read(i);
      sums.add(tile, findTileRegions(tile, grid_, context_));
      returnFreedMemory();
    }
    const auto findAgain = [this](std::size_t number, const RegionSums::Inspect& inspect) {
      runner_.runAgain(ownOf(number), inspect);
    };
    return sums.largerThan(minimum, findAgain, context_);
  }

  // Calls drop(tile, its number, its regions, which of them stay) where some go.
  template <class Drop>
  void forTilesWithSmallRegions(double minimum, const Drop& drop) {
    const std::vector<std::vector<char>> keeps = largeRegions(minimum);
    for (std::size_t i = 0; i < tileCount(); ++i) {
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

  // Those of the cells, and those of what gaps change.
  [[nodiscard]] std::size_t tileCount() const { return cells_.size() + ofGroups_.size(); }
  OwnFloors ownOf(std::size_t tile) {
    if (tile < cells_.size()) return {cells_[tile]};
    const GroupRange& range = ofGroups_[tile - cells_.size()];
    listed_ = groups_.list(range.first, range.last);
    return {{}, &listed_};
  }

  void tellStatistics(const Stopwatch& watch) {
    result_.wallMs = watch.wallMs();
    result_.cpuMs = watch.cpuMs();
    CellCounts counts = runner_.counts();
    counts.takenOver = takenOver_;
    const TileRankStatistics own{counts, environment_.bytesRead(), peakRssBytes(), result_.wallMs, result_.cpuMs};
    for (const std::string& rank : ranks_.gather(encode(own), context_)) {
      result_.ranks.push_back(decodeRank(rank));
      result_.counts.add(result_.ranks.back().counts);
    }
  }

  const PackedEnvironment& environment_;
  CellSteps steps_;
  TileRunOptions options_;
  TileStore& store_;
  RankGroup& ranks_;
  RunContext& context_;
  CellRunner runner_;
  Grid grid_;
  FloorsAtGaps atGaps_;
  bool isAgain_ = false;          ///< cells have a tile each already
  std::vector<FaceRange> cells_;  ///< one range per tile of a cell
  GapGroups groups_;
  std::vector<GroupRange> ofGroups_;  ///< one range per tile of what gaps change; these follow those of the cells
  ListedFloors listed_;               ///< floors of the groups at work
  std::uint64_t takenOver_ = 0;       ///< cells of an earlier run
  TileRunResult result_;
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

TileRunResult runCells(const PackedEnvironment& environment, const Pipeline& pipeline, const TileRunOptions& options,
                       TileStore& store, RankGroup& ranks, RunContext& context) {
  return TileRun(environment, pipeline, options, store, ranks, context).run();
}

TileRunResult runIntoTiles(const PackedEnvironment& environment, const Pipeline& pipeline, const std::string& folder,
                           const TileRunOptions& options, RankGroup& ranks, RunContext& context) {
  TileFolder tiles(folder, context);
  if (ranks.size() > 1) tiles.leaveUnfinished();
  TileRunResult result = runCells(environment, pipeline, options, tiles, ranks, context);
  if (ranks.isFirst()) tiles.finish(result.set);
  ranks.fromFirst({}, context);  // others are at work as long as rank 0 is
  return result;
}

}  // namespace footfall::detail
