// RadiusFilter with two distances, behind a border that keeps less away: walks bend round its ends.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "footfall/inspect.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "tests/reference/border_distance.hpp"
#include "tests/reference/radius_promise.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::test;
using reference::RadiusTally;

namespace {

const std::string kBefore = minimalPipeline(2) + "\nStepFilter 0.4\n";

}  // namespace

// The smallest cases of docs/explanation/model.md ("Margins").
class TestRadiusShadows : public QObject {
  Q_OBJECT

 private slots:
  // The floor's triangles reach around the wall's ends. Behind the wall, the ledge takes what is within half a metre of
  // its ends: two quarters of a disc.
  void aWallBeforeALedge() {
    const Soup room = Soup().floor(0, 0, 10, 10, 0).wall(3, 0.5, 7, 0.5, 0, 3);
    const double left = area(navigationMesh(runFilters(room.environment(), kBefore + "RadiusFilter 0 1\n")));
    const double discs = 2 * std::numbers::pi / 16, exact = 64 + 4 * 0.5 - discs;
    QVERIFY(left <= exact && left > exact - 0.05 * discs);
    std::mt19937 random(static_cast<unsigned>(seed()));
    const RadiusTally equal = reference::lookAtRadius(room.environment(), kBefore, {1, 1}, rounds(6000), random);
    QCOMPARE(equal.wrong, std::size_t{0});
    const RadiusTally two = reference::lookAtRadius(room.environment(), kBefore, {0, 1}, rounds(6000), random);
    QVERIFY(two.near > 1000 && two.far > 1000);
    QCOMPARE(two.wrong, std::size_t{0});
  }

  // A slit before a wall; behind its end, at x = 3.02, the floor folds. No walk at a right angle to the wall gets
  // there, but one from (2.9, 0) does: it is 0.91 long.
  void aSlitBeforeAWallAndAFoldBehindIt() {
    const Soup level = Soup()
                           .floor(0, 0, 10, 0.5, 0)
                           .floor(0, 0.5, 3, 0.6, 0)
                           .floor(0, 0.6, 3.02, 10, 0)
                           .quad({3.02, 0.6, 0}, {7, 0.6, 0.398}, {7, 10, 0.398}, {3.02, 10, 0})
                           .wall(-1, 0, 11, 0, -1, 3);
    const auto isLeft = [&](const std::string& numbers) {
      const NavigationMesh left =
          navigationMesh(runFilters(level.environment(), kBefore + "RadiusFilter " + numbers + "\n"));
      return reference::BorderDistance(left).find(3.05, 0.9, 0.003, 1e-6).has_value();
    };
    QVERIFY(isLeft("0.9 0"));
    QVERIFY(!isLeft("1 1"));
    QVERIFY(!isLeft("1 0"));
  }

  // The walk goes along a corridor from the wall, at (0.6, 0.2) to the left, at (0.8, 0.4) to the right again: 0.88 in
  // length so far.
  void walksBendTwice() {
    const Soup room = Soup()
                          .floor(0, 0, 0.8, 0.2, 0)
                          .floor(0.6, 0.2, 0.8, 0.6, 0)
                          .floor(0.8, 0.4, 3, 0.6, 0)
                          .wall(0, -1, 0, 4, -1, 3);
    const auto isLeft = [&](double x) {
      const NavigationMesh left = navigationMesh(runFilters(room.environment(), kBefore + "RadiusFilter 1.5 0\n"));
      return reference::BorderDistance(left).find(x, 0.401, 0, 1e-6).has_value();
    };
    QVERIFY(!isLeft(0.8 + 1.5 - 0.883) && isLeft(0.8 + 1.51 - 0.882));
    std::mt19937 random(static_cast<unsigned>(seed()));
    const RadiusTally tally = reference::lookAtRadius(room.environment(), kBefore, {1.5, 0}, rounds(6000), random);
    QVERIFY(tally.near > 1000 && tally.far > 500);
    QCOMPARE(tally.wrong, std::size_t{0});
  }

  // The margin goes round the end of a wall, as far as the border goes: a body there touches the wall's end.
  void endsOfWallsAreRound() {
    const Soup pit = Soup().floor(0, 0, 10, 4, 0).floor(0, 4, 4, 6, 0).floor(6, 4, 10, 6, 0).floor(0, 6, 10, 10, 0);
    const Soup room = Soup(pit).wall(4, 4, 6, 4, -1, 3);
    const double left = area(navigationMesh(runFilters(room.environment(), kBefore + "RadiusFilter 1 0\n")));
    const double discs = 2 * std::numbers::pi / 2, exact = 96 - 2 - discs;
    QVERIFY(left <= exact && left > exact - 0.02 * discs);
  }

  // The upper edges of two slopes coincide but for roundings. The lower slope is no wall to the upper one: it ends
  // there.
  void whatEndsAtABorderIsNoWall() {
    const Soup slopes =
        Soup()
            .triangle({-0.19999999999999973, 3.6000000000000005, 3}, {1.8000000000000007, 7.6, 4}, {-1.4, 5.2, 4})
            .triangle({1.2000000000000004, 3.4, 1}, {2.6000000000000005, 8.2, 4}, {-0.59999999999999964, 5.8, 4});
    std::mt19937 random(static_cast<unsigned>(seed()));
    const RadiusTally tally =
        reference::lookAtRadius(slopes.environment(), minimalPipeline(1.5), {0, 0.3}, rounds(2000), random);
    QVERIFY(tally.near > 500 && tally.far > 200);
    QCOMPARE(tally.wrong, std::size_t{0});
  }

  void saysWhyRoundACorner() {
    const auto environment = Soup().floor(0, 0, 10, 10, 0).wall(3, 0.5, 7, 0.5, 0, 3).environment();
    RunContext context;
    const Pipeline pipeline = parsePipeline(kBefore + "RadiusFilter 0 1\n", "p");
    const Inspector inspector(environment, pipeline, runPipeline(environment, pipeline, context).mesh);
    const PlaceExplanation place = inspector.explain(*inspector.placeBelow({3.25, 0.75, 0.1}));
    QVERIFY(place.verdict == PlaceVerdict::TooNearLedge && place.limit == 1);
  }

  // A piece of border as short as roundings, between two ledges, is one: it was taken for a wall, which took a disc.
  // Beside a wall it keeps away what the wall does.
  void shortBordersAreWhatIsNextToThem() {
    for (const double hair : {0x1p-50, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10}) {
      Soup floor;
      floor.triangle({0, 0, 0}, {10, 0, 0}, {10 + hair, hair, 0})
          .triangle({0, 0, 0}, {10 + hair, hair, 0}, {10, 10, 0});
      floor.triangle({0, 0, 0}, {10, 10, 0}, {0, 10, 0});
      const auto left = [](const Soup& soup, const char* filter) {
        return area(navigationMesh(runFilters(soup.environment(), kBefore + filter + "\n")));
      };
      QVERIFY(std::fabs(left(floor, "RadiusFilter 1 0") - 100) < 1e-8);
      QVERIFY(std::fabs(left(floor, "RadiusFilter 1 0.25") - 9.5 * 9.5) < 1e-8);
      QVERIFY(std::fabs(left(floor, "RadiusFilter 0 1") - 64) < 1e-8);
      const Soup walled = Soup(floor).wall(-1, 0, 11, 0, -1, 3);
      const double within = left(walled, "RadiusFilter 1 0");  // arcs may take a hundredth more
      QVERIFY(within < 90 + 1e-8 && within > 90 - 0.001);
      const double before = left(walled, "RadiusFilter 0 1");
      QVERIFY2(before < 72 + 1e-8 && before > 72 - 0.001, qPrintable(QString::number(before, 'g', 12)));
    }
  }

  void orderAndThreadsChangeNothing() {
    std::mt19937 random(static_cast<unsigned>(seed()));
    for (int i = 0; i < rounds(20); ++i) {
      std::vector<PartNumbers> parts(8);
      for (PartNumbers& part : parts)
        for (int& n : part) n = static_cast<int>(random() % 64);
      const auto environment = buildingOf(parts).environment();
      for (const char* numbers : {"0.3 0.6", "0.75 0"}) {
        const std::string text = kBefore + "RadiusFilter " + numbers + "\nSimplificationFilter\n";
        const NavigationMesh mesh = navigationMesh(runFilters(environment, text));
        QCOMPARE(findMeshError(mesh), std::string());
        std::vector<std::uint32_t> order(environment->triangles.size());
        std::iota(order.begin(), order.end(), 0U);
        std::shuffle(order.begin(), order.end(), random);
        NavigationMesh other;
        runWithThreads(1 + i % 3, [&] { other = navigationMesh(runFilters(shuffled(*environment, order, 1), text)); });
        QVERIFY(other.triangles == mesh.triangles && other.vertices == mesh.vertices);
      }
    }
  }
};

QTEST_GUILESS_MAIN(TestRadiusShadows)
#include "test_radius_shadows.moc"
