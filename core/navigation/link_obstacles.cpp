// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/link_obstacles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/infinity.hpp"

namespace footfall::detail {
namespace {

constexpr double kReach =
    1e-4;  // share of the agent's height by which the way extends beyond both borders, as walls stand there
constexpr double kBeside = 1e-5;   // share of the agent's height on either side of the way
constexpr double kClearly = 1e-3;  // the sine of an angle
constexpr double kMargin = 1e-3;   // share of the agent's height: lower obstacles are the floor itself, where it slopes

/// The heights between which something lies.
struct Span {
  double low = kInfinity, high = -kInfinity;
  void add(double z) {
    low = std::min(low, z);
    high = std::max(high, z);
  }
};

}  // namespace

/// A vertical rectangle without an upper end: from `origin` along a unit vector of the plan.
struct LinkObstacles::Way {
  Vec3 origin;
  double ux, uy;
  double first, last;

  [[nodiscard]] std::array<double, 2> inFrame(const Vec3& p) const {
    const double x = p.x - origin.x, y = p.y - origin.y;
    return {x * ux + y * uy, y * ux - x * uy};
  }

  /// The part of a triangle in it.
  [[nodiscard]] Span spanOf(const std::array<Vec3, 3>& f) const {
    // The triangle meets the rectangle's plane in a segment.
    std::array<std::array<double, 2>, 2> ends{};  // along the way, and height
    std::size_t count = 0;
    std::array<std::array<double, 2>, 3> at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = inFrame(f[k]);
    for (std::size_t k = 0; k < 3 && count < 2; ++k) {
      const std::size_t next = (k + 1) % 3;
      const double a = at[k][1], b = at[next][1];
      if ((a < 0) == (b < 0)) continue;
      const double s = a / (a - b);
      ends[count++] = {at[k][0] + s * (at[next][0] - at[k][0]), f[k].z + s * (f[next].z - f[k].z)};
    }
    Span span;
    if (count < 2) return span;
    if (ends[0][0] > ends[1][0]) std::swap(ends[0], ends[1]);
    const double t0 = ends[0][0], z0 = ends[0][1], t1 = ends[1][0], z1 = ends[1][1];
    if (t1 < first || t0 > last) return span;
    const auto heightAt = [&](double t) { return t1 > t0 ? z0 + (t - t0) / (t1 - t0) * (z1 - z0) : z0; };
    span.add(heightAt(std::max(t0, first)));
    span.add(t1 > t0 ? heightAt(std::min(t1, last)) : z1);
    return span;
  }
};

namespace {

using Way = LinkObstacles::Way;

/// A unit vector of the plan that leaves the walkable side.
std::array<double, 2> outwards(const SurfaceBorder& e) {
  const double length = std::hypot(e.to.x - e.from.x, e.to.y - e.from.y);
  return {(e.to.y - e.from.y) / length, (e.from.x - e.to.x) / length};
}

/// The way from a place on border `a` to one on border `b`; straight out of `a` if they are next to each other.
Way wayBetween(const SurfaceBorder& a, const Vec3& p, const Vec3& q, double reach) {
  const double gap = std::hypot(q.x - p.x, q.y - p.y);
  if (gap > reach) return {p, (q.x - p.x) / gap, (q.y - p.y) / gap, -reach, gap + reach};
  const auto [x, y] = outwards(a);
  return {p, x, y, -reach, gap + reach};
}

/// True when a way leaves the walkable side at `a` and enters that at `b`, and not only along them.
bool isCrossing(const Way& way, const SurfaceBorder& a, const SurfaceBorder& b) {
  const auto m = outwards(a), n = outwards(b);
  return way.ux * m[0] + way.uy * m[1] > kClearly && way.ux * n[0] + way.uy * n[1] < -kClearly;
}

Box boxOf(const Way& way, double low, double high) {
  const auto [x0, x1] = std::minmax({way.origin.x + way.first * way.ux, way.origin.x + way.last * way.ux});
  const auto [y0, y1] = std::minmax({way.origin.y + way.first * way.uy, way.origin.y + way.last * way.uy});
  return {{x0, y0, low}, {x1, y1, high}};
}

}  // namespace

struct LinkObstacles::Sight {
  BorderLink link;
  Way way;
  bool isCrossed = false;
};

LinkObstacles::LinkObstacles(std::shared_ptr<const Environment> environment, double height, double step, Poll poll)
    : environment_(std::move(environment)), height_(height), step_(step) {
  std::vector<Box> boxes;
  std::vector<std::int32_t> ids;
  boxes.reserve(environment_->triangles.size());
  ids.reserve(environment_->triangles.size());
  for (const Triangle& t : environment_->triangles) {
    const Vec3 &p = environment_->vertices[t[0]], &q = environment_->vertices[t[1]], &r = environment_->vertices[t[2]];
    boxes.push_back({{std::min({p.x, q.x, r.x}), std::min({p.y, q.y, r.y}), std::min({p.z, q.z, r.z})},
                     {std::max({p.x, q.x, r.x}), std::max({p.y, q.y, r.y}), std::max({p.z, q.z, r.z})}});
    ids.push_back(static_cast<std::int32_t>(ids.size()));
  }
  if (!boxes.empty()) tree_.build(boxes, ids, poll);
}

std::optional<LinkObstacles::Sight> LinkObstacles::look(const BorderLink& link, const SurfaceBorder& a,
                                                        const SurfaceBorder& b,
                                                        std::vector<std::int32_t>& stack) const {
  const double beside = kBeside * height_;
  std::optional<Sight> best;
  const auto rank = [](const BorderLink& seen) { return std::pair(seen.isBlocked(), seen.size()); };
  const auto lookAlong = [&](const Vec3& p, const Vec3& q) {
    const Way way = wayBetween(a, p, q, kReach * height_);
    const bool crosses = isCrossing(way, a, b);
    if (best && best->isCrossed && !crosses) return;
    BorderLink seen = seeAlong(way, link, stack);
    if (!best || (crosses && !best->isCrossed) || rank(seen) < rank(best->link))
      best.emplace(Sight{std::move(seen), way, crosses});
  };
  // The end of a wall touches the way on one side only, and the seam of two walls on both.
  for (const double step : {-beside, beside}) {
    if (const auto p = besideOn(a, link.from, step)) lookAlong(*p, nearestPoint(b, *p));
    if (const auto q = besideOn(b, link.to, step)) lookAlong(nearestPoint(a, *q), *q);
  }
  return best;
}

bool LinkObstacles::lookAt(BorderLink& link, const SurfaceBorder& a, const SurfaceBorder& b,
                           std::vector<std::int32_t>& stack) const {
  const std::optional<Sight> sight = look(link, a, b, stack);
  if (sight && link.kind == LinkKind::Open) link = sight->link;
  return sight && sight->isCrossed;
}

/// The range between the higher border, or the obstacle that is stepped over, and the agent's head there.
std::array<double, 2> LinkObstacles::heightsInTheWay(const BorderLink& link) const {
  const double base = std::max(link.from.z, link.to.z), lower = std::min(link.from.z, link.to.z);
  return {std::max(base + kMargin * height_, lower + step_), base + height_ - kMargin * height_};
}

template <class Visit>
void LinkObstacles::visitAlong(const Way& way, double low, double high, std::vector<std::int32_t>& stack,
                               const Visit& visit) const {
  if (low >= high) return;
  tree_.visitOverlapping(boxOf(way, low, high), stack, [&](std::int32_t id) {
    const Triangle& t = environment_->triangles[id];
    const Span span =
        way.spanOf({environment_->vertices[t[0]], environment_->vertices[t[1]], environment_->vertices[t[2]]});
    if (span.low < high && span.high > low) visit(id, span);
    return true;
  });
}

BorderLink LinkObstacles::seeAlong(const Way& way, const BorderLink& link, std::vector<std::int32_t>& stack) const {
  const auto [floor, ceiling] = heightsInTheWay(link);
  Span inTheWay;
  visitAlong(way, floor, ceiling, stack, [&](std::int32_t, const Span& span) {
    inTheWay.add(span.low);
    inTheWay.add(span.high);
  });
  BorderLink seen = link;
  if (inTheWay.low > inTheWay.high) return seen;
  if (inTheWay.high < ceiling) {
    seen.kind = LinkKind::Obstacle;
    seen.obstacle = inTheWay.high - std::min(link.from.z, link.to.z);
  } else if (inTheWay.low > floor) {
    seen.kind = LinkKind::LowCeiling;
    seen.headroom = inTheWay.low - std::max(link.from.z, link.to.z);
  } else {
    seen.kind = LinkKind::Wall;
  }
  return seen;
}

void LinkObstacles::findTriangles(BorderLink& link, const SurfaceBorder& a, const SurfaceBorder& b,
                                  std::vector<std::int32_t>& stack) const {
  link.triangles.clear();
  BorderLink open = link;
  open.kind = LinkKind::Open;
  const std::optional<Sight> sight = look(open, a, b, stack);
  if (!sight) return;
  const auto take = [&](std::int32_t id, const Span&) { link.triangles.push_back(static_cast<std::uint32_t>(id)); };
  const auto [floor, ceiling] = heightsInTheWay(link);
  visitAlong(sight->way, floor, ceiling, stack, take);
  // The riser of a step, between both floors.
  const auto [low, high] = std::minmax(link.from.z, link.to.z);
  const double margin = kMargin * height_;
  if (high - low > 2 * margin) visitAlong(sight->way, low + margin, high - margin, stack, take);
  std::ranges::sort(link.triangles);
  link.triangles.erase(std::unique(link.triangles.begin(), link.triangles.end()), link.triangles.end());
}

}  // namespace footfall::detail
