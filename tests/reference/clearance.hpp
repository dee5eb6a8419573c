// The distance of a place of a navigation mesh from its border, found by searching in all directions: slow and obvious.
// It is exact with rational numbers; with doubles it serves large meshes.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "core/mesh/surface_topology.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::reference {

/// Squared distances to the first border in each direction. `Number` is mpq_class or double.
template <class Number>
class SeenBorder {
 public:
  /// `bridged` has its gaps as faces.
  SeenBorder(const NavigationMesh& bridged, const detail::SurfaceTopology& topology)
      : mesh_(bridged), topology_(topology) {}

  struct Place {
    Number x, y;
  };
  /// The place with these weights of the first and the second corner; all three weights are above 0.
  [[nodiscard]] Place inside(std::uint32_t face, const Number& u, const Number& v) const {
    const Place a = corner(face, 0), b = corner(face, 1), c = corner(face, 2);
    return {Number(c.x + u * (a.x - c.x) + v * (b.x - c.x)), Number(c.y + u * (a.y - c.y) + v * (b.y - c.y))};
  }
  /// Starts from a place inside of a face.
  std::optional<Number> squaredDistance(std::uint32_t face, const Place& p) {
    place_ = p;
    best_.reset();
    for (int i = 0; i < 3; ++i) takeCorner(face, i);
    for (int side = 0; side < 3; ++side)
      look(face, side, minus(corner(face, side + 1), p), minus(corner(face, side), p));
    return best_;
  }

 private:
  static Place minus(const Place& a, const Place& b) { return {Number(a.x - b.x), Number(a.y - b.y)}; }
  static Number turn(const Place& a, const Place& b) { return a.x * b.y - a.y * b.x; }
  static Number product(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y; }
  [[nodiscard]] Place corner(std::uint32_t face, int i) const {
    const Vec3& v = mesh_.vertices[mesh_.triangles[face][i % 3]];
    return {Number(v.x), Number(v.y)};
  }
  void takeCorner(std::uint32_t face, int i) {
    const Place p = minus(corner(face, i), place_);
    if (topology_.isOpen[topology_.fans[face][i]] != 0) take(product(p, p));
  }
  void take(const Number& squared) {
    if (!best_ || squared < *best_) best_ = squared;
  }
  /// The least squared length of the vectors from a to b.
  static Number nearest(const Place& a, const Place& b) {
    const Place way = minus(b, a);
    const Number length = product(way, way);
    if (length == 0) return product(a, a);
    const Number along = -product(a, way);
    if (along <= 0) return product(a, a);
    if (along >= length) return product(b, b);
    const Number aside = turn(a, way);
    return aside * aside / length;
  }
  /// The place where a direction meets the line from a to b.
  static Place meet(const Place& direction, const Place& a, const Place& b) {
    const Place way = minus(b, a);
    const Number t = turn(direction, a) / turn(way, direction);
    return {Number(a.x + t * way.x), Number(a.y + t * way.y)};
  }
  /// Looks out of a side of a face, between two directions that meet the side.
  void look(std::uint32_t face, int side, const Place& left, const Place& right) {
    const Place a = minus(corner(face, side), place_), b = minus(corner(face, side + 1), place_);
    if (turn(right, left) <= 0) return;
    Place seenRight = a, seenLeft = b;
    if (turn(a, right) > 0) seenRight = meet(right, a, b);
    if (turn(left, b) > 0) seenLeft = meet(left, a, b);
    const Number least = nearest(seenRight, seenLeft);
    if (best_ && least >= *best_) return;
    const std::uint32_t other = topology_.neighbours[face][side];
    if (other == detail::SurfaceTopology::kNone) {
      take(least);
      return;
    }
    const int behind = topology_.sideBehind(face, side);
    const Place tip = minus(corner(other, behind + 2), place_);
    const Number toLeft = turn(tip, left), toRight = turn(right, tip);
    if (toLeft >= 0 && toRight >= 0) takeCorner(other, (behind + 2) % 3);
    if (toRight > 0) look(other, (behind + 1) % 3, toLeft > 0 ? tip : left, right);
    if (toLeft > 0) look(other, (behind + 2) % 3, left, toRight > 0 ? tip : right);
  }

  const NavigationMesh& mesh_;
  const detail::SurfaceTopology& topology_;
  Place place_;
  std::optional<Number> best_;
};

}  // namespace footfall::reference
