// The table of export formats: the format of a name, and the stated losses.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "core/io/formats/detour_export.hpp"
#include "core/io/formats/format_table.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/report.hpp"
#include "tests/unit/environment_files.hpp"
#include "tests/unit/program_run.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

class TestFormatTable : public QObject {
  Q_OBJECT
 private slots:
  void namesChooseTheFormat() {
    QVERIFY(exportFormatOf("a") == ExportFormat::Obj);
    QVERIFY(exportFormatOf("a.OBJ") == ExportFormat::Obj);
    QVERIFY(exportFormatOf("a.b/c.Gltf") == ExportFormat::Gltf);
    QVERIFY(exportFormatOf("a.bin") == ExportFormat::Detour);
    QVERIFY(exportFormatOf("a.tres") == ExportFormat::Godot);
    for (const FormatDescriptor& format : exportFormats())
      QVERIFY(exportFormatOf(std::string("x") + format.ending) == format.format);
    const QString refusal = messageOf<InputError>([] { exportFormatOf("a.fbx"); });
    for (const FormatDescriptor& format : exportFormats()) QVERIFY(refusal.contains(format.ending));
  }

  void whatIsLostIsSaid() {
    NavigationMesh mesh;
    mesh.layerCount = 3;
    mesh.drops.resize(1);
    const auto said = [&](ExportFormat format, const ExportOptions& options = {}) {
      return QString::fromStdString(lossesOf(format, mesh, options).str());
    };
    QCOMPARE(said(ExportFormat::Obj), QString());
    QCOMPARE(said(ExportFormat::Glb), QString());
    QCOMPARE(said(ExportFormat::Detour), QString());
    QCOMPARE(said(ExportFormat::Godot), QString("3 layers, 1 drop"));
    ExportOptions options;
    options.layers = options.drops = false;
    QCOMPARE(said(ExportFormat::Godot, options), QString());
    mesh.layerCount = 60;
    QCOMPARE(said(ExportFormat::Detour), QString("the areas of 3 layers"));
  }

  void theHeaderHasTheAgentsNumbers() {
    const AgentNumbers none = agentNumbers({});
    QVERIFY(!none.maxSlope && !none.height);
    QCOMPARE(none.step, 0.0);
    const AgentNumbers numbers =
        makeExportHeader(parsePipeline("SlopeFilter 45\nSlopeFilter 30\nVerticalClearanceFilter 1.5\n"
                                       "VerticalClearanceFilter 2\nStepFilter 0.4 0.1\nRadiusFilter 0.3\n",
                                       "test"))
            .numbers;
    QCOMPARE(*numbers.maxSlope, 30.0);
    QCOMPARE(*numbers.height, 2.0);
    QCOMPARE(numbers.step, 0.4);
    QCOMPARE(numbers.gap, 0.1);
    QCOMPARE(numbers.radius, 0.3);
  }

  void theCommandLineWritesAllAndSaysWhatIsLost() {
    const TemporaryFolder folder;
    const QString tower = FOOTFALL_SOURCE_DIR "/samples/tower/tower.obj";
    for (const FormatDescriptor& format : exportFormats()) {
      if (format.format == ExportFormat::Detour && !hasDetour()) continue;
      const QString out = QString::fromStdString(folder.path("level")) + format.ending;
      const Outcome outcome = runProgram({"run", tower, "-o", out});
      QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
      const QString first = format.format == ExportFormat::Wkt ? QString(out).replace(".wkt", "-0.wkt") : out;
      QVERIFY2(QFileInfo(first).size() > 200, qPrintable(first));
      QCOMPARE(outcome.err.contains("cannot hold"), format.format == ExportFormat::Godot);
    }
    const QString out = QString::fromStdString(folder.path("three.tres"));
    QCOMPARE(runProgram({"run", tower, "--quiet", "--godot", "3", "-o", out}).err, QByteArray());
    QVERIFY(contentOf(out).contains("format=2"));
    QCOMPARE(runProgram({"run", tower, "--godot", "5", "-o", out}).exitCode, 2);
    const QByteArray help = runProgram({"run", "--help"}).out;
    for (const FormatDescriptor& format : exportFormats()) QVERIFY(help.contains(format.ending));
  }

  void filesOfOtherKindsAreNotReplaced() {
    const TemporaryFolder folder;
    const QString tower = FOOTFALL_SOURCE_DIR "/samples/tower/tower.obj";
    for (const char* name : {"level.bin", "level.tres"}) {
      if (exportFormatOf(name) == ExportFormat::Detour && !hasDetour()) continue;
      const QByteArray other = "[gd_resource type=\"SpatialMaterial\" format=2]\n";
      const QString out = QString::fromStdString(folder.write(name, other));
      const Outcome refused = runProgram({"run", tower, "-o", out});
      QCOMPARE(refused.exitCode, 2);
      QVERIFY(refused.err.contains("is not a navigation mesh; choose another name"));
      QCOMPARE(contentOf(out), other);
      QVERIFY(messageOf<InputError>([&] { save({}, out.toStdString()); }).contains("is not a navigation mesh"));
      QVERIFY(QFile::remove(out));
      QCOMPARE(runProgram({"run", tower, "--quiet", "-o", out}).exitCode, 0);
      QCOMPARE(runProgram({"run", tower, "--quiet", "-o", out}).exitCode, 0);  // its own may go
    }
  }

  void godotsNodeOfAGltf() {
    const TemporaryFolder folder;
    const QString out = QString::fromStdString(folder.path("level.gltf"));
    const QString tower = FOOTFALL_SOURCE_DIR "/samples/tower/tower.obj";
    QCOMPARE(runProgram({"run", tower, "--quiet", "--navmesh-node", "-o", out}).exitCode, 0);
    const QByteArray text = contentOf(out);
    QVERIFY(text.contains("\"walkable-navmesh\""));
    QVERIFY(!text.contains("\"layer_0\""));
  }
};

QTEST_GUILESS_MAIN(TestFormatTable)
#include "test_format_table.moc"
