// A level that was turned, scaled or moved has the same walkable area, connected in the same way, when its coordinates
// are put on a grid again.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>

#include "core/pipeline/runner.hpp"
#include "footfall/inspect.hpp"
#include "footfall/pipeline.hpp"
#include "tests/support/changed_level.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

constexpr double kSameArea = 0.001, kSameShare = 0.01;  // of the area; of the share itself

struct Figures {
  double squareMetres = 0, share = 0;
};

Figures figuresOf(const std::shared_ptr<const Environment>& level) {
  RunContext context;
  const RunResult result = runPipeline(level, defaultPipeline(*level), context, nullptr, 2);
  return {result.summary.area * level->metresPerUnit * level->metresPerUnit,
          findComponents(*result.mesh).connectedShare()};
}

QString pathOf(const QString& name) {
  const QString sample = QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj").arg(name);
  return QFile::exists(sample) ? sample : sharedEnvironments() + "/" + name + ".obj";
}

}  // namespace

class TestTurnedLevels : public QObject {
  Q_OBJECT

 private slots:
  void areasAndShares_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("scale");
    QTest::addColumn<double>("offset");
    const auto add = [](const char* name, const char* how, const LevelChange& change) {
      QTest::addRow("%s %s", name, how) << QString(name) << change.degrees << change.scale << change.offset;
    };
    for (const char* name : {"house", "villa", "arena", "tower", "rooms", "docks", "nav_test", "level", "ot", "turbine",
                             "dutility", "complex", "steelribs", "fortitude"})
      add(name, "turned by 17 degrees", {17, 1, 0});
    for (const char* name : {"house", "rooms", "nav_test", "turbine", "complex"}) {
      add(name, "turned by 45 degrees", {45, 1, 0});
      add(name, "turned by 90 degrees", {90, 1, 0});
      add(name, "scaled by 0.0254", {0, 0.0254, 0});
      add(name, "moved by 10 km", {0, 1, 10000});
    }
    add("villa", "turned and moved", {17, 1, 10000.3});
    add("docks", "turned and scaled", {17, 0.0254, 0});
  }

  void areasAndShares() {
    QFETCH(QString, name);
    QFETCH(double, degrees);
    QFETCH(double, scale);
    QFETCH(double, offset);
    const QString path = pathOf(name);
    if (!QFile::exists(path)) QSKIP("the environment is not there");
    const auto level = importEnvironment(path.toStdString());
    if (known_.name != name) known_ = {name, figuresOf(level)};
    const Figures& original = known_.figures;
    const auto other = changedLevel(*level, {degrees, scale, offset});
    const Figures turned = figuresOf(other);
    const QString shown = QStringLiteral("area %1 for %2 m2, share %3 for %4, %5 welded")
                              .arg(turned.squareMetres)
                              .arg(original.squareMetres)
                              .arg(turned.share)
                              .arg(original.share)
                              .arg(other->grid.weldedVertices);
    qInfo().noquote() << shown;
    QVERIFY2(std::abs(turned.squareMetres - original.squareMetres) <= kSameArea * original.squareMetres,
             qPrintable(shown));
    QVERIFY2(std::abs(turned.share - original.share) <= kSameShare, qPrintable(shown));
  }

 private:
  struct {
    QString name;
    Figures figures;
  } known_;
};

QTEST_APPLESS_MAIN(TestTurnedLevels)
#include "test_turned_levels.moc"
