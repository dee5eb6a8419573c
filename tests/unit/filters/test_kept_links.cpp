// Links through the filters that follow a StepFilter: those that make the walkable area anew keep them where both
// borders are left.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "footfall/compare.hpp"
#include "footfall/errors.hpp"
#include "footfall/inspect.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::test;

namespace {

const std::string kClearance = "SlopeFilter 45\nVerticalClearanceFilter 2\n";

NavigationMesh result(const Soup& soup, const std::string& filters) {
  return navigationMesh(runFilters(soup.environment(), kClearance + filters));
}

double lengthOf(const NavigationMesh& mesh, StepKind kind) {
  double length = 0;
  for (const StepLink& link : mesh.links)
    if (link.kind == kind)
      length += std::hypot(mesh.vertices[link.from[0]].x - mesh.vertices[link.from[1]].x,
                           mesh.vertices[link.from[0]].y - mesh.vertices[link.from[1]].y);
  return length;
}
std::size_t parts(const NavigationMesh& mesh) { return findComponents(mesh).list.size(); }
bool haveEqualLinks(const NavigationMesh& a, const NavigationMesh& b) { return compareMeshes(a, b).hasEqualLinks(); }

/// Stairs of six treads of 0.25 with risers, and behind them a slit of 0.125.
Soup stairsAndSlit() {
  Soup soup;
  for (int i = 0; i < 6; ++i) {
    soup.floor(i, 0, i + 1, 2, 0.25 * i);
    if (i > 0) soup.wall(i, 0, i, 2, 0.25 * (i - 1), 0.25 * i);
  }
  return soup.floor(6.125, 0, 12, 2, 1.25);
}
/// The same at an angle, so that most of it is rounded, and under a slanted beam that cuts the treads.
Soup turned() {
  Soup soup = stairsAndSlit();
  soup.quad({0.3, 1.4, 1.5}, {6.4, 1.7, 2.6}, {6.4, 1.9, 2.6}, {0.3, 1.8, 1.5});
  return soup.mapped([](const Vec3& p) { return Vec3{0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y, p.z}; });
}

}  // namespace

class TestKeptLinks : public QObject {
  Q_OBJECT

 private slots:
  void aLowLintelPartsATallerAgent() {
    // 2.5 over the lower tread: 2.25 over the higher one.
    const Soup soup = Soup().floor(0, 0, 1, 2, 0).floor(1, 0, 2, 2, 0.25).wall(1, -1, 1, 3, 2.5, 4);
    const auto linked = [&](const char* more) { return result(soup, std::string("StepFilter 0.25 0\n") + more); };
    QCOMPARE(linked("").links.size(), std::size_t{1});
    QCOMPARE(linked("VerticalClearanceFilter 2.25\n").links.size(), std::size_t{1});  // exactly
    QCOMPARE(linked("VerticalClearanceFilter 2.26\n").links.size(), std::size_t{0});
    QCOMPARE(linked("VerticalClearanceFilter 1\n").links.size(), std::size_t{1});
    QCOMPARE(linked("RoundingFilter\nVerticalClearanceFilter 2.26\n").links.size(), std::size_t{0});
  }

  void aBarOverASlitPartsATallerAgent() {
    const Soup soup = Soup().floor(0, 0, 4, 4, 0).floor(4.125, 0, 8, 4, 0).box({4.03, 1, 2.25}, {4.06, 2, 2.5});
    const auto length = [&](const char* more) {
      return lengthOf(result(soup, std::string("StepFilter 0.25 0.25\n") + more), StepKind::Gap);
    };
    QCOMPARE(length(""), 4.0);
    QCOMPARE(length("VerticalClearanceFilter 2.25\n"), 4.0);
    QVERIFY(std::fabs(length("VerticalClearanceFilter 2.3\n") - 3) < 1e-9);
  }

  void onlyWhatWasLinkedIsLinkedAgain() {
    // A box in a slit parts it for who steps over 0.25; a later clearance of the same height must not close it.
    const Soup soup = Soup().floor(0, 0, 4, 4, 0).floor(4.125, 0, 8, 4, 0).box({4.03, 1, -1}, {4.06, 2, 0.5});
    for (const char* more : {"", "VerticalClearanceFilter 2\n", "VerticalClearanceFilter 2.5\n", "RoundingFilter\n",
                             "SimplificationFilter\nVerticalClearanceFilter 1\n", "StepFilter 0.25 0\n"}) {
      const NavigationMesh mesh = result(soup, std::string("StepFilter 0.25 0.25\n") + more);
      QVERIFY(std::fabs(lengthOf(mesh, StepKind::Gap) - 3) < 1e-9);
    }
  }

  void whatALargerClearanceTakesAwayTakesItsLinks() {
    // A ceiling of 2.5 over half of the stairs.
    const Soup soup = stairsAndSlit().ceiling(-1, 1, 13, 3, 2.5);
    const NavigationMesh mesh = result(soup, "StepFilter 0.25 0.25\nVerticalClearanceFilter 3\n");
    QCOMPARE(lengthOf(mesh, StepKind::Step), 5.0 * 1);
    QCOMPARE(lengthOf(mesh, StepKind::Gap), 1.0);
    QCOMPARE(parts(mesh), std::size_t{1});
    QVERIFY(haveEqualLinks(mesh, result(soup, "VerticalClearanceFilter 3\nStepFilter 0.25 0.25\n")));
    QCOMPARE(findMeshError(mesh), std::string());
  }

  void aSecondStepFilterAdds() {
    const Soup soup = stairsAndSlit();
    const NavigationMesh both = result(soup, "StepFilter 0.25 0\nStepFilter 0.1 0.2\n");
    QCOMPARE(lengthOf(both, StepKind::Step), 10.0);
    QCOMPARE(lengthOf(both, StepKind::Gap), 2.0);
    QCOMPARE(parts(both), std::size_t{1});
    QVERIFY(haveEqualLinks(both, result(soup, "StepFilter 0.1 0.2\nStepFilter 0.25 0\n")));
    QVERIFY(haveEqualLinks(both, result(soup, "StepFilter 0.25 0.2\nStepFilter 0.1 0.2\n")));
  }

  void newGenerationsKeepLinks_data() {
    QTest::addColumn<QString>("filters");
    for (const char* filters :
         {"RoundingFilter\n", "SimplificationFilter true\n", "SimplificationFilter true 0.01\n",
          "DuplicationFilter 0.000001\n", "DegeneracyFilter\n", "LayerSubdivisionFilter\nRoundingFilter\n",
          "SimplificationFilter\nRoundingFilter\nSimplificationFilter\n", "RoundingFilter\nVerticalClearanceFilter 1\n",
          "AreaFilter 4\nRoundingFilter\nAreaFilter 4\n",
          "SimplificationFilter\nAreaFilter 4\nVerticalClearanceFilter 2\n", "RoundingFilter\nStepFilter 0.1 0\n"})
      QTest::newRow(filters) << filters;
  }
  void newGenerationsKeepLinks() {
    QFETCH(QString, filters);
    for (const Soup& soup : {stairsAndSlit(), turned()}) {
      // The beam's top is a region of less than 4.
      const char* const area4 = filters.contains("AreaFilter") ? "AreaFilter 4\n" : "";
      const NavigationMesh before = result(soup, std::string("StepFilter 0.3 0.2\n") + area4);
      const NavigationMesh after = result(soup, "StepFilter 0.3 0.2\n" + filters.toStdString());
      QVERIFY(lengthOf(before, StepKind::Step) > 5 && lengthOf(before, StepKind::Gap) > 1);
      QCOMPARE(findMeshError(after), std::string());
      QVERIFY(std::fabs(lengthOf(after, StepKind::Step) - lengthOf(before, StepKind::Step)) < 1e-9);
      QVERIFY(std::fabs(lengthOf(after, StepKind::Gap) - lengthOf(before, StepKind::Gap)) < 1e-9);
      QCOMPARE(parts(after), parts(before));
      if (!filters.contains("0.01")) QVERIFY(std::fabs(area(after) - area(before)) < 1e-6);
    }
  }

  void roundingChangesNoLink() {
    std::size_t links = 0;
    for (int i = 0; i < rounds(150); ++i) {
      const fuzz::PipelineCase one = fuzz::makePipelineCase(seed() + 3000 + static_cast<std::uint64_t>(i));
      if (!one.roundingIsHarmless || one.soup.size() > 60) continue;
      const std::string text = minimalPipeline(one.clearance, one.slope) + "\nStepFilter " +
                               QString::number(one.clearance * 0.6, 'g', 17).toStdString() + " 0\n";
      const auto environment = one.soup.environment(one.bothSides);
      const NavigationMesh before = navigationMesh(runFilters(environment, text));
      const NavigationMesh after = navigationMesh(runFilters(environment, text + "RoundingFilter\n"));
      links += before.links.size();
      QVERIFY2(haveEqualLinks(before, after), qPrintable(QString("case %1").arg(i)));
      QCOMPARE(parts(after), parts(before));
    }
    qInfo("%zu links", links);
    QVERIFY(links > 50);
  }

  void mergingMovesNoLinkApart() {
    // Moved borders lose their link where it became wider or higher; the others keep it.
    Soup soup = stairsAndSlit();
    soup.floor(-4, 0, -0.0625, 2, 0).floor(-0.0625, 2.001, 1, 4, 0.125);
    const NavigationMesh before = result(soup, "StepFilter 0.25 0.125\n");
    const NavigationMesh after = result(soup, "StepFilter 0.25 0.125\nDuplicationFilter 0.07\n");
    QCOMPARE(findMeshError(after), std::string());
    QCOMPARE(lengthOf(after, StepKind::Step), lengthOf(before, StepKind::Step));
    for (const StepLink& link : after.links) QVERIFY(link.width <= 0.125 * (1 + 1e-12) && link.height <= 0.25);
    QVERIFY(parts(after) <= parts(before));
  }

  void anyFiltersMayFollow() {
    std::mt19937 random(11);
    std::size_t kept = 0;
    for (int i = 0; i < rounds(120); ++i) {
      const fuzz::PipelineCase one = fuzz::makePipelineCase(seed() + 20000 + static_cast<std::uint64_t>(i));
      if (one.clearance < 1e-6 || one.soup.size() > 200) continue;
      const QString numbers =
          QString("%1 %2").arg(0.4 * one.clearance, 0, 'g', 17).arg(0.02 * one.clearance, 0, 'g', 17);
      std::string text = minimalPipeline(one.clearance, one.slope) + "\nStepFilter " + numbers.toStdString() + "\n";
      text += fuzz::toPipelineText(one.anyFilters);
      const auto environment = one.soup.environment(one.bothSides);
      try {
        const NavigationMesh mesh = navigationMesh(runFilters(environment, text));
        QCOMPARE(findMeshError(mesh), std::string());
        kept += mesh.links.size();
        std::vector<std::uint32_t> order(environment->triangles.size());
        for (std::uint32_t t = 0; t < order.size(); ++t) order[t] = t;
        std::shuffle(order.begin(), order.end(), random);
        NavigationMesh other;
        runWithThreads(1 + i % 3, [&] { other = navigationMesh(runFilters(shuffled(*environment, order, 1), text)); });
        QVERIFY2(other.triangles == mesh.triangles && other.vertices == mesh.vertices, text.c_str());
        QVERIFY2(std::equal(other.links.begin(), other.links.end(), mesh.links.begin(), mesh.links.end(),
                            [](const StepLink& a, const StepLink& b) { return a.from == b.from && a.to == b.to; }),
                 text.c_str());
      } catch (const InputError&) {  // too small a height beside the coordinates
      }
    }
    qInfo("%zu links", kept);
    QVERIFY(kept > 50);
  }

  void liveEditsGiveTheSame() {
    const std::string pipeline = kClearance +
                                 "StepFilter 0.3 0.2\nAreaFilter 1\nVerticalClearanceFilter 2.5\nRoundingFilter\n"
                                 "SimplificationFilter\nLayerSubdivisionFilter\n";
    ResultCache cache;
    EditableEnvironment edited(turned().environment());
    QVERIFY(agrees(edited.environment(), pipeline, cache));
    const auto crate = [](double x, double y, double z) {
      return soupFor(Soup().box({x, y, z}, {x + 0.75, y + 0.75, z + 0.25}));
    };
    const ObstacleId id = edited.add(crate(1.5, 1, 0.25));
    for (int i = 0; i < 8; ++i) {
      edited.replace(id, crate(0.375 * i, 0.5 + 0.25 * (i % 5), 0.25 * (i / 3)));
      QVERIFY2(agrees(edited.environment(), pipeline, cache), qPrintable(QString::number(i)));
    }
  }
};

QTEST_GUILESS_MAIN(TestKeptLinks)
#include "test_kept_links.moc"
