// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/clearance/clearance_candidates.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/index_and_box.hpp"
#include "core/base/poll.hpp"

namespace footfall::detail {
namespace {

/// Signs by edge, then corner.
void setSigns(std::array<ClearanceCandidate::Signs, 3>& signs, const EdgeSides& sides) {
  for (std::size_t k = 0; k < 3; ++k) signs[k] = sides[k].each();
}

struct GridSquare {
  std::uint8_t column = 0, row = 0;
};

/// All squares of an OpenGrid, in an order of which every beginning spreads over the grid.
constexpr auto kSpreadSquares = [] {
  std::array<GridSquare, OpenGrid::kSquares * OpenGrid::kSquares> squares{};
  // Each turn fills three quarters around those that are there, half as far away as the turn before.
  for (std::size_t count = 1, half = OpenGrid::kSquares / 2; half > 0; count *= 4, half /= 2)
    for (std::size_t i = count; i < 4 * count; ++i) {
      const GridSquare& from = squares[i % count];
      const std::size_t quarter = i / count;
      squares[i].column = static_cast<std::uint8_t>(from.column + (quarter & 1) * half);
      squares[i].row = static_cast<std::uint8_t>(from.row + (quarter >> 1) * half);
    }
  return squares;
}();

}  // namespace

bool ClearanceCandidate::takesAll() const {
  const bool above = std::all_of(floor.begin(), floor.end(), [](int s) { return s >= 0; });
  const bool below = std::all_of(ceiling.begin(), ceiling.end(), [](int s) { return s <= 0; });
  return coplanar || (above && below);
}

unsigned ClearanceCandidate::coveredCorners() const {
  unsigned covered = 0;
  for (unsigned j = 0; j < 3; ++j)
    if (corners[0][j] >= 0 && corners[1][j] >= 0 && corners[2][j] >= 0) covered |= 1U << j;
  return covered;
}

// A place that is a little way from corner 0 to corner 1, and much less towards corner 2.
bool ClearanceCandidate::coversStart() const {
  return std::all_of(corners.begin(), corners.end(), [](const Signs& s) {
    return (s[0] != 0 ? s[0] : s[1] != 0 ? s[1] : s[2]) > 0;
  });
}

Box clearanceBox(const SourceMesh& mesh, Index face, double height) {
  Box box = boxOf(mesh, face);
  box.upper[2] = std::nextafter(box.upper[2] + height, std::numeric_limits<double>::infinity());
  return box;
}

ClearanceCandidates::ClearanceCandidates(const PlanKernel& kernel, std::function<bool(Index)> isFloor, Index level,
                                         Poll poll)
    : kernel_(kernel),
      mesh_(kernel.mesh()),
      isFloor_(std::move(isFloor)),
      level_(level),
      height_(kernel.heights()[level - 1]),
      scaledHeight_(std::ldexp(height_, mesh_.grid.scaleExponent())),
      poll_(poll),
      closedCover_(mesh_) {
  exactOrientations_ = kernel.hasExactOrientations();
  exactTree_ = mesh_.tree.isExactOn(mesh_.grid);
  chooseHeights();
}

void ClearanceCandidates::begin(Index face) {
  face_ = face;
  dependsOnFloors_ = false;
  candidates_.clear();
  if (crowding_)
    crowding_->restart(face);
  else
    crowding_.emplace(mesh_, face);
  isCoverSought_ = areKnownToCover_ = false;
  coveredCorners_ = 0;
  whole_ = wholeWhenLast_ = 0;
  overlapInPlane_ = false;
  mayLeaveOut_ = true;
  openSquares_.reset();
  box_ = clearanceBox(mesh_, face, height_);
  const auto& f = mesh_.triangles[face];
  const auto& n = mesh_.normals[face];
  nx_ = n[0].value, ny_ = n[1].value, nz_ = n[2].value;
  ex_ = n[0].error, ey_ = n[1].error, ez_ = n[2].error;
  floorZ_ = mesh_.vertices[f[0]].z;
  isLevel_ = mesh_.vertices[f[1]].z == floorZ_ && mesh_.vertices[f[2]].z == floorZ_;
  if (heights_ == Heights::Integers && !isLevel_) beginIntegers();
  if (exactOrientations_)
    planEdges_ = PlanEdges(mesh_.scaled[f[0]], mesh_.scaled[f[1]], mesh_.scaled[f[2]]);
  else
    for (int k = 0; k < 3; ++k) edges_[k] = lineThrough(f[k], f[next(k)]);
  findEdgesInBox();
}

std::span<const ClearanceCandidate> ClearanceCandidates::find(Index face) {
  begin(face);
  if (!isTwin()) search(box_);
  findOpenSquares();
  return candidates_;
}

// Equal triangles follow each other. The one before this face takes all of it, if it is a floor.
bool ClearanceCandidates::isTwin() {
  if (face_ == 0 || mesh_.triangles[face_ - 1] != mesh_.triangles[face_]) return false;
  consider(face_ - 1);
  areKnownToCover_ = !candidates_.empty();
  return areKnownToCover_;
}

std::span<const ClearanceCandidate> ClearanceCandidates::findWithin(Index face, const Box& box) {
  begin(face);
  mayLeaveOut_ = false;
  Box part = box_;
  for (int axis = 0; axis < 2; ++axis) {
    part.lower[axis] = std::max(part.lower[axis], box.lower[axis]);
    part.upper[axis] = std::min(part.upper[axis], box.upper[axis]);
  }
  search(part, true);
  return candidates_;
}

std::span<const ClearanceCandidate> ClearanceCandidates::findAmong(Index face, std::span<const Index> obstacles) {
  begin(face);
  mayLeaveOut_ = false;
  isCoverSought_ = true;
  for (const Index obstacle : obstacles)
    if (!areKnownToCover_ && !onlyTouches(obstacle)) consider(obstacle);
  finish();
  return candidates_;
}

// An unknown obstacle that overlaps a level floor in the plan begins above the known clearance. Its corners can be
// anywhere above other floors.
std::span<const ClearanceCandidate> ClearanceCandidates::find(Index face, const std::vector<Index>& known,
                                                              double knownHeight) {
  begin(face);
  if (knownHeight < height_ && !isLevel_) {
    search(box_);
    findOpenSquares();
    return candidates_;
  }
  mayLeaveOut_ = false;
  isCoverSought_ = true;  // Obstacles found twice must not count twice.
  for (const Index obstacle : known)
    if (!areKnownToCover_ && !onlyTouches(obstacle)) consider(obstacle);
  if (knownHeight < height_ && !areKnownToCover_) {
    Box box = box_;
    box.lower[2] = std::nextafter(floorZ_ + knownHeight, -std::numeric_limits<double>::infinity());
    search(box);
    const auto isSame = [](const ClearanceCandidate& x, const ClearanceCandidate& y) {
      return x.obstacle == y.obstacle;
    };
    candidates_.erase(std::unique(candidates_.begin(), candidates_.end(), isSame), candidates_.end());
  } else {
    finish();
  }
  if (areKnownToCover_) return candidates_;
  crowding_->restart(face);
  for (const ClearanceCandidate& candidate : candidates_) crowding_->add(candidate.obstacle);
  areKnownToCover_ = crowding_->isCrowd() && proveCover();
  findOpenSquares();
  return candidates_;
}

// The face's own box may cross parts that the box of a part does not.
void ClearanceCandidates::search(const Box& box, bool isPart) {
  const auto take = [&](Index obstacle) {
    if ((++polls_ & 255) == 0) poll_();
    if (!onlyTouches(obstacle)) consider(obstacle);
    return !areKnownToCover_;
  };
  if (fans_ != nullptr && !isPart && fans_->contains(face_)) {
    fans_->visit(face_, box, stack_, take);
  } else if (exactTree_ && !isPart) {
    mesh_.tree.visitCrossing(box, stack_, [&](Index obstacle, bool crosses) {
      if ((++polls_ & 255) == 0) poll_();
      if (crosses || (mesh_.facing[obstacle] == 0 && !onlyTouches(obstacle))) consider(obstacle);
      return !areKnownToCover_;
    });
  } else if (isPart) {
    mesh_.tree.visitOverlapping(box, stack_, take);
  } else {
    const auto& [a, b, c] = mesh_.triangles[face_];
    // The plan is as quick to compare as boxes where doubles decide it, and leaves out more.
    const auto takeAny = [&](Index obstacle) {
      if (exactOrientations_)
        consider(obstacle);
      else
        take(obstacle);
      return !areKnownToCover_;
    };
    mesh_.tree.visitOver(std::array{mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]}, box, stack_, takeAny);
  }
  finish();
}

// Points and lines are numbered as they come, so the order of the tree must not show.
void ClearanceCandidates::finish() {
  findClosedCover();
  std::sort(candidates_.begin(), candidates_.end(),
            [](const ClearanceCandidate& x, const ClearanceCandidate& y) { return x.obstacle < y.obstacle; });
}

void ClearanceCandidates::consider(Index obstacle) {
  if ((++polls_ & 255) == 0) poll_();
  if (obstacle == face_) return;
  ClearanceCandidate candidate;
  candidate.obstacle = obstacle;
  // The plan is cheaper where doubles decide it, and leaves out more.
  if (exactOrientations_ && !findOverlap(candidate)) return;
  if (!findHeights(candidate)) return;
  if (candidate.coplanar && (mesh_.facing[obstacle] <= 0 || obstacle > face_)) return;
  if (isLeftOut(obstacle) || (!exactOrientations_ && !findOverlap(candidate))) return;
  if (candidate.coplanar) {
    dependsOnFloors_ = overlapInPlane_ = true;
    if (!isFloor_(obstacle)) return;
  }
  candidates_.push_back(candidate);
  findCover(candidate);
  if (areKnownToCover_) return;
  crowding_->add(obstacle);
  if (openSquares_) closeSquares(candidate);
  if (!crowding_->isCrowd()) return;
  if (!isCoverSought_) {
    isCoverSought_ = true;
    areKnownToCover_ = proveCover();
  }
  if (mayLeaveOut_) findOpenSquares();
}

// More candidates never make a cover less of one, so it does not matter when it is looked for. Floors in the face's own
// plane do not count: then the cover does not depend on floors.
void ClearanceCandidates::findCover(const ClearanceCandidate& candidate) {
  if (candidate.coplanar || mesh_.facing[candidate.obstacle] == 0 || !candidate.takesAll()) return;
  const unsigned corners = candidate.coveredCorners();
  coveredCorners_ |= corners;
  ++whole_;
  if (corners == ClearanceCandidate::kAllCorners)
    setCovered();
  else if (whole_ >= 4 * wholeWhenLast_)
    findClosedCover();
}

void ClearanceCandidates::findClosedCover() {
  if (areKnownToCover_ || coveredCorners_ != ClearanceCandidate::kAllCorners || whole_ == wholeWhenLast_) return;
  wholeWhenLast_ = whole_;
  if (closedCover_.covers(candidates_)) setCovered();
}

void ClearanceCandidates::setCovered() {
  areKnownToCover_ = true;
  dependsOnFloors_ = false;
}

// An obstacle that closes no open square is not needed: the same squares are open in the end with or without it, and
// obstacles that reach those are never left out. Cuts that depend on floors are never derived from known ones, so it is
// not missed later.
bool ClearanceCandidates::isLeftOut(Index obstacle) const {
  return openSquares_ && mesh_.facing[obstacle] != 0 &&
         !openSquares_->mayReach(outlineInPlan(kernel_, obstacle, mesh_.triangles[face_][0]));
}

void ClearanceCandidates::findOpenSquares() {
  if (openSquares_ || areKnownToCover_ || !overlapInPlane_ || !crowding_->isCrowd()) return;
  openSquares_.emplace(kernel_, face_);
  for (const ClearanceCandidate& candidate : candidates_) closeSquares(candidate);
}

void ClearanceCandidates::closeSquares(const ClearanceCandidate& candidate) {
  if (mesh_.facing[candidate.obstacle] != 0 && candidate.takesAll())
    openSquares_->cover(outlineInPlan(kernel_, candidate.obstacle, mesh_.triangles[face_][0]));
}

// Most floors of a deep crowd are covered many times over, and a few obstacles prove it. Squares are tested in a
// scattered order, so that floors with an open square are found soon.
bool ClearanceCandidates::proveCover() {
  const Index origin = mesh_.triangles[face_][0];
  const Vec3& base = mesh_.vertices[origin];
  OpenGrid grid(kernel_, face_);
  std::vector<std::int32_t> stack;
  for (const GridSquare& square : kSpreadSquares) {
    if (!grid.isOpen(square.column, square.row)) continue;
    const auto [x, y] = grid.middle(square.column, square.row);
    Box box = box_;
    box.lower[0] = box.upper[0] = base.x + std::ldexp(x, -mesh_.grid.scaleExponent());
    box.lower[1] = box.upper[1] = base.y + std::ldexp(y, -mesh_.grid.scaleExponent());
    mesh_.tree.visitOverlapping(box, stack, [&](Index obstacle) {
      if ((++polls_ & 255) == 0) poll_();
      if (obstacle == face_ || mesh_.facing[obstacle] == 0) return true;
      ClearanceCandidate candidate;
      candidate.obstacle = obstacle;
      if (!findHeights(candidate) || !candidate.takesAll()) return true;
      if (candidate.coplanar && (mesh_.facing[obstacle] < 0 || obstacle > face_)) return true;
      dependsOnFloors_ = dependsOnFloors_ || candidate.coplanar;
      if (!candidate.coplanar || isFloor_(obstacle)) grid.cover(outlineInPlan(kernel_, obstacle, origin));
      return grid.isOpen(square.column, square.row);
    });
    if (grid.isOpen(square.column, square.row)) return false;
    if (grid.isClosed()) return true;
  }
  return true;
}

ClearanceCandidates::Line ClearanceCandidates::lineThrough(Index from, Index to) const {
  const Vec3 &a = mesh_.scaled[from], &b = mesh_.scaled[to];
  return {from, to, a.x, a.y, b.x - a.x, b.y - a.y};
}

// The kernel's orientation, which doubles decide at once on a grid of few bits. A point above one of the ends is on the
// line.
int ClearanceCandidates::sideOf(const Line& line, Index vertex) {
  const Vec3& at = mesh_.scaled[vertex];
  const double left = line.dx * (at.y - line.y), right = line.dy * (at.x - line.x);
  const double value = left - right;
  // The bound is that of PlanKernel::orientation.
  const double bound = (std::fabs(left) + std::fabs(right)) * (6 * 0x1p-53) + kernel_.sign().slack;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  const auto& plan = mesh_.planIds;
  if (plan[vertex] == plan[line.from] || plan[vertex] == plan[line.to]) return 0;
  return kernel_.orientation(line.from, line.to, vertex, fallbacks);
}

PlanCorners ClearanceCandidates::cornersOf(Index triangle) const {
  const auto& t = mesh_.triangles[triangle];
  return {mesh_.scaled[t[0]], mesh_.scaled[t[1]], mesh_.scaled[t[2]]};
}

ThreeSigns ClearanceCandidates::filteredSides(const Line& line, Index triangle) {
  ThreeSigns sides;
  for (unsigned j = 0; j < 3; ++j) sides.set(j, sideOf(line, mesh_.triangles[triangle][j]));
  return sides;
}

// Some corner of the obstacle must lie strictly inside each edge of the face; a wall may also stand on the edge.
bool ClearanceCandidates::findOverlap(ClearanceCandidate& candidate) {
  const Index obstacle = candidate.obstacle;
  const bool isWall = mesh_.facing[obstacle] == 0;
  EdgeSides sides;
  const auto isOutside = [&](int k, const ThreeSigns& corners) {
    sides[static_cast<std::size_t>(k)] = corners;
    return corners.positive == 0 && (!isWall || hasTwo(corners.negative));
  };
  if (exactOrientations_) {
    const PlanCorners corners = cornersOf(obstacle);
    for (int k = 0; k < 3; ++k)
      if (isOutside(k, planEdges_.sidesOf(k, corners))) return false;
  } else {
    for (int k = 0; k < 3; ++k)
      if (isOutside(k, filteredSides(edges_[k], obstacle))) return false;
  }
  if (isWall ? isWallApart(obstacle) : isSeparated(candidate)) return false;
  setSigns(candidate.sides, sides);
  return true;
}

void ClearanceCandidates::findEdgesInBox() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto& f = mesh_.triangles[face_];
  const auto coordinate = [](const Vec3& v, int axis) { return axis == 0 ? v.x : v.y; };
  const std::array<const Vec3*, 3> corners{&mesh_.vertices[f[0]], &mesh_.vertices[f[1]], &mesh_.vertices[f[2]]};
  for (int axis = 0; axis < 2; ++axis)
    for (int upper = 0; upper < 2; ++upper) {
      const double side = upper != 0 ? box_.upper[axis] : box_.lower[axis];
      auto& range = edgesInBox_[axis][upper];
      range = {kInfinity, -kInfinity};
      for (int k = 0; k < 3; ++k) {
        const Vec3 &a = *corners[k], &b = *corners[next(k)];
        if (coordinate(a, axis) != side || coordinate(b, axis) != side) continue;
        const double u = coordinate(a, 1 - axis), v = coordinate(b, 1 - axis);
        range = {std::min(u, v), std::max(u, v)};
      }
    }
}

// Most neighbours of a floor meet it along an edge at most. Beside its box only a wall can matter, one that lies in a
// side of the box and stands on an edge there.
bool ClearanceCandidates::onlyTouches(Index obstacle) const {
  const auto& o = mesh_.triangles[obstacle];
  const Vec3 &a = mesh_.vertices[o[0]], &b = mesh_.vertices[o[1]], &c = mesh_.vertices[o[2]];
  const std::array<double, 2> low{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})};
  const std::array<double, 2> high{std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})};
  for (int axis = 0; axis < 2; ++axis) {
    const bool isBelow = high[axis] <= box_.lower[axis];
    if (!isBelow && low[axis] < box_.upper[axis]) continue;
    if (mesh_.facing[obstacle] != 0) return true;
    const double side = isBelow ? box_.lower[axis] : box_.upper[axis];
    const auto& [first, last] = edgesInBox_[axis][isBelow ? 0 : 1];
    if (low[axis] != side || high[axis] != side || high[1 - axis] <= first || low[1 - axis] >= last) return true;
  }
  return false;
}

// True when an edge of the obstacle has the whole face on its outer side.
bool ClearanceCandidates::isSeparated(ClearanceCandidate& candidate) {
  const auto& o = mesh_.triangles[candidate.obstacle];
  const bool isTurned = mesh_.facing[candidate.obstacle] < 0;
  EdgeSides sides;
  if (exactOrientations_) {
    const PlanEdges edges(mesh_.scaled[o[0]], mesh_.scaled[o[1]], mesh_.scaled[o[2]]);
    const PlanCorners corners = cornersOf(face_);
    for (int k = 0; k < 3; ++k) {
      ThreeSigns& signs = sides[static_cast<std::size_t>(k)] = edges.sidesOf(k, corners);
      if (isTurned) std::swap(signs.positive, signs.negative);
      if (signs.positive == 0) return true;
    }
  } else {
    for (int k = 0; k < 3; ++k) {
      const Line line = isTurned ? lineThrough(o[next(k)], o[k]) : lineThrough(o[k], o[next(k)]);
      const ThreeSigns& signs = sides[static_cast<std::size_t>(k)] = filteredSides(line, face_);
      if (signs.positive == 0) return true;
    }
  }
  setSigns(candidate.corners, sides);
  return false;
}

// A wall must not have the whole face strictly on one side, nor touch it in a corner only.
bool ClearanceCandidates::isWallApart(Index wall) {
  const auto& f = mesh_.triangles[face_];
  const auto& o = mesh_.triangles[wall];
  Index a = -1, b = -1;
  for (int k = 0; k < 3 && a < 0; ++k)
    if (mesh_.planIds[o[k]] != mesh_.planIds[o[next(k)]]) a = o[k], b = o[next(k)];
  const Line foot = lineThrough(a, b);
  ThreeSigns sides;
  for (unsigned j = 0; j < 3; ++j) sides.set(j, sideOf(foot, f[j]));
  return (sides.negative == 0 && hasTwo(sides.positive)) || (sides.positive == 0 && hasTwo(sides.negative));
}

}  // namespace footfall::detail
