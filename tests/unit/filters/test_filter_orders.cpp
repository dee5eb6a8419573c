// Filters in other orders than the usual one: what must come out the same, does so exactly.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmpxx.h>

#include <QtTest>
#include <cmath>
#include <map>

#include "core/assembly/walkable_state.hpp"
#include "footfall/pipeline.hpp"
#include "tests/reference/exact_view.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

struct Measure {
  mpq_class planArea;
  std::size_t parts = 0;
  bool operator==(const Measure& o) const { return planArea == o.planArea && parts == o.parts; }
};

Measure measure(const StatePtr& state) {
  Measure result;
  for (const ExactTriangle& t : exactWalkableTriangles(*state)) {
    std::array<std::array<mpq_class, 2>, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = {mpq_class(t.corners[k][0]), mpq_class(t.corners[k][1])};
    result.planArea += (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
  }
  result.parts = countParts(navigationMesh(state));
  return result;
}

/// A floor with a low box, a high slab, a wall and a table: something for every filter.
Soup room() {
  Soup soup;
  soup.floor(0, 0, 16, 16, 0).box({2, 2, 0}, {4, 4, 1}).ceiling(6, 0, 9, 16, 2.5).floor(6, 0, 9, 16, 2.75);
  soup.wall(11, 0, 11, 12, 0, 3).box({12, 2, 0.5}, {15, 5, 0.75}).ramp(0, 10, 4, 14, 0, 4);
  return soup;
}

}  // namespace

class TestFilterOrders : public QObject {
  Q_OBJECT

 private slots:
  void equalResults_data() {
    QTest::addColumn<QString>("filters");
    QTest::addColumn<QString>("same");
    const auto row = [](const char* filters, const char* same) { QTest::newRow(filters) << filters << same; };
    row("VerticalClearanceFilter 2\nVerticalClearanceFilter 3", "VerticalClearanceFilter 3");
    row("VerticalClearanceFilter 3\nVerticalClearanceFilter 2", "VerticalClearanceFilter 3");
    row("VerticalClearanceFilter 2\nVerticalClearanceFilter 2", "VerticalClearanceFilter 2");
    row("VerticalClearanceFilter 2\nSimplificationFilter", "VerticalClearanceFilter 2");
    row("SimplificationFilter\nVerticalClearanceFilter 2", "VerticalClearanceFilter 2");
    row("VerticalClearanceFilter 2\nSimplificationFilter\nVerticalClearanceFilter 3", "VerticalClearanceFilter 3");
    row("VerticalClearanceFilter 2\nAreaFilter 5\nVerticalClearanceFilter 2",
        "VerticalClearanceFilter 2\nAreaFilter 5");
    row("VerticalClearanceFilter 2\nSimplificationFilter\nAreaFilter 5\nVerticalClearanceFilter 2",
        "VerticalClearanceFilter 2\nAreaFilter 5");
    row("VerticalClearanceFilter 2\nLayerSubdivisionFilter\nSlopeFilter 80", "VerticalClearanceFilter 2");
    row("VerticalClearanceFilter 2\nSlopeFilter 30", "SlopeFilter 30\nVerticalClearanceFilter 2");
    row("VerticalClearanceFilter 2\nRoundingFilter", "VerticalClearanceFilter 2");
    row("VerticalClearanceFilter 2\nRoundingFilter\nVerticalClearanceFilter 3", "VerticalClearanceFilter 3");
    row("VerticalClearanceFilter 2\nRoundingFilter\nAreaFilter 5\nVerticalClearanceFilter 2",
        "VerticalClearanceFilter 2\nAreaFilter 5");
    row("DuplicationFilter 0.01\nVerticalClearanceFilter 2", "VerticalClearanceFilter 2");
  }
  void equalResults() {
    QFETCH(QString, filters);
    QFETCH(QString, same);
    const auto environment = room().environment();  // all crossings are doubles: rounding changes nothing
    const Measure a = measure(runFilters(environment, filters.toStdString()));
    const Measure b = measure(runFilters(environment, same.toStdString()));
    QVERIFY(a.planArea > 0);
    QCOMPARE(QString::fromStdString(a.planArea.get_str()), QString::fromStdString(b.planArea.get_str()));
    QCOMPARE(a.parts, b.parts);
  }

  void equalResultsOnRandomSoups() {
    QVERIFY(check("filter orders", 40, [] {
      const auto environment = soupOf(*gridTriangles(12, 3, 3)).environment();
      const Measure once = measure(runFilters(environment, "SlopeFilter 80\nVerticalClearanceFilter 2"));
      for (const char* filters : {"SlopeFilter 80\nVerticalClearanceFilter 1\nVerticalClearanceFilter 2",
                                  "SlopeFilter 80\nVerticalClearanceFilter 1\nSimplificationFilter\n"
                                  "AreaFilter 0\nVerticalClearanceFilter 2",
                                  "VerticalClearanceFilter 2\nSlopeFilter 80\nVerticalClearanceFilter 2"}) {
        const Measure other = measure(runFilters(environment, filters));
        RC_ASSERT(other.planArea == once.planArea || std::string(filters).starts_with("Vertical"));
        if (!std::string(filters).starts_with("Vertical")) RC_ASSERT(other.parts == once.parts);
      }
    }));
  }

  void droppedFloorsStayObstacles() {
    // a small board over a floor: AreaFilter drops it, and it still keeps agents from standing under it
    Soup soup;
    soup.floor(0, 0, 8, 8, 0).floor(2, 2, 4, 4, 1);
    for (const char* filters :
         {"AreaFilter 10\nVerticalClearanceFilter 2", "VerticalClearanceFilter 2\nAreaFilter 10",
          "VerticalClearanceFilter 0.5\nAreaFilter 10\nVerticalClearanceFilter 2",
          "VerticalClearanceFilter 0.5\nAreaFilter 10\nRoundingFilter\nVerticalClearanceFilter 2"})
      QCOMPARE(measure(runFilters(soup.environment(), filters)).planArea.get_d(), 2.0 * 60);
  }

  void droppedCoplanarFloorsRemoveNothing() {
    // a small floor in the plane of a large one, dropped before anything is cut: it is coplanar and rejected then
    Soup soup;
    soup.triangle({0, 0, 0}, {30, 0, 0}, {0, 30, 0}).triangle({9, 9, 0}, {12, 9, 0}, {9, 12, 0});
    for (const char* filters :
         {"AreaFilter 50\nVerticalClearanceFilter 2", "SimplificationFilter\nAreaFilter 50\nVerticalClearanceFilter 2"})
      QCOMPARE(measure(runFilters(soup.environment(), filters)).planArea.get_d(), 2.0 * 450);
  }

  void overlappingFansAreLeftAlone() {
    // Floors may wind twice around a vertex before a clearance filter.
    const std::array<Vec3, 5> ring{Vec3{100, 0, 0}, Vec3{-81, 59, 0}, Vec3{31, -95, 0}, Vec3{31, 95, 0},
                                   Vec3{-81, -59, 0}};
    Soup soup;
    for (std::size_t i = 0; i < 5; ++i) soup.triangle({0, 0, 0}, ring[i], ring[(i + 1) % 5]);
    const Measure before = measure(runFilters(soup.environment(), "SlopeFilter 45\nAreaFilter 0"));
    const Measure after = measure(runFilters(soup.environment(), "SlopeFilter 45\nAreaFilter 0\nSimplificationFilter"));
    QCOMPARE(after.planArea.get_d(), before.planArea.get_d());
  }

  void anyHeightAboveTheExtentIsTheSame() {
    const auto environment = room().environment();
    const Measure enough = measure(runFilters(environment, "SlopeFilter 80\nVerticalClearanceFilter 4.5"));
    for (const char* height : {"5", "9", "1000", "1e30", "1e300"}) {
      const Measure other =
          measure(runFilters(environment, "SlopeFilter 80\nVerticalClearanceFilter " + std::string(height)));
      QCOMPARE(other.planArea.get_d(), enough.planArea.get_d());
      QCOMPARE(other.parts, enough.parts);
    }
  }

  // Also around z = 0, where the extent is larger than all coordinates, and where all is flat, doubles decide nearly
  // everything.
  void heightAboveTheExtentStaysOnTheGrid() {
    const Soup centred = room().mapped([](const Vec3& v) { return Vec3{v.x - 8, v.y - 8, (v.z - 2) * 4}; });
    for (const Soup& soup : {centred, Soup().floor(0, 0, 8, 8, 0), Soup().floor(0, 0, 8, 8, 2)}) {
      RunContext context;
      const StatePtr state = makeInitialState(soup.environment(), context);
      const PipelineStep step = parsePipeline("VerticalClearanceFilter 1000", "test").steps[0];
      const FilterOutcome outcome = applyFilter(*step.filter, step.values, state, context);
      QVERIFY(std::isfinite(outcome.state->kernel->sign().slack));
    }
  }

  void bothSidesSurviveANewGeneration() {
    // merging turns the only floor over: with both sides counting as up, it stays a floor
    Soup soup;
    soup.triangle({0, 0, 0}, {4, 0, 0}, {2, 0.05, 0}).triangle({1.99, -0.04, 0}, {1.99, -4, 5}, {1.99, -5, 5});
    QVERIFY(measure(runFilters(soup.environment(true), "DuplicationFilter 0.1")).planArea > 0);
    QVERIFY(measure(runFilters(soup.environment(false), "DuplicationFilter 0.1")).planArea == 0);
  }

  void slopeKeepsLayers() {
    Soup soup;
    soup.floor(0, 0, 8, 8, 0).floor(0, 0, 8, 8, 4);
    const std::string layered = "VerticalClearanceFilter 2\nLayerSubdivisionFilter\n";
    QCOMPARE(navigationMesh(runFilters(soup.environment(), layered)).layerCount, 2U);
    const NavigationMesh mesh = navigationMesh(runFilters(soup.environment(), layered + "SlopeFilter 45"));
    QCOMPARE(mesh.layerCount, 2U);
    QCOMPARE(mesh.layers.size(), mesh.triangles.size());
  }

  void generationsKeepObstacleEdges() {
    // a wall in the floor's inside with both ends free, kept through rounding, merging and approximate simplification;
    // the leaning roof makes sure that there is something to round
    Soup soup;
    soup.floor(0, 0, 16, 16, 0).wall(4, 8, 12, 8, 0, 3).triangle({1, 1, 1}, {3.1, 1.2, 1.7}, {1.3, 3, 1.2});
    const std::string start = "SlopeFilter 45\nVerticalClearanceFilter 2\n";
    for (const char* more : {"", "RoundingFilter", "DuplicationFilter 0.01", "SimplificationFilter true 0.000001",
                             "RoundingFilter\nVerticalClearanceFilter 2.5", "RoundingFilter\nSimplificationFilter"}) {
      const NavigationMesh mesh = navigationMesh(runFilters(soup.environment(), start + more));
      QCOMPARE(findMeshError(mesh), std::string());
      QCOMPARE(obstacleLength(mesh), 8.0);
    }
  }
};

QTEST_APPLESS_MAIN(TestFilterOrders)
#include "test_filter_orders.moc"
