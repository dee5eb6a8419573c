// DropFilter: the cases that people have in mind.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>

#include "footfall/path.hpp"
#include "tests/support/drop_cases.hpp"
#include "tests/support/run_filters.hpp"

using namespace footfall;
using namespace footfall::test;

class TestDropFilter : public QObject {
  Q_OBJECT

 private slots:
  void oneDropsFromAPlatformAllAround() {
    const NavigationMesh mesh = dropped(platform(1), drops(1));
    QCOMPARE(mesh.drops.size(), std::size_t{4});
    QCOMPARE(lengthOf(mesh), 8.0);
    for (const DropLink& drop : mesh.drops) {
      QCOMPARE(drop.depth, 1.0);
      for (const int end : {0, 1}) {
        QCOMPARE(drop.start[end], mesh.vertices[drop.from[end]]);
        QCOMPARE(drop.landing[end], (Vec3{drop.start[end].x, drop.start[end].y, 0}));
      }
      const Triangle& t = mesh.triangles[drop.fromTriangle];
      QVERIFY(std::ranges::count(t, drop.from[0]) == 1 && std::ranges::count(t, drop.from[1]) == 1);
      for (const std::uint32_t v : mesh.triangles[drop.toTriangle]) QCOMPARE(mesh.vertices[v].z, 0.0);
    }
    QCOMPARE(findMeshError(mesh), std::string());
  }

  void theDepthIsAllowedAndNotMore() {
    QVERIFY(dropped(platform(1), drops(std::nextafter(1.0, 0))).drops.empty());
    QCOMPARE(dropped(platform(1), drops(1000)).drops.size(), std::size_t{4});  // deeper than the level
    QVERIFY(!dropped(platform(0.1), drops(0.1)).drops.empty());
  }

  void nobodyDropsOntoTheSameHeightOrUp() {
    QVERIFY(dropped(ledge(0, 0.2), drops(2)).drops.empty());
    QVERIFY(dropped(Soup().floor(0, 0, 4, 4, 0), drops(2)).drops.empty());
    const NavigationMesh mesh = dropped(platform(1), drops(2));
    QVERIFY(reaches(mesh, {4, 4, 1}, {1, 1, 0}));
    QVERIFY(!reaches(mesh, {1, 1, 0}, {4, 4, 1}));
  }

  void fencesOnTheLedge() {
    const auto fence = [](double height) { return platform(1).wall(5, 2, 5, 6, 1, 1 + height); };
    const std::string step = "StepFilter 0.4\n";
    QCOMPARE(lengthOf(dropped(fence(0.4), step + drops(1))), 8.0);  // stepped over
    QCOMPARE(lengthOf(dropped(fence(0.41), step + drops(1))), 6.0);
    QCOMPARE(lengthOf(dropped(fence(0.4), drops(1))), 6.0);  // The step is 0 without a StepFilter.
    // A fence over one half, and one that grows from nothing to the clearance: passable up to the step.
    for (const Soup& half :
         {platform(1).wall(5, 4, 5, 6, 1, 2), platform(1).triangle({5, 3, 1}, {5, 5, 1}, {5, 5, 1.8})}) {
      const double length = lengthOf(dropped(half, step + drops(1)));
      QVERIFY2(length <= 7 && length > 7 - 1e-9, qPrintable(QString::number(length, 'g', 17)));
    }
  }

  void ceilingsOverTheFall() {
    const auto roof = [](double z) { return platform(1).ceiling(5, 2, 6, 6, z); };
    QCOMPARE(lengthOf(dropped(roof(3), drops(1))), 8.0);  // exactly the clearance over the ledge
    QCOMPARE(lengthOf(dropped(roof(2.99), drops(1))), 6.0);
    QCOMPARE(lengthOf(dropped(roof(0.5), drops(1))), 6.0);  // an awning below the ledge
  }

  void theFallEndsOnTheFirstThing() {
    // A shelf under the ledge, too narrow for nothing: it catches who falls.
    const Soup soup = platform(1).box({5, 2, 0.5}, {5.5, 6, 0.6});
    const NavigationMesh mesh = dropped(soup, drops(1, 0), 0.3);
    QVERIFY(!mesh.drops.empty());
    for (const DropLink& drop : mesh.drops)
      if (drop.start[0].x == 5 && drop.start[1].x == 5 && drop.start[0].z == 1)
        for (const Vec3& p : drop.landing) QCOMPARE(p.z, 0.6);
    // Ground that is too steep to stand on catches nothing, and there are no landings on or behind it either.
    QCOMPARE(lengthOf(dropped(platform(1).quad({5, 2, 0.8}, {5, 6, 0.8}, {5.4, 6, 0}, {5.4, 2, 0}), drops(1, 0))), 6.0);
    QCOMPARE(lengthOf(dropped(platform(1).quad({5, 2, 0.8}, {5.4, 2, 0}, {5.4, 6, 0}, {5, 6, 0.8}), drops(1, 0))), 6.0);
  }

  void gapsWithinTheReach() {
    QVERIFY(dropped(ledge(1, 0.25), drops(2, 0.2)).drops.empty());
    const NavigationMesh mesh = dropped(ledge(1, 0.25), drops(2, 0.3));
    QCOMPARE(mesh.drops.size(), std::size_t{1});
    QVERIFY(std::fabs(mesh.drops[0].width - 4) < 1e-9);
    for (const int end : {0, 1}) QCOMPARE(mesh.drops[0].landing[end].x, 0.25);
    // The drop leads over a low wall in the gap, as far as the step goes; with obstacles behind it, too.
    const auto walled = [](double z) { return ledge(1, 0.25).wall(0.125, -1, 0.125, 5, 0, z); };
    QCOMPARE(dropped(walled(1.4), "StepFilter 0.4\n" + drops(2)).drops.size(), std::size_t{1});
    QVERIFY(dropped(walled(1.41), "StepFilter 0.4\n" + drops(2)).drops.empty());
    // A beam over the landing, lower than the head of who starts.
    QVERIFY(dropped(ledge(1, 0.25).ceiling(0.2, -1, 1, 5, 2.5), drops(2)).drops.empty());
    QCOMPARE(dropped(ledge(1, 0.25).ceiling(0.2, -1, 1, 5, 3), drops(2)).drops.size(), std::size_t{1});
    // A parapet that agents step over but do not stand on, and that is higher above the landing than an agent.
    const auto parapet = [](double top) {
      return Soup()
          .floor(-2, 0, 0, 4, 3)
          .quad({0, -1, 3}, {0.125, -1, top}, {0.125, 5, top}, {0, 5, 3})
          .wall(0.125, -1, 0.125, 5, 0, top)
          .floor(0.125, 0, 4, 4, 0);
    };
    QVERIFY(lengthOf(dropped(parapet(3.4), "StepFilter 0.4\n" + drops(3))) > 4 - 1e-9);
    QVERIFY(dropped(parapet(3.45), "StepFilter 0.4\n" + drops(3)).drops.empty());
  }

  void largerDepthAddsDropsAndTakesNoneAway() {
    // A shelf a little outwards, and the floor straight below.
    const Soup soup = Soup().floor(-2, 0, 0, 4, 3).floor(0.2, 0, 1, 4, 2).floor(-2, 0, 6, 4, 0);
    const NavigationMesh little = dropped(soup, drops(1), 1), much = dropped(soup, drops(3), 1);
    QVERIFY(reaches(little, {-1, 1, 3}, {0.5, 1, 2}));
    QVERIFY(!reaches(little, {-1, 1, 3}, {3, 1, 0}));
    QVERIFY(reaches(much, {-1, 1, 3}, {0.5, 1, 2}));
    QVERIFY(reaches(much, {-1, 1, 3}, {3, 1, 0}));
  }

  void stepsAreNoLedges() {
    Soup stairs;
    for (int i = 0; i < 4; ++i) {
      stairs.floor(i, 0, i + 1, 2, 0.25 * i);
      if (i > 0) stairs.wall(i, 0, i, 2, 0.25 * (i - 1), 0.25 * i);
    }
    QVERIFY(dropped(stairs, "StepFilter 0.25\n" + drops(2)).drops.empty());
    QCOMPARE(dropped(stairs, "StepFilter 0.2\n" + drops(2)).drops.size(), std::size_t{3});
    // Drops lead from each tread, beside the stairs.
    const Soup beside = Soup(stairs).floor(0, 2, 8, 6, -1);
    QCOMPARE(lengthOf(dropped(beside, "StepFilter 0.25\n" + drops(2))), 4.0);
    QCOMPARE(lengthOf(dropped(beside, "StepFilter 0.25\n" + drops(1.25))), 2.0);
  }

  void behindARadiusTheReachCrossesBothMargins() {
    const std::string filters = "RadiusFilter 0.25\n";
    QVERIFY(dropped(platform(1), filters + drops(2, 0.4)).drops.empty());
    const NavigationMesh mesh = dropped(platform(1), filters + drops(2, 0.6));
    QVERIFY(!mesh.drops.empty());
    QVERIFY(reaches(mesh, {4, 4, 1}, {1, 1, 0}));
    QVERIFY(!reaches(mesh, {1, 1, 0}, {4, 4, 1}));
  }

  // Obstacles cut one floor into thousands of triangles.
  void landingsLieInTheirTriangles() {
    Soup crates = Soup().floor(0, 0, 40, 40, 0);
    for (int i = 0; i < 100; ++i) {
      const double x = 2 + 3.7 * (i % 10) + 0.01 * (i % 7), y = 2 + 3.7 * (i / 10) + 0.01 * (i % 9);
      crates.box({x, y, 0}, {x + 1, y + 1, 1});
    }
    for (const std::string filters : {"", "SimplificationFilter\n", "RadiusFilter 0.1\nSimplificationFilter\n"}) {
      const NavigationMesh mesh = dropped(crates, filters + drops(1.5, 0.5));
      QVERIFY(mesh.triangles.size() > 600);
      QVERIFY2(mesh.drops.size() >= 400, qPrintable(QString::number(mesh.drops.size())));
      for (const DropLink& drop : mesh.drops) {
        const Vec3 &p = drop.landing[0], &q = drop.landing[1];
        const double x = (p.x + q.x) / 2, y = (p.y + q.y) / 2;
        for (int k = 0; k < 3; ++k) {
          const Vec3& a = mesh.vertices[mesh.triangles[drop.toTriangle][k]];
          const Vec3& b = mesh.vertices[mesh.triangles[drop.toTriangle][(k + 1) % 3]];
          QVERIFY((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x) >= -1e-9);
        }
      }
    }
  }
};

QTEST_GUILESS_MAIN(TestDropFilter)
#include "test_drop_filter.moc"
