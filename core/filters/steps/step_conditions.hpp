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
  /// The sign of something linear at both ends of the stretch, times a factor.
  struct StretchSign {
    LinearSign sign;
    int factor = 1;
    int begin = 0, end = 0;
    [[nodiscard]] bool changes() const { return begin * end < 0; }
    /// Positive on the whole stretch but for single points.
    [[nodiscard]] bool isPositive() const { return begin >= 0 && end >= 0 && begin + end > 0; }
    [[nodiscard]] bool isNegative() const { return begin <= 0 && end <= 0 && begin + end < 0; }
  };
  /// An obstacle over the stretch that is not vertical: on which side of its edges the stretch is, and how high it is
  /// over each floor (of SharedStretch::faces) raised by the step and by the clearance.
  struct Cover {
    Index triangle = -1;
    std::array<StretchSign, 3> edges;
    std::array<std::array<StretchSign, 2>, 2> heights;
  };
  /// A corner of a vertical triangle. Where it is on the line of the stretch: its place in the plan, and the sign of
  /// its height over each floor raised by the step and by the clearance.
  struct WallCorner {
    Index vertex = -1;
    bool isOnLine = false, isAfterBegin = false, isBeforeEnd = false;  ///< of the stretch
    std::array<std::array<int, 2>, 2> signs{};
    MeshVertex place;
  };
  /// The sign of the height of a wall's edge over a floor and a level, along the stretch.
  struct WallSign {
    int before = 0, after = 0;
    Index zero = -1;  ///< in zeros_, where it changes; -1: it is `before` everywhere
  };
  /// An edge of a wall that is not vertical; its corners, of corners_, in the order of the stretch.
  struct WallEdge {
    Index begin = -1, end = -1;
    bool isWhole = false;  ///< the stretch is within it
    std::array<std::array<WallSign, 2>, 2> signs;
  };
  struct Wall {
    std::array<WallEdge, 3> edges;
    int edgeCount = 0;
  };
  /// Walls that hang together by edges along the whole stretch.
  struct WallGroup {
    bool reachesUp = false, reachesDown = false;  ///< on the whole stretch
  };
  struct GroupEdge {
    Index low = -1, high = -1;  ///< vertices
    std::size_t group = 0;
  };

  [[nodiscard]] ApproximatePoint approximateSource(Index vertex) const;
  /// Finds out how the floors lie to each other.
  void compareFloors(const SharedStretch& stretch, MeshGeometry& geometry);
  [[nodiscard]] bool isLevel(Index face) const;
  /// In environment units, as what follows.
  [[nodiscard]] double heightOf(Index face) const { return mesh_.vertices[mesh_.triangles[face][0]].z; }
  [[nodiscard]] double lengthOf(Index level) const {
    return level > 0 ? kernel_.heights()[level - 1] : -kernel_.heights()[-level - 1];
  }
  [[nodiscard]] StretchSign edgeSign(Index triangle, int k) const;
  /// False when obstacles were found that block the whole stretch; then not all are listed.
  bool listObstacles(const SharedStretch& stretch, MeshGeometry& geometry);
  /// False when an edge has the whole stretch on its outer side.
  bool addCover(const SharedStretch& stretch, Index triangle, MeshGeometry& geometry);
  /// Its number in corners_.
  Index cornerOf(const SharedStretch& stretch, Index vertex, MeshGeometry& geometry);
  /// False when it is none along the stretch, or too low or too high.
  bool addWall(const SharedStretch& stretch, Index triangle, MeshGeometry& geometry);
  /// The signs of a source vertex over the floors, by floor and level.
  [[nodiscard]] std::array<std::array<int, 2>, 2> signsOver(const SharedStretch& stretch, Index vertex,
                                                            MeshGeometry& geometry) const;
  /// True only if an obstacle blocks every piece of the stretch, whatever the pieces are.
  [[nodiscard]] bool isBlockedThroughoutBy(const Cover& cover) const;
  /// The same of the last wall together with those before it.
  bool isBlockedThroughoutByWalls();
  std::size_t groupOf(const Wall& wall);
  void addBreaks(const SharedStretch& stretch, const Lines& lines, MeshGeometry& geometry);
  void addCrossing(const SharedStretch& stretch, const StretchSign& sign, const Lines& lines);
  /// Whether the place is strictly within the stretch; then it is a break.
  bool addBreak(const SharedStretch& stretch, const MeshVertex& place, MeshGeometry& geometry);
  void addWallBreaks(const SharedStretch& stretch, Wall& wall, MeshGeometry& geometry);
  bool isFree(const SharedStretch& stretch, const MeshVertex& a, const MeshVertex& b, MeshGeometry& geometry) const;
  bool isBlockedBy(const Cover& cover, const MeshVertex& a, const MeshVertex& b, MeshGeometry& geometry) const;
  bool isBlockedBy(const SharedStretch& stretch, const Wall& wall, const MeshVertex& a, const MeshVertex& b,
                   MeshGeometry& geometry) const;
  int sideAt(const LinearSign& sign, const MeshVertex& p, MeshGeometry& geometry) const;
  void find(StretchSign& sign, const SharedStretch& stretch, MeshGeometry& geometry) const {
    sign.begin = sign.factor * sideAt(sign.sign, stretch.begin, geometry);
    sign.end = sign.factor * sideAt(sign.sign, stretch.end, geometry);
  }
  /// A sign between two places between which it does not change.
  int signBetween(const StretchSign& sign, const MeshVertex& a, const MeshVertex& b, MeshGeometry& geometry) const;
  /// The same of a wall's edge, between a place before `b` and `b`.
  int signBefore(const SharedStretch& stretch, const WallSign& sign, const MeshVertex& b, MeshGeometry& geometry) const;
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
  std::array<Index, 2> levels_;       ///< both
  std::array<StretchSign, 2> rises_;  ///< of the second floor over the first one, raised by the step and lowered by it
  int floorCount_ = 2;                ///< 1: both floors are one plane, and what is asked of the second one is known
  std::vector<Cover> covers_;
  std::vector<Wall> walls_;  ///< vertical obstacles along the stretch
  std::vector<WallCorner> corners_;
  std::vector<MeshVertex> zeros_;
  std::vector<WallGroup> groups_;
  std::vector<GroupEdge> groupEdges_;
  std::vector<KnownLine> lines_;  ///< of the stretch, once they were asked for
  std::vector<MeshVertex> breaks_;
  bool isUndecided_ = false;
  std::size_t undecided_ = 0;
  std::vector<std::int32_t> stack_;
};

}  // namespace footfall::detail
