// The counts of `footfall info`, on soups with known answers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "core/report/info.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

class TestInfo : public QObject {
  Q_OBJECT
 private slots:
  void closedTetrahedronHasNoOpenEdges() {
    const auto info =
        inspectEnvironment(*importObjText("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"));
    QCOMPARE(info.triangles, 4U);
    QCOMPARE(info.vertices, 4U);
    QCOMPARE(info.openEdges, 0U);
    QCOMPARE(info.nonManifoldEdges, 0U);
    QVERIFY(info.lower == (Vec3{0, 0, 0}) && info.upper == (Vec3{1, 1, 1}));
  }

  void edgesMeetByPositionNotByIndex() {
    const QByteArray vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 1 5\nv 9 9 9\n";
    const auto two = inspectEnvironment(*importObjText(vertices + "f 1 2 3\nf 4 6 5\n"));
    QCOMPARE(two.openEdges, 4U);
    QCOMPARE(two.nonManifoldEdges, 0U);
    const auto three = inspectEnvironment(*importObjText(vertices + "f 1 2 3\nf 4 6 5\nf 4 5 7\n"));
    QCOMPARE(three.nonManifoldEdges, 1U);
    QCOMPARE(three.openEdges, 6U);
  }

  void duplicatesInAnyOrderAndDegenerates() {
    const auto info = inspectEnvironment(
        *importObjText("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -0\nv 2 0 0\nf 1 2 3\nf 3 4 2\nf 2 1 3\nf 1 2 5\nf 1 2 4\n"));
    QCOMPARE(info.duplicate, 2U);
    QCOMPARE(info.degenerate, 2U);
    QCOMPARE(info.walkable45, 2U);
  }

  void slopeIsExactAt45Degrees() {
    const QByteArray ramp = "v 0 0 122000\nv 1 0 122001\nv 0 1 122000\nv 1 1 122001\n";
    const QByteArray steeper = "v 0 0 122000\nv 1 0 122001.00000000002\nv 0 1 122000\n";
    QCOMPARE(inspectEnvironment(*importObjText(ramp + "f 1 2 3\nf 2 4 3\n")).walkable45, 2U);
    QCOMPARE(inspectEnvironment(*importObjText(steeper + "f 1 2 3\n")).walkable45, 0U);
  }

  void bothSidesCountAsUp() {
    const TemporaryFolder folder;
    ImportOptions options;
    options.up = UpAxis::Z;
    const std::string path = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n");
    QCOMPARE(inspectEnvironment(*importEnvironment(path, options)).walkable45, 0U);
    options.bothSides = true;
    QCOMPARE(inspectEnvironment(*importEnvironment(path, options)).walkable45, 1U);
  }

  void textSaysEverything() {
    const auto environment = importObjText("v 0 0 -0.5\nv 1.25 0 0\nv 0 1 0\nl 1 2\np 1 2\nf 1 2\nf 1 2 3\n");
    const QString text = QString::fromStdString(formatInfo(*environment, inspectEnvironment(*environment)));
    for (const char* expected : {"x 0 to 1.25, y 0 to 1, z -0.5 to 0", "Z (given)", "1 (guessed)",
                                 "2 points, 1 line, 1 polygon", "walkable at 45 degrees  1\n", "open edges"}) {
      QVERIFY2(text.contains(expected), qPrintable(text));
    }
  }
};

QTEST_GUILESS_MAIN(TestInfo)
#include "test_info.moc"
