// The polygons of a file that import left out: the list of them, and its texts for people.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "footfall/environment.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// A polygon with fewer than three distinct ones of these corners, indices into `vertices`; without line or face.
SkippedPolygon skippedPolygon(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices);

/// Counts the polygon, and lists it while the list is not full.
void addSkipped(SkippedElements& skipped, SkippedPolygon polygon);
/// Adds the polygons of a later stretch of the file, whose first line comes after `linesBefore` others.
void appendSkippedPolygons(SkippedElements& skipped, const SkippedElements& later, std::uint64_t linesBefore);

/// The place in the file, "line 12" or "face 3 of mesh 'Wall'".
Text skippedSource(const SkippedPolygon& polygon);
/// Why it was left out, "2 of its 4 corners are different; a polygon needs three".
Text skippedReason(const SkippedPolygon& polygon);

/// A line "  line 12: its 3 corners ..., at 1 2 3" for each of the first polygons, `most` of them, and one for the
/// rest; empty when none was left out. In English; places in the frame of the file, of which `up` is the up axis.
std::string formatSkipped(const SkippedElements& skipped, UpAxis up, std::size_t most);

}  // namespace footfall::detail
