// A straight way over the ground: a walk from triangle to triangle along a line in the plan, decided exactly.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <utility>

#include "core/base/poll.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/navigation/path_ground.hpp"
#include "core/navigation/plan_crossing.hpp"
#include "footfall/errors.hpp"
#include "footfall/ground.hpp"

namespace footfall {
using namespace detail;
namespace {

constexpr std::uint32_t kNone = SurfaceTopology::kNone;

/// The corner or the inside of the side at which a line leaves a triangle.
struct TriangleExit {
  bool isCorner = false;
  int index = 0;
};

double planDistance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y); }

class RayWalk {
 public:
  RayWalk(const PathGround& ground, const Vec3& from, const Vec3& to) : ground_(ground), from_(from), to_(to) {}

  GroundRay walk(const SurfacePlace& start, Poll poll) {
    ray_.start = ray_.end = start;
    std::uint32_t triangle = start.triangle;
    while (true) {
      poll();
      if (isOnGround(triangle)) ray_.triangles.push_back(triangle);
      if (holdsTarget(triangle)) {
        if (isOnGround(triangle)) endAt(triangle, to_, std::nullopt);
        ray_.reached = isOnGround(triangle);
        break;
      }
      const TriangleExit exit = exitOf(triangle);
      const std::uint32_t next =
          exit.isCorner ? beyondCorner(triangle, exit.index) : ground_.topology.neighbours[triangle][exit.index];
      // The place before a gap is the end until the ray is on ground again.
      if (isOnGround(triangle) && (next == kNone || !isOnGround(next))) leave(triangle, exit, next == kNone);
      if (next == kNone) break;
      triangle = next;
    }
    ray_.planLength = planDistance(ray_.start.position, ray_.end.position);
    ray_.end.distance = planDistance(ray_.end.position, to_);
    return std::move(ray_);
  }

 private:
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

  /// Whether the line goes on inside the triangle or along one of its sides, from its corner `i` on, which is on it.
  [[nodiscard]] bool goesOnFrom(std::uint32_t triangle, int i) const {
    return sideOf(triangle, (i + 1) % 3) <= 0 && sideOf(triangle, (i + 2) % 3) >= 0;
  }

  /// The triangle around a corner in which the line goes on, the first one on the left; kNone without any.
  [[nodiscard]] std::uint32_t beyondCorner(std::uint32_t triangle, int corner) const {
    for (const bool isLeft : {true, false}) {
      std::uint32_t t = triangle;
      int i = corner;
      while (true) {
        const int side = isLeft ? (i + 2) % 3 : i;
        const std::uint32_t next = ground_.topology.neighbours[t][static_cast<std::size_t>(side)];
        if (next == kNone || next == triangle) break;
        const int back = ground_.topology.sideBehind(t, side);
        t = next;
        i = isLeft ? back : (back + 1) % 3;
        if (goesOnFrom(t, i)) return t;
      }
    }
    return kNone;
  }

  void leave(std::uint32_t triangle, const TriangleExit& exit, bool isBorder) {
    const Vec3& first = corner(triangle, exit.index);
    if (exit.isCorner) {
      endAt(triangle, first, std::nullopt);
      return;
    }
    const auto i = static_cast<std::size_t>(exit.index);
    const Triangle& f = ground_.mesh->triangles[triangle];
    const Vec3& second = corner(triangle, (exit.index + 1) % 3);
    std::optional<std::array<std::uint32_t, 2>> border;
    if (isBorder) border = {f[i], f[(i + 1) % 3]};
    endAt(triangle, pointBetween(first, second, crossingParameter(from_, to_, first, second)), border);
  }

  void endAt(std::uint32_t triangle, const Vec3& place, std::optional<std::array<std::uint32_t, 2>> border) {
    ray_.end = ground_.places.placeInside(place, triangle);
    ray_.border = border;
  }

  const PathGround& ground_;
  Vec3 from_, to_;
  GroundRay ray_;
};

bool isFinite(const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace

std::optional<GroundRay> castRay(const PathFinder& finder, const Vec3& from, const Vec3& to, double reach,
                                 const RunContext* context) {
  if (!isFinite(from) || !isFinite(to))
    throw InputError(FOOTFALL_TEXT("the place has a coordinate that is not finite; give three numbers"));
  const PathGround& ground = *finder.inside();
  const std::optional<SurfacePlace> start = ground.places.locate(from, reach);
  if (!start) return std::nullopt;
  return RayWalk(ground, start->position, to).walk(*start, Poll(context));
}

}  // namespace footfall
