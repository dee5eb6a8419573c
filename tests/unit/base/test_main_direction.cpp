// The main direction of a level: found where most edges are turned alike, and not where they follow the axes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

#include "core/base/main_direction.hpp"

using namespace footfall::detail;

namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Edges along and across a direction, in both senses, and `others` at random angles.
MainDirection edges(double degrees, int count, int others) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> turn(0, 360), length(1, 2);
  MainDirection direction;
  for (int i = 0; i < count + others; ++i) {
    const double angle = radians(i < count ? degrees + 90 * i : turn(random)), size = length(random);
    direction.add(size * std::cos(angle), size * std::sin(angle));
  }
  return direction;
}

}  // namespace

class TestMainDirection : public QObject {
  Q_OBJECT

 private slots:
  void directionOfTurnedEdgesIsFound() {
    for (const double degrees : {1.0, 17.0, 45.0, 60.0, 89.0, 200.0}) {
      const auto found = edges(degrees, 100, 100).find();
      QVERIFY(found.has_value());
      // Along or across the edges: the angle between them is a multiple of a right one.
      const double angle = std::atan2((*found)[1], (*found)[0]) - radians(degrees);
      QVERIFY(std::abs(std::sin(2 * angle)) < 0.01);
      QVERIFY(std::abs(std::hypot((*found)[0], (*found)[1]) - 1) < 1e-9);
    }
  }

  void edgesAlongTheAxesHaveNone() {
    for (const double degrees : {0.0, 90.0, 180.0, 270.0}) QVERIFY(!edges(degrees, 100, 100).find());
  }

  void edgesInAllDirectionsHaveNone() { QVERIFY(!edges(17, 0, 1000).find()); }

  void nothingAndNoLengthHaveNone() {
    MainDirection direction;
    QVERIFY(!direction.find());
    direction.add(0, 0);
    QVERIFY(!direction.find());
  }
};

QTEST_APPLESS_MAIN(TestMainDirection)
#include "test_main_direction.moc"
