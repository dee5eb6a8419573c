// RadiusFilter's promise on whole environments: 4,000 places of each, FOOTFALL_TEST_ROUNDS times, in short batches.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "footfall/io.hpp"
#include "tests/reference/radius_promise.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::test;
using reference::RadiusTally;

namespace {

constexpr int kBatch = 50000;

/// Batch after batch, on an environment that is prepared once.
class Batches {
 public:
  const reference::RadiusCase& of(const QString& file, double height, const reference::RadiusDistances& distances) {
    const QString name = QString("%1 %2 %3 %4").arg(file).arg(height).arg(distances.walls).arg(distances.ledges);
    if (prepared_ && name == name_) return *prepared_;
    prepared_.reset();
    prepared_ = std::make_unique<reference::RadiusCase>(
        importEnvironment(file.toStdString()), minimalPipeline(height) + "\nStepFilter " + std::to_string(height / 5),
        distances);
    name_ = name;
    return *prepared_;
  }

 private:
  QString name_;
  std::unique_ptr<reference::RadiusCase> prepared_;
};

}  // namespace

class TestRadiusPromise : public QObject {
  Q_OBJECT

 private slots:
  void isKept_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<double>("height");
    QTest::addColumn<double>("walls");
    QTest::addColumn<double>("ledges");
    QTest::addColumn<int>("batch");
    const int batches = (rounds(4000) - 1) / kBatch + 1;
    const auto addRows = [&](const QString& name, const QString& file, double height, double walls, double ledges) {
      for (int i = 0; i < batches; ++i)
        QTest::newRow(qPrintable(batches == 1 ? name : QString("%1, %2 of %3").arg(name).arg(i + 1).arg(batches)))
            << file << height << walls << ledges << i;
    };
    const auto add = [&](const char* name, const QString& file, double height) {
      const double radius = 0.15 * height;  // 0.3 m for 2 m
      addRows(name, file, height, radius, radius);
    };
    for (const char* name : {"nav_test", "complex", "fortitude"}) add(name, QString("%1.obj").arg(name), 2);
    add("level", "level.obj", 0.35);
    for (const char* name : {"ot", "turbine", "dutility", "steelribs"}) add(name, QString("%1.obj").arg(name), 40);
    for (const char* name : {"complex", "fortitude"})
      add(qPrintable(QString("%1 in units").arg(name)), QString("%1.obj").arg(name), 40);
    add("town", "town/town_model.gltf", 2);
    for (const char* name : {"LargeBuilding", "TallBuilding", "SimpleWall"})
      add(name, QString("ifc/%1.ifc").arg(name), 2);
    for (const char* name : {"house", "rooms", "villa", "arena", "docks", "tower"})
      add(name, QString(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj").arg(name), 2);
    // Walls and ledges have different distances.
    for (const char* name : {"house", "villa"})
      addRows(QString("%1, walls and ledges").arg(name), QString(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj").arg(name), 2,
              0.3, 0.1);
    addRows("proto-level, on a grid, walls and ledges", "scenes/proto-level.glb", 2, 0.3, 0.1);
    addRows("nav_test, walls alone", "nav_test.obj", 2, 0.3, 0);
    addRows("villa, ledges more", QString(FOOTFALL_SOURCE_DIR "/samples/villa/villa.obj"), 2, 0.3, 0.6);
    addRows("villa, walls alone", QString(FOOTFALL_SOURCE_DIR "/samples/villa/villa.obj"), 2, 0.3, 0);
  }
  void isKept() {
    QFETCH(QString, file);
    QFETCH(double, height);
    QFETCH(double, walls);
    QFETCH(double, ledges);
    QFETCH(int, batch);
    const bool isShared = !file.startsWith('/');
    if (isShared && sharedEnvironments().isEmpty()) QSKIP("the shared environments are not here; set FOOTFALL_SHARED");
    std::mt19937 random(static_cast<unsigned>(seed()) + static_cast<unsigned>(batch));
    const RadiusTally tally = batches_.of(isShared ? sharedEnvironments() + "/" + file : file, height, {walls, ledges})
                                  .look(std::min(kBatch, rounds(4000) - batch * kBatch), random);
    qInfo("%zu places nearer, %zu farther, %zu between, %zu on needles, %zu near them, %zu wrong", tally.near,
          tally.far, tally.between, tally.onNeedles, tally.doubtful, tally.wrong);
    for (const std::string& report : tally.reports) qWarning("%s", report.c_str());
    QCOMPARE(tally.wrong, std::size_t{0});
    QVERIFY(tally.near + tally.far > 10 * tally.doubtful);
    QVERIFY(tally.near > 0);
  }

  // Rounding to a grid makes half of the upright walls lean away from the floors at their feet.
  void wallsThatAGridTiltsAreWalls() {
    constexpr double kGrid = 0x1p-12;
    const auto areaWith = [](double lean, double grid) {
      Soup soup = Soup().floor(0, 0, 8, 8, 0);
      soup.quad({8, 0, 0}, {8, 8, 0}, {8 + lean, 8, 4}, {8 + lean, 0, 4});
      const auto environment = soup.environment();
      environment->grid.step = grid;
      return area(
          navigationMesh(runFilters(environment, minimalPipeline(2) + "\nStepFilter 0.25\nRadiusFilter 1 0.25\n")));
    };
    const double besideWall = areaWith(0, 0), besideLedge = areaWith(1, 0);
    QVERIFY(std::fabs(besideWall - 7.5 * 6.75) < 0.2 && std::fabs(besideLedge - 7.5 * 7.5) < 0.2);
    QVERIFY(std::fabs(areaWith(kGrid, 0) - besideLedge) < 1e-6);
    QVERIFY(std::fabs(areaWith(kGrid, kGrid) - besideWall) < 1e-6);
    QVERIFY(std::fabs(areaWith(-kGrid, kGrid) - besideWall) < 0.01);
    QVERIFY(std::fabs(areaWith(64 * kGrid, kGrid) - besideLedge) < 1e-6);
  }

 private:
  Batches batches_;
};

QTEST_GUILESS_MAIN(TestRadiusPromise)
#include "test_radius_promise.moc"
