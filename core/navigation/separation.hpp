// What keeps two parts of a walkable area apart: the least that would have to be overcome between them.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts (components) are linked where their borders come near each other (border_links.hpp). Of all chains of links
// from one part to the other, over any parts between, the one is told whose largest link is least; the size of a link
// is the larger of its gap in the plan and of the height that is climbed there, over what stands between. Walls and
// places without headroom count only where nothing else leads across, and then by distance.
//
// Sizes are rounded, and so is the choice between links whose sizes differ by rounding; it does not depend on threads.
// It is Kruskal's algorithm (a chain within a minimum spanning tree has the least largest link), over pairs of borders
// in bands of growing distance, up to the agent's height. Beyond, no step is to be expected, and parts are joined one
// by one with what is nearest to them (Prim's algorithm).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/navigation/link_obstacles.hpp"

namespace footfall::detail {

struct Separation {
  std::vector<BorderLink> links;  ///< from the first part to the other one, over parts between
  std::size_t largest = 0;        ///< of `links`: what to mend first; the first one where several are as large

  [[nodiscard]] const BorderLink& barrier() const { return links[largest]; }
};

/// Made once for a result (60,000 triangles take some 30 ms), then asked from any thread.
class SeparationFinder {
 public:
  /// `environment` is what the mesh was computed from, `height` the agent's. `topology` must outlive this. `poll` is
  /// called now and then, by any thread, and may throw.
  SeparationFinder(
      const NavigationMesh& mesh, const SurfaceTopology& topology, std::shared_ptr<const Environment> environment,
      double height, const std::function<void()>& poll = [] {});

  /// Between two different components of the topology. Nothing only where one of them has no border.
  [[nodiscard]] std::optional<Separation> find(
      std::uint32_t from, std::uint32_t to, const std::function<void()>& poll = [] {}) const;

 private:
  friend class SeparationSearch;

  std::uint32_t componentCount_;
  std::vector<BorderEdge> borders_;
  TriangleTree tree_;  ///< of the borders
  LinkObstacles obstacles_;
};

}  // namespace footfall::detail
