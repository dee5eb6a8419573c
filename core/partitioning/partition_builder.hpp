// The code that all strategies share: the tree of cuts that they grow, and the partition made of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/exact/source_mesh.hpp"
#include "core/partitioning/partition.hpp"
#include "core/partitioning/strategies.hpp"

namespace footfall::detail {

struct FloorWork;  // core/partitioning/floor_work.hpp

/// Cuts as a strategy makes them, on several threads.
struct CutTree {
  int axis = 0;
  double coordinate = 0;
  std::unique_ptr<CutTree> below, above;  ///< none in a cell
};

/// A rectangle in the plan; empty while lower > upper.
struct PlanBox {
  std::array<double, 2> lower{CellBounds::kInfinity, CellBounds::kInfinity};
  std::array<double, 2> upper{-CellBounds::kInfinity, -CellBounds::kInfinity};

  [[nodiscard]] bool empty() const { return !(lower[0] <= upper[0]); }
  /// A cut there leaves width on both sides.
  [[nodiscard]] bool isInside(int axis, double coordinate) const {
    return lower[axis] < coordinate && coordinate < upper[axis];
  }
};

/// The box of a triangle in the plan.
PlanBox planBoxOf(const SourceMesh& mesh, Index triangle);
/// The box in the plan around all triangles that are not removed.
PlanBox planBoxOf(const StrategyInput& input);

/// Refuses parameters that make more cells than anyone can use.
class CellLimit {
 public:
  static constexpr std::int64_t kMostCells = 65536;

  /// `strategy` with its parameters, and `advice` on what to change, for the message.
  CellLimit(std::string strategy, Text advice) : strategy_(std::move(strategy)), advice_(std::move(advice)) {}
  /// More cells than the one at the beginning: throws InputError when there are too many now. Called by any thread.
  void add(std::int64_t cells);

 private:
  std::string strategy_;
  Text advice_;
  std::atomic<std::int64_t> cells_{1};
};

/// Numbers nodes, cells and borders of a tree, in the tree's order: below before above.
Partition partitionOf(const CutTree& tree);

// One function for each strategy. `name` is the strategy with its parameters, for messages.
std::unique_ptr<CutTree> growGrid(double columns, double rows, const std::string& name, const StrategyInput& input);
/// Parameters of the strategies that cut again and again.
struct RecursionLimits {
  double triangles = 0;  ///< parts with no more are not cut
  double depth = 0;      ///< cuts on the way to a cell

  /// Advice for strategies that make too many cells.
  static constexpr Pattern kAdvice = FOOTFALL_TEXT("give a larger min or a smaller depth");
};
std::unique_ptr<CutTree> growRecursive(const RecursionLimits& limits, const std::string& name,
                                       const StrategyInput& input);
std::unique_ptr<CutTree> growSortedRecursive(const RecursionLimits& limits, const std::string& name,
                                             const StrategyInput& input);
/// Parts with less estimated work than that of so many trivial triangles are not cut.
std::unique_ptr<CutTree> growHeightAware(const RecursionLimits& limits, const FloorWork& work, const std::string& name,
                                         const StrategyInput& input);

/// The choice of AutoStrategy.
struct AutoChoice {
  bool isOneCell = true;
  RecursionLimits limits;  ///< limits for HeightAwareStrategy, if that is chosen
  Text reason;
};
/// `work` is called only when its value matters.
AutoChoice chooseStrategy(const StrategyInput& input, const std::function<double(const RecursionLimits&)>& work);

}  // namespace footfall::detail
