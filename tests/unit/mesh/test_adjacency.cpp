// Edges, parts and first uses of triangle lists against maps and searches that are obviously right, and disjoint sets.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <atomic>
#include <map>
#include <random>
#include <utility>
#include <vector>

#undef emit  // Qt's word for nothing; the thread library has functions of this name
#include "core/base/disjoint_sets.hpp"
#include "core/mesh/adjacency.hpp"
#include "core/mesh/first_uses.hpp"
#include "core/mesh/surface_topology.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

using Triangles = std::vector<Triangle>;

// Few vertices: many triangles at one edge, the same triangle twice, corners twice in one triangle.
Triangles randomTriangles(std::size_t count, std::uint32_t vertices, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::uint32_t> vertex(0, vertices - 1);
  Triangles triangles(count);
  for (Triangle& t : triangles) t = {vertex(random), vertex(random), vertex(random)};
  return triangles;
}

std::vector<MeshTriangle> asMesh(const Triangles& triangles) {
  std::vector<MeshTriangle> mesh;
  for (const Triangle& t : triangles)
    mesh.push_back({{static_cast<Index>(t[0]), static_cast<Index>(t[1]), static_cast<Index>(t[2])}, 7, 5});
  return mesh;
}

std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Index>> sidesByEnds(const Triangles& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Index>> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      edges[std::minmax(triangles[t][k], triangles[t][(k + 1) % 3])].push_back(static_cast<Index>(3 * t + k));
  return edges;
}

bool isRight(const Adjacency& adjacency, const Triangles& triangles) {
  const auto edges = sidesByEnds(triangles);
  if (adjacency.edgeCount() != static_cast<Index>(edges.size())) return false;
  Index e = 0;
  for (const auto& [ends, sides] : edges)
    if (!std::ranges::equal(adjacency.sidesOf(e++), sides)) return false;
  return adjacency.sides.size() == 3 * triangles.size();
}

// Floods over the edges from each triangle that has no part yet.
std::vector<Index> partsOf(const Triangles& triangles) {
  const auto edges = sidesByEnds(triangles);
  std::vector<Index> parts(triangles.size(), -1);
  Index count = 0;
  for (std::size_t start = 0; start < parts.size(); ++start) {
    if (parts[start] >= 0) continue;
    std::vector<std::size_t> open{start};
    parts[start] = count;
    while (!open.empty()) {
      const std::size_t t = open.back();
      open.pop_back();
      for (std::size_t k = 0; k < 3; ++k)
        for (const Index side : edges.at(std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]))) {
          if (parts[side / 3] >= 0) continue;
          parts[side / 3] = count;
          open.push_back(static_cast<std::size_t>(side / 3));
        }
    }
    ++count;
  }
  return parts;
}

}  // namespace

class TestAdjacency : public QObject {
  Q_OBJECT

 private slots:
  void edgesAndParts_data() {
    QTest::addColumn<int>("triangles");
    QTest::addColumn<int>("vertices");
    // The sizes are below and above those from which several tasks share the work.
    for (const auto& [triangles, vertices] : std::vector<std::pair<int, int>>{
             {0, 1}, {1, 1}, {1, 3}, {9, 2}, {50, 8}, {300, 400}, {6000, 50}, {9000, 20000}})
      QTest::addRow("%d triangles, %d vertices", triangles, vertices) << triangles << vertices;
  }
  void edgesAndParts() {
    QFETCH(int, triangles);
    QFETCH(int, vertices);
    const Triangles list =
        randomTriangles(static_cast<std::size_t>(triangles), static_cast<std::uint32_t>(vertices), 3);
    QVERIFY(isRight(findEdges(list, static_cast<std::size_t>(vertices)), list));
    const std::vector<MeshTriangle> mesh = asMesh(list);
    QVERIFY(isRight(findEdges(mesh, static_cast<std::size_t>(vertices)), list));
    Index count = -1;
    const std::vector<Index> parts = partsOf(list);
    QVERIFY(findParts(list, static_cast<std::size_t>(vertices), count) == parts);
    QCOMPARE(count, parts.empty() ? 0 : *std::max_element(parts.begin(), parts.end()) + 1);
  }

  // Vertices near each other in most blocks of triangles, so that threads leave out blocks, and far in some.
  void edgesOfTrianglesInOrder() {
    std::mt19937 random(11);
    Triangles triangles(20000);
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      triangles[t] = {t / 2, t / 2 + 1, t % 3000 == 7 ? static_cast<std::uint32_t>(random() % 10000) : t / 2 + 2};
    QVERIFY(isRight(findEdges(triangles, 10002), triangles));
    std::ranges::reverse(triangles);
    QVERIFY(isRight(findEdges(triangles, 10002), triangles));
  }

  void verticesAreNumberedByFirstUse() {
    for (const std::size_t count : {0, 1, 50, 9000}) {
      std::vector<MeshTriangle> mesh = asMesh(randomTriangles(count, 700, 13));
      const std::vector<MeshTriangle> given = mesh;
      const FirstUses uses = findFirstUses(mesh.size(), 700, [&](std::size_t t) { return mesh[t].corners; }, {});
      std::vector<Index> order;
      for (const MeshTriangle& t : mesh)
        for (const Index v : t.corners)
          if (std::ranges::find(order, v) == order.end()) order.push_back(v);
      QVERIFY(uses.order == order);
      for (Index v = 0; v < 700; ++v) {
        const auto at = std::ranges::find(order, v);
        QCOMPARE(uses.numbers[v], at == order.end() ? -1 : static_cast<Index>(at - order.begin()));
      }
      renumber(mesh, uses, {});
      for (std::size_t t = 0; t < mesh.size(); ++t)
        for (int k = 0; k < 3; ++k) QCOMPARE(order[mesh[t].corners[k]], given[t].corners[k]);
    }
  }

  void edgesOfSomeAreFoundAmongThoseOfAll_data() { edgesAndParts_data(); }
  void edgesOfSomeAreFoundAmongThoseOfAll() {
    QFETCH(int, triangles);
    QFETCH(int, vertices);
    const Triangles all = randomTriangles(static_cast<std::size_t>(triangles), static_cast<std::uint32_t>(vertices), 5);
    const Adjacency edges = findEdges(all, static_cast<std::size_t>(vertices));
    for (const std::uint32_t share : {0, 1, 2, 4}) {  // fourths
      std::mt19937 random(7);
      Triangles some;
      std::vector<Index> renumbered;
      for (const Triangle& t : all) {
        const bool stays = random() % 4 < share;
        renumbered.push_back(stays ? static_cast<Index>(some.size()) : -1);
        if (stays) some.push_back(t);
      }
      const Adjacency found = edgesOfSome(edges, renumbered, {});
      const Adjacency expected = findEdges(some, static_cast<std::size_t>(vertices));
      QVERIFY(found.sides == expected.sides);
      QVERIFY(found.first == expected.first);
    }
  }

  void noTrianglesHaveNoEdges() {
    const Adjacency adjacency = findEdges(Triangles{}, 0);
    QCOMPARE(adjacency.edgeCount(), 0);
    QVERIFY(adjacency.sides.empty());
  }

  void sidesHaveEnds() {
    const Triangles list{{4, 9, 2}};
    const TriangleCorners corners(list);
    QCOMPARE(corners.size(), 1);
    QCOMPARE((std::pair{corners.beginOf(0), corners.endOf(0)}), (std::pair<Index, Index>{4, 9}));
    QCOMPARE((std::pair{corners.beginOf(2), corners.endOf(2)}), (std::pair<Index, Index>{2, 4}));
  }

  void findingEdgesCanBeCancelled() {
    const Triangles list = randomTriangles(9000, 20000, 4);
    std::atomic<int> polls{0};
    findEdges(list, 20000, [&] { ++polls; });
    QVERIFY(polls >= 8);
    RunContext context;
    context.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, findEdges(list, 20000, context));
  }

  void setsAreNumberedByTheirSmallestElements() {
    DisjointSets sets(6);
    QVERIFY(sets.unite(5, 1));
    QVERIFY(sets.unite(3, 5));
    QVERIFY(!sets.unite(1, 3));
    QVERIFY(!sets.unite(2, 2));
    QCOMPARE(sets.find(5), 1);
    Index count = 0;
    QVERIFY((sets.numbers(count) == std::vector<Index>{0, 1, 2, 1, 3, 1}));
    QCOMPARE(count, 4);
  }

  // Two triangles side by side; a third one on the same edge, or the second one turned over, closes it.
  void aSurfaceIsCrossedWhereTwoOppositeSidesMeet() {
    NavigationMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 2, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    SurfaceTopology topology = makeSurfaceTopology(mesh);
    QCOMPARE(topology.componentCount, 1U);
    QCOMPARE(topology.neighbours[0][2], 1U);
    QCOMPARE(topology.neighbours[1][0], 0U);
    QCOMPARE(topology.fanVertices.size(), std::size_t{4});
    mesh.triangles.push_back({0, 2, 4});
    QCOMPARE(makeSurfaceTopology(mesh).componentCount, 3U);
    mesh.triangles[2] = {2, 0, 4};  // faces down: it takes no part
    topology = makeSurfaceTopology(mesh);
    QCOMPARE(topology.componentCount, 1U);
    QCOMPARE(topology.components[2], SurfaceTopology::kNone);
  }
};

QTEST_APPLESS_MAIN(TestAdjacency)
#include "test_adjacency.moc"
