// The files that import puts on a grid, and those that it does not change; packing and folders give the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "core/environment/coordinate_grid.hpp"
#include "core/environment/edge_splitting.hpp"
#include "core/io/environment_text.hpp"
#include "core/io/packed/pack.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

template <class Number>
void append(QByteArray& bytes, std::initializer_list<Number> numbers) {
  for (const Number number : numbers) bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

QByteArray plyHead(const char* format, const char* type) {
  QByteArray text =
      "ply\nformat FORMAT 1.0\nelement vertex 4\nproperty TYPE x\nproperty TYPE y\nproperty TYPE z\n"
      "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
  return text.replace("FORMAT", format).replace("TYPE", type);
}

QByteArray textPly() {
  return plyHead("ascii", "float") + "0.1 0.2 0.3\n10.1 0.2 0.3\n10.1 8.7 0.3\n+1e-1 8.7 0.3\n3 0 1 2\n3 0 2 3\n";
}

template <class Number>
QByteArray binaryPly(const char* type) {
  QByteArray bytes = plyHead("binary_little_endian", type);
  append<Number>(bytes, {Number(0.1), Number(0.2), Number(0.3), Number(10.1), Number(0.2), Number(0.3)});
  append<Number>(bytes, {Number(10.1), Number(8.7), Number(0.3), Number(0.1), Number(8.7), Number(0.3)});
  for (const std::int32_t second : {1, 2}) {
    append<std::uint8_t>(bytes, {3});
    append<std::int32_t>(bytes, {0, second, second + 1});
  }
  return bytes;
}

/// Facets over a wavy floor with vertices of their own, in floats that a turn has made of round numbers.
QByteArray binaryStl(int side) {
  QByteArray bytes(80, ' ');
  append<std::uint32_t>(bytes, {static_cast<std::uint32_t>(2 * side * side)});
  const double c = std::cos(0.3), s = std::sin(0.3);
  const auto corner = [&](int i, int j) {
    append<float>(bytes, {static_cast<float>(c * i - s * j), static_cast<float>(s * i + c * j),
                          static_cast<float>(0.1 * std::sin(i + 2.0 * j))});
  };
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      for (const bool upper : {false, true}) {
        append<float>(bytes, {0, 0, 1});
        corner(i, j);
        corner(i + 1, upper ? j + 1 : j);
        corner(upper ? i : i + 1, j + 1);
        append<std::uint16_t>(bytes, {0});
      }
  return bytes;
}

bool isOnGrid(const Environment& environment) {
  return std::ranges::all_of(environment.vertices,
                             [&](const Vec3& p) { return onGrid(p, environment.grid.step) == p; });
}

}  // namespace

class TestImportGrid : public QObject {
  Q_OBJECT

 private slots:
  void doublesStay_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("name");
    QTest::newRow("text PLY") << textPly() << "a.ply";
    QTest::newRow("PLY in doubles") << binaryPly<double>("double") << "a.ply";
    QTest::newRow("text STL") << QByteArray(
                                     "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0.1 0.2 0.3\n"
                                     "vertex 10.1 0.2 0.3\nvertex 10.1 8.7 0.3\nendloop\nendfacet\nendsolid s\n")
                              << "a.stl";
    QTest::newRow("OBJ") << QByteArray("v 0.1 0.3 -0.2\nv 10.1 0.3 -0.2\nv 10.1 0.3 -8.7\nf 1 2 3\n") << "a.obj";
  }

  void doublesStay() {
    QFETCH(QByteArray, content);
    QFETCH(QString, name);
    const TemporaryFolder folder;
    const auto level = importEnvironment(folder.write(qPrintable(name), content));
    QCOMPARE(level->grid.step, 0.0);
    QVERIFY(level->vertices[0] == (Vec3{0.1, 0.2, 0.3}));
    QVERIFY(level->vertices[2] == (Vec3{10.1, 8.7, 0.3}));
    ImportOptions options;
    options.grid = GridChoice::On;
    const auto other = importEnvironment(folder.path(qPrintable(name)), options);
    QCOMPARE(other->grid.step, 0x1p-20);  // 16 * 2^-24
    QVERIFY(isOnGrid(*other) && other->grid.largestMovement > 0 && other->grid.largestMovement < 0x1p-20);
  }

  void floatsAreRounded_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("name");
    QTest::newRow("PLY in floats") << binaryPly<float>("float") << "a.ply";
    QTest::newRow("binary STL") << binaryStl(10) << "a.stl";
    QTest::newRow("glTF") << readAll(dataFile("transforms.gltf")) << "a.gltf";
  }

  void floatsAreRounded() {
    QFETCH(QByteArray, content);
    QFETCH(QString, name);
    if (content.isEmpty()) QSKIP("no such file among the tests' data");
    const TemporaryFolder folder;
    const std::string path = folder.write(qPrintable(name), content);
    const auto level = importEnvironment(path);
    QVERIFY(level->grid.step > 0 && isOnGrid(*level));
    ImportOptions options;
    options.grid = GridChoice::Off;
    QCOMPARE(importEnvironment(path, options)->grid.step, 0.0);
    options.grid = GridChoice::Step;
    options.gridStep = 0.3;
    QCOMPARE(importEnvironment(path, options)->grid.step, 0.25);
    options.gridStep = 0;
    QVERIFY_EXCEPTION_THROWN(importEnvironment(path, options), InputError);
  }

  void packedFilesKeepTheGrid() {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.stl", binaryStl(40)), packed = folder.path("a.ffenv");
    const auto level = importEnvironment(path);
    for (const std::uint64_t faces : {kMostSplitTriangles, std::uint64_t{0}}) {
      PackingMemory memory;
      memory.facesOnGrid = faces;
      memory.weldedVertices = 50;
      QVERIFY(packEnvironment(path, packed, {}, nullptr, memory).isStreamed);
      const auto read = importEnvironment(packed);
      QVERIFY(read->grid == level->grid);
      QVERIFY(read->vertices == level->vertices && read->triangles == level->triangles);
    }
    ImportOptions off;
    off.grid = GridChoice::Off;
    packEnvironment(path, packed, off, nullptr);
    QCOMPARE(importEnvironment(packed)->grid.step, 0.0);
    ImportOptions on;
    on.grid = GridChoice::On;
    QVERIFY(importEnvironment(packed, on)->vertices == level->vertices);
  }

  void foldersAreOnOneGrid() {
    const TemporaryFolder folder;
    folder.write("a.obj", "v 0.1 -100 0.2\nv 7 -100 0.2\nv 7 -100 5.1\nf 1 2 3\n");
    folder.write("b.stl", binaryStl(10));
    const auto level = importEnvironment(folder.path(""));
    QCOMPARE(level->grid.step, 0x1p-17);  // of an extent of a hundred, in both files together
    QVERIFY(isOnGrid(*level));
  }

  void coordinatesAreWrittenAsTheyAre() {
    const TemporaryFolder folder;
    const auto level = importEnvironment(folder.write("a.stl", binaryStl(10)));
    ImportOptions zUp;
    zUp.up = UpAxis::Z;
    const auto read =
        importEnvironment(folder.write("b.obj", QByteArray::fromStdString(formatEnvironment(*level))), zUp);
    QVERIFY(read->vertices == level->vertices && read->triangles == level->triangles);
  }

  void verticesBesideAnEdgeSplitIt() {
    // A T-joint in a file whose vertex lies on the edge, turned so that it lies beside it on the grid.
    Environment level;
    const double c = std::cos(0.3), s = std::sin(0.3);
    for (const auto& [x, y] : {std::array{0.0, 0.0}, {9.0, 0.0}, {9.0, 8.0}, {3.7, 0.0}, {0.0, -4.0}, {9.0, -4.0}})
      level.vertices.push_back({c * x - s * y, s * x + c * y, 0});
    level.vertices.push_back({level.vertices[1].x, level.vertices[1].y, 3});
    // The last one is a wall on the edge, which stays whole and upright.
    level.triangles = {{0, 1, 2}, {0, 4, 3}, {3, 4, 5}, {3, 5, 1}, {0, 1, 6}};
    level.partOf = {0, 1, 1, 1, 2};
    Environment other = level;
    putOnGrid(level, 0x1p-20, {});
    QCOMPARE(level.grid.splitTriangles, std::uint64_t{1});
    QCOMPARE(level.triangles.size(), std::size_t{6});
    QVERIFY(std::ranges::count(level.triangles[0], 3U) == 1 && std::ranges::count(level.triangles[5], 3U) == 1);
    QVERIFY((level.triangles[4] == Triangle{0, 1, 6}));
    QCOMPARE(level.partOf.back(), 0U);
    // The edge gets the same vertex from the other side, and in another order.
    std::ranges::reverse(other.triangles);
    std::ranges::rotate(other.triangles.back(), other.triangles.back().begin() + 1);
    putOnGrid(other, 0x1p-20, {});
    QVERIFY(other.vertices == level.vertices);
    QCOMPARE(other.triangles.size(), std::size_t{6});
    QVERIFY(std::ranges::count(other.triangles[4], 3U) == 1 && std::ranges::count(other.triangles[5], 3U) == 1);
  }
};

QTEST_APPLESS_MAIN(TestImportGrid)
#include "test_import_grid.moc"
