// From what a cell needs of an environment to the tile of its floors, by local filters.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/exact/grid.hpp"
#include "core/tiles/cell_faces.hpp"
#include "core/tiles/tile.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The steps of a pipeline that cells can run by themselves: local filters that move nothing. Strategies and Collapse,
/// which change no result, are left out. The pipeline is one that parsePipeline() has checked. Throws InputError
/// "PLACE: what; what to do" where a step is another filter.
std::vector<PipelineStep> stepsOfCells(const Pipeline& pipeline);

/// What collecting has to know of the steps.
FloorRule floorRuleOf(const std::vector<PipelineStep>& steps);

/// What the steps leave of the cell's own floors, exactly as in the whole environment. `head` is that of the
/// environment and `grid` that of all its vertices.
Tile makeTile(const CellFaces& cell, const Environment& head, const Grid& grid, const std::vector<PipelineStep>& steps,
              RunContext& context);

}  // namespace footfall::detail
