// Makes the tile of a cell's floors from the part of the environment that the cell needs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "core/exact/grid.hpp"
#include "core/tiles/cell_faces.hpp"
#include "core/tiles/dropped_triangles.hpp"
#include "core/tiles/tile.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// A pipeline that keeps to a bound of memory.
struct CellSteps {
  std::vector<PipelineStep> local;            ///< filters that a cell runs by itself
  std::optional<double> minimumArea{};        ///< then: regions of at most this area are removed, over all cells
  std::optional<PipelineStep> step{};         ///< then: a StepFilter
  std::optional<double> minimumLinkedArea{};  ///< then: the same as minimumArea, over links
  std::vector<PipelineStep> global{};         ///< then: filters that see over the borders of tiles
};

/// A pipeline in the form in which cells run it: local filters that move nothing, then an AreaFilter or several, then a
/// StepFilter, and AreaFilters again. Strategies and Collapse, which change no result, are left out. The pipeline is
/// one that parsePipeline() has checked. Throws InputError "PLACE: what; what to do" where a
/// step is another filter (FilterTraits::tileUse), or stands at a place where cells cannot run it.
CellSteps stepsOfCells(const Pipeline& pipeline);

/// The rule for collecting that follows from the steps.
FloorRule floorRuleOf(const CellSteps& steps);

/// The exact place of a tile's vertex, in the environment's units.
using ExactPlaceOf = std::function<std::array<mpq_class, 3>(Index vertex)>;

/// The work of a cell.
struct CellWork {
  const std::vector<PipelineStep>& local;
  const PipelineStep* step = nullptr;         ///< a StepFilter behind them; may be null
  const DroppedTriangles* dropped = nullptr;  ///< dropped between both; may be null
  bool keepsGeometry = false;                 ///< true: keep the geometry that filters over the borders of tiles need
};

struct MadeTile {
  Tile tile;
  /// The tile has nothing of these own floors. When all cells ran, they are a cell of their own (OwnFloors::listed),
  /// which leaves none out.
  FloorsAtGaps atGaps{};
};

/// The remainder of the cell's own floors after the work, exactly as in the whole environment. `head` is that of the
/// environment and `grid` that of all its vertices. `inspect` (may be empty) is called with the tile while the places
/// of its vertices are known exactly. Empty when steps lead beyond everything that the cell sees: the cell must be
/// collected again with a larger reach.
std::optional<MadeTile> makeTile(const CellFaces& cell, const Environment& head, const Grid& grid, const CellWork& work,
                                 RunContext& context,
                                 const std::function<void(const Tile&, const ExactPlaceOf&)>& inspect = {});

}  // namespace footfall::detail
