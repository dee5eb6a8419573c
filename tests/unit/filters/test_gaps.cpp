// StepFilter across gaps: the cases that people expect, exports, paths, other filters and edits.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/mesh/gap_bridges.hpp"
#include "footfall/compare.hpp"
#include "footfall/errors.hpp"
#include "footfall/inspect.hpp"
#include "footfall/io.hpp"
#include "footfall/path.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/unit/filters/gap_cases.hpp"

using namespace footfall;
using namespace footfall::test;

class TestGaps : public QObject {
  Q_OBJECT

 private slots:
  void slitsAreSteppedOver() {
    for (const double width : {0.25, 1e-3, 0x1p-50, 0x1p-30}) {
      const NavigationMesh mesh = linked(slit(width, 0.25), 2, 0.25, 0.5);
      QCOMPARE(gapCount(mesh), std::size_t{1});
      const StepLink& link = mesh.links[0];
      QCOMPARE(link.height, 0.25);
      const double exact = mesh.vertices[link.to[0]].x - mesh.vertices[link.from[0]].x;
      QVERIFY(link.width >= std::fabs(exact) && link.width <= std::fabs(exact) * (1 + 1e-13));
      QCOMPARE(parts(mesh), std::size_t{1});
      QCOMPARE(pathParts(mesh), 1U);
      QCOMPARE(findMeshError(mesh), std::string());
      QCOMPARE(mesh.triangles.size(), std::size_t{4});  // nothing was cut
    }
    QCOMPARE(gapCount(linked(slit(0.25), 2, 0.25, 0.25)), std::size_t{1});  // exactly the maximum is stepped over
    QCOMPARE(gapCount(linked(slit(0.25, 0.25), 2, 0.249, 0.5)), std::size_t{0});
    QCOMPARE(gapCount(linked(slit(0.25), 2, 0.25, std::nextafter(0.25, 0))), std::size_t{0});
    QCOMPARE(gapCount(linked(slit(0.25), 2, 0.25, 0)), std::size_t{0});
  }

  void floorsThatMissEachOtherSidewaysAreCut() {
    const Soup soup = Soup().floor(0, 0, 4, 4, 0).floor(4.125, 1, 8, 3.0625, 0.1);
    const NavigationMesh mesh = linked(soup, 2, 0.25, 0.25);
    QCOMPARE(gapLength(mesh), 2.0625);
    for (const StepLink& link : mesh.links)  // grid coordinates are hit exactly
      for (const int end : {0, 1}) QCOMPARE(mesh.vertices[link.from[end]].y, mesh.vertices[link.to[1 - end]].y);
  }

  void whatStandsInASlitBlocksIt() {
    const auto with = [](double low, double high) { return slit(0.125).wall(4.0625, -1, 4.0625, 5, low, high); };
    QCOMPARE(gapCount(linked(with(-1, 0.25), 2, 0.25, 0.25)), std::size_t{1});  // stepped over
    QCOMPARE(gapCount(linked(with(-1, 0.26), 2, 0.25, 0.25)), std::size_t{0});
    QCOMPARE(gapCount(linked(with(2, 3), 2, 0.25, 0.25)), std::size_t{1});  // walked under
    QCOMPARE(gapCount(linked(with(1.99, 3), 2, 0.25, 0.25)), std::size_t{0});
    QCOMPARE(gapCount(linked(slit(0.125).ceiling(-1, -1, 9, 5, 2), 2, 0.25, 0.25)), std::size_t{1});
  }

  void aDoorwayWithoutAThreshold() {
    // Jambs that end the slit exactly, a lintel as high as the clearance.
    Soup soup = Soup().floor(0, 1, 4, 2, 0).floor(4.25, 1, 8, 2, 0);
    soup.box({4, 0, 0}, {4.25, 1, 3}).box({4, 2, 0}, {4.25, 3, 3}).box({4, 1, 2}, {4.25, 2, 3});
    const NavigationMesh mesh = linked(soup, 2, 0.25, 0.25 + 1e-6);
    QCOMPARE(gapCount(mesh), std::size_t{1});
    QCOMPARE(gapLength(mesh), 1.0);
    QVERIFY(PathFinder(std::make_shared<const NavigationMesh>(mesh)).find({1, 1.5, 0}, {7, 1.5, 0}).reached());
  }

  void onlyTheFreePartIsLinked() {
    const NavigationMesh mesh = linked(slit(0.125).box({3.9, 1, 0.5}, {4.2, 2, 1}), 2, 0.25, 0.25);
    QVERIFY(std::fabs(gapLength(mesh) - 3) < 1e-9);
    QCOMPARE(parts(mesh), std::size_t{2});  // the floors, and the box's top
  }

  void bordersAtAnAngle() {
    // The gap begins at a common corner, between two places as far from it, until these are 0.25 apart.
    const Soup soup = Soup()
                          .quad({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0})
                          .quad({4, 0, 0.1}, {8, 0, 0.1}, {8, 4, 0.1}, {5, 4, 0.1});
    const NavigationMesh mesh = linked(soup, 2, 0.25, 0.25);
    QVERIFY(gapCount(mesh) >= 1);
    QVERIFY(std::fabs(gapLength(mesh) - 0.125 / std::sin(std::atan(0.25) / 2)) < 1e-6);
    QCOMPARE(pathParts(mesh), 1U);
    // The link that begins at the corner is a triangle: both edges begin there, and go along one of the borders each.
    const auto from = [&](const std::array<std::uint32_t, 2>& edge, int end) { return mesh.vertices[edge[end]]; };
    std::size_t triangles = 0;
    for (const StepLink& link : mesh.links) {
      const bool isFirst = from(link.from, 0).z == 0;
      const auto &low = isFirst ? link.from : link.to, &high = isFirst ? link.to : link.from;
      for (const int end : {0, 1}) {
        const Vec3 p = from(low, end), q = from(high, 1 - end);
        QVERIFY(p.x == 4 && p.z == 0 && std::fabs(q.x - 4 - q.y / 4) < 1e-14 && q.z == 0.1);
        QVERIFY(std::fabs(p.y - std::hypot(q.x - 4, q.y)) < 1e-9);  // as far from the corner
        if (p.y == 0 && q.y == 0) ++triangles;
      }
      QCOMPARE(bridgeOver(link, mesh.vertices).size(), std::size_t{from(low, 0).y == 0 ? 1U : 2U});
    }
    QCOMPARE(triangles, std::size_t{1});
  }

  void aWedgeBarelyTooWideIsLinkedAsFarAsItIsNot() {
    // The gap goes from 0.125 to 0.25, and the limit is less than that by less than the conditions resolve.
    const Soup soup = Soup().floor(0, 0, 4, 4, 0).quad({4.125, 0, 0}, {8, 0, 0}, {8, 4, 0}, {4.25, 4, 0});
    const double angle = std::atan(1.0 / 32);
    const double widest = 0.25 * std::cos(angle) / std::cos(angle / 2);  // across the bisector, at the first one's end
    for (const double less : {-1e-14, 0.0, 1e-15, 3e-15, 1e-14, 1e-12}) {
      const NavigationMesh mesh = linked(soup, 2, 0.25, widest - less);
      QVERIFY2(gapLength(mesh) > 3.99, qPrintable(QString::number(less)));
      for (const StepLink& link : mesh.links) QVERIFY(link.width <= (widest - less) * (1 + 1e-12));
    }
  }

  void pathsLeadOverGaps() {
    const auto mesh = std::make_shared<const NavigationMesh>(linked(slit(0.25), 2, 0.25, 0.5));
    const PathResult path = PathFinder(mesh).find({1, 1, 0}, {7.25, 3, 0});
    QVERIFY(path.reached());
    QCOMPARE(path.planLength, std::hypot(6.25, 2.0));
    QCOMPARE(path.gaps.size(), std::size_t{1});
    QVERIFY(path.steps.empty());
    const std::size_t piece = path.gaps[0];
    QCOMPARE(path.points[piece].x, 4.0);
    QCOMPARE(path.points[piece + 1].x, 4.25);
    for (const std::uint32_t t : path.triangles) QVERIFY(t < mesh->triangles.size());
    QCOMPARE(path.triangles.size() + 1, path.points.size());
    // Nobody stands in the slit.
    QVERIFY(!PathFinder(mesh).locate({4.1, 1, 0}));
  }

  void radiusLeavesGapsOpen() {
    const auto remaining = [](double gap) { return area(linked(slit(0.25), 2, 0.25, gap, "RadiusFilter 0.5\n")); };
    QVERIFY(std::fabs(remaining(0.5) - 3.5 * 3 * 2) < 0.01 * 4);
    QVERIFY(std::fabs(remaining(0) - 3.0 * 3 * 2) < 0.01 * 4);
    const NavigationMesh mesh = linked(slit(0.25), 2, 0.25, 0.5, "RadiusFilter 0.5\n");
    QCOMPARE(parts(mesh), std::size_t{1});
    QVERIFY(std::fabs(gapLength(mesh) - 3) < 0.02);
  }

  void radiusKeepsAwayFromTheEndsOfGaps() {
    // The second floor faces only the middle of the first one's side.
    const Soup soup = Soup().floor(0, 0, 4, 8, 0).floor(4.25, 2, 8, 6, 0);
    const NavigationMesh mesh = linked(soup, 2, 0.25, 0.5, "RadiusFilter 0.5\n");
    QCOMPARE(parts(mesh), std::size_t{1});
    for (const Vec3& v : mesh.vertices)
      for (const Vec3& end : {Vec3{4, 2, 0}, Vec3{4, 6, 0}, Vec3{4.25, 2, 0}, Vec3{4.25, 6, 0}})
        QVERIFY(std::hypot(v.x - end.x, v.y - end.y) >= 0.5);
    QVERIFY(gapLength(mesh) > 2.9 && gapLength(mesh) <= 3);
  }

  void exportsAreReadBackAndCompared() {
    const QTemporaryDir folder;
    Soup soup = slit(0.25, 0.125).floor(8.25, 0, 9, 4, 0.25);  // a gap and a step
    const NavigationMesh mesh = linked(soup, 2, 0.25, 0.5);
    QCOMPARE(mesh.links.size(), std::size_t{2});
    const std::string path = folder.filePath("a.obj").toStdString();
    save(mesh, path);
    const NavigationMesh read = readNavigationMesh(path).mesh;
    QCOMPARE(read.links.size(), std::size_t{2});
    const auto gapOf = [](const NavigationMesh& m) {
      return *std::ranges::find(m.links, StepKind::Gap, &StepLink::kind);
    };
    QCOMPARE(gapOf(read).from, gapOf(mesh).from);
    QCOMPARE(gapOf(read).to, gapOf(mesh).to);
    QCOMPARE(gapOf(read).width, gapOf(mesh).width);
    QCOMPARE(gapOf(read).height, gapOf(mesh).height);
    QCOMPARE(gapOf(read).fromTriangle, gapOf(mesh).fromTriangle);
    QVERIFY(compareMeshes(mesh, read, {}).hasEqualLinks());
    const MeshComparison other = compareMeshes(mesh, linked(soup, 2, 0.25, 0.1), {});
    QVERIFY(!other.hasEqualLinks());
    QCOMPARE(other.meshes[0].gaps, std::size_t{1});
    QCOMPARE(other.meshes[1].gaps, std::size_t{0});
    ExportOptions without;
    without.steps = false;
    save(mesh, path, without);
    QVERIFY(readNavigationMesh(path).mesh.links.empty());
  }

  void laterFiltersKeepGaps() {
    const Soup soup = slit(0.25).floor(-5, 0, 0, 4, 0).floor(0, 4, 4, 8, 0);
    const NavigationMesh mesh =
        linked(soup, 2, 0.25, 0.5, "AreaFilter 17\nSimplificationFilter\nLayerSubdivisionFilter\n");
    QCOMPARE(area(mesh), 16.0 + 16 + 20 + 16);
    QCOMPARE(gapCount(mesh), std::size_t{1});
    QCOMPARE(parts(mesh), std::size_t{1});
    QCOMPARE(area(linked(soup, 2, 0.25, 0, "AreaFilter 17\n")), 16.0 + 20 + 16);
  }

  void wrongNumbersAreRefused() {
    for (const char* gap : {"-1", "nan", "x"}) {
      try {
        parsePipeline(std::string("VerticalClearanceFilter 2\nStepFilter 0.4 ") + gap + "\n", "p");
        QFAIL("it was accepted");
      } catch (const InputError& error) {
        QVERIFY2(QString(error.what()).startsWith("p:2:16: "), error.what());
      }
    }
    QCOMPARE(formatPipeline(parsePipeline("VerticalClearanceFilter 2\nStepFilter 0.4\n", "p")),
             std::string("VerticalClearanceFilter 2\nStepFilter 0.4\n"));
  }

  void liveEditsGiveTheSame() {
    Soup level = slit(0.03125).floor(-6, 0, 0, 4, 0.25).floor(0.3, 4.03125, 7, 8, -0.2).floor(0, -3, 2, -0.04, 0.1);
    const std::string pipeline = gaps(2, 0.3, 0.05) + "AreaFilter 1\nSimplificationFilter\nLayerSubdivisionFilter\n";
    ResultCache cache;
    EditableEnvironment edited(level.environment());
    QVERIFY(agrees(edited.environment(), pipeline, cache));
    const auto crate = [](double x, double y, double z) {
      return soupFor(Soup().box({x, y, z}, {x + 0.75, y + 0.75, z + 0.25}));
    };
    const ObstacleId id = edited.add(crate(3.5, 1, 0));
    QVERIFY(agrees(edited.environment(), pipeline, cache));
    for (int i = 0; i < 12; ++i) {
      edited.replace(id, crate(0.375 * i, 0.5 + 0.7 * (i % 5), 0.25 * (i / 3)));
      QVERIFY2(agrees(edited.environment(), pipeline, cache), qPrintable(QString::number(i)));
    }
    for (const double gap : {0.05, 0.0, 0.02, 0.1})  // other parameters on the same level
      QVERIFY(agrees(edited.environment(), gaps(2, 0.3, gap) + "AreaFilter 1\nSimplificationFilter\n", cache));
    edited.remove(id);
    QVERIFY(agrees(edited.environment(), pipeline, cache));
    QVERIFY(agrees(edited.environment(), gaps(2, 0.3, 0.05) + "RadiusFilter 0.2\n", cache));
  }
};

QTEST_GUILESS_MAIN(TestGaps)
#include "test_gaps.moc"
