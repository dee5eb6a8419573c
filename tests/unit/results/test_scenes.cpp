// Generated scenes whose coordinates are off by their last bits: runs end, with work that follows the scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include "core/io/import.hpp"
#include "footfall/edit.hpp"
#include "footfall/path.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "tests/support/changed_level.hpp"
#include "tests/support/live_runs.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

constexpr int kTriangles = 12000;

QByteArray contents(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

int generate(const QStringList& arguments) {
  return QProcess::execute(FOOTFALL_BINARY_DIR "/footfall-samples", QStringList{"scene"} + arguments);
}

void addKinds() {
  QTest::addColumn<QString>("kind");
  for (const char* kind : {"town", "office", "foliage", "noise", "ramps", "stands"})
    QTest::newRow(kind) << QString(kind);
}

}  // namespace

class TestScenes : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;

 private slots:
  void theSameSeedGivesTheSameBytes_data() { addKinds(); }
  void theSameSeedGivesTheSameBytes() {
    QFETCH(QString, kind);
    const auto made = [&](const QString& seed) {
      const QString path = folder_.filePath("made.obj");
      return generate({kind, "3000", path, seed}) == 0 ? contents(path) : QByteArray();
    };
    const QByteArray first = made("1");
    QVERIFY(first.count("\nf ") >= 3000);
    QVERIFY(made("1") == first);
    QVERIFY(made("2") != first);
  }

  // Off the grid, no two coordinates agree. Edits give the bytes of runs from nothing, and the path finder that follows
  // them gives the paths of a new one.
  void editsOfTurnedScenes_data() {
    QTest::addColumn<QString>("kind");
    for (const char* kind : {"noise", "office"}) QTest::newRow(kind) << QString(kind);
  }
  void editsOfTurnedScenes() {
    QFETCH(QString, kind);
    const QString path = folder_.filePath("edited.obj");
    QCOMPARE(generate({kind, "5000", path, "3"}), 0);
    test::LevelChange turned;
    turned.degrees = 17;
    const auto level = test::changedLevel(*importEnvironment(path.toStdString()), turned, GridChoice::Off);
    const std::string pipeline = formatPipeline(defaultPipeline(*level));
    ResultCache cache;
    const RunResult first = test::run(level, pipeline, &cache);
    QVERIFY(!first.mesh->triangles.empty());
    auto finder = std::make_unique<const PathFinder>(first.mesh);
    EditableEnvironment editable(level);
    std::optional<ObstacleId> crate;
    std::mt19937 random(5);
    const auto anyPlace = [&](const NavigationMesh& mesh) {
      return mesh.vertices[mesh.triangles[random() % mesh.triangles.size()][random() % 3]];
    };
    for (int edit = 0; edit < 3; ++edit) {
      const Vec3 foot = anyPlace(*first.mesh);
      const double width = 0.3 + 0.1 * (edit % 3);
      const TriangleSoup box = test::soupFor(test::Soup().box({foot.x - width, foot.y - width, foot.z - 0.1},
                                                              {foot.x + width, foot.y + width, foot.z + 1}));
      if (crate)
        editable.replace(*crate, box);
      else
        crate = editable.add(box);
      QVERIFY(test::agrees(editable.environment(), pipeline, cache));
      const RunResult now = test::run(editable.environment(), pipeline, &cache);
      auto next = std::make_unique<const PathFinder>(now.mesh, *finder);
      finder = std::move(next);
      const PathFinder anew(now.mesh);
      for (int i = 0; i < 10; ++i) {
        const Vec3 from = anyPlace(*now.mesh), to = anyPlace(*now.mesh);
        const PathResult path = finder->find(from, to), expected = anew.find(from, to);
        QCOMPARE(path.status, expected.status);
        QCOMPARE(path.planLength, expected.planLength);
        QVERIFY(path.points == expected.points && path.triangles == expected.triangles);
      }
    }
  }

  void wrongArgumentsAreRefused() {
    const QString path = folder_.filePath("wrong.obj");
    for (const QStringList& arguments :
         {QStringList{"garden", "10", path}, {"town", "0", path}, {"town", "x", path}, {"town", "10", path, "0"}})
      QCOMPARE(generate(arguments), 2);
    QVERIFY(!QFile::exists(path));
  }

  // Work is counted, not timed: triangles and links after each step of the default pipeline.
  void workFollowsTheScene_data() { addKinds(); }
  void workFollowsTheScene() {
    QFETCH(QString, kind);
    const QString path = folder_.filePath(kind + ".obj");
    QCOMPARE(generate({kind, QString::number(kTriangles), path}), 0);
    const auto environment = importEnvironment(path.toStdString());
    for (const std::string more : {"LayerSubdivisionFilter\n", "RadiusFilter 0.3\nDropFilter 1.5\n"}) {
      const Pipeline pipeline = parsePipeline(
          "DuplicationFilter 0\nDegeneracyFilter\nSlopeFilter 45.01\nVerticalClearanceFilter 2\nStepFilter 0.4 0.05\n"
          "AreaFilter 1\nSimplificationFilter\n" +
              more,
          "test");
      RunContext context;
      const RunResult result = runPipeline(environment, pipeline, context, nullptr, 2);
      const std::uint64_t given = environment->triangles.size();
      for (const StepStatistics& step : result.steps)
        QVERIFY2(step.out.triangles <= 4 * given,
                 qPrintable(QString("%1: %2 of %3").arg(kind).arg(step.out.triangles).arg(given)));
      QVERIFY2(result.mesh->links.size() <= 2 * given,
               qPrintable(QString("%1: %2 links of %3").arg(kind).arg(result.mesh->links.size()).arg(given)));
      QVERIFY(!result.mesh->triangles.empty());
    }
  }
};

QTEST_GUILESS_MAIN(TestScenes)
#include "test_scenes.moc"
