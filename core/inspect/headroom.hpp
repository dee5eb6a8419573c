// The free height above places, for heat maps.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A picture's measure, in doubles. What decides over walkable and not is VerticalClearanceFilter, exactly; what is said
// of one place in words is core/inspect/inspection.hpp's, exactly too.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "core/base/triangle_tree.hpp"
#include "footfall/environment.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// The triangles that may be above something: all triangles of an environment that are not vertical. Immutable; shared
/// by threads.
class HeadroomTree {
 public:
  /// O(n log n), in parallel. `poll` is called every few milliseconds, by any thread, and may throw to cancel.
  explicit HeadroomTree(std::shared_ptr<const Environment> environment, Poll poll = {});

  struct Above {
    double height = 0;           ///< height of the triangle above the place, > 0
    std::uint32_t triangle = 0;  ///< index into Environment::triangles
  };
  /// The lowest triangle straight above a place (finite, environment units, Z up), less than `cap` above it. A triangle
  /// covers what lies inside or on its outline in the plan; walls cover nothing. What is above the place by no more
  /// than rounding its coordinates may have moved it does not count: that is the floor itself. Of several in one place
  /// the one with the smallest index.
  [[nodiscard]] std::optional<Above> lowestAbove(const Vec3& place, double cap, std::vector<std::int32_t>& stack) const;

  [[nodiscard]] const Environment& environment() const { return *environment_; }

 private:
  std::shared_ptr<const Environment> environment_;
  TriangleTree tree_;
};

/// The free height above each place, or `cap` if that is at least `cap` (environment units, > 0; infinity is fine). In
/// parallel; `poll` as above, about every millisecond.
std::vector<float> headroomAt(const HeadroomTree& tree, std::span<const Vec3> places, double cap, Poll poll = {});

}  // namespace footfall::detail
