// Whether an agent steps over where two borders coincide in the plan, decided piece by piece.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/base/geometry.hpp"
#include "core/mesh/mesh_geometry.hpp"

namespace footfall::detail {

/// Two borders that coincide along a stretch, which goes from `begin` to `end`.
struct SharedStretch {
  std::array<Index, 2> faces{};  ///< the planes on either side
  MeshVertex begin, end;
  Box box;            ///< holds it, on both sides; scaled
  int axis = 0;       ///< coordinate in which they differ
  int direction = 1;  ///< +1: it grows from begin to end
};

/// A line through a stretch, as it was made: a trace is taken on `face`.
struct KnownLine {
  PlanLine line;
  Index face = -1;
};

/// Design section 7, StepFilter, for a gap of 0: at p on the one border and q on the other, |z(p) - z(q)| <= step, and
/// nothing of the environment lies strictly between min(z(p), z(q)) + step and max(z(p), z(q)) + H straight above.
///
/// Everything that is asked along a stretch is the sign of a function that is linear there: how high an obstacle's
/// plane or edge is over one of the two floors, on which side of an obstacle's edge one is. Between the places where
/// one of them is zero nothing changes, and those places are of the closed family: crossings of the line with traces
/// and edges, source vertices, edges in raised planes. Single points do not count, so what happens there is not asked.
class StepConditions {
 public:
  using Lines = std::function<std::vector<KnownLine>()>;

  /// `step` and `height` are levels of the kernel. `removed`: for each source triangle, it is out of the environment.
  StepConditions(const PlanKernel& kernel, const std::vector<char>& removed, Index step, Index height);

  /// The pieces, in order along the stretch, that can be stepped over; neighbours are one piece. `lines` gives what the
  /// stretch is known to lie on; where none of that makes a crossing, nothing is (undecided()).
  std::vector<std::array<MeshVertex, 2>> find(const SharedStretch& stretch, const Lines& lines, MeshGeometry& geometry);

  [[nodiscard]] std::size_t undecided() const { return undecided_; }

 private:
  /// Positive on the line's left; a trace is taken on `face`, and positive where the obstacle is above face + level.
  struct LinearSign {
    PlanLine line;
    Index face = -1;
  };
  /// A corner of a wall: its place in the plan, and the sign of its height over each floor (of SharedStretch::faces)
  /// raised by the step and by the clearance.
  struct WallCorner {
    Index vertex = -1;
    MeshVertex place;
    std::array<std::array<int, 2>, 2> signs{};
  };
  /// An edge of a wall that is not vertical; its ends in the order of the stretch.
  struct WallEdge {
    WallCorner begin, end;
  };
  using Wall = std::vector<WallEdge>;

  [[nodiscard]] ApproximatePoint approximateSource(Index vertex) const;
  [[nodiscard]] std::array<LinearSign, 2> stepSigns(const SharedStretch& stretch) const;
  [[nodiscard]] LinearSign edgeSign(Index triangle, int k, int& inside) const;
  /// False when one obstacle was found that blocks the whole stretch; then not all are listed.
  bool listObstacles(const SharedStretch& stretch, MeshGeometry& geometry);
  bool mayCover(const SharedStretch& stretch, Index triangle, MeshGeometry& geometry) const;
  void addWall(const SharedStretch& stretch, Index triangle, MeshGeometry& geometry);
  /// True only if an obstacle blocks every piece of the stretch, whatever the pieces are.
  bool isBlockedThroughoutBy(const SharedStretch& stretch, Index triangle, MeshGeometry& geometry) const;
  bool isBlockedThroughoutBy(const SharedStretch& stretch, const Wall& wall, MeshGeometry& geometry) const;
  void addBreaks(const SharedStretch& stretch, const Lines& lines, MeshGeometry& geometry);
  void addCrossing(const SharedStretch& stretch, const LinearSign& sign, const Lines& lines, MeshGeometry& geometry);
  void addBreak(const SharedStretch& stretch, const MeshVertex& place, MeshGeometry& geometry);
  bool isFree(const SharedStretch& stretch, const MeshVertex& a, const MeshVertex& b, MeshGeometry& geometry) const;
  bool isBlockedBy(const SharedStretch& stretch, Index triangle, const MeshVertex& a, const MeshVertex& b,
                   MeshGeometry& geometry) const;
  bool isBlockedBy(const SharedStretch& stretch, const Wall& wall, const MeshVertex& a, const MeshVertex& b,
                   MeshGeometry& geometry) const;
  int sideAt(const LinearSign& sign, const MeshVertex& p, MeshGeometry& geometry) const;
  /// A sign between two places between which it does not change.
  int signBetween(const LinearSign& sign, const MeshVertex& a, const MeshVertex& b, MeshGeometry& geometry) const;
  /// The sign of the height of a wall's edge over a face and a level, between a place before `b` and `b`.
  int heightBetween(const SharedStretch& stretch, const WallEdge& edge, int face, int level, const MeshVertex& b,
                    MeshGeometry& geometry) const;
  [[nodiscard]] PlanPoint zeroOf(const SharedStretch& stretch, const WallEdge& edge, int face, int level) const {
    return PlanPoint::edgePlane(edge.begin.vertex, edge.end.vertex, stretch.faces[face], levels_[level]);
  }
  /// A source vertex as a place of the plan; its height is not that of a floor.
  [[nodiscard]] MeshVertex placeOf(const SharedStretch& stretch, Index vertex) const;
  [[nodiscard]] int compareAlong(const SharedStretch& stretch, const MeshVertex& a, const MeshVertex& b,
                                 MeshGeometry& geometry) const {
    return stretch.direction * geometry.compare(a, b, stretch.axis);
  }

  const PlanKernel& kernel_;
  const SourceMesh& mesh_;
  const std::vector<char>& removed_;
  Index step_, height_;
  std::array<Index, 2> levels_;   ///< both
  std::vector<Index> covers_;     ///< obstacles over the stretch that are not vertical
  std::vector<Wall> walls_;       ///< vertical ones along it
  std::vector<KnownLine> lines_;  ///< of the stretch, once they were asked for
  std::vector<MeshVertex> breaks_;
  bool isUndecided_ = false;
  std::size_t undecided_ = 0;
  std::vector<std::int32_t> stack_;
};

}  // namespace footfall::detail
