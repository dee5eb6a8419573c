// Outlines in the plan: rings, holes that touch, slits, stairs, and polygons as other programs read them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <vector>

#include "core/io/formats/geojson_export.hpp"
#include "core/io/formats/wkt_export.hpp"
#include "core/mesh/plan_outline.hpp"
#include "footfall/errors.hpp"
#include "footfall/inspect.hpp"
#include "footfall/io.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using namespace footfall::detail;
using footfall::test::Soup;

namespace {

/// The unit squares of a grid that `rows` marks, with shared vertices.
NavigationMesh gridMesh(const std::vector<std::string>& rows) {
  NavigationMesh mesh;
  const std::size_t width = rows[0].size() + 1;
  for (std::size_t y = 0; y <= rows.size(); ++y)
    for (std::size_t x = 0; x < width; ++x) mesh.vertices.push_back({double(x), double(y), 0});
  for (std::size_t y = 0; y < rows.size(); ++y) {
    for (std::size_t x = 0; x + 1 < width; ++x) {
      if (rows[y][x] != '#') continue;
      const auto v = static_cast<std::uint32_t>(y * width + x), w = static_cast<std::uint32_t>(width);
      mesh.triangles.push_back({v, v + 1, v + w + 1});
      mesh.triangles.push_back({v, v + w + 1, v + w});
    }
  }
  return mesh;
}

std::vector<std::uint32_t> allOf(const NavigationMesh& mesh) {
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

PlanOutline outlineOf(const NavigationMesh& mesh, EdgeRule rule = EdgeRule::SamePlace) {
  return outlineInPlan(mesh, allOf(mesh), rule);
}

double areaOf(const NavigationMesh& mesh, const PlanPart& part) {
  double sum = doubleAreaOf(mesh, part.outer);
  for (const PlanRing& hole : part.holes) sum += doubleAreaOf(mesh, hole);
  return sum / 2;
}

std::shared_ptr<const NavigationMesh> resultOf(const Soup& soup, const std::string& pipeline) {
  RunContext context;
  return runPipeline(soup.environment(), parsePipeline(pipeline, "test"), context).mesh;
}

constexpr const char* kStepsAndLayers =
    "DuplicationFilter 0\nSlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4\nSimplificationFilter\n"
    "LayerSubdivisionFilter\n";

/// Empty where all geometries are valid by shapely, and polygons have the area that they state.
QByteArray shapelyComplaints(const QString& geojson) {
  QProcess python;
  python.start("/usr/bin/python3", {"-c", R"(
import json, sys
from shapely.geometry import shape
from shapely.validation import explain_validity
for feature in json.load(open(sys.argv[1]))["features"]:
    geometry, about = shape(feature["geometry"]), feature["properties"]
    if not geometry.is_valid: print(about, explain_validity(geometry))
    if about["kind"] == "walkable" and abs(geometry.area - about["plan_area"]) > 1e-9 * geometry.area: print(about, geometry.area)
)",
                                    geojson});
  python.waitForFinished();
  return python.exitCode() == 0 ? python.readAllStandardOutput() : python.readAllStandardError();
}

bool hasShapely() { return QProcess::execute("/usr/bin/python3", {"-c", "import shapely.geometry"}) == 0; }

template <class Change>
ExportOptions with(Change change) {
  ExportOptions options;
  change(options);
  return options;
}

}  // namespace

class TestPlanOutline : public QObject {
  Q_OBJECT

 private slots:
  void squareWithAHole() {
    const NavigationMesh mesh = gridMesh({"###", "#.#", "###"});
    const PlanOutline outline = outlineOf(mesh);
    QCOMPARE(outline.parts.size(), std::size_t{1});
    QCOMPARE(outline.parts[0].outer.size(), std::size_t{12});
    QCOMPARE(outline.parts[0].holes.size(), std::size_t{1});
    QCOMPARE(areaOf(mesh, outline.parts[0]), 8.0);
    QVERIFY(doubleAreaOf(mesh, outline.parts[0].outer) > 0 && doubleAreaOf(mesh, outline.parts[0].holes[0]) < 0);
  }

  void holesThatTouch_data() {
    QTest::addColumn<QStringList>("rows");
    QTest::addColumn<int>("parts");
    QTest::addColumn<int>("holes");
    QTest::addColumn<double>("area");
    // Rows from below. A hole whose corner is a corner of the outline; two holes with a corner in common; ...
    QTest::newRow("outline and hole") << QStringList{".###", "#.##", "####"} << 1 << 1 << 10.0;
    QTest::newRow("two holes") << QStringList{"####", "#.##", "##.#", "####"} << 1 << 2 << 14.0;
    QTest::newRow("parts that touch") << QStringList{"#.", ".#"} << 2 << 0 << 2.0;
    QTest::newRow("chain of holes cuts in two") << QStringList{".###", "#.##", "##.#", "###."} << 2 << 0 << 12.0;
    QTest::newRow("a ring round a part") << QStringList{"#####", "#...#", "#.#.#", "#...#", "#####"} << 2 << 1 << 17.0;
  }
  void holesThatTouch() {
    QFETCH(QStringList, rows);
    QFETCH(int, parts);
    QFETCH(int, holes);
    QFETCH(double, area);
    std::vector<std::string> grid;
    for (const QString& row : rows) grid.push_back(row.toStdString());
    const NavigationMesh mesh = gridMesh(grid);
    const PlanOutline outline = outlineOf(mesh);
    QCOMPARE(int(outline.parts.size()), parts);
    int found = 0;
    double sum = 0;
    for (const PlanPart& part : outline.parts) {
      found += int(part.holes.size());
      sum += areaOf(mesh, part);
      std::vector<PlanRing> rings = part.holes;
      rings.push_back(part.outer);
      for (PlanRing& ring : rings) {
        std::sort(ring.begin(), ring.end());
        QVERIFY(std::adjacent_find(ring.begin(), ring.end()) == ring.end());
      }
    }
    QCOMPARE(found, holes);
    QCOMPARE(sum, area);
  }

  // A wall without thickness in the middle of a room: no slit in the polygon, but a barrier.
  void thinWall() {
    const auto mesh = resultOf(Soup().floor(0, 0, 4, 4, 0).wall(1, 2, 3, 2, 0, 3), kStepsAndLayers);
    QCOMPARE(outlineOf(*mesh, EdgeRule::Joined).parts[0].holes.size(), std::size_t{1});
    const PlanOutline outline = outlineOf(*mesh);
    QCOMPARE(outline.parts.size(), std::size_t{1});
    QVERIFY(outline.parts[0].holes.empty());
    QCOMPARE(areaOf(*mesh, outline.parts[0]), 16.0);
    double length = 0;
    for (const auto& edge : outline.barriers) length += std::abs(mesh->vertices[edge[0]].x - mesh->vertices[edge[1]].x);
    QCOMPARE(length, 2.0);
  }

  // Two treads and a landing: one polygon, because steps link them, and no barrier. A block that is too high to climb
  // is another part, so it stays a polygon of its own beside the hole that it makes.
  void stairsGrowTogether() {
    Soup soup;
    soup.floor(0, 0, 4, 2, 0).floor(4, 0, 5, 2, 0.25).floor(5, 0, 8, 2, 0.5).wall(4, 0, 4, 2, 0, 0.25);
    soup.wall(5, 0, 5, 2, 0.25, 0.5).floor(8, 0, 9, 2, 1.5).wall(8, 0, 8, 2, 0.5, 1.5);
    const auto mesh = resultOf(soup, kStepsAndLayers);
    const PlanPolygons polygons = makePlanPolygons(*mesh);
    QCOMPARE(polygons.polygons.size(), std::size_t{2});
    QVERIFY(polygons.barriers.empty());
    QCOMPARE(areaOf(*mesh, polygons.polygons[0].outline), 16.0);
    QCOMPARE(polygons.polygons[1].part, 1U);
    const auto ofPart = [](std::uint32_t part) { return with([part](ExportOptions& o) { o.part = part; }); };
    QVERIFY(formatLayerWkt(*mesh, polygons, 0).starts_with("GEOMETRYCOLLECTION (POLYGON (("));
    const std::string first = formatLayerWkt(*mesh, polygons, 0, ofPart(0));
    QVERIFY2(first.starts_with("POLYGON ((") && first.ends_with("))\n"), first.c_str());
    QCOMPARE(formatLayerWkt(*mesh, polygons, 0, ofPart(2)), std::string("POLYGON EMPTY\n"));
  }

  // Surfaces of one part that lie side by side without being joined, their vertices on each other's edges.
  void edgesThatOverlap() {
    NavigationMesh mesh = gridMesh({"##"});
    // A single rectangle lies above the upper border of both squares, at another height, linked by one step.
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec3& p : {Vec3{0.5, 1, 3}, Vec3{1.5, 1, 3}, Vec3{1.5, 2, 3}, Vec3{0.5, 2, 3}})
      mesh.vertices.push_back(p);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
    mesh.links.push_back({.fromTriangle = 0, .toTriangle = 4});
    const PlanPolygons polygons = makePlanPolygons(mesh);
    QCOMPARE(polygons.polygons.size(), std::size_t{1});
    QVERIFY(polygons.polygons[0].outline.holes.empty());
    QCOMPARE(areaOf(mesh, polygons.polygons[0].outline), 3.0);
    QCOMPARE(polygons.barriers.size(), std::size_t{2});
  }

  void wellKnownText() {
    NavigationMesh mesh = gridMesh({"#"});
    mesh.frame.metresPerUnit = 0.5;
    const PlanPolygons polygons = makePlanPolygons(mesh);
    QCOMPARE(formatLayerWkt(mesh, polygons, 0), std::string("POLYGON ((0 0, 0.5 0, 0.5 0.5, 0 0.5, 0 0))\n"));
    QCOMPARE(formatLinksWkt(mesh, polygons),
             std::string("GEOMETRYCOLLECTION (MULTILINESTRING EMPTY, MULTILINESTRING EMPTY, MULTILINESTRING EMPTY, "
                         "MULTILINESTRING EMPTY, MULTILINESTRING EMPTY)\n"));
    mesh.drops.push_back({.start = {Vec3{0, 0, 0}, Vec3{1, 0, 0}}});
    QVERIFY(formatLinksWkt(mesh, makePlanPolygons(mesh)).find("MULTILINESTRING ((0 0, 0.5 0))") != std::string::npos);
  }

  void geoJson() {
    Soup soup;
    soup.floor(0, 0, 4, 4, 0).floor(4, 0, 8, 4, 0.25).wall(4, 0, 4, 4, 0, 0.25).floor(20, 0, 21, 1, 0);
    const auto mesh = resultOf(soup, kStepsAndLayers);
    const auto json =
        nlohmann::json::parse(formatGeoJson(*mesh, with([&](ExportOptions& o) { o.coordinateSystem = "EPSG:25832"; })));
    QVERIFY(json.at("crs").at("properties").at("name") == "urn:ogc:def:crs:EPSG::25832");
    int polygons = 0, steps = 0;
    for (const auto& feature : json.at("features")) {
      const auto& about = feature.at("properties");
      if (about.at("kind") == "walkable") {
        ++polygons;
        QCOMPARE(about.at("area").get<double>(), about.at("part") == 1 ? 32.0 : 1.0);
        QCOMPARE(about.at("plan_area").get<double>(), about.at("area").get<double>());
        QVERIFY(feature.at("geometry").at("coordinates")[0].front() ==
                feature.at("geometry").at("coordinates")[0].back());
      } else {
        QVERIFY(about.at("kind") == "step");
        QCOMPARE(about.at("height").get<double>(), 0.25);
        ++steps;
      }
    }
    QCOMPARE(polygons, 2);
    QVERIFY(steps > 0);
    const auto second = nlohmann::json::parse(formatGeoJson(*mesh, with([&](ExportOptions& o) { o.part = 1; })));
    QVERIFY(!second.contains("crs"));
    QCOMPARE(second.at("features").size(), std::size_t{1});
    QVERIFY(formatGeoJson(*mesh) == formatGeoJson(*mesh));
    QVERIFY_EXCEPTION_THROWN(formatGeoJson(*mesh, with([&](ExportOptions& o) { o.part = 2; })), InputError);
    const auto large = nlohmann::json::parse(formatGeoJson(*mesh, with([](ExportOptions& o) {
      o.layers = o.steps = false;
      o.scale = 10;
    })));
    QCOMPARE(large.at("features").size(), std::size_t{2});
    QCOMPARE(large.at("features")[1].at("properties").at("area").get<double>(), 100.0);
    QVERIFY(!large.at("features")[0].at("properties").contains("layer"));
    for (const char* wrong : {"25832", "EPSG:", "EPSG:1\"", "epsg:1", "EPSG:12345678901"})
      QVERIFY_EXCEPTION_THROWN(formatGeoJson(*mesh, with([&](ExportOptions& o) { o.coordinateSystem = wrong; })),
                               InputError);
  }

  void partsAreThoseOfFindComponents() {
    const auto mesh = std::make_shared<NavigationMesh>(readSample("villa"));
    const NumberedParts parts = numberParts(*mesh);
    const Components components = findComponents(*mesh);
    QVERIFY(components.list.size() > 1);
    QVERIFY(parts.ofTriangle == components.ofTriangle);
    for (std::size_t i = 0; i < parts.areas.size(); ++i) QVERIFY(parts.areas[i] == components.list[i].area);
  }

  void samplesAreValidPolygons_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"house", "villa", "docks"}) QTest::newRow(name) << name;
  }
  void samplesAreValidPolygons() {
    QFETCH(QString, name);
    const NavigationMesh mesh = readSample(name);
    double polygons = 0, triangles = 0;
    const PlanPolygons made = makePlanPolygons(mesh);
    for (const PlanPolygon& polygon : made.polygons) polygons += areaOf(mesh, polygon.outline);
    for (const Triangle& t : mesh.triangles) triangles += doubleAreaOf(mesh, {t[0], t[1], t[2]}) / 2;
    QVERIFY(triangles > 100);
    QVERIFY2(std::abs(polygons - triangles) <= 1e-9 * triangles, qPrintable(QString::number(polygons - triangles)));
    if (!hasShapely()) QSKIP("python3-shapely is missing, so nobody else has looked at the polygons");
    QTemporaryDir folder;
    QFile file(folder.filePath("plan.geojson"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(formatGeoJson(mesh)));
    file.close();
    const QByteArray complaints = shapelyComplaints(file.fileName());
    QVERIFY2(complaints.isEmpty(), complaints.constData());
  }

 private:
  static NavigationMesh readSample(const QString& name) {
    const std::string path = FOOTFALL_SOURCE_DIR "/samples/" + name.toStdString() + '/' + name.toStdString() + ".obj";
    const auto environment = std::make_shared<const Environment>(load(path));
    RunContext context;
    return *runPipeline(environment, defaultPipeline(*environment), context).mesh;
  }
};

QTEST_GUILESS_MAIN(TestPlanOutline)
#include "test_plan_outline.moc"
