// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/rounding/snapped_needles.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace footfall::detail {
namespace {

struct PlanOffset {
  double x = 0, y = 0;
};
PlanOffset between(const Vec3& a, const Vec3& b) { return {b.x - a.x, b.y - a.y}; }
double dot(const PlanOffset& a, const PlanOffset& b) { return a.x * b.x + a.y * b.y; }
double cross(const PlanOffset& a, const PlanOffset& b) { return a.x * b.y - a.y * b.x; }

constexpr std::size_t kMostTouched = 1 << 14;
/// A vertex near in the plan whose height differs more than on slopes of 89.7 degrees is on another floor.
constexpr double kSteepest = 256;

}  // namespace

std::optional<double> NeedleSnapper::shareAt(const Edge& edge, Index v) const {
  const Vec3 &a = mesh_.place(edge[0]), &b = mesh_.place(edge[1]), &p = mesh_.place(v);
  const PlanOffset whole = between(a, b), part = between(a, p);
  const double square = dot(whole, whole), along = dot(whole, part), off = cross(whole, part);
  if (!(along > 0) || !(along < square) || off * off > reach_ * reach_ * square) return std::nullopt;
  const double share = along / square;
  if (std::fabs(a.z + share * (b.z - a.z) - p.z) > kSteepest * reach_) return std::nullopt;
  return share;
}

bool NeedleSnapper::isOnePlace(Index a, Index b) const {
  const PlanOffset apart = between(mesh_.place(a), mesh_.place(b));
  return dot(apart, apart) <= reach_ * reach_ && std::fabs(mesh_.place(a).z - mesh_.place(b).z) <= kSteepest * reach_;
}

template <class Visit>
void NeedleSnapper::visitAt(const Edge& edge, const Visit& visit) {
  for (const Index t : mesh_.around(edge[0])) {
    if (!mesh_.isAlive(t)) continue;
    const auto& corners = mesh_[t].corners;
    if (std::find(corners.begin(), corners.end(), edge[1]) != corners.end()) visit(t);
  }
}

const std::vector<Index>& NeedleSnapper::verticesOn(const Edge& edge) {
  const auto [it, isNew] = on_.try_emplace(edge);
  if (isNew) it->second = findVerticesOn(edge);
  return it->second;
}

// The triangles reached over edges that end at one of those vertices, or at an end of the edge; and those found from
// other edges.
std::vector<Index> NeedleSnapper::findVerticesOn(const Edge& edge) {
  std::vector<std::pair<double, Index>> found;
  std::set<Index> near{edge[0], edge[1]}, seen;
  const auto look = [&](Index v) {
    if (near.count(v) != 0) return;
    const auto share = shareAt(edge, v);
    if (share) found.emplace_back(*share, v);
    bool isNear = share.has_value();
    for (const Index end : edge) {
      if (!isOnePlace(v, end)) continue;
      together_.push_back(edgeOf(v, end));
      isNear = true;
    }
    if (isNear) near.insert(v);
  };
  for (const Index v : known_) look(v);
  std::vector<Index> stack;
  const auto visit = [&](Index t) {
    if (seen.insert(t).second) stack.push_back(t);
  };
  visitAt(edge, visit);
  while (!stack.empty()) {
    const std::array<Index, 3> corners = mesh_[stack.back()].corners;
    stack.pop_back();
    for (const Index v : corners) look(v);
    for (int k = 0; k < 3; ++k) {
      const Edge other = edgeOf(corners[k], corners[next(k)]);
      if (near.count(other[0]) != 0 || near.count(other[1]) != 0) visitAt(other, visit);
    }
  }
  known_.insert(near.begin(), near.end());
  std::sort(found.begin(), found.end());
  std::vector<Index> vertices;
  for (const auto& [share, v] : found) {
    if (!vertices.empty() && isOnePlace(vertices.back(), v)) together_.push_back(edgeOf(vertices.back(), v));
    vertices.push_back(v);
  }
  return vertices;
}

// True when it came to an end.
bool NeedleSnapper::findTouched(Index broken) {
  on_.clear();
  touched_ = {broken};
  std::set<Index> seen{broken};
  for (std::size_t i = 0; i < touched_.size() && together_.empty(); ++i) {
    if (i > kMostTouched) return false;
    const Index t = touched_[i];
    for (int k = 0; k < 3; ++k) {
      const Edge edge = edgeOf(mesh_[t].corners[k], mesh_[t].corners[next(k)]);
      if (verticesOn(edge).empty()) continue;
      visitAt(edge, [&](Index other) {
        if (seen.insert(other).second) touched_.push_back(other);
      });
    }
  }
  return true;
}

NeedleSnapper::Outcome NeedleSnapper::snap(Index broken, double reach) {
  reach_ = reach;
  known_.clear();
  together_.clear();
  made_.clear();
  obstacles_.clear();
  for (std::size_t before = 1; known_.size() != before;) {
    before = known_.size();
    if (!findTouched(broken)) return Outcome::Failed;
    if (!together_.empty()) return Outcome::NeedsOnePlace;
  }
  if (!std::all_of(touched_.begin(), touched_.end(), [&](Index t) { return divide(t); }) || !isConforming())
    return Outcome::Failed;
  apply();
  return Outcome::Done;
}

// The outline has gone round a loop when it comes to a vertex again.
bool NeedleSnapper::divide(Index t) {
  const MeshTriangle& triangle = mesh_[t];
  Outline open;
  const auto add = [&](const Piece& piece) {
    const auto before =
        std::find_if(open.begin(), open.end(), [&](const Piece& other) { return other.from == piece.from; });
    const Outline loop(before, open.end());
    open.erase(before, open.end());
    open.push_back(piece);
    return loop.empty() || addLoop(t, loop);
  };
  for (int k = 0; k < 3; ++k) {
    const Index from = triangle.corners[k], to = triangle.corners[next(k)];
    const bool isObstacle = (triangle.obstacleEdges >> k & 1) != 0;
    std::vector<Index> inside = verticesOn(edgeOf(from, to));
    if (to < from) std::reverse(inside.begin(), inside.end());
    if (!add({from, isObstacle})) return false;
    for (const Index v : inside)
      if (!add({v, isObstacle})) return false;
  }
  return addLoop(t, open);
}

bool NeedleSnapper::addLoop(Index t, const Outline& loop) {
  if (loop.size() > 2) return triangulate(t, loop);
  if (loop.size() == 2 && (loop[0].isObstacle || loop[1].isObstacle))
    obstacles_.push_back(edgeOf(loop[0].from, loop[1].from));
  return true;
}

// Turns to the left, and has no other corner in it.
bool NeedleSnapper::isEar(const Outline& loop, std::size_t i) const {
  const std::size_t count = loop.size(), before = (i + count - 1) % count, behind = (i + 1) % count;
  const Index a = loop[before].from, b = loop[i].from, c = loop[behind].from;
  if (!mesh_.isLeftTurn(a, b, c)) return false;
  for (std::size_t j = 0; j < count; ++j) {
    if (j == before || j == i || j == behind) continue;
    const Index v = loop[j].from;
    if (!mesh_.isLeftTurn(b, a, v) && !mesh_.isLeftTurn(c, b, v) && !mesh_.isLeftTurn(a, c, v)) return false;
  }
  return true;
}

// The distance of the corner from the line of its neighbours, relative to their distance.
double NeedleSnapper::shapeOf(const Outline& loop, std::size_t i) const {
  const std::size_t count = loop.size();
  const Vec3 &a = mesh_.place(loop[(i + count - 1) % count].from), &b = mesh_.place(loop[i].from),
             &c = mesh_.place(loop[(i + 1) % count].from);
  const PlanOffset ab = between(a, b), bc = between(b, c), ac = between(a, c);
  const double shape = cross(ab, ac) / std::max({dot(ab, ab), dot(bc, bc), dot(ac, ac)});
  return std::isfinite(shape) ? shape : 0;  // three at one place, or beyond what doubles can say
}

// Cuts off ears, the best shaped one first.
bool NeedleSnapper::triangulate(Index t, Outline loop) {
  while (loop.size() > 2) {
    const std::size_t count = loop.size();
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < count; ++i) order.emplace_back(-shapeOf(loop, i), i);
    std::sort(order.begin(), order.end());
    const auto best =
        std::find_if(order.begin(), order.end(), [&](const auto& one) { return isEar(loop, one.second); });
    if (best == order.end()) return false;
    const std::size_t i = best->second, before = (i + count - 1) % count, behind = (i + 1) % count;
    NewTriangle made{t, mesh_[t]};
    made.triangle.corners = {loop[before].from, loop[i].from, loop[behind].from};
    made.triangle.obstacleEdges =
        static_cast<std::uint8_t>((loop[before].isObstacle ? 1 : 0) | (loop[i].isObstacle ? 2 : 0) |
                                  (count == 3 && loop[behind].isObstacle ? 4 : 0));
    made_.push_back(made);
    loop[before].isObstacle = false;  // the place where it was cut off
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return true;
}

// Returns whether no edge has two triangles on one side.
bool NeedleSnapper::isConforming() {
  std::set<Edge> sides;
  const std::set<Index> gone(touched_.begin(), touched_.end());
  for (const NewTriangle& made : made_)
    for (int k = 0; k < 3; ++k) {
      const Index a = made.triangle.corners[k], b = made.triangle.corners[next(k)];
      if (!sides.insert({a, b}).second) return false;
      bool isFree = true;
      mesh_.visitSide(a, b, [&](Index other) { isFree = isFree && gone.count(other) != 0; });
      if (!isFree) return false;
    }
  return true;
}

void NeedleSnapper::apply() {
  double drift = 0;
  for (const Index t : touched_) drift = std::max(drift, mesh_.drift(t));
  std::set<Index> reused;
  for (const NewTriangle& made : made_) {
    Index t = made.from;
    if (reused.insert(t).second)
      mesh_.replace(t, made.triangle);
    else
      t = mesh_.add(made.triangle, made.from);
    mesh_.setDrift(t, drift + reach_);
  }
  for (const Index t : touched_)
    if (reused.count(t) == 0) mesh_.kill(t);
  for (const auto& [a, b] : obstacles_) {
    int k = 0;
    if (const Index t = mesh_.across(a, b, k); t >= 0) mesh_.markObstacle(t, k);
    if (const Index t = mesh_.across(b, a, k); t >= 0) mesh_.markObstacle(t, k);
  }
}

}  // namespace footfall::detail
