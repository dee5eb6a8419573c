// The full corridor map as ways between vertices, by which paths for a body are found.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/poll.hpp"
#include "core/mesh/clearance_field.hpp"
#include "core/navigation/corridor_axis.hpp"
#include "core/navigation/corridor_graph.hpp"
#include "core/navigation/field_places.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// A place of the axis, and its nearest places of the border on the left and on the right of a way.
struct CorridorGate {
  FieldVector place;
  double distance = 0;                  ///< to both
  std::array<FieldVector, 2> border{};  ///< on the left and on the right
  std::array<FieldVector, 2> away{};    ///< directions of length 1, from there to the place
  std::array<std::uint32_t, 2> ends{};  ///< the same numbers for the same border places of the same place
};

/// A piece of the axis between the same two features. Places on it are known by how far along `direction` they are.
struct CorridorWay {
  std::uint32_t from = 0, to = 0;            ///< vertices
  std::array<std::uint32_t, 2> features{};   ///< left and right, from `from` to `to`
  FieldVector direction;                     ///< of length 1
  double begin = 0, end = 0;                 ///< of its ends, along `direction`
  std::optional<FieldVector> narrow;         ///< where it is narrowest, between its ends
  double narrowDistance = 0;                 ///< from there to the border
  double least = 0;                          ///< the least distance from it to the border
  std::size_t firstGate = 0, gateCount = 0;  ///< from `from` to `to`, both ends included; two at least
  std::vector<std::uint32_t> faces;
  [[nodiscard]] double along(FieldVector p) const { return dot(p, direction); }
};

/// A way as it leads away from a vertex: what a search reads at every vertex that it passes.
struct CorridorExit {
  double least = 0;  ///< that of the way
  std::uint32_t way = 0, next = 0;
  std::uint32_t firstGate = 0, gateCount = 0;
  bool isForward = false;  ///< the way begins at the vertex
  bool isOutward = false;  ///< it leads into a part without cycles
};

/// A place on a way, and how far it is from the border there.
struct CorridorFoot {
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  std::uint32_t way = kNone;
  FieldVector place;
  double distance = 0;
};

/// The narrowest place of a part of a way.
struct CorridorNeck {
  std::uint32_t way = CorridorFoot::kNone;
  FieldVector place;
  double distance = std::numeric_limits<double>::infinity();
};

class CorridorNetwork {
 public:
  /// `mesh` must outlive it.
  CorridorNetwork(const NavigationMesh& mesh, Poll poll);
  CorridorNetwork(const CorridorNetwork&) = delete;
  CorridorNetwork& operator=(const CorridorNetwork&) = delete;

  [[nodiscard]] const ClearanceField& field() const { return field_; }
  [[nodiscard]] const NavigationMesh& bridged() const { return bridged_; }
  [[nodiscard]] const FieldPlaces& places() const { return places_; }
  [[nodiscard]] const std::vector<AxisNode>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<CorridorWay>& ways() const { return ways_; }
  /// Ways at a vertex, in their order.
  [[nodiscard]] std::span<const CorridorExit> exitsAt(std::uint32_t vertex) const {
    return std::span(exits_).subspan(firstExit_[vertex], firstExit_[vertex + 1] - firstExit_[vertex]);
  }
  /// Ways over a face.
  [[nodiscard]] const std::vector<std::uint32_t>& waysIn(std::uint32_t face) const { return waysIn_[face]; }
  /// A way as it leads away from its first vertex, or from its last one.
  [[nodiscard]] CorridorExit exitAlong(std::uint32_t way, bool isForward) const;
  [[nodiscard]] std::uint32_t otherEnd(std::uint32_t way, std::uint32_t vertex) const {
    return ways_[way].from == vertex ? ways_[way].to : ways_[way].from;
  }

  /// Gates of all ways. Where a feature is a corner, gates turn round it by at most kTurn between each other.
  [[nodiscard]] const std::vector<CorridorGate>& gates() const { return gates_; }
  [[nodiscard]] std::span<const CorridorGate> gatesOf(const CorridorWay& way) const {
    return std::span(gates_).subspan(way.firstGate, way.gateCount);
  }
  static constexpr double kTurn = 0.1;
  /// The way by which one gets from a vertex towards the cycles of its part, where no cycle leads through the vertex;
  /// else CorridorFoot::kNone. In a part without cycles one vertex has none.
  [[nodiscard]] std::uint32_t wayInward(std::uint32_t vertex) const { return inward_[vertex]; }
  /// The narrowest way on the route between two vertices whose narrowest way is widest. Nothing where none leads from
  /// one to the other, kNone where both are one.
  [[nodiscard]] std::optional<std::uint32_t> widestRoute(std::uint32_t a, std::uint32_t b) const;

  /// The place at which one comes to the axis when one goes away from the border, from a place on a face that is not on
  /// the border: all along, the place's own nearest border is nearest. Nothing where no way is there.
  [[nodiscard]] std::optional<CorridorFoot> footOf(std::uint32_t face, FieldVector p) const;

  /// The narrowest place between two places on a way.
  [[nodiscard]] CorridorNeck neckBetween(std::uint32_t way, const CorridorFoot& a, const CorridorFoot& b) const;
  /// An end of a way as a place on it.
  [[nodiscard]] CorridorFoot footAt(std::uint32_t way, std::uint32_t vertex) const {
    return {way, vertices_[vertex].place, vertices_[vertex].distance};
  }

 private:
  /// The way at a place on the axis; one beside the region of `feature` where there is one.
  [[nodiscard]] std::optional<CorridorFoot> wayNear(std::uint32_t face, FieldVector p, std::uint32_t feature) const;
  void addWay(const CorridorChain& chain, std::uint32_t from, std::uint32_t to);
  void addGates(CorridorWay& way);
  void numberEnds();
  void shareEnd(std::uint32_t feature, std::size_t gate, int side,
                std::vector<std::pair<std::uint32_t, std::uint32_t>>& known, std::uint32_t& next);
  void findInward();
  void listExits();
  void findWidest();

  const NavigationMesh& mesh_;
  NavigationMesh bridged_;
  ClearanceField field_;
  FieldPlaces places_{mesh_, bridged_, field_};
  std::vector<AxisNode> vertices_;
  std::vector<CorridorWay> ways_;
  std::vector<CorridorGate> gates_;
  std::vector<std::vector<std::uint32_t>> waysAt_, waysIn_;  ///< of each vertex; of each face
  std::vector<std::uint32_t> inward_;
  std::vector<CorridorExit> exits_;
  std::vector<std::size_t> firstExit_;  ///< of each vertex, and the number of all
  /// A forest over the vertices: parts that were joined, the widest way first, with the number of the joining way in
  /// that order.
  std::vector<std::uint32_t> joinedTo_, joinedBy_, widestFirst_;
};

}  // namespace footfall::detail
