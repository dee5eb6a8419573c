// Decides, piece by piece, whether an agent steps over where two borders coincide in the plan.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/index_and_box.hpp"
#include "core/mesh/mesh_geometry.hpp"

namespace footfall::detail {

/// Two borders that coincide along a stretch, which goes from `begin` to `end`.
struct SharedStretch {
  std::array<Index, 2> faces{};  ///< planes on either side
  MeshVertex begin, end;
  Box box;            ///< scaled box that holds the stretch on both sides
  int axis = 0;       ///< coordinate in which the ends differ
  int direction = 1;  ///< +1: the coordinate grows from begin to end
};

/// A line through a stretch in its original form; a trace is taken on `face`.
struct KnownLine {
  PlanLine line;
  Index face = -1;
};

/// The conditions of StepFilter for a gap of 0 (model, Steps): at p on one border and q on the other, |z(p) -
/// z(q)| <= step, and nothing of the environment lies strictly between min(z(p), z(q)) + step and max(z(p), z(q)) + H
/// straight above.
///
/// Every condition along a stretch is the sign of a linear function: the height of an obstacle's plane or edge over one
/// of the two floors, or the side of an obstacle's edge. Nothing changes between the zeros of these functions. The
/// zeros belong to the closed family: crossings of the line with traces and edges, source vertices, edges in raised
/// planes. Single points do not count, so conditions at the zeros themselves are not computed.
class StepConditions {
 public:
  using Lines = std::function<std::vector<KnownLine>()>;

  /// `step` and `height` are levels of the kernel. `removed` has an entry for each source triangle, true where it is
  /// out of the environment.
  StepConditions(const PlanKernel& kernel, const std::vector<char>& removed, Index step, Index height);

  /// Two levels, one below the step and one above it. A stretch whose rise goes from the lower one or more to beyond
  /// the higher one is not linked: only the rounding of coordinates lets a piece of it be within the step.
  void refuseBetween(Index lower, Index higher) { atLimit_ = {lower, higher}; }

  /// The pieces that can be stepped over, in order along the stretch; neighbouring pieces are joined. `lines` returns
  /// the lines that the stretch is known to lie on. Where none of them makes a crossing, there are no pieces
  /// (undecided()).
  std::vector<std::array<MeshVertex, 2>> find(const SharedStretch& stretch, const Lines& lines, MeshGeometry& geometry);

  [[nodiscard]] std::size_t undecided() const { return undecided_; }

 private:
  /// A sign that is positive on the line's left; a trace is taken on `face`, and is positive where the obstacle is
  /// above face + level.
  struct LinearSign {
    PlanLine line;
    Index face = -1;
  };
  /// The sign of a linear function at both ends of the stretch, times a factor.
  struct StretchSign {
    LinearSign sign;
    int factor = 1;
    int begin = 0, end = 0;
    [[nodiscard]] bool changes() const { return begin * end < 0; }
    /// Returns whether the sign is positive on the whole stretch except at single points.
    [[nodiscard]] bool isPositive() const { return begin >= 0 && end >= 0 && begin + end > 0; }
    [[nodiscard]] bool isNegative() const { return begin <= 0 && end <= 0 && begin + end < 0; }
  };
  /// An obstacle over the stretch that is not vertical: the side of its edges on which the stretch lies, and its height
  /// over each floor (SharedStretch::faces) raised by the step and by the clearance.
  struct Cover {
    Index triangle = -1;
    std::array<StretchSign, 3> edges;
    std::array<std::array<StretchSign, 2>, 2> heights;
    /// Bounds of where it may be over the stretch, along it (placeAlong()).
    double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
  };
  /// A corner of a vertical triangle. On the line of the stretch, it has its place in the plan, and the sign of its
  /// height over each floor raised by the step and by the clearance.
  struct WallCorner {
    Index vertex = -1;
    bool isOnLine = false, isAfterBegin = false, isBeforeEnd = false;  ///< relative to the stretch
    std::array<std::array<int, 2>, 2> signs{};
    MeshVertex place;
  };
  /// The sign of the height of a wall's edge over a floor and a level, along the stretch.
  struct WallSign {
    int before = 0, after = 0;
    Index zero = -1;  ///< place of the change in zeros_; -1: the sign is `before` everywhere
  };
  /// An edge of a wall that is not vertical. Its corners, in corners_, are in the order of the stretch.
  struct WallEdge {
    Index begin = -1, end = -1;
    bool isWhole = false;  ///< the stretch is within it
    std::array<std::array<WallSign, 2>, 2> signs;
  };
  struct Wall {
    std::array<WallEdge, 3> edges;
    int edgeCount = 0;
  };
  /// Walls that are connected by edges along the whole stretch.
  struct WallGroup {
    bool reachesUp = false, reachesDown = false;  ///< along the whole stretch
  };
  struct GroupEdge {
    Index low = -1, high = -1;  ///< vertices
    std::size_t group = 0;
  };

  [[nodiscard]] ApproximatePoint approximateSource(Index vertex) const;
  /// Compares the heights of the floors.
  void compareFloors(const SharedStretch& stretch, MeshGeometry& geometry);
  [[nodiscard]] bool isLevel(Index face) const;
  /// Lengths here and below are in environment units.
  [[nodiscard]] double heightOf(Index face) const { return mesh_.vertices[mesh_.triangles[face][0]].z; }
  [[nodiscard]] double lengthOf(Index level) const {
    return level > 0 ? kernel_.heights()[level - 1] : -kernel_.heights()[-level - 1];
  }
  [[nodiscard]] StretchSign edgeSign(Index triangle, int k) const;
  [[nodiscard]] bool isOnlyAtLimit(const SharedStretch& stretch, MeshGeometry& geometry) const;
  /// Returns false when one of the obstacles blocks the whole stretch; then not all are listed.
  bool listObstacles(const SharedStretch& stretch, MeshGeometry& geometry);
  /// Returns false when the whole stretch is on the outer side of an edge.
  bool addCover(const SharedStretch& stretch, Index triangle, MeshGeometry& geometry);
  /// The number of the corner in corners_.
  Index cornerOf(const SharedStretch& stretch, Index vertex, MeshGeometry& geometry);
  /// Returns false when the wall does not run along the stretch, or is too low or too high.
  bool addWall(const SharedStretch& stretch, Index triangle, MeshGeometry& geometry);
  /// The signs of a source vertex over the floors, by floor and level.
  [[nodiscard]] std::array<std::array<int, 2>, 2> signsOver(const SharedStretch& stretch, Index vertex,
                                                            MeshGeometry& geometry) const;
  /// True only if an obstacle blocks every piece of the stretch, for any pieces.
  [[nodiscard]] bool isBlockedThroughoutBy(const Cover& cover) const;
  /// True only if the last wall and the walls before it together block every piece.
  bool isBlockedThroughoutByWalls();
  std::size_t groupOf(const Wall& wall);
  void addBreaks(const SharedStretch& stretch, const Lines& lines, MeshGeometry& geometry);
  /// Makes the place where a sign changes a break; null where it does not change or no such place was found.
  const MeshVertex* addCrossing(const SharedStretch& stretch, const StretchSign& sign, const Lines& lines);
  /// Bounds of a coordinate that ascends along the stretch.
  struct Along {
    double low, high;
  };
  [[nodiscard]] Along placeAlong(const SharedStretch& stretch, const MeshVertex& place) const;
  /// Makes a place a break where it is strictly within the stretch. Returns whether it is.
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
  /// The sign of a wall's edge between `b` and a place before it.
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
  std::array<Index, 2> levels_;  ///< step and height
  std::optional<std::array<Index, 2>> atLimit_;
  std::array<StretchSign, 2> rises_;  ///< second floor over the first one, raised by the step and lowered by it
  int floorCount_ = 2;  ///< 1: both floors are one plane, so the signs of the second one are those of the first
  std::vector<Cover> covers_;
  std::vector<Wall> walls_;  ///< vertical obstacles along the stretch
  std::vector<WallCorner> corners_;
  std::vector<MeshVertex> zeros_;
  std::vector<WallGroup> groups_;
  std::vector<GroupEdge> groupEdges_;
  std::vector<KnownLine> lines_;  ///< lines of the stretch, once they were computed
  std::vector<MeshVertex> breaks_;
  bool isUndecided_ = false;
  std::size_t undecided_ = 0;
  std::vector<std::int32_t> stack_;
};

}  // namespace footfall::detail
