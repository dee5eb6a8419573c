// Writing the navigation mesh: exact text, order of groups, round trips, and files that are never half-written.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QtTest>
#include <cfloat>

#include "core/io/export.hpp"
#include "core/io/import.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

NavigationMesh square() {
  NavigationMesh mesh;
  mesh.vertices = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.sourceTriangles = {0, 0};
  return mesh;
}

NavigationMesh framed(NavigationMesh mesh, const SourceFrame& frame) {
  mesh.frame = frame;
  return mesh;
}

SourceFrame frame(UpAxis up) { return {"/somewhere/level.obj", up, 1}; }

/// The text without its comments.
QByteArray body(const std::string& text) {
  QByteArray result;
  for (const QByteArray& line : QByteArray::fromStdString(text).split('\n')) {
    if (!line.startsWith('#') && !line.isEmpty()) result += line + '\n';
  }
  return result;
}

}  // namespace

class TestExport : public QObject {
  Q_OBJECT
 private slots:
  void withoutLayersThereIsOneGroup() {
    QCOMPARE(body(formatObj(framed(square(), frame(UpAxis::Z)), {})),
             QByteArray("v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\ng walkable\nf 1 2 3\nf 1 3 4\n"));
  }

  void manyLinesAreInTheirOrder() {
    // More than the threads write at once, in one group and in two.
    constexpr std::uint32_t kVertices = 1'200'000, kTriangles = 600'000;
    NavigationMesh mesh;
    for (std::uint32_t v = 0; v < kVertices; ++v) mesh.vertices.push_back({v % 1000 + 0.0, v / 1000 + 0.0, 1});
    for (std::uint32_t t = 0; t < kTriangles; ++t) mesh.triangles.push_back({t, t + 1, t + 2});
    mesh.sourceTriangles.resize(kTriangles);
    QByteArray vertices, one = "g walkable\n", first = "g layer_0\n", second = "g layer_1\n";
    for (std::uint32_t v = 0; v < kVertices; ++v)
      vertices += "v " + QByteArray::number(v % 1000) + ' ' + QByteArray::number(v / 1000) + " 1\n";
    for (std::uint32_t t = 0; t < kTriangles; ++t) {
      QByteArray line = "f";
      for (std::uint32_t k = 1; k < 4; ++k) line += ' ' + QByteArray::number(t + k);
      line += '\n';
      one += line;
      (t % 3 == 0 ? second : first) += line;
    }
    QVERIFY(body(formatObj(framed(mesh, frame(UpAxis::Z)), {})) == vertices + one);
    for (std::uint32_t t = 0; t < kTriangles; ++t) mesh.layers.push_back(t % 3 == 0 ? 1 : 0);
    mesh.layerCount = 2;
    QVERIFY(body(formatObj(framed(mesh, frame(UpAxis::Z)), {})) == vertices + first + second);
  }

  void layersConnectionsAndObstacleEdgesFollow() {
    NavigationMesh mesh = square();
    mesh.layers = {1, 0};
    mesh.layerCount = 2;
    mesh.connections = {{0, 2}};
    mesh.obstacleEdges = {{0, 1}, {2, 3}};
    QCOMPARE(body(formatObj(framed(mesh, frame(UpAxis::Z)), {})),
             QByteArray("v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\ng layer_0\nf 1 3 4\ng layer_1\nf 1 2 3\n"
                        "g connections\nl 1 3\ng obstacle_edges\nl 1 2\nl 3 4\n"));
  }

  void yUpIsTurnedBackWithoutNegativeZeros() {
    NavigationMesh mesh = square();
    mesh.vertices[3] = {-0.0, 2.5, 3};
    QCOMPARE(body(formatObj(framed(mesh, frame(UpAxis::Y)), {})),
             QByteArray("v 0 1 0\nv 1 1 0\nv 1 1 -1\nv 0 3 -2.5\ng walkable\nf 1 2 3\nf 1 3 4\n"));
  }

  void headerNamesVersionSourcePipelineAndAgent() {
    ExportHeader header;
    header.pipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\n";
    header.agent = "slope 45 degrees, height 2 \\";
    SourceFrame source = frame(UpAxis::Y);
    source.source = "/somewhere/le\nvel.obj";
    const QByteArray text = QByteArray::fromStdString(formatObj(framed(square(), source), header));
    QVERIFY(text.startsWith("# Walkable area by Footfall "));
    QVERIFY(text.contains("\n# source: le vel.obj\n"));
    QVERIFY(text.contains("\n# pipeline: SlopeFilter 45\n# pipeline: VerticalClearanceFilter 2\n"));
    QVERIFY(text.contains("\n# agent: slope 45 degrees, height 2 \\ \n"));
    QVERIFY(!text.contains("somewhere"));
  }

  void sameInputSameBytes() {
    QCOMPARE(formatObj(framed(square(), frame(UpAxis::Y)), {}), formatObj(framed(square(), frame(UpAxis::Y)), {}));
  }

  void everyDoubleReadsBack() {
    NavigationMesh mesh;
    mesh.vertices = {{122000.123, 487000.456, 0.1},
                     {1e300, -1e-300, DBL_MIN / 4},
                     {1.0 / 3, -2.0 / 3, 1e22},
                     {123456789012345680, 5e-324, 1e5},
                     {DBL_MAX, -DBL_MAX, 0.3}};
    mesh.triangles = {{0, 1, 2}, {2, 3, 4}};
    const TemporaryFolder folder;
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z}) {
      save(framed(mesh, frame(up)), folder.path("a.obj"));
      ImportOptions options;
      options.up = up;
      const auto environment = importEnvironment(folder.path("a.obj"), options);
      QVERIFY(environment->vertices == mesh.vertices);
      QVERIFY(environment->triangles == mesh.triangles);
    }
  }

  void importedEnvironmentsReadBack() {
    if (sharedEnvironments().isEmpty()) QSKIP("the shared environments are not here; set FOOTFALL_SHARED");
    const TemporaryFolder folder;
    for (const char* name : {"/nav_test.obj", "/steelribs.obj", "/town/town_model.gltf"}) {
      ImportOptions asTheFileHasThem;
      asTheFileHasThem.grid = GridChoice::Off;
      const auto first = importEnvironment(sharedEnvironments().toStdString() + name, asTheFileHasThem);
      NavigationMesh mesh;
      mesh.vertices = first->vertices;
      mesh.triangles = first->triangles;
      const std::string text = formatObj(framed(mesh, first->frame()), {});
      writeFileSafely(folder.path("again.obj"), text);
      const auto second = importEnvironment(folder.path("again.obj"));
      QVERIFY(second->vertices == first->vertices);
      QVERIFY(second->triangles == first->triangles);
    }
  }

  void writingReplacesAndLeavesNothingElse() {
    const TemporaryFolder folder;
    const std::string path = folder.path("out.txt");
    writeFileSafely(path, "first");
    QCOMPARE(readAll(path), QByteArray("first"));
    QCOMPARE(::chmod(path.c_str(), 0640), 0);
    writeFileSafely(path, "second");
    QCOMPARE(readAll(path), QByteArray("second"));
    struct stat status {};
    QCOMPARE(::stat(path.c_str(), &status), 0);
    QCOMPARE(static_cast<int>(status.st_mode & 0777), 0640);
    QCOMPARE(folder.files(), QStringList{"out.txt"});
  }

  void aLinkStaysALink() {
    const TemporaryFolder folder;
    writeFileSafely(folder.path("real.txt"), "first");
    QCOMPARE(::symlink("real.txt", folder.path("link.txt").c_str()), 0);
    writeFileSafely(folder.path("link.txt"), "second");
    QCOMPARE(readAll(folder.path("real.txt")), QByteArray("second"));
    QVERIFY(QFileInfo(QString::fromStdString(folder.path("link.txt"))).isSymLink());
  }

  void aDeviceIsWrittenNotReplaced() {
    writeFileSafely("/dev/null", "text");
    struct stat status {};
    QCOMPARE(::stat("/dev/null", &status), 0);
    QVERIFY(S_ISCHR(status.st_mode));
    if (!QFile::exists("/dev/full")) QSKIP("no /dev/full here");
    QVERIFY(messageOf<RunError>([] { writeFileSafely("/dev/full", "text"); }).contains("the disk is full"));
  }

  void badTargets() {
    const TemporaryFolder folder;
    const auto message = [](const std::string& path) {
      return messageOf<RunError>([&] { writeFileSafely(path, "text"); });
    };
    QVERIFY(message(folder.path("none/out.obj")).contains("folder does not exist"));
    QVERIFY(message(folder.path("")).contains("is a folder"));
    QVERIFY(message(folder.path("none/")).contains("is a folder"));
    QVERIFY(message("").contains("no file name"));
    QVERIFY(message("/proc/footfall.obj").startsWith("/proc/footfall.obj: "));
    QVERIFY(message("/proc/footfall.obj").contains("in its folder"));
    const std::string file = folder.write("file", "x");
    QVERIFY(message(file + "/out.obj").contains(QString::fromStdString(file) + " is a file, not a folder; choose"));
    QCOMPARE(::symlink("loop", folder.path("loop").c_str()), 0);
    QVERIFY(message(folder.path("loop")).contains("form a circle"));
    QFile::remove(QString::fromStdString(folder.path("loop")));
    QFile::remove(QString::fromStdString(file));
    const QString longName = message(folder.path(std::string(300, 'x').c_str()));
    QVERIFY2(longName.contains("too long"), qPrintable(longName));
    QCOMPARE(folder.files(), QStringList{});
  }

  void readOnlyFolder() {
    if (::geteuid() == 0) QSKIP("the superuser may write everywhere");
    const TemporaryFolder folder;
    const std::string inside = folder.path("inside");
    QCOMPARE(::mkdir(inside.c_str(), 0500), 0);
    const QString message = messageOf<RunError>([&] { writeFileSafely(inside + "/out.obj", "text"); });
    QVERIFY2(message.contains("no permission"), qPrintable(message));
  }

  void readOnlyFile() {
    if (::geteuid() == 0) QSKIP("the superuser may write every file");
    const TemporaryFolder folder;
    const std::string path = folder.write("out.obj", "kept");
    QCOMPARE(::chmod(path.c_str(), 0400), 0);
    QVERIFY(messageOf<RunError>([&] { writeFileSafely(path, "text"); }).contains("no permission"));
    QCOMPARE(readAll(path), QByteArray("kept"));
  }

  void diskThatCanOnlyBeRead() {
    const TemporaryFolder folder;
    const std::string disk = folder.path("disk");
    QCOMPARE(::mkdir(disk.c_str(), 0700), 0);
    if (::mount("tmpfs", disk.c_str(), "tmpfs", MS_RDONLY, "size=64k") != 0) QSKIP("a disk cannot be mounted here");
    const QString message = messageOf<RunError>([&] { writeFileSafely(disk + "/out.obj", "text"); });
    const QString before = messageOf<RunError>([&] { checkWritable(disk + "/out.obj"); });
    QCOMPARE(::umount(disk.c_str()), 0);
    QVERIFY2(message.contains("its disk is read-only; choose another disk"), qPrintable(message));
    QCOMPARE(before, message);
  }

  void fullDiskKeepsTheOldFile() {
    const TemporaryFolder folder;
    const std::string disk = folder.path("disk");
    QCOMPARE(::mkdir(disk.c_str(), 0700), 0);
    if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=64k") != 0) QSKIP("a small disk cannot be mounted here");
    writeFileSafely(disk + "/out.obj", "old");
    const QString message = messageOf<RunError>([&] { writeFileSafely(disk + "/out.obj", std::string(1 << 20, 'x')); });
    const QByteArray kept = readAll(disk + "/out.obj");
    const QStringList left =
        QDir(QString::fromStdString(disk)).entryList(QDir::Files | QDir::Hidden | QDir::NoDotAndDotDot);
    QCOMPARE(::umount(disk.c_str()), 0);
    QVERIFY2(message.contains("the disk is full"), qPrintable(message));
    QCOMPARE(kept, QByteArray("old"));
    QCOMPARE(left, QStringList{"out.obj"});
  }
};

QTEST_GUILESS_MAIN(TestExport)
#include "test_export.moc"
