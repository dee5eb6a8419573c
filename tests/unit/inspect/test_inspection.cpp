// The reasons why a place is walkable or not: known rooms.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>

#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/inspect/explained_places.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;
using reference::Linear;
using reference::Point2;
using reference::Rational;

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
    // The places are on the diagonal of floor and ceiling, on the outline of the ceiling's shadow, in corners.
    QVERIFY(explain(run, 0, {3, 3, 0}).verdict == PlaceVerdict::TooLow);
    QVERIFY(explain(run, 1, {1, 1, 0}).verdict == PlaceVerdict::Walkable);
    QVERIFY(explain(run, 1, {2, 2, 0}).verdict == PlaceVerdict::Walkable);  // towards (4/3, 8/3)
    QVERIFY(explain(run, 0, {2, 1, 0}).verdict == PlaceVerdict::TooLow);    // towards (8/3, 4/3)
    QVERIFY(explain(run, 0, {0, 0, 0}).verdict == PlaceVerdict::Walkable);
    QVERIFY(explain(run, 0, {4, 0, 0}).verdict == PlaceVerdict::TooLow);
    // The place is beside the triangle, as a ray's rounding puts it.
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

  // Disabled steps keep their numbers, and those of a parallel block are distinguished.
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
    QVERIFY(below({4, 4, 0})->triangle < 2);  // The place is in a corner.
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
};

QTEST_APPLESS_MAIN(TestInspection)
#include "test_inspection.moc"
