// The walkable area as RadiusFilter measures on it: places in the plan, and where its border goes on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/base/poll.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Scaled (SourceMesh::scaled).
struct PlanVector {
  double x = 0, y = 0;
};
inline PlanVector operator+(const PlanVector& a, const PlanVector& b) { return {a.x + b.x, a.y + b.y}; }
inline PlanVector operator-(const PlanVector& a, const PlanVector& b) { return {a.x - b.x, a.y - b.y}; }
inline PlanVector operator*(double f, const PlanVector& a) { return {f * a.x, f * a.y}; }
inline double dot(const PlanVector& a, const PlanVector& b) { return a.x * b.x + a.y * b.y; }
inline double cross(const PlanVector& a, const PlanVector& b) { return a.x * b.y - a.y * b.x; }
inline PlanVector leftOf(const PlanVector& d) { return {-d.y, d.x}; }
inline double length(const PlanVector& a) { return std::sqrt(dot(a, a)); }
inline PlanVector unitOf(const PlanVector& d) { return (1 / length(d)) * d; }

/// A number that grows with the angle from `base` to `direction`, counter-clockwise: a quarter of a turn is 1. In
/// (-2, 2]. Made of the four operations only, so it is the same on every machine.
double turnFrom(const PlanVector& base, const PlanVector& direction);

/// Sides are numbered as by TriangleCorners.
class MarginSurface {
 public:
  /// Doubles at the largest coordinate are so far apart; scaled. All places of margins are multiples of it.
  static constexpr double kUnit = 0x1p-17;
  static constexpr double kShort = 256 * kUnit;  ///< shorter edges have no direction
  static constexpr double kSlack = 32 * kUnit;
  static constexpr double kTouch = 0x1p-30;  ///< share of turns: triangles that touch are reached

  MarginSurface(const WalkableState& state, RunContext& context);

  /// The sides that can be entered by leaving a triangle over `side`: of the same edge, or of linked ones.
  [[nodiscard]] std::span<const Index> beyond(Index side) const {
    return {beyond_.data() + first_[side], static_cast<std::size_t>(first_[side + 1] - first_[side])};
  }
  [[nodiscard]] bool isBorder(Index side) const { return first_[side] == first_[side + 1]; }
  /// Whether a link leads over this side, not only its own edge.
  [[nodiscard]] bool hasLink(Index side) const {
    for (const Index other : beyond(side))
      if (beginVertex(other) != endVertex(side)) return true;
    return false;
  }
  [[nodiscard]] PlanVector begin(Index side) const { return places_[corners_.beginOf(side)]; }
  [[nodiscard]] PlanVector end(Index side) const { return begin(nextSide(side)); }
  [[nodiscard]] Index beginVertex(Index side) const { return corners_.beginOf(side); }
  [[nodiscard]] Index endVertex(Index side) const { return corners_.endOf(side); }
  [[nodiscard]] Index face(Index side) const { return mesh_.triangles[side / 3].face; }
  /// The error of the place of a vertex.
  [[nodiscard]] double error(Index vertex) const { return errors_[vertex]; }
  [[nodiscard]] Index sideCount() const { return corners_.size() * 3; }

  static Index nextSide(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static Index previousSide(Index side) { return side % 3 == 0 ? side + 2 : side - 1; }

  /// The sides that begin where `border` ends, around that place up to the next border, which is the last of them; the
  /// next triangle is beyond each side except the last. Returns whether there are several ways on, because floors
  /// overlap; the fan then has the sides on all of them, and its last one has no meaning.
  bool fanBehind(Index border, std::vector<Index>& fan) const;

 private:
  void addAllWays(std::vector<Index>& fan) const;

  const WalkableMesh& mesh_;
  TriangleCorners corners_;
  Poll poll_;
  std::vector<PlanVector> places_;
  std::vector<double> errors_;
  std::vector<Index> first_, beyond_;
};

}  // namespace footfall::detail
