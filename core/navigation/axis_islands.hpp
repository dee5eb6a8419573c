// Regions of the medial axis that do not reach the border.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/poll.hpp"
#include "core/navigation/corridor_axis.hpp"

namespace footfall::detail {

/// Arcs of the axis to leave out, by number: those of Joined pairs, and one for each island.
///
/// The region of a feature contains the straight way from each of its places to the feature, so it hangs together and
/// reaches the border. Where several features are equally near up to the field's margin, as along a straight row of
/// border edges whose ends are rounded, labels may divide it. A part that does not reach the border is an island. The
/// axis around it is a cycle around nothing; a gate on the cycle may have both ends on one side of the way.
///
/// Each region reaches the border without the arcs that are returned. The arc that an island loses is the one whose
/// nearest places of the border are nearest to each other: two edges of one row, not two sides of a corridor.
std::vector<char> arcsToLeaveOut(const ClearanceField& field, const CorridorAxis& axis, Poll poll);

/// Marks the arcs of all parts of the axis but one for each part of the mesh, of those that are not marked yet. Arcs
/// within a row of edges may hang together with nothing else. The part that stays has the largest area beside it.
void leaveOutSmallParts(const ClearanceField& field, const CorridorAxis& axis, std::vector<char>& isLeftOut);

}  // namespace footfall::detail
