// The obstacles of an environment between two borders of its walkable area.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/poll.hpp"
#include "core/base/triangle_tree.hpp"
#include "core/navigation/border_links.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// An index of the triangles that can stand in the way. Made once for an environment, then used by any thread.
class LinkObstacles {
 public:
  struct Way;

  /// `height` and `step` are those of the agent, in the environment's units. `poll` may throw.
  LinkObstacles(std::shared_ptr<const Environment> environment, double height, double step = 0, Poll poll = {});

  /// Looks at what lies over the way between the two places of a link, from border `a` to border `b`: above the higher
  /// of both and above what is stepped over, and less than the agent's height above it. Sets the kind of an open link,
  /// and its obstacle or headroom. Returns whether the way leads from one walkable side to the other, and not only
  /// along one of them. A link must be more than one point, so the place right beside each counts where less stands
  /// there.
  ///
  /// Computed in doubles, and from one side: what is found stands there, up to a few units in the last place, within
  /// kReach of both borders; what stands nowhere on the two lines that are looked along, or reaches less than kMargin
  /// into the agent, is not seen. So an obstacle is never invented, and a way that is called open may not be.
  bool lookAt(BorderLink& link, const SurfaceBorder& a, const SurfaceBorder& b, std::vector<std::int32_t>& stack) const;

  /// Fills in `triangles` of a link that was looked at.
  void findTriangles(BorderLink& link, const SurfaceBorder& a, const SurfaceBorder& b,
                     std::vector<std::int32_t>& stack) const;

  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] double step() const { return step_; }

 private:
  /// The obstacle that was found, and the way along which it was found.
  struct Sight;
  [[nodiscard]] std::optional<Sight> look(const BorderLink& link, const SurfaceBorder& a, const SurfaceBorder& b,
                                          std::vector<std::int32_t>& stack) const;
  [[nodiscard]] BorderLink seeAlong(const Way& way, const BorderLink& link, std::vector<std::int32_t>& stack) const;
  template <class Visit>
  void visitAlong(const Way& way, double low, double high, std::vector<std::int32_t>& stack, const Visit& visit) const;
  [[nodiscard]] std::array<double, 2> heightsInTheWay(const BorderLink& link) const;

  std::shared_ptr<const Environment> environment_;
  double height_, step_;
  TriangleTree tree_;
};

}  // namespace footfall::detail
