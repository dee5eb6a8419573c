// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/border_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace footfall::reference {
namespace {

using Place = std::array<double, 2>;

double orientation(const Place& a, const Place& b, const Place& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// The very ends of a border are excluded: where a border meets a step, agents walk over the step beside the corner.
Place nearestOn(const Place& a, const Place& b, const BorderStretch& part, double x, double y) {
  constexpr double kEnd = 1e-8;
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  const double t = std::clamp(((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy), std::max(part.begin, kEnd),
                              std::max({part.begin, kEnd, std::min(part.end, 1 - kEnd)}));
  return {a[0] + t * dx, a[1] + t * dy};
}

}  // namespace

BorderDistance::BorderDistance(const NavigationMesh& mesh) : mesh_(mesh), beyond_(mesh.triangles.size()) {
  std::map<std::array<std::uint32_t, 2>, std::vector<Border>> sides;  // keyed by their ends
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) sides[{mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]}].push_back({t, k, {}});
  for (const auto& [ends, own] : sides) {
    const auto other = sides.find({ends[1], ends[0]});
    if (other == sides.end()) continue;
    for (const Border& side : own)
      for (const Border& there : other->second) beyond_[side.triangle][side.side].push_back(there.triangle);
  }
  for (const StepLink& link : mesh.links) {
    for (const Border& side : sides[link.from])
      if (side.triangle == link.fromTriangle) beyond_[side.triangle][side.side].push_back(link.toTriangle);
    for (const Border& side : sides[link.to])
      if (side.triangle == link.toTriangle) beyond_[side.triangle][side.side].push_back(link.fromTriangle);
  }
  for (const auto& [ends, own] : sides)
    for (const Border& side : own)
      if (beyond_[side.triangle][side.side].empty()) borders_.push_back({side.triangle, side.side, {}});
  makeGrid();
}

Place BorderDistance::corner(std::uint32_t triangle, int k) const {
  const Vec3& v = mesh_.vertices[mesh_.triangles[triangle][k % 3]];
  return {v.x, v.y};
}

int BorderDistance::cell(double value, int axis) const {
  const double share = (value - lower_[axis]) / std::max(upper_[axis] - lower_[axis], 1e-300);
  return static_cast<int>(std::clamp(share * cells_, 0.0, cells_ - 1.0));
}

void BorderDistance::makeGrid() {
  lower_.fill(std::numeric_limits<double>::infinity());
  upper_.fill(-std::numeric_limits<double>::infinity());
  for (const Vec3& v : mesh_.vertices)
    for (int k = 0; k < 2; ++k) {
      lower_[k] = std::min(lower_[k], k == 0 ? v.x : v.y);
      upper_[k] = std::max(upper_[k], k == 0 ? v.x : v.y);
    }
  constexpr double kMostCells = 128;
  cells_ = static_cast<int>(std::clamp(2 * std::sqrt(mesh_.triangles.size()), 1.0, kMostCells));
  trianglesIn_.resize(cells_ * cells_);
  bordersIn_.resize(cells_ * cells_);
  const auto add = [&](auto& cells, std::uint32_t id, std::initializer_list<Place> places) {
    const auto [x0, x1] = std::minmax({(*places.begin())[0], (*(places.end() - 1))[0], (*(places.begin() + 1))[0]});
    const auto [y0, y1] = std::minmax({(*places.begin())[1], (*(places.end() - 1))[1], (*(places.begin() + 1))[1]});
    const int lastX = cell(x1, 0), firstY = cell(y0, 1), lastY = cell(y1, 1);
    for (int i = cell(x0, 0); i <= lastX; ++i)
      for (int j = firstY; j <= lastY; ++j) cells[i * cells_ + j].push_back(id);
  };
  for (auto* cells : {&trianglesIn_, &bordersIn_})
    for (auto& cell : *cells) cell.clear();
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    add(trianglesIn_, t, {corner(t, 0), corner(t, 1), corner(t, 2)});
  for (std::uint32_t b = 0; b < borders_.size(); ++b)
    add(bordersIn_, b,
        {corner(borders_[b].triangle, borders_[b].side), corner(borders_[b].triangle, borders_[b].side + 1)});
}

double BorderDistance::height(const SurfacePlace& place) const {
  const auto& t = mesh_.triangles[place.triangle];
  const Vec3 &a = mesh_.vertices[t[0]], &b = mesh_.vertices[t[1]], &c = mesh_.vertices[t[2]];
  const double whole = orientation({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
  const double u = orientation({a.x, a.y}, {place.x, place.y}, {c.x, c.y}) / whole;
  const double v = orientation({a.x, a.y}, {b.x, b.y}, {place.x, place.y}) / whole;
  return a.z + u * (b.z - a.z) + v * (c.z - a.z);
}

double BorderDistance::heightOn(const Border& border, double x, double y) const {
  const auto& t = mesh_.triangles[border.triangle];
  const Vec3 &a = mesh_.vertices[t[border.side]], &b = mesh_.vertices[t[(border.side + 1) % 3]];
  return a.z + std::hypot(x - a.x, y - a.y) / std::hypot(b.x - a.x, b.y - a.y) * (b.z - a.z);
}

bool BorderDistance::isNeedle(std::uint32_t triangle) const {
  const Place a = corner(triangle, 0), b = corner(triangle, 1), c = corner(triangle, 2);
  const double longest = std::max({std::hypot(b[0] - a[0], b[1] - a[1]), std::hypot(c[0] - b[0], c[1] - b[1]),
                                   std::hypot(a[0] - c[0], a[1] - c[1])});
  return longest < 1e-9 || orientation(a, b, c) < 1e-6 * longest * longest;
}

// Doubles place everything on its line inside a triangle that is not wide.
bool BorderDistance::isWide(std::uint32_t triangle) const {
  const Place a = corner(triangle, 0), b = corner(triangle, 1), c = corner(triangle, 2);
  const double around = std::hypot(b[0] - a[0], b[1] - a[1]) + std::hypot(c[0] - b[0], c[1] - b[1]);
  return orientation(a, b, c) > 1e-11 * around;
}

std::optional<std::uint32_t> BorderDistance::find(double x, double y, double z, double most) const {
  std::optional<std::uint32_t> found;
  if (mesh_.triangles.empty()) return found;
  for (const std::uint32_t t : trianglesIn_[cell(x, 0) * cells_ + cell(y, 1)]) {
    bool isInside = isWide(t);
    for (int k = 0; k < 3; ++k) {
      const Place a = corner(t, k), b = corner(t, k + 1);
      // Roundings may take a place on an edge out of both triangles.
      const double hair = 1e-15 * std::hypot(b[0] - a[0], b[1] - a[1]) * (std::fabs(x) + std::fabs(y));
      isInside = isInside && orientation(a, b, {x, y}) >= -hair;
    }
    if (!isInside) continue;
    const double apart = std::fabs(height({t, x, y}) - z);
    if (apart > most) continue;
    most = apart;
    found = t;
  }
  return found;
}

BorderDistance::Walk BorderDistance::walk(const SurfacePlace& from, double x, double y) const {
  const Place start{from.x, from.y}, target{x, y};
  const double whole = std::hypot(x - from.x, y - from.y);
  std::uint32_t t = from.triangle, before = t;
  double passed = 0;
  bool isDoubtful = isNeedle(t);
  for (std::size_t step = 0; step <= mesh_.triangles.size(); ++step) {
    // The edge where the line leaves the triangle, if that is before the target.
    int exit = -1;
    double share = 1;
    for (int k = 0; k < 3; ++k) {
      const Place a = corner(t, k), b = corner(t, k + 1);
      const double atEnd = orientation(a, b, target), atStart = orientation(a, b, start);
      if (atEnd >= 0) continue;
      const auto& next = beyond_[t][k];
      if (step > 0 && std::find(next.begin(), next.end(), before) != next.end()) continue;
      const double s = atStart <= 0 ? 0 : atStart / (atStart - atEnd);
      if (exit < 0 || s < share) {
        exit = k;
        share = s;
      }
    }
    if (exit < 0) return {{t, x, y}, whole, false, isDoubtful};
    passed = std::max(passed, share);
    if (beyond_[t][exit].empty())
      return {{t, from.x + passed * (x - from.x), from.y + passed * (y - from.y)}, passed * whole, true, isDoubtful};
    before = t;
    t = beyond_[t][exit].front();
    isDoubtful = isDoubtful || isNeedle(t);
  }
  return {{t, x, y}, whole, false, true};
}

void BorderDistance::divide(const Environment& environment, double step, double height, std::size_t floors) {
  std::vector<Border> divided;
  for (const Border& border : borders_) {
    if (border.triangle >= floors) {
      divided.push_back(border);
      continue;
    }
    const auto& t = mesh_.triangles[border.triangle];
    for (const BorderStretch& stretch : stretchesOf(environment, mesh_.vertices[t[border.side]],
                                                    mesh_.vertices[t[(border.side + 1) % 3]], step, height))
      divided.push_back({border.triangle, border.side, stretch});
  }
  borders_ = std::move(divided);
  makeGrid();
}

template <class Counts>
BorderDistance::Distance BorderDistance::leastOf(const SurfacePlace& from, double most, const Counts& counts) const {
  std::vector<std::uint32_t> near;
  const int lastX = cell(from.x + most, 0), firstY = cell(from.y - most, 1), lastY = cell(from.y + most, 1);
  for (int i = cell(from.x - most, 0); i <= lastX; ++i)
    for (int j = firstY; j <= lastY; ++j)
      near.insert(near.end(), bordersIn_[i * cells_ + j].begin(), bordersIn_[i * cells_ + j].end());
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  Distance distance;
  auto& [least, isDoubtful] = distance;
  for (const std::uint32_t i : near) {
    const Border& border = borders_[i];
    const Place q = nearestOn(corner(border.triangle, border.side), corner(border.triangle, border.side + 1),
                              border.stretch, from.x, from.y);
    const double direct = std::hypot(q[0] - from.x, q[1] - from.y);
    if (direct > most) continue;
    const Walk way = walk(from, q[0], q[1]);
    isDoubtful = isDoubtful || way.isDoubtful || isNeedle(border.triangle);
    const double apart = std::fabs(height(way.end) - heightOn(border, q[0], q[1]));
    const bool isThere = way.end.triangle == border.triangle || apart < 1e-6 * (1 + most);
    const bool isStoppedBefore = way.isStopped && (!isThere || way.length < direct - 1e-9 * (1 + most));
    if ((!isThere && !way.isStopped) || way.length > most || !counts(border, way, isStoppedBefore)) continue;
    if (!way.isDoubtful) least = least ? std::min(*least, way.length) : way.length;
  }
  return distance;
}

// A place beside a border's very end may be on another floor of nearly the same height.
BorderDistance::Distance BorderDistance::at(const SurfacePlace& from, double most, bool orDoubtful) const {
  return leastOf(from, most, [&](const Border& border, const Walk& way, bool) {
    return orDoubtful || way.isStopped || way.end.triangle == border.triangle;
  });
}

// The border that stops a walk is nearer, and counts as its own kind.
BorderDistance::Distance BorderDistance::at(const SurfacePlace& from, double most, BorderKind kind,
                                            bool orDoubtful) const {
  return leastOf(from, most, [&](const Border& border, const Walk& way, bool isStoppedBefore) {
    const BorderKind own = border.stretch.kind;
    if (!orDoubtful && way.end.triangle != border.triangle) return false;
    return !isStoppedBefore && (own == kind || (orDoubtful && own == BorderKind::Doubtful));
  });
}

}  // namespace footfall::reference
