// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/cell_runner.hpp"

#include <algorithm>
#include <utility>

#include "core/base/background_release.hpp"
#include "core/environment/coordinate_grid.hpp"
#include "core/tiles/tile_stage.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

// The memory that a process holds without any triangle, and per block, triangle and floor of a cell. A city takes half
// of it; other levels cut their floors into more pieces.
constexpr std::uint64_t kOfProcess = std::uint64_t{64} << 20;
constexpr std::uint64_t kOfBlock = 256, kOfFace = 500, kOfFloor = 1000;
constexpr std::uint64_t kMegabyte = std::uint64_t{1} << 20;
// Includes as much beside the triangle.
constexpr std::uint64_t kOfTileTriangle = 2 * kOfUnionTriangle;
// The number of pieces into which a city cuts a floor.
constexpr double kTrianglesPerFloor = 1.7;

/// Bytes of blocks that are kept from one cell for the next one, which is a neighbour.
std::uint64_t keptBetween(std::uint64_t memory) {
  return std::max(kKeptBlocks, std::min(memory / 16, std::uint64_t{32} << 20));
}

[[noreturn]] void failWith(const std::string& source, std::uint64_t memory, std::uint64_t least) {
  throw InputError(
      FOOTFALL_TEXT("%1: a memory of %2 is too little; give %3 or more, or run without the bound, with all of "
                    "the environment in memory"),
      source, inMegabytes(memory), inMegabytes(least));
}

/// None where all parts are floors.
std::vector<PartRole> rolesThatMatter(const std::vector<PartRole>& roles) {
  const auto isFloor = [](PartRole role) { return role == PartRole::Floor; };
  return std::all_of(roles.begin(), roles.end(), isFloor) ? std::vector<PartRole>() : roles;
}

FloorRule ruleOf(const CellSteps& steps, const std::vector<PartRole>& roles, const CoordinateGrid& grid) {
  FloorRule rule = floorRuleOf(steps);
  if (rule.step > 0) rule.step = climbOnGrid(grid, rule.step);
  rule.height = std::max(rule.height, rule.step);
  rule.roles = roles;
  return rule;
}

}  // namespace

std::string inMegabytes(std::uint64_t bytes) { return std::to_string((bytes + kMegabyte - 1) / kMegabyte) + " MB"; }

void checkMemory(const std::string& source, std::uint64_t memory) {
  if (memory <= kOfProcess + kOfFace + kOfFloor) failWith(source, memory, kOfProcess + kMegabyte);
}

CellRunner::CellRunner(const PackedEnvironment& environment, const CellSteps& steps, const std::vector<PartRole>& roles,
                       std::uint64_t memory, RunContext& context)
    : environment_(environment),
      steps_(steps),
      memory_(memory),
      context_(context),
      roles_(rolesThatMatter(roles)),
      collector_(environment, ruleOf(steps, roles_, environment.head().grid)),
      fixed_(kOfProcess + kOfBlock * environment.blocks().size() + keptBetween(memory) - kKeptBlocks) {
  if (memory <= fixed_ + kOfFace + kOfFloor) failTooLittle(kMegabyte);
}

// Leaves some room, since places differ.
CellLimits CellRunner::limits(std::uint64_t mostFaces, double seen) const {
  const auto times = [](std::uint64_t bytes, double factor) {
    return static_cast<std::uint64_t>(static_cast<double>(bytes) * factor);
  };
  return {times(free(), 0.9), times(kOfFace, seen), times(kOfFloor, seen),
          isExact() ? times(kOfTileTriangle, kTrianglesPerFloor) : 0, std::max<std::uint64_t>(mostFaces, 1)};
}

std::uint64_t CellRunner::measure(const OwnFloors& own) const {
  environment_.keepBlocks(std::max(free() / 2, keptBetween(memory_)));
  const std::uint64_t bytes = needed(collector_.measure(own, context_)) - fixed_;
  environment_.keepBlocks(keptBetween(memory_));
  return bytes;
}

void CellRunner::link(DroppedTriangles dropped) {
  dropped_ = std::move(dropped);
  charge(dropped_.bytes());
  if (memory_ <= fixed_ + kOfFace + kOfFloor) failTooLittle(kMegabyte);
  isLinked_ = true;
  counts_.cells = 0;  // cells that run once more are the same
}

std::uint64_t CellRunner::needed(const CellSize& size) const {
  return fixed_ + ofListed_ + kOfFace * size.faces + kOfFloor * size.floors;
}

// More memory keeps more blocks between cells, at most a sixteenth of it, so the sum is approached from below.
std::uint64_t CellRunner::leastFor(std::uint64_t bytes) const {
  const std::uint64_t rest = fixed_ - keptBetween(memory_) + bytes;
  std::uint64_t least = rest;
  while (least < rest + keptBetween(least)) least = rest + keptBetween(least);
  return least;
}

void CellRunner::failTooLittle(std::uint64_t bytes) const {
  failWith(environment_.head().source, memory_, leastFor(std::max(bytes, expected_)));
}

void CellRunner::failTooLittle(const OwnFloors& own) const {
  if (neededForTile_ != 0) failTooLittle(neededForTile_);
  failTooLittle(needed(collector_.measure(own, context_, reach_)) - fixed_);
}

CellCollector::Fits CellRunner::withinMemory() const {
  return [this](const CellSize& size) { return needed(size) <= memory_; };
}

// Empty when the cell does not fit.
std::optional<MadeTile> CellRunner::make(const OwnFloors& own, const CellCollector::Fits& fits,
                                         const RegionSums::Inspect& inspect) {
  for (reach_ = kUsualReach;; reach_ *= 2) {
    context_.checkCancelled();
    bool fit = false;
    std::optional<MadeTile> made = tryMake(own, fits, inspect, fit);
    if (!fit || made) return made;
  }
}

// Empty when the cell does not fit, or does not reach far enough.
std::optional<MadeTile> CellRunner::tryMake(const OwnFloors& own, const CellCollector::Fits& fits,
                                            const RegionSums::Inspect& inspect, bool& fit) {
  // A cell holds less than half of its final size while it is collected.
  environment_.keepBlocks(std::max(free() / 2, keptBetween(memory_)));
  const std::optional<CellFaces> cell = collector_.collect(own, fits, context_, nullptr, reach_);
  environment_.keepBlocks(keptBetween(memory_));
  fit = cell.has_value();
  if (!cell) return std::nullopt;
  const std::uint64_t faces = cell->faces.faceNumbers.size();
  counts_.largestCell = std::max(counts_.largestCell, faces);
  counts_.collected += faces;
  const CellWork work{steps_.local, isLinked_ && steps_.step ? &*steps_.step : nullptr, &dropped_, isExact()};
  return makeTile(*cell, environment_.head(), grid_, work, context_, inspect);
}

// Empty when the cell, or its tile, does not fit.
std::optional<MadeTile> CellRunner::makeWithin(const OwnFloors& own) {
  neededForTile_ = 0;
  std::optional<MadeTile> made = make(own, withinMemory());
  if (!made) return std::nullopt;
  if (isExact()) neededForTile_ = kOfTileTriangle * made->tile.triangles.size();
  if (fixed_ + neededForTile_ > memory_) return std::nullopt;
  return made;
}

void CellRunner::run(const FaceRange& range, const Visit& visit) {
  std::vector<FaceRange> left{range};
  while (!left.empty()) {
    const FaceRange piece = left.back();
    left.pop_back();
    if (std::optional<MadeTile> made = makeWithin({piece})) {
      ++counts_.cells;
      visit(piece, *made);
      made.reset();
      returnFreedMemory();
      continue;
    }
    ++counts_.refused;
    if (piece.size() == 1) failTooLittle(OwnFloors{piece});
    const std::uint64_t middle = piece.first + piece.size() / 2;
    left.push_back({middle, piece.last});
    left.push_back({piece.first, middle});
  }
}

std::optional<MadeTile> CellRunner::runListed(const ListedFloors& floors) {
  ofListed_ = floors.bytes();
  std::optional<MadeTile> made = makeWithin({{}, &floors});
  if (made) ofListed_ = 0;
  ++(made ? counts_.cells : counts_.refused);
  return made;
}

void CellRunner::runAgain(const OwnFloors& own, const RegionSums::Inspect& inspect) {
  make(
      own, [](const CellSize&) { return true; }, inspect);
  returnFreedMemory();
}

}  // namespace footfall::detail
