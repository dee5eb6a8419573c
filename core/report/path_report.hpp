// What a path has to tell: as text, as JSON and as OBJ.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/io/export.hpp"
#include "core/navigation/path_finder.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// A point in the frame of the environment's file, "1 2.5 -3": the way the user wrote it.
std::string formatPlace(const Vec3& p, UpAxis up);

/// describeFailure(), and what keeps start and target apart: "...; the parts are nearest at 4 1 -3: a step of 0.43 up".
std::string formatFailure(const PathResult& path, UpAxis up);

/// A few lines for a terminal or a log; places in the frame of the environment's file, lengths in its units.
std::string formatPath(const Environment& environment, const PathResult& path);

/// One JSON object: `status` ("found", "nothing_walkable", "start_not_walkable", "target_not_walkable",
/// "not_connected"), `message` (formatFailure(); empty when found), `from`, `to` (as asked for), `start`, `end` (null
/// or `position`, `distance` from what was asked for, `layer` or null), `length`, `plan_length`, `layers`,
/// `connections`, `bends` and `points` (lists of points), `max_slope_degrees`, `max_incline_degrees`, and `separation`,
/// null unless start and target are on separate parts: `largest` (the place in the list of what to overcome first, from
/// 0) and `links`, from start to target, each with `kind` (linkWord()), `from`, `to`, `gap`, `rise`, `obstacle` and
/// `headroom` (null where the kind has none). Points are [x, y, z] in the file's frame.
std::string formatPathJson(const NavigationMesh& mesh, const Environment& environment, const PathResult& path);

/// The path as one polyline (`g path`, one `l` element), in the frame and units of the environment's file.
std::string formatPathObj(const Environment& environment, const ExportHeader& header, const PathResult& path);

}  // namespace footfall::detail
