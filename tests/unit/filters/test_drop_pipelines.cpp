// DropFilter: what comes behind it, exports, live edits, and pipelines that cannot be.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "footfall/compare.hpp"
#include "footfall/errors.hpp"
#include "footfall/io.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "tests/support/drop_cases.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/support/run_filters.hpp"

using namespace footfall;
using namespace footfall::test;

namespace {

std::string errorOf(const Soup& soup, const std::string& filters) {
  try {
    runFilters(soup.environment(), filters);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

class TestDropPipelines : public QObject {
  Q_OBJECT

 private slots:
  void filtersBehindTakeDropsAlong() {
    const Soup soup = platform(1).add(platform(1.5).mapped([](const Vec3& p) { return Vec3{p.x + 8, p.y, p.z}; }));
    const std::string all = "SimplificationFilter\nLayerSubdivisionFilter\n" + drops(2);
    QCOMPARE(lengthOf(dropped(soup, all)), 16.0);
    QVERIFY(dropped(soup, all + "AreaFilter 4\n").drops.empty());  // platforms have 4 each
    QCOMPARE(lengthOf(dropped(soup, all + "AreaFilter 3.9\n")), 16.0);
    // Seeds: down is reached, up is not.
    const NavigationMesh down = dropped(soup, all + "ReachableFilter 4 4 1.5\n");
    QCOMPARE(area(down), 124.0);
    QCOMPARE(lengthOf(down), 8.0);
    const NavigationMesh ground = dropped(soup, all + "ReachableFilter 1 1 0.5\n");
    QCOMPARE(area(ground), 120.0);
    QVERIFY(ground.drops.empty());
  }

  void exportsAreReadBack() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.obj").toStdString();
    const NavigationMesh mesh = dropped(platform(1), "StepFilter 0.3\nLayerSubdivisionFilter\n" + drops(2));
    const std::vector<ExportExtra> extras{{"crate", soupFor(Soup().box({1, 1, 0}, {2, 2, 1}))}};
    save(mesh, path, {}, {}, extras);
    const NavigationMesh read = readNavigationMesh(path).mesh;
    QCOMPARE(read.vertices, mesh.vertices);
    QCOMPARE(read.triangles, mesh.triangles);
    QCOMPARE(read.drops.size(), mesh.drops.size());
    for (std::size_t i = 0; i < read.drops.size(); ++i) {
      QCOMPARE(read.drops[i].start, mesh.drops[i].start);
      QCOMPARE(read.drops[i].landing, mesh.drops[i].landing);
      QCOMPARE(read.drops[i].from, mesh.drops[i].from);
      QCOMPARE(read.drops[i].fromTriangle, mesh.drops[i].fromTriangle);
      QCOMPARE(read.drops[i].toTriangle, mesh.drops[i].toTriangle);
      QCOMPARE(read.drops[i].depth, 1.0);
      QCOMPARE(read.drops[i].width, 2.0);
    }
    QVERIFY(compareMeshes(mesh, read).equalDrops);
    ExportOptions without;
    without.drops = false;
    save(mesh, path, without, {}, extras);
    const NavigationMesh other = readNavigationMesh(path).mesh;
    QVERIFY(other.drops.empty());
    const MeshComparison comparison = compareMeshes(mesh, other);
    QVERIFY(comparison.equal() && !comparison.equalDrops);
    QCOMPARE(comparison.meshes[0].drops, std::size_t{4});
    QCOMPARE(comparison.meshes[0].dropLength, 8.0);
    QCOMPARE(comparison.meshes[0].deepestDrop, 1.0);
    QCOMPARE(comparison.meshes[1].drops, std::size_t{0});
  }

  void liveEditsGiveTheSame() {
    Soup level = platform(1).add(platform(1.5).mapped([](const Vec3& p) { return Vec3{p.x + 8, p.y, p.z}; }));
    const std::string pipeline = minimalPipeline(2) +
                                 "\nStepFilter 0.3\nAreaFilter 1\nSimplificationFilter\nLayerSubdivisionFilter\n" +
                                 drops(1.5) + "ReachableFilter 4 4 1.25\n";
    ResultCache cache;
    EditableEnvironment edited(level.environment());
    QVERIFY(agrees(edited.environment(), pipeline, cache));
    const auto crate = [](double x, double y, double z) {
      return soupFor(Soup().box({x, y, z}, {x + 0.75, y + 0.75, z + 0.5}));
    };
    const ObstacleId id = edited.add(crate(4.5, 4, 1));
    QVERIFY(agrees(edited.environment(), pipeline, cache));
    for (int i = 0; i < 8; ++i) {
      edited.replace(id, crate(2.25 + 0.375 * i, 2.5 + 0.25 * (i % 5), 0.25 * (i / 2)));
      QVERIFY2(agrees(edited.environment(), pipeline, cache), qPrintable(QString::number(i)));
    }
  }

  void pipelinesThatCannotBe_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("expected");
    QTest::newRow("no clearance") << "SlopeFilter 45\nDropFilter 1\n"
                                  << "p:2:1: DropFilter needs VerticalClearanceFilter before it";
    QTest::newRow("zero") << "VerticalClearanceFilter 2\nDropFilter 0\n"
                          << "p:2:12: ";
    QTest::newRow("negative") << "VerticalClearanceFilter 2\nDropFilter -1\n"
                              << "p:2:12: ";
    QTest::newRow("nan") << "VerticalClearanceFilter 2\nDropFilter nan\n"
                         << "p:2:12: ";
    QTest::newRow("negative reach") << "VerticalClearanceFilter 2\nDropFilter 1 -0.1\n"
                                    << "p:2:14: ";
    QTest::newRow("infinite reach") << "VerticalClearanceFilter 2\nDropFilter 1 inf\n"
                                    << "p:2:14: ";
    QTest::newRow("in a block") << "GridStrategy 2 2\nVerticalClearanceFilter 2\nDropFilter 1\nCollapse\n"
                                << "p:3:1: DropFilter needs all cells";
    for (const char* last : {"VerticalClearanceFilter 2", "RoundingFilter", "SimplificationFilter", "StepFilter 1",
                             "RadiusFilter 1", "LayerSubdivisionFilter", "SlopeFilter 45", "DuplicationFilter 0"})
      QTest::newRow(last) << QString("VerticalClearanceFilter 2\nDropFilter 1\n%1\n").arg(last)
                          << "p:3:1: " + QString(last).section(' ', 0, 0) + " would lose the drops";
  }
  void pipelinesThatCannotBe() {
    QFETCH(QString, text);
    QFETCH(QString, expected);
    try {
      parsePipeline(text.toStdString(), "p");
      QFAIL("it was accepted");
    } catch (const InputError& error) {
      QVERIFY2(QString(error.what()).startsWith(expected), error.what());
    }
  }

  void depthsThatAreTooSmall() {
    const Soup far = platform(1).mapped([](const Vec3& p) { return Vec3{p.x + 1e9, p.y, p.z}; });
    QVERIFY(errorOf(far, minimalPipeline(2) + "\n" + drops(1e-200)).starts_with("a drop of 1e-200 is too small"));
  }
};

QTEST_GUILESS_MAIN(TestDropPipelines)
#include "test_drop_pipelines.moc"
