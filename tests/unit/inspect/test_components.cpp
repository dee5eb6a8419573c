// Components of the walkable area: known levels, and a comparison with joining triangles edge by edge.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/io/import.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/errors.hpp"
#include "footfall/inspect.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

NavigationMesh walkable(const Soup& soup, const std::string& filters = "") {
  return navigationMesh(runFilters(soup.environment(), minimalPipeline(2) + filters));
}

double areaOf(const NavigationMesh& mesh, std::size_t t) {
  NavigationMesh one = mesh;
  one.triangles = {mesh.triangles[t]};
  return area(one);
}

/// True when every claim of `components` holds, with the parts found again by spreading marks over shared edges and
/// steps.
bool check(const NavigationMesh& mesh, const Components& components) {
  std::map<std::array<std::uint32_t, 2>, std::vector<std::size_t>> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      edges[{std::min(a, b), std::max(a, b)}].push_back(t);
    }
  for (const StepLink& link : mesh.links) edges[{link.from[0], ~link.to[0]}] = {link.fromTriangle, link.toTriangle};
  std::vector<std::size_t> part(mesh.triangles.size());
  std::iota(part.begin(), part.end(), std::size_t{0});
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [edge, triangles] : edges)
      for (const std::size_t t : triangles)
        for (const std::size_t other : triangles)
          if (part[other] < part[t]) part[t] = part[other], changed = true;
  }
  std::map<std::size_t, std::vector<std::size_t>> parts;
  for (std::size_t t = 0; t < part.size(); ++t) parts[part[t]].push_back(t);
  if (parts.size() != components.list.size() || components.ofTriangle.size() != part.size()) return false;
  if (mesh.links.empty() && countParts(mesh) != parts.size()) return false;
  for (std::size_t i = 0; i + 1 < components.list.size(); ++i)
    if (components.list[i].area < components.list[i + 1].area) return false;
  for (const auto& [first, triangles] : parts) {
    const Component& component = components.list[components.ofTriangle[first]];
    if (component.firstTriangle != first || component.triangles != triangles.size()) return false;
    std::vector<std::uint32_t> layers;
    double sum = 0;
    for (const std::size_t t : triangles) {
      if (components.ofTriangle[t] != components.ofTriangle[first]) return false;
      sum += areaOf(mesh, t);
      if (!mesh.layers.empty()) layers.push_back(mesh.layers[t]);
      for (const auto v : mesh.triangles[t]) {
        const Vec3& p = mesh.vertices[v];
        if (p.x < component.lower.x || p.x > component.upper.x || p.z < component.lower.z || p.z > component.upper.z)
          return false;
      }
    }
    std::sort(layers.begin(), layers.end());
    layers.erase(std::unique(layers.begin(), layers.end()), layers.end());
    if (layers != component.layers || std::fabs(sum - component.area) > 1e-9 * sum) return false;
  }
  return std::fabs(components.totalArea() - area(mesh)) <= 1e-9 * area(mesh);
}

}  // namespace

class TestComponents : public QObject {
  Q_OBJECT
 private slots:
  void nothing() {
    const Components none = findComponents({});
    QVERIFY(none.list.empty() && none.ofTriangle.empty());
    QCOMPARE(none.totalArea(), 0.0);
    QCOMPARE(none.connectedShare(), 0.0);
  }

  void largestFirst() {
    const NavigationMesh mesh = walkable(Soup().floor(0, 0, 1, 1, 0).floor(5, 0, 9, 2, 1).floor(20, 0, 22, 1, 7));
    const Components components = findComponents(mesh);
    QCOMPARE(components.list.size(), std::size_t{3});
    QCOMPARE(components.list[0].area, 8.0);
    QCOMPARE(components.list[1].area, 2.0);
    QCOMPARE(components.list[2].area, 1.0);
    QCOMPARE(components.totalArea(), 11.0);
    QVERIFY((components.list[0].lower == Vec3{5, 0, 1} && components.list[0].upper == Vec3{9, 2, 1}));
    QVERIFY((components.list[1].centre == Vec3{21, 0.5, 7}));
    QVERIFY(components.list[0].layers.empty());
    QVERIFY(check(mesh, components));
  }

  // A thin wall across the floor parts it; a corner in common joins nothing.
  void obstacleEdgesPart() {
    const NavigationMesh parted = walkable(Soup().floor(0, 0, 4, 2, 0).wall(2, 0, 2, 2, 0, 3));
    QCOMPARE(findComponents(parted).list.size(), std::size_t{2});
    const NavigationMesh doorway = walkable(Soup().floor(0, 0, 4, 2, 0).wall(2, 0, 2, 1, 0, 3));
    QCOMPARE(findComponents(doorway).list.size(), std::size_t{1});
    const NavigationMesh corner = walkable(Soup().floor(0, 0, 1, 1, 0).floor(1, 1, 2, 2, 0));
    QCOMPARE(findComponents(corner).list.size(), std::size_t{2});
  }

  void connectionsJoin() {
    // Up a ramp and over the floor that one came from: two layers, one component.
    const NavigationMesh mesh = walkable(Soup()
                                             .floor(0, 0, 8, 1, 0)
                                             .ramp(8, 0, 12, 1, 0, 4)
                                             .floor(12, 0, 13, 2, 4)
                                             .floor(0, 1, 12, 2, 4)
                                             .floor(0, 0, 1, 1, 4),
                                         "LayerSubdivisionFilter");
    QVERIFY(mesh.layerCount == 2 && !mesh.connections.empty());
    const Components components = findComponents(mesh);
    QCOMPARE(components.list.size(), std::size_t{1});
    QVERIFY((components.list[0].layers == std::vector<std::uint32_t>{0, 1}));
    QVERIFY(check(mesh, components));
  }

  // Areas that no double holds: infinite, and no NaN in the reports about them.
  void beyondAllDoubles() {
    NavigationMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}, {2e300, 2e300, 0}, {3e300, 2e300, 0}, {2e300, 3e300, 0}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    const Components components = findComponents(mesh);
    QCOMPARE(components.list.size(), std::size_t{2});
    for (const Component& component : components.list) {
      QVERIFY(std::isinf(component.area));
      QVERIFY(std::isfinite(component.centre.x) && std::isfinite(component.centre.y));
    }
    QCOMPARE(components.connectedShare(), 0.5);
  }

  // Three treads and, apart from them, a table: without steps four parts, with them two.
  void stepsJoin() {
    Soup soup;
    for (int i = 0; i < 3; ++i) soup.floor(i, 0, i + 1, 2, 0.25 * i);
    soup.floor(9, 0, 10, 2, 0);
    const Components apart = findComponents(walkable(soup));
    QCOMPARE(apart.list.size(), std::size_t{4});
    QCOMPARE(apart.connectedShare(), 4 * 0.25 * 0.25);
    const NavigationMesh mesh = walkable(soup, "StepFilter 0.25\nLayerSubdivisionFilter");
    QCOMPARE(mesh.links.size(), std::size_t{2});
    const Components joined = findComponents(mesh);
    QCOMPARE(joined.list.size(), std::size_t{2});
    QCOMPARE(joined.list[0].area, 6.0);
    QCOMPARE(joined.list[0].upper.z, 0.5);
    QCOMPARE(joined.connectedShare(), 0.75 * 0.75 + 0.25 * 0.25);
    QVERIFY(check(mesh, joined));
    // A step that is too high joins nothing.
    QCOMPARE(findComponents(walkable(soup, "StepFilter 0.125")).list.size(), std::size_t{4});
  }

  void randomBuildings() {
    QVERIFY(test::check("components of buildings", 60, [] {
      const Soup soup = buildingOf(*buildingParts(12));
      const bool hasSteps = *rc::gen::arbitrary<bool>();
      const NavigationMesh mesh =
          walkable(soup, hasSteps ? "StepFilter 1\nLayerSubdivisionFilter" : "LayerSubdivisionFilter");
      RC_TAG(mesh.links.empty() ? "no steps" : "steps");
      RC_ASSERT(::check(mesh, findComponents(mesh)));
    }));
  }

  void realEnvironment() {
    if (sharedEnvironments().isEmpty()) QSKIP("the real environments are not here");
    const auto environment = importEnvironment((sharedEnvironments() + "/nav_test.obj").toStdString());
    RunContext context;
    const RunResult result = runPipeline(environment, defaultPipeline(*environment), context);
    const Components components = findComponents(*result.mesh);
    QVERIFY(::check(*result.mesh, components));
    runWithThreads(1, [&] {
      const Components again = findComponents(*result.mesh);
      QVERIFY(again.ofTriangle == components.ofTriangle);
      for (std::size_t i = 0; i < again.list.size(); ++i) QCOMPARE(again.list[i].area, components.list[i].area);
    });
  }

  void cancels() {
    const NavigationMesh mesh = walkable(Soup().floor(0, 0, 1, 1, 0));
    RunContext cancelled;
    cancelled.cancel();
    QVERIFY_EXCEPTION_THROWN(findComponents(mesh, &cancelled), Cancelled);
  }
};

QTEST_APPLESS_MAIN(TestComponents)
#include "test_components.moc"
