// Buildings in IFC: the converter is found, run, refused and cancelled, with small converters of the suite's own.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cstdlib>
#include <thread>

#include "core/io/ifc_reader.hpp"
#include "footfall/errors.hpp"
#include "footfall/io.hpp"
#include "tests/unit/program_run.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

// A floor and a table on it, whatever the file says.
constexpr const char* kConverter = R"(import { writeFileSync } from 'node:fs';
writeFileSync(process.argv[3], `# Z up, metres
o Level 1: Floor (1)
usemtl IfcSlab
v 0 0 0
v 8 0 0
v 8 8 0
v 0 8 0
f 1 2 3
f 1 3 4
o Level 1: Table (2)
usemtl IfcFurniture
v 1 1 1
v 5 1 1
v 5 5 1
v 1 5 1
f 5 6 7
f 5 7 8
`);
)";

}  // namespace

class TestIfc : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    write(path("building.ifc"), "ISO-10303-21;\n");
    ::unsetenv("FOOTFALL_IFC");
  }
  void cleanup() { ::unsetenv("FOOTFALL_IFC"); }

  void whereTheConverterIs() {
    ::setenv("FOOTFALL_IFC", "/somewhere/else.mjs", 1);
    QCOMPARE(findIfcConverter(), std::string("/somewhere/else.mjs"));
    ::setenv("FOOTFALL_IFC", "", 1);
    QVERIFY(findIfcConverter().empty());
    ::unsetenv("FOOTFALL_IFC");
    const QByteArray before = qgetenv("XDG_DATA_HOME");
    qputenv("XDG_DATA_HOME", folder_->path().toUtf8());
    QVERIFY(QDir(folder_->path()).mkpath("footfall/ifc"));
    write(path("footfall/ifc/ifc_to_obj.mjs"), "");
    QCOMPARE(findIfcConverter(), path("footfall/ifc/ifc_to_obj.mjs").toStdString());
    if (before.isEmpty())
      qunsetenv("XDG_DATA_HOME");
    else
      qputenv("XDG_DATA_HOME", before);
  }

  void missingConverterIsTold() {
    ::setenv("FOOTFALL_IFC", "", 1);
    QVERIFY(missingIfcConverter("a.IFC").str().find("installer/ifc.sh") != std::string::npos);
    QVERIFY(missingIfcConverter("a.obj").empty());
    Environment environment;
    QVERIFY(!readIfc(path("building.ifc").toStdString(), environment, nullptr));
  }

  void convertedBuilding() {
    if (!hasNode()) QSKIP("Node.js is missing");
    useConverter(kConverter);
    QVERIFY(missingIfcConverter("a.ifc").empty());
    const Environment building = load(path("building.ifc").toStdString());
    QCOMPARE(building.triangles.size(), std::size_t{4});
    QVERIFY(building.up == UpAxis::Z && building.metresPerUnit == 1 && !building.scaleGuessed);
    QCOMPARE(building.parts.size(), std::size_t{2});
    QCOMPARE(building.parts[0].mesh, std::string("Level 1: Floor (1)"));
    QCOMPARE(building.parts[1].material, std::string("IfcFurniture"));
    QCOMPARE(building.source, path("building.ifc").toStdString());
  }

  // On the command line nobody walks on furniture.
  void furnitureIsAnObstacle() {
    if (!hasNode()) QSKIP("Node.js is missing");
    useConverter(kConverter);
    const Outcome outcome = runProgram({"run", path("building.ifc"), "-o", path("out.obj"), "--threads", "1"});
    QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    const QByteArray obj = contentOf(path("out.obj"));
    QVERIFY(obj.contains("v 8 8 0\n") && obj.contains("v 5 5 0\n") && !obj.contains("v 5 5 1\n"));
    QVERIFY(!outcome.err.contains("converter"));
  }

  void converterThatFails() {
    if (!hasNode()) QSKIP("Node.js is missing");
    useConverter("console.error('one'); console.error('broken: %1'); process.exit(1);");
    try {
      load(path("building.ifc").toStdString());
      QFAIL("reads it");
    } catch (const InputError& error) {
      const QByteArray text = error.what();
      QVERIFY2(text.contains("building.ifc: the converter for IFC cannot read it: broken: %1;"), text.constData());
      QVERIFY(text.count('\n') == 0);
    }
    useConverter("");  // writes nothing
    QVERIFY_EXCEPTION_THROWN(load(path("building.ifc").toStdString()), InputError);
  }

  void cancelling() {
    if (!hasNode()) QSKIP("Node.js is missing");
    useConverter("setTimeout(() => {}, 60000);");
    RunContext context;
    std::thread canceller([&context] {
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
      context.cancel();
    });
    QElapsedTimer clock;
    clock.start();
    QVERIFY_EXCEPTION_THROWN(load(path("building.ifc").toStdString(), {}, &context), Cancelled);
    canceller.join();
    QVERIFY2(clock.elapsed() < 10000, qPrintable(QString::number(clock.elapsed())));
  }

 private:
  QString path(const QString& name) const { return folder_->filePath(name); }
  void useConverter(const QByteArray& program) {
    write(path("converter.mjs"), program);
    ::setenv("FOOTFALL_IFC", path("converter.mjs").toUtf8().constData(), 1);
  }
  static bool hasNode() { return QProcess::execute("node", {"--version"}) == 0; }

  std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(TestIfc)
#include "test_ifc.moc"
