// Reading OBJ: exact numbers, every form of the statements, and one-line errors with the place.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>
#include <unistd.h>

#include <QtTest>
#include <clocale>
#include <cmath>
#include <limits>

#include "core/environment/skipped_polygons.hpp"
#include "core/io/import.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// About a megabyte of all statements.
QByteArray longText(const QByteArray& lineEnd) {
  QByteArray text;
  for (int i = 0; i < 8000; ++i) {
    const auto corner = [&](int k) { return QByteArray::number(3 * i + k); };
    text += "# group " + QByteArray::number(i) + lineEnd;
    for (int k = 0; k < 3; ++k)
      text += "v " + QByteArray::number(i * 0.37) + " " + QByteArray::number(k * (i % 7)) + " " +
              QByteArray::number(k % 2 * 1.5) + lineEnd;
    text += "vn 0 0 1" + lineEnd + "f " + corner(1) + "//1 " + corner(2) + " " + corner(3) + lineEnd;
    if (i % 5 == 0) text += "f " + corner(1) + " " + corner(2) + " " + corner(3) + " " + corner(4) + lineEnd;
    if (i % 11 == 0) text += "p 1 2" + lineEnd + "l 1 2" + lineEnd + "f 1 2" + lineEnd;
  }
  return text + "v 0 0 9" + lineEnd;
}

}  // namespace

class TestImport : public QObject {
  Q_OBJECT
 private slots:
  void coordinatesAreTheNearestDoubles() {
    const auto environment = importObjText(
        "v 122000.123 487000.456 0.1\n"
        "v 4417.123456789 +2.5e-3 -.5\n"
        "v 9007199254740993 1e-999 5.\n"
        "v 0.1000000000000000055511151231257827021181583404541015625 4.9e-324 -1.7976931348623157e308\n"
        "f 1 2 3\n");
    const std::vector<Vec3> expected = {
        {122000.123, 487000.456, 0.1},
        {4417.123456789, 0.0025, -0.5},
        {9007199254740992.0, 0.0, 5.0},
        {0.1, std::numeric_limits<double>::denorm_min(), -std::numeric_limits<double>::max()}};
    QVERIFY(environment->vertices == expected);
  }

  void numbersDoNotDependOnTheLocale() {
    const char* old = std::setlocale(LC_NUMERIC, nullptr);
    const std::string kept = old;
    std::setlocale(LC_NUMERIC, "de_DE.UTF-8");  // stays as it was where the locale is not installed
    const auto environment = importObjText("v 1.5 2.25 1e-999\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    std::setlocale(LC_NUMERIC, kept.c_str());
    QVERIFY(environment->vertices[0] == (Vec3{1.5, 2.25, 0}));
  }

  void negativeZeroBecomesZero() {
    const auto environment = importObjText("v -0 -0.0 -1e-999\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Vec3& p = environment->vertices[0];
    QVERIFY(!std::signbit(p.x) && !std::signbit(p.y) && !std::signbit(p.z));
  }

  void faceForms_data() {
    QTest::addColumn<QByteArray>("faces");
    QTest::newRow("v") << QByteArray("f 1 2 3\n");
    QTest::newRow("v/t") << QByteArray("f 1/1 2/2 3/3\n");
    QTest::newRow("v//n") << QByteArray("f 1//1 2//-1 3//1\n");
    QTest::newRow("v/t/n") << QByteArray("f 1/1/1 2/1/1 3/1/1\n");
    QTest::newRow("v/") << QByteArray("f 1/ 2/ 3/\n");
    QTest::newRow("negative") << QByteArray("f -3 -2 -1\n");
    QTest::newRow("continued") << QByteArray("f 1 \\\n 2\\\n 3\n");
    QTest::newRow("continued with CR LF") << QByteArray("f 1 \\\r\n 2 3\r\n");
    QTest::newRow("comment at the end") << QByteArray("f 1 2 3 # first\n");
    QTest::newRow("tabs and blanks") << QByteArray("  f\t1  2\t3   \n");
    QTest::newRow("no line end") << QByteArray("f 1 2 3");
    QTest::newRow("CR LF") << QByteArray("f 1 2 3\r\n");
    QTest::newRow("comment that ends in a backslash") << QByteArray("# C:\\models\\\nf 1 2 3\n");
    QTest::newRow("other statements") << QByteArray(
        "mtllib a b.mtl\nusemtl \xC3\xA4\nvt 0 0\nvn 0 0 \\\n 1\nvp 1\ns off\no x\ng a b\nf 1 2 3\ncall x\n");
  }
  void faceForms() {
    QFETCH(QByteArray, faces);
    const auto environment = importObjText(kTriangle + faces);
    QVERIFY(environment->triangles == (std::vector<Triangle>{{0, 1, 2}}));
  }

  void vertexForms_data() {
    QTest::addColumn<QByteArray>("vertex");
    QTest::newRow("plain") << QByteArray("v 1 2 3\n");
    QTest::newRow("weight") << QByteArray("v 1 2 3 0.5\n");
    QTest::newRow("colour") << QByteArray("v 1 2 3 0.5 0.25 1\n");
    QTest::newRow("continued") << QByteArray("v 1 2\\\n 3\n");
    QTest::newRow("comment") << QByteArray("v 1 2 3 # here\n");
  }
  void vertexForms() {
    QFETCH(QByteArray, vertex);
    const auto environment = importObjText(vertex + "v 0 0 0\nv 1 1 0\nf 1 2 3\n");
    QVERIFY(environment->vertices[0] == (Vec3{1, 2, 3}));
    QCOMPARE(environment->vertices.size(), std::size_t{3});
  }

  void loneCarriageReturnsEndLines() {
    QCOMPARE(importObjText("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r")->triangles.size(), std::size_t{1});
  }

  void byteOrderMarkIsSkipped() {
    QCOMPARE(importObjText(QByteArray("\xEF\xBB\xBF") + kTriangle + "f 1 2 3\n")->triangles.size(), std::size_t{1});
  }

  void facesMayReferToLaterVertices() {
    const auto environment = importObjText(QByteArray("f 1 2 3\nf 1 2 4 3\n") + kTriangle + "v 1 1 0\n");
    QVERIFY(environment->triangles == (std::vector<Triangle>{{0, 1, 2}, {0, 1, 3}, {0, 3, 2}}));
  }

  void trianglesKeepTheOrderOfTheFile() {
    const auto environment =
        importObjText("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 3\nf 4 1 2 3\nf 2 3 4\n");
    const std::vector<Triangle> expected = {{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {3, 0, 1}, {3, 1, 2}, {1, 2, 3}};
    QVERIFY(environment->triangles == expected);
  }

  void whatIsNoTriangleIsCounted() {
    const auto environment =
        importObjText(QByteArray(kTriangle) + "p 1 2\np 3\nl 1 2 3\nf 1 2\nf 1 1 2\nf 1 2 1 2\nf 1 2 3\n");
    QCOMPARE(environment->skipped.points, 3U);
    QCOMPARE(environment->skipped.lines, 1U);
    QCOMPARE(environment->skipped.polygons, 3U);
    QCOMPARE(environment->triangles.size(), std::size_t{1});
  }

  void skippedPolygonsAreListedWithReasonLineAndPlace() {
    const auto environment = importObjText(QByteArray("f 1 1\\\n 3\n") + kTriangle +
                                           "f 1 2\nf 1 2 1 2\nsurf 0 1 0 1 1 2\nf 3\nf 2 2 2 2\nf 1 2 3\n");
    const std::vector<SkippedPolygon>& listed = environment->skipped.listed;
    const Vec3 a{0, 0, 0}, b = environment->vertices[1], c = environment->vertices[2];
    const std::vector<SkippedPolygon> expected = {
        {SkipReason::RepeatedCorners, 3, 1, 0, {}, {a, c}}, {SkipReason::TooFewCorners, 2, 6, 0, {}, {a, b}},
        {SkipReason::RepeatedCorners, 4, 7, 0, {}, {a, b}}, {SkipReason::FreeForm, 0, 8, 0, {}, {}},
        {SkipReason::TooFewCorners, 1, 9, 0, {}, {c}},      {SkipReason::RepeatedCorners, 4, 10, 0, {}, {b}}};
    QCOMPARE(environment->skipped.polygons, 6U);
    QVERIFY(listed == expected);
    QCOMPARE(QString::fromStdString(formatSkipped(environment->skipped, environment->up, 3)),
             QString("  line 1: its 3 corners are only two different vertices; a polygon needs three; at 0 0 0\n"
                     "  line 6: has two corners; a polygon needs three; at 0 0 0\n"
                     "  line 7: its 4 corners are only two different vertices; a polygon needs three; at 0 0 0\n"
                     "  and 3 more\n"));
  }

  void theListOfSkippedPolygonsIsBounded() {
    QByteArray text = kTriangle;
    for (int i = 0; i < 1500; ++i) text += "f 1 2\nf 1 1 2 2\n";
    const auto environment = importObjText(text + "f 1 2 3\n");
    QCOMPARE(environment->skipped.polygons, 3000U);
    QCOMPARE(environment->skipped.listed.size(), SkippedElements::kMostListed);
    QCOMPARE(environment->skipped.listed.back().line, std::uint64_t{1003});
  }

  void geometricallyDegenerateTrianglesStay() {
    const auto environment = importObjText("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 0 0\nf 1 2 3\nf 1 2 4\n");
    QCOMPARE(environment->triangles.size(), std::size_t{2});
    QCOMPARE(environment->skipped.polygons, 0U);
  }

  void yUpIsTurnedAndGuessed() {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.OBJ", "v 1 2 3\nv 0 0 0\nv 1 0 0\nf 1 2 3\n");
    const auto guessed = importEnvironment(path);
    QVERIFY(guessed->up == UpAxis::Y && guessed->upGuessed && guessed->scaleGuessed);
    QVERIFY(guessed->vertices[0] == (Vec3{1, -3, 2}));
    QCOMPARE(guessed->metresPerUnit, 1.0);
    QVERIFY(guessed->source == path);

    ImportOptions options;
    options.up = UpAxis::Z;
    options.metresPerUnit = 0.01;
    options.bothSides = true;
    const auto given = importEnvironment(path, options);
    QVERIFY(given->up == UpAxis::Z && !given->upGuessed && !given->scaleGuessed && given->bothSides);
    QVERIFY(given->vertices[0] == (Vec3{1, 2, 3}));
    QCOMPARE(given->metresPerUnit, 0.01);
  }

  void badScaleIsRefused() {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.obj", QByteArray(kTriangle) + "f 1 2 3\n");
    for (const double scale : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
      ImportOptions options;
      options.metresPerUnit = scale;
      QVERIFY(messageOf<InputError>([&] { importEnvironment(path, options); }).contains("scale"));
    }
  }

  void badObj_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("expected");
    const QByteArray start = kTriangle;
    QTest::newRow("nan") << QByteArray("v 0 nan 0\n") << 1 << "'nan' is not finite";
    QTest::newRow("inf") << QByteArray("v 0 0 0\nv 0 -inf 0\n") << 2 << "'-inf' is not finite";
    QTest::newRow("1e999") << QByteArray("# x\n\nv 1e999 0 0\n") << 3 << "'1e999' is not finite";
    QTest::newRow("no number") << QByteArray("v 0 x 0\n") << 1 << "'x' is not a number";
    QTest::newRow("half a number") << QByteArray("v 0 1e 0\n") << 1 << "'1e' is not a number";
    QTest::newRow("hexadecimal") << QByteArray("v 0 0x10 0\n") << 1 << "'0x10' is not a number";
    QTest::newRow("two signs") << QByteArray("v +-1 0 0\n") << 1 << "'+-1' is not a number";
    QTest::newRow("decimal comma") << QByteArray("v 1,5 0 0\n") << 1 << "decimal point";
    QTest::newRow("two coordinates") << QByteArray("v 1 2\n") << 1 << "three coordinates";
    QTest::newRow("no coordinates") << QByteArray("v\n") << 1 << "three coordinates";
    QTest::newRow("cut vertex") << start + "v 1 2" << 4 << "truncated";
    QTest::newRow("cut keyword") << start + "f 1 2 3\nv" << 5 << "truncated";
    QTest::newRow("cut face") << start + "f 1 2" << 4 << "truncated";
    QTest::newRow("too large index") << start + "f 1 2 4\n" << 4 << "vertex index 4 is out of range: the file has 3";
    QTest::newRow("too large in polygon") << start + "f 1 2 3 9\nf 1 2 3\n" << 4 << "vertex index 9 is out of range";
    QTest::newRow("zero index") << start + "f 0 1 2\n" << 4 << "index 0";
    QTest::newRow("too negative") << start + "f -1 -2 -4\n" << 4 << "'-4' is out of range";
    QTest::newRow("beyond 32 bits") << start + "f 1 2 4294967297\n" << 4 << "out of range";
    QTest::newRow("beyond 64 bits") << start + "f 1 2 99999999999999999999999999\n" << 4 << "out of range";
    QTest::newRow("beyond, negative") << start + "f 1 2 -99999999999999999999999999\n" << 4 << "out of range";
    QTest::newRow("no index") << start + "f 1 2 a\n" << 4 << "'a' is not a face corner";
    QTest::newRow("index with a tail") << start + "f 1 2 3x\n" << 4 << "'3x' is not a face corner";
    QTest::newRow("fraction") << start + "f 1 2 3.5\n" << 4 << "'3.5' is not a face corner";
    QTest::newRow("line after a continuation") << start + "f 1 \\\n 2 \\\n x\n" << 6 << "'x'";
    QTest::newRow("NUL bytes") << start + QByteArray("f 1 2 3\n\0\0", 10) << 5 << "NUL byte";
    QTest::newRow("binary without NUL") << QByteArray("\x7f\x45\x4c\x46\x02\n\x01") << 1 << "not an OBJ statement";
    QTest::newRow("markup") << QByteArray("<html>\n") << 1 << "not an OBJ statement: '<html>'";
    QTest::newRow("no triangles") << start << 0 << "no triangles";
    QTest::newRow("only lines") << start + "l 1 2\n" << 0 << "1 line";
    QTest::newRow("text") << QByteArray("hello world\n") << 0 << "no triangles";
    QTest::newRow("only blanks") << QByteArray("\n\n  \n") << 0 << "no triangles";
    QTest::newRow("0 bytes") << QByteArray("") << 0 << "empty";
  }
  void badObj() {
    QFETCH(QByteArray, text);
    QFETCH(int, line);
    QFETCH(QString, expected);
    const TemporaryFolder folder;
    const std::string path = folder.write("bad.obj", text);
    const QString message = messageOf<InputError>([&] { importEnvironment(path); });
    const QString place = QString::fromStdString(path) + (line > 0 ? ":" + QString::number(line) : QString()) + ": ";
    QVERIFY2(message.startsWith(place), qPrintable(message));
    QVERIFY2(message.contains(expected), qPrintable(message));
    QVERIFY2(message.contains("; ") && !message.contains('\n'), qPrintable(message));
  }

  // Long files are read in stretches by all threads; a corner that counts from the end makes one thread read all.
  void longFilesAreReadAlike_data() {
    QTest::addColumn<QByteArray>("lineEnd");
    QTest::newRow("LF") << QByteArray("\n");
    QTest::newRow("CR LF") << QByteArray("\r\n");
    QTest::newRow("CR") << QByteArray("\r");
  }
  void longFilesAreReadAlike() {
    QFETCH(QByteArray, lineEnd);
    const QByteArray text = longText(lineEnd);
    const auto alone = importObjText(text + "f -3 -2 -1" + lineEnd), together = importObjText(text);
    QVERIFY(together->vertices == alone->vertices);
    auto triangles = alone->triangles;
    triangles.pop_back();
    QVERIFY(together->triangles == triangles);
    QCOMPARE(together->skipped.points, alone->skipped.points);
    QCOMPARE(together->skipped.lines, alone->skipped.lines);
    QCOMPARE(together->skipped.polygons, alone->skipped.polygons);
    QVERIFY(together->skipped.listed == alone->skipped.listed);
    QVERIFY(!together->skipped.listed.empty());
  }

  void continuedLinesMayCrossStretches() {
    QByteArray text = kTriangle;
    for (int i = 0; i < 40000; ++i) text += "f 1 \\\n2 3\n";
    QCOMPARE(importObjText(text)->triangles.size(), std::size_t{40000});
  }

  void errorsInLongFilesTellTheirLine_data() {
    QTest::addColumn<QByteArray>("wrong");
    QTest::addColumn<QString>("expected");
    QTest::newRow("not a number") << QByteArray("v 1 2 x") << "'x' is not a number";
    QTest::newRow("index") << QByteArray("f 1 2 99999999") << "out of range";
    QTest::newRow("relative index") << QByteArray("f -1 -2 -99999999") << "out of range";
  }
  void errorsInLongFilesTellTheirLine() {
    QFETCH(QByteArray, wrong);
    QFETCH(QString, expected);
    const QByteArray text = longText("\n");
    const TemporaryFolder folder;
    const std::string path = folder.write("bad.obj", text + wrong + "\n" + longText("\n"));
    const QString message = messageOf<InputError>([&] { importEnvironment(path); });
    const QString place = QString::fromStdString(path) + ":" + QString::number(text.count('\n') + 1) + ": ";
    QVERIFY2(message.startsWith(place), qPrintable(message));
    QVERIFY2(message.contains(expected), qPrintable(message));
  }

  void badPaths() {
    const TemporaryFolder folder;
    const auto message = [](const std::string& path) {
      return messageOf<InputError>([&] { importEnvironment(path); });
    };
    QVERIFY(message(folder.path("none.obj")).contains("no such file"));
    QVERIFY(message("").contains("no such file"));
    QVERIFY(message(folder.path("")).contains("a folder without meshes"));
    const std::string file = folder.write("a.xyzzy", "v 0 0 0\n");
    QVERIFY(message(file).contains("unknown extension '.xyzzy'"));
    QVERIFY(message(file + "/b.obj").contains("no such file"));
    QVERIFY(message(folder.write("noextension", "v 0 0 0\n")).contains("no extension"));
    QVERIFY(message("two\nlines.obj").startsWith("two lines.obj: no such file"));
    const std::string pipe = folder.path("pipe.obj");
    QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
    QVERIFY(message(pipe).contains("not an ordinary file"));
  }

  void noPermission() {
    if (::geteuid() == 0) QSKIP("the superuser may read every file");
    const TemporaryFolder folder;
    const std::string path = folder.write("a.obj", QByteArray(kTriangle) + "f 1 2 3\n");
    QCOMPARE(::chmod(path.c_str(), 0), 0);
    QVERIFY(messageOf<InputError>([&] { importEnvironment(path); }).contains("no permission"));
  }

  void cancelling() {
    const TemporaryFolder folder;
    QByteArray text = kTriangle;
    for (int i = 0; i < 300000; ++i) text += "f 1 2 3\n";
    const std::string path = folder.write("a.obj", text);
    RunContext cancelledBefore;
    cancelledBefore.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, importEnvironment(path, {}, &cancelledBefore));

    double last = 0;
    RunContext* running = nullptr;
    RunContext cancelledWhileReading([&](const RunEvent& event) {
      last = event.fraction;
      if (event.fraction > 0.3) running->cancel();
    });
    running = &cancelledWhileReading;
    QVERIFY_THROWS_EXCEPTION(Cancelled, importEnvironment(path, {}, &cancelledWhileReading));
    QVERIFY(last > 0.3 && last < 0.9);
  }

  void realEnvironments_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("triangles");  // ours; with the skipped faces, those of the README
    QTest::addColumn<int>("skipped");
    QTest::newRow("nav_test") << "nav_test.obj" << 1612 << 0;
    QTest::newRow("level") << "level.obj" << 1612 << 0;
    QTest::newRow("ot") << "ot.obj" << 2907 << 1;
    QTest::newRow("turbine") << "turbine.obj" << 3061 << 3;
    QTest::newRow("dutility") << "dutility.obj" << 8103 << 12;
    QTest::newRow("complex") << "complex.obj" << 12368 << 21;
    QTest::newRow("town") << "town/town_model.gltf" << 30477 << 0;
    QTest::newRow("steelribs") << "steelribs.obj" << 45846 << 58;
    QTest::newRow("fortitude") << "fortitude.obj" << 48321 << 37;
  }
  void realEnvironments() {
    if (sharedEnvironments().isEmpty()) QSKIP("the shared environments are not here; set FOOTFALL_SHARED");
    QFETCH(QString, file);
    QFETCH(int, triangles);
    QFETCH(int, skipped);
    ImportOptions asTheFileHasThem;  // the grid splits edges
    asTheFileHasThem.grid = GridChoice::Off;
    const auto environment = importEnvironment((sharedEnvironments() + "/" + file).toStdString(), asTheFileHasThem);
    QCOMPARE(static_cast<int>(environment->triangles.size()), triangles);
    QCOMPARE(static_cast<int>(environment->skipped.polygons), skipped);
    QVERIFY(environment->up == UpAxis::Y);
  }
};

QTEST_GUILESS_MAIN(TestImport)
#include "test_import.moc"
