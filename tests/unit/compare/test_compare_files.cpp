// `footfall compare` and the reader of navigation meshes as a user meets them: files, output, exit codes, signals.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>

#include <QElapsedTimer>
#include <QProcess>
#include <QtTest>
#include <nlohmann/json.hpp>
#include <set>

#include "core/io/export.hpp"
#include "core/io/gltf_navigation_mesh.hpp"
#include "footfall/inspect.hpp"
#include "footfall/io.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/unit/environment_files.hpp"
#include "tests/unit/program_run.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

constexpr const char* kSquare = "v 0 0 0\nv 4 0 0\nv 4 0 -4\nv 0 0 -4\nf 1 2 3\nf 1 3 4\n";
constexpr const char* kSquareAsPolygon = "v 0 0 0\nv 2 0 0\nv 4 0 0\nv 4 0 -4\nv 0 0 -4\nf 1 2 3 4 5\n";
constexpr const char* kHalf = "v 0 0 0\nv 2 0 0\nv 2 0 -4\nv 0 0 -4\nf 1 2 3\nf 1 3 4\n";

/// The output of `footfall run` for a sample, and its input.
struct Product {
  std::shared_ptr<const Environment> environment;
  NavigationMesh mesh;
  QByteArray text;
};

Product exported(const char* sample, const std::string& filters) {
  Product product;
  product.environment =
      importEnvironment(std::string(FOOTFALL_SOURCE_DIR "/samples/") + sample + '/' + sample + ".obj");
  product.mesh = navigationMesh(runFilters(product.environment, filters));
  product.text = QByteArray::fromStdString(formatObj(product.mesh, {filters, "test"}));
  return product;
}

QString message(const std::string& path) {
  try {
    readNavigationMesh(path);
  } catch (const InputError& error) {
    return QString::fromUtf8(error.what());
  }
  return {};
}

/// Many small triangles in many planes: enough work for a signal to arrive in the middle.
QByteArray hills(int n, int shift) {
  QByteArray text;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x)
      text += "v " + QByteArray::number(x + 0.1 * shift) + ' ' + QByteArray::number((x * 7 + y * 13) % 11 * 0.1) + ' ' +
              QByteArray::number(y) + '\n';
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const int a = y * (n + 1) + x + 1, c = a + n + 2;
      for (const int b : {a + 1, a + n + 1})
        text += "f " + QByteArray::number(a) + ' ' + QByteArray::number(b) + ' ' + QByteArray::number(c) + '\n';
    }
  }
  return text;
}

}  // namespace

class TestCompareFiles : public QObject {
  Q_OBJECT
 private slots:
  void gltfIsRefusedInOneLine() {
    const QTemporaryDir folder;
    for (const char* content :
         {"{\"asset\": {\"version\": \"2.0\"}}", "\n {\"meshes\": [], \"asset\" : {}}", "glTF\2"}) {
      const std::string path = folder.filePath("a.glb").toStdString();
      QFile file(QString::fromStdString(path));
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(content);
      file.close();
      const QString told = message(path);
      QVERIFY2(told.contains("glTF has numbers of 24 bits") && told.contains("export as OBJ"), qPrintable(told));
      QVERIFY(!told.contains('\n'));
    }
  }

  void exportsReadBack_data();
  void exportsReadBack();
  void gltfReadsBackWhatObjDoes_data();
  void gltfReadsBackWhatObjDoes();
  void damagedGltfIsRefused();
  void readingGltfIsCancelled();
  void groupsAmongPolygons();
  void upAxes();
  void refusedFiles_data();
  void refusedFiles();
  void emptyExport();
  void reportForPeople();
  void facesOverVerticesOfDropsAreRefused();
  void stepsInReports();
  void jsonKeys();
  void exitCodes();
  void wrongUsage_data();
  void wrongUsage();
  void signalCancels();

 private:
  QString file(const char* name, const QByteArray& content) const {
    return QString::fromStdString(folder_.write(name, content));
  }
  TemporaryFolder folder_;
};

void TestCompareFiles::exportsReadBack_data() {
  QTest::addColumn<QByteArray>("filters");
  QTest::newRow("layers") << QByteArray("SlopeFilter 45\nVerticalClearanceFilter 2\nLayerSubdivisionFilter\n");
  QTest::newRow("no layers") << QByteArray("SlopeFilter 45\nVerticalClearanceFilter 2\n");
}

void TestCompareFiles::exportsReadBack() {
  QFETCH(QByteArray, filters);
  const Product product = exported("house", filters.toStdString());
  const auto read = readNavigationMesh(folder_.write("house.obj", product.text));
  QVERIFY(read.isExport);
  QVERIFY(read.statedUp == product.environment->up);
  QVERIFY(read.metresPerUnit == product.environment->metresPerUnit);
  QVERIFY(read.mesh.vertices == product.mesh.vertices);
  QCOMPARE(read.mesh.triangles.size(), product.mesh.triangles.size());
  QCOMPARE(read.mesh.layerCount, product.mesh.layerCount);
  QVERIFY(read.mesh.connections == product.mesh.connections);
  QVERIFY(read.mesh.obstacleEdges == product.mesh.obstacleEdges);
  QVERIFY(!read.mesh.obstacleEdges.empty());
  // An export goes layer by layer.
  std::vector<std::pair<std::uint32_t, Triangle>> expected, found;
  for (std::size_t i = 0; i < product.mesh.triangles.size(); ++i) {
    expected.push_back({product.mesh.layers.empty() ? 0 : product.mesh.layers[i], product.mesh.triangles[i]});
    found.push_back({read.mesh.layers.empty() ? 0 : read.mesh.layers[i], read.mesh.triangles[i]});
  }
  std::stable_sort(expected.begin(), expected.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  QVERIFY(found == expected);
}

void TestCompareFiles::gltfReadsBackWhatObjDoes_data() {
  QTest::addColumn<QString>("sample");
  QTest::addColumn<QString>("ending");
  QTest::addColumn<bool>("layers");
  QTest::newRow("house, binary") << "house"
                                 << ".glb" << true;
  QTest::newRow("house, text") << "house"
                               << ".gltf" << true;
  QTest::newRow("house, no layers") << "house"
                                    << ".glb" << false;
  QTest::newRow("villa") << "villa"
                         << ".glb" << true;
}

void TestCompareFiles::gltfReadsBackWhatObjDoes() {
  QFETCH(QString, sample);
  QFETCH(QString, ending);
  QFETCH(bool, layers);
  const std::string filters =
      std::string("SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4 0.05\nAreaFilter 1\n") +
      (layers ? "LayerSubdivisionFilter\n" : "") + "DropFilter 1.5 0.3\n";
  const Product product = exported(sample.toUtf8(), filters);
  const auto obj = readNavigationMesh(folder_.write("a.obj", product.text));
  const std::string path = folder_.path(qPrintable("a" + ending));
  save(product.mesh, path);
  const auto gltf = readNavigationMesh(path);
  QVERIFY(gltf.isExport && gltf.statedUp == UpAxis::Y && gltf.metresPerUnit == 1);
  QCOMPARE(gltf.mesh.triangles.size(), obj.mesh.triangles.size());
  QCOMPARE(gltf.mesh.layerCount, obj.mesh.layerCount);
  QCOMPARE(gltf.mesh.connections.size(), obj.mesh.connections.size());
  QCOMPARE(gltf.mesh.obstacleEdges.size(), obj.mesh.obstacleEdges.size());
  QCOMPARE(gltf.mesh.drops.size(), obj.mesh.drops.size());
  QCOMPARE(findComponents(gltf.mesh).list.size(), findComponents(obj.mesh).list.size());
  // Each link is between the same places, at the same triangles, up to floats.
  QVERIFY(!obj.mesh.links.empty());
  QCOMPARE(gltf.mesh.links.size(), obj.mesh.links.size());
  const auto rounded = [](const Vec3& p) {
    return std::array<float, 3>{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  };
  const auto linksOf = [&](const NavigationMesh& mesh) {
    std::multiset<std::pair<std::array<std::array<float, 3>, 4>, StepKind>> links;
    for (const StepLink& link : mesh.links) {
      std::array<std::array<float, 3>, 4> places{
          rounded(mesh.vertices[link.from[0]]), rounded(mesh.vertices[link.from[1]]),
          rounded(mesh.vertices[link.to[0]]), rounded(mesh.vertices[link.to[1]])};
      if (std::array{places[2], places[3]} < std::array{places[0], places[1]}) {
        std::swap(places[0], places[2]);
        std::swap(places[1], places[3]);
      }
      links.insert({places, link.kind});
    }
    return links;
  };
  QVERIFY(linksOf(gltf.mesh) == linksOf(obj.mesh));
}

void TestCompareFiles::damagedGltfIsRefused() {
  const Product product =
      exported("house", "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4 0.05\nLayerSubdivisionFilter\n");
  const std::string path = folder_.path("whole.glb");
  save(product.mesh, path);
  QFile written(QString::fromStdString(path));
  QVERIFY(written.open(QIODevice::ReadOnly));
  const QByteArray whole = written.readAll();
  for (const int size : {static_cast<int>(whole.size()) - 8, static_cast<int>(whole.size()) / 2}) {
    const QString told = message(folder_.write("cut.glb", whole.left(size)));
    QVERIFY2(told.contains("its glTF is damaged") && !told.contains('\n'), qPrintable(told));
  }
  QByteArray wrong = whole;
  const auto indices = wrong.lastIndexOf(QByteArray::fromHex("00000000"));
  QVERIFY(indices > 0);
  wrong.replace(indices, 4, QByteArray::fromHex("ffffffff"));
  QVERIFY(message(folder_.write("wrong.glb", wrong)).contains("its glTF is damaged"));
  // Some triangles in layers, others not.
  const std::string text = folder_.path("whole.gltf");
  save(product.mesh, text);
  QByteArray mixed = contentOf(QString::fromStdString(text));
  QVERIFY(mixed.contains("\"layer_1\""));
  mixed.replace("\"layer_1\"", "\"walkable\"");
  QVERIFY(message(folder_.write("mixed.gltf", mixed)).contains("its glTF is damaged"));
}

void TestCompareFiles::readingGltfIsCancelled() {
  const Product product =
      exported("tower", "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4 0.05\nLayerSubdivisionFilter\n");
  const std::string path = folder_.path("long.glb");
  save(product.mesh, path);
  const QByteArray content = contentOf(QString::fromStdString(path));
  const std::string_view text(content.constData(), static_cast<std::size_t>(content.size()));
  int polls = 0;
  QVERIFY(readGltfNavigationMesh(path, text, [&polls] { ++polls; }).has_value());
  QVERIFY(polls > 5);
  for (int last = 1; last <= polls; ++last) {
    int asked = 0;
    QVERIFY_THROWS_EXCEPTION(Cancelled, readGltfNavigationMesh(path, text, [&] {
                               if (++asked == last) throw Cancelled();
                             }));
  }
}

void TestCompareFiles::groupsAmongPolygons() {
  const auto read = readNavigationMesh(
      folder_.write("groups.obj",
                    "v 0 0 0\nv 4 0 0\nv 4 0 -4\nv 0 0 -4\nv 2 1 -6\n"
                    "g layer_1\nf 1 2 3 4\nf 4 3 5\ng layer_0  \nf 1 2 3\nf 1 2 3 4\ng connections\nl 3 4 5\n"
                    "g obstacle_edges\nl -1 -2\ng other\nl 1 2\n"));
  QCOMPARE(read.mesh.layers, (std::vector<std::uint32_t>{1, 1, 1, 0, 0, 0}));
  QCOMPARE(read.mesh.layerCount, 2U);
  QVERIFY((read.mesh.connections == std::vector<std::array<std::uint32_t, 2>>{{2, 3}, {3, 4}}));
  QVERIFY((read.mesh.obstacleEdges == std::vector<std::array<std::uint32_t, 2>>{{4, 3}}));
  // A face outside of layers: the groups are not ours.
  QVERIFY(readNavigationMesh(folder_.write("other.obj", "v 0 0 0\nv 4 0 0\nv 4 0 -4\nf 1 2 3\ng layer_0\nf 1 2 3\n"))
              .mesh.layers.empty());
}

void TestCompareFiles::upAxes() {
  const std::string y = folder_.write("y.obj", kSquare);
  const std::string z =
      folder_.write("z.obj", QByteArray("# Walkable area by Footfall 1\n# frame: Z up, 0.5 metres per unit\n"
                                        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nf 1 2 4\nf 2 3 4\n"));
  QVERIFY(readNavigationMesh(y).up == UpAxis::Y);
  QVERIFY(readNavigationMesh(y, std::nullopt, UpAxis::Z).up == UpAxis::Z);
  QVERIFY(readNavigationMesh(z).up == UpAxis::Z);
  QVERIFY(readNavigationMesh(z).metresPerUnit == 0.5);
  QVERIFY(readNavigationMesh(z, UpAxis::Y).up == UpAxis::Y);
  QVERIFY((readNavigationMesh(y).mesh.vertices[2] == Vec3{4, 4, 0}));
  // A file that states no axis lies as the other file does, whichever comes first.
  const QByteArray flat = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nf 1 2 3 4\n";
  const QString unstated = file("unstated.obj", flat);
  for (const QStringList& files :
       {QStringList{unstated, QString::fromStdString(z)}, QStringList{QString::fromStdString(z), unstated}}) {
    const Outcome outcome = runProgram(QStringList{"compare"} + files + QStringList{"--json"});
    QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    const auto json = nlohmann::json::parse(outcome.out.toStdString());
    QVERIFY(json.at("equal") == true && json.at("a").at("up") == "z" && json.at("b").at("up") == "z");
    QVERIFY(json.at("a").at("plan_area") == 16);
  }
}

void TestCompareFiles::refusedFiles_data() {
  QTest::addColumn<QByteArray>("content");
  QTest::addColumn<QString>("says");
  const QByteArray header = "# Walkable area by Footfall 1\n# content: 4 vertices, 2 triangles, 0 layers, ";
  QTest::newRow("empty") << QByteArray() << "is empty";
  QTest::newRow("no faces") << QByteArray("v 0 0 0\nv 1 0 0\nv 0 0 1\nl 1 2\n") << "no triangles in it; choose";
  QTest::newRow("NaN") << QByteArray("v 0 nan 0\n") << ":1: ";
  QTest::newRow("no number") << QByteArray("v 0 0 zero\n") << "'zero' is not a number";
  QTest::newRow("not OBJ") << QByteArray("<svg/>\n") << "not an OBJ statement";
  QTest::newRow("binary") << QByteArray("v 0 0 0\n\0\1\2", 11) << "NUL byte";
  QTest::newRow("index") << QByteArray(kSquare) + "f 1 2 9\n"
                         << "out of range";
  QTest::newRow("line index") << QByteArray(kSquare) + "g connections\nl 1 9\n"
                              << "out of range";
  QTest::newRow("line garbage") << QByteArray(kSquare) + "l 1 x\n"
                                << "'x'";
  QTest::newRow("cut in a line") << QByteArray(kSquare).chopped(6) << "truncated";
  QTest::newRow("cut after a line") << header + "0 connections, 0 obstacle edges\n" + QByteArray(kSquare).chopped(8)
                                    << "triangles: its comments count 2, but it has 1; it was cut off";
  QTest::newRow("lost connections") << header + "3 connections, 0 obstacle edges\n" + kSquare
                                    << "connections: its comments count 3, but it has 0";
  QTest::newRow("enormous") << QByteArray("v 0 0 0\nv 1e200 0 0\nv 0 0 1e200\nf 1 2 3\n") << "above 1e100";
}

void TestCompareFiles::refusedFiles() {
  QFETCH(QByteArray, content);
  QFETCH(QString, says);
  const std::string path = folder_.write("refused.obj", content);
  const QString text = message(path);
  QVERIFY2(text.contains(says) && text.startsWith(QString::fromStdString(path)) && !text.contains('\n'),
           qPrintable(text));
  const Outcome outcome = runProgram({"compare", file("square.obj", kSquare), QString::fromStdString(path)});
  QCOMPARE(outcome.exitCode, 2);
  QVERIFY(outcome.out.isEmpty());
  QCOMPARE(outcome.err.count('\n'), 1);
}

void TestCompareFiles::emptyExport() {
  const QByteArray empty =
      "# Walkable area by Footfall 1\n# content: 0 vertices, 0 triangles, 0 layers, 0 connections, 0 obstacle edges\n"
      "g walkable\n";
  const Outcome outcome = runProgram({"compare", file("empty.obj", empty), file("square.obj", kSquare), "--json"});
  QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
  const auto json = nlohmann::json::parse(outcome.out.toStdString());
  QVERIFY(json.at("equal") == false && json.at("distances").is_null() && json.at("area_ratio").is_null());
  QVERIFY(json.at("exact").at("b_without_a").at("area") == 16);
}

void TestCompareFiles::reportForPeople() {
  const QString square = file("square.obj", kSquare);
  const Outcome same = runProgram({"compare", square, file("polygon.obj", kSquareAsPolygon)});
  QVERIFY2(same.exitCode == 0 && same.err.isEmpty(), same.err.constData());
  QVERIFY(same.out.contains("Equal: both are the same set of points.\n"));
  QVERIFY(!same.out.contains('\r') && !same.out.contains('\x1b'));
  const Outcome half = runProgram({"compare", square, file("half.obj", kHalf)});
  QCOMPARE(half.exitCode, 0);
  QVERIFY(half.out.contains("Different: A holds all of B, and more."));
  QVERIFY(QString(half.out).contains(QRegularExpression("exact area +8 +0\n")));
  QVERIFY(half.out.contains("walkable space covered: 0.5 of A"));
  QVERIFY(runProgram({"compare", square, square}).out.contains("Equal"));
}

// Steps end in vertices of their own, and these are rounded: floors that slope differ by that, and nothing else.
// A face of the mesh over a vertex of a drop: no vertex of the mesh is left for it.
void TestCompareFiles::facesOverVerticesOfDropsAreRefused() {
  const QByteArray text =
      "# Walkable area by Footfall\n# content: 3 vertices, 1 triangles, 0 layers, 0 connections, 0 obstacle edges, "
      "1 drops\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 1 1 -1\nv 1 2 0\nv 1 2 -1\ng walkable\nf 1 2 4\ng drops\n"
      "l 4 5\nl 6 7\n";
  QVERIFY_EXCEPTION_THROWN((void)readNavigationMesh(folder_.write("edited.obj", text)), InputError);
}

void TestCompareFiles::stepsInReports() {
  const std::string filters = "SlopeFilter 45\nVerticalClearanceFilter 2\n";
  const Product without = exported("villa", filters), with = exported("villa", filters + "StepFilter 0.4\n");
  QVERIFY(with.mesh.links.size() > 100);
  const QString a = file("without.obj", without.text), b = file("with.obj", with.text);
  const Outcome outcome = runProgram({"compare", a, b, "--json"});
  const auto json = nlohmann::json::parse(outcome.out.toStdString());
  QVERIFY(json.at("equal") == false);
  QVERIFY(json.at("a").at("links") == 0 && json.at("a").at("highest_link").is_null());
  QVERIFY(json.at("b").at("links") == with.mesh.links.size());
  QVERIFY(json.at("b").at("components") < json.at("a").at("components"));
  QVERIFY(json.at("links").at("a_without_b").at("empty") == true && json.at("links").at("common").at("length") == 0);
  const double length = json.at("b").at("link_length"), only = json.at("links").at("b_without_a").at("length");
  QVERIFY(length > 100 && std::fabs(length - only) <= 1e-12 * length);
  QVERIFY(json.at("b").at("highest_link").get<double>() < 0.4 + 1e-9);  // The height is between rounded vertices.

  const Outcome people = runProgram({"compare", a, b, "--fail-if-different"});
  QCOMPARE(people.exitCode, 1);
  QVERIFY2(
      QString(people.err)
          .contains(QRegularExpression(
              "are not the same set of points; heights within [0-9.e-]+, an area of at most [0-9.]+e-1[0-9] in the "
              "plan is in one of them only, and no point of either is farther than [0-9.]+e-[0-9]+ from the other")),
      people.err.constData());
  QVERIFY(people.out.contains("Different as exact sets; heights within "));
  QVERIFY(people.out.contains("Only B has steps.\n"));
  QVERIFY(QString(people.out).contains(QRegularExpression("steps, length in the plan +0 +[1-9]")));
  QVERIFY(runProgram({"compare", b, b}).out.contains("Both have the same steps.\n"));
  const QString lower = file("lower.obj", exported("villa", filters + "StepFilter 0.2\n").text);
  QVERIFY(runProgram({"compare", lower, b}).out.contains("Their steps differ.\n"));
}

void TestCompareFiles::jsonKeys() {
  const Product product = exported("house", "SlopeFilter 45\nVerticalClearanceFilter 2\nLayerSubdivisionFilter\n");
  const QString house = file("house.obj", product.text);
  const Outcome outcome = runProgram(
      {"compare", house, file("half.obj", kHalf), "--json", "--height", "0.5", "--error", "0.25", "--threads", "2"});
  QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
  const auto json = nlohmann::json::parse(outcome.out.toStdString());
  QVERIFY(json.at("equal") == false);
  for (const char* side : {"a", "b"}) {
    const auto& mesh = json.at(side);
    for (const char* key : {"vertices", "positions", "triangles", "degenerate_triangles", "components", "layers",
                            "connections", "obstacle_edges"})
      QVERIFY2(mesh.at(key).is_number_unsigned(), key);
    for (const char* key : {"area", "plan_area", "connection_length", "obstacle_edge_length"})
      QVERIFY2(mesh.at(key).is_number(), key);
    QVERIFY(mesh.at("file").is_string() && mesh.at("up") == "y" && mesh.at("uncovered").at("plan_area").is_number());
  }
  QVERIFY(json.at("a").at("layers") == product.mesh.layerCount);
  QVERIFY(json.at("a").at("connections") == product.mesh.connections.size());
  QVERIFY(json.at("a").at("obstacle_edges") == product.mesh.obstacleEdges.size());
  QCOMPARE(json.at("a").at("by_layer").size(), std::size_t{product.mesh.layerCount});
  for (const char* key : {"name", "triangles", "components", "area", "plan_area", "uncovered"})
    QVERIFY2(json.at("a").at("by_layer")[0].contains(key), key);
  for (const char* part : {"a_without_b", "b_without_a", "common"}) {
    QVERIFY(json.at("exact").at(part).at("empty").is_boolean());
    QVERIFY(json.at("exact").at(part).at("area").is_number());
  }
  QVERIFY(json.at("within_height").at("height") == 0.5);
  QVERIFY(json.at("distances").at("error") == 0.25);
  for (const char* way : {"a_to_b", "b_to_a"}) {
    for (const char* key : {"d_min", "d_max", "d_mean", "d_rms", "hausdorff_lower", "hausdorff_upper"})
      QVERIFY2(json.at("distances").at(way).at(key).is_number(), key);
    QVERIFY(json.at("distances").at(way).at("samples").get<int>() > 0);
    QCOMPARE(json.at("distances").at(way).at("d_max_at").size(), std::size_t{3});
  }
  for (const char* key : {"walkable_space_covered", "area_ratio", "load_ms", "compare_ms", "peak_rss_bytes"})
    QVERIFY2(json.at(key).is_number(), key);
}

void TestCompareFiles::exitCodes() {
  const QString square = file("square.obj", kSquare), half = file("half.obj", kHalf);
  const auto code = [&](const QStringList& more) { return runProgram(QStringList{"compare"} + more).exitCode; };
  QCOMPARE(code({square, half}), 0);
  QCOMPARE(code({square, file("polygon.obj", kSquareAsPolygon), "--fail-if-different"}), 0);
  QCOMPARE(code({square, half, "--fail-above", "8"}), 0);
  QCOMPARE(code({square, half, "--fail-above", "7.9"}), 1);
  QCOMPARE(code({half, square, "--fail-above", "7.9"}), 1);
  const Outcome outcome = runProgram({"compare", square, half, "--fail-if-different", "--json"});
  QCOMPARE(outcome.exitCode, 1);
  QVERIFY(outcome.err.contains("half.obj are not the same set of points") && outcome.err.count('\n') == 1);
  QVERIFY(nlohmann::json::parse(outcome.out.toStdString()).at("equal") == false);  // the report is there all the same
}

void TestCompareFiles::wrongUsage_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("says");
  QTest::newRow("no files") << QStringList{} << QByteArray("A is required");
  QTest::newRow("one file") << QStringList{"FILE"} << QByteArray("B is required");
  QTest::newRow("missing") << QStringList{"FILE", "nowhere.obj"} << QByteArray("nowhere.obj: no such file");
  QTest::newRow("folder") << QStringList{"FILE", "."} << QByteArray("is a folder");
  QTest::newRow("height") << QStringList{"FILE", "FILE", "--height", "-1"} << QByteArray("the height must be");
  QTest::newRow("height inf") << QStringList{"FILE", "FILE", "--height", "inf"} << QByteArray("the height must be");
  QTest::newRow("error") << QStringList{"FILE", "FILE", "--error", "0"} << QByteArray("the error must be");
  QTest::newRow("area") << QStringList{"FILE", "FILE", "--fail-above", "nan"} << QByteArray("--fail-above");
  QTest::newRow("up") << QStringList{"FILE", "FILE", "--up", "w"} << QByteArray("--up");
}

void TestCompareFiles::wrongUsage() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, says);
  arguments.replaceInStrings(QRegularExpression("^FILE$"), file("square.obj", kSquare));
  const Outcome outcome = runProgram(QStringList{"compare"} + arguments);
  QCOMPARE(outcome.exitCode, 2);
  QVERIFY2(outcome.err.contains(says) && outcome.err.count('\n') == 1, outcome.err.constData());
  QVERIFY(outcome.out.isEmpty());
}

void TestCompareFiles::signalCancels() {
  QProcess process;
  process.start(FOOTFALL_PROGRAM,
                {"compare", file("a.obj", hills(300, 0)), file("b.obj", hills(300, 1)), "--height", "1"});
  QVERIFY(process.waitForStarted());
  const auto blocksInterrupt = [&] {
    QFile status(QString("/proc/%1/status").arg(process.processId()));
    if (!status.open(QIODevice::ReadOnly)) return false;
    for (const QByteArray& line : status.readAll().split('\n'))
      if (line.startsWith("SigBlk:"))
        return (line.mid(7).trimmed().toULongLong(nullptr, 16) & (1u << (SIGINT - 1))) != 0;
    return false;
  };
  QTRY_VERIFY_WITH_TIMEOUT(blocksInterrupt() || process.state() == QProcess::NotRunning, 10000);
  QTest::qWait(500);  // into the comparison
  QElapsedTimer timer;
  timer.start();
  QCOMPARE(::kill(static_cast<pid_t>(process.processId()), SIGINT), 0);
  QVERIFY(process.waitForFinished(20000));
  QVERIFY2(timer.elapsed() < 2000, qPrintable(QString::number(timer.elapsed())));
  QCOMPARE(process.exitCode(), 1);
  QCOMPARE(process.readAllStandardError(), QByteArray("footfall: cancelled\n"));
  QVERIFY(process.readAllStandardOutput().isEmpty());
}

QTEST_GUILESS_MAIN(TestCompareFiles)
#include "test_compare_files.moc"
