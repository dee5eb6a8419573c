// One triangle that stands in the clearance above a floor triangle.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "footfall/geometry.hpp"

namespace footfall::detail {

/// A triangle that stands in the clearance above a face, and what was found out about it.
struct ClearanceCandidate {
  using Signs = std::array<std::int8_t, 3>;
  Index obstacle = -1;
  Signs floor{}, ceiling{};      ///< signs of each of the obstacle's corners: its height against the floor and the
                                 ///< clearance
  std::array<Signs, 3> sides{};  ///< [edge of the face][corner of the obstacle]: +1 inside
  /// [edge of the obstacle, counter-clockwise in the plan][corner of the face]: +1 inside; not of walls. The edge k is
  /// that between the corners k and k + 1.
  std::array<Signs, 3> corners{};
  bool coplanar = false;

  /// The whole triangle takes from the floor what lies under it.
  [[nodiscard]] bool takesAll() const;
  /// True when all of the face lies under the obstacle, which is no wall.
  [[nodiscard]] bool coversFace() const { return coveredCorners() == kAllCorners; }
  /// Bit j: the corner j of the face lies under the obstacle, which is no wall.
  [[nodiscard]] unsigned coveredCorners() const;
  static constexpr unsigned kAllCorners = 7;
  /// ... or what lies beside the start of the face's edge from corner 0 to 1.
  [[nodiscard]] bool coversStart() const;
};

}  // namespace footfall::detail
