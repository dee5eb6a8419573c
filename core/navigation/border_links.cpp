// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/border_links.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/disjoint_sets.hpp"

namespace footfall {

double BorderLink::size() const { return std::max({gap, std::fabs(rise), kind == LinkKind::Obstacle ? obstacle : 0}); }

namespace detail {
namespace {

constexpr double kClearlyLess = 1 - 1e-9;  // smaller improvements are no reason to leave the middle
constexpr double kTiny = 1e-12;            // times the largest coordinate: far above what rounding adds to lengths

double along(double a, double b, double s) { return s <= 0 ? a : s >= 1 ? b : a + s * (b - a); }
Vec3 pointAt(const SurfaceBorder& e, double s) {
  return {along(e.from.x, e.to.x, s), along(e.from.y, e.to.y, s), along(e.from.z, e.to.z, s)};
}

/// The place of the border nearest to a place in the plan.
double nearestIn(const SurfaceBorder& e, const Vec3& p) {
  const double ux = e.to.x - e.from.x, uy = e.to.y - e.from.y, square = ux * ux + uy * uy;
  const double s = ((p.x - e.from.x) * ux + (p.y - e.from.y) * uy) / square;
  return square > 0 ? std::clamp(s, 0.0, 1.0) : 0;
}

/// The best place so far between two borders.
class Choice {
 public:
  Choice(const SurfaceBorder& a, const SurfaceBorder& b, double step) : a_(a), b_(b), step_(step) {
    for (const Vec3& p : {a.from, a.to, b.from, b.to})
      tiny_ = std::max({tiny_, kTiny * std::fabs(p.x), kTiny * std::fabs(p.y), kTiny * std::fabs(p.z)});
  }

  void tryAt(double s, bool isInterval) {
    take(pointAt(a_, s), pointAt(b_, nearestIn(b_, pointAt(a_, s))), isInterval);
  }
  void tryEnd(const Vec3& end) { take(pointAt(a_, nearestIn(a_, end)), end, false); }
  void take(const Vec3& p, const Vec3& q, bool isInterval) {
    BorderLink link;
    link.from = p;
    link.to = q;
    link.gap = std::hypot(q.x - p.x, q.y - p.y);
    link.rise = q.z - p.z;
    link.isInterval = isInterval;
    if (!best_ || (lackAt(*best_) > tiny_ && lackAt(link) < kClearlyLess * lackAt(*best_))) best_ = link;
  }
  /// The part of a link that the agent's step does not overcome.
  [[nodiscard]] double lackAt(const BorderLink& link) const { return excessOf(link, 0, step_); }
  [[nodiscard]] const std::optional<BorderLink>& best() const { return best_; }
  /// Lengths up to this are none.
  [[nodiscard]] double tiny() const { return tiny_; }

 private:
  const SurfaceBorder &a_, &b_;
  double step_;
  double tiny_ = 0;
  std::optional<BorderLink> best_;
};

/// The stretch of `a` beside `b`: between the feet of b's ends.
std::array<double, 2> stretchBeside(const SurfaceBorder& a, const SurfaceBorder& b) {
  const double s = nearestIn(a, b.from), t = nearestIn(a, b.to);
  return {std::min(s, t), std::max(s, t)};
}

double heightOver(const SurfaceBorder& a, const SurfaceBorder& b, double s) {
  const Vec3 p = pointAt(a, s);
  return pointAt(b, nearestIn(b, p)).z - p.z;
}

}  // namespace

SurfaceParts findSurfaceParts(const NavigationMesh& mesh, const SurfaceTopology& topology) {
  constexpr std::uint32_t kNone = SurfaceTopology::kNone;
  const std::vector<std::uint32_t>& components = topology.components;
  DisjointSets sets(topology.componentCount);
  for (const StepLink& link : mesh.links) {
    const std::uint32_t from = components[link.fromTriangle], to = components[link.toTriangle];
    if (from != kNone && to != kNone) sets.unite(static_cast<Index>(from), static_cast<Index>(to));
  }
  Index count = 0;
  const std::vector<Index> numbers = sets.numbers(count);
  SurfaceParts parts;
  parts.count = static_cast<std::uint32_t>(count);
  parts.of.reserve(components.size());
  for (const std::uint32_t component : components)
    parts.of.push_back(component == kNone ? kNone : static_cast<std::uint32_t>(numbers[component]));
  return parts;
}

std::vector<SurfaceBorder> findBorders(const NavigationMesh& mesh, const SurfaceTopology& topology,
                                       const SurfaceParts& parts) {
  // A joined side has a neighbour in the mesh with the same two vertices, a step one with others.
  const auto isJoined = [&](const Triangle& f, std::size_t k, std::uint32_t neighbour) {
    if (neighbour >= mesh.triangles.size()) return false;  // none, or a bridge over a gap
    const Triangle& other = mesh.triangles[neighbour];
    return std::ranges::count(other, f[k]) + std::ranges::count(other, f[(k + 1) % 3]) == 2;
  };
  std::vector<SurfaceBorder> borders;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (topology.components[t] == SurfaceTopology::kNone) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle& f = mesh.triangles[t];
      if (isJoined(f, k, topology.neighbours[t][k])) continue;
      borders.push_back({mesh.vertices[f[k]], mesh.vertices[f[(k + 1) % 3]], t, parts.of[t]});
    }
  }
  return borders;
}

Vec3 nearestPoint(const SurfaceBorder& border, const Vec3& place) { return pointAt(border, nearestIn(border, place)); }

std::optional<Vec3> besideOn(const SurfaceBorder& border, const Vec3& place, double step) {
  const double length = std::hypot(border.to.x - border.from.x, border.to.y - border.from.y);
  const double s = nearestIn(border, place), t = std::clamp(s + step / length, 0.0, 1.0);
  if (s == t) return std::nullopt;
  return pointAt(border, t);
}

BorderLink reversed(const BorderLink& link) {
  BorderLink other = link;
  std::swap(other.from, other.to);
  std::swap(other.fromComponent, other.toComponent);
  other.rise = -link.rise;
  return other;
}

double excessOf(const BorderLink& link, double height, double step, double gap) {
  const double climbed = std::max(std::fabs(link.rise), link.kind == LinkKind::Obstacle ? link.obstacle : 0);
  double excess = std::max({link.gap - gap, climbed - step, 0.0});
  if (link.kind == LinkKind::LowCeiling) excess = std::max(excess, height - link.headroom);
  return excess;
}

std::optional<BorderLink> linkBetween(const SurfaceBorder& a, const SurfaceBorder& b, double step) {
  const double ax = a.to.x - a.from.x, ay = a.to.y - a.from.y, bx = b.to.x - b.from.x, by = b.to.y - b.from.y;
  Choice choice(a, b, step);
  if (a.from == b.to && a.to == b.from) {  // both sides of one edge: without rounding
    const Vec3 middle = pointAt(a, 0.5);
    choice.take(middle, middle, true);
  } else {
    const auto [s0, s1] = stretchBeside(a, b);
    const bool isFacing = s1 > s0 && ax * bx + ay * by < 0;
    if (isFacing) {
      choice.tryAt((s0 + s1) / 2, true);
      const double h0 = heightOver(a, b, s0), h1 = heightOver(a, b, s1);
      if (h0 * h1 < 0) choice.tryAt(s0 + (s1 - s0) * (h0 / (h0 - h1)), true);
    }
    choice.tryAt(0, false);
    choice.tryAt(1, false);
    choice.tryEnd(b.from);
    choice.tryEnd(b.to);
    const double area = ax * by - ay * bx;
    const double cx = b.from.x - a.from.x, cy = b.from.y - a.from.y;
    const double s = (cx * by - cy * bx) / area, t = (cx * ay - cy * ax) / area;
    if (area != 0 && s > 0 && s < 1 && t > 0 && t < 1) choice.take(pointAt(a, s), pointAt(b, t), false);
    // A bridge's border right over another one's: both walkable sides are on the same side, and no step leads there.
    const Vec3 middle = pointAt(a, (s0 + s1) / 2), over = pointAt(b, nearestIn(b, middle));
    const bool isSameSide = s1 > s0 && ax * bx + ay * by > 0;
    if (isSameSide && std::hypot(over.x - middle.x, over.y - middle.y) <= choice.tiny()) return std::nullopt;
  }
  BorderLink link = *choice.best();
  if (!link.isInterval && choice.lackAt(link) <= choice.tiny()) link.kind = LinkKind::Touch;
  link.fromComponent = a.component;
  link.toComponent = b.component;
  return link;
}

}  // namespace detail
}  // namespace footfall
