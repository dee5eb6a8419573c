// The part of ClearanceClipper that cuts along walls.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <tuple>

#include "core/base/index_and_box.hpp"
#include "core/filters/clearance/clearance_clipper.hpp"

namespace footfall::detail {

// The corner itself is in the clearance, or an upright edge at it passes floor or ceiling.
bool ClearanceClipper::reachesAt(const ClearanceCandidate& candidate, int j) const {
  if (candidate.floor[j] >= 0 && candidate.ceiling[j] <= 0) return true;
  const auto& o = mesh_.triangles[candidate.obstacle];
  for (const int i : {next(j), previous(j)})
    if (mesh_.planIds[o[i]] == mesh_.planIds[o[j]] &&
        (candidate.floor[j] * candidate.floor[i] < 0 || candidate.ceiling[j] * candidate.ceiling[i] < 0))
      return true;
  return false;
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
      (at == from ? atFrom : atTo) |= reachesAt(candidate, j);
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
  Index line = -1;
  for (int k = 0; k < 3 && line < 0; ++k)
    if (plan[o[k]] != plan[o[next(k)]]) line = geometry_.edgeLine(plan[o[k]], plan[o[next(k)]]);
  // Plan ids ascend or descend along a line, and an edge's line runs to the larger one.
  int low = 0, high = 0;
  for (int k = 1; k < 3; ++k) {
    if (plan[o[k]] < plan[o[low]]) low = k;
    if (plan[o[k]] > plan[o[high]]) high = k;
  }
  Place first, last;
  if (reachesAt(candidate, low) && reachesAt(candidate, high)) {
    first = {geometry_.sourcePoint(plan[o[low]]), low, low};
    last = {geometry_.sourcePoint(plan[o[high]]), high, high};
  } else {
    std::tie(first, last) = endsOfWall(candidate, line);
    if (first.point == last.point) return;
  }
  if (clipToFace(line, first, last, candidate)) addWallPiece(line, first.point, last.point);
}

std::pair<ClearanceClipper::Place, ClearanceClipper::Place> ClearanceClipper::endsOfWall(
    const ClearanceCandidate& candidate, Index line) {
  const auto& o = mesh_.triangles[candidate.obstacle];
  const auto& plan = mesh_.planIds;
  // The places where the wall reaches into the clearance: its corners there, and the crossings of its edges with floor
  // and ceiling.
  std::array<Place, 9> places;
  int count = 0;
  const auto addPlace = [&](const PlanPoint& point, int from, int to) {
    places[count++] = {geometry_.point(point), from, to};
  };
  for (int k = 0; k < 3; ++k) {
    const Index u = o[k], v = o[next(k)];
    if (reachesAt(candidate, k)) addPlace(PlanPoint::source(plan[u]), k, k);
    if (plan[u] == plan[v]) continue;
    if (candidate.floor[k] * candidate.floor[next(k)] < 0) addPlace(PlanPoint::edgePlane(u, v, face_, 0), k, next(k));
    if (candidate.ceiling[k] * candidate.ceiling[next(k)] < 0)
      addPlace(PlanPoint::edgePlane(u, v, face_, level_), k, next(k));
  }
  const PlanLine l = geometry_.lineAt(line);
  const Vec3 &start = mesh_.vertices[l.a], &end = mesh_.vertices[l.b];
  const double dx = end.x - start.x, dy = end.y - start.y;
  const int axis = std::fabs(dx) > std::fabs(dy) ? 0 : 1;
  const int along = (axis == 0 ? end.x > start.x : end.y > start.y) ? 1 : -1;
  Place first = places[0], last = places[0];
  for (int i = 1; i < count; ++i) {
    if (geometry_.compare(places[i].point, first.point, axis) * along < 0) first = places[i];
    if (geometry_.compare(places[i].point, last.point, axis) * along > 0) last = places[i];
  }
  if (geometry_.compare(first.point, last.point, axis) == 0) last = first;
  return {first, last};
}

// Adds the part of a wall over the face, from one end to the other along its line.
void ClearanceClipper::addWallPiece(Index line, Index first, Index last) {
  if (first == last) return;
  for (int k = 0; k < 3; ++k) {
    if ((first == k && last == next(k)) || (last == k && first == next(k))) {
      edgeWalls_ |= static_cast<std::uint8_t>(1 << k);
      return;
    }
  }
  bool cutFirst = false, cutLast = false;
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    const int a = sideOfCell(side, first), b = sideOfCell(side, last);
    if (a <= 0 && b <= 0 && !(a == 0 && b == 0)) return;
    if (a * b >= 0) continue;
    (a < 0 ? first : last) = geometry_.crossing(line, sideLines_[side]);
    (a < 0 ? cutFirst : cutLast) = true;
  }
  addSegment(first, last, line, 1, 0, true, cutFirst, cutLast);
}

}  // namespace footfall::detail
