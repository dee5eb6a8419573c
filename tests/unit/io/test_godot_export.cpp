// Navigation meshes for Godot: the text, the connections by Godot's rule, and the form for Godot 3.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QtTest>
#include <map>
#include <set>

#include "core/base/vector.hpp"
#include "core/io/formats/convex_polygons.hpp"
#include "core/io/formats/godot_export.hpp"
#include "footfall/path.hpp"
#include "footfall/report.hpp"
#include "footfall/run.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

struct Level {
  std::shared_ptr<const NavigationMesh> mesh;
  ExportHeader header;
};

Level levelOf(const QString& file) {
  const auto source = importEnvironment(file.toStdString());
  const Pipeline pipeline = defaultPipeline(*source);
  RunContext context;
  return {runPipeline(source, pipeline, context).mesh, makeExportHeader(pipeline)};
}

QString sampleFile(const char* name) { return QString(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj").arg(name); }

/// The content of the text, Z up again.
struct Resource {
  std::vector<Vec3> vertices;
  std::vector<std::vector<std::uint32_t>> polygons;
  std::map<QString, QString> properties;
};

std::vector<double> numbersIn(const QString& text) {
  std::vector<double> numbers;
  for (const QString& number : text.split(',', Qt::SkipEmptyParts)) numbers.push_back(number.trimmed().toDouble());
  return numbers;
}

Resource parse(const std::string& text) {
  Resource resource;
  for (const QString& line : QString::fromStdString(text).split('\n')) {
    const qsizetype equals = line.indexOf(" = ");
    if (equals < 0 || line.startsWith('[')) continue;
    resource.properties[line.left(equals)] = line.mid(equals + 3);
  }
  const QRegularExpression list("^(?:PackedVector3Array|PoolVector3Array)\\((.*)\\)$");
  const std::vector<double> places = numbersIn(list.match(resource.properties["vertices"]).captured(1));
  for (std::size_t i = 0; i + 2 < places.size(); i += 3)
    resource.vertices.push_back({places[i], -places[i + 2], places[i + 1]});
  const QRegularExpression polygon("(?:PackedInt32Array|PoolIntArray)\\(([^)]*)\\)");
  for (auto found = polygon.globalMatch(resource.properties["polygons"]); found.hasNext();) {
    resource.polygons.emplace_back();
    for (const double corner : numbersIn(found.next().captured(1)))
      resource.polygons.back().push_back(static_cast<std::uint32_t>(corner));
  }
  return resource;
}

/// Parts that Godot sees: it joins two polygons whose edges have their ends at the same places. -1: a place where more
/// than two meet, of which it drops some.
int godotParts(const Resource& resource) {
  using Place = std::array<double, 3>;
  std::map<std::set<Place>, std::vector<std::uint32_t>> edges;
  for (std::uint32_t i = 0; i < resource.polygons.size(); ++i) {
    const auto& corners = resource.polygons[i];
    for (std::size_t k = 0; k < corners.size(); ++k) {
      std::set<Place> ends;
      for (const std::uint32_t v : {corners[k], corners[(k + 1) % corners.size()]})
        ends.insert({resource.vertices[v].x, resource.vertices[v].y, resource.vertices[v].z});
      edges[ends].push_back(i);
    }
  }
  std::vector<std::uint32_t> part(resource.polygons.size());
  for (std::uint32_t i = 0; i < part.size(); ++i) part[i] = i;
  const auto find = [&](std::uint32_t i) {
    while (part[i] != i) i = part[i] = part[part[i]];
    return i;
  };
  for (const auto& edge : edges)
    if (edge.second.size() >= 2) part[find(edge.second[0])] = find(edge.second[1]);
  int count = 0;
  for (std::uint32_t i = 0; i < part.size(); ++i) count += find(i) == i ? 1 : 0;
  return count;
}

/// Parts of the mesh over common edges and links.
int partsOf(const NavigationMesh& mesh) {
  std::vector<std::uint32_t> part(mesh.triangles.size());
  for (std::uint32_t i = 0; i < part.size(); ++i) part[i] = i;
  const auto find = [&](std::uint32_t i) {
    while (part[i] != i) i = part[i] = part[part[i]];
    return i;
  };
  const std::vector<std::uint32_t> opposite = oppositeEdges(mesh.triangles);
  for (std::uint32_t e = 0; e < opposite.size(); ++e)
    if (opposite[e] != kNoPolygon) part[find(e / 3)] = find(opposite[e] / 3);
  for (const StepLink& link : mesh.links) part[find(link.fromTriangle)] = find(link.toTriangle);
  int count = 0;
  for (std::uint32_t i = 0; i < part.size(); ++i) count += find(i) == i ? 1 : 0;
  return count;
}

}  // namespace

class TestGodotExport : public QObject {
  Q_OBJECT
 private slots:
  void theTextIsThatOfGodot4() {
    Level level = levelOf(sampleFile("house"));
    level.header.numbers.radius = 0.25;
    const std::string text = formatGodot(*level.mesh, level.header).text;
    QVERIFY(text.starts_with("[gd_resource type=\"NavigationMesh\" format=3]\n\n[resource]\n"));
    const Resource resource = parse(text);
    const auto property = [&](const char* name) { return resource.properties.at(name); };
    QCOMPARE(property("resource_name"), QString("\"house\""));
    QCOMPARE(property("agent_height"), QString("2.0"));
    QCOMPARE(property("agent_radius"), QString("0.25"));
    QCOMPARE(property("agent_max_climb"), QString("0.4"));
    QCOMPARE(property("agent_max_slope"), QString("45.0"));
  }

  void theTextIsThatOfGodot3() {
    const Level level = levelOf(sampleFile("house"));
    ExportOptions options;
    options.godot = 3;
    const std::string text = formatGodot(*level.mesh, level.header, options).text;
    QVERIFY(text.starts_with("[gd_resource type=\"NavigationMesh\" format=2]\n"));
    QVERIFY(text.find("Packed") == std::string::npos);
    const Resource three = parse(text), four = parse(formatGodot(*level.mesh, level.header).text);
    QCOMPARE(three.properties.at("agent/max_climb"), QString("0.4"));
    QVERIFY(three.vertices == four.vertices && three.polygons == four.polygons);
    options.godot = 5;
    QVERIFY(messageOf<InputError>([&] { formatGodot(*level.mesh, level.header, options); }).contains("choose 3 or 4"));
  }

  void whoReachesWhomIsTheSame_data() {
    QTest::addColumn<QString>("file");
    for (const char* name : {"house", "rooms", "villa", "tower", "arena", "docks"})
      QTest::newRow(name) << sampleFile(name);
  }
  void whoReachesWhomIsTheSame() {
    QFETCH(QString, file);
    const Level level = levelOf(file);
    const GodotFile written = formatGodot(*level.mesh, level.header);
    const Resource resource = parse(written.text);
    QCOMPARE(resource.polygons.size(), written.polygons);
    QVERIFY(resource.polygons.size() < level.mesh->triangles.size());
    for (const auto& polygon : resource.polygons) {
      QVERIFY(polygon.size() >= 3);
      for (const std::uint32_t v : polygon) QVERIFY(v < resource.vertices.size());
    }
    QCOMPARE(godotParts(resource), partsOf(*level.mesh));
  }

  void obstacleEdgesStayClosed() {
    // Two squares with vertices of their own at the same places.
    NavigationMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
    const Resource apart = parse(formatGodot(mesh, {}).text);
    QCOMPARE(apart.polygons.size(), 2U);
    QCOMPARE(apart.polygons[0].size() + apart.polygons[1].size(), 9U);
    QCOMPARE(godotParts(apart), 2);
    // Unless one steps over them.
    mesh.links = {{{1, 2}, {7, 4}, 0, 3}};
    QCOMPARE(godotParts(parse(formatGodot(mesh, {}).text)), 1);
  }

  void saveWritesIt() {
    const TemporaryFolder folder;
    const Level level = levelOf(sampleFile("rooms"));
    save(*level.mesh, folder.path("level.tres"), {}, level.header);
    QCOMPARE(readAll(folder.path("level.tres")).toStdString(), formatGodot(*level.mesh, level.header).text);
    QVERIFY(messageOf<RunError>([&] { save(*level.mesh, "/dev/full/level.tres"); }).contains("/dev/full"));
    QCOMPARE(folder.files(), QStringList{"level.tres"});
  }

  // A fold in one surface, and the border of another one at the very same place (nav_test has such a place).
  void aBorderInAFoldStaysClosed() {
    NavigationMesh mesh;
    mesh.vertices = {{0, 0, 0}, {0, 4, 0}, {-4, 2, 2}, {4, 2, 2}, {0, 0, 0}, {0, 4, 0}, {3, 2, 3}};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {5, 4, 6}};
    QCOMPARE(partsOf(mesh), 2);
    const Resource resource = parse(formatGodot(mesh, {}).text);
    QCOMPARE(godotParts(resource), 2);
    QCOMPARE(resource.polygons.size(), std::size_t{3});
  }

  /// Godot's server of version 3 loads the file and finds ways.
  void godotFindsTheSameWays() {
    const QString program = QStandardPaths::findExecutable("godot3-server");
    if (program.isEmpty()) QSKIP("there is no godot3-server");
    const TemporaryFolder folder;
    const Level level = levelOf(sampleFile("house"));
    ExportOptions options;
    options.godot = 3;
    save(*level.mesh, folder.path("level.tres"), options, level.header);
    folder.write("project.godot", "config_version=4\n");
    const PathFinder finder(level.mesh);
    QByteArray pairs, expected;
    int reached = 0;
    const std::size_t count = level.mesh->triangles.size();
    for (std::size_t i = 0; i < 200; ++i) {
      std::array<Vec3, 2> ends;
      for (std::size_t k = 0; k < 2; ++k) {
        const Triangle& t = level.mesh->triangles[(i * (k == 0 ? 7919 : 104729) + k) % count];
        ends[k] = (1.0 / 3) * (level.mesh->vertices[t[0]] + level.mesh->vertices[t[1]] + level.mesh->vertices[t[2]]);
        pairs += QByteArray(pairs.isEmpty() ? "" : ",") + "Vector3(" + QByteArray::number(ends[k].x, 'g', 9) + ',' +
                 QByteArray::number(ends[k].z, 'g', 9) + ',' + QByteArray::number(-ends[k].y, 'g', 9) + ')';
      }
      const bool isReached = finder.find(ends[0], ends[1], 0.01).reached();
      reached += isReached ? 1 : 0;
      expected += isReached ? '1' : '0';
    }
    QVERIFY(reached > 20 && reached < 200);
    folder.write("ask.gd",
                 "extends SceneTree\nfunc _init():\n\tvar level = Navigation.new()\n"
                 "\tlevel.navmesh_add(load('res://level.tres'), Transform())\n\tvar places = [" +
                     pairs +
                     "]\n\tvar answer = ''\n\tfor i in range(0, places.size(), 2):\n"
                     "\t\tvar way = level.get_simple_path(places[i], places[i + 1], true)\n"
                     "\t\tanswer += '1' if way.size() > 0 else '0'\n"
                     "\tprint('ways ' + answer)\n\tlevel.free()\n\tquit()\n");
    QProcess godot;
    godot.start(program, {"--path", QFileInfo(QString::fromStdString(folder.path("x"))).path(), "-s", "ask.gd"});
    QVERIFY(godot.waitForFinished(60'000));
    const QByteArray said = godot.readAllStandardOutput();
    const qsizetype at = said.indexOf("ways ");
    QVERIFY2(at >= 0, (said + godot.readAllStandardError()).constData());
    QCOMPARE(said.mid(at + 5, 200), expected);
  }
};

QTEST_GUILESS_MAIN(TestGodotExport)
#include "test_godot_export.moc"
