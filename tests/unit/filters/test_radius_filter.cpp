// RadiusFilter: its promise at random places, and the cases that people have in mind.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/assembly/walkable_state.hpp"
#include "core/mesh/surface_topology.hpp"
#include "footfall/errors.hpp"
#include "footfall/inspect.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "tests/reference/radius_promise.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::test;
using Distances = reference::RadiusDistances;
using Tally = reference::RadiusTally;

namespace {

std::string number(double x) { return QString::number(x, 'g', 17).toStdString(); }
std::string radius(double r) { return "RadiusFilter " + number(r) + "\n"; }
NavigationMesh narrowed(const Soup& soup, double r, const std::string& before = minimalPipeline(2) + "\n",
                        const std::string& more = "") {
  return navigationMesh(runFilters(soup.environment(), before + radius(r) + more));
}

std::uint32_t components(const NavigationMesh& mesh) { return makeSurfaceTopology(mesh).componentCount; }

/// Off the grid, where rounding decides what touches.
Soup turned(const Soup& soup) {
  return soup.mapped([](const Vec3& p) { return Vec3{0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y, p.z}; });
}

Tally checkPromise(const std::shared_ptr<Environment>& environment, const std::string& before,
                   const Distances& distances, int places, std::mt19937& random,
                   reference::MeasuredArea measured = reference::MeasuredArea::AsGiven) {
  const Tally tally = reference::lookAtRadius(environment, before, distances, places, random, measured);
  for (const std::string& report : tally.reports) qWarning("%s", report.c_str());
  if (tally.wrong > 0 && environment->triangles.size() < 100) qWarning("%s", toText(*environment).c_str());
  return tally;
}
Tally checkPromise(const std::shared_ptr<Environment>& environment, const std::string& before, double r, int places,
                   std::mt19937& random, reference::MeasuredArea measured = reference::MeasuredArea::AsGiven) {
  return checkPromise(environment, before, Distances{r, r}, places, random, measured);
}
/// The second of two buildings is turned, which leaves lines that coincide but for roundings.
reference::MeasuredArea measuredOf(int building) {
  return building % 2 == 0 ? reference::MeasuredArea::AsGiven : reference::MeasuredArea::Simplified;
}

}  // namespace

class TestRadiusFilter : public QObject {
  Q_OBJECT

 private slots:
  void roomsShrink() {
    const Soup room = Soup().floor(0, 0, 10, 10, 0);
    QVERIFY(std::fabs(area(narrowed(room, 1)) - 64) < 1e-11);
    QVERIFY(area(narrowed(room, 1)) <= 64);
    QCOMPARE(area(narrowed(room, 0)), 100.0);
    QCOMPARE(area(narrowed(room, 5)), 0.0);
    QCOMPARE(area(narrowed(room, 50)), 0.0);
    QVERIFY(area(narrowed(room, 4.999)) > 0);
  }

  void hugeRadiiLeaveNothing() {
    const Soup level =
        Soup().floor(0, 0, 10, 10, 0).floor(20, 0, 21, 10, 0).box({4, 4, 0}, {6, 6, 3}).wall(5, 1, 5, 3, 0, 3);
    for (const double r : {10.0, 30.0, 1e3, 1e9, 1e30, 1e300, 1.7e308}) QCOMPARE(area(narrowed(level, r)), 0.0);
    for (const double scale : {1e-3, 1e6}) {
      const Soup scaled = level.mapped([&](const Vec3& p) { return Vec3{scale * p.x, scale * p.y, p.z}; });
      for (const double r : {30 * scale, 1e300}) QCOMPARE(area(narrowed(scaled, r)), 0.0);
    }
  }

  void roundCornersArePolygonsOutside() {
    const Soup edge = Soup().floor(0, 0, 10, 10, 0).box({4, 4, 0}, {6, 6, 3});
    const double exact = 64 - (4 + 4 * 2 * 1 + std::numbers::pi), lost = exact - area(narrowed(edge, 1));
    QVERIFY(lost > 0 && lost < 0.02 * std::numbers::pi);
  }

  void wallsWithoutThicknessHaveTwoSides() {
    // The wall goes from (5, 3) to (5, 7): two rectangles and two half discs.
    const Soup room = Soup().floor(0, 0, 10, 10, 0).wall(5, 3, 5, 7, 0, 3);
    const double exact = 64 - (4 * 2 + std::numbers::pi), lost = exact - area(narrowed(room, 1));
    QVERIFY(lost > 0 && lost < 0.02 * std::numbers::pi);
    QCOMPARE(components(narrowed(room, 1)), 1U);
    QCOMPARE(components(narrowed(room, 1.5)), 2U);
  }

  void doorwaysAreAsWideAsTwoRadii() {
    const auto rooms = [](double width) {
      return Soup().floor(0, 0, 10, 4, 0).wall(5, -1, 5, 2 - width / 2, 0, 3).wall(5, 2 + width / 2, 5, 5, 0, 3);
    };
    QCOMPARE(components(narrowed(rooms(1), 0.5)), 2U);  // a single point does not connect
    QCOMPARE(components(narrowed(rooms(1.001), 0.5)), 1U);
    QCOMPARE(components(narrowed(rooms(0.999), 0.5)), 2U);
  }

  void anUpperFloorsBorderDoesNotTouchWhatLiesBelow() {
    const Soup floors = Soup().floor(0, 0, 10, 10, 0).floor(3, 3, 7, 7, 3).ceiling(3, 3, 7, 7, 2.5);
    QVERIFY(std::fabs(area(narrowed(floors, 1)) - (64 + 4)) < 1e-11);
  }

  void stepsAreNoBorder() {
    Soup stairs;
    for (int i = 0; i < 9; ++i) {
      stairs.floor(i, 0, i + 1, 4, i * 0.25);
      if (i > 0) stairs.wall(i, 0, i, 4, (i - 1) * 0.25, i * 0.25);
    }
    const std::string before = minimalPipeline(2) + "\nStepFilter 0.25\n";
    const NavigationMesh left = narrowed(stairs, 1, before);
    QVERIFY(std::fabs(area(left) - 7 * 2) < 1e-11);
    QCOMPARE(components(left), 1U);
    QCOMPARE(left.links.size(), std::size_t{6});
    QCOMPARE(components(narrowed(stairs, 1, before, "AreaFilter 3\nSimplificationFilter\nLayerSubdivisionFilter\n")),
             1U);
    QCOMPARE(area(narrowed(stairs, 1)), 0.0);  // Each tread is an island without steps.
  }

  // A walk to the edge of a gap ends there, though a floor's border is just below, and the one behind the gap leans so
  // that the place is beyond another of its sides.
  void gapsHaveAWidth() {
    Soup floors = Soup().floor(0, 0, 10, 4, 0).floor(0, 0, 10, 4, -3);
    floors = turned(floors.triangle({0, 4.04, 0}, {10, 4.04, 0}, {-1000, 9, 0}));
    std::mt19937 random(static_cast<unsigned>(seed()));
    const Tally tally =
        checkPromise(floors.environment(), minimalPipeline(2) + "\nStepFilter 0.4 0.05", 0.5, rounds(6000), random);
    QCOMPARE(tally.wrong, std::size_t{0});
    QVERIFY(tally.near > 1000 && tally.far > 500);
  }

  // Some bridges end beside others at a corner of a gap: their sides are borders, to the filter and to the definition
  // alike.
  void gapsWithCorners() {
    std::mt19937 random(static_cast<unsigned>(seed()));
    for (const double turn : {0.1, 0.3, 0.5}) {
      Soup floors;
      floors.triangle({0, 0, 0}, {5, 5, 0}, {0, 5, 0}).triangle({0, 0, 0}, {10, 5 - 5 * turn, 0}, {5, 5, 0});
      floors.triangle({0, 5.03, 0}, {5, 5.03, 0}, {0, 10, 0});
      floors.triangle({5, 5.03, 0}, {10, 5.03 - 5 * turn, 0}, {10, 10, 0})
          .triangle({5, 5.03, 0}, {10, 10, 0}, {0, 10, 0});
      const Tally tally =
          checkPromise(floors.environment(), minimalPipeline(2) + "\nStepFilter 0.4 0.05", 0.5, rounds(3000), random);
      QCOMPARE(tally.wrong, std::size_t{0});
      QVERIFY(tally.near > 300 && tally.far > 300);
    }
  }

  void pipelines() {
    const Soup room = Soup().floor(0, 0, 10, 10, 0).box({4, 4, 0}, {6, 6, 3});
    // More filters, before and behind, also those that begin anew.
    const double once = area(narrowed(room, 1));
    for (const char* more : {"AreaFilter 1\n", "SimplificationFilter\n", "LayerSubdivisionFilter\n", "RoundingFilter\n",
                             "VerticalClearanceFilter 2\n", "SimplificationFilter true\n", "SlopeFilter 30\n"})
      QVERIFY2(std::fabs(area(narrowed(room, 1, minimalPipeline(2) + "\n", more)) - once) < 1e-9, more);
    for (const char* before :
         {"", "SimplificationFilter\n", "RoundingFilter\n", "LayerSubdivisionFilter\n", "AreaFilter 1\n"})
      QVERIFY2(std::fabs(area(narrowed(room, 1, minimalPipeline(2) + "\n" + before)) - once) < 1e-9, before);
    // Again: the second one moves the border of the first.
    QVERIFY(std::fabs(area(narrowed(Soup().floor(0, 0, 10, 10, 0), 1, radius(1) + radius(1))) - 16) < 1e-10);
  }

  void saysWhy() {
    RunContext context;
    const auto environment = Soup().floor(0, 0, 10, 10, 0).environment();
    const Pipeline pipeline = parsePipeline(minimalPipeline(2) + "\n" + radius(1) + "AreaFilter 1\n", "p");
    const Inspector inspector(environment, pipeline, runPipeline(environment, pipeline, context).mesh);
    const PlaceExplanation near = inspector.explain(*inspector.placeBelow({0.5, 5, 0.1}));
    QVERIFY(near.verdict == PlaceVerdict::TooNearLedge && near.limit == 1 && near.step == std::size_t{2});
    QVERIFY(near.ledgeDistance == 0.5 && !near.wallDistance);
    const PlaceExplanation middle = inspector.explain(*inspector.placeBelow({5, 5, 0.1}));
    QVERIFY(middle.verdict == PlaceVerdict::Walkable && middle.ledgeDistance == 5.0);
  }

  void tellsWallsFromLedges() {
    // A wall along x = 0 as far as y = 5.
    const Soup room = Soup().floor(0, 0, 10, 10, 0).wall(0, -1, 0, 5, -1, 3);
    RunContext context;
    const auto environment = room.environment();
    const Pipeline pipeline = parsePipeline(minimalPipeline(2) + "\nRadiusFilter 1 0.25\n", "p");
    const Inspector inspector(environment, pipeline, runPipeline(environment, pipeline, context).mesh);
    const auto at = [&](double x, double y) { return inspector.explain(*inspector.placeBelow({x, y, 0.1})); };
    QVERIFY(at(0.5, 3).verdict == PlaceVerdict::TooNearWall && at(0.5, 3).limit == 1 && at(0.5, 3).wallDistance == 0.5);
    QVERIFY(at(9.875, 3).verdict == PlaceVerdict::TooNearLedge && at(9.875, 3).limit == 0.25 &&
            at(9.875, 3).ledgeDistance == 0.125);
    QVERIFY(at(0.5, 6.5).verdict == PlaceVerdict::Walkable && at(0.5, 6.5).ledgeDistance == 0.5);
    QVERIFY(at(9.5, 5).verdict == PlaceVerdict::Walkable && at(9.5, 5).wallDistance == 9.5);
  }

  void wallsEndInTheMiddleOfAnEdge() {
    const auto left = [](const Soup& soup, const std::string& numbers) {
      return area(navigationMesh(
          runFilters(soup.environment(), minimalPipeline(2) + "\nStepFilter 0.3\nRadiusFilter " + numbers + "\n")));
    };
    const Soup floor = Soup().floor(0, 0, 10, 10, 0);
    const Soup room = Soup().floor(0, 0, 10, 10, 0).wall(0, -1, 0, 5, -1, 3);
    const double disc = std::numbers::pi;
    const auto isAbout = [](double found, double exact, double arcs) { return found <= exact && found > exact - arcs; };
    QVERIFY(isAbout(left(room, "1 0"), 100 - 5 - disc / 4, 0.02 * disc));
    QVERIFY(isAbout(left(room, "0 1"), 72 - 4 - disc / 4, 0.02 * disc));
    QCOMPARE(left(room, "0 0"), 100.0);
    QVERIFY(std::fabs(left(room, "1 1") - 64) < 1e-10 && std::fabs(left(room, "1") - 64) < 1e-10);
    QCOMPARE(left(floor, "1 0"), 100.0);
    QVERIFY(std::fabs(left(floor, "0 1") - 64) < 1e-10);
    // A finer tolerance loses less, a coarser one more, and none too much.
    double before = 100 - 5 - disc / 4;
    for (const char* tolerance : {"0.0001", "0.001", "0.01", "0.1"}) {
      const double now = left(room, std::string("1 0 ") + tolerance);
      QVERIFY2(now < before, tolerance);
      before = now;
    }
    QVERIFY(before > 100 - 5 - 1.21 * disc / 4);
    // Obstacles no higher than a step are no walls; a railing is one; so is an obstacle that hangs beside the floor at
    // a man's height.
    QVERIFY(isAbout(left(Soup(floor).wall(0, -1, 0, 5, -1, 0.3), "1 0"), 100.0000001, 1e-6));
    QVERIFY(left(Soup(floor).wall(0, -1, 0, 5, 0, 1), "1 0") < 94.3);
    QVERIFY(left(Soup(floor).wall(0, -1, 0, 5, 1, 1.5), "1 0") < 94.3);
    QCOMPARE(left(Soup(floor).wall(0, -1, 0, 5, 2, 3), "1 0"), 100.0);
    QVERIFY(left(Soup(floor).ceiling(-2, -1, 0, 5, 1.5), "1 0") < 94.3);
    QCOMPARE(left(Soup(floor).ceiling(-2, -1, -0.001, 5, 1.5), "1 0"), 100.0);
  }

  void keepsItsPromiseToWallsAndLedges() {
    std::mt19937 random(static_cast<unsigned>(seed()) + 5);
    Tally sum;
    for (int i = 0; i < rounds(60); ++i) {
      std::vector<PartNumbers> parts(3 + random() % 9);
      for (PartNumbers& part : parts)
        for (int& n : part) n = static_cast<int>(random() % 64);
      const Soup soup = i % 2 == 0 ? buildingOf(parts) : turned(buildingOf(parts));
      const std::string before = minimalPipeline(1.5) + "\n" + (i % 3 == 0 ? "StepFilter 0.5\n" : "");
      for (const Distances& distances : {Distances{0.3, 0}, Distances{0, 0.3}, Distances{0.75, 0.2},
                                         Distances{0.2, 0.5, 0.1}, Distances{0.3, 0.6}, Distances{0.3, 0.3, 0.001}}) {
        const Tally tally = checkPromise(soup.environment(i % 5 == 0), before, distances, 300, random, measuredOf(i));
        QVERIFY2(tally.wrong == 0, qPrintable(QString("building %1, %2, %3, %4")
                                                  .arg(i)
                                                  .arg(distances.walls)
                                                  .arg(distances.ledges)
                                                  .arg(distances.tolerance)));
        sum.near += tally.near;
        sum.far += tally.far;
        sum.doubtful += tally.doubtful;
      }
    }
    qInfo("%zu places nearer, %zu farther, %zu near needles", sum.near, sum.far, sum.doubtful);
    QVERIFY(sum.near > 1000 && sum.far > 1000 && sum.doubtful < (sum.near + sum.far) / 10);
  }

  void wrongNumbers_data() {
    QTest::addColumn<QString>("text");
    for (const char* text :
         {"RadiusFilter -1", "RadiusFilter nan", "RadiusFilter inf", "RadiusFilter", "RadiusFilter x",
          "RadiusFilter 1 -1", "RadiusFilter 1 1 0", "RadiusFilter 1 1 0.2", "RadiusFilter 1 2",
          "RadiusFilter 1 1 0.01 1", "GridStrategy 2 2\nRadiusFilter 1\nCollapse"})
      QTest::newRow(text) << QString(text);
  }
  void wrongNumbers() {
    QFETCH(QString, text);
    QVERIFY_THROWS_EXCEPTION(InputError, parsePipeline(text.toStdString(), "p"));
  }

  void tooSmallBesideTheCoordinatesIsRefused() {
    const Soup far = Soup().floor(1e9, 0, 1e9 + 10, 10, 0);
    QVERIFY_THROWS_EXCEPTION(InputError, narrowed(far, 1e-6));
    QVERIFY(area(narrowed(far, 1)) > 63.9);
  }

  void keepsItsPromiseOnBuildings() {
    std::mt19937 random(static_cast<unsigned>(seed()));
    Tally sum;
    for (int i = 0; i < rounds(150); ++i) {
      std::vector<PartNumbers> parts(3 + random() % 9);
      for (PartNumbers& part : parts)
        for (int& n : part) n = static_cast<int>(random() % 64);
      const Soup soup = i % 2 == 0 ? buildingOf(parts) : turned(buildingOf(parts));
      const std::string before = minimalPipeline(1.5) + "\n" + (i % 3 == 0 ? "StepFilter 0.5\n" : "");
      for (const double r : {0.1, 0.3, 0.75}) {
        const Tally tally = checkPromise(soup.environment(i % 5 == 0), before, r, 300, random, measuredOf(i));
        QVERIFY2(tally.wrong == 0, qPrintable(QString("building %1, radius %2").arg(i).arg(r)));
        sum.near += tally.near;
        sum.far += tally.far;
        sum.doubtful += tally.doubtful;
      }
    }
    qInfo("%zu places nearer, %zu farther, %zu near needles", sum.near, sum.far, sum.doubtful);
    QVERIFY(sum.near > 1000 && sum.far > 1000 && sum.doubtful < sum.far / 10);
  }

  void keepsItsPromiseOnWalks() {
    std::mt19937 random(static_cast<unsigned>(seed()) + 1);
    for (int i = 0; i < rounds(100); ++i) {
      std::vector<int> moves(4 + random() % 12);
      for (int& move : moves) move = static_cast<int>(random() % 16);
      const Soup soup = walkOf(moves);
      for (const double r : {0.05, 0.2, 0.45}) {
        const Tally tally =
            checkPromise(soup.environment(), minimalPipeline(0.5) + "\nStepFilter 0.25\n", r, 300, random);
        QVERIFY2(tally.wrong == 0, qPrintable(QString("walk %1, radius %2").arg(i).arg(r)));
      }
    }
  }

  void keepsItsPromiseOnSoups() {
    std::mt19937 random(static_cast<unsigned>(seed()) + 2);
    int tried = 0;
    for (int i = 0; i < rounds(300); ++i) {
      const fuzz::PipelineCase one = fuzz::makePipelineCase(seed() + static_cast<std::uint64_t>(i));
      const auto environment = one.soup.environment(one.bothSides);
      double largest = 0;
      for (const Vec3& v : environment->vertices) largest = std::max({largest, std::fabs(v.x), std::fabs(v.y)});
      if (largest > 50 || largest < 1 || one.clearance < 1e-3) continue;  // the doubles here are made for such
      ++tried;
      for (const double r : {0.2, 0.7}) {
        const Tally tally = checkPromise(environment, minimalPipeline(one.clearance) + "\n", r, 200, random);
        QVERIFY2(tally.wrong == 0, qPrintable(QString("case %1 (%2), clearance %3, radius %4")
                                                  .arg(i)
                                                  .arg(QString::fromStdString(one.kind))
                                                  .arg(one.clearance)
                                                  .arg(r)));
      }
    }
    QVERIFY(tried > 20);
  }

  void orderAndThreadsChangeNothing() {
    std::mt19937 random(7);
    for (int i = 0; i < rounds(40); ++i) {
      const fuzz::PipelineCase one = fuzz::makePipelineCase(seed() + 9000 + static_cast<std::uint64_t>(i));
      const auto environment = one.soup.environment(one.bothSides);
      const std::string text = minimalPipeline(one.clearance) + "\n" + radius(0.3) + "SimplificationFilter\n";
      try {
        const NavigationMesh mesh = navigationMesh(runFilters(environment, text));
        QCOMPARE(findMeshError(mesh), std::string());
        std::vector<std::uint32_t> order(environment->triangles.size());
        for (std::uint32_t t = 0; t < order.size(); ++t) order[t] = t;
        std::shuffle(order.begin(), order.end(), random);
        NavigationMesh other;
        runWithThreads(1 + i % 3, [&] { other = navigationMesh(runFilters(shuffled(*environment, order, 1), text)); });
        QVERIFY(other.triangles == mesh.triangles && other.vertices == mesh.vertices);
      } catch (const InputError&) {  // the radius is nothing beside the coordinates
      }
    }
  }

  void moreRadiusNeverAddsArea() {
    for (int i = 0; i < rounds(60); ++i) {
      std::mt19937 random(static_cast<unsigned>(i));
      std::vector<PartNumbers> parts(8);
      for (PartNumbers& part : parts)
        for (int& n : part) n = static_cast<int>(random() % 64);
      const Soup soup = buildingOf(parts);
      double before = 1e300;
      for (const double r : {0.0, 0.1, 0.2, 0.4, 0.8}) {
        const double now = area(narrowed(soup, r, minimalPipeline(1.5) + "\n"));
        QVERIFY(now <= before);
        before = now;
      }
    }
  }

  void moreRadiusNeverAddsPlaces() {
    std::mt19937 random(static_cast<unsigned>(seed()) + 11);
    int looked = 0;
    for (int i = 0; i < rounds(40); ++i) {
      std::vector<PartNumbers> parts(8);
      for (PartNumbers& part : parts)
        for (int& n : part) n = static_cast<int>(random() % 64);
      const Soup soup = i % 2 == 0 ? buildingOf(parts) : turned(buildingOf(parts));
      const std::string before = minimalPipeline(1.5) + "\nStepFilter 0.5\n";
      NavigationMesh wider = navigationMesh(runFilters(soup.environment(), before));
      for (const double r : {0.1, 0.102, 0.2, 0.4}) {  // round corners may lose a hundredth more
        const NavigationMesh now = narrowed(soup, r, before);
        const reference::BorderDistance places(wider);
        for (const Triangle& t : now.triangles) {
          const Vec3 &a = now.vertices[t[0]], &b = now.vertices[t[1]], &c = now.vertices[t[2]];
          const Vec3 middle{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3};
          const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
          if (area < 1e-6) continue;  // the middle of a needle can lie beside it
          ++looked;
          QVERIFY2(places.find(middle.x, middle.y, middle.z, 1e-6), qPrintable(QString("%1, %2").arg(i).arg(r)));
        }
        wider = now;
      }
    }
    QVERIFY(looked > 1000);
  }

  void turnedDoorwaysAreAsWideAsTwoRadii() {
    for (const bool isThick : {false, true})
      for (const double r : {0.3, 0.45, 0.7})
        for (const double more : {-1e-6, isThick ? 1e-6 : 0.0202 * r}) {  // ends of walls are round, to a hundredth
          const double low = 2 - r - more / 2, high = 2 + r + more / 2;
          Soup rooms = Soup().floor(0, 0, 10, 4, 0);
          if (isThick)
            rooms.box({4.75, -1, 0}, {5.25, low, 3}).box({4.75, high, 0}, {5.25, 5, 3});
          else
            rooms.wall(5, -1, 5, low, 0, 3).wall(5, high, 5, 5, 0, 3);
          // The space on top of a wall is no room.
          const NavigationMesh left = narrowed(turned(rooms), r, minimalPipeline(2) + "\n", "AreaFilter 1\n");
          QCOMPARE(components(left), more > 0 ? 1U : 2U);
        }
  }

  void linksAndObstacleEdges() {
    // Two floors, one a step above the other, and a wall without thickness across the step as far as the middle.
    const Soup floors = Soup().floor(0, 0, 5, 4, 0).floor(5, 0, 10, 4, 0.25).wall(5, 0, 5, 4, 0, 0.25);
    const std::string before = minimalPipeline(2) + "\nStepFilter 0.3\n";
    QVERIFY(std::fabs(area(narrowed(floors, 0.5, before)) - 9 * 3) < 1e-11);
    QCOMPARE(components(narrowed(floors, 0.5, before)), 1U);
    const Soup walled = Soup(floors).wall(5, -1, 5, 2, 0, 3);
    // The margins of 0.5 reach to 4.5 and begin again at 5.5, as far as the wall's end, round which they are half a
    // disc.
    const double exact = 9 * 3 - 1.5 * 1 - std::numbers::pi / 8, lost = exact - area(narrowed(walled, 0.5, before));
    QVERIFY(lost > -1e-9 && lost < 0.02 * std::numbers::pi / 8);
    QCOMPARE(components(narrowed(walled, 0.5, before)), 1U);
    QCOMPARE(components(narrowed(walled, 1.001, before)), 2U);  // the passage is 2 wide
    // The wall goes through the middle of the upper floor, along the walk.
    const Soup along = Soup(floors).wall(6, 2, 9, 2, 0, 3);
    QCOMPARE(components(narrowed(along, 0.5, before)), 1U);
    QVERIFY(std::fabs(area(narrowed(along, 0.5, before)) - (9 * 3 - 3 - std::numbers::pi / 4)) < 0.02);
  }

  void liveEditsGiveTheSame() {
    const Soup level = Soup().floor(0, 0, 10, 6, 0).wall(5, -1, 5, 2, 0, 3).wall(5, 4, 5, 7, 0, 3);
    const std::string pipeline = minimalPipeline(2) + "\nStepFilter 0.3\n" + radius(0.4) +
                                 "AreaFilter 1\nSimplificationFilter\nLayerSubdivisionFilter\n";
    ResultCache cache;
    EditableEnvironment edited(level.environment());
    QVERIFY(agrees(edited.environment(), pipeline, cache));
    const auto crate = [](double x, double y) { return soupFor(Soup().box({x, y, 0}, {x + 0.75, y + 0.75, 1})); };
    const ObstacleId id = edited.add(crate(1.5, 1));
    for (int i = 0; i < 12; ++i) {
      edited.replace(id, crate(0.6 * i, 0.5 + 0.7 * (i % 5)));
      QVERIFY2(agrees(edited.environment(), pipeline, cache), qPrintable(QString::number(i)));
    }
    edited.remove(id);
    QVERIFY(agrees(edited.environment(), pipeline, cache));
  }

  // Random edits of stairs, slits and rooms under a low ceiling, with one distance and with two: what is taken over
  // must be what a run from nothing finds. Some obstacles stand on the grid of all else, some do not.
  void randomEditsGiveTheSame() {
    Soup level = Soup().floor(0, 0, 12, 5, 0).floor(0, 5.03, 6, 9, 0.1).ceiling(8, 1, 11, 3, 1.5);
    level.wall(5, -1, 5, 2, 0, 3).wall(5, 4, 5, 5, 0, 3).floor(2, 1, 4, 3, 2.5);
    for (int i = 0; i < 5; ++i) level.floor(6 + 0.5 * i, 5, 6.5 + 0.5 * i, 8, 0.2 * i);
    std::mt19937 random(static_cast<unsigned>(seed()));
    std::uniform_real_distribution<double> share(0, 1);
    for (const char* narrow :
         {"RadiusFilter 0.4\n", "RadiusFilter 0.4 0.1\n", "RadiusFilter 0.2\nRadiusFilter 0.1\n"}) {
      const std::string pipeline = minimalPipeline(2) + "\nStepFilter 0.3 0.05\n" + narrow + "AreaFilter 0.1\n";
      ResultCache cache;
      EditableEnvironment edited(level.environment());
      QVERIFY(agrees(edited.environment(), pipeline, cache));
      std::vector<ObstacleId> placed;
      const auto crate = [&] {
        const double unit = share(random) < 0.5 ? 0.25 : 1e-7;
        const auto at = [&](double most) { return unit * std::round(most * share(random) / unit); };
        const Vec3 low{at(11), at(8), share(random) < 0.2 ? 1.5 : 0.0};
        const Soup box = Soup().box(low, {low.x + 0.25 + at(1), low.y + 0.25 + at(1), low.z + 1});
        return soupFor(share(random) < 0.2 ? turned(box) : box);
      };
      for (int i = 0; i < rounds(12); ++i) {
        const double what = share(random);
        const auto which = static_cast<std::ptrdiff_t>(share(random) * static_cast<double>(placed.size()));
        if (placed.size() < 2 || what < 0.3) {
          placed.push_back(edited.add(crate()));
        } else if (what < 0.8) {
          edited.replace(placed[which], crate());
        } else {
          edited.remove(placed[which]);
          placed.erase(placed.begin() + which);
        }
        QVERIFY2(agrees(edited.environment(), pipeline, cache), qPrintable(QString("%1: %2").arg(narrow).arg(i)));
      }
    }
  }
};

QTEST_GUILESS_MAIN(TestRadiusFilter)
#include "test_radius_filter.moc"
