// Decides where an agent drops from a border to a lower place, straight from the definition (docs/explanation/model.md,
// Drops): slow, obvious, exact.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/reference/steps.hpp"

namespace footfall::reference {

/// The abilities of an agent.
struct DropAgent {
  Rational step, clearance, depth, reach;
  Rational least = {};  ///< across a gap it drops by more than this, farther than this
};

/// The point of a border at a share of its length, 0 at `from`.
Point3 pointOn(const BorderEdge3& border, const Rational& share);

/// Returns whether the environment leaves the heights (z + step, z + clearance) free straight over a place of the
/// border.
bool isLedgeAt(const Environment& environment, const BorderEdge3& border, const Rational& share,
               const DropAgent& agent);

/// True for a drop from a place of the border, which is at a ledge, straight down into a walkable triangle: that is
/// there in the limit on the border's far side, lower by at most the depth, and nothing lies in that limit between it
/// and the head of who starts.
bool canDropStraight(const Environment& environment, const BorderEdge3& border, const Rational& share,
                     const std::array<Point3, 3>& landing, const DropAgent& agent);

/// True for a drop from a place of the border, which is at a ledge, straight outwards in the plan to another border,
/// where one enters the walkable area: at most `reach` away, lower by at most the depth, nothing over the way higher
/// than the step and within the clearance, and nothing over the landing, in the limit on its walkable side, below the
/// head of who starts.
bool canDropAcross(const Environment& environment, const BorderEdge3& border, const Rational& share,
                   const BorderEdge3& landing, const DropAgent& agent);

}  // namespace footfall::reference
