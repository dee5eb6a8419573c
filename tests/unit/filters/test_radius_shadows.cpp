// RadiusFilter with two distances, behind a border that keeps less away: what is known to be wrong there.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <random>

#include "tests/reference/border_distance.hpp"
#include "tests/reference/radius_promise.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::test;
using reference::RadiusTally;

namespace {

const std::string kBefore = minimalPipeline(2) + "\nStepFilter 0.4\n";

}  // namespace

// The smallest cases of docs/decisions.md ("What a radius is measured on").
class TestRadiusShadows : public QObject {
  Q_OBJECT

 private slots:
  // The floor's triangles reach around the wall's ends: the ledge takes what lies behind the wall, too.
  void aWallBeforeALedge() {
    const Soup room = Soup().floor(0, 0, 10, 10, 0).wall(3, 0.5, 7, 0.5, 0, 3);
    std::mt19937 random(static_cast<unsigned>(seed()));
    const RadiusTally equal = reference::lookAtRadius(room.environment(), kBefore, {1, 1}, rounds(6000), random);
    QCOMPARE(equal.wrong, std::size_t{0});
    const RadiusTally two = reference::lookAtRadius(room.environment(), kBefore, {0, 1}, rounds(6000), random);
    QVERIFY(two.near > 1000 && two.far > 1000);
    QEXPECT_FAIL("", "triangles that are reached are taken behind other borders, too", Continue);
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
    QEXPECT_FAIL("", "walks past the end of another border are not told", Continue);
    QVERIFY(!isLeft("1 0"));
  }
};

QTEST_GUILESS_MAIN(TestRadiusShadows)
#include "test_radius_shadows.moc"
