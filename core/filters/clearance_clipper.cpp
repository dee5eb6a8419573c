// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/clearance_clipper.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace footfall {
namespace {

int next(int k) { return k == 2 ? 0 : k + 1; }

}  // namespace

ClearanceClipper::ClearanceClipper(const PlanKernel& kernel, const std::vector<char>& walkable, Index level,
                                   std::function<void()> poll)
    : mesh_(kernel.mesh()), level_(level), poll_(poll), geometry_(kernel), candidates_(kernel, walkable, level, poll) {}

FaceCuts ClearanceClipper::clip(Index face, const FaceCuts* earlier) {
  begin(face);
  if (earlier != nullptr) {
    if (earlier->removed) return *earlier;
    addEarlier(*earlier);
  }
  return cut(candidates_.find(face));
}

FaceCuts ClearanceClipper::clip(Index face, const std::vector<Index>& known, double knownHeight) {
  begin(face);
  return cut(candidates_.find(face, known, knownHeight));
}

std::vector<Index> ClearanceClipper::candidates() const {
  std::vector<Index> result;
  result.reserve(candidates_.found().size());
  for (const ClearanceCandidate& c : candidates_.found()) result.push_back(c.obstacle);
  return result;
}

ExactFallbacks ClearanceClipper::fallbacks() const {
  ExactFallbacks sum = geometry_.fallbacks;
  sum += candidates_.fallbacks;
  return sum;
}

void ClearanceClipper::begin(Index face) {
  face_ = face;
  started_ = false;
  segments_.clear();
  edgeWalls_ = 0;
  const auto& f = mesh_.triangles[face];
  for (int k = 0; k < 3; ++k)
    if (mesh_.hasObstacleEdge(f[k], f[next(k)])) edgeWalls_ |= static_cast<std::uint8_t>(1 << k);
}

FaceCuts ClearanceClipper::cut(std::span<const ClearanceCandidate> candidates) {
  bool removed = false;
  for (const ClearanceCandidate& candidate : candidates) {
    if ((++polls_ & 255) == 0) poll_();
    if (mesh_.facing[candidate.obstacle] == 0 && isWallOfEdge(candidate)) continue;
    if (!started_) {
      geometry_.start(face_);
      started_ = true;
    }
    if (mesh_.facing[candidate.obstacle] == 0)
      addWall(candidate);
    else
      removed = addArea(candidate);
    if (removed) break;
  }
  FaceCuts cuts;
  if (!removed) {
    cancelSegments();
    cuts = collect();
  }
  cuts.removed = removed;
  cuts.dependsOnFloors = candidates_.dependsOnFloors();
  return cuts;
}

bool ClearanceClipper::addArea(const ClearanceCandidate& candidate) {
  const Index obstacle = candidate.obstacle;
  const auto& o = mesh_.triangles[obstacle];
  const auto& plan = mesh_.planIds;
  const bool up = mesh_.facing[obstacle] > 0;
  Polygon polygon;
  for (int j = 0; j < 3; ++j) {  // counter-clockwise in the plan
    const int i = up ? j : 2 - j;
    const int i2 = up ? next(j) : (4 - j) % 3;
    const Index a = plan[o[i]], b = plan[o[i2]];
    polygon.push({geometry_.point({PlanPoint::Source, a}), geometry_.edgeLine(a, b), a < b ? 1 : -1, candidate.floor[i],
                  candidate.ceiling[i]});
  }
  if (!candidate.coplanar) {
    clipToLevel(polygon, obstacle, false);
    if (polygon.size > 0) clipToLevel(polygon, obstacle, true);
  }
  for (int k = 0; k < 3 && polygon.size > 0; ++k) {
    const auto& s = candidate.sides[k];
    if (s[0] >= 0 && s[1] >= 0 && s[2] >= 0) {
      // inside already; only remember what lies on the edge
      const int zeros = (s[0] == 0) + (s[1] == 0) + (s[2] == 0);
      for (int i = 0; i < polygon.size; ++i) {
        const Index p = polygon.corners[i].point;
        if (zeros >= 2) {
          geometry_.sideOfEdge(k, p);
        } else if (zeros == 1 && geometry_[p].kind == PlanPoint::Source) {
          for (int j = 0; j < 3; ++j)
            if (s[j] == 0 && geometry_[p].a == plan[o[j]]) geometry_.addBorder(p, static_cast<std::uint8_t>(1 << k));
        }
      }
      continue;
    }
    clipToEdge(polygon, k);
  }
  if (polygon.size < 3) return false;
  if (polygon.size == 3) {
    int corners = 0;
    for (int i = 0; i < 3; ++i) corners += polygon.corners[i].point < 3;  // the face's corners are points 0, 1, 2
    if (corners == 3) return true;
  }
  for (int i = 0; i < polygon.size; ++i) {
    const Corner& c = polygon.corners[i];
    addSegment(c.point, polygon.corners[(i + 1) % polygon.size].point, c.line, c.direction, 1, false);
  }
  return false;
}

// Keeps what is above the floor, or below the clearance.
void ClearanceClipper::clipToLevel(Polygon& polygon, Index obstacle, bool ceiling) {
  const int keep = ceiling ? -1 : 1;
  const auto value = [&](const Corner& c) { return (ceiling ? c.ceiling : c.floor) * keep; };
  bool needed = false, any = false;
  for (int i = 0; i < polygon.size; ++i) {
    needed = needed || value(polygon.corners[i]) < 0;
    any = any || value(polygon.corners[i]) > 0;
  }
  if (!any) polygon.size = 0;
  if (!any || !needed) return;

  const Index level = ceiling ? level_ : 0;
  const Index trace = geometry_.line({PlanLine::Trace, obstacle, level});
  const auto& o = mesh_.triangles[obstacle];
  const auto crossingOf = [&](Index line) {
    const PlanLine l = geometry_.lineAt(line);
    for (int j = 0; j < 3; ++j) {
      const Index u = o[j], v = o[next(j)];
      const Index a = mesh_.planIds[u], b = mesh_.planIds[v];
      if (std::min(a, b) == l.a && std::max(a, b) == l.b)
        return geometry_.point({PlanPoint::EdgePlane, std::min(u, v), std::max(u, v), face_, level});
    }
    return geometry_.crossing(line, trace);
  };
  Polygon result;
  for (int i = 0; i < polygon.size; ++i) {
    const Corner& c = polygon.corners[i];
    const int a = value(c), b = value(polygon.corners[(i + 1) % polygon.size]);
    if (a == 0 && b < 0)
      result.push({c.point, trace, keep, c.floor, c.ceiling});
    else if (a >= 0)
      result.push(c);
    if (a * b < 0) {
      Corner cut{crossingOf(c.line), c.line, c.direction, ceiling ? 1 : 0, ceiling ? 0 : -1};
      if (a > 0) {
        cut.line = trace;
        cut.direction = keep;
      }
      result.push(cut);
    }
  }
  polygon = result;
}

void ClearanceClipper::clipToEdge(Polygon& polygon, int k) {
  std::array<int, 12> side{};
  bool any = false;
  for (int i = 0; i < polygon.size; ++i) {
    side[i] = geometry_.sideOfEdge(k, polygon.corners[i].point);
    any = any || side[i] > 0;
  }
  if (!any) {
    polygon.size = 0;
    return;
  }
  Polygon result;
  for (int i = 0; i < polygon.size; ++i) {
    Corner c = polygon.corners[i];
    const int a = side[i], b = side[(i + 1) % polygon.size];
    if (a == 0 && b < 0) {
      c.line = k;  // FaceGeometry: the face's edges are the lines 0, 1, 2
      c.direction = geometry_.edgeDirection(k);
      result.push(c);
    } else if (a >= 0) {
      result.push(c);
    }
    if (a * b < 0) {
      Corner cut = polygon.corners[i];
      cut.point = geometry_.crossing(cut.line, k);
      geometry_.addBorder(cut.point, static_cast<std::uint8_t>(1 << k));
      if (a > 0) {
        cut.line = k;
        cut.direction = geometry_.edgeDirection(k);
      }
      result.push(cut);
    }
  }
  polygon = result;
}

// The most common wall stands on a whole edge of the face: between its ends, and in the clearance at both.
bool ClearanceClipper::isWallOfEdge(const ClearanceCandidate& candidate) {
  const auto& f = mesh_.triangles[face_];
  const auto& o = mesh_.triangles[candidate.obstacle];
  const auto& plan = mesh_.planIds;
  for (int k = 0; k < 3; ++k) {
    if (candidate.sides[k] != ClearanceCandidate::Signs{0, 0, 0}) continue;
    const Index from = plan[f[k]], to = plan[f[next(k)]];
    bool atFrom = false, atTo = false;
    for (int j = 0; j < 3; ++j) {
      const Index at = plan[o[j]];
      if (at != from && at != to) return false;
      bool reaches = candidate.floor[j] >= 0 && candidate.ceiling[j] <= 0;
      const int i = next(j);
      if (plan[o[i]] == at)  // an upright edge
        reaches =
            reaches || candidate.floor[j] * candidate.floor[i] < 0 || candidate.ceiling[j] * candidate.ceiling[i] < 0;
      (at == from ? atFrom : atTo) |= reaches;
    }
    if (!atFrom || !atTo) return false;
    edgeWalls_ |= static_cast<std::uint8_t>(1 << k);
    return true;
  }
  return false;
}

void ClearanceClipper::addWall(const ClearanceCandidate& candidate) {
  const auto& o = mesh_.triangles[candidate.obstacle];
  const auto& plan = mesh_.planIds;
  // Where the wall reaches into the clearance: its corners there, and where its edges pass floor and ceiling.
  std::array<Index, 12> points{};
  int count = 0;
  Index line = -1;
  for (int k = 0; k < 3; ++k) {
    const Index u = o[k], v = o[next(k)];
    const bool upright = plan[u] == plan[v];
    if (!upright && line < 0) line = geometry_.edgeLine(plan[u], plan[v]);
    if (candidate.floor[k] >= 0 && candidate.ceiling[k] <= 0)
      points[count++] = geometry_.point({PlanPoint::Source, plan[u]});
    const auto addCrossing = [&](Index level) {
      points[count++] = upright ? geometry_.point({PlanPoint::Source, plan[u]})
                                : geometry_.point({PlanPoint::EdgePlane, std::min(u, v), std::max(u, v), face_, level});
    };
    if (candidate.floor[k] * candidate.floor[next(k)] < 0) addCrossing(0);
    if (candidate.ceiling[k] * candidate.ceiling[next(k)] < 0) addCrossing(level_);
  }
  const PlanLine l = geometry_.lineAt(line);
  const Vec3 &start = mesh_.vertices[l.a], &end = mesh_.vertices[l.b];
  const double dx = end.x - start.x, dy = end.y - start.y;
  const int axis = std::fabs(dx) > std::fabs(dy) ? 0 : 1;
  const int along = (axis == 0 ? end.x > start.x : end.y > start.y) ? 1 : -1;
  Index first = points[0], last = points[0];
  for (int i = 1; i < count; ++i) {
    if (geometry_.compare(points[i], first, axis) * along < 0) first = points[i];
    if (geometry_.compare(points[i], last, axis) * along > 0) last = points[i];
  }
  if (geometry_.compare(first, last, axis) == 0) return;
  for (int k = 0; k < 3; ++k) {
    const int a = geometry_.sideOfEdge(k, first), b = geometry_.sideOfEdge(k, last);
    if (a <= 0 && b <= 0 && !(a == 0 && b == 0)) return;
    if (a * b >= 0) continue;
    const Index p = geometry_.crossing(line, k);
    geometry_.addBorder(p, static_cast<std::uint8_t>(1 << k));
    (a < 0 ? first : last) = p;
  }
  if (first == last) return;
  for (int k = 0; k < 3; ++k) {
    if ((first == k && last == next(k)) || (last == k && first == next(k))) {
      edgeWalls_ |= static_cast<std::uint8_t>(1 << k);
      return;
    }
  }
  addSegment(first, last, line, 1, 0, true);
}

void ClearanceClipper::addSegment(Index from, Index to, Index line, int direction, int winding, bool wall) {
  if (from == to) return;
  CutSegment s{from, to, line, static_cast<std::int8_t>(direction), winding, wall};
  if (s.from > s.to) {
    std::swap(s.from, s.to);
    s.direction = static_cast<std::int8_t>(-s.direction);
    s.winding = -s.winding;
  }
  segments_.push_back(s);
}

void ClearanceClipper::addEarlier(const FaceCuts& earlier) {
  edgeWalls_ |= earlier.edgeWalls;
  if (earlier.segments.empty()) return;
  geometry_.start(face_);
  started_ = true;
  std::vector<Index> points, lines;
  for (std::size_t i = 0; i < earlier.points.size(); ++i) {
    points.push_back(geometry_.point(earlier.points[i]));
    geometry_.addBorder(points.back(), earlier.borders[i]);
  }
  for (const PlanLine& l : earlier.lines) lines.push_back(geometry_.line(l));
  for (const CutSegment& s : earlier.segments)
    addSegment(points[s.from], points[s.to], lines[s.line], s.direction, s.winding, s.wall);
}

// Two obstacles that share an edge and lie on either side of it in the plan cover it: their windings cancel.
void ClearanceClipper::cancelSegments() {
  sortSegments();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < segments_.size();) {
    CutSegment sum = segments_[i];
    std::size_t j = i + 1;
    for (; j < segments_.size() && segments_[j].from == sum.from && segments_[j].to == sum.to; ++j) {
      if (segments_[j].line < sum.line) {
        sum.line = segments_[j].line;
        sum.direction = segments_[j].direction;
      }
      sum.winding += segments_[j].winding;
      sum.wall = sum.wall || segments_[j].wall;
    }
    if (sum.winding != 0 || sum.wall) segments_[kept++] = sum;
    i = j;
  }
  segments_.resize(kept);
}

// By their ends. Giants have tens of thousands of segments: those are counted into place, by one end and then the
// other.
void ClearanceClipper::sortSegments() {
  constexpr std::size_t kFewSegments = 256;
  if (segments_.size() < kFewSegments) {
    std::sort(segments_.begin(), segments_.end(), [](const CutSegment& a, const CutSegment& b) {
      return a.from != b.from ? a.from < b.from : a.to < b.to;
    });
    return;
  }
  sorted_.resize(segments_.size());
  for (const auto end : {&CutSegment::to, &CutSegment::from}) {
    poll_();
    numbers_.assign(geometry_.pointCount() + 1, 0);
    for (const CutSegment& s : segments_) ++numbers_[s.*end + 1];
    std::partial_sum(numbers_.begin(), numbers_.end(), numbers_.begin());
    for (const CutSegment& s : segments_) sorted_[numbers_[s.*end]++] = s;
    segments_.swap(sorted_);
  }
}

FaceCuts ClearanceClipper::collect() {
  FaceCuts cuts;
  cuts.edgeWalls = edgeWalls_;
  if (segments_.empty()) return cuts;
  const auto number = [&](std::size_t slot, std::size_t count) {
    const bool isNew = numbers_[slot] < 0;
    if (isNew) numbers_[slot] = static_cast<Index>(count);
    return isNew;
  };
  const std::size_t lineSlots = geometry_.pointCount();
  numbers_.assign(lineSlots + geometry_.lineCount(), -1);
  cuts.segments.assign(segments_.begin(), segments_.end());
  for (CutSegment& s : cuts.segments) {
    for (Index* p : {&s.from, &s.to}) {
      if (number(*p, cuts.points.size())) {
        cuts.points.push_back(geometry_[*p]);
        cuts.borders.push_back(geometry_.border(*p));
      }
      *p = numbers_[*p];
    }
    if (number(lineSlots + s.line, cuts.lines.size())) cuts.lines.push_back(geometry_.lineAt(s.line));
    s.line = numbers_[lineSlots + s.line];
  }
  return cuts;
}

}  // namespace footfall
