// Meshes and materials as files name them, and the programs' texts about them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <string>
#include <vector>

#include "core/environment/part_names.hpp"
#include "core/io/obj_reader.hpp"
#include "tests/unit/environment_files.hpp"
#include "tests/unit/program_run.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// Labels of the triangles' parts, one after the other.
std::string labels(const Environment& environment) {
  std::string text;
  for (const std::uint32_t part : environment.partOf) text += partLabel(environment.parts[part]).str() + ' ';
  return text;
}

std::string labelsOf(const QByteArray& statements) { return labels(*importObjText(kSquare + statements)); }

/// About half a megabyte of faces, polygons among them, with parts that change inside of stretches and between them.
QByteArray manyParts() {
  QByteArray text(kSquare);
  for (int i = 0; i < 30000; ++i) {
    if (i % 977 == 0) text += "o object " + QByteArray::number(i % 7) + "\n";
    if (i % 1291 == 5) text += i % 2 == 0 ? "g\n" : "g group" + QByteArray::number(i % 5) + "\n";
    if (i % 613 == 3) text += "usemtl paint" + QByteArray::number(i % 3) + "\n";
    text += i % 3 == 0 ? "f 1 2 3 4\n" : "f 1 2 3\n";
    if (i % 100 == 0) text += "# " + QByteArray(900, '-') + "\n";
  }
  return text;
}

}  // namespace

class TestEnvironmentParts : public QObject {
  Q_OBJECT
 private slots:
  void objStatements_data() {
    QTest::addColumn<QByteArray>("statements");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char* name, const char* statements, const char* expected) {
      QTest::newRow(name) << QByteArray(statements) << QByteArray(expected);
    };
    row("none", "f 1 2 3\n", "");
    row("object", "o crate\nf 1 2 3\n", "crate ");
    row("material alone", "usemtl wood\nf 1 2 3\n", "wood ");
    row("both", "o crate\nusemtl wood\nf 1 2 3\n", "crate/wood ");
    row("nothing before the first", "f 1 2 3\no crate\nf 1 2 3\n", "(unnamed) crate ");
    row("a group divides an object", "o hall\nf 1 2 3\ng floor\nf 1 2 3\ng\nf 1 2 3\n", "hall floor hall ");
    row("the next object ends the group", "g floor\nf 1 2 3\no crate\nf 1 2 3\n", "floor crate ");
    row("a material stays for the next object", "usemtl wood\no a\nf 1 2 3\no b\nf 1 2 3\n", "a/wood b/wood ");
    row("back again", "o a\nf 1 2 3\no b\nf 1 2 3\no a\nf 1 2 3\n", "a b a ");
    row("polygons", "o a\nf 1 2 3 4\no b\nf 1 2 3\nf 1 2 3 4\no c\nf 1 2 3\n", "a a b b b c ");
    row("words, tabs and a comment", "o the\tbig crate  # old\nf 1 2 3\n", "the big crate ");
    row("a number sign in a name", "usemtl wood#2\nf 1 2 3\n", "wood#2 ");
    row("CR LF", "o a\r\nf 1 2 3\r\n", "a ");
    row("UTF-8", "o T\xC3\xBCr\nf 1 2 3\n", "T\xC3\xBCr ");
    row("Latin-1", "o T\xFCr\nf 1 2 3\n", "T\xC3\xBCr ");
    row("without faces", "o a\no b\nf 1 2 3\n", "b ");
  }
  void objStatements() {
    QFETCH(QByteArray, statements);
    QFETCH(QByteArray, expected);
    QCOMPARE(QByteArray::fromStdString(labelsOf(statements)), expected);
  }

  void partsComeInTheOrderOfTheirTriangles() {
    const auto environment = importObjText(QByteArray(kSquare) + "o z\no b\nf 1 2 3\no a\nf 1 2 3\no b\nf 1 2 3\n");
    QVERIFY(environment->parts == (std::vector<EnvironmentPart>{{"b", ""}, {"a", ""}}));
    QVERIFY(countPartTriangles(*environment) == (std::vector<std::uint64_t>{2, 1}));
  }

  void readingInStretchesNamesTheSameParts() {
    const std::string text = manyParts().toStdString();
    Environment stretches, whole;
    ObjGroups groups;
    readObj("a.obj", text, stretches, nullptr);
    readObj("a.obj", text, whole, nullptr, &groups);  // one pass
    QVERIFY(whole.parts.size() > 20 && whole.partOf.size() == whole.triangles.size());
    QVERIFY(stretches.triangles == whole.triangles && stretches.partOf == whole.partOf);
    QVERIFY(stretches.parts == whole.parts);
  }

  void cleanNames() {
    QCOMPARE(cleanName("a b"), std::string("a b"));
    QCOMPARE(cleanName("a\tb\x7F"), std::string("a b "));
    QCOMPARE(cleanName("\xE2\x82\xAC \xF0\x9F\x98\x80"), std::string("\xE2\x82\xAC \xF0\x9F\x98\x80"));
    for (const char* wrong : {"\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82", "\x80", "\xF8"}) {
      const QByteArray clean = QByteArray::fromStdString(cleanName(wrong));
      QCOMPARE(QString::fromUtf8(clean), QString::fromLatin1(wrong));
    }
  }

  void otherFormats() {
    QCOMPARE(QByteArray::fromStdString(labels(*importEnvironment(dataFile("transforms.gltf")))),
             QByteArray("scaled mirrored "));
    const auto stl = importEnvironment(dataFile("floor.stl"));
    QCOMPARE(stl->partOf.size(), stl->parts.empty() ? std::size_t{0} : stl->triangles.size());
    for (const char* name : {"z_up.dae", "z_up_inches.fbx", "floor.3ds", "polygons.ply"}) {
      const auto environment = importEnvironment(dataFile(name));
      QVERIFY2(environment->parts.empty() == environment->partOf.empty(), name);
      for (const std::uint32_t part : environment->partOf) QVERIFY(part < environment->parts.size());
    }
  }

  void infoListsParts() {
    const TemporaryFolder folder;
    const QString file = QString::fromStdString(folder.write(
        "a.obj", QByteArray(kSquare) + "o crate\nusemtl wood\nf 1 2 3\nf 1 3 4\no floor\nusemtl stone\nf 1 2 3\n"));
    const Outcome all = runProgram({"info", file});
    QVERIFY2(all.out.contains("  crate/wood: 2 triangles\n  floor/stone: 1 triangle\n"), all.out);
    const Outcome rest = runProgram({"info", file, "--ignore", "crate", "--obstacle-only", "stone", "--up", "z"});
    QVERIFY2(rest.out.contains("walkable at 45 degrees  0\n") && rest.out.contains("triangles               1\n"),
             rest.out);
  }

  void namesOnTheCommandLine() {
    const TemporaryFolder folder;
    const QString file =
        QString::fromStdString(folder.write("a.obj",
                                            "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 0 0 1\nv 4 0 1\nv 4 4 1\nv 0 4 1\n"
                                            "o ground\nusemtl stone\nf 1 2 3 4\no roof\nusemtl wood\nf 5 6 7 8\n"));
    const auto area = [&](const QStringList& arguments) {
      const Outcome outcome =
          runProgram(QStringList{"run", file, "--up", "z", "--filter", "SlopeFilter 45", "--filter",
                                 "VerticalClearanceFilter 2", "-o", QString::fromStdString(folder.path("out.obj"))} +
                     arguments);
      if (outcome.exitCode != 0) return outcome.err;
      const QByteArray text = readAll(folder.path("out.obj"));
      return QByteArray::number(text.count("\nf "));
    };
    QCOMPARE(area({}), QByteArray("2"));                           // area on the roof
    QCOMPARE(area({"--obstacle-only", "roof"}), QByteArray("0"));  // it still blocks
    QCOMPARE(area({"--ignore", "wood"}), QByteArray("2"));         // the ground is free
    QCOMPARE(area({"--ignore", "roof/wood", "--obstacle-only", "ground"}), QByteArray("0"));
    const QByteArray unknown = area({"--ignore", "rof"});
    QVERIFY2(unknown.contains("--ignore \"rof\"") && unknown.contains("\"ground\", \"stone\", \"roof\", \"wood\""),
             unknown);
    QVERIFY(area({"--ignore", "ground", "--ignore", "roof"}).contains("nothing of"));
    QCOMPARE(runProgram({"cells", file, "--ignore", "none"}).exitCode, 2);
    QCOMPARE(runProgram({"cells", file, "--ignore", "roof"}).exitCode, 0);
  }
};

QTEST_GUILESS_MAIN(TestEnvironmentParts)
#include "test_environment_parts.moc"
