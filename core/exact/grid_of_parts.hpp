// The grid of what one point is made of.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <cstdlib>
#include <initializer_list>
#include <optional>

#include "core/exact/fixed_integer.hpp"
#include "core/exact/grid.hpp"
#include "core/exact/plan_kernel.hpp"
#include "core/exact/plan_predicates.hpp"

namespace footfall::detail {

/// Collects what a point is made of. The coordinates of a few vertices have far fewer bits than those of a whole
/// environment, and a place, which is a quotient, is the same on either grid.
class GridOfParts {
 public:
  explicit GridOfParts(const PlanKernel& kernel) : kernel_(kernel), mesh_(kernel.mesh()) {}
  GridOfParts(const PlanKernel& kernel, Index origin, std::initializer_list<const PlanPoint*> points)
      : GridOfParts(kernel) {
    addVertex(origin);
    for (const PlanPoint* point : points) addPoint(*point);
  }

  void addPlanPlace(Index vertex) {
    grid_.include(mesh_.vertices[vertex].x);
    grid_.include(mesh_.vertices[vertex].y);
  }
  void addVertex(Index vertex) {
    addPlanPlace(vertex);
    grid_.include(mesh_.vertices[vertex].z);
  }
  void addTriangle(Index triangle) {
    for (const Index corner : mesh_.triangles[triangle]) addVertex(corner);
  }
  void addPoint(const PlanPoint& point) {
    if (point.kind() == PlanPoint::Source) {
      addPlanPlace(point.planId());
    } else if (point.kind() == PlanPoint::EdgePlane) {
      addVertex(point.edgeBegin());
      addVertex(point.edgeEnd());
      addTriangle(point.triangle());
      addLevel(point.level());
    } else {
      addLine(point.firstLine(), point.face());
      addLine(point.secondLine(), point.face());
    }
  }
  /// A context of the parts alone. `whole` is the grid of everything.
  template <class Integer>
  [[nodiscard]] GridContext<Integer> context(const Grid& whole, Index origin) const {
    const int width = grid_.width();
    return {mesh_,
            kernel_.heights(),
            kernel_.borders(),
            grid_.empty() ? whole.low : grid_.low,
            width <= kNarrowGrid,
            width <= kSmallGrid,
            origin,
            {}};
  }
  /// A place on the grid of the parts as one on the whole grid, where x and y are as many times larger.
  [[nodiscard]] Homogeneous<mpz_class> onWhole(const Homogeneous<FixedInteger>& place, const Grid& whole) const {
    Homogeneous<mpz_class> result;
    for (std::size_t k = 0; k < 3; ++k) {
      const IntegerView view = place[k];
      mpz_t borrowed;
      result[k] = mpz_class(mpz_roinit_n(borrowed, view.limbs, view.size));
      if (k < 2 && !grid_.empty()) result[k] <<= static_cast<mp_bitcnt_t>(grid_.low - whole.low);
    }
    return result;
  }
  /// The sign of what `evaluate` computes from the parts; empty where their own grid is too wide as well.
  template <class Evaluate>
  [[nodiscard]] std::optional<int> sign(const Grid& whole, Index origin, const Evaluate& evaluate) const {
    if (grid_.width() > kWidestFixedGrid) return std::nullopt;
    return sgn(evaluate(context<FixedInteger>(whole, origin)));
  }
  /// The bits of places on a grid, which are fewer than those of a decision (fixed_integer.hpp): 11 D + 12.
  [[nodiscard]] bool hasFixedPlaces() const {
    return 11 * (grid_.width() + 1) + 12 <= 64 * (FixedInteger::kCapacity - 2);
  }

 private:
  void addLevel(Index level) {
    if (level != 0) grid_.include(kernel_.heights()[std::abs(level) - 1]);
  }
  void addLine(const PlanLine& line, Index face) {
    if (line.kind == PlanLine::Edge) {
      addPlanPlace(line.a);
      addPlanPlace(line.b);
    } else if (line.kind == PlanLine::Border) {
      grid_.include(kernel_.borderCoordinate(line));
    } else {
      addTriangle(line.a);
      addTriangle(face);
      addLevel(line.b);
    }
  }

  const PlanKernel& kernel_;
  const SourceMesh& mesh_;
  Grid grid_;
};

}  // namespace footfall::detail
