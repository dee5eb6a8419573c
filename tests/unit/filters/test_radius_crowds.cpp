// RadiusFilter where much meets at one place: long thin triangles, overlapping floors; and cancelling there.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <random>

#include "footfall/pipeline.hpp"
#include "tests/reference/radius_promise.hpp"
#include "tests/support/cancelled_run.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::test;

namespace {

const std::string kBefore = minimalPipeline(2) + "\n";

/// The corners of the round square about a post: arcs are divided at less than 17 degrees.
constexpr std::size_t kCorners = 4 * (6 + 2);

/// Posts of an eighth in a row, one after each metre, on a floor that is 10 wide.
Soup posts(int count) {
  Soup soup = Soup().floor(-5, -5, count + 5, 5, 0);
  for (int i = 0; i < count; ++i) soup.box({static_cast<double>(i), 0, 0}, {static_cast<double>(i) + 0.125, 0.125, 3});
  return soup;
}

/// A strip that is 2 wide, with teeth that are 1 wide and 4 long.
Soup comb(int teeth) {
  Soup soup;
  std::vector<double> xs;
  for (int i = 0; i < 2 * teeth; ++i) xs.push_back(i);
  // One long edge below, corners above.
  soup.triangle({0, 0, 0}, {xs.back(), 0, 0}, {xs.back(), 2, 0});
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) soup.triangle({0, 0, 0}, {xs[i + 1], 2, 0}, {xs[i], 2, 0});
  for (int i = 0; i < teeth; ++i) soup.floor(2 * i, 2, 2 * i + 1, 6, 0);
  return soup;
}

std::size_t trianglesLeft(const Soup& soup, double radius) {
  return navigationMesh(runFilters(soup.environment(), kBefore + "RadiusFilter " + std::to_string(radius) + "\n"))
      .triangles.size();
}

}  // namespace

class TestRadiusCrowds : public QObject {
  Q_OBJECT

 private slots:
  void trianglesGrowInLine() {
    for (const auto& make : {posts, comb}) {
      const std::size_t some = trianglesLeft(make(300), 0.3), more = trianglesLeft(make(1200), 0.3);
      QVERIFY2(more < 4.5 * static_cast<double>(some), qPrintable(QString("%1, %2").arg(some).arg(more)));
      QVERIFY2(some < 300 * 2 * kCorners, qPrintable(QString::number(some)));
    }
  }

  void thePromiseIsKeptThere() {
    std::mt19937 random(static_cast<unsigned>(seed()));
    for (const auto& make : {posts, comb}) {
      const Soup level = make(300), turned = level.mapped([](const Vec3&p) {
        return Vec3{0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y, p.z};
      });
      for (const Soup* soup : {&level, &turned}) {
        const reference::RadiusTally tally =
            reference::lookAtRadius(soup->environment(), kBefore, {0.3, 0.3}, rounds(4000), random);
        for (const std::string& report : tally.reports) qWarning("%s", report.c_str());
        QCOMPARE(tally.wrong, std::size_t{0});
        QVERIFY(tally.near > 100 && tally.far > 100);
      }
    }
  }

  void simplificationTakesItAllBack() {
    const std::string more = "RadiusFilter 0.25\nSimplificationFilter\n";
    const NavigationMesh left = navigationMesh(runFilters(posts(400).environment(), kBefore + more));
    const NavigationMesh again =
        navigationMesh(runFilters(posts(400).environment(), kBefore + more + "SimplificationFilter\n"));
    QVERIFY(left.triangles == again.triangles);
    QVERIFY2(left.triangles.size() < 400 * 2 * kCorners, qPrintable(QString::number(left.triangles.size())));
  }

  // Floors overlap without a clearance, and three triangles meet at an edge.
  void allWaysOnAreTaken() {
    Soup soup;
    soup.floor(0, 0, 5, 6, 0).floor(0, 6, 5, 10, 0);  // Left of x = 5.
    soup.floor(5, 0, 10, 6, 0).floor(5, 6, 10, 10, 0);
    soup.ramp(5, 0, 10, 6, 0, 2);  // The ramp is over one of them; its side begins at (5, 6).
    const NavigationMesh left =
        navigationMesh(runFilters(soup.environment(), std::string("SlopeFilter 45\nRadiusFilter 0.5\n")));
    const reference::BorderDistance places(left);
    for (const Vec3& p : {Vec3{5.25, 6.25, 0}, Vec3{4.75, 6.25, 0}, Vec3{4.75, 5.75, 0}, Vec3{6, 5.75, 0.4}})
      QVERIFY2(!places.find(p.x, p.y, p.z, 1e-6), qPrintable(QString("%1 %2").arg(p.x).arg(p.y)));
    for (const Vec3& p : {Vec3{5.375, 6.375, 0}, Vec3{4.5, 5, 0}, Vec3{6, 5.25, 0.4}, Vec3{6, 5.75, 0}})
      QVERIFY2(places.find(p.x, p.y, p.z, 1e-6), qPrintable(QString("%1 %2").arg(p.x).arg(p.y)));
  }

  void cancelsInTime() {
    const auto environment = posts(2500).environment();
    const Pipeline pipeline = parsePipeline(kBefore + "RadiusFilter 0.3\n", "test");
    const double all = stepCpuMs(environment, pipeline, 2);
    for (const double share : {0.05, 0.2, 0.4, 0.6, 0.8}) {
      const auto known = cpuMsAfterCancelling(environment, pipeline, 2, share * all);
      QVERIFY2(known, "the run was over each time before it was cancelled");
      QVERIFY2(*known < 50, qPrintable(QString("%1 ms at %2").arg(*known).arg(share)));
    }
  }
};

QTEST_GUILESS_MAIN(TestRadiusCrowds)
#include "test_radius_crowds.moc"
