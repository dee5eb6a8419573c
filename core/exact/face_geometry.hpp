// The points and lines that meet on one floor triangle, with their exact predicates. Reused from face to face by one
// thread.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "core/base/numbered_table.hpp"
#include "core/exact/integer_triples.hpp"
#include "core/exact/plan_kernel.hpp"

namespace footfall::detail {

class FaceGeometry {
 public:
  explicit FaceGeometry(const PlanKernel& kernel) : kernel_(kernel) {}

  /// Starts on a face: its corners become the points 0, 1, 2 and its edges (corner k to k + 1) the lines 0, 1, 2.
  void start(Index face);

  [[nodiscard]] const PlanKernel& kernel() const { return kernel_; }
  [[nodiscard]] Index face() const { return face_; }
  [[nodiscard]] Index origin() const { return origin_; }

  /// Makes room for so many points.
  void reserve(std::size_t points) { points_.reserve(points); }

  Index point(const PlanPoint& p);
  /// The point at a source vertex.
  Index sourcePoint(Index planId);
  Index line(const PlanLine& l);
  /// The same for a line that is looked up once only, unless it is the face's own edge.
  Index newLine(const PlanLine& l);
  /// The line of a source edge, by the plan ids of its ends (different ones).
  Index edgeLine(Index planA, Index planB);
  [[nodiscard]] const PlanPoint& operator[](Index point) const { return points_[point]; }
  [[nodiscard]] const PlanLine& lineAt(Index line) const { return lines_[line]; }
  [[nodiscard]] std::size_t pointCount() const { return points_.size(); }
  [[nodiscard]] std::size_t lineCount() const { return lines_.size(); }

  /// Bit k: the point is known to lie on the face's edge k.
  [[nodiscard]] std::uint8_t border(Index point) const { return places_[point].border; }
  void addBorder(Index point, std::uint8_t mask) { places_[point].border |= mask; }
  /// +1 when the face's edge k runs along its line's direction, -1 against it.
  [[nodiscard]] int edgeDirection(int k) const { return edgeDirection_[k]; }

  /// The crossing of two lines that are not parallel, in canonical form.
  Index crossing(Index line1, Index line2);

  /// Sign of the line at the point: +1 left of it.
  int side(Index line, Index point);
  /// The same, faster for a point that seems to lie on the line: provenance is checked before doubles.
  int sideNearby(Index line, Index point);
  /// Side of the face's edge k: +1 inside, 0 on it.
  int sideOfEdge(int k, Index point);
  int orientation(Index a, Index b, Index c) {
    const ApproximatePoint &p = approximate_[a], &q = approximate_[b], &r = approximate_[c];
    const double value = (p.x - r.x) * (q.y - r.y) - (p.y - r.y) * (q.x - r.x);
    if (value > surely_) return 1;
    if (value < -surely_) return -1;
    return orientationBeyondBound(a, b, c);
  }
  int compare(Index a, Index b, int axis);

  [[nodiscard]] const ApproximatePoint& approximate(Index point) const { return approximate_[point]; }
  /// The bound beyond which an orientation from approximate coordinates relative to one of its three points is certain.
  [[nodiscard]] double certainTurn() const { return surely_; }

  ExactFallbacks fallbacks;

 private:
  /// Further values of a point. Values that only some decisions need are computed when one does.
  struct Place {
    Homogeneous<ErrorDouble> homogeneous;  ///< once hasHomogeneous
    Index exact = -1;                      ///< index in exact_
    std::uint8_t border = 0;
    bool hasHomogeneous = false;
  };
  /// Source vertices are found by their number: slots carry that of the face that they were filled for.
  struct SourceSlot {
    std::uint32_t filling;
    Index point;
  };
  struct Free {
    void operator()(SourceSlot* all) const { std::free(all); }
  };
  void forgetSources();
  struct Line {
    std::array<ErrorDouble, 3> coefficients;  ///< once hasCoefficients
    Index exact = -1;                         ///< index in exact_
    bool hasCoefficients = false;
  };
  [[nodiscard]] bool isSource(Index point) const { return points_[point].kind() == PlanPoint::Source; }
  int orientationBeyondBound(Index a, Index b, Index c);
  /// Notes where a new point lies, for which surely_ is to hold as well.
  void place(const ApproximatePoint& point);
  Index borderCrossing(PlanLine l, PlanLine m);
  const Homogeneous<ErrorDouble>& homogeneous(Index point);
  /// The number of a point's, or of a line's, exact coordinates in exact_.
  Index exact(Index point);
  Index exactLine(Index line);
  [[nodiscard]] bool areOnSameBorder(Index a, Index b, Index c) const;

  const PlanKernel& kernel_;
  Index face_ = -1;
  Index origin_ = -1;
  std::array<int, 3> edgeDirection_{};
  NumberedTable<PlanPoint> points_;              ///< only those that are no source vertices are found by their key
  std::unique_ptr<SourceSlot[], Free> sources_;  ///< one per plan id; zeros, whose pages are allocated as they are used
  std::size_t sourceCount_ = 0;
  std::uint32_t filling_ = 0;
  NumberedTable<PlanLine> lines_;
  std::vector<ApproximatePoint> approximate_;
  std::vector<Place> places_;
  std::vector<Line> lineValues_;
  IntegerTriples exact_;
  double size_ = 0, error_ = 0;  ///< the largest of all approximate points
  double surely_ = 0;            ///< filteredOrientation() has no larger bound for any three of them
};

/// Orientation of three rounded points relative to one origin, never 0.
MaybeSign filteredOrientation(const ApproximatePoint& a, const ApproximatePoint& b, const ApproximatePoint& c,
                              double slack);

}  // namespace footfall::detail
