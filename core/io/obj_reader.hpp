// Reading Wavefront OBJ at double precision.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "footfall/environment.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The groups of an OBJ file (`g`), in its order, with their content.
struct ObjGroups {
  struct Group {
    std::string name;           ///< the words after `g`, unchanged; empty before the first `g`
    std::size_t firstTriangle;  ///< in Environment::triangles; the last one precedes the next group's first
    std::size_t firstSegment;   ///< the same for `segments`
  };
  std::vector<Group> groups;
  /// The pieces of all `l` elements, as vertex indices.
  std::vector<std::array<std::uint32_t, 2>> segments;
};

/// Fills `vertices`, `triangles`, `skipped`, `parts` and `partOf` from OBJ text, in the file's own frame (no axis is
/// turned).
///
/// Every coordinate is the double nearest to its decimal text. The reader accepts `v x y z` (a weight or a colour after
/// it is left out), `f` with the forms v, v/t, v//n and v/t/n and negative (relative) or forward indices, `l` and `p`
/// (counted), `o`, `g` and `usemtl` (parts: obj_parts.hpp), comments, line continuations by a backslash, and line ends
/// of any system; other statements that begin with a letter are passed over. Triangles are in the order of the file's
/// faces; polygons are split by triangulatePolygon().
///
/// Throws InputError "PATH:LINE: what; what to do" for a malformed or infinite number, a missing coordinate, an index
/// that is zero or out of range, and text that is not OBJ; Cancelled when `context` (may be null) was cancelled.
///
/// `groups` (may be null) receives the groups and the line elements.
void readObj(const std::string& path, std::string text, Environment& environment, RunContext* context,
             ObjGroups* groups = nullptr);

}  // namespace footfall::detail
