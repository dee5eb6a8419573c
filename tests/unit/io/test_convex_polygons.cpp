// Convex polygons out of triangles: as few as they can be where that is plain, convex and conforming everywhere.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>
#include <map>
#include <set>

#include "core/base/vector.hpp"
#include "core/io/formats/convex_polygons.hpp"
#include "core/io/formats/engine_mesh.hpp"
#include "footfall/run.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

struct Mesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

/// n x m squares of two triangles each, at the height that `height` gives.
template <class Height>
Mesh grid(std::uint32_t n, std::uint32_t m, Height height) {
  Mesh mesh;
  for (std::uint32_t y = 0; y <= m; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) mesh.vertices.push_back({double(x), double(y), height(x, y)});
  for (std::uint32_t y = 0; y < m; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t v = y * (n + 1) + x;
      mesh.triangles.push_back({v, v + 1, v + n + 2});
      mesh.triangles.push_back({v, v + n + 2, v + n + 1});
    }
  return mesh;
}

Mesh flatGrid(std::uint32_t n, std::uint32_t m) {
  return grid(n, m, [](auto, auto) { return 0.0; });
}

double planArea(const std::vector<Vec3>& vertices, std::span<const std::uint32_t> corners) {
  double twice = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec3 a = vertices[corners[k]] - vertices[corners[0]];
    const Vec3 b = vertices[corners[(k + 1) % corners.size()]] - vertices[corners[0]];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

double planArea(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
  double area = 0;
  for (const Triangle& t : triangles) area += planArea(vertices, t);
  return area;
}

/// The first thing in words that no result may have; empty when there is none.
QString findError(const Mesh& mesh, const ConvexPolygons& polygons, const MergeRules& rules) {
  double largest = 0, area = 0;
  for (const Vec3& p : mesh.vertices) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  std::map<std::array<std::uint32_t, 2>, std::size_t> edges;  // directed
  std::vector<std::size_t> triangles(polygons.size());
  for (const std::uint32_t polygon : polygons.polygonOf) ++triangles.at(polygon);
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const auto corners = polygons.cornersOf(i);
    if (corners.size() < 3 || corners.size() > rules.maxCorners) return "too many corners";
    if (triangles[i] == 0 || triangles[i] > rules.maxTriangles) return "too many triangles";
    area += planArea(mesh.vertices, corners);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::uint32_t a = corners[k], b = corners[(k + 1) % corners.size()], c = corners[(k + 2) % corners.size()];
      const Vec3 in = mesh.vertices[b] - mesh.vertices[a], out = mesh.vertices[c] - mesh.vertices[b];
      const double bend = (in.x * out.y - in.y * out.x) / std::hypot(in.x + out.x, in.y + out.y);
      if (triangles[i] > 1 && bend < -std::ldexp(largest, -20)) return QString("not convex by %1").arg(bend);
      if (!edges.emplace(std::array{a, b}, i).second) return "an edge of two polygons in one direction";
    }
  }
  std::size_t at = 0;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const auto corners = polygons.cornersOf(i);
    for (std::size_t k = 0; k < corners.size(); ++k, ++at) {
      const auto beyond = edges.find({corners[(k + 1) % corners.size()], corners[k]});
      const std::uint32_t expected = beyond == edges.end() ? kNoPolygon : static_cast<std::uint32_t>(beyond->second);
      if (polygons.neighbours[at] != expected) return "a neighbour that does not share the edge";
    }
  }
  const double expected = planArea(mesh.vertices, mesh.triangles);
  if (std::fabs(area - expected) > 1e-6 * expected) return QString("area %1 of %2").arg(area).arg(expected);
  return {};
}

/// Pairs of polygons that share an edge, and whether all triangles that share one are in polygons that do.
bool keepsNeighbours(const Mesh& mesh, const ConvexPolygons& polygons) {
  std::set<std::array<std::uint32_t, 2>> beside;
  for (std::size_t i = 0, at = 0; i < polygons.size(); ++i)
    for (std::size_t k = 0; k < polygons.cornersOf(i).size(); ++k, ++at)
      if (polygons.neighbours[at] != kNoPolygon)
        beside.insert({static_cast<std::uint32_t>(i), polygons.neighbours[at]});
  const std::vector<std::uint32_t> opposite = oppositeEdges(mesh.triangles);
  for (std::size_t e = 0; e < opposite.size(); ++e) {
    if (opposite[e] == kNoPolygon) continue;
    const std::uint32_t a = polygons.polygonOf[e / 3], b = polygons.polygonOf[opposite[e] / 3];
    if (a != b && !beside.contains({a, b})) return false;
  }
  return true;
}

}  // namespace

class TestConvexPolygons : public QObject {
  Q_OBJECT
 private slots:
  void aSquareIsOnePolygon() {
    const Mesh mesh = flatGrid(1, 1);
    const ConvexPolygons polygons = mergeTriangles(mesh.vertices, mesh.triangles, {}, {});
    QCOMPARE(polygons.size(), 1U);
    QCOMPARE(polygons.corners.size(), 4U);
    QCOMPARE(findError(mesh, polygons, {}), QString());
  }

  void aFieldIsFew() {
    const Mesh mesh = flatGrid(8, 8);
    const MergeRules any{.maxCorners = 1000};
    const ConvexPolygons one = mergeTriangles(mesh.vertices, mesh.triangles, {}, any);
    QCOMPARE(findError(mesh, one, any), QString());
    QCOMPARE(one.size(), 1U);
    const ConvexPolygons six = mergeTriangles(mesh.vertices, mesh.triangles, {}, {});
    QCOMPARE(findError(mesh, six, {}), QString());
    QVERIFY2(six.size() <= 24,
             qPrintable(QString::number(six.size())));  // 128 triangles; its border alone has 32 edges
    QVERIFY(keepsNeighbours(mesh, six));
  }

  void whatIsNotFlatStaysApartWhereThatIsAsked() {
    // A roof: up to x = 4, and down again.
    const Mesh mesh = grid(8, 1, [](std::uint32_t x, auto) { return 0.25 * (x < 4 ? x : 8 - x); });
    const MergeRules flat{.maxCorners = 1000, .maxHeight = 0.001}, any{.maxCorners = 1000};
    const ConvexPolygons two = mergeTriangles(mesh.vertices, mesh.triangles, {}, flat);
    QCOMPARE(two.size(), 2U);
    QCOMPARE(findError(mesh, two, flat), QString());
    QCOMPARE(mergeTriangles(mesh.vertices, mesh.triangles, {}, any).size(), 1U);
  }

  void groupsStayApart() {
    const Mesh mesh = flatGrid(2, 1);
    const std::vector<std::uint32_t> groups{0, 0, 1, 1};
    const ConvexPolygons polygons = mergeTriangles(mesh.vertices, mesh.triangles, groups, {});
    QCOMPARE(polygons.size(), 2U);
    QVERIFY(polygons.polygonOf[0] != polygons.polygonOf[2]);
    QCOMPARE(findError(mesh, polygons, {}), QString());
  }

  void anLIsTwo() {
    Mesh mesh = flatGrid(2, 2);
    mesh.triangles.erase(mesh.triangles.end() - 2, mesh.triangles.end());
    const ConvexPolygons polygons = mergeTriangles(mesh.vertices, mesh.triangles, {}, {});
    QCOMPARE(polygons.size(), 2U);
    QCOMPARE(findError(mesh, polygons, {}), QString());
  }

  void theLimitOfTrianglesHolds() {
    const Mesh mesh = flatGrid(8, 8);
    const MergeRules rules{.maxCorners = 1000, .maxTriangles = 5};
    QCOMPARE(findError(mesh, mergeTriangles(mesh.vertices, mesh.triangles, {}, rules), rules), QString());
  }

  void realResults_data() {
    QTest::addColumn<QString>("file");
    for (const char* name : {"house", "rooms", "villa", "tower"})
      QTest::newRow(name) << QString(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj").arg(name);
    if (!sharedEnvironments().isEmpty())
      for (const char* name : {"nav_test", "complex", "fortitude"})
        QTest::newRow(name) << sharedEnvironments() + '/' + name + ".obj";
  }
  void realResults() {
    QFETCH(QString, file);
    const auto source = importEnvironment(file.toStdString());
    RunContext context;
    const RunResult run = runPipeline(source, defaultPipeline(*source), context);
    const EngineMesh engine = engineMesh(*run.mesh, {});
    const Mesh mesh{engine.vertices, engine.triangles};
    for (const MergeRules& rules : {MergeRules{}, MergeRules{.maxCorners = 1000, .maxHeight = 0.001}}) {
      const ConvexPolygons polygons = mergeTriangles(mesh.vertices, mesh.triangles, engine.layers, rules);
      QCOMPARE(findError(mesh, polygons, rules), QString());
      QVERIFY(keepsNeighbours(mesh, polygons));
      QVERIFY(polygons.size() * 3 < mesh.triangles.size() * 2);
      qInfo("%zu triangles, %zu polygons", mesh.triangles.size(), polygons.size());
    }
  }
};

QTEST_GUILESS_MAIN(TestConvexPolygons)
#include "test_convex_polygons.moc"
