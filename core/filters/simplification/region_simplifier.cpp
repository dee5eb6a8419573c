// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/simplification/region_simplifier.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/index_and_box.hpp"
#include "core/base/sorted_list.hpp"
#include "core/exact/shape.hpp"

namespace footfall::detail {
namespace {

using Place = std::array<double, 3>;

Place minus(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Place placeOf(const MeshVertex& v) { return {v.x, v.y, v.z}; }

double distanceToSegment(const Place& p, const Place& a, const Place& b) {
  const Place u = minus(b, a), w = minus(p, a);
  const double length = dot(u, u);
  const double s = length > 0 ? std::clamp(dot(w, u) / length, 0.0, 1.0) : 0;
  const Place d{w[0] - s * u[0], w[1] - s * u[1], w[2] - s * u[2]};
  return std::sqrt(dot(d, d));
}

double distanceToTriangle(const Place& p, const Place& a, const Place& b, const Place& c) {
  const Place u = minus(b, a), v = minus(c, a), w = minus(p, a);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const double determinant = uu * vv - uv * uv;
  if (determinant > 0) {
    const double s = (vv * wu - uv * wv) / determinant, t = (uu * wv - uv * wu) / determinant;
    if (s >= 0 && t >= 0 && s + t <= 1) {
      const Place d{w[0] - s * u[0] - t * v[0], w[1] - s * u[1] - t * v[1], w[2] - s * u[2] - t * v[2]};
      return std::sqrt(dot(d, d));
    }
  }
  return std::min({distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
}

}  // namespace

void RegionSimplifier::simplify(std::span<const Index> vertices, std::span<const Index> triangles) {
  // Taking away a vertex can leave its whole fan to its neighbour. Where a border keeps its vertices and the one across
  // does not, going on with that neighbour would carry a fan along that grows with each vertex. Later the fans that
  // come together are equally large, so that each triangle is in few of them.
  constexpr std::size_t kSmallFan = 256, kPolled = 4096;
  std::vector<Index> waiting(vertices.begin(), vertices.end()), large;
  std::size_t visited = kPolled;
  for (std::size_t most = kSmallFan; !waiting.empty(); most *= 2) {
    large.clear();
    for (const Index v : waiting) {
      if (visited >= kPolled) {
        poll_();
        visited = 0;
      }
      collectTriangles(v);
      if (at_.size() > most)
        large.push_back(v);
      else
        removeIfPossible(v);
      visited += 16 + at_.size();
    }
    waiting.swap(large);
  }
  improve(triangles);
}

int RegionSimplifier::cornerOf(Index triangle, Index vertex) const {
  const auto& c = mesh_.triangles[triangle].corners;
  return c[0] == vertex ? 0 : c[1] == vertex ? 1 : 2;
}

void RegionSimplifier::collectTriangles(Index v) {
  at_.clear();
  mesh_.around.visit(v, [&](Index t) { at_.push_back(t); });
}

// The groups, in the order of their smallest triangles.
void RegionSimplifier::collectFans(Index v) {
  fanCount_ = 0;
  std::sort(at_.begin(), at_.end());
  seen_.assign(at_.size(), 0);
  for (std::size_t i = 0; i < at_.size(); ++i) {
    if (seen_[i] != 0) continue;
    if (fanCount_ == fans_.size()) fans_.emplace_back();
    Fan& fan = fans_[fanCount_++];
    collectFan(v, at_[i], fan);
    for (const Index t : fan.triangles) seen_[std::lower_bound(at_.begin(), at_.end(), t) - at_.begin()] = 1;
  }
}

void RegionSimplifier::collectFan(Index v, Index start, Fan& fan) const {
  fan.triangles.clear();
  fan.ring.clear();
  fan.beyond.clear();
  fan.flags.clear();
  fan.closed = false;
  // clockwise to the first triangle of the fan
  Index first = start;
  while (!fan.closed) {
    const Index side = mesh_.neighbors[3 * first + cornerOf(first, v)];
    if (side < 0) break;
    first = side / 3;
    fan.closed = first == start;
  }
  for (Index t = first;;) {
    const int i = cornerOf(t, v);
    const MeshTriangle& m = mesh_.triangles[t];
    fan.triangles.push_back(t);
    fan.ring.push_back(m.corners[next(i)]);
    fan.beyond.push_back(mesh_.neighbors[3 * t + next(i)]);
    fan.flags.push_back(m.obstacleEdges >> next(i) & 1);
    if (t == first) fan.firstFlag = m.obstacleEdges >> i & 1;
    const Index side = mesh_.neighbors[3 * t + previous(i)];
    if (side < 0) {
      fan.ring.push_back(m.corners[previous(i)]);
      fan.lastFlag = m.obstacleEdges >> previous(i) & 1;
      fan.beyond.push_back(-1);
      fan.flags.push_back(static_cast<std::uint8_t>(fan.firstFlag));
      break;
    }
    t = side / 3;
    if (t == first) break;
  }
}

// Exactly, vertices at outlines are only given when they are straight there, and stay so: what goes beside them lies on
// the same line.
bool RegionSimplifier::isStraight(Index u, Index v, Index w) const {
  return !approximate_.enabled || distanceToSegment(placeOf(mesh_.vertices[v]), placeOf(mesh_.vertices[u]),
                                                    placeOf(mesh_.vertices[w])) <= approximate_.bound;
}

void RegionSimplifier::removeIfPossible(Index v) {
  collectFans(v);
  if (fanCount_ == 0) return;
  const std::span<Fan> fans(fans_.data(), fanCount_);
  if (fans.size() > 1 || !fans[0].closed) {
    const Index u = fans[0].ring.front(), w = fans[0].ring.back();
    for (const Fan& fan : fans) {
      if (fan.closed) return;
      const Index a = fan.ring.front(), b = fan.ring.back();
      if (!((a == u && b == w) || (a == w && b == u)) || u == w) return;
      if (fan.firstFlag != fan.lastFlag) return;
    }
    if (!isStraight(u, v, w)) return;
  }
  if (!std::all_of(fans.begin(), fans.end(), [&](const Fan& fan) { return turnsOnce(v, fan); })) return;
  for (Fan& fan : fans)
    if (!(approximate_.enabled ? cutAnyEars(fan) : cutEars(v, fan))) return;
  std::vector<Index> stoodFor;
  if (approximate_.enabled && !isWithinBound(v, stoodFor)) return;
  for (Fan& fan : fans) {
    replace(fan);
    if (approximate_.enabled)
      for (std::size_t k = 0; k < fan.ears.size(); ++k) mesh_.standsFor[fan.triangles[k]] = stoodFor;
  }
}

// A fan on overlapping floors (before a clearance filter) can wind around its vertex more than once. The half-plane of
// the directions to its ring then changes more often than twice, or once for a straight open fan.
bool RegionSimplifier::turnsOnce(Index v, const Fan& fan) {
  const auto isUpper = [&](Index p) {
    const int y = geometry_.compare(p, v, 1);
    return y != 0 ? y > 0 : geometry_.compare(p, v, 0) > 0;
  };
  int changes = 0;
  bool last = isUpper(fan.closed ? fan.ring.back() : fan.ring.front());
  for (const Index p : fan.ring) {
    const bool upper = isUpper(p);
    changes += upper != last;
    last = upper;
  }
  return approximate_.enabled ? changes <= 2 : changes == (fan.closed ? 2 : 1);
}

void RegionSimplifier::linkRing(const Fan& fan) {
  const auto n = static_cast<Index>(fan.ring.size());
  ringNext_.resize(n);
  ringPrevious_.resize(n);
  for (Index i = 0; i < n; ++i) {
    ringNext_[i] = i + 1 == n ? 0 : i + 1;
    ringPrevious_[i] = i == 0 ? n - 1 : i - 1;
  }
}

void RegionSimplifier::unlink(Index place) {
  ringNext_[ringPrevious_[place]] = ringNext_[place];
  ringPrevious_[ringNext_[place]] = ringPrevious_[place];
}

// An ear of the star-shaped ring does not hold another corner of it when the vertex is not strictly inside.
bool RegionSimplifier::cutEars(Index v, Fan& fan) {
  fan.ears.clear();
  linkRing(fan);
  Index i = 0;
  std::size_t left = fan.ring.size(), misses = 0;
  while (left > 3) {
    const Index before = ringPrevious_[i], after = ringNext_[i];
    const Index a = fan.ring[before], b = fan.ring[i], c = fan.ring[after];
    if (geometry_.orientation(a, b, c) > 0 && geometry_.orientation(a, c, v) >= 0) {
      fan.ears.push_back({before, i, after});
      unlink(i);
      --left;
      i = before;
      misses = 0;
    } else {
      i = after;
      if (++misses > left) return false;
    }
  }
  const Index lowest = std::min({i, ringNext_[i], ringPrevious_[i]});
  fan.ears.push_back({lowest, ringNext_[lowest], ringPrevious_[lowest]});
  return true;
}

// Any simple ring: an ear must not hold another corner of it.
bool RegionSimplifier::cutAnyEars(Fan& fan) {
  fan.ears.clear();
  linkRing(fan);
  Index i = 0;
  std::size_t left = fan.ring.size(), misses = 0;
  while (left >= 3) {
    const Index before = ringPrevious_[i], after = ringNext_[i];
    const Index a = fan.ring[before], b = fan.ring[i], c = fan.ring[after];
    bool ear = geometry_.orientation(a, b, c) > 0;
    for (Index j = ringNext_[after]; j != before && ear; j = ringNext_[j]) {
      const Index p = fan.ring[j];
      if (p == a || p == b || p == c) continue;
      ear = geometry_.orientation(a, b, p) < 0 || geometry_.orientation(b, c, p) < 0 ||
            geometry_.orientation(c, a, p) < 0;
    }
    if (!ear) {
      if (++misses > left) return false;
      i = after;
      continue;
    }
    fan.ears.push_back({before, i, after});
    unlink(i);
    --left;
    i = before;
    misses = 0;
  }
  return !fan.ears.empty();
}

bool RegionSimplifier::isWithinBound(Index v, std::vector<Index>& stoodFor) {
  const std::span<const Fan> fans(fans_.data(), fanCount_);
  stoodFor.assign(1, v);
  for (const Fan& fan : fans)
    for (const Index t : fan.triangles)
      stoodFor.insert(stoodFor.end(), mesh_.standsFor[t].begin(), mesh_.standsFor[t].end());
  sortOnce(stoodFor);
  return std::all_of(stoodFor.begin(), stoodFor.end(), [&](Index p) {
    for (const Fan& fan : fans) {
      const auto corner = [&](Index place) { return placeOf(mesh_.vertices[fan.ring[place]]); };
      for (const auto& ear : fan.ears)
        if (distanceToTriangle(placeOf(mesh_.vertices[p]), corner(ear[0]), corner(ear[1]), corner(ear[2])) <=
            approximate_.bound)
          return true;
    }
    return false;
  });
}

// Puts the new triangles in the places of the fan's and links them with each other and with what lies around. What lies
// beyond a ring edge changes to the new triangle when an ear is cut off there.
void RegionSimplifier::replace(Fan& fan) {
  Index face = mesh_.triangles[fan.triangles[0]].face;
  for (const Index t : fan.triangles) {
    face = std::min(face, mesh_.triangles[t].face);
    mesh_.alive[t] = 0;
    for (int k = 0; k < 3; ++k) mesh_.around.erase(mesh_.triangles[t].corners[k], 3 * t + k);
  }
  for (std::size_t i = 0; i < fan.ears.size(); ++i) {
    const Index t = fan.triangles[i];
    const auto& ear = fan.ears[i];
    const bool last = i + 1 == fan.ears.size();
    mesh_.alive[t] = 1;
    MeshTriangle& m = mesh_.triangles[t];
    m = {{fan.ring[ear[0]], fan.ring[ear[1]], fan.ring[ear[2]]}, face, 0};
    for (int k = 0; k < 3; ++k) {
      const Index side = 3 * t + k;
      mesh_.around.insert(m.corners[k], side);
      if (k == 2 && !last) {
        fan.beyond[ear[0]] = side;
        fan.flags[ear[0]] = 0;
        break;
      }
      const Index beyond = fan.beyond[ear[k]];
      mesh_.neighbors[side] = beyond;
      if (beyond >= 0) mesh_.neighbors[beyond] = side;
      m.obstacleEdges |= static_cast<std::uint8_t>(fan.flags[ear[k]] << k);
    }
  }
}

void RegionSimplifier::improve(std::span<const Index> triangles) {
  queue_.clear();
  for (const Index t : triangles) {
    if (mesh_.alive[t] == 0) continue;
    for (int k = 0; k < 3; ++k)
      if (mesh_.neighbors[3 * t + k] > 3 * t + k) queue_.push_back(3 * t + k);
  }
  std::size_t left = 10 * queue_.size(), polls = 0;
  while (!queue_.empty() && left > 0) {
    if ((++polls & 1023) == 0) poll_();
    const Index s = queue_.back();
    queue_.pop_back();
    if (mesh_.neighbors[s] < 0 || !flipIfBetter(s)) continue;
    --left;
    const Index t = s / 3, other = mesh_.neighbors[3 * t + 2] / 3;  // the flipped edge is side 2 of t
    for (const Index m : {t, other})
      for (int k = 0; k < 3; ++k)
        if (mesh_.neighbors[3 * m + k] >= 0) queue_.push_back(3 * m + k);
  }
}

bool RegionSimplifier::flipIfBetter(Index s) {
  const Index o = mesh_.neighbors[s];
  const Index t = s / 3, u = o / 3;
  const int k = s % 3, j = o % 3;
  const MeshTriangle x = mesh_.triangles[t], y = mesh_.triangles[u];
  const Index a = x.corners[k], b = x.corners[next(k)], c = x.corners[previous(k)], d = y.corners[previous(j)];
  const auto relative = [&](Index v) {
    return std::array<double, 2>{mesh_.vertices[v].x - mesh_.vertices[d].x, mesh_.vertices[v].y - mesh_.vertices[d].y};
  };
  if (!isWellInsideCircle(relative(a), relative(b), relative(c))) return false;
  if (geometry_.orientation(c, a, d) <= 0 || geometry_.orientation(c, d, b) <= 0) return false;
  const auto flag = [](const MeshTriangle& m, int edge) { return m.obstacleEdges >> edge & 1; };
  const Index ca = mesh_.neighbors[3 * t + previous(k)], bc = mesh_.neighbors[3 * t + next(k)];
  const Index ad = mesh_.neighbors[3 * u + next(j)], db = mesh_.neighbors[3 * u + previous(j)];
  mesh_.triangles[t] = {{c, a, d}, x.face, static_cast<std::uint8_t>(flag(x, previous(k)) | flag(y, next(j)) << 1)};
  mesh_.triangles[u] = {
      {c, d, b}, y.face, static_cast<std::uint8_t>(flag(y, previous(j)) << 1 | flag(x, next(k)) << 2)};
  const auto link = [&](Index side, Index beyond) {
    mesh_.neighbors[side] = beyond;
    if (beyond >= 0) mesh_.neighbors[beyond] = side;
  };
  link(3 * t, ca);
  link(3 * t + 1, ad);
  link(3 * t + 2, 3 * u);
  link(3 * u + 1, db);
  link(3 * u + 2, bc);
  return true;
}

}  // namespace footfall::detail
