// The medial axis as a graph: pieces within faces put together, what leads nowhere left out.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/poll.hpp"
#include "core/navigation/corridor_axis.hpp"
#include "footfall/corridor_map.hpp"

namespace footfall::detail {

/// A chain of arcs between the regions of the same two features.
struct CorridorChain {
  std::uint32_t from = 0, to = 0;     ///< nodes of the axis
  std::uint32_t left = 0, right = 0;  ///< features
  std::vector<std::uint32_t> faces;
  double length = 0, area = 0;
};

struct CorridorGraph {
  std::vector<CorridorChain> chains;
  std::vector<std::uint32_t> alone;  ///< nodes of parts that have no chain
  std::vector<double> hidden;        ///< of each node of the axis, the area beside what was left out there
};

/// `isFull`: pieces that lead into convex corners stay.
CorridorGraph makeCorridorGraph(const ClearanceField& field, const CorridorAxis& axis, bool isFull, Poll poll = {});

/// makeCorridorMap() with a poll instead of a context.
CorridorMap makePolledCorridorMap(const NavigationMesh& mesh, bool isFull, Poll poll);

/// Finds Bottleneck after Bottleneck of a map that has all else. `hidden`: areas that belong to its vertices.
std::vector<Bottleneck> findBottlenecks(const CorridorMap& map, const std::vector<double>& hidden, Poll poll = {});

}  // namespace footfall::detail
