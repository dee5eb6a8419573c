// Gaps between borders that go around corners: the ways over them lie side by side.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "tests/support/live_runs.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/filters/gap_agreement.hpp"

using namespace footfall;
using namespace footfall::test;
using namespace footfall::test::corners;

namespace {

/// Two floors around the origin, as far as `angles` goes, with a slit between them: corners of the inner floor are 2
/// from the origin, and those of the outer one are moved by `offsets`.
Soup curved(const std::vector<double>& angles, const std::vector<Vec3>& offsets) {
  Soup soup;
  const auto inner = [&](std::size_t i) { return Vec3{2 * std::cos(angles[i]), 2 * std::sin(angles[i]), 0}; };
  const auto moved = [&](std::size_t i, double factor) {
    return Vec3{factor * inner(i).x + offsets[i].x, factor * inner(i).y + offsets[i].y, offsets[i].z};
  };
  for (std::size_t i = 0; i + 1 < angles.size(); ++i)
    soup.triangle({0, 0, 0}, inner(i), inner(i + 1)).quad(moved(i, 1), moved(i, 2), moved(i + 1, 2), moved(i + 1, 1));
  return soup;
}
/// The same with twelve parts of 15 degrees, all with one offset.
Soup halfRing(const Vec3& offset) {
  std::vector<double> angles;
  for (int i = -6; i <= 6; ++i) angles.push_back(i * std::acos(-1.0) / 12);
  return curved(angles, std::vector<Vec3>(angles.size(), offset));
}
/// A random polyline with a slit of up to 0.04, which may turn by up to a right angle at each corner.
Soup randomlyCurved(std::mt19937& random) {
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  std::vector<double> angles{number(0, 6)};
  std::vector<Vec3> offsets;
  while (angles.size() < 6) angles.push_back(angles.back() + number(0.02, 0.7));
  const double rise = number(-0.2, 0.2), turn = number(0, 6.28);
  const bool isOneOffset = number(0, 1) < 0.5;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double own = isOneOffset ? turn : number(0, 6.28), width = isOneOffset ? 0.02 : number(0, 0.02);
    offsets.push_back(
        {0.02 * std::cos(angles[i]) + width * std::cos(own), 0.02 * std::sin(angles[i]) + width * std::sin(own), rise});
  }
  Soup soup = curved(angles, offsets);
  if (number(0, 1) < 0.3) {
    const double at = number(angles.front(), angles.back());
    soup.wall(2 * std::cos(at), 2 * std::sin(at), 2.03 * std::cos(at), 2.02 * std::sin(at), 0, number(0.1, 3));
  }
  return soup;
}
/// The number of sides of ways over gaps at which no other way goes on.
std::size_t openSides(const NavigationMesh& mesh) {
  std::map<std::array<std::uint32_t, 2>, int> ways;
  for (const StepLink& link : mesh.links)
    for (const int end : {0, 1}) {
      const auto [low, high] = std::minmax(link.from[end], link.to[1 - end]);
      if (link.kind == StepKind::Gap) ++ways[{low, high}];
    }
  return static_cast<std::size_t>(std::ranges::count_if(ways, [](const auto& way) { return way.second == 1; }));
}

}  // namespace

class TestGapCurves : public QObject {
  Q_OBJECT

 private slots:
  // Ways at a right angle to each pair of borders would leave a wedge at each corner.
  void waysOverACurvedSlitLieSideBySide() {
    for (const Vec3& offset : {Vec3{0.03, 0, 0.125}, Vec3{0.03, 0.003, -0.125}, Vec3{0.0375, 0, 0}}) {
      const Soup soup = halfRing(offset);
      const NavigationMesh mesh = linked(soup, 0.25, 0.08);
      QCOMPARE(gapCount(mesh), 12);
      QCOMPARE(openSides(mesh), 2);
      QCOMPARE(mesh.vertices.size(), 12 + 2 + 2 * 13);  // no border is divided
      // A margin is cut out at the ends only.
      const std::string radius = "RadiusFilter 0.3\nSimplificationFilter\n";
      const double ground = area(linked(soup, 0.25, 0.08, radius));
      const double closed = area(linked(halfRing({}), 0.25, 0.08, radius));
      QVERIFY2(std::fabs(ground - closed) < 0.02 * closed, qPrintable(QString("%1 %2").arg(ground).arg(closed)));
      QCOMPARE(linked(soup, 0.25, 0.08, "DropFilter 1 0").drops.size(), 0);
    }
  }

  // A way to a corner that is too long or blocked leaves the ways as they are without the corner.
  void cornersThatNothingLeadsTo() {
    const Soup soup = halfRing({0.03, 0, 0.125});
    const NavigationMesh narrow = linked(soup, 0.25, 0.0299);
    QVERIFY(gapCount(narrow) > 0);
    QVERIFY(openSides(narrow) > 2);
    const double x = 2.015 * std::cos(std::acos(-1.0) / 12), y = 2.015 * std::sin(std::acos(-1.0) / 12);
    const Soup blocked = Soup(soup).wall(x - 0.1, y, x + 0.1, y, 0, 2);
    QVERIFY(openSides(linked(blocked, 0.25, 0.08)) >= 4);
    Counts counts;
    QVERIFY(agrees(blocked.environment(), 0.25, 0.08, 1e-6, counts));
  }

  // Corners that lie exactly across from each other are farther apart than the gap: no way leads there.
  void cornersAcrossFromEachOtherThatAreTooFarApart() {
    const Soup soup = Soup()
                          .triangle({0, 0, 0}, {1, 0.0625, 0}, {0.5, 2, 0})
                          .triangle({1, -0.453125, 0}, {0, -0.390625, 0}, {0.5, -2, 0});
    const NavigationMesh mesh = linked(soup, 0.25, 0.5);
    QVERIFY(gapCount(mesh) > 0);
    for (const StepLink& link : mesh.links) QVERIFY(link.width <= 0.5 * (1 + 1e-12));
    Counts counts;
    QVERIFY(agrees(soup.environment(), 0.25, 0.5, 1e-6, counts));
  }

  // A way that leads along a slope begins lower than the floor is where a post stands beside the way.
  void postsBesideWaysAlongASlope() {
    const auto ramp = [](double begin, double y) {
      return Soup().quad({begin, y, begin / 2}, {begin + 1, y, begin / 2 + 0.5}, {begin + 1, y + 1, begin / 2 + 0.5},
                         {begin, y + 1, begin / 2});
    };
    for (const double at : {0.3, 0.5, 0.7, 0.9}) {
      const double top = at / 2 + 0.35;
      Soup soup = ramp(0, 0).add(ramp(0.15, -1.3));
      soup.box({at, -0.299, 0}, {at + 0.01, -0.28, top});
      Counts counts;
      QVERIFY2(agrees(soup.environment(), 0.4, 0.4, 1e-6, counts), qPrintable(QString::number(at)));
    }
  }

  // The rest that a later filter leaves of a way keeps its direction: no wedge opens at the corners that are left.
  void laterFiltersKeepWaysSideBySide() {
    const Soup soup = halfRing({0.03, 0, 0.125}).ceiling(1.5, -0.25, 2.5, 0.125, 2.5);
    const NavigationMesh mesh = linked(soup, 0.25, 0.08, "VerticalClearanceFilter 3\n");
    QCOMPARE(findMeshError(mesh), std::string());
    QCOMPARE(openSides(mesh), 4);
    QVERIFY(area(mesh) < area(linked(soup, 0.25, 0.08)) - 0.2);
  }

  void randomCurvesAgree() {
    Counts counts;
    std::mt19937 random(static_cast<std::uint32_t>(seed()));
    for (int i = 0; i < rounds(60); ++i)
      QVERIFY2(agrees(randomlyCurved(random).environment(), 0.25, 0.08, 1e-6, counts), qPrintable(QString::number(i)));
    qInfo("%zu links, %zu borders", counts.linked, counts.expected);
    QVERIFY(counts.linked > 60);
  }

  void editsGiveTheSame() {
    const std::string pipeline = gaps(0.25, 0.08, "SimplificationFilter\nLayerSubdivisionFilter\n");
    ResultCache cache;
    EditableEnvironment edited(halfRing({0.03, 0, 0.125}).environment());
    QVERIFY(test::agrees(edited.environment(), pipeline, cache));
    const auto crate = [](double x, double y) { return soupFor(Soup().box({x, y, 0}, {x + 0.4, y + 0.4, 1})); };
    const ObstacleId id = edited.add(crate(1.8, 0.1));
    for (const auto& [x, y] : {std::pair(1.9, 0.3), {1.0, 1.5}, {1.93, -0.5176}, {0.2, 0.2}}) {
      edited.replace(id, crate(x, y));
      QVERIFY2(test::agrees(edited.environment(), pipeline, cache), qPrintable(QString::number(x)));
    }
    edited.remove(id);
    QVERIFY(test::agrees(edited.environment(), pipeline, cache));
  }
};

QTEST_GUILESS_MAIN(TestGapCurves)
#include "test_gap_curves.moc"
