// The walkable part of one face as triangles: what its cuts leave.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <memory_resource>
#include <vector>

#include "core/base/poll.hpp"
#include "core/exact/face_cuts.hpp"
#include "core/exact/face_triangulation.hpp"

namespace footfall::detail {

/// Points are numbered within the face; 0, 1, 2 are its corners.
struct FaceMesh {
  struct Facet {
    std::array<Index, 3> corners{};
    std::uint8_t obstacleEdges = 0;                    ///< bit k: edge from corner k to k + 1
    std::uint8_t outlineEdges = 0;                     ///< bit k: no walkable part of this face on the other side
    std::array<std::int8_t, 3> faceEdges{-1, -1, -1};  ///< the face's own edge on which an outline edge lies
    std::array<Index, 3> lines{-1, -1, -1};            ///< supporting line of an outline or obstacle edge
  };
  FaceMesh() = default;
  /// A copy that lies in `memory`.
  FaceMesh(const FaceMesh& other, std::pmr::memory_resource* memory)
      : points(other.points, memory),
        approximate(other.approximate, memory),
        lines(other.lines, memory),
        facets(other.facets, memory) {}

  std::pmr::vector<PlanPoint> points;
  std::pmr::vector<ApproximatePoint> approximate;  ///< relative to the face's first vertex
  std::pmr::vector<PlanLine> lines;
  std::pmr::vector<Facet> facets;
};

/// The remainder of each source triangle after its cuts; null where nothing cuts it.
using FaceMeshes = std::vector<std::shared_ptr<const FaceMesh>>;

/// Triangulates a face by its cuts. `covered` chooses the covered parts instead of the walkable ones.
class FaceMesher {
 public:
  /// `advance(n)` (may be empty) is called when n more segments are in.
  FaceMesher(const PlanKernel& kernel, Poll poll, std::function<void(std::size_t)> advance = {})
      : geometry_(kernel), triangulation_(geometry_, std::move(poll)), advance_(std::move(advance)) {}

  /// Good until the next call.
  const FaceMesh& mesh(Index face, const FaceCuts* cuts, bool covered = false);

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return geometry_.fallbacks; }

 private:
  void insertCuts(const FaceCuts& cuts);

  std::vector<Index> points_, lines_;    ///< number in the geometry of each of the cuts' points and lines
  std::vector<Index> pointOf_, lineOf_;  ///< number in the mesh of each of the geometry's points and lines
  std::vector<char> isTaken_;            ///< one flag per facet of the triangulation
  FaceMesh result_;

  FaceGeometry geometry_;
  FaceTriangulation triangulation_;
  std::function<void(std::size_t)> advance_;
};

}  // namespace footfall::detail
