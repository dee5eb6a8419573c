// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/step_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/geometry.hpp"
#include "core/exact/face_geometry.hpp"
#include "core/mesh/lifted_vertex.hpp"

namespace footfall::detail {

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

int StepConditions::signBetween(const LinearSign& sign, const MeshVertex& a, const MeshVertex& b,
                                MeshGeometry& geometry) const {
  const int atA = sideAt(sign, a, geometry);
  return atA != 0 ? atA : sideAt(sign, b, geometry);
}

// The height of the second floor over the first one, raised by the step and lowered by it.
std::array<StepConditions::LinearSign, 2> StepConditions::stepSigns(const SharedStretch& stretch) const {
  const auto [below, above] = stretch.faces;
  return {LinearSign{{PlanLine::Trace, above, step_}, below}, LinearSign{{PlanLine::Trace, above, -step_}, below}};
}

// `inside` is the line's sign on the side of the triangle.
StepConditions::LinearSign StepConditions::edgeSign(Index triangle, int k, int& inside) const {
  const auto& f = mesh_.triangles[triangle];
  const Index a = mesh_.planIds[f[k]], b = mesh_.planIds[f[next(k)]];
  inside = a < b ? mesh_.facing[triangle] : -mesh_.facing[triangle];
  return {{PlanLine::Edge, std::min(a, b), std::max(a, b)}, -1};
}

std::vector<std::array<MeshVertex, 2>> StepConditions::find(const SharedStretch& stretch, const Lines& lines,
                                                            MeshGeometry& geometry) {
  std::vector<std::array<MeshVertex, 2>> pieces;
  const auto [over, under] = stepSigns(stretch);
  for (const int wrong : {1, -1}) {
    const LinearSign& sign = wrong > 0 ? over : under;
    if (sideAt(sign, stretch.begin, geometry) == wrong && sideAt(sign, stretch.end, geometry) == wrong) return pieces;
  }
  listObstacles(stretch, geometry);
  if (isClosed_) return pieces;
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

// Of the tree's boxes, which may be larger; nothing that counts is missed.
void StepConditions::listObstacles(const SharedStretch& stretch, MeshGeometry& geometry) {
  covers_.clear();
  walls_.clear();
  isClosed_ = false;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box = stretch.box;
  const int scale = mesh_.grid.scaleExponent();
  for (int k = 0; k < 3; ++k) {
    box.lower[k] = std::ldexp(box.lower[k], -scale);
    box.upper[k] = std::ldexp(box.upper[k], -scale);
  }
  box.lower[2] = std::nextafter(box.lower[2] + kernel_.heights()[step_ - 1], -kInfinity);
  box.upper[2] = std::nextafter(box.upper[2] + kernel_.heights()[height_ - 1], kInfinity);
  mesh_.tree.visitOverlapping(box, stack_, [&](Index t) {
    if (removed_[t] != 0 || t == stretch.faces[0] || t == stretch.faces[1]) return true;
    if (mesh_.facing[t] == 0)
      addWall(stretch, t, geometry);
    else if (mayCover(stretch, t, geometry))
      covers_.push_back(t);
    return !isClosed_;
  });
  std::sort(covers_.begin(), covers_.end());
}

// False when an edge has the whole stretch on its outer side.
bool StepConditions::mayCover(const SharedStretch& stretch, Index triangle, MeshGeometry& geometry) const {
  for (int k = 0; k < 3; ++k) {
    int inside = 0;
    const LinearSign sign = edgeSign(triangle, k, inside);
    const int atBegin = inside * sideAt(sign, stretch.begin, geometry);
    if (atBegin <= 0) {
      const int atEnd = inside * sideAt(sign, stretch.end, geometry);
      if (atEnd < 0 || (atBegin < 0 && atEnd == 0)) return false;
    }
  }
  return true;
}

// A wall that is not parallel meets the line in one point.
void StepConditions::addWall(const SharedStretch& stretch, Index triangle, MeshGeometry& geometry) {
  const auto& f = mesh_.triangles[triangle];
  const Index origin = mesh_.triangles[stretch.faces[0]][0];
  const MeshVertex &a = stretch.begin, &b = stretch.end;
  for (const Index v : f) {
    if (filteredOrientation({a.x, a.y, a.error}, {b.x, b.y, b.error}, approximateSource(v), kernel_.sign().slack))
      return;
    if (kernel_.orientation(a.point, b.point, PlanPoint::source(mesh_.planIds[v]), origin, geometry.fallbacks) != 0)
      return;
  }
  std::array<WallCorner, 3> corners;
  bool reachesUp = false, reachesDown = false;
  for (int k = 0; k < 3; ++k) {
    corners[k].vertex = f[k];
    for (int face = 0; face < 2; ++face) {
      for (int level = 0; level < 2; ++level)
        corners[k].signs[face][level] =
            face > 0 && stretch.faces[face] == stretch.faces[0]
                ? corners[k].signs[0][level]
                : kernel_.heightSign(stretch.faces[face], f[k], levels_[level], geometry.fallbacks);
      reachesUp = reachesUp || corners[k].signs[face][0] > 0;
      reachesDown = reachesDown || corners[k].signs[face][1] < 0;
    }
  }
  if (!reachesUp || !reachesDown) return;
  for (WallCorner& corner : corners) corner.place = placeOf(stretch, corner.vertex);
  Wall wall;
  for (int k = 0; k < 3; ++k) {
    const WallCorner &p = corners[k], &q = corners[next(k)];
    const int order = compareAlong(stretch, p.place, q.place, geometry);
    if (order != 0) wall.push_back(order < 0 ? WallEdge{p, q} : WallEdge{q, p});  // else the other two span the same
  }
  isClosed_ = isWhollyBlockedBy(stretch, wall, geometry);
  walls_.push_back(std::move(wall));
}

// What blocks each piece of the stretch: then there is no need to know the pieces. Most walls are such.
bool StepConditions::isWhollyBlockedBy(const SharedStretch& stretch, const Wall& wall, MeshGeometry& geometry) const {
  bool reachesUp = false, reachesDown = false;
  for (const WallEdge& edge : wall) {
    if (compareAlong(stretch, stretch.begin, edge.begin.place, geometry) < 0 ||
        compareAlong(stretch, edge.end.place, stretch.end, geometry) < 0)
      continue;
    for (int face = 0; face < 2; ++face) {
      const auto signsOf = [&](int level) {
        return std::pair(edge.begin.signs[face][level], edge.end.signs[face][level]);
      };
      const auto [lowUp, highUp] = signsOf(0);
      const auto [lowDown, highDown] = signsOf(1);
      reachesUp = reachesUp || (std::min(lowUp, highUp) >= 0 && std::max(lowUp, highUp) > 0);
      reachesDown = reachesDown || (std::max(lowDown, highDown) <= 0 && std::min(lowDown, highDown) < 0);
    }
  }
  return reachesUp && reachesDown;
}

MeshVertex StepConditions::placeOf(const SharedStretch& stretch, Index vertex) const {
  const Vec3& p = mesh_.scaled[vertex];
  return {PlanPoint::source(mesh_.planIds[vertex]), stretch.faces[0], -1, p.x, p.y, p.z, kernel_.sign().slack};
}

void StepConditions::addBreaks(const SharedStretch& stretch, const Lines& lines, MeshGeometry& geometry) {
  for (const LinearSign& sign : stepSigns(stretch)) addCrossing(stretch, sign, lines, geometry);
  for (const Index t : covers_) {
    for (int k = 0; k < 3; ++k) {
      int inside = 0;
      addCrossing(stretch, edgeSign(t, k, inside), lines, geometry);
    }
    for (const Index face : stretch.faces)
      for (const Index level : {step_, height_})
        addCrossing(stretch, {{PlanLine::Trace, t, level}, face}, lines, geometry);
  }
  for (const Wall& wall : walls_)
    for (const WallEdge& edge : wall) {
      addBreak(stretch, edge.begin.place, geometry);
      addBreak(stretch, edge.end.place, geometry);
      for (int face = 0; face < 2; ++face)
        for (int level = 0; level < 2; ++level)
          if (edge.begin.signs[face][level] * edge.end.signs[face][level] < 0)
            addBreak(stretch, liftedVertex(kernel_, stretch.faces[0], zeroOf(stretch, edge, face, level)), geometry);
    }
}

void StepConditions::addCrossing(const SharedStretch& stretch, const LinearSign& sign, const Lines& lines,
                                 MeshGeometry& geometry) {
  const int atBegin = sideAt(sign, stretch.begin, geometry);
  if (atBegin == 0 || atBegin * sideAt(sign, stretch.end, geometry) >= 0) return;
  const bool isTrace = sign.line.kind == PlanLine::Trace;
  if (lines_.empty()) lines_ = lines();
  for (const auto& [line, face] : lines_) {
    const bool isOwnTrace = line.kind == PlanLine::Trace;
    if (isTrace && isOwnTrace && face != sign.face) continue;  // a crossing knows one face
    const Index taken = isTrace ? sign.face : isOwnTrace ? face : -1;
    breaks_.push_back(liftedVertex(kernel_, stretch.faces[0], PlanPoint::crossing(line, sign.line, taken)));
    return;
  }
  isUndecided_ = true;
}

void StepConditions::addBreak(const SharedStretch& stretch, const MeshVertex& place, MeshGeometry& geometry) {
  if (compareAlong(stretch, stretch.begin, place, geometry) < 0 &&
      compareAlong(stretch, place, stretch.end, geometry) < 0)
    breaks_.push_back(place);
}

bool StepConditions::isFree(const SharedStretch& stretch, const MeshVertex& a, const MeshVertex& b,
                            MeshGeometry& geometry) const {
  const auto [over, under] = stepSigns(stretch);
  if (signBetween(over, a, b, geometry) > 0 || signBetween(under, a, b, geometry) < 0) return false;
  return std::none_of(covers_.begin(), covers_.end(),
                      [&](Index t) { return isBlockedBy(stretch, t, a, b, geometry); }) &&
         std::none_of(walls_.begin(), walls_.end(),
                      [&](const Wall& wall) { return isBlockedBy(stretch, wall, a, b, geometry); });
}

bool StepConditions::isBlockedBy(const SharedStretch& stretch, Index triangle, const MeshVertex& a, const MeshVertex& b,
                                 MeshGeometry& geometry) const {
  for (int k = 0; k < 3; ++k) {
    int inside = 0;
    const LinearSign sign = edgeSign(triangle, k, inside);
    if (inside * signBetween(sign, a, b, geometry) < 0) return false;
  }
  const auto overFloor = [&](Index face, Index level) {
    return signBetween({{PlanLine::Trace, triangle, level}, face}, a, b, geometry);
  };
  const auto& [f, g] = stretch.faces;
  return (overFloor(f, step_) > 0 || overFloor(g, step_) > 0) &&
         (overFloor(f, height_) < 0 || overFloor(g, height_) < 0);
}

bool StepConditions::isBlockedBy(const SharedStretch& stretch, const Wall& wall, const MeshVertex& a,
                                 const MeshVertex& b, MeshGeometry& geometry) const {
  bool reachesUp = false, reachesDown = false;
  for (const WallEdge& edge : wall) {
    if (compareAlong(stretch, a, edge.begin.place, geometry) < 0 ||
        compareAlong(stretch, edge.end.place, b, geometry) < 0)
      continue;
    for (int face = 0; face < 2; ++face) {
      reachesUp = reachesUp || heightBetween(stretch, edge, face, 0, b, geometry) > 0;
      reachesDown = reachesDown || heightBetween(stretch, edge, face, 1, b, geometry) < 0;
    }
  }
  return reachesUp && reachesDown;
}

int StepConditions::heightBetween(const SharedStretch& stretch, const WallEdge& edge, int face, int level,
                                  const MeshVertex& b, MeshGeometry& geometry) const {
  const int begin = edge.begin.signs[face][level], end = edge.end.signs[face][level];
  if (begin * end >= 0) return begin != 0 ? begin : end;
  const MeshVertex zero = liftedVertex(kernel_, stretch.faces[0], zeroOf(stretch, edge, face, level));
  return compareAlong(stretch, b, zero, geometry) <= 0 ? begin : end;
}

}  // namespace footfall::detail
