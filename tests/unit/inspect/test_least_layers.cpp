// The lower bounds of the numbers of layers and connections: on meshes made by hand, and against a count over all
// triangles. SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <array>
#include <vector>

#include "core/exact/source_predicates.hpp"
#include "footfall/inspect.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

/// Squares of side 2 whose lower corners are given; each is a layer of its own.
NavigationMesh squares(const std::vector<std::array<double, 2>>& corners) {
  NavigationMesh mesh;
  for (const auto& [x, y] : corners) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto z = static_cast<double>(mesh.layerCount);
    mesh.vertices.insert(mesh.vertices.end(), {{x, y, z}, {x + 2, y, z}, {x + 2, y + 2, z}, {x, y + 2, z}});
    mesh.triangles.insert(mesh.triangles.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
    mesh.layers.insert(mesh.layers.end(), 2, mesh.layerCount++);
  }
  return mesh;
}

/// The most triangles over one of the middles of all triangles, by looking at every triangle.
std::uint32_t mostOverMiddles(const NavigationMesh& mesh) {
  std::uint32_t most = 0;
  for (const Triangle& corners : mesh.triangles) {
    Vec3 middle{};
    for (const std::uint32_t v : corners) {
      middle.x += mesh.vertices[v].x / 3;
      middle.y += mesh.vertices[v].y / 3;
    }
    std::uint32_t floors = 0;
    for (const Triangle& other : mesh.triangles) {
      bool holds = true;
      for (const std::size_t i : {0, 1, 2})
        holds = holds && facing(mesh.vertices[other[i]], mesh.vertices[other[(i + 1) % 3]], middle) > 0;
      floors += holds ? 1 : 0;
    }
    most = std::max(most, floors);
  }
  return most;
}

}  // namespace

class TestLeastLayers : public QObject {
  Q_OBJECT
 private slots:
  void countsFloorsOverOnePlace() {
    QCOMPARE(leastLayers(NavigationMesh{}), 0U);
    QCOMPARE(leastLayers(squares({{0, 0}})), 1U);
    QCOMPARE(leastLayers(squares({{0, 0}, {0, 0}, {0, 0}})), 3U);
    // Side by side, they touch and do not overlap; in a row, only two of them overlap at a place.
    QCOMPARE(leastLayers(squares({{0, 0}, {2, 0}, {4, 0}})), 1U);
    QCOMPARE(leastLayers(squares({{0, 0}, {1, 0}, {2, 0}})), 2U);
  }

  // Only the corner at the rim of the second square lies over the first one.
  void findsThinOverlaps() { QCOMPARE(leastLayers(squares({{0, 0}, {1.99, 1.99}})), 2U); }

  // A ramp that turns around itself, so that each turn lies above the one before; and a second one beside it.
  void countsCutsOfParts() {
    const auto connectionsOf = [](int quads, int count) {
      Soup soup;
      for (int ramp = 0; ramp < count; ++ramp) {
        constexpr std::array<std::array<double, 2>, 4> kRays{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
        const auto at = [&](int ray, double radius) {
          const auto& [x, y] = kRays[static_cast<std::size_t>(ray % 4)];
          return Vec3{100.0 * ramp + radius * x, radius * y, 1.0 * ray};
        };
        for (int i = 0; i < quads; ++i) soup.quad(at(i, 10), at(i, 20), at(i + 1, 20), at(i + 1, 10));
      }
      return navigationMesh(runFilters(soup.environment(), minimalPipeline(1, 60) + "\nLayerSubdivisionFilter"));
    };
    QCOMPARE(leastConnections(NavigationMesh{}), std::size_t{0});
    QCOMPARE(leastConnections(squares({{0, 0}, {0, 0}})), std::size_t{0});
    QCOMPARE(leastConnections(connectionsOf(3, 1)), std::size_t{0});
    QCOMPARE(leastConnections(connectionsOf(8, 1)), std::size_t{1});
    QCOMPARE(leastConnections(connectionsOf(12, 1)), std::size_t{2});
    QCOMPARE(leastConnections(connectionsOf(12, 2)), std::size_t{4});
    QCOMPARE(connectionsOf(12, 2).connections.size(), std::size_t{4});
  }

  void isABoundOfResults() {
    QVERIFY(check("at most the number of layers, at least a count over all triangles", 40, [] {
      const Soup soup = buildingOf(*buildingParts(12));
      const NavigationMesh mesh =
          navigationMesh(runFilters(soup.environment(), minimalPipeline(1, 60) + "\nLayerSubdivisionFilter"));
      const std::uint32_t least = leastLayers(mesh);
      RC_ASSERT(least <= mesh.layerCount);
      RC_ASSERT(leastConnections(mesh) <= mesh.connections.size());
      if (mesh.layerCount > 1) RC_ASSERT(least >= std::min(mesh.layerCount, mostOverMiddles(mesh)));
    }));
  }
};

QTEST_GUILESS_MAIN(TestLeastLayers)
#include "test_least_layers.moc"
