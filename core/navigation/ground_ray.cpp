// A straight way over the ground: a walk from triangle to triangle along a line in the plan, decided exactly.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/base/poll.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/navigation/path_ground.hpp"
#include "core/navigation/plan_crossing.hpp"
#include "core/navigation/plan_distance.hpp"
#include "footfall/errors.hpp"
#include "footfall/ground.hpp"

namespace footfall {
using namespace detail;
namespace {

/// The corner or the inside of the side at which a line leaves a triangle.
struct TriangleExit {
  bool isCorner = false;
  int index = 0;
};

class RayWalk {
 public:
  RayWalk(const PathGround& ground, const Vec3& from, const Vec3& to) : ground_(ground), from_(from), to_(to) {}

  GroundRay walk(const SurfacePlace& start, Poll poll) {
    Branch farthest{start.triangle, kNoNode, start, std::nullopt};
    double most = -1;
    branches_.push_back({start.triangle, kNoNode, start, std::nullopt});
    while (!branches_.empty() && !isReached_) {
      Branch branch = branches_.back();
      branches_.pop_back();
      if (!follow(branch, poll)) continue;
      const double length = planDistance(start.position, branch.end.position);
      if (!isReached_ && length <= most) continue;
      most = length;
      farthest = branch;
    }
    GroundRay ray{start, farthest.end, isReached_, std::max(most, 0.0), farthest.border, {}};
    ray.end.distance = planDistance(ray.end.position, to_);
    for (std::size_t node = farthest.node; node != kNoNode; node = nodes_[node].before)
      ray.triangles.push_back(nodes_[node].triangle);
    std::reverse(ray.triangles.begin(), ray.triangles.end());
    return ray;
  }

 private:
  static constexpr std::size_t kNoNode = static_cast<std::size_t>(-1);

  /// A way along the line that is followed. Two of them lead along both sides of a wall that stands on the line.
  struct Branch {
    std::uint32_t triangle = 0;  ///< the next one
    std::size_t node = kNoNode;  ///< the last one on the ground
    SurfacePlace end;            ///< the last place on the ground
    std::optional<std::array<std::uint32_t, 2>> border;
  };
  struct Node {
    std::uint32_t triangle = 0;
    std::size_t before = kNoNode;
  };

  /// Follows a branch to its end. False where it leads into a triangle that was passed already, from which all ways are
  /// the same.
  bool follow(Branch& branch, Poll poll) {
    while (true) {
      poll();
      const std::uint32_t triangle = branch.triangle;
      if (!passed_.insert(triangle).second) return false;
      const bool isGround = isOnGround(triangle);
      if (isGround) {
        nodes_.push_back({triangle, branch.node});
        branch.node = nodes_.size() - 1;
      }
      if (holdsTarget(triangle)) {
        if (isGround) endAt(branch, to_, std::nullopt);
        isReached_ = isGround;
        return true;
      }
      const TriangleExit exit = exitOf(triangle);
      const std::uint32_t next = exit.isCorner
                                     ? beyondCorner(triangle, exit.index, true)
                                     : ground_.topology.neighbours[triangle][static_cast<std::size_t>(exit.index)];
      // The place before a gap is the end until the ray is on ground again.
      if (isGround && (exit.isCorner || next == kNoElement || !isOnGround(next)))
        leave(branch, exit, next == kNoElement);
      if (next == kNoElement) return true;
      if (exit.isCorner) {
        const std::uint32_t other = beyondCorner(triangle, exit.index, false);
        if (other != kNoElement && other != next) branches_.push_back({other, branch.node, branch.end, branch.border});
      }
      branch.triangle = next;
    }
  }

  /// Triangles behind those of the mesh are bridges over gaps.
  [[nodiscard]] bool isOnGround(std::uint32_t triangle) const { return triangle < ground_.mesh->triangles.size(); }
  [[nodiscard]] const Vec3& corner(std::uint32_t triangle, int i) const {
    return ground_.surface->vertices[ground_.surface->triangles[triangle][static_cast<std::size_t>(i)]];
  }
  /// +1: left of the ray's line.
  [[nodiscard]] int sideOf(std::uint32_t triangle, int i) const { return facing(from_, to_, corner(triangle, i)); }

  [[nodiscard]] bool holdsTarget(std::uint32_t triangle) const {
    const Vec3 &a = corner(triangle, 0), &b = corner(triangle, 1), &c = corner(triangle, 2);
    return facing(a, b, to_) >= 0 && facing(b, c, to_) >= 0 && facing(c, a, to_) >= 0;
  }

  /// The triangle has a place on the line. Where that is one corner only, it is the exit.
  [[nodiscard]] TriangleExit exitOf(std::uint32_t triangle) const {
    const int sides[3] = {sideOf(triangle, 0), sideOf(triangle, 1), sideOf(triangle, 2)};
    int touched = 0;
    for (int i = 0; i < 3; ++i) {
      const int next = sides[(i + 1) % 3], before = sides[(i + 2) % 3];
      if (sides[i] < 0 && next > 0) return {false, i};
      if (sides[i] != 0) continue;
      if (next >= 0 && before <= 0) return {true, i};
      touched = i;
    }
    return {true, touched};
  }

  /// Returns whether the line goes on inside the triangle or along one of its sides, from its corner `i`, which is on
  /// the line.
  [[nodiscard]] bool goesOnFrom(std::uint32_t triangle, int i) const {
    return sideOf(triangle, (i + 1) % 3) <= 0 && sideOf(triangle, (i + 2) % 3) >= 0;
  }

  /// The first triangle around a corner in which the line goes on, turning around it counter-clockwise or, where that
  /// leads to a border, clockwise; or the other way round. kNoElement without any.
  [[nodiscard]] std::uint32_t beyondCorner(std::uint32_t triangle, int corner, bool isCounterClockwise) const {
    for (const bool isLeft : {isCounterClockwise, !isCounterClockwise}) {
      std::uint32_t t = triangle;
      int i = corner;
      while (true) {
        const int side = isLeft ? (i + 2) % 3 : i;
        const std::uint32_t next = ground_.topology.neighbours[t][static_cast<std::size_t>(side)];
        if (next == kNoElement || next == triangle) break;
        const int back = ground_.topology.sideBehind(t, side);
        t = next;
        i = isLeft ? back : (back + 1) % 3;
        if (goesOnFrom(t, i)) return t;
      }
    }
    return kNoElement;
  }

  void leave(Branch& branch, const TriangleExit& exit, bool isBorder) const {
    const std::uint32_t triangle = branch.triangle;
    const Vec3& first = corner(triangle, exit.index);
    if (exit.isCorner) {
      endAt(branch, first, std::nullopt);
      return;
    }
    const auto i = static_cast<std::size_t>(exit.index);
    const Triangle& f = ground_.mesh->triangles[triangle];
    const Vec3& second = corner(triangle, (exit.index + 1) % 3);
    std::optional<std::array<std::uint32_t, 2>> border;
    if (isBorder) border = {f[i], f[(i + 1) % 3]};
    endAt(branch, pointBetween(first, second, crossingParameter(from_, to_, first, second)), border);
  }

  void endAt(Branch& branch, const Vec3& place, std::optional<std::array<std::uint32_t, 2>> border) const {
    branch.end = ground_.places.placeInside(place, branch.triangle);
    branch.border = border;
  }

  const PathGround& ground_;
  Vec3 from_, to_;
  std::vector<Branch> branches_;
  std::vector<Node> nodes_;
  std::unordered_set<std::uint32_t> passed_;
  bool isReached_ = false;
};

/// Returns whether a point lies in a triangle or on its border, in the plan.
bool liesIn(const NavigationMesh& surface, std::uint32_t triangle, const Vec3& point) {
  const Triangle& corners = surface.triangles[triangle];
  for (std::size_t i = 0; i < 3; ++i)
    if (facing(surface.vertices[corners[i]], surface.vertices[corners[(i + 1) % 3]], point) < 0) return false;
  return true;
}

void checkFinite(std::initializer_list<Vec3> places) {
  for (const Vec3& p : places)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw InputError(FOOTFALL_TEXT("the place has a coordinate that is not finite; give three numbers"));
}

}  // namespace

std::optional<GroundRay> castRay(const PathFinder& finder, const Vec3& from, const Vec3& to, double reach,
                                 const RunContext* context) {
  checkFinite({from, to});
  const PathGround& ground = *finder.inside();
  const std::optional<SurfacePlace> start = ground.places.locate(from, reach);
  if (!start) return std::nullopt;
  return RayWalk(ground, start->position, to).walk(*start, Poll(context));
}

GroundRay castRayFrom(const PathFinder& finder, const SurfacePlace& start, const Vec3& to, const RunContext* context) {
  checkFinite({start.position, to});
  const PathGround& ground = *finder.inside();
  if (start.triangle >= ground.mesh->triangles.size())
    throw InputError(FOOTFALL_TEXT("there is no triangle %1; the mesh has %2"), start.triangle,
                     ground.mesh->triangles.size());
  if (!liesIn(*ground.surface, start.triangle, start.position))
    throw InputError(FOOTFALL_TEXT("the place does not lie in triangle %1; give a place of this mesh"), start.triangle);
  return RayWalk(ground, start.position, to).walk(start, Poll(context));
}

}  // namespace footfall
