// Why a place is walkable or not: known rooms, and thousands of random places against the definitions, one by one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/base/number_text.hpp"
#include "core/io/import.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/errors.hpp"
#include "footfall/inspect.hpp"
#include "tests/reference/walkable_area.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using reference::Linear;
using reference::Point2;
using reference::Rational;

using EnvironmentPtr = std::shared_ptr<const Environment>;

struct Inspected {
  RunResult result;
  std::unique_ptr<Inspector> inspector;
};

Inspected inspect(const EnvironmentPtr& environment, const std::string& filters) {
  const Pipeline pipeline = parsePipeline(filters, "test");
  RunContext context;
  ResultCache cache;
  Inspected made;
  made.result = runPipeline(environment, pipeline, context, &cache);
  made.inspector = std::make_unique<Inspector>(environment, pipeline, made.result.mesh, &cache, &context);
  return made;
}

PlaceExplanation explain(const Inspected& inspected, std::uint32_t triangle, const Vec3& point) {
  RunContext context;
  return inspected.inspector->explain({triangle, point}, &context);
}

/// What is asked of an agent; as a pipeline of the four filters that reject.
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

bool contains(const reference::Polygon& polygon, const Point2& place) {
  for (std::size_t k = 0; k < polygon.size(); ++k)
    if (turn(polygon[k], polygon[(k + 1) % polygon.size()], place) < 0) return false;
  return !polygon.empty();
}

/// The area in space of the connected part that a free place belongs to.
double partArea(const Environment& environment, const Limits& limits, const Linear& plane, const Point2& place) {
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
std::optional<Expected> expect(const Environment& environment, const Limits& limits, std::uint32_t triangle,
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
Vec3 placeOn(const Environment& environment, std::uint32_t triangle, const std::array<double, 3>& weights) {
  const double sum = weights[0] + weights[1] + weights[2];
  Vec3 place;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& p = environment.vertices[environment.triangles[triangle][k]];
    place = {place.x + weights[k] / sum * p.x, place.y + weights[k] / sum * p.y, place.z + weights[k] / sum * p.z};
  }
  return place;
}

/// Whether no edge passes above or below, and the place is inside the triangle.
bool isGeneric(const Environment& environment, std::uint32_t triangle, const Vec3& place) {
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

/// Whether the product covers a place of a plane; empty where rounding decides.
std::optional<bool> isCovered(const Environment& environment, const NavigationMesh& mesh, std::uint32_t triangle,
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

/// Compares one place; false says what is wrong.
bool agrees(const PlaceExplanation& told, const Expected& expected) {
  if (told.verdict != expected.verdict || told.step != expected.step) return false;
  if (told.above.has_value() != expected.above.has_value()) return false;
  if (told.above && std::fabs(told.above->height - expected.above->get_d()) > 1e-12 * told.above->height) return false;
  if (told.obstacle.has_value() != expected.obstacle.has_value()) return false;
  return !told.obstacle || told.obstacle->height == told.above->height;
}

}  // namespace

class TestInspection : public QObject {
  Q_OBJECT
 private slots:
  void walkableFloor() {
    const auto room = Soup().floor(0, 0, 4, 4, 0).ceiling(0, 0, 4, 4, 3).floor(10, 0, 11, 1, 0).environment();
    const Inspected run = inspect(room, Limits{}.pipeline());
    const PlaceExplanation place = explain(run, 0, {2, 1, 0});
    QVERIFY(place.verdict == PlaceVerdict::Walkable && !place.step);
    QCOMPARE(place.slope, 0.0);
    QVERIFY(place.above && place.above->height == 3 && place.above->triangle >= 2);
    QVERIFY(place.layer && *place.layer == 0);
    QCOMPARE(place.component, 0U);
    QCOMPARE(place.componentArea, 16.0);
    const PlaceExplanation small = explain(run, 4, {10.5, 0.25, 0});
    QVERIFY(small.verdict == PlaceVerdict::Walkable && !small.above && small.component == 1);
    const PlaceExplanation ceiling = explain(run, 2, {2, 1, 3});
    QVERIFY(ceiling.verdict == PlaceVerdict::FacesDown && !ceiling.step);
    QCOMPARE(ceiling.slope, 180.0);
  }

  void everyFilterThatRejects() {
    const auto room = Soup()
                          .floor(0, 0, 8, 4, 0)
                          .ceiling(0, 0, 4, 4, 1.5)   // 2, 3: a low half
                          .ceiling(0, 0, 1, 4, 1.25)  // 4, 5: and lower still
                          .ramp(20, 0, 22, 2, 0, 3)   // 6, 7
                          .floor(30, 0, 30.5, 1, 2)   // 8, 9
                          .wall(6, 0, 6, 2, 0, 3)     // 10, 11
                          .triangle({50, 0, 0}, {51, 0, 0}, {52, 0, 0})
                          .environment();
    const Inspected run = inspect(room, Limits{45, 2, 1}.pipeline());
    const PlaceExplanation low = explain(run, 0, {3, 0.5, 0});
    QVERIFY(low.verdict == PlaceVerdict::TooLow && low.step == kClearanceStep && low.limit == 2);
    QVERIFY(low.obstacle && (low.obstacle->triangle == 2 || low.obstacle->triangle == 3));
    QCOMPARE(low.obstacle->height, 1.5);
    const PlaceExplanation lowest = explain(run, 0, {0.75, 0.25, 0});
    QVERIFY(lowest.obstacle && (lowest.obstacle->triangle == 4 || lowest.obstacle->triangle == 5));
    QVERIFY(explain(run, 0, {5, 1, 0}).verdict == PlaceVerdict::Walkable);

    const PlaceExplanation steep = explain(run, 6, {21, 0.5, 1.5});
    QVERIFY(steep.verdict == PlaceVerdict::TooSteep && steep.step == kSlopeStep && steep.limit == 45);
    QVERIFY(std::fabs(steep.slope - 56.30993247402021) < 1e-9 && !steep.movedSlope);
    const PlaceExplanation ledge = explain(run, 8, {30.25, 0.125, 2});
    QVERIFY(ledge.verdict == PlaceVerdict::RegionTooSmall && ledge.step == kAreaStep && ledge.limit == 1);
    QCOMPARE(ledge.regionArea, 0.5);
    const PlaceExplanation wall = explain(run, 10, {6, 1, 1});
    QVERIFY(wall.verdict == PlaceVerdict::Vertical && !wall.step);
    QCOMPARE(wall.slope, 90.0);
    const PlaceExplanation line = explain(run, 12, {51, 0, 0});
    QVERIFY(line.verdict == PlaceVerdict::NoArea && line.step == std::size_t{1});
  }

  // Exactly at the limit; the double that is shown must not decide.
  void limitsAreExact() {
    const auto level = Soup().floor(0, 0, 4, 4, 0.1).ceiling(0, 0, 4, 4, 2.1).ramp(10, 0, 13, 3, 0, 3).environment();
    const Inspected run = inspect(level, Limits{}.pipeline());
    QVERIFY(explain(run, 4, {11, 0.5, 1}).verdict == PlaceVerdict::Walkable);
    // 2.1 - 0.1 is 2 in doubles, and less than 2 in truth.
    const Rational truth = Rational(2.1) - Rational(0.1);
    QVERIFY(truth != 2);
    QCOMPARE(explain(run, 0, {2, 1, 0.1}).verdict == PlaceVerdict::TooLow, truth < 2);
  }

  void placesOnEdgesMeanTheAreaBeside() {
    const auto room = Soup().floor(0, 0, 4, 4, 0).ceiling(2, 0, 4, 4, 1).environment();
    const Inspected run = inspect(room, Limits{}.pipeline());
    // On the diagonal of floor and ceiling, on the outline of the ceiling's shadow, in corners.
    QVERIFY(explain(run, 0, {3, 3, 0}).verdict == PlaceVerdict::TooLow);
    QVERIFY(explain(run, 1, {1, 1, 0}).verdict == PlaceVerdict::Walkable);
    QVERIFY(explain(run, 1, {2, 2, 0}).verdict == PlaceVerdict::Walkable);  // towards (4/3, 8/3)
    QVERIFY(explain(run, 0, {2, 1, 0}).verdict == PlaceVerdict::TooLow);    // towards (8/3, 4/3)
    QVERIFY(explain(run, 0, {0, 0, 0}).verdict == PlaceVerdict::Walkable);
    QVERIFY(explain(run, 0, {4, 0, 0}).verdict == PlaceVerdict::TooLow);
    // Beside the triangle, as a ray's rounding puts it.
    QVERIFY(explain(run, 0, {4.0000000001, 2, 0}).verdict == PlaceVerdict::TooLow);
    QVERIFY(explain(run, 0, {0, 0.00001, 0.1}).verdict == PlaceVerdict::Walkable);
  }

  void wallsOnTheSpotAreNamed() {
    const auto room = Soup().floor(0, 0, 4, 4, 0).wall(2, 0, 2, 4, 0, 3).wall(3, 0, 3, 4, 2, 3).environment();
    const Inspected run = inspect(room, Limits{}.pipeline());
    const PlaceExplanation place = explain(run, 0, {2, 1, 0});
    QVERIFY(place.verdict == PlaceVerdict::Walkable);
    QVERIFY((place.walls == std::vector<std::uint32_t>{2, 3}) || (place.walls == std::vector<std::uint32_t>{2}) ||
            (place.walls == std::vector<std::uint32_t>{3}));
    QVERIFY(explain(run, 0, {2.5, 1, 0}).walls.empty());
    QVERIFY(explain(run, 0, {3, 1, 0}).walls.empty());  // begins at the clearance
    QVERIFY(explain(inspect(room, "SlopeFilter 45"), 0, {2, 1, 0}).walls.empty());
  }

  void anotherTriangleOfThePlane() {
    // A floor with a second one in its plane, and a zero-thickness slab.
    const auto level =
        Soup().floor(0, 0, 4, 4, 0).floor(1, 1, 3, 3, 0).floor(10, 0, 12, 2, 3).ceiling(10, 0, 12, 2, 3).environment();
    const Inspected run = inspect(level, Limits{}.pipeline());
    for (const std::uint32_t triangle : {0U, 1U, 2U, 3U})
      QVERIFY(explain(run, triangle, {2.25, 1.75, 0}).verdict == PlaceVerdict::Walkable);
    const PlaceExplanation below = explain(run, 6, {11.5, 0.5, 3});
    QVERIFY(below.verdict == PlaceVerdict::Walkable && below.floor && (*below.floor == 4 || *below.floor == 5));
    QVERIFY(!explain(run, 4, {11.5, 0.25, 3}).floor);
  }

  void obstaclesOnly() {
    const auto level = Soup().floor(0, 0, 4, 4, 0).floor(10, 0, 14, 4, 0).environment();
    level->obstacleOnly = {1, 1, 0, 0};
    const Inspected run = inspect(level, Limits{}.pipeline());
    const PlaceExplanation marked = explain(run, 0, {3, 1, 0});
    QVERIFY(marked.verdict == PlaceVerdict::NeverFloor && !marked.step);
    QVERIFY(explain(run, 2, {13, 1, 0}).verdict == PlaceVerdict::Walkable);
  }

  void orderOfTheFilters() {
    const auto level = Soup().ramp(0, 0, 1, 1, 0, 3).ceiling(0, 0, 1, 1, 3.5).environment();
    const auto stepOf = [&](const std::string& filters) {
      return explain(inspect(level, filters), 0, {0.75, 0.25, 2.25}).step;
    };
    QVERIFY(stepOf("SlopeFilter 45\nVerticalClearanceFilter 2") == std::size_t{0});
    QVERIFY(stepOf("VerticalClearanceFilter 2\nSlopeFilter 45") == std::size_t{0});
    QVERIFY(stepOf("AreaFilter 9\nVerticalClearanceFilter 2\nSlopeFilter 45") == std::size_t{0});
    QVERIFY(stepOf("SlopeFilter 80\nVerticalClearanceFilter 1\nVerticalClearanceFilter 2\nAreaFilter 9") ==
            std::size_t{2});
    QVERIFY(stepOf("SlopeFilter 80") == std::nullopt);
    QVERIFY(stepOf("") == std::nullopt);
  }

  // Disabled steps keep their numbers, and those of a parallel block are told apart.
  void stepsOfTheList() {
    const auto level = Soup().floor(0, 0, 4, 4, 0).ceiling(0, 0, 2, 4, 1).ramp(10, 0, 11, 1, 0, 3).environment();
    Pipeline pipeline = parsePipeline(
        "AreaFilter 99\nDegeneracyFilter\nGridStrategy 2 2\nSlopeFilter 45\nVerticalClearanceFilter 2\nRoundingFilter\n"
        "Collapse\nLayerSubdivisionFilter",
        "test");
    pipeline.steps[0].enabled = false;
    RunContext context;
    ResultCache cache;
    const RunResult result = runPipeline(level, pipeline, context, &cache);
    for (const bool fresh : {false, true}) {
      if (fresh) cache.clear();
      const auto states = stepStates(level, pipeline, context, cache);
      QCOMPARE(states.size(), std::size_t{8});
      const Inspector inspector(level, pipeline, result.mesh, fresh ? nullptr : &cache, &context);
      QVERIFY(inspector.explain({0, {1, 0.5, 0}}, &context).step == std::size_t{4});
      QVERIFY(inspector.explain({4, {10.5, 0.25, 1.5}}, &context).step == std::size_t{3});
      QVERIFY(inspector.explain({0, {3, 0.5, 0}}, &context).verdict == PlaceVerdict::Walkable);
    }
  }

  // The states are those that the filters give one after the other.
  void statesOfSteps() {
    const auto level = buildingOf({{0, 0, 0, 9, 9, 0, 0}, {5, 1, 1, 1, 1, 1, 1}, {4, 2, 1, 3, 2, 0, 2}}).environment();
    const std::string filters =
        "DegeneracyFilter\nAutoStrategy\nSlopeFilter 45\nVerticalClearanceFilter 1.5\nCollapse\n"
        "AreaFilter 1\nRoundingFilter";
    const Pipeline pipeline = parsePipeline(filters, "test");
    RunContext context;
    ResultCache cache;
    runPipeline(level, pipeline, context, &cache);
    const auto states = stepStates(level, pipeline, context, cache);
    QCOMPARE(states.size(), pipeline.steps.size() + 1);
    StatePtr state = makeInitialState(level, context);
    const auto same = [](const StateSummary& a, const StateSummary& b) {
      return a.triangles == b.triangles && a.area == b.area && a.rejected == b.rejected &&
             a.obstacleEdges == b.obstacleEdges;
    };
    for (std::size_t i = 0; i < pipeline.steps.size(); ++i) {
      const PipelineStep& step = pipeline.steps[i];
      if (step.filter->kind == FilterKind::Filter) state = applyFilter(*step.filter, step.values, state, context).state;
      QVERIFY(same(summarize(*states[i + 1]), summarize(*state)));
    }
    ResultCache small(1);
    const auto again = stepStates(level, pipeline, context, small);
    QVERIFY(same(summarize(*again.back()), summarize(*state)));
    QVERIFY_EXCEPTION_THROWN(
        stepStates(level, Pipeline{{{&filterDescriptor(FilterType::Collapse), {}}}}, context, cache), InputError);
    context.cancel();
    QVERIFY_EXCEPTION_THROWN(stepStates(level, pipeline, context, cache), Cancelled);
  }

  void movedVertices() {
    const auto level = Soup()
                           .floor(0, 0, 4, 4, 0)
                           .floor(4.05, 0, 8, 4, 0.02)
                           .floor(20, 0, 20.05, 4, 0)  // closes when vertices 0.1 apart become one
                           .ceiling(5, 0, 6, 4, 1)
                           .environment();
    const Inspected run = inspect(
        level, "DuplicationFilter 0.1\nDegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nRoundingFilter");
    QVERIFY(explain(run, 0, {3, 1, 0}).verdict == PlaceVerdict::Walkable);
    QVERIFY(explain(run, 2, {7, 1, 0.02}).verdict == PlaceVerdict::Walkable);
    const PlaceExplanation gone = explain(run, 4, {20.02, 0.5, 0});
    QVERIFY(gone.verdict == PlaceVerdict::Moved && gone.step == std::size_t{0});
    const PlaceExplanation low = explain(run, 2, {5.5, 0.5, 0.02});
    QVERIFY(low.verdict == PlaceVerdict::TooLow && low.step == std::size_t{3});
    QVERIFY(low.obstacle && (low.obstacle->triangle == 6 || low.obstacle->triangle == 7));
  }

  void approximateSimplification() {
    Soup soup;
    for (int i = 0; i < 20; ++i)
      soup.quad({double(i), 0, i % 2 * 0.0001}, {i + 1.0, 0, (i + 1) % 2 * 0.0001}, {i + 1.0, 4, (i + 1) % 2 * 0.0001},
                {double(i), 4, i % 2 * 0.0001});
    const auto level = soup.ceiling(3, 0, 5, 4, 1).environment();
    const Inspected run = inspect(
        level, "SlopeFilter 45\nVerticalClearanceFilter 2\nSimplificationFilter true 0.001\nLayerSubdivisionFilter");
    QVERIFY(run.result.mesh->triangles.size() < 30);
    for (int i = 0; i < 20; ++i)
      QVERIFY(explain(run, static_cast<std::uint32_t>(2 * i), {i + 0.7, 1.1, 0.00005}).verdict ==
              (i == 3 || i == 4 ? PlaceVerdict::TooLow : PlaceVerdict::Walkable));
  }

  void badPlaces() {
    const Inspected run = inspect(Soup().floor(0, 0, 1, 1, 0).environment(), Limits{}.pipeline());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY_EXCEPTION_THROWN(explain(run, 2, {0, 0, 0}), InputError);
    QVERIFY_EXCEPTION_THROWN(explain(run, 0, {nan, 0, 0}), InputError);
    QVERIFY_EXCEPTION_THROWN(explain(run, 0, {0, 0, std::numeric_limits<double>::infinity()}), InputError);
    QVERIFY(explain(run, 0, {1e300, -1e300, 0}).verdict == PlaceVerdict::Walkable);  // somewhere on it
    QVERIFY(!run.inspector->placeBelow({nan, 0, 0}));
    RunContext cancelled;
    cancelled.cancel();
    QVERIFY_EXCEPTION_THROWN((void)run.inspector->explain({0, {0.5, 0.25, 0}}, &cancelled), Cancelled);
  }

  void placesBelowAPoint() {
    const auto level = Soup().floor(0, 0, 4, 4, 0).floor(0, 0, 2, 4, 3).ceiling(0, 0, 2, 4, 3).environment();
    const Inspected run = inspect(level, Limits{}.pipeline());
    const auto below = [&](const Vec3& point) { return run.inspector->placeBelow(point); };
    QVERIFY(below({1, 1, 9})->point == (Vec3{1, 1, 3}) && below({1, 1, 9})->triangle < 4);
    QVERIFY(below({1, 1, 3})->triangle == 2 || below({1, 1, 3})->triangle == 3);
    QVERIFY(below({1, 1, 2.9999999})->point == (Vec3{1, 1, 3}));
    QVERIFY(below({1, 1, 2.9})->point == (Vec3{1, 1, 0}));
    QVERIFY(below({4, 4, 0})->triangle < 2);  // in a corner
    QVERIFY(!below({1, 1, -1}) && !below({5, 1, 9}));
  }

  void nearestPlace() {
    const auto level = Soup().floor(0, 0, 4, 4, 0).floor(10, 0, 14, 4, 2).environment();
    const Inspected run = inspect(level, Limits{}.pipeline());
    QCOMPARE(run.inspector->placeNear({3, 1, 0.25})->triangle, 0U);
    QCOMPARE(run.inspector->placeNear({1, 3, -0.25})->triangle, 1U);
    QCOMPARE(run.inspector->placeNear({8, 1, 2})->triangle, 3U);
    QVERIFY(!run.inspector->placeNear({std::numeric_limits<double>::quiet_NaN(), 0, 0}));
  }

  void randomSoups() {
    int walkable = 0, rejected = 0;
    const auto compare = [&](const Soup& soup, const Limits& limits) {
      const auto environment = soup.environment();
      const Inspected run = inspect(environment, limits.pipeline());
      for (std::uint32_t t = 0; t < environment->triangles.size(); ++t) {
        if (!reference::planeThrough(reference::cornersOf(*environment, t))) continue;
        for (int i = 0; i < 4; ++i) {
          const auto weight = [] { return 1.0 + *below(1000); };
          const Vec3 place = placeOn(*environment, t, {weight(), weight(), weight()});
          if (!isGeneric(*environment, t, place)) continue;
          const auto expected = expect(*environment, limits, t, {place.x, place.y});
          if (!expected) continue;
          const PlaceExplanation told = explain(run, t, place);
          RC_ASSERT(agrees(told, *expected));
          const auto covered = isCovered(*environment, *run.result.mesh, t, place);
          if (covered) RC_ASSERT((told.verdict == PlaceVerdict::Walkable) == *covered);
          (told.verdict == PlaceVerdict::Walkable ? walkable : rejected) += 1;
        }
      }
    };
    QVERIFY(test::check("places of soups", 60, [&] {
      compare(soupOf(*gridTriangles(10, 9, 4)), {60, double(1 + *below(3)), *below(2) * 2.5});
    }));
    QVERIFY(test::check("places of buildings", 40, [&] {
      compare(buildingOf(*buildingParts(8)), {50, double(1 + *below(3)), *below(2) * 3.7});
    }));
    qInfo("%d walkable, %d rejected", walkable, rejected);
    QVERIFY(walkable > rounds(100) && rejected > rounds(100));
  }

  // On grid points, which lie on edges, corners and walls all the time: as a hair beside, towards the middle.
  void randomPlacesOnEdges() {
    int compared = 0;
    QVERIFY(test::check("places on edges", 60, [&] {
      const Soup soup = *below(2) == 0 ? soupOf(*gridTriangles(10, 4, 3)) : buildingOf(*buildingParts(8));
      const auto environment = soup.environment();
      const Limits limits{60, double(1 + *below(3)), 0};
      const Inspected run = inspect(environment, limits.pipeline());
      for (std::uint32_t t = 0; t < environment->triangles.size(); ++t) {
        const auto corners = reference::cornersOf(*environment, t);
        const auto plane = reference::planeThrough(corners);
        if (!plane) continue;
        const auto outline = reference::planTriangle(corners);
        for (int i = 0; i < 81; ++i) {
          const Point2 place{i % 9, i / 9};
          if (!contains(outline, place)) continue;
          const Rational middleX = (outline[0].x + outline[1].x + outline[2].x) / 3,
                         middleY = (outline[0].y + outline[1].y + outline[2].y) / 3;
          Rational dx = middleX - place.x, dy = middleY - place.y;
          if (dx == 0 && dy == 0) dx = 1;
          // Coordinates are small whole numbers, so this meets no line through the place, and no other one.
          const Rational hair(1, 1000000), less = hair / 1000000;
          const Point2 beside{place.x + hair * dx - less * dy, place.y + hair * dy + less * dx};
          const auto expected = expect(*environment, limits, t, beside);
          const PlaceExplanation told = explain(run, t, {place.x.get_d(), place.y.get_d(), plane->at(place).get_d()});
          RC_ASSERT(told.verdict == expected->verdict && told.step == expected->step);
          RC_ASSERT(told.above.has_value() == expected->above.has_value());
          ++compared;
        }
      }
    }));
    QVERIFY(compared > rounds(1000));
  }

  void realEnvironments_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"nav_test", "complex"}) QTest::newRow(name) << name;
  }
  void realEnvironments() {
    QFETCH(QString, name);
    if (sharedEnvironments().isEmpty()) QSKIP("the real environments are not here");
    const auto environment = importEnvironment((sharedEnvironments() + "/" + name + ".obj").toStdString());
    const Limits limits{45, 3 / environment->metresPerUnit, 0};
    const Inspected run = inspect(environment, limits.pipeline());
    // Half of the triangles are chosen by their size: large floors are where obstacles stand.
    std::vector<double> sizes;
    for (std::uint32_t t = 0; t < environment->triangles.size(); ++t) {
      const Triangle& corners = environment->triangles[t];
      const Vec3 &a = environment->vertices[corners[0]], &b = environment->vertices[corners[1]],
                 &c = environment->vertices[corners[2]];
      sizes.push_back(std::max(0.0, (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)));
    }
    std::discrete_distribution<std::uint32_t> bySize(sizes.begin(), sizes.end());
    std::mt19937_64 random(test::seed());
    std::uniform_real_distribution<double> weight(0.01, 1);
    std::uniform_int_distribution<std::uint32_t> any(0, static_cast<std::uint32_t>(environment->triangles.size()) - 1);
    std::map<PlaceVerdict, int> verdicts;
    for (int i = 0; i < rounds(2000); ++i) {
      const std::uint32_t t = i % 2 == 0 ? any(random) : bySize(random);
      const auto corners = reference::cornersOf(*environment, t);
      const Vec3 place = placeOn(*environment, t, {weight(random), weight(random), weight(random)});
      if (!reference::planeThrough(corners)) {
        const PlaceVerdict verdict = explain(run, t, place).verdict;
        QVERIFY(verdict == (reference::isDegenerate(corners) ? PlaceVerdict::NoArea : PlaceVerdict::Vertical));
        continue;
      }
      if (!isGeneric(*environment, t, place)) continue;
      const PlaceExplanation told = explain(run, t, place);
      const auto expected = expect(*environment, limits, t, {place.x, place.y});
      QVERIFY2(agrees(told, *expected), qPrintable(QString("triangle %1").arg(t)));
      const auto covered = isCovered(*environment, *run.result.mesh, t, place);
      if (covered) QCOMPARE(told.verdict == PlaceVerdict::Walkable, *covered);
      if (told.verdict == PlaceVerdict::Walkable) {
        const Component& component = run.inspector->components().list.at(told.component);
        QVERIFY(component.lower.z <= told.place.point.z + 1e-6 && component.upper.z >= told.place.point.z - 1e-6);
        QCOMPARE(component.area, told.componentArea);
      }
      ++verdicts[told.verdict];
    }
    for (const auto verdict :
         {PlaceVerdict::Walkable, PlaceVerdict::FacesDown, PlaceVerdict::TooSteep, PlaceVerdict::TooLow})
      QVERIFY2(verdicts[verdict] > rounds(2000) / 400, qPrintable(QString::number(static_cast<int>(verdict))));
  }
};

QTEST_APPLESS_MAIN(TestInspection)
#include "test_inspection.moc"
