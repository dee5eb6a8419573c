// The structures that filters find in a walkable mesh in a clever way, against the plain way.
// SPDX-License-Identifier: GPL-3.0-or-later
#undef emit  // Qt's, in the precompiled header; TBB has functions of that name
#include <gmpxx.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <QtTest>
#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "core/assembly/obstacle_split.hpp"
#include "core/base/box_tree.hpp"
#include "core/filters/rounding/rounded_mesh.hpp"
#include "core/mesh/mesh_geometry.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "tests/reference/exact_view.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

Adjacency topologyOf(const WalkableMesh& mesh) { return findEdges(mesh.triangles, mesh.vertices.size()); }

/// A hilly floor of n x n squares with random heights, `z` above the ground.
Soup hills(int n, double z, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<double> heights((n + 1) * (n + 1));
  for (double& h : heights) h = z + static_cast<double>(random() % 5) / 8;
  const auto at = [&](int x, int y) { return Vec3{double(x), double(y), heights[x * (n + 1) + y]}; };
  Soup soup;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y) soup.quad(at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
  return soup;
}

/// Tiles of one floor with boxes on them, so that there is much to simplify and to cut.
Soup tiles(int n) {
  Soup soup;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y) {
      soup.floor(x, y, x + 1, y + 1, x / 8 % 2 * 0.25);
      if ((x * 7 + y * 3) % 11 == 0) soup.box({x + 0.25, y + 0.5, 0}, {x + 1.25, y + 0.75, 1});
      if ((x * 5 + y) % 13 == 0) soup.floor(x, y, x + 2, y + 2, 3);
    }
  return soup;
}

bool sameProduct(const NavigationMesh& a, const NavigationMesh& b) {
  return a.vertices == b.vertices && a.triangles == b.triangles && a.layers == b.layers &&
         a.sourceTriangles == b.sourceTriangles && a.obstacleEdges == b.obstacleEdges && a.connections == b.connections;
}

using Pairs = std::set<std::array<Index, 2>>;

Pairs overlapsOnePair(const WalkableState& state) {
  MeshGeometry geometry(*state.kernel, state.mesh->vertices);
  Pairs result;
  const auto count = static_cast<Index>(state.mesh->triangles.size());
  for (Index t = 0; t < count; ++t)
    for (Index s = 0; s < t; ++s) {
      // Uses the definition with one orientation after the other instead of geometry.overlap().
      const auto separates = [&](Index m, Index n) {
        const auto &own = state.mesh->triangles[m].corners, &others = state.mesh->triangles[n].corners;
        for (int k = 0; k < 3; ++k)
          if (std::all_of(others.begin(), others.end(),
                          [&](Index c) { return geometry.orientation(own[k], own[(k + 1) % 3], c) <= 0; }))
            return true;
        return false;
      };
      if (!separates(s, t) && !separates(t, s)) result.insert({s, t});
    }
  return result;
}

Pairs overlapsFound(const WalkableState& state) {
  MeshGeometry geometry(*state.kernel, state.mesh->vertices);
  const auto planOf = [&state](Index t) { return planTriangleOf(state.mesh->vertices, state.mesh->triangles[t]); };
  Pairs result;
  for (Index t = 0; t < static_cast<Index>(state.mesh->triangles.size()); ++t)
    for (Index s = 0; s < t; ++s)
      if (geometry.overlap(planOf(s), planOf(t))) result.insert({s, t});
  return result;
}

std::multiset<std::array<std::array<std::string, 3>, 3>> placesOf(const StatePtr& state, double below) {
  std::multiset<std::array<std::array<std::string, 3>, 3>> result;
  for (const ExactTriangle& t : exactWalkableTriangles(*state))
    if (mpq_class(t.corners[0][0]) < below) result.insert(t.corners);
  return result;
}

}  // namespace

class TestMeshStructure : public QObject {
  Q_OBJECT

 private slots:
  void edgesAreThoseOfAMap() {
    QVERIFY(check("edges", 200, [] {
      const StatePtr state = runFilters(soupOf(*gridTriangles(30, 4, 3)).environment(true), minimalPipeline(1));
      std::map<std::array<Index, 2>, std::vector<Index>> expected;
      const auto& triangles = state->mesh->triangles;
      for (Index s = 0; s < static_cast<Index>(triangles.size()) * 3; ++s) {
        const Index a = triangles[s / 3].corners[s % 3], b = triangles[s / 3].corners[(s + 1) % 3];
        expected[{std::min(a, b), std::max(a, b)}].push_back(s);
      }
      const Adjacency topology = topologyOf(*state->mesh);
      RC_ASSERT(topology.edgeCount() == static_cast<Index>(expected.size()));
      Index e = 0;
      for (const auto& [vertices, sides] : expected) {
        const auto found = topology.sidesOf(e++);
        RC_ASSERT(std::equal(found.begin(), found.end(), sides.begin(), sides.end()));
      }
    }));
  }

  void boxesAreFound() {
    std::mt19937 random(5);
    using Bounds = BoxTree<3>::Bounds;
    for (const int count : {0, 1, 3, 4, 5, 17, 300}) {
      std::vector<Bounds> boxes;
      std::vector<Index> ids;
      for (Index i = 0; i < count; ++i) {
        Bounds b;
        for (int k = 0; k < 3; ++k) {
          b.lower[k] = 1e6 + random() % 20;
          b.upper[k] = b.lower[k] + random() % (i % 10 == 0 ? 20 : 3);
        }
        boxes.push_back(b);
        ids.push_back(i);
      }
      BoxTree<3> tree;
      tree.build(
          ids, [&](Index i) { return boxes[i]; }, [] {});
      QCOMPARE(tree.size(), count);
      for (Index first : {0, count / 2})
        for (const Bounds& query : boxes) {
          std::set<Index> expected, found;
          for (Index place = first; place < count; ++place) {
            const Bounds& b = boxes[tree.idAt(place)];
            bool overlap = true;
            for (int k = 0; k < 3; ++k)
              overlap = overlap && b.lower[k] <= query.upper[k] && query.lower[k] <= b.upper[k];
            if (overlap) expected.insert(tree.idAt(place));
          }
          tree.visitOverlapping(
              query, [&](Index i) { found.insert(i); }, first);
          QVERIFY(found == expected);  // small whole numbers: floats lose nothing
        }
    }
  }

  void overlapsOfRandomTriangles() {
    QVERIFY(check("overlaps", 150, [] {
      const StatePtr state = runFilters(soupOf(*gridTriangles(24, 5, 4)).environment(true), minimalPipeline(0.5, 80));
      RC_ASSERT(overlapsFound(*state) == overlapsOnePair(*state));
    }));
  }

  void overlapsOfTurnedBuildings() {
    QVERIFY(check("turned overlaps", 60, [] {
      const Soup soup = buildingOf(*buildingParts(8)).mapped([](const Vec3& p) {
        return Vec3{p.x * 0.8 - p.y * 0.6, p.x * 0.6 + p.y * 0.8, p.z};
      });
      const StatePtr state = runFilters(soup.environment(true), minimalPipeline(0.5));
      RC_ASSERT(overlapsFound(*state) == overlapsOnePair(*state));
    }));
  }

  void overlapsFarFromAnyBorder() {
    // Nearly all pairs are of triangles without borders.
    Soup soup = hills(9, 0, 1);
    soup.add(hills(9, 4, 2).mapped([](const Vec3& p) { return Vec3{p.x + 0.25, p.y + 0.5, p.z}; }));
    const StatePtr state = runFilters(soup.environment(), minimalPipeline(2, 60));
    const Pairs expected = overlapsOnePair(*state);
    QVERIFY(expected.size() > 500);
    QVERIFY(overlapsFound(*state) == expected);
  }

  void onlySuspectBordersClose() {
    int closed = 0;
    QVERIFY(check("closed slivers", 150, [&closed] {
      Soup soup = soupOf(*gridTriangles(12, 5, 4)).add(buildingOf(*buildingParts(4)));
      const StatePtr state = runFilters(soup.environment(true), minimalPipeline(1, 60));
      RunContext context;
      SplitMesh split = splitAtObstacleEdges(state->mesh->triangles, state->mesh->layers, state->mesh->vertices.size(),
                                             topologyOf(*state->mesh));
      std::vector<char> exact, sturdy;
      const auto places = roundVertices(*state->kernel, state->mesh->vertices, exact, context);
      RoundedMesh mesh;
      for (const SplitVertex& v : split.vertices) {
        RC_PRE(v.origin >= 0);
        mesh.vertices.push_back(places[v.origin]);
        sturdy.push_back(exact[v.origin]);
      }
      mesh.triangles = split.triangles;
      std::vector<char> suspects;
      for (const char s : sturdy) suspects.push_back(static_cast<char>(s == 0));
      for (const MeshTriangle& t : mesh.triangles)
        for (int k = 0; k < 3; ++k)
          if ((t.obstacleEdges >> k & 1) != 0) suspects[t.corners[k]] = suspects[t.corners[(k + 1) % 3]] = 1;
      Adjacency topology = findEdges(mesh.triangles, mesh.vertices.size());
      markBorders(mesh, topology);
      RC_PRE(!repairRounding(mesh, sturdy, context).anyBroken());
      settleBorders(mesh, topology);
      RoundedMesh all = mesh;
      RC_ASSERT(markClosedSlivers(mesh, topology, suspects, context) == markClosedSlivers(all, topology, {}, context));
      RC_ASSERT(mesh.vertices == all.vertices);
      RC_ASSERT(mesh.triangles.size() == all.triangles.size());
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        RC_ASSERT(mesh.triangles[t].obstacleEdges == all.triangles[t].obstacleEdges);
        closed += mesh.triangles[t].obstacleEdges != 0;
      }
    }));
    QVERIFY(closed > 100);
  }

  void anyNumberOfThreadsGivesTheSame() {
    const auto environment = tiles(48).add(hills(40, 6, 3)).environment();
    const std::string filters = minimalPipeline(2) + "\nAreaFilter 1\nSimplificationFilter\nLayerSubdivisionFilter";
    std::vector<NavigationMesh> products;
    for (const int threads : {1, 2, 7}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      tbb::task_arena arena(threads);
      arena.execute([&] { products.push_back(navigationMesh(runFilters(environment, filters))); });
    }
    QVERIFY(products[0].triangles.size() > 3000);
    QVERIFY(sameProduct(products[0], products[1]));
    QVERIFY(sameProduct(products[0], products[2]));
  }

  // The simplification of a region does not depend on far parts.
  void regionsAreSimplifiedEachOnTheirOwn() {
    const std::string filters = minimalPipeline(2) + "\nSimplificationFilter";
    const Soup here = tiles(20);
    Soup more = here;
    more.add(tiles(11).mapped([](const Vec3& p) { return Vec3{p.x + 1000, p.y, p.z}; }));
    const auto alone = placesOf(runFilters(here.environment(), filters), 500);
    QVERIFY(alone.size() > 100);
    QVERIFY(alone == placesOf(runFilters(more.environment(), filters), 500));
  }
};

QTEST_APPLESS_MAIN(TestMeshStructure)
#include "test_mesh_structure.moc"
