// The reasons why a place is walkable or not, from the inspector and from the definitions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/number_text.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/errors.hpp"
#include "footfall/inspect.hpp"
#include "tests/reference/walkable_area.hpp"
#include "tests/support/run_filters.hpp"

namespace footfall::test {
using namespace detail;

using reference::Linear;
using reference::Point2;
using reference::Rational;

using EnvironmentPtr = std::shared_ptr<const Environment>;

struct Inspected {
  RunResult result;
  std::unique_ptr<Inspector> inspector;
};

inline Inspected inspect(const EnvironmentPtr& environment, const std::string& filters) {
  const Pipeline pipeline = parsePipeline(filters, "test");
  RunContext context;
  ResultCache cache;
  Inspected made;
  made.result = runPipeline(environment, pipeline, context, &cache);
  made.inspector = std::make_unique<Inspector>(environment, pipeline, made.result.mesh, &cache, &context);
  return made;
}

inline PlaceExplanation explain(const Inspected& inspected, std::uint32_t triangle, const Vec3& point) {
  RunContext context;
  return inspected.inspector->explain({triangle, point}, &context);
}

/// The limits of an agent, as a pipeline of the four filters that reject.
struct Limits {
  double slope = 45, clearance = 2, area = 0;

  [[nodiscard]] std::string pipeline() const {
    std::string text = "DuplicationFilter 0\nDegeneracyFilter\n" + minimalPipeline(clearance, slope) + "AreaFilter ";
    appendNumber(text, area);
    return text + "\nSimplificationFilter\nLayerSubdivisionFilter\n";
  }
};
constexpr std::size_t kSlopeStep = 2, kClearanceStep = 3, kAreaStep = 4;

struct Expected {
  PlaceVerdict verdict = PlaceVerdict::Walkable;
  std::optional<std::size_t> step;
  std::optional<std::uint32_t> obstacle;  ///< TooLow
  std::optional<Rational> above;          ///< nothing: unlimited
};

inline bool contains(const reference::Polygon& polygon, const Point2& place) {
  for (std::size_t k = 0; k < polygon.size(); ++k)
    if (turn(polygon[k], polygon[(k + 1) % polygon.size()], place) < 0) return false;
  return !polygon.empty();
}

/// The area in space of the connected part that a free place belongs to.
inline double partArea(const Environment& environment, const Limits& limits, const Linear& plane, const Point2& place) {
  const auto area = reference::computeWalkableArea(environment, {limits.slope, limits.clearance});
  const auto parts = reference::connectedParts(area, reference::findMeetings(area));
  std::vector<double> areas(parts.size(), 0);
  std::size_t cell = 0, found = parts.size();
  for (const auto& region : area.regions) {
    const double steepness =
        std::sqrt(Rational(1 + region.plane.a * region.plane.a + region.plane.b * region.plane.b).get_d());
    for (const auto& polygon : region.cells) {
      if (region.plane == plane && contains(polygon, place)) found = parts[cell];
      areas[parts[cell]] += Rational(reference::twiceArea(polygon) / 2).get_d() * steepness;
      ++cell;
    }
  }
  return areas.at(found);
}

/// Straight from the definitions, for a place that is on no edge's plan. Empty where the area is too close to call.
inline std::optional<Expected> expect(const Environment& environment, const Limits& limits, std::uint32_t triangle,
                                      const Point2& place) {
  const Linear plane = *reference::planeThrough(reference::cornersOf(environment, triangle));
  Expected expected;
  bool facesUp = false;
  std::optional<std::array<reference::Point3, 3>> floor;
  for (std::uint32_t t = 0; t < environment.triangles.size(); ++t) {
    // Far away in plain numbers?
    const Triangle& corners = environment.triangles[t];
    const Vec3 &a = environment.vertices[corners[0]], &b = environment.vertices[corners[1]],
               &c = environment.vertices[corners[2]];
    const double x = place.x.get_d(), y = place.y.get_d(), slack = 1e-6 * (1 + std::fabs(x) + std::fabs(y));
    if (x < std::min({a.x, b.x, c.x}) - slack || x > std::max({a.x, b.x, c.x}) + slack ||
        y < std::min({a.y, b.y, c.y}) - slack || y > std::max({a.y, b.y, c.y}) + slack)
      continue;
    const auto exact = reference::cornersOf(environment, t);
    if (!contains(reference::planTriangle(exact), place)) continue;
    const auto other = reference::planeThrough(exact);
    const Rational height = other->at(place) - plane.at(place);
    if (*other == plane) {
      if (const auto up = reference::upwardCorners(environment, t)) facesUp = true, floor = up;
    } else if (height > 0 && (!expected.above || height < *expected.above)) {
      expected.above = height;
      expected.obstacle = t;
    }
  }
  const auto reject = [&](PlaceVerdict verdict, std::optional<std::size_t> step) {
    expected.verdict = verdict;
    expected.step = step;
    if (verdict != PlaceVerdict::TooLow) expected.obstacle.reset();
    return expected;
  };
  if (!facesUp) return reject(PlaceVerdict::FacesDown, std::nullopt);
  if (!reference::isWithinSlope(*floor, limits.slope)) return reject(PlaceVerdict::TooSteep, kSlopeStep);
  if (expected.above && *expected.above < Rational(limits.clearance))
    return reject(PlaceVerdict::TooLow, kClearanceStep);
  if (limits.area > 0) {
    const double area = partArea(environment, limits, plane, place);
    if (std::fabs(area - limits.area) < 1e-9 * (area + limits.area)) return std::nullopt;
    if (area < limits.area) return reject(PlaceVerdict::RegionTooSmall, kAreaStep);
  }
  return reject(PlaceVerdict::Walkable, std::nullopt);
}

/// A place of a triangle that has an area in the plan, by three numbers of any size above 0.
inline Vec3 placeOn(const Environment& environment, std::uint32_t triangle, const std::array<double, 3>& weights) {
  const double sum = weights[0] + weights[1] + weights[2];
  Vec3 place;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& p = environment.vertices[environment.triangles[triangle][k]];
    place = {place.x + weights[k] / sum * p.x, place.y + weights[k] / sum * p.y, place.z + weights[k] / sum * p.z};
  }
  return place;
}

/// True when no edge passes above or below, and the place is inside the triangle.
inline bool isGeneric(const Environment& environment, std::uint32_t triangle, const Vec3& place) {
  const Point2 p{place.x, place.y};
  if (!contains(reference::planTriangle(reference::cornersOf(environment, triangle)), p)) return false;
  for (const Triangle& t : environment.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = environment.vertices[t[k]], &b = environment.vertices[t[(k + 1) % 3]];
      const double side = (b.x - a.x) * (place.y - a.y) - (b.y - a.y) * (place.x - a.x);
      const double size = (std::fabs(b.x - a.x) + std::fabs(b.y - a.y)) *
                          (std::fabs(place.x) + std::fabs(place.y) + std::fabs(a.x) + std::fabs(a.y));
      if (std::fabs(side) > 1e-12 * size) continue;
      if (!(a.x == b.x && a.y == b.y) && turn(Point2{a.x, a.y}, Point2{b.x, b.y}, p) == 0) return false;
    }
  return true;
}

/// True when the product covers a place of a plane; empty when rounding decides.
inline std::optional<bool> isCovered(const Environment& environment, const NavigationMesh& mesh, std::uint32_t triangle,
                                     const Vec3& place) {
  const Linear plane = *reference::planeThrough(reference::cornersOf(environment, triangle));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.vertices[mesh.triangles[t][k]];
    double least = std::numeric_limits<double>::infinity(), size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = p[k], &b = p[(k + 1) % 3];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      least = std::min(least, ((b.x - a.x) * (place.y - a.y) - (b.y - a.y) * (place.x - a.x)) / length);
      size = std::max({size, length, std::fabs(a.x), std::fabs(a.y)});
    }
    if (least < -1e-9 * size) continue;
    if (*reference::planeThrough(reference::cornersOf(environment, mesh.sourceTriangles[t])) != plane) continue;
    if (least < 1e-9 * size) return std::nullopt;
    return true;
  }
  return false;
}

/// Compares one place; returns false after a message.
inline bool agrees(const PlaceExplanation& told, const Expected& expected) {
  if (told.verdict != expected.verdict || told.step != expected.step) return false;
  if (told.above.has_value() != expected.above.has_value()) return false;
  if (told.above && std::fabs(told.above->height - expected.above->get_d()) > 1e-12 * told.above->height) return false;
  if (told.obstacle.has_value() != expected.obstacle.has_value()) return false;
  return !told.obstacle || told.obstacle->height == told.above->height;
}

}  // namespace footfall::test
