// Cells of one run, each within the bound of memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/io/packed/packed_environment.hpp"
#include "core/tiles/cell_outcome.hpp"
#include "core/tiles/cell_plan.hpp"
#include "core/tiles/cell_tile.hpp"
#include "core/tiles/tile_regions.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Bytes as messages say them.
[[nodiscard]] std::string inMegabytes(std::uint64_t bytes);

/// Throws InputError where so much memory is too little for any environment; `source` is its file.
void checkMemory(const std::string& source, std::uint64_t memory);

/// Runs cells one by one. What becomes of a cell depends on nothing that ran before it.
class CellRunner {
 public:
  /// `roles` as TileRunOptions::roles. Throws InputError where the memory is too little for the environment's table.
  CellRunner(const PackedEnvironment& environment, const CellSteps& steps, const std::vector<PartRole>& roles,
             std::uint64_t memory, RunContext& context);

  [[nodiscard]] const CellCollector& collector() const { return collector_; }
  /// The roles of the run; empty where all parts are floors.
  [[nodiscard]] const std::vector<PartRole>& roles() const { return roles_; }
  /// The limits of a cell that, with all that it sees, takes `seen` times what its own faces take.
  [[nodiscard]] CellLimits limits(std::uint64_t mostFaces, double seen) const;
  /// The memory that a cell takes while it runs, with all that it sees; it is not held.
  [[nodiscard]] std::uint64_t measure(const OwnFloors& own) const;

  /// Call this before the first cell runs.
  void setGrid(const Grid& grid) { grid_ = grid; }
  /// Lets cells run their steps from now on, without the triangles in `dropped`.
  void link(DroppedTriangles dropped);
  /// Adds to the bytes that are in memory beside each cell.
  void charge(std::uint64_t bytes) { fixed_ += bytes; }
  /// Bytes for triangles at one time.
  [[nodiscard]] std::uint64_t free() const { return memory_ - fixed_; }

  using Visit = std::function<void(const FaceRange& range, MadeTile& made)>;
  /// Visits what is left of a cell: in pieces, in their order, where it does not fit.
  void run(const FaceRange& range, const Visit& visit);
  /// Runs a cell of what gaps change. Empty where it does not fit.
  std::optional<MadeTile> runListed(const ListedFloors& floors);
  /// Runs a cell that ran before, to inspect it exactly.
  void runAgain(const OwnFloors& own, const RegionSums::Inspect& inspect);

  [[nodiscard]] const CellCounts& counts() const { return counts_; }
  /// Messages about too little memory name enough for so many bytes besides those that are charged, an estimate of what
  /// later work needs. No run is refused because of it.
  void expect(std::uint64_t bytes) { expected_ = std::max(expected_, bytes); }
  /// Messages name no more than what is known to be needed from this call on.
  void expectNothing() { expected_ = 0; }
  /// The least memory in which so many bytes besides those that are charged have room.
  [[nodiscard]] std::uint64_t leastFor(std::uint64_t bytes) const;
  /// Throws InputError: so many bytes besides those that are charged are needed. It names the least memory in which
  /// they and those that are expected have room.
  [[noreturn]] void failTooLittle(std::uint64_t bytes) const;
  /// The same for the last cell, which did not fit.
  [[noreturn]] void failTooLittle(const OwnFloors& own) const;

 private:
  /// True when tiles keep the geometry that filters over their borders need.
  [[nodiscard]] bool isExact() const { return !steps_.global.empty(); }
  [[nodiscard]] std::uint64_t needed(const CellSize& size) const;
  std::optional<MadeTile> make(const OwnFloors& own, const CellCollector::Fits& fits,
                               const RegionSums::Inspect& inspect = {});
  std::optional<MadeTile> tryMake(const OwnFloors& own, const CellCollector::Fits& fits,
                                  const RegionSums::Inspect& inspect, bool& fit);
  std::optional<MadeTile> makeWithin(const OwnFloors& own);
  [[nodiscard]] CellCollector::Fits withinMemory() const;

  const PackedEnvironment& environment_;
  const CellSteps& steps_;
  std::uint64_t memory_;
  RunContext& context_;
  std::vector<PartRole> roles_;
  CellCollector collector_;
  std::uint64_t fixed_ = 0;
  std::uint64_t expected_ = 0;
  std::uint64_t ofListed_ = 0;       ///< bytes of the list of floors at work, or that did not fit
  std::uint64_t neededForTile_ = 0;  ///< for the last cell, if filters see over the borders of tiles; or 0
  Grid grid_;
  int reach_ = kUsualReach;  ///< reach of the last cell
  bool isLinked_ = false;    ///< cells have their steps now
  DroppedTriangles dropped_;
  CellCounts counts_;
};

}  // namespace footfall::detail
