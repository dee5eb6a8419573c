// Exports in other frames and formats: what is left out, scaled, turned and rounded, and that it reads back.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/io/formats/format_table.hpp"
#include "core/io/gltf_export.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/io.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/unit/environment_files.hpp"
#include "tests/unit/program_run.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

/// Two layers that share an edge, and an obstacle edge with vertices at the same places.
NavigationMesh sample() {
  NavigationMesh mesh;
  mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {4, 0, 1}, {4, 2, 1}, {0, 0, 0}, {2, 0, 0}, {1, -2, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}, {6, 8, 7}};
  mesh.layers = {0, 0, 1, 1, 0};
  mesh.layerCount = 2;
  mesh.connections = {{1, 2}};
  mesh.obstacleEdges = {{0, 1}};
  mesh.sourceTriangles.assign(5, 0);
  return mesh;
}

NavigationMesh framed(NavigationMesh mesh, const SourceFrame& frame) {
  mesh.frame = frame;
  return mesh;
}

SourceFrame frame(UpAxis up, double metresPerUnit = 1) { return {"/somewhere/level.obj", up, metresPerUnit}; }

QJsonObject gltf(const NavigationMesh& mesh, const ExportOptions& options = {}) {
  const GltfFile file = formatGltf(GltfKind::Text, mesh, {"SlopeFilter 45\n", "slope 45 degrees"}, options);
  return QJsonDocument::fromJson(QByteArray::fromStdString(file.bytes)).object();
}

QStringList names(const QJsonArray& objects) {
  QStringList list;
  for (const auto& object : objects) list << object.toObject()["name"].toString();
  return list;
}

/// Positions of all triangles, in any order.
std::multiset<std::array<std::array<double, 3>, 3>> trianglesOf(const std::vector<Vec3>& vertices,
                                                                const std::vector<Triangle>& triangles) {
  std::multiset<std::array<std::array<double, 3>, 3>> all;
  for (const Triangle& t : triangles) {
    std::array<std::array<double, 3>, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = {vertices[t[k]].x + 0.0, vertices[t[k]].y + 0.0, vertices[t[k]].z + 0.0};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.insert(corners);
  }
  return all;
}

}  // namespace

class TestGltfExport : public QObject {
  Q_OBJECT
 private slots:
  void objLeavesOutWhatIsNotWanted() {
    const TemporaryFolder folder;
    ExportOptions options;
    options.layers = options.connections = options.obstacleEdges = false;
    const std::string text = formatObj(framed(sample(), frame(UpAxis::Y)), {}, options);
    QVERIFY(text.find("layer_") == std::string::npos && text.find("g walkable\n") != std::string::npos);
    QVERIFY(text.find("\nl ") == std::string::npos);
    const auto read = readNavigationMesh(folder.write("a.obj", QByteArray::fromStdString(text)));
    QCOMPARE(read.mesh.triangles.size(), sample().triangles.size());
    QCOMPARE(read.mesh.connections.size(), 0U);
    QCOMPARE(formatObj(framed(sample(), frame(UpAxis::Y)), {}, ExportOptions{}),
             formatObj(framed(sample(), frame(UpAxis::Y)), {}));
  }

  void objIsTurnedAndScaledAndSaysSo() {
    const TemporaryFolder folder;
    ExportOptions options;
    options.up = UpAxis::Z;
    options.scale = 100;
    const std::string text = formatObj(framed(sample(), frame(UpAxis::Y, 1)), {"", "slope any"}, options);
    QVERIFY2(text.find("# note: coordinates are those of the source times 100; pipeline and agent are in units of the "
                       "source\n# frame: Z up, 0.01 metres per unit\n") != std::string::npos,
             text.c_str());
    QVERIFY(text.find("\nv 400 200 100\n") != std::string::npos);
    const auto read = readNavigationMesh(folder.write("a.obj", QByteArray::fromStdString(text)));
    QCOMPARE(read.mesh.layerCount, 2U);
    QCOMPARE(*read.metresPerUnit, 0.01);
    for (const double scale : {0.0, -1.0, double(INFINITY), double(NAN)}) {
      options.scale = scale;
      QVERIFY_EXCEPTION_THROWN(formatObj(framed(sample(), frame(UpAxis::Y)), {}, options), InputError);
    }
    NavigationMesh far = sample();
    far.vertices[0].x = 1e300;
    options.scale = 1e10;
    QVERIFY_EXCEPTION_THROWN(formatObj(framed(far, frame(UpAxis::Y)), {}, options), InputError);
  }

  void placedObstaclesStandBehindTheArea() {
    const TemporaryFolder folder;
    const ExportExtra crate{"my crate\n2", {{{5, 5, 0}, {6, 5, 0}, {6, 6, 0}}, {{0, 1, 2}}}};
    const std::string text = formatObj(framed(sample(), frame(UpAxis::Z)), {}, {}, std::array{crate});
    QVERIFY2(text.ends_with("g placed_my_crate_2\nv 5 5 0\nv 6 5 0\nv 6 6 0\nf 10 11 12\n"), text.c_str());
    // A reader of the export does not take it for walkable area.
    const auto read = readNavigationMesh(folder.write("a.obj", QByteArray::fromStdString(text)));
    QVERIFY(read.mesh.vertices == sample().vertices);
    QCOMPARE(read.mesh.triangles.size(), 5U);
    QCOMPARE(read.mesh.layerCount, 2U);
    const GltfFile file = formatGltf(GltfKind::Text, framed(sample(), frame(UpAxis::Z)), {}, {}, std::array{crate});
    QVERIFY(names(QJsonDocument::fromJson(QByteArray::fromStdString(file.bytes)).object()["meshes"].toArray())
                .contains("placed_my crate\n2"));
  }

  void extrasSayWhatTheTrianglesDoNot() {
    NavigationMesh mesh = framed(sample(), frame(UpAxis::Y, 0.5));
    mesh.links = {{{0, 1}, {7, 6}, 0, 4, 0.25, 0.125, StepKind::Gap}};
    mesh.drops.resize(1);
    mesh.drops[0].fromTriangle = 2;
    mesh.drops[0].depth = 3;
    ExportHeader header;
    header.numbers.height = 2;
    header.numbers.step = 0.5;
    ExportOptions options;
    options.scale = 2;
    const auto object = [&](double scale, bool navmeshNode) {
      options.scale = scale;
      options.navmeshNode = navmeshNode;
      const GltfFile file = formatGltf(GltfKind::Text, mesh, header, options);
      return QJsonDocument::fromJson(QByteArray::fromStdString(file.bytes)).object();
    };
    QMap<QString, QJsonObject> extras;
    const QJsonObject json = object(1, false);
    for (const auto& node : json["nodes"].toArray())
      extras[node.toObject()["name"].toString()] = node.toObject()["extras"].toObject();
    QCOMPARE(extras["layer_1"]["layer"].toInt(), 1);
    QCOMPARE(extras["layer_1"]["triangles"].toInt(), 2);
    QCOMPARE(extras["layer_1"]["area"].toDouble(), std::sqrt(5.0) * 2 / 4);
    QCOMPARE(extras["gaps"]["faces"].toArray(), (QJsonArray{2}));
    QCOMPARE(extras["gaps"]["heights"].toArray(), (QJsonArray{0.125}));
    QCOMPARE(extras["gaps"]["widths"].toArray(), (QJsonArray{0.0625}));
    QCOMPARE(extras["gaps"]["layers"].toArray(), (QJsonArray{QJsonArray{0, 0}}));
    QCOMPARE(extras["drops"]["depths"].toArray(), (QJsonArray{1.5}));
    QCOMPARE(extras["drops"]["layers"].toArray(), (QJsonArray{QJsonArray{1, 0}}));
    const auto numbersOf = [](const QJsonObject& file) {
      return file["asset"].toObject()["extras"].toObject()["agent_numbers"].toObject();
    };
    QCOMPARE(numbersOf(json)["height"].toDouble(), 1.0);
    QCOMPARE(numbersOf(json)["step"].toDouble(), 0.25);
    QVERIFY(numbersOf(json)["max_slope"].isNull());
    QCOMPARE(numbersOf(object(2, false))["height"].toDouble(), 2.0);
    QCOMPARE(names(object(1, true)["meshes"].toArray()).front(), QString("walkable-navmesh"));
  }

  void gltfHasAMeshForEachLayer() {
    const QJsonObject json = gltf(framed(sample(), frame(UpAxis::Y)));
    QCOMPARE(names(json["meshes"].toArray()), (QStringList{"layer_0", "layer_1", "connections", "obstacle_edges"}));
    QList<int> modes, counts;
    for (const auto& mesh : json["meshes"].toArray()) {
      const QJsonObject primitive = mesh.toObject()["primitives"].toArray()[0].toObject();
      modes << primitive["mode"].toInt();
      const int positions = primitive["attributes"].toObject()["POSITION"].toInt();
      counts << json["accessors"].toArray()[positions].toObject()["count"].toInt();
    }
    QCOMPARE(modes, (QList<int>{4, 4, 1, 1}));
    // The two sides of the obstacle edge stay apart, though they are at one place.
    QCOMPARE(counts, (QList<int>{7, 4, 2, 2}));
    const QJsonArray materials = json["materials"].toArray();
    QVERIFY(materials[0].toObject()["pbrMetallicRoughness"] != materials[1].toObject()["pbrMetallicRoughness"]);
    QVERIFY(materials[0].toObject()["doubleSided"].toBool());
    const QJsonObject extras = json["asset"].toObject()["extras"].toObject();
    QCOMPARE(extras["source"].toString(), QString("level.obj"));
    QCOMPARE(extras["pipeline"].toString(), QString("SlopeFilter 45\n"));

    ExportOptions options;
    options.layers = options.connections = options.obstacleEdges = false;
    QCOMPARE(names(gltf(framed(sample(), frame(UpAxis::Y)), options)["meshes"].toArray()), QStringList{"walkable"});
  }

  void anEmptyResultIsAFileAllTheSame() {
    for (const GltfKind kind : {GltfKind::Text, GltfKind::Binary}) {
      const GltfFile file = formatGltf(kind, framed(NavigationMesh(), frame(UpAxis::Y)), {});
      QVERIFY(file.bytes.find("\"2.0\"") != std::string::npos);
      QCOMPARE(file.largestError, 0.0);
    }
  }

  void gltfReadsBackInMetresAndYUp_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("text") << "a.gltf";
    QTest::newRow("binary") << "a.glb";
    QTest::newRow("capitals") << "A.GLB";
  }

  void gltfReadsBackInMetresAndYUp() {
    QFETCH(QString, name);
    const TemporaryFolder folder;
    const std::string path = folder.path(name.toUtf8().constData());
    NavigationMesh mesh = sample();
    mesh.connections.clear();
    mesh.obstacleEdges.clear();
    ExportOptions options;
    options.scale = 2;
    QCOMPARE(save(framed(mesh, frame(UpAxis::Z, 0.25)), path, options), 0.0);
    QCOMPARE(folder.files(), QStringList{name});
    const auto environment = importEnvironment(path);
    QVERIFY(environment->up == UpAxis::Y);
    for (Vec3& p : mesh.vertices) p = {p.x / 2, p.y / 2, p.z / 2};
    QVERIFY(trianglesOf(environment->vertices, environment->triangles) == trianglesOf(mesh.vertices, mesh.triangles));
  }

  void realResultsReadBackInFloats() {
    if (sharedEnvironments().isEmpty()) QSKIP("the shared environments are not here; set FOOTFALL_SHARED");
    RunContext context;
    const auto source = importEnvironment((sharedEnvironments() + "/nav_test.obj").toStdString());
    const RunResult result = runPipeline(source, defaultPipeline(*source), context);
    NavigationMesh mesh = *result.mesh;
    const TemporaryFolder folder;
    const double error = save(framed(mesh, source->frame()), folder.path("a.glb"));
    QVERIFY(error > 0 && error < 1e-5);
    ImportOptions asTheFileHasThem;
    asTheFileHasThem.grid = GridChoice::Off;
    const auto read = importEnvironment(folder.path("a.glb"), asTheFileHasThem);
    // The value goes over memory: with -O3, GCC 12 leaves out the conversion to floats and back where it takes two
    // numbers at once.
    const auto toFloat = [](double x) {
      const volatile float rounded = static_cast<float>(x);
      return static_cast<double>(rounded);
    };
    for (Vec3& p : mesh.vertices) p = {toFloat(p.x), toFloat(p.y), toFloat(p.z)};
    std::vector<Triangle> all = mesh.triangles;
    QVERIFY(!mesh.links.empty());
    for (const StepLink& link : mesh.links) {
      all.push_back({link.from[0], link.from[1], link.to[0]});
      all.push_back({link.from[0], link.to[0], link.to[1]});
    }
    auto expected = trianglesOf(mesh.vertices, all);
    // Readers may drop what has become a line or a point.
    std::size_t missing = expected.size();
    for (const auto& triangle : trianglesOf(read->vertices, read->triangles)) {
      const auto found = expected.find(triangle);
      QVERIFY(found != expected.end());
      expected.erase(found);
      --missing;
    }
    QCOMPARE(missing, expected.size());
    for (const auto& f : expected) QVERIFY(f[0] == f[1] || f[1] == f[2] || f[0] == f[2]);
    QVERIFY(expected.size() < 5);
  }

  void farAwayTheErrorIsTold() {
    NavigationMesh mesh = sample();
    for (Vec3& p : mesh.vertices) p.x += 487000.456;
    const GltfFile file = formatGltf(GltfKind::Binary, framed(mesh, frame(UpAxis::Z)), {});
    QVERIFY(file.largestError > 1e-3 && file.largestError < 0.016);
    mesh.vertices[0].y = 1e39;
    QVERIFY_EXCEPTION_THROWN(formatGltf(GltfKind::Binary, framed(mesh, frame(UpAxis::Z)), {}), InputError);
  }

  void sameInputSameBytes() {
    QCOMPARE(formatGltf(GltfKind::Binary, framed(sample(), frame(UpAxis::Y)), {}).bytes,
             formatGltf(GltfKind::Binary, framed(sample(), frame(UpAxis::Y)), {}).bytes);
  }

  void targetsThatCannotBeWritten() {
    const TemporaryFolder folder;
    const auto failure = [](const std::string& path) {
      return messageOf<RunError>([&] { save(framed(sample(), frame(UpAxis::Y)), path); });
    };
    QVERIFY(failure("/nowhere/at/all.glb").contains("its folder does not exist"));
    QVERIFY(failure("/dev/full").contains("the disk is full"));
    QCOMPARE(::symlink("/dev/full", folder.path("full.gltf").c_str()), 0);
    QVERIFY(failure(folder.path("full.gltf")).contains("the disk is full"));
    QCOMPARE(::mkdir(folder.path("folder.glb").c_str(), 0777), 0);
    QVERIFY(failure(folder.path("folder.glb")).contains("is a folder"));
    if (::geteuid() != 0) {
      const std::string readOnly = folder.write("old.glb", "old");
      QCOMPARE(::chmod(readOnly.c_str(), 0444), 0);
      QVERIFY(failure(readOnly).contains("no permission"));
      QCOMPARE(readAll(readOnly), QByteArray("old"));
    }
    QVERIFY(messageOf<InputError>([] { exportFormatOf("a.fbx"); }).contains(".obj, .gltf, .glb, .bin, .tres, "));
  }

  void theCommandLineHasTheOptions() {
    const TemporaryFolder folder;
    const QString in =
        QString::fromStdString(folder.write("in.obj", "v 0 0 0\nv 4 0 0\nv 4 0 -4\nv 0 0 -4\nf 1 2 3 4\n"));
    const QString out = QString::fromStdString(folder.path("out.obj"));
    const auto run = [&](const QStringList& rest) {
      return runProgram(QStringList{"run", in, "--quiet", "-o"} + rest);
    };
    QCOMPARE(
        run({out, "--no-layers", "--no-connections", "--no-obstacle-edges", "--export-up", "z", "--export-scale", "10"})
            .exitCode,
        0);
    const QByteArray text = readAll(out.toStdString());
    QVERIFY2(
        text.contains("g walkable\n") && text.contains("v 40 40 0\n") && text.contains("# frame: Z up, 0.1 metres"),
        text.constData());
    for (const char* name : {"out.gltf", "out.glb"}) {
      QCOMPARE(run({QString::fromStdString(folder.path(name))}).exitCode, 0);
      QCOMPARE(importEnvironment(folder.path(name))->triangles.size(), 2U);
    }
    const Outcome unknown = run({QString::fromStdString(folder.path("out.fbx"))});
    QCOMPARE(unknown.exitCode, 2);
    QVERIFY2(unknown.err.contains("give a name that ends in .obj, .gltf, .glb, .bin, "), unknown.err.constData());
    QCOMPARE(run({out, "--export-scale", "0"}).exitCode, 2);
  }
};

QTEST_GUILESS_MAIN(TestGltfExport)
#include "test_gltf_export.moc"
