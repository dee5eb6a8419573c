// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/simplifier.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/exact/shape.hpp"
#include "core/filters/disjoint_sets.hpp"
#include "core/filters/mesh_topology.hpp"

namespace footfall {
namespace {

int next(int k) { return k == 2 ? 0 : k + 1; }
int previous(int k) { return k == 0 ? 2 : k - 1; }

std::uint64_t edgeKey(Index a, Index b) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32 | static_cast<std::uint32_t>(b);
}

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

WalkableMesh Simplifier::run() {
  findInnerEdges();
  around_.resize(mesh_.vertices.size());
  for (Index t = 0; t < static_cast<Index>(mesh_.triangles.size()); ++t)
    for (const Index v : mesh_.triangles[t].corners) around_[v].push_back(t);
  alive_.assign(mesh_.triangles.size(), 1);
  if (approximate_.enabled) standsFor_.resize(mesh_.triangles.size());
  for (Index v = 0; v < static_cast<Index>(mesh_.vertices.size()); ++v) {
    if ((v & 255) == 0) context_.checkCancelled();
    if ((v & 8191) == 0) context_.progress(static_cast<double>(v) / static_cast<double>(mesh_.vertices.size()));
    removeIfPossible(v);
  }
  improve();
  return compact();
}

bool Simplifier::mayJoin(Index face, Index other) {
  if (!approximate_.enabled) return kernel_.coplanar(face, other, geometry_.fallbacks);
  const auto unit = [&](Index f) {
    const auto& n = kernel_.mesh().normals[f];
    const Place p{n[0].value, n[1].value, n[2].value};
    const double length = std::sqrt(dot(p, p));
    return Place{p[0] / length, p[1] / length, p[2] / length};
  };
  return dot(unit(face), unit(other)) > 1 - approximate_.tolerance;
}

// Both sides of an edge belong to one region when nothing stands on it, they are in one layer, and their planes agree.
void Simplifier::findInnerEdges() {
  neighbors_.assign(mesh_.triangles.size() * 3, -1);
  const MeshTopology topology = findEdges(mesh_);
  DisjointSets planes(kernel_.mesh().triangles.size());
  for (const MeshEdge& e : topology.edges) {
    if (e.useCount != 2 || e.obstacle) continue;
    const Index s = topology.uses[e.firstUse], t = topology.uses[e.firstUse + 1];
    if (!mesh_.layers.empty() && mesh_.layers[s / 3] != mesh_.layers[t / 3]) continue;
    if (mesh_.triangles[s / 3].corners[s % 3] == mesh_.triangles[t / 3].corners[t % 3]) continue;  // folded over
    const Index f = mesh_.triangles[s / 3].face, g = mesh_.triangles[t / 3].face;
    if (planes.find(f) != planes.find(g)) {
      // Approximately, the first face of a region speaks for it, so that a curved floor does not count as flat.
      if (!mayJoin(planes.find(f), planes.find(g))) continue;
      planes.unite(f, g);
    }
    neighbors_[s] = t;
    neighbors_[t] = s;
  }
}

int Simplifier::cornerOf(Index triangle, Index vertex) const {
  const auto& c = mesh_.triangles[triangle].corners;
  return c[0] == vertex ? 0 : c[1] == vertex ? 1 : c[2] == vertex ? 2 : -1;
}

void Simplifier::collectFans(Index v) {
  fans_.clear();
  auto& left = around_[v];
  std::erase_if(left, [&](Index t) { return alive_[t] == 0 || cornerOf(t, v) < 0; });
  std::sort(left.begin(), left.end());
  left.erase(std::unique(left.begin(), left.end()), left.end());
  std::vector<Index> seen;
  for (const Index start : left) {
    if (std::find(seen.begin(), seen.end(), start) != seen.end()) continue;
    Fan fan;
    // clockwise to the first triangle of the fan
    Index first = start;
    while (!fan.closed) {
      const Index side = neighbors_[3 * first + cornerOf(first, v)];
      if (side < 0) break;
      first = side / 3;
      fan.closed = first == start;
    }
    for (Index t = first;;) {
      const int i = cornerOf(t, v);
      const MeshTriangle& m = mesh_.triangles[t];
      fan.triangles.push_back(t);
      fan.ring.push_back(m.corners[next(i)]);
      fan.ringNeighbors.push_back(neighbors_[3 * t + next(i)]);
      fan.ringFlags.push_back(m.obstacleEdges >> next(i) & 1);
      if (t == first) fan.firstFlag = m.obstacleEdges >> i & 1;
      const Index side = neighbors_[3 * t + previous(i)];
      if (side < 0) {
        fan.ring.push_back(m.corners[previous(i)]);
        fan.lastFlag = m.obstacleEdges >> previous(i) & 1;
        break;
      }
      t = side / 3;
      if (t == first) break;
    }
    seen.insert(seen.end(), fan.triangles.begin(), fan.triangles.end());
    fans_.push_back(std::move(fan));
  }
}

bool Simplifier::isStraight(Index u, Index v, Index w) {
  if (!approximate_.enabled) return geometry_.isBetween(u, v, w);
  return distanceToSegment(placeOf(mesh_.vertices[v]), placeOf(mesh_.vertices[u]), placeOf(mesh_.vertices[w])) <=
         approximate_.bound;
}

void Simplifier::removeIfPossible(Index v) {
  collectFans(v);
  if (fans_.empty()) return;
  if (fans_.size() > 1 || !fans_[0].closed) {
    const Index u = fans_[0].ring.front(), w = fans_[0].ring.back();
    for (const Fan& fan : fans_) {
      if (fan.closed) return;
      const Index a = fan.ring.front(), b = fan.ring.back();
      if (!((a == u && b == w) || (a == w && b == u)) || u == w) return;
      if (fan.firstFlag != fan.lastFlag) return;
    }
    if (!isStraight(u, v, w)) return;
  }
  if (!std::all_of(fans_.begin(), fans_.end(), [&](const Fan& fan) { return turnsOnce(v, fan); })) return;
  std::vector<std::vector<Corners>> filled(fans_.size());
  for (std::size_t i = 0; i < fans_.size(); ++i)
    if (!(approximate_.enabled ? cutAnyEars(fans_[i], filled[i]) : cutEars(v, fans_[i], filled[i]))) return;
  std::vector<Index> stoodFor;
  if (approximate_.enabled && !isWithinBound(v, filled, stoodFor)) return;
  for (std::size_t i = 0; i < fans_.size(); ++i) {
    replace(fans_[i], filled[i]);
    if (approximate_.enabled)
      for (std::size_t k = 0; k < filled[i].size(); ++k) standsFor_[fans_[i].triangles[k]] = stoodFor;
  }
}

// Where floors overlap (before a clearance filter), a fan can wind around its vertex more than once. The half-plane of
// the directions to its ring then changes more often than twice, or once for a straight open fan.
bool Simplifier::turnsOnce(Index v, const Fan& fan) {
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

// An ear of the star-shaped ring does not hold another corner of it when the vertex is not strictly inside.
bool Simplifier::cutEars(Index v, const Fan& fan, std::vector<Corners>& result) {
  std::vector<Index> ring = fan.ring;
  std::size_t i = 0, misses = 0;
  while (ring.size() > 3) {
    const std::size_t n = ring.size(), before = (i + n - 1) % n, after = (i + 1) % n;
    const Index a = ring[before], b = ring[i], c = ring[after];
    if (geometry_.orientation(a, b, c) > 0 && geometry_.orientation(a, c, v) >= 0) {
      result.push_back({a, b, c});
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      i = (i + ring.size() - 1) % ring.size();
      misses = 0;
    } else {
      i = after;
      if (++misses > ring.size()) return false;
    }
  }
  result.push_back({ring[0], ring[1], ring[2]});
  return true;
}

// Any simple ring: an ear must not hold another corner of it.
bool Simplifier::cutAnyEars(const Fan& fan, std::vector<Corners>& result) {
  std::vector<Index> ring = fan.ring;
  if (ring.size() < 3) return false;
  std::size_t i = 0, misses = 0;
  while (ring.size() >= 3) {
    const std::size_t n = ring.size(), before = (i + n - 1) % n, after = (i + 1) % n;
    const Index a = ring[before], b = ring[i], c = ring[after];
    bool ear = geometry_.orientation(a, b, c) > 0;
    for (std::size_t j = 0; j < n && ear; ++j) {
      const Index p = ring[j];
      if (p == a || p == b || p == c) continue;
      ear = geometry_.orientation(a, b, p) < 0 || geometry_.orientation(b, c, p) < 0 ||
            geometry_.orientation(c, a, p) < 0;
    }
    if (!ear) {
      if (++misses > n) return false;
      i = after;
      continue;
    }
    result.push_back({a, b, c});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
    if (ring.size() < 3) break;
    i = (i + ring.size() - 1) % ring.size();
    misses = 0;
  }
  return true;
}

bool Simplifier::isWithinBound(Index v, const std::vector<std::vector<Corners>>& filled, std::vector<Index>& stoodFor) {
  stoodFor.assign(1, v);
  for (const Fan& fan : fans_)
    for (const Index t : fan.triangles) stoodFor.insert(stoodFor.end(), standsFor_[t].begin(), standsFor_[t].end());
  std::sort(stoodFor.begin(), stoodFor.end());
  stoodFor.erase(std::unique(stoodFor.begin(), stoodFor.end()), stoodFor.end());
  return std::all_of(stoodFor.begin(), stoodFor.end(), [&](Index p) {
    for (const auto& triangles : filled)
      for (const Corners& c : triangles)
        if (distanceToTriangle(placeOf(mesh_.vertices[p]), placeOf(mesh_.vertices[c[0]]), placeOf(mesh_.vertices[c[1]]),
                               placeOf(mesh_.vertices[c[2]])) <= approximate_.bound)
          return true;
    return false;
  });
}

// Puts the new triangles in the places of the fan's and links them with each other and with what lies around.
void Simplifier::replace(const Fan& fan, const std::vector<Corners>& corners) {
  struct Beyond {
    Index side;
    int flag;
  };
  std::unordered_map<std::uint64_t, Beyond> beyond;  // by directed edge
  const std::size_t n = fan.ring.size();
  for (std::size_t i = 0; i < fan.ringNeighbors.size(); ++i)
    beyond[edgeKey(fan.ring[i], fan.ring[(i + 1) % n])] = {fan.ringNeighbors[i], fan.ringFlags[i]};
  if (!fan.closed) beyond[edgeKey(fan.ring.back(), fan.ring.front())] = {-1, fan.firstFlag};
  Index face = mesh_.triangles[fan.triangles[0]].face;
  for (const Index t : fan.triangles) {
    face = std::min(face, mesh_.triangles[t].face);
    alive_[t] = 0;
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Index t = fan.triangles[i];
    alive_[t] = 1;
    MeshTriangle& m = mesh_.triangles[t];
    m = {corners[i], face, 0};
    for (int k = 0; k < 3; ++k) {
      const Index a = corners[i][k], b = corners[i][next(k)];
      const Index side = 3 * t + k;
      around_[a].push_back(t);
      neighbors_[side] = -1;
      if (const auto it = beyond.find(edgeKey(a, b)); it != beyond.end()) {
        neighbors_[side] = it->second.side;
        if (it->second.side >= 0) neighbors_[it->second.side] = side;
        m.obstacleEdges |= static_cast<std::uint8_t>(it->second.flag << k);
      } else {
        beyond[edgeKey(b, a)] = {side, 0};
      }
    }
  }
}

void Simplifier::improve() {
  std::vector<Index> queue;
  for (Index s = 0; s < static_cast<Index>(neighbors_.size()); ++s)
    if (alive_[s / 3] != 0 && neighbors_[s] > s) queue.push_back(s);
  std::size_t left = 10 * queue.size();
  while (!queue.empty() && left > 0) {
    if ((left & 255) == 0) context_.checkCancelled();
    const Index s = queue.back();
    queue.pop_back();
    if (neighbors_[s] < 0 || !flipIfBetter(s)) continue;
    --left;
    const Index t = s / 3, other = neighbors_[3 * t + 2] / 3;  // the flipped edge is side 2 of t
    for (const Index m : {t, other})
      for (int k = 0; k < 3; ++k)
        if (neighbors_[3 * m + k] >= 0) queue.push_back(3 * m + k);
  }
}

bool Simplifier::flipIfBetter(Index s) {
  const Index o = neighbors_[s];
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
  const Index ca = neighbors_[3 * t + previous(k)], bc = neighbors_[3 * t + next(k)];
  const Index ad = neighbors_[3 * u + next(j)], db = neighbors_[3 * u + previous(j)];
  mesh_.triangles[t] = {{c, a, d}, x.face, static_cast<std::uint8_t>(flag(x, previous(k)) | flag(y, next(j)) << 1)};
  mesh_.triangles[u] = {
      {c, d, b}, y.face, static_cast<std::uint8_t>(flag(y, previous(j)) << 1 | flag(x, next(k)) << 2)};
  const auto link = [&](Index side, Index beyond) {
    neighbors_[side] = beyond;
    if (beyond >= 0) neighbors_[beyond] = side;
  };
  link(3 * t, ca);
  link(3 * t + 1, ad);
  link(3 * t + 2, 3 * u);
  link(3 * u + 1, db);
  link(3 * u + 2, bc);
  return true;
}

WalkableMesh Simplifier::compact() {
  WalkableMesh result;
  std::vector<Index> renumbered(mesh_.vertices.size(), -1);
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (alive_[t] == 0) continue;
    MeshTriangle m = mesh_.triangles[t];
    for (Index& v : m.corners) {
      if (renumbered[v] < 0) {
        renumbered[v] = static_cast<Index>(result.vertices.size());
        result.vertices.push_back(mesh_.vertices[v]);
      }
      v = renumbered[v];
    }
    result.triangles.push_back(m);
    if (!mesh_.layers.empty()) result.layers.push_back(mesh_.layers[t]);
  }
  result.layerCount = mesh_.layerCount;
  return result;
}

}  // namespace footfall
