// Exact predicates in the plan: the closed family of lines and points that the pipeline constructs, one level deep.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A new vertex is always the crossing, in the plan, of two lines of a closed family, lifted to a floor's plane: edges
// of source triangles, traces of an obstacle's plane at a level (height 0 or a clearance) above the floor's plane, and
// borders between cells, which are parallel to an axis.
// What a point *is* is kept; its value is computed when needed. A decision goes through up to four stages: rounded
// coordinates with a bound, provenance, doubles with a running error (ErrorDouble), exact integers: on the stack
// (FixedInteger) or, on a grid too wide for the proof of their widths, GMP's.
#pragma once

#include <gmpxx.h>

#include <array>
#include <compare>
#include <memory>
#include <optional>
#include <vector>

#include "core/exact/fixed_integer.hpp"
#include "core/exact/source_mesh.hpp"
#include "footfall/statistics.hpp"

namespace footfall::detail {

/// A directed line in the plan; positive is its left side.
struct PlanLine {
  enum Kind : Index { Edge, Trace, Border };
  Index kind = Edge;
  Index a = -1;  ///< Edge: smaller plan id, from here ... Trace: the obstacle. Border: the axis of its coordinate
  Index b = -1;  ///< ... to the larger plan id. Trace: the level; positive where the obstacle is above floor + level.
                 ///< Border: the number of the coordinate; positive where coordinates are larger
  bool operator==(const PlanLine&) const = default;
};

/// A point in the plan: what it was made of. Equal points may have been made in different ways.
class PlanPoint {
 public:
  enum Kind : Index {
    Source,     ///< a source vertex
    EdgePlane,  ///< a source edge meets the plane of a triangle raised by a level
    Crossing    ///< two lines cross
  };

  PlanPoint() = default;
  static PlanPoint source(Index planId) { return {Source, {planId, -1, -1, -1, -1, -1}, -1}; }
  /// The edge from vertex u to vertex v, in either order.
  static PlanPoint edgePlane(Index u, Index v, Index triangle, Index level) {
    return {EdgePlane, {u < v ? u : v, u < v ? v : u, triangle, level, -1, -1}, -1};
  }
  /// Traces are taken on `face`; -1 where neither line is one.
  static PlanPoint crossing(const PlanLine& first, const PlanLine& second, Index face) {
    return {Crossing, {first.kind, first.a, first.b, second.kind, second.a, second.b}, face};
  }

  [[nodiscard]] Kind kind() const { return static_cast<Kind>(kind_); }
  // A source vertex:
  [[nodiscard]] Index planId() const { return numbers_[0]; }
  // An edge and a plane. The edge's vertices are sorted, the smaller one first.
  [[nodiscard]] Index edgeBegin() const { return numbers_[0]; }
  [[nodiscard]] Index edgeEnd() const { return numbers_[1]; }
  [[nodiscard]] Index triangle() const { return numbers_[2]; }
  [[nodiscard]] Index level() const { return numbers_[3]; }
  // A crossing:
  [[nodiscard]] PlanLine firstLine() const { return {numbers_[0], numbers_[1], numbers_[2]}; }
  [[nodiscard]] PlanLine secondLine() const { return {numbers_[3], numbers_[4], numbers_[5]}; }
  [[nodiscard]] Index face() const { return face_; }

  bool operator==(const PlanPoint&) const = default;
  /// An order without a geometric meaning, for tables.
  auto operator<=>(const PlanPoint&) const = default;

 private:
  PlanPoint(Kind kind, const std::array<Index, 6>& numbers, Index face) : kind_(kind), numbers_(numbers), face_(face) {}

  Index kind_ = Source;
  std::array<Index, 6> numbers_{-1, -1, -1, -1, -1, -1};
  Index face_ = -1;
};

/// Homogeneous plan coordinates relative to an origin vertex: (x, y, w), w > 0, the point is (x / w, y / w).
template <class T>
using Homogeneous = std::array<T, 3>;

/// Rounded scaled coordinates relative to some origin with an absolute error bound on each.
struct ApproximatePoint {
  double x = 0, y = 0;
  double error = 0;
};

struct DoubleContext;
template <class Integer>
struct GridContext;

/// Coordinates of borders between cells, in x and in y (environment units, finite).
using BorderCoordinates = std::array<std::vector<double>, 2>;

/// Predicates over one generation of source geometry, a set of levels and a set of borders. Immutable; shared by all
/// threads.
class PlanKernel {
 public:
  /// `heights[i]` is level i + 1 (environment units, > 0); level -i is its negative, level 0 is the plane itself.
  /// `borders[axis]` are distinct and ascending. Borders change nothing for points and lines that were made without
  /// them: same approximations, same rounded places, same fallbacks. Only the exact integers may be wider.
  PlanKernel(std::shared_ptr<const SourceMesh> mesh, std::vector<double> heights, BorderCoordinates borders = {});

  [[nodiscard]] const SourceMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const std::shared_ptr<const SourceMesh>& sharedMesh() const { return mesh_; }
  [[nodiscard]] const std::vector<double>& heights() const { return heights_; }
  [[nodiscard]] const BorderCoordinates& borders() const { return borders_; }
  [[nodiscard]] const SignRule& sign() const { return sign_; }
  /// The level of a height, if it is one of heights().
  [[nodiscard]] std::optional<Index> levelOf(double height) const;
  [[nodiscard]] double borderCoordinate(const PlanLine& border) const { return borders_[border.a][border.b]; }

  /// Sign of z(vertex) - z_face(vertex) - height(level); the face must face up.
  int heightSign(Index face, Index vertex, Index level, ExactFallbacks& count) const;
  /// Orientation in the plan of three source vertices.
  int orientation(Index a, Index b, Index c, ExactFallbacks& count) const {
    const Vec3 &pa = mesh_->scaled[a], &pb = mesh_->scaled[b], &pc = mesh_->scaled[c];
    if (exactOrientations_) {
      const double area = (pa.x - pc.x) * (pb.y - pc.y) - (pa.y - pc.y) * (pb.x - pc.x);
      return (area > 0) - (area < 0);
    }
    const MaybeSign filtered = filteredArea(pa.x - pc.x, pa.y - pc.y, pb.x - pc.x, pb.y - pc.y, sign_.slack);
    return filtered ? *filtered : orientationBeyondFilter(a, b, c, count);
  }
  /// True when plain doubles decide the orientation of source vertices (Grid).
  [[nodiscard]] bool hasExactOrientations() const { return exactOrientations_; }
  /// True when both triangles lie in one plane (the face must face up).
  bool coplanar(Index face, Index other, ExactFallbacks& count) const;

  /// Provenance: returns true when the point was made on that line (a trace is taken on `face`). False has no meaning.
  [[nodiscard]] bool isKnownOn(const PlanLine& line, Index face, const PlanPoint& point) const;
  /// Coordinate `axis` (0 or 1) where the point's provenance shows that a double holds it exactly.
  [[nodiscard]] std::optional<double> knownCoordinate(const PlanPoint& point, int axis) const;

  /// Sign of a's minus b's coordinate where knownCoordinate() has both.
  [[nodiscard]] std::optional<int> compareKnown(const PlanPoint& a, const PlanPoint& b, int axis) const;
  /// Side of a border at a point where knownCoordinate() has a value.
  [[nodiscard]] std::optional<int> knownSide(const PlanLine& border, const PlanPoint& point) const;
  /// Returns true when the points' provenance shows that they lie on one line. False has no meaning.
  [[nodiscard]] bool areKnownCollinear(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c) const;

  // Values for FaceGeometry and the joining step.
  [[nodiscard]] Homogeneous<ErrorDouble> homogeneous(const PlanPoint& point, Index origin) const;
  [[nodiscard]] Homogeneous<mpz_class> exactHomogeneous(const PlanPoint& point, Index origin) const;
  [[nodiscard]] std::array<ErrorDouble, 3> coefficients(const PlanLine& line, Index face, Index origin) const;
  [[nodiscard]] std::array<mpz_class, 3> exactCoefficients(const PlanLine& line, Index face, Index origin) const;
  /// True when FixedInteger holds all exact values on this grid; only then the two functions below may be called.
  [[nodiscard]] bool fitsFixedIntegers() const { return grid_.width() <= kWidestFixedGrid; }
  [[nodiscard]] Homogeneous<FixedInteger> fixedHomogeneous(const PlanPoint& point, Index origin) const;
  [[nodiscard]] std::array<FixedInteger, 3> fixedCoefficients(const PlanLine& line, Index face, Index origin) const;
  [[nodiscard]] ApproximatePoint approximateSource(Index planId, Index origin) const;
  /// The same for the most common constructed points, in plain doubles; empty where that would be coarse.
  [[nodiscard]] std::optional<ApproximatePoint> approximateQuickly(const PlanPoint& point, Index origin) const;
  /// Rounded coordinates; computed exactly where the running error would be too coarse to decide anything.
  [[nodiscard]] ApproximatePoint approximate(const Homogeneous<ErrorDouble>& h, const PlanPoint& point,
                                             Index origin) const;

  /// Orientation in the plan of any three points; `origin` should be near them.
  int orientation(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c, Index origin,
                  ExactFallbacks& count) const;
  /// Compares coordinate `axis` (0 or 1) of two points.
  int compare(const PlanPoint& a, const PlanPoint& b, int axis, Index origin, ExactFallbacks& count) const;
  /// Sign of z on face f minus z on face g at one plan point; both must not be vertical.
  int compareHeight(const PlanPoint& point, Index f, Index g, ExactFallbacks& count) const;
  /// Sign of a line taken on `face` at a point.
  int side(const PlanLine& line, Index face, const PlanPoint& point, Index origin, ExactFallbacks& count) const;

  /// The exact coordinates of a plan point lifted to a face, in the environment's units.
  [[nodiscard]] std::array<mpq_class, 3> exactPosition(const PlanPoint& point, Index face) const;
  /// The same, each coordinate rounded to the nearest double; `exact` (may be null) is set to whether nothing was lost.
  [[nodiscard]] Vec3 roundedPosition(const PlanPoint& point, Index face, bool* exact = nullptr) const;

 private:
  [[nodiscard]] int orientationBeyondFilter(Index a, Index b, Index c, ExactFallbacks& count) const;
  [[nodiscard]] DoubleContext doubleContext(Index origin) const;
  template <class Integer>
  [[nodiscard]] GridContext<Integer> gridContext(Index origin) const;
  /// Sign of what `evaluate` computes over a GridContext of the integers that this grid needs.
  template <class Evaluate>
  [[nodiscard]] int exactSign(Index origin, const Evaluate& evaluate) const;
  /// The line of the edge of an EdgePlane point.
  [[nodiscard]] PlanLine edgeLineOf(const PlanPoint& point) const;
  /// The edge is parallel to an axis, and the point is known to share the other coordinate with it.
  [[nodiscard]] bool isKnownAlong(const PlanLine& edge, const PlanPoint& point) const;
  [[nodiscard]] bool isKnownLevel(const PlanPoint& point, Index f, Index g) const;
  /// roundedPosition() where doubles of twice the length decide all its digits, of a place that is no triple of
  /// doubles. `known` are knownCoordinate()s; on a level face, z is that of its corners.
  [[nodiscard]] std::optional<Vec3> placeByTwofolds(const PlanPoint& point, Index face,
                                                    const std::array<std::optional<double>, 2>& known,
                                                    bool isLevel) const;

  std::shared_ptr<const SourceMesh> mesh_;
  std::vector<double> heights_;
  std::vector<double> scaledHeights_;
  BorderCoordinates borders_;
  std::array<std::vector<ErrorDouble>, 2> scaledBorders_;
  Grid grid_;
  SignRule sign_;
  bool exactOrientations_ = false;
};

/// Nearest double of a rational, ties to even; overflow gives infinity.
double nearestDouble(const mpq_class& value);

}  // namespace footfall::detail
