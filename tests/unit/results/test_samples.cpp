// The samples in the repository are the generator's output, and agree with their README.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "core/io/import.hpp"
#include "core/report/info.hpp"
#include "footfall/pipeline.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

QString sampleFile(const QString& name, const QString& extension) {
  return QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/%1/%1.%2").arg(name, extension);
}

QByteArray contents(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class TestSamples : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir generated_;

 private slots:
  void initTestCase();
  void filesAreWhatTheGeneratorMakes_data();
  void filesAreWhatTheGeneratorMakes();
  void sizes_data();
  void sizes();
  void coordinatesLieOnTheGrid_data();
  void coordinatesLieOnTheGrid();
  void pipelinesParse_data();
  void pipelinesParse();
  void villaHasMeshErrors();
  void aSmallCityIsTheBeginningOfALargerOne();
};

namespace {

void addSampleRows() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"house", "villa", "docks", "arena", "tower", "rooms"}) QTest::newRow(name) << QString(name);
}

}  // namespace

void TestSamples::initTestCase() {
  QVERIFY(generated_.isValid());
  QCOMPARE(QProcess::execute(FOOTFALL_BINARY_DIR "/footfall-samples", {generated_.path()}), 0);
}

void TestSamples::filesAreWhatTheGeneratorMakes_data() { addSampleRows(); }
void TestSamples::filesAreWhatTheGeneratorMakes() {
  QFETCH(QString, name);
  const QByteArray made = contents(generated_.filePath(name + "/" + name + ".obj"));
  QVERIFY(!made.isEmpty());
  QVERIFY2(made == contents(sampleFile(name, "obj")), "write it again: footfall-samples samples");
}

void TestSamples::aSmallCityIsTheBeginningOfALargerOne() {
  const auto city = [this](const QString& triangles) {
    const QString path = generated_.filePath("city.obj");
    const int code = QProcess::execute(FOOTFALL_BINARY_DIR "/footfall-samples", {"city", triangles, path});
    return code == 0 ? contents(path) : QByteArray();
  };
  const QByteArray small = city("1"), large = city("60000");
  QVERIFY(small.count("\nf ") > 10000 && large.count("\nf ") >= 60000);
  QVERIFY(large.startsWith(small) && large.size() > small.size());
  QVERIFY(city("60000") == large);
  for (const char* wrong : {"", "0", "-1", "1e6", "100x"}) QVERIFY(city(wrong).isEmpty());
}

void TestSamples::sizes_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<int>("fewestTriangles");
  QTest::addColumn<int>("mostTriangles");
  QTest::newRow("house") << "house" << 820 << 820;
  QTest::newRow("villa") << "villa" << 29000 << 31000;
  QTest::newRow("docks") << "docks" << 58000 << 60000;
  QTest::newRow("arena") << "arena" << 19500 << 20500;
  QTest::newRow("tower") << "tower" << 440 << 440;
  QTest::newRow("rooms") << "rooms" << 266 << 266;
}

void TestSamples::sizes() {
  QFETCH(QString, name);
  QFETCH(int, fewestTriangles);
  QFETCH(int, mostTriangles);
  const auto environment = importEnvironment(sampleFile(name, "obj").toStdString());
  const int triangles = static_cast<int>(environment->triangles.size() + environment->skipped.polygons);
  QVERIFY2(triangles >= fewestTriangles && triangles <= mostTriangles, qPrintable(QString::number(triangles)));
  QCOMPARE(environment->up, UpAxis::Y);
  QCOMPARE(environment->metresPerUnit, 1.0);
  if (name == "tower") QCOMPARE(environment->vertices.size(), std::size_t{272});
}

void TestSamples::coordinatesLieOnTheGrid_data() { addSampleRows(); }
void TestSamples::coordinatesLieOnTheGrid() {
  QFETCH(QString, name);
  const auto environment = importEnvironment(sampleFile(name, "obj").toStdString());
  for (const Vec3& vertex : environment->vertices)
    for (double coordinate : {vertex.x, vertex.y, vertex.z}) {
      QVERIFY(std::isfinite(coordinate));
      QCOMPARE(coordinate * 64, std::round(coordinate * 64));
      QVERIFY(std::abs(coordinate) <= 200);
    }
}

void TestSamples::pipelinesParse_data() { addSampleRows(); }
void TestSamples::pipelinesParse() {
  QFETCH(QString, name);
  const Pipeline pipeline = readPipelineFile(sampleFile(name, "pipeline").toStdString());
  QCOMPARE(pipeline.steps.size(), std::size_t{8});
}

void TestSamples::villaHasMeshErrors() {
  const auto environment = importEnvironment(sampleFile("villa", "obj").toStdString());
  const EnvironmentInfo info = inspectEnvironment(*environment);
  QVERIFY(info.degenerate > 0 || environment->skipped.polygons > 0);
  QVERIFY(info.duplicate > 100);
  QVERIFY(info.nonManifoldEdges > 100);
}

QTEST_GUILESS_MAIN(TestSamples)
#include "test_samples.moc"
