// The commands of `footfall`. Each declares its options, and works when it is what the user typed: results go to stdout
// and to the files that are named.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace footfall::app {

// Callbacks of the commands throw InputError (usage or input), RunError or Cancelled. Each file is written as a whole
// or stays as it was.

class RunProgram;  // app/run_program.hpp

/// `footfall run`: loads, runs the pipeline, exports. `program` lives as long as the command.
void addRunCommand(CLI::App& app, RunProgram& program);
/// `footfall why`: why a place of an environment is walkable, or why not.
void addWhyCommand(CLI::App& app);
/// `footfall info`: what an environment holds.
void addInfoCommand(CLI::App& app);
/// `footfall pack`: a packed environment (.ffenv) of any other.
void addPackCommand(CLI::App& app);
/// `footfall join`: one file of the tiles that `footfall run --memory` wrote.
void addJoinCommand(CLI::App& app);
/// `footfall cells`: the cells of a strategy, without running the filters.
void addCellsCommand(CLI::App& app);
/// `footfall path`: the shortest path between two places. Where the target cannot be reached, the path leads to the
/// nearest place that can, and is reported and written as well, before that is an error.
void addPathCommand(CLI::App& app);
/// `footfall corridors`: how wide passages are, by the corridor map.
void addCorridorsCommand(CLI::App& app);
/// `footfall plan`: floor plans as SVG or PDF, and the walkable area as polygons (well-known text, GeoJSON).
void addPlanCommand(CLI::App& app);
/// `footfall compare`: how two navigation meshes differ.
void addCompareCommand(CLI::App& app);
/// `footfall filters`: the reference of filters.
void addFiltersCommand(CLI::App& app);

}  // namespace footfall::app
