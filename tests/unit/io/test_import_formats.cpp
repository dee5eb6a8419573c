// Reading through Assimp: node transforms, frames and units by format, polygons, broken files.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "core/environment/skipped_polygons.hpp"
#include "core/io/import.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

/// Corner positions of all triangles.
std::vector<Vec3> corners(const Environment& environment) {
  std::vector<Vec3> result;
  for (const Triangle& triangle : environment.triangles) {
    for (const std::uint32_t corner : triangle) result.push_back(environment.vertices[corner]);
  }
  return result;
}

bool closeTo(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double tolerance) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const Vec3& p, const Vec3& q) {
    return std::abs(p.x - q.x) <= tolerance && std::abs(p.y - q.y) <= tolerance && std::abs(p.z - q.z) <= tolerance;
  });
}

QByteArray binaryPly() {
  QByteArray content(
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n");
  const float positions[9] = {0, 0, 1, 1, 0, 1, 0, 1, 1};
  const qint32 indices[3] = {0, 1, 2};
  content.append(reinterpret_cast<const char*>(positions), sizeof positions);
  content.append('\3');
  content.append(reinterpret_cast<const char*>(indices), sizeof indices);
  return content;
}

QByteArray binaryStl(quint32 facets) {
  QByteArray content("solid, but binary");
  content.append(80 - content.size(), '\0');
  content.append(reinterpret_cast<const char*>(&facets), sizeof facets);
  const float facet[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  for (quint32 i = 0; i < facets; ++i) {
    content.append(reinterpret_cast<const char*>(facet), sizeof facet);
    content.append(2, '\0');
  }
  return content;
}

}  // namespace

class TestImportFormats : public QObject {
  Q_OBJECT
 private slots:
  void gltfNodesAreAppliedAndMirroringReversesWinding() {
    const auto environment = importEnvironment(dataFile("transforms.gltf"));
    QVERIFY(environment->up == UpAxis::Y && !environment->upGuessed);  // by the standard of glTF
    QCOMPARE(environment->metresPerUnit, 1.0);
    QVERIFY(!environment->scaleGuessed);  // glTF is in metres
    // parent moves by 10; first child scales by (2, 3, 4) and turns 90 degrees about Y; the second mirrors X and lifts
    const std::vector<Vec3> expected = {{10, 0, 0}, {10, 2, 0}, {6, 0, 0}, {10, 0, 5}, {10, 1, 5}, {9, 0, 5}};
    QVERIFY(closeTo(corners(*environment), expected, 1e-6));
  }

  void plyPolygonsAreTriangulatedZUp() {
    const auto environment = importEnvironment(dataFile("polygons.ply"));
    QVERIFY(environment->up == UpAxis::Z);
    // the first quad is concave at corner 0, so both triangles of a right split use it
    QCOMPARE(environment->triangles.size(), std::size_t{3});
    const std::vector<Vec3> expected = {{1, 1, 0}, {0, 4, 0}, {0, 0, 0}, {1, 1, 0}, {0, 0, 0},
                                        {4, 0, 0}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}};
    QVERIFY(corners(*environment) == expected);
  }

  void skippedPolygonsAreKnownByMeshAndFace() {
    const TemporaryFolder folder;
    QByteArray ply = readAll(dataFile("polygons.ply"));
    const auto environment = importEnvironment(folder.write("a.ply", ply.replace("3 4 5 6", "3 4 5 5")));
    const std::vector<SkippedPolygon> expected = {{SkipReason::RepeatedCorners, 3, 0, 2, {}, {{0, 0, 2}, {1, 0, 2}}}};
    QVERIFY(environment->skipped.listed == expected);
    QCOMPARE(QString::fromStdString(skippedSource(expected[0]).str()), QString("face 2"));
    SkippedPolygon named = expected[0];
    named.mesh = "Wall";
    QCOMPARE(QString::fromStdString(skippedSource(named).str()), QString("face 2 of mesh 'Wall'"));
  }

  void stlIsZUp() {
    const auto environment = importEnvironment(dataFile("floor.stl"));
    QVERIFY(environment->up == UpAxis::Z && environment->upGuessed);
    const std::vector<Vec3> expected = {{0, 0, 1.5}, {2, 0, 1.5}, {0, 2, 1.5}, {2, 0, 1.5}, {2, 2, 1.5}, {0, 2, 1.5}};
    QVERIFY(corners(*environment) == expected);
  }

  void binaryPlyAndStl() {
    const TemporaryFolder folder;
    QCOMPARE(importEnvironment(folder.write("a.ply", binaryPly()))->triangles.size(), std::size_t{1});
    QCOMPARE(importEnvironment(folder.write("a.stl", binaryStl(5)))->triangles.size(), std::size_t{5});
  }

  void threeDsKeepsItsOwnFrame() {
    const auto environment = importEnvironment(dataFile("floor.3ds"));
    QVERIFY(environment->up == UpAxis::Z);
    QVERIFY(corners(*environment) == (std::vector<Vec3>{{0, 0, 3}, {1, 0, 3}, {0, 1, 3}}));
  }

  void fbxSaysAxisAndUnit() {
    const auto environment = importEnvironment(dataFile("z_up_inches.fbx"));
    QVERIFY(environment->up == UpAxis::Z);
    QCOMPARE(environment->metresPerUnit, 0.0254);
    QCOMPARE(environment->triangles.size(), std::size_t{2});
    QVERIFY(environment->vertices == (std::vector<Vec3>{{5, 6, 7}, {6, 6, 7}, {6, 7, 7}, {5, 7, 7}}));
    // any axis, also downwards
    QByteArray text = readAll(dataFile("z_up_inches.fbx"));
    text.replace("\"UpAxis\", \"int\", \"Integer\", \"\",2", "\"UpAxis\", \"int\", \"Integer\", \"\",0");
    text.replace("\"UpAxisSign\", \"int\", \"Integer\", \"\",1", "\"UpAxisSign\", \"int\", \"Integer\", \"\",-1");
    const TemporaryFolder folder;
    const auto turned = importEnvironment(folder.write("a.fbx", text));
    QVERIFY(turned->up == UpAxis::NegativeX && turned->vertices[0] == (Vec3{6, -7, -5}));
  }

  void colladaKeepsItsFrameAndUnit_data() {
    QTest::addColumn<QByteArray>("axis");
    QTest::addColumn<int>("up");
    QTest::addColumn<double>("x");  // coordinates of the corner that the file has at (5, 6, 7)
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    QTest::newRow("Z_UP") << QByteArray("Z_UP") << int(UpAxis::Z) << 5.0 << 6.0 << 7.0;
    QTest::newRow("Y_UP") << QByteArray("Y_UP") << int(UpAxis::Y) << 5.0 << -7.0 << 6.0;
    QTest::newRow("X_UP") << QByteArray("X_UP") << int(UpAxis::X) << -6.0 << -7.0 << 5.0;
  }
  void colladaKeepsItsFrameAndUnit() {
    QFETCH(QByteArray, axis);
    QFETCH(int, up);
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    const TemporaryFolder folder;
    const auto environment =
        importEnvironment(folder.write("a.dae", readAll(dataFile("z_up.dae")).replace("Z_UP", axis)));
    QCOMPARE(int(environment->up), up);
    QCOMPARE(environment->metresPerUnit, 0.0254);
    QVERIFY(corners(*environment)[0] == (Vec3{x, y, z}));
  }

  void optionsOverrideTheFile() {
    ImportOptions options;
    options.up = UpAxis::Y;
    options.metresPerUnit = 2;
    const auto environment = importEnvironment(dataFile("z_up.dae"), options);
    QVERIFY(environment->up == UpAxis::Y && !environment->upGuessed && !environment->scaleGuessed);
    QCOMPARE(environment->metresPerUnit, 2.0);
    QVERIFY(environment->vertices[0] == (Vec3{5, -7, 6}));
  }

  void brokenFiles_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("expected");
    const QByteArray gltf = readAll(dataFile("transforms.gltf")), ply = readAll(dataFile("polygons.ply")),
                     stl = readAll(dataFile("floor.stl")), dae = readAll(dataFile("z_up.dae")),
                     fbx = readAll(dataFile("z_up_inches.fbx")), tds = readAll(dataFile("floor.3ds"));
    const auto with = [](QByteArray text, const char* from, const QByteArray& to) { return text.replace(from, to); };
    QTest::newRow("cut gltf") << "a.gltf" << gltf.left(500) << "cannot be read";
    QTest::newRow("cut ply header") << "a.ply" << ply.left(100) << "end_header";
    QTest::newRow("cut ply vertices") << "a.ply" << ply.left(220) << "truncated";
    QTest::newRow("ply without its last face") << "a.ply" << ply.left(ply.size() - 8) << "truncated";
    QTest::newRow("ply with half a face") << "a.ply" << ply.left(ply.size() - 3) << "truncated";
    QTest::newRow("cut binary ply") << "a.ply" << binaryPly().chopped(20) << "truncated";
    QTest::newRow("cut stl") << "a.stl" << stl.left(150) << "endsolid";
    QTest::newRow("cut binary stl") << "a.stl" << binaryStl(3).chopped(10) << "; ";
    QTest::newRow("cut dae") << "a.dae" << dae.left(900) << "cannot be read";
    QTest::newRow("cut fbx") << "a.fbx" << fbx.left(800) << "cannot be read";
    QTest::newRow("cut 3ds") << "a.3ds" << tds.left(60) << "cannot be read";
    QTest::newRow("empty glb") << "a.glb" << QByteArray() << "empty";
    QTest::newRow("text as glb") << "a.glb" << QByteArray("hello") << "cannot be read";
    QTest::newRow("obj as stl") << "a.stl" << QByteArray("v 0 0 0\nf 1 1 1\n") << "cannot be read";
    QTest::newRow("nan in ply") << "a.ply" << with(ply, "1 1 0", "nan 1 0") << "not finite";
    QTest::newRow("1e999 in ply") << "a.ply" << with(ply, "1 1 0", "1e999 1 0") << "not finite";
    QTest::newRow("nan in stl") << "a.stl" << with(stl, "vertex 0 0", "vertex nan 0") << "not finite";
    QTest::newRow("index in ply") << "a.ply" << with(ply, "4 0 1 2 3", "4 0 1 2 33") << "out of range";
    QTest::newRow("index in dae") << "a.dae" << with(dae, "<p>0 1 2", "<p>0 1 9") << "cannot be read";
    QTest::newRow("accessor in gltf") << "a.gltf" << with(gltf, "\"count\": 3,", "\"count\": 3000,") << "out of range";
    QTest::newRow("missing buffer") << "a.gltf" << with(gltf, "data:application/octet-stream;base64,", "gone/")
                                    << "cannot be read";
    QTest::newRow("ply without faces")
        << "a.ply"
        << QByteArray(
               "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
               "property float z\nend_header\n0 0 0\n")
        << "; ";
    QTest::newRow("ply that announces billions")
        << "a.ply" << with(ply, "element vertex 7", "element vertex 4000000000") << "truncated";
    // found by fuzzing: Assimp allocated 20 GB, never returned, or wrote where it must not
    QTest::newRow("ply that announces more than any number")
        << "a.ply" << with(ply, "element vertex 7", "element vertex 99999999999999999999") << "truncated";
    QByteArray longList = binaryPly();
    longList[longList.size() - 13] = '\xEB';  // The byte stands before three indices.
    QTest::newRow("ply with a list longer than the file") << "a.ply" << longList << "truncated";
    QTest::newRow("ply with a list of negative length")
        << "a.ply" << with(longList, "list uchar", "list char") << "a negative length";
    QTest::newRow("ascii ply with a list of negative length")
        << "a.ply" << with(ply, "4 0 1 2 3", "-103 0 1 2 3") << "a negative length";
    QTest::newRow("ascii ply with a list longer than its line")
        << "a.ply" << with(ply, "4 0 1 2 3", "3333333333333330 0 1 2 3") << "more entries than its line";
    QTest::newRow("ascii ply with two numbers in a word")
        << "a.ply" << with(ply, "4 0 1 2 3", "4-7 0 1 2 3") << "'4-7' is not a number";
    QTest::newRow("ascii ply with an end of line that is not everybody's")
        << "a.ply" << with(ply, "4 0 1 2 3", "4 0\r-1 1 2 3") << "bytes that are not text";
    QTest::newRow("ascii ply with bytes that are no text")
        << "a.ply" << with(ply, "0 4 0", QByteArray("0 4\0 0", 6)) << "bytes that are not text";
    QTest::newRow("ascii ply with an empty line")
        << "a.ply" << with(ply, "4 0 1 2 3", "\n4 0 1 2 3") << "the line is empty";
    QTest::newRow("ply behind an empty line") << "a.ply"
                                              << "\r\n" + ply << "before the word 'ply'";
    QTest::newRow("ply with two formats")
        << "a.ply" << with(ply, "comment", "format binary_little_endian 1.0\ncomment") << "line 3 of the PLY header";
    QTest::newRow("ply with a comment that Assimp takes for an element")
        << "a.ply" << with(ply, "element face", "comment edge 4000000000\nelement face") << "line 8 of the PLY header";
    QTest::newRow("ply with elements that come twice")
        << "a.ply" << with(ply, "element face", "element vertex") << "line 8 of the PLY header";
    QTest::newRow("ply with a number for a name")
        << "a.ply" << with(ply, "element face", "element 4000000000face") << "line 8 of the PLY header";
    QTest::newRow("ply with an empty line among its properties")
        << "a.ply" << with(ply, "property float y", "\nproperty float y") << "line 6 of the PLY header";
    QTest::newRow("ply with elements that Assimp cannot skip")
        << "a.ply" << with(ply, "element face", "element camera 1\nproperty float x\nelement face")
        << "elements 'camera'";
    QTest::newRow("binary ply with billions of elements without properties")
        << "a.ply" << with(binaryPly(), "end_header", "element nothing 4000000000\nend_header") << "truncated";
    QTest::newRow("ply that announces less than nothing")
        << "a.ply" << with(ply, "element vertex 7", "element vertex -7") << "line 4 of the PLY header";
    QTest::newRow("cut ply with another extension") << "a.gltf" << ply.left(100) << "end_header";
    QTest::newRow("cut ply in capitals") << "a.ply"
                                         << "Ply" + ply.mid(3, 97) << "end_header";
    QTest::newRow("ply with an unknown statement")
        << "a.ply" << with(binaryPly(), "element", "elephant") << "line 3 of the PLY header";
    QTest::newRow("ply with an unknown type")
        << "a.ply" << with(binaryPly(), "property float", "property long") << "line 4 of the PLY header";
  }
  void brokenFiles() {
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    QFETCH(QString, expected);
    const TemporaryFolder folder;
    const std::string path = folder.write(qPrintable(name), content);
    const QString message = messageOf<InputError>([&] { importEnvironment(path); });
    QVERIFY2(message.startsWith(QString::fromStdString(path) + ":"), qPrintable(message));
    QVERIFY2(message.contains(expected) && message.contains("; "), qPrintable(message));
    QVERIFY2(!message.contains('\n'), qPrintable(message));
  }

  void extensionsAreListedOnce() {
    const std::vector<std::string> extensions = importableExtensions();
    for (const char* expected : {"obj", "gltf", "glb", "fbx", "dae", "ply", "stl", "3ds"}) {
      QCOMPARE(std::count(extensions.begin(), extensions.end(), expected), std::ptrdiff_t{1});
    }
  }
};

QTEST_GUILESS_MAIN(TestImportFormats)
#include "test_import_formats.moc"
