// Sides near a triangle against looking at every side, and how many more than those are found.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "core/filters/layers/border_sides.hpp"
#include "core/filters/layers/growing_triangles.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

using Place = std::array<double, 2>;

double areaOf(const Place& a, const Place& b, const Place& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Exact for whole numbers below 2^25.
bool doTouch(const std::array<Place, 3>& triangle, const BorderSides::Side& side) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Place &a = triangle[k], &b = triangle[(k + 1) % 3];
    if (areaOf(a, b, side.begin) < 0 && areaOf(a, b, side.end) < 0) return false;
  }
  std::array<double, 3> areas{};
  for (std::size_t k = 0; k < 3; ++k) areas[k] = areaOf(side.begin, side.end, triangle[k]);
  return *std::ranges::min_element(areas) <= 0 && *std::ranges::max_element(areas) >= 0;
}

PlanTriangle planOf(const std::array<Place, 3>& corners) {
  PlanTriangle plan;
  for (std::size_t k = 0; k < 3; ++k) {
    plan.x[k] = corners[k][0];
    plan.y[k] = corners[k][1];
  }
  return plan;
}

std::vector<int> visitsOf(const BorderSides& sides, const PlanTriangle& plan, std::size_t count) {
  std::vector<int> visits(count, 0);
  sides.visitNear(plan, planBoundsOf(plan), [&](Index side) { ++visits[static_cast<std::size_t>(side)]; });
  return visits;
}

}  // namespace

class TestBorderSides : public QObject {
  Q_OBJECT

 private slots:
  void noSideIsMissed_data() {
    QTest::addColumn<double>("scale");
    QTest::addColumn<double>("moved");
    for (const double scale : {1.0, 0x1p-40, 0x1p40, 0x1p70, 0x1p-60})
      for (const double moved : {0.0, 0x1p18}) QTest::addRow("%g, %g", scale, moved) << scale << moved;
  }
  void noSideIsMissed();
  void placesWithoutBoundsAreFound();
  void needlesFindFewSides();
};

// Sides and triangles of all sizes, long and thin ones among them, on a grid on which doubles are exact.
void TestBorderSides::noSideIsMissed() {
  QFETCH(double, scale);
  QFETCH(double, moved);
  std::mt19937 random(3);
  const auto place = [&]() -> Place {
    const int size = 1 << random() % 12;
    const auto coordinate = [&] { return static_cast<double>(static_cast<int>(random() % (2 * size + 1)) - size); };
    const double x = coordinate();
    return {x + moved, (random() % 4 == 0 ? x + static_cast<double>(random() % 3) : coordinate()) - moved};
  };
  std::vector<BorderSides::Side> sides, scaled;
  for (Index i = 0; i < 600; ++i) {
    sides.push_back({i, place(), place(), 0});
    const auto at = [&](const Place& p) { return Place{p[0] * scale, p[1] * scale}; };
    scaled.push_back({i, at(sides.back().begin), at(sides.back().end), 0});
  }
  BorderSides tree;
  tree.build(scaled, [] {});
  std::size_t touched = 0;
  for (int n = 0; n < 600; ++n) {
    std::array<Place, 3> corners{place(), place(), place()};
    const double area = areaOf(corners[0], corners[1], corners[2]);
    if (area == 0) continue;
    if (area < 0) std::swap(corners[1], corners[2]);
    PlanTriangle plan = planOf(corners);
    for (std::size_t k = 0; k < 3; ++k) {
      plan.x[k] *= scale;
      plan.y[k] *= scale;
    }
    const std::vector<int> visits = visitsOf(tree, plan, sides.size());
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (!doTouch(corners, sides[i])) continue;
      ++touched;
      QVERIFY2(visits[i] > 0, qPrintable(QString("triangle %1, side %2").arg(n).arg(i)));
    }
  }
  QVERIFY(touched > 1000);
}

// A vertex that no double can place has an infinite error.
void TestBorderSides::placesWithoutBoundsAreFound() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  BorderSides tree;
  tree.build({{0, {1, 1}, {2, 2}, 0}, {1, {0, 0}, {0, 0}, kInfinity}, {2, {40, 50}, {41, 50}, 0}}, [] {});
  PlanTriangle plan = planOf({{{1, 1}, {3, 1}, {1, 3}}});
  std::vector<int> visits = visitsOf(tree, plan, 3);
  QVERIFY(visits[0] > 0 && visits[1] > 0 && visits[2] == 0);
  plan.error = kInfinity;
  visits = visitsOf(tree, plan, 3);
  QVERIFY(visits[0] > 0 && visits[1] > 0 && visits[2] > 0);
}

// The box of a needle of a disc touches those of a quarter of all sides of the rim.
void TestBorderSides::needlesFindFewSides() {
  for (const int corners : {1000, 16000}) {
    const auto at = [&](int step) -> Place {
      const double angle = 2 * std::numbers::pi * step / corners;
      return {3 + 50 * std::cos(angle), 50 * std::sin(angle) - 7};
    };
    std::vector<BorderSides::Side> sides;
    for (int i = 0; i < corners; ++i) sides.push_back({i, at(i), at(i + 1), 0x1p-40});
    BorderSides tree;
    tree.build(sides, [] {});
    int visits = 0;
    for (int i = 0; i < corners; ++i)
      for (const int found : visitsOf(tree, planOf({{{3, -7}, at(i), at(i + 1)}}), sides.size())) visits += found;
    QVERIFY2(visits >= 3 * corners - 10 && visits < 6 * corners, qPrintable(QString::number(visits)));
  }
}

QTEST_GUILESS_MAIN(TestBorderSides)
#include "test_border_sides.moc"
