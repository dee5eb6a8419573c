// Layers from outlines: the same as from a list of all overlapping pairs; the order of places and the tree of members
// that they use, against comparing all.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/filters/layers/growing_boxes.hpp"
#include "core/filters/layers/known_overlaps.hpp"
#include "core/filters/layers/member_tree.hpp"
#include "core/filters/layers/plan_order.hpp"
#include "core/mesh/mesh_geometry.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

std::vector<std::uint32_t> layersOf(const StatePtr& state) {
  RunContext context;
  return applyLayerSubdivision(state, {}, context).state->mesh->layers;
}

std::vector<std::uint32_t> layersByPairs(const StatePtr& state) {
  RunContext context;
  const WalkableMesh& mesh = *state->mesh;
  MeshGeometry geometry(*state->kernel, mesh.vertices);
  std::vector<std::array<Index, 2>> pairs;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t s = 0; s < t; ++s)
      if (geometry.overlap(planTriangleOf(mesh.vertices, mesh.triangles[s]),
                           planTriangleOf(mesh.vertices, mesh.triangles[t])))
        pairs.push_back({static_cast<Index>(s), static_cast<Index>(t)});
  return detail::layersOf(mesh, findEdges(mesh.triangles, mesh.vertices.size()), std::move(pairs), context);
}

/// Storeys with pillars, on each a stair of treads that lead to the next one.
Soup tower(int storeys, double turned) {
  constexpr double kStorey = 3, kTread = 0.25;
  Soup soup;
  for (int k = 0; k < storeys; ++k) {
    const double z = kStorey * k;
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j)
        if (k == 0 || i != 1 || j < 1 || j > 3) soup.floor(2.0 * i, 2.0 * j, 2.0 * i + 2, 2.0 * j + 2, z);
    for (int step = 0; step < 12; ++step)
      soup.floor(2.5, 2 + 0.5 * step, 3.5, 2.5 + 0.5 * step, z + kTread * (step + 1));
    soup.floor(6 + 0.125 * k, 1, 7, 2, z + 1);
  }
  return soup.mapped([turned](const Vec3& p) {
    return Vec3{std::cos(turned) * p.x - std::sin(turned) * p.y, std::sin(turned) * p.x + std::cos(turned) * p.y, p.z};
  });
}

}  // namespace

class TestLayersByOutlines : public QObject {
  Q_OBJECT

 private slots:
  void randomMeshesHaveTheLayersOfTheirPairs() {
    std::set<std::uint32_t> counts;
    QVERIFY(check("layers from outlines and from pairs", 300, [&counts] {
      const int size = *rc::gen::inRange(2, 60);
      const StatePtr state = runFilters(soupOf(*gridTriangles(size, 6, 4)).environment(true), minimalPipeline(0.5));
      const std::vector<std::uint32_t> expected = layersByPairs(state);
      RC_ASSERT(layersOf(state) == expected);
      if (!expected.empty()) counts.insert(*std::max_element(expected.begin(), expected.end()));
    }));
    QVERIFY(counts.size() > 3);
  }

  void buildingsHaveTheLayersOfTheirPairs() {
    QVERIFY(check("layers of buildings", 60, [] {
      const StatePtr state = runFilters(buildingOf(*buildingParts(30)).environment(),
                                        minimalPipeline(1, 60) + "\nStepFilter 0.4\nSimplificationFilter");
      RC_ASSERT(layersOf(state) == layersByPairs(state));
    }));
  }

  // The earlier run is believed: one that claims a single layer gets it.
  void aRunWithAnEarlierOneHasItsLayersAndOverlaps() {
    QVERIFY(check("layers from an earlier run", 60, [] {
      const StatePtr state = runFilters(buildingOf(*buildingParts(30)).environment(),
                                        minimalPipeline(1, 60) + "\nStepFilter 0.4\nSimplificationFilter");
      RunContext context;
      Recall recall;
      recall.keep = true;
      const StatePtr first = applyLayerSubdivision(state, recall, context).state;
      RC_ASSERT(first->overlaps != nullptr);
      recall.before = first;
      const StatePtr second = applyLayerSubdivision(state, recall, context).state;
      RC_ASSERT(second->mesh->layers == first->mesh->layers);
      RC_ASSERT(*second->overlaps == *first->overlaps);
      auto claimed = std::make_shared<WalkableState>(*first);
      auto mesh = std::make_shared<WalkableMesh>(*first->mesh);
      std::fill(mesh->layers.begin(), mesh->layers.end(), 0);
      claimed->mesh = mesh;
      claimed->overlaps = std::make_shared<const std::vector<std::array<Index, 2>>>();
      recall.before = claimed;
      const StatePtr third = applyLayerSubdivision(state, recall, context).state;
      RC_ASSERT(third->mesh->layers == mesh->layers);
    }));
  }

  // More layers than that up to which squares prove nothing.
  void towers_data() {
    QTest::addColumn<int>("storeys");
    QTest::addColumn<double>("turned");
    for (const int storeys : {3, 7, 8, 9, 20})
      for (const double turned : {0.0, 0.3})
        QTest::addRow("%d storeys, turned by %g", storeys, turned) << storeys << turned;
  }
  void towers() {
    QFETCH(int, storeys);
    QFETCH(double, turned);
    for (const char* steps : {"", "\nStepFilter 0.4 0.05"}) {
      const StatePtr state = runFilters(tower(storeys, turned).environment(), minimalPipeline(2) + steps);
      const std::vector<std::uint32_t> expected = layersByPairs(state);
      QVERIFY(!expected.empty());
      QVERIFY(*std::max_element(expected.begin(), expected.end()) + 1 >= static_cast<std::uint32_t>(storeys));
      QVERIFY(layersOf(state) == expected);
    }
  }

  // Cut floors on a grid have many vertices in one column; turned ones have none that are equal for sure.
  void placesAreInTheirExactOrder() {
    QVERIFY(check("the order of places", 200, [] {
      const StatePtr state = runFilters(soupOf(*gridTriangles(30, 5, 4)).environment(true), minimalPipeline(0.5));
      const WalkableMesh& mesh = *state->mesh;
      std::vector<Index> vertices;
      for (std::size_t v = 0; v < mesh.vertices.size(); ++v) vertices.push_back(static_cast<Index>(v));
      RunContext context;
      ExactFallbacks fallbacks;
      std::size_t decisions = 0;
      const PlanOrder order = findPlanOrder(vertices, *state->kernel, mesh, context, fallbacks, decisions);
      MeshGeometry geometry(*state->kernel, mesh.vertices);
      for (const Index a : vertices) {
        for (const Index b : vertices) {
          const int x = geometry.compare(a, b, 0), sign = x != 0 ? x : geometry.compare(a, b, 1);
          const Index p = order.placeOf[static_cast<std::size_t>(a)], q = order.placeOf[static_cast<std::size_t>(b)];
          RC_ASSERT((p > q) - (p < q) == sign);
        }
        const Index at = order.vertexAt[static_cast<std::size_t>(order.placeOf[static_cast<std::size_t>(a)])];
        RC_ASSERT(geometry.compare(a, at, 0) == 0 && geometry.compare(a, at, 1) == 0);
      }
    }));
  }

  void membersAreFoundAsByLookingAtAll() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(0, 1);
    const auto randomBox = [&] {
      MemberTree::Bounds box;
      for (std::size_t k = 0; k < 2; ++k) {
        box.lower[k] = 100 * share(random) - 50;
        box.upper[k] = box.lower[k] + 10 * share(random);
      }
      return box;
    };
    for (const std::size_t count : {1, 3, 4, 5, 16, 17, 300}) {
      std::vector<MemberTree::Bounds> boxes(count);
      for (auto& box : boxes) box = randomBox();
      MemberTree tree;
      tree.build(boxes, {});
      for (int round = 0; round < 3; ++round) {
        std::set<Index> members;
        for (std::size_t i = 0; i < count; ++i) {
          if (share(random) < 0.5) continue;
          members.insert(static_cast<Index>(i));
          tree.insert(static_cast<Index>(i));
        }
        for (int query = 0; query < 50; ++query) {
          const MemberTree::Bounds wanted = randomBox();
          std::set<Index> found;
          QVERIFY(!tree.visitUntil(wanted, [&](Index box) { return !found.insert(box).second; }));
          for (const Index box : found) QVERIFY(members.contains(box));
          for (const Index box : members)
            if (!areApart(boxes[static_cast<std::size_t>(box)], wanted)) QVERIFY(found.contains(box));
          if (!found.empty()) QVERIFY(tree.visitUntil(wanted, [](Index) { return true; }));
        }
        tree.clear();
        QVERIFY(!tree.visitUntil({{-1e9, -1e9}, {1e9, 1e9}}, [](Index) { return true; }));
      }
    }
  }
};

QTEST_GUILESS_MAIN(TestLayersByOutlines)
#include "test_layers_by_outlines.moc"
