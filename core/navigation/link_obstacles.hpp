// What of an environment stands between two borders of its walkable area.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/poll.hpp"
#include "core/base/triangle_tree.hpp"
#include "core/navigation/border_links.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// Made once for an environment, then asked from any thread.
class LinkObstacles {
 public:
  struct Way;

  /// `height` is that of the agent, in the environment's units. `poll` may throw.
  LinkObstacles(std::shared_ptr<const Environment> environment, double height, Poll poll = {});

  /// Looks at what lies over the way between the two places of a link, from border `a` to border `b`: above the higher
  /// of both, and less than the agent's height above it. Sets the kind of an open link, and its obstacle or headroom.
  /// Returns whether the way leads from one walkable side to the other, and not only along one of them. As a link must
  /// be more than one point, it is looked right beside the places, where less stands.
  ///
  /// In doubles, and blind for what is lower than a thousandth of the agent.
  bool lookAt(BorderLink& link, const BorderEdge& a, const BorderEdge& b, std::vector<std::int32_t>& stack) const;

  [[nodiscard]] double height() const { return height_; }

 private:
  [[nodiscard]] BorderLink seeAlong(const Way& way, const BorderLink& link, std::vector<std::int32_t>& stack) const;

  std::shared_ptr<const Environment> environment_;
  double height_;
  TriangleTree tree_;
};

}  // namespace footfall::detail
