// From what a cell needs of an environment to the tile of its floors.
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
  std::optional<double> minimumArea{};        ///< behind them: regions of at most that are left out, over all cells
  std::optional<PipelineStep> step{};         ///< behind that a StepFilter
  std::optional<double> minimumLinkedArea{};  ///< behind that the same as minimumArea, over links
  std::vector<PipelineStep> global{};         ///< behind that filters that see over the borders of tiles
};

/// What a pipeline is for cells: local filters that move nothing, then an AreaFilter or several, then a StepFilter, and
/// AreaFilters again. Strategies and Collapse, which change no result, are left out. The pipeline is one that
/// parsePipeline() has checked. Throws InputError "PLACE: what; what to do" where a step is another filter.
CellSteps stepsOfCells(const Pipeline& pipeline);

/// What collecting has to know of the steps.
FloorRule floorRuleOf(const CellSteps& steps);

/// The exact place of a tile's vertex, in the environment's units.
using ExactPlaceOf = std::function<std::array<mpq_class, 3>(Index vertex)>;

/// What a cell runs.
struct CellWork {
  const std::vector<PipelineStep>& local;
  const PipelineStep* step = nullptr;         ///< a StepFilter behind them; may be null
  const DroppedTriangles* dropped = nullptr;  ///< between both; may be null
  bool keepsGeometry = false;                 ///< with all that filters over the borders of tiles need to know
};

struct MadeTile {
  Tile tile;
  /// The tile has nothing of these own floors. When all cells ran, they are a cell of their own (OwnFloors::listed),
  /// which leaves none out.
  FloorsAtGaps atGaps{};
};

/// What the work leaves of the cell's own floors, exactly as in the whole environment. `head` is that of the
/// environment and `grid` that of all its vertices. `inspect` (may be empty) is called with the tile while the places
/// of its vertices are known exactly. Empty where steps lead on from all that the cell sees: it must be collected with
/// a larger reach.
std::optional<MadeTile> makeTile(const CellFaces& cell, const Environment& head, const Grid& grid, const CellWork& work,
                                 RunContext& context,
                                 const std::function<void(const Tile&, const ExactPlaceOf&)>& inspect = {});

}  // namespace footfall::detail
