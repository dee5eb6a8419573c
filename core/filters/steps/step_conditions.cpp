// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/step_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/index_and_box.hpp"
#include "core/exact/face_geometry.hpp"
#include "core/exact/sign_of_difference.hpp"
#include "core/mesh/lifted_vertex.hpp"

namespace footfall::detail {
namespace {

/// Walls are grouped by comparing all edges. Where there are more edges than this, each wall is judged alone first, and
/// then all walls together piece by piece.
constexpr std::size_t kMostGroupEdges = 64;
/// Corners of walls are looked up among this many earlier corners.
constexpr Index kMostKnownCorners = 32;

}  // namespace

StepConditions::StepConditions(const PlanKernel& kernel, const std::vector<char>& removed, Index step, Index height)
    : kernel_(kernel), mesh_(kernel.mesh()), removed_(removed), step_(step), height_(height), levels_{step, height} {}

ApproximatePoint StepConditions::approximateSource(Index vertex) const {
  return {mesh_.scaled[vertex].x, mesh_.scaled[vertex].y, kernel_.sign().slack};
}

int StepConditions::sideAt(const LinearSign& sign, const MeshVertex& p, MeshGeometry& geometry) const {
  if (sign.line.kind == PlanLine::Edge) {
    if (const MaybeSign filtered = filteredOrientation(approximateSource(sign.line.a), approximateSource(sign.line.b),
                                                       {p.x, p.y, p.error}, kernel_.sign().slack))
      return *filtered;
  }
  return kernel_.side(sign.line, sign.face, p.point, mesh_.triangles[p.face][0], geometry.fallbacks);
}

int StepConditions::signBetween(const StretchSign& sign, const MeshVertex& a, const MeshVertex& b,
                                MeshGeometry& geometry) const {
  if (!sign.changes()) return sign.begin != 0 ? sign.begin : sign.end;
  const int atA = sideAt(sign.sign, a, geometry);
  return sign.factor * (atA != 0 ? atA : sideAt(sign.sign, b, geometry));
}

bool StepConditions::isLevel(Index face) const {
  const auto& f = mesh_.triangles[face];
  return mesh_.vertices[f[1]].z == mesh_.vertices[f[0]].z && mesh_.vertices[f[2]].z == mesh_.vertices[f[0]].z;
}

void StepConditions::compareFloors(const SharedStretch& stretch, MeshGeometry& geometry) {
  const auto [below, above] = stretch.faces;
  const bool areLevel = isLevel(below) && isLevel(above);
  floorCount_ = below == above || (areLevel && heightOf(below) == heightOf(above)) ? 1 : 2;
  for (const int side : {0, 1}) {
    const Index level = side == 0 ? step_ : -step_;
    StretchSign& rise = rises_[side];
    rise = {{{PlanLine::Trace, above, level}, below}};
    if (areLevel || floorCount_ == 1)
      rise.begin = rise.end =
          floorCount_ == 1 ? 2 * side - 1 : signOfDifference(heightOf(above), heightOf(below), lengthOf(level));
    else
      find(rise, stretch, geometry);
  }
}

StepConditions::StretchSign StepConditions::edgeSign(Index triangle, int k) const {
  const auto& f = mesh_.triangles[triangle];
  const Index a = mesh_.planIds[f[k]], b = mesh_.planIds[f[next(k)]];
  const int inside = a < b ? mesh_.facing[triangle] : -mesh_.facing[triangle];
  return {{{PlanLine::Edge, std::min(a, b), std::max(a, b)}, -1}, inside};
}

// The rise is a linear function: it is least and largest at the ends.
bool StepConditions::isOnlyAtLimit(const SharedStretch& stretch, MeshGeometry& geometry) const {
  for (const int side : {0, 1}) {
    const int toward = side == 0 ? 1 : -1;
    const StretchSign& rise = rises_[side];
    if (std::max(rise.begin * toward, rise.end * toward) <= 0) continue;
    const bool endsBeyond = rise.end * toward > 0;
    const auto overLevel = [&](Index level, const MeshVertex& place) {
      const LinearSign sign{{PlanLine::Trace, rise.sign.line.a, toward * level}, rise.sign.face};
      return toward * sideAt(sign, place, geometry);
    };
    const MeshVertex &within = endsBeyond ? stretch.begin : stretch.end,
                     &beyond = endsBeyond ? stretch.end : stretch.begin;
    if (overLevel((*atLimit_)[0], within) >= 0 && overLevel((*atLimit_)[1], beyond) > 0) return true;
  }
  return false;
}

std::vector<std::array<MeshVertex, 2>> StepConditions::find(const SharedStretch& stretch, const Lines& lines,
                                                            MeshGeometry& geometry) {
  std::vector<std::array<MeshVertex, 2>> pieces;
  compareFloors(stretch, geometry);
  if ((rises_[0].begin > 0 && rises_[0].end > 0) || (rises_[1].begin < 0 && rises_[1].end < 0)) return pieces;
  if (atLimit_ && isOnlyAtLimit(stretch, geometry)) return pieces;
  if (!listObstacles(stretch, geometry)) return pieces;
  isUndecided_ = false;
  lines_.clear();
  breaks_.clear();
  addBreaks(stretch, lines, geometry);
  if (isUndecided_) {
    ++undecided_;
    return pieces;
  }
  std::sort(breaks_.begin(), breaks_.end(),
            [&](const MeshVertex& a, const MeshVertex& b) { return compareAlong(stretch, a, b, geometry) < 0; });
  breaks_.push_back(stretch.end);
  bool isOpen = false;
  MeshVertex from = stretch.begin;
  for (const MeshVertex& to : breaks_) {
    if (compareAlong(stretch, from, to, geometry) == 0) continue;
    if (!isFree(stretch, from, to, geometry)) {
      isOpen = false;
    } else if (isOpen) {
      pieces.back()[1] = to;
    } else {
      pieces.push_back({from, to});
      isOpen = true;
    }
    from = to;
  }
  return pieces;
}

// Obstacles are found by the tree's boxes, which may be larger than the obstacles; nothing that counts is missed.
bool StepConditions::listObstacles(const SharedStretch& stretch, MeshGeometry& geometry) {
  covers_.clear();
  walls_.clear();
  corners_.clear();
  zeros_.clear();
  groups_.clear();
  groupEdges_.clear();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box = stretch.box;
  const int scale = mesh_.grid.scaleExponent();
  for (int k = 0; k < 3; ++k) {
    box.lower[k] = std::ldexp(box.lower[k], -scale);
    box.upper[k] = std::ldexp(box.upper[k], -scale);
  }
  box.lower[2] = std::nextafter(box.lower[2] + lengthOf(step_), -kInfinity);
  box.upper[2] = std::nextafter(box.upper[2] + lengthOf(height_), kInfinity);
  bool isOpen = true;
  mesh_.tree.visitOverlapping(box, stack_, [&](Index t) {
    if (removed_[t] != 0 || t == stretch.faces[0] || t == stretch.faces[1]) return true;
    if (mesh_.facing[t] == 0) {
      if (addWall(stretch, t, geometry)) isOpen = !isBlockedThroughoutByWalls();
    } else if (addCover(stretch, t, geometry)) {
      isOpen = !isBlockedThroughoutBy(covers_.back());
    }
    return isOpen;
  });
  std::sort(covers_.begin(), covers_.end(), [](const Cover& a, const Cover& b) { return a.triangle < b.triangle; });
  return isOpen;
}

bool StepConditions::addCover(const SharedStretch& stretch, Index triangle, MeshGeometry& geometry) {
  Cover cover{triangle, {}, {}};
  for (int k = 0; k < 3; ++k) {
    StretchSign& edge = cover.edges[k];
    edge = edgeSign(triangle, k);
    edge.begin = edge.factor * sideAt(edge.sign, stretch.begin, geometry);
    if (edge.begin > 0) continue;
    edge.end = edge.factor * sideAt(edge.sign, stretch.end, geometry);
    if (edge.end < 0 || (edge.begin < 0 && edge.end == 0)) return false;
  }
  for (StretchSign& edge : cover.edges)
    if (edge.begin > 0) edge.end = edge.factor * sideAt(edge.sign, stretch.end, geometry);
  for (int floor = 0; floor < 2; ++floor)
    for (int level = 0; level < 2; ++level) {
      StretchSign& height = cover.heights[floor][level];
      height = {{{PlanLine::Trace, triangle, levels_[level]}, stretch.faces[floor]}};
      if (floor < floorCount_)
        find(height, stretch, geometry);
      else
        height = cover.heights[0][level];
    }
  covers_.push_back(cover);
  return true;
}

std::array<std::array<int, 2>, 2> StepConditions::signsOver(const SharedStretch& stretch, Index vertex,
                                                            MeshGeometry& geometry) const {
  std::array<std::array<int, 2>, 2> signs{};
  for (int floor = 0; floor < floorCount_; ++floor) {
    const Index face = stretch.faces[floor];
    const bool faceIsLevel = isLevel(face);
    for (int level = 0; level < 2; ++level)
      signs[floor][level] = faceIsLevel
                                ? signOfDifference(mesh_.vertices[vertex].z, heightOf(face), lengthOf(levels_[level]))
                                : kernel_.heightSign(face, vertex, levels_[level], geometry.fallbacks);
  }
  if (floorCount_ == 1) signs[1] = signs[0];
  return signs;
}

Index StepConditions::cornerOf(const SharedStretch& stretch, Index vertex, MeshGeometry& geometry) {
  const auto count = static_cast<Index>(corners_.size());
  for (Index i = count; i-- > std::max<Index>(count - kMostKnownCorners, 0);)
    if (corners_[i].vertex == vertex) return i;
  WallCorner corner;
  corner.vertex = vertex;
  const MeshVertex &a = stretch.begin, &b = stretch.end;
  corner.isOnLine =
      !filteredOrientation({a.x, a.y, a.error}, {b.x, b.y, b.error}, approximateSource(vertex), kernel_.sign().slack) &&
      kernel_.orientation(a.point, b.point, PlanPoint::source(mesh_.planIds[vertex]),
                          mesh_.triangles[stretch.faces[0]][0], geometry.fallbacks) == 0;
  if (corner.isOnLine) {
    corner.place = placeOf(stretch, vertex);
    corner.isAfterBegin = compareAlong(stretch, a, corner.place, geometry) < 0;
    corner.isBeforeEnd = compareAlong(stretch, corner.place, b, geometry) < 0;
    corner.signs = signsOver(stretch, vertex, geometry);
  }
  corners_.push_back(corner);
  return count;
}

// A wall that is not parallel meets the line in one point.
bool StepConditions::addWall(const SharedStretch& stretch, Index triangle, MeshGeometry& geometry) {
  std::array<Index, 3> corners{};
  bool reachesUp = false, reachesDown = false;
  for (int k = 0; k < 3; ++k) {
    corners[k] = cornerOf(stretch, mesh_.triangles[triangle][k], geometry);
    const WallCorner& corner = corners_[corners[k]];
    if (!corner.isOnLine) return false;
    for (const auto& [overStep, overHeight] : corner.signs) {
      reachesUp = reachesUp || overStep > 0;
      reachesDown = reachesDown || overHeight < 0;
    }
  }
  if (!reachesUp || !reachesDown) return false;
  Wall wall;
  for (int k = 0; k < 3; ++k) {
    const Index first = corners[k], second = corners[next(k)];
    const int order = compareAlong(stretch, corners_[first].place, corners_[second].place, geometry);
    if (order == 0) continue;  // the other two corners span the same
    WallEdge& edge = wall.edges[wall.edgeCount++];
    edge.begin = order < 0 ? first : second;
    edge.end = order < 0 ? second : first;
    edge.isWhole = !corners_[edge.begin].isAfterBegin && !corners_[edge.end].isBeforeEnd;
  }
  walls_.push_back(wall);
  return true;
}

// Linear functions that are nowhere negative at either end of the stretch, and positive at one, are positive between
// the ends.
bool StepConditions::isBlockedThroughoutBy(const Cover& cover) const {
  const auto& [overFirst, overSecond] = cover.heights;
  if (!overFirst[0].isPositive() && !overSecond[0].isPositive()) return false;
  if (!overFirst[1].isNegative() && !overSecond[1].isNegative()) return false;
  return std::all_of(cover.edges.begin(), cover.edges.end(),
                     [](const StretchSign& edge) { return edge.begin >= 0 && edge.end >= 0; });
}

// Over each place, a wall fills an interval of heights, and walls that share an edge there fill one interval together.
// If that interval begins below the highest place that must be free and ends above the lowest one, one of the walls
// does so as well, because the former place is above the latter. Otherwise each wall would be either below or above the
// heights that must be free, and two walls with a common point would be of both kinds.
bool StepConditions::isBlockedThroughoutByWalls() {
  const Wall& wall = walls_.back();
  WallGroup own;
  for (int i = 0; i < wall.edgeCount; ++i) {
    const WallEdge& edge = wall.edges[i];
    if (!edge.isWhole) continue;
    const WallCorner &begin = corners_[edge.begin], &end = corners_[edge.end];
    for (int floor = 0; floor < floorCount_; ++floor) {
      const auto signOver = [&](int level) {
        return StretchSign{{}, 1, begin.signs[floor][level], end.signs[floor][level]};
      };
      own.reachesUp = own.reachesUp || signOver(0).isPositive();
      own.reachesDown = own.reachesDown || signOver(1).isNegative();
    }
  }
  if (own.reachesUp && own.reachesDown) return true;
  if (!(lengthOf(height_) > lengthOf(step_)) || groupEdges_.size() > kMostGroupEdges) return false;
  const std::size_t number = groupOf(wall);
  WallGroup& group = groups_[number];
  group.reachesUp = group.reachesUp || own.reachesUp;
  group.reachesDown = group.reachesDown || own.reachesDown;
  return group.reachesUp && group.reachesDown;
}

// Joins the groups of all whole edges of the wall.
std::size_t StepConditions::groupOf(const Wall& wall) {
  const std::size_t own = groups_.size(), count = groupEdges_.size();
  groups_.emplace_back();
  for (int i = 0; i < wall.edgeCount; ++i) {
    const WallEdge& edge = wall.edges[i];
    if (!edge.isWhole) continue;
    const auto [low, high] = std::minmax({corners_[edge.begin].vertex, corners_[edge.end].vertex});
    for (std::size_t j = 0; j < count; ++j) {
      const std::size_t other = groupEdges_[j].group;
      if (groupEdges_[j].low != low || groupEdges_[j].high != high || other == own) continue;
      groups_[own].reachesUp = groups_[own].reachesUp || groups_[other].reachesUp;
      groups_[own].reachesDown = groups_[own].reachesDown || groups_[other].reachesDown;
      for (GroupEdge& joined : groupEdges_)
        if (joined.group == other) joined.group = own;
    }
    groupEdges_.push_back({low, high, own});
  }
  return own;
}

MeshVertex StepConditions::placeOf(const SharedStretch& stretch, Index vertex) const {
  const Vec3& p = mesh_.scaled[vertex];
  return {PlanPoint::source(mesh_.planIds[vertex]), stretch.faces[0], -1, p.x, p.y, p.z, kernel_.sign().slack};
}

void StepConditions::addBreaks(const SharedStretch& stretch, const Lines& lines, MeshGeometry& geometry) {
  for (const StretchSign& rise : rises_) addCrossing(stretch, rise, lines);
  for (Cover& cover : covers_) {
    for (const StretchSign& edge : cover.edges)
      if (const MeshVertex* crossing = addCrossing(stretch, edge, lines)) {
        const Along along = placeAlong(stretch, *crossing);
        if (edge.begin < 0)
          cover.from = std::max(cover.from, along.low);
        else
          cover.to = std::min(cover.to, along.high);
      }
    for (int floor = 0; floor < floorCount_; ++floor)
      for (const StretchSign& height : cover.heights[floor]) addCrossing(stretch, height, lines);
  }
  for (Wall& wall : walls_) addWallBreaks(stretch, wall, geometry);
}

void StepConditions::addWallBreaks(const SharedStretch& stretch, Wall& wall, MeshGeometry& geometry) {
  for (int i = 0; i < wall.edgeCount; ++i) {
    WallEdge& edge = wall.edges[i];
    const WallCorner &begin = corners_[edge.begin], &end = corners_[edge.end];
    for (const WallCorner* corner : {&begin, &end})
      if (corner->isAfterBegin && corner->isBeforeEnd) breaks_.push_back(corner->place);
    for (int floor = 0; floor < 2; ++floor)
      for (int level = 0; level < 2; ++level) {
        WallSign& sign = edge.signs[floor][level];
        if (floor >= floorCount_) {
          sign = edge.signs[0][level];
          continue;
        }
        sign = {begin.signs[floor][level], end.signs[floor][level]};
        if (sign.before * sign.after >= 0) {
          if (sign.before == 0) sign.before = sign.after;
          continue;
        }
        const PlanPoint zero = PlanPoint::edgePlane(begin.vertex, end.vertex, stretch.faces[floor], levels_[level]);
        const MeshVertex place = liftedVertex(kernel_, stretch.faces[0], zero);
        if (addBreak(stretch, place, geometry)) {
          sign.zero = static_cast<Index>(zeros_.size());
          zeros_.push_back(place);
        } else if (compareAlong(stretch, stretch.begin, place, geometry) >= 0) {
          sign.before = sign.after;
        }
      }
  }
}

const MeshVertex* StepConditions::addCrossing(const SharedStretch& stretch, const StretchSign& sign,
                                              const Lines& lines) {
  if (!sign.changes()) return nullptr;
  const PlanLine& other = sign.sign.line;
  const bool isTrace = other.kind == PlanLine::Trace;
  if (lines_.empty()) lines_ = lines();
  for (const auto& [line, face] : lines_) {
    const bool isOwnTrace = line.kind == PlanLine::Trace;
    if (isTrace && isOwnTrace && face != sign.sign.face) continue;  // a crossing is tied to one face
    const Index taken = isTrace ? sign.sign.face : isOwnTrace ? face : -1;
    return &breaks_.emplace_back(liftedVertex(kernel_, stretch.faces[0], PlanPoint::crossing(line, other, taken)));
  }
  isUndecided_ = true;
  return nullptr;
}

StepConditions::Along StepConditions::placeAlong(const SharedStretch& stretch, const MeshVertex& place) const {
  const double along = stretch.direction * (stretch.axis == 0 ? place.x : place.y);
  const double error = (place.error + kernel_.sign().slack) * 2 + std::fabs(along) * 0x1p-50;
  return {along - error, along + error};
}

bool StepConditions::addBreak(const SharedStretch& stretch, const MeshVertex& place, MeshGeometry& geometry) {
  if (compareAlong(stretch, stretch.begin, place, geometry) >= 0 ||
      compareAlong(stretch, place, stretch.end, geometry) >= 0)
    return false;
  breaks_.push_back(place);
  return true;
}

// Covers that begin behind the piece or end before it are left out by their bounds: long borders have hundreds of both.
bool StepConditions::isFree(const SharedStretch& stretch, const MeshVertex& a, const MeshVertex& b,
                            MeshGeometry& geometry) const {
  if (signBetween(rises_[0], a, b, geometry) > 0 || signBetween(rises_[1], a, b, geometry) < 0) return false;
  const double begin = placeAlong(stretch, a).low, end = placeAlong(stretch, b).high;
  return std::none_of(covers_.begin(), covers_.end(),
                      [&](const Cover& cover) {
                        return cover.from <= end && cover.to >= begin && isBlockedBy(cover, a, b, geometry);
                      }) &&
         std::none_of(walls_.begin(), walls_.end(),
                      [&](const Wall& wall) { return isBlockedBy(stretch, wall, a, b, geometry); });
}

bool StepConditions::isBlockedBy(const Cover& cover, const MeshVertex& a, const MeshVertex& b,
                                 MeshGeometry& geometry) const {
  for (const StretchSign& edge : cover.edges)
    if (signBetween(edge, a, b, geometry) < 0) return false;
  const auto overFloor = [&](int floor, int level) { return signBetween(cover.heights[floor][level], a, b, geometry); };
  return (overFloor(0, 0) > 0 || (floorCount_ > 1 && overFloor(1, 0) > 0)) &&
         (overFloor(0, 1) < 0 || (floorCount_ > 1 && overFloor(1, 1) < 0));
}

bool StepConditions::isBlockedBy(const SharedStretch& stretch, const Wall& wall, const MeshVertex& a,
                                 const MeshVertex& b, MeshGeometry& geometry) const {
  bool reachesUp = false, reachesDown = false;
  for (int i = 0; i < wall.edgeCount; ++i) {
    const WallEdge& edge = wall.edges[i];
    if (!edge.isWhole && (compareAlong(stretch, a, corners_[edge.begin].place, geometry) < 0 ||
                          compareAlong(stretch, corners_[edge.end].place, b, geometry) < 0))
      continue;
    for (int floor = 0; floor < floorCount_; ++floor) {
      const auto& [overStep, overHeight] = edge.signs[floor];
      reachesUp = reachesUp || signBefore(stretch, overStep, b, geometry) > 0;
      reachesDown = reachesDown || signBefore(stretch, overHeight, b, geometry) < 0;
    }
    if (reachesUp && reachesDown) return true;
  }
  return false;
}

int StepConditions::signBefore(const SharedStretch& stretch, const WallSign& sign, const MeshVertex& b,
                               MeshGeometry& geometry) const {
  if (sign.zero < 0 || compareAlong(stretch, b, zeros_[sign.zero], geometry) <= 0) return sign.before;
  return sign.after;
}

}  // namespace footfall::detail
