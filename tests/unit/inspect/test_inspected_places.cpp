// Why a place is walkable or not: thousands of random places against the definitions, one by one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "core/io/import.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/environment_files.hpp"
#include "tests/unit/inspect/explained_places.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;
using reference::Linear;
using reference::Point2;
using reference::Rational;

class TestInspectedPlaces : public QObject {
  Q_OBJECT

 private slots:
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

  // Grid points, which lie on edges, corners and walls all the time, count as a hair beside, towards the middle.
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

QTEST_APPLESS_MAIN(TestInspectedPlaces)
#include "test_inspected_places.moc"
