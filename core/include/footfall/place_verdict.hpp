// The verdicts on a place: why it is walkable or not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace footfall {

/// A verdict of a filter belongs to a removal of that filter (core/filters/filter_traits.hpp). A new filter needs no
/// verdict here: it has Removed, and words of its own.
enum class PlaceVerdict {
  Walkable,
  NoArea,          ///< the triangle is degenerate
  Vertical,        ///< it is a wall
  FacesDown,       ///< no triangle in its plane that faces up is here
  NeverFloor,      ///< it faces up, but is no floor before the first filter
  TooSteep,        ///< SlopeFilter
  TooLow,          ///< VerticalClearanceFilter
  RegionTooSmall,  ///< AreaFilter
  Moved,           ///< a filter that moves vertices left nothing here
  Unreachable,     ///< ReachableFilter
  TooNearWall,     ///< RadiusFilter
  TooNearLedge,    ///< RadiusFilter; no wall is too near
  Removed,         ///< another filter removed it: the one of PlaceExplanation::step
};

}  // namespace footfall
