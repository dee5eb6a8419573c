// Reading Wavefront OBJ at double precision.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/environment/environment.hpp"
#include "core/pipeline/run_context.hpp"

namespace footfall {

/// Fills `vertices`, `triangles` and `skipped` from OBJ text, in the file's own frame (no axis is turned).
///
/// Every coordinate is the double nearest to its decimal text. Understood: `v x y z` (a weight or a colour after it is
/// left out), `f` with the forms v, v/t, v//n and v/t/n and negative (relative) or forward indices, `l` and `p`
/// (counted), comments, line continuations by a backslash, and line ends of any system; other statements that begin
/// with a letter are passed over. Triangles come in the order of the file's faces; polygons are split by
/// triangulatePolygon().
///
/// Throws InputError "PATH:LINE: what; what to do" for a number that is none or not finite, a missing coordinate, an
/// index that is zero or out of range, and text that is not OBJ; Cancelled when `context` (may be null) was cancelled.
void readObj(const std::string& path, std::string text, Environment& environment, RunContext* context);

}  // namespace footfall
