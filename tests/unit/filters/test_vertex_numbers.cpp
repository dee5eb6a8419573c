// Simplification and layers do not depend on the numbers of vertices: a part of a mesh has the same result alone and in
// the whole, and an AreaFilter leaves no trace of removed parts.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QTest>
#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <tuple>

#include "core/assembly/walkable_state.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/filters/layers/known_overlaps.hpp"
#include "core/filters/simplification/simplifier.hpp"
#include "core/io/import.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

/// The mesh with its vertices in another order.
WalkableMesh shuffled(const WalkableMesh& mesh, std::uint64_t seed) {
  std::vector<std::pair<std::uint64_t, Index>> order;
  for (Index v = 0; v < static_cast<Index>(mesh.vertices.size()); ++v) {
    seed = seed * 6364136223846793005U + 1442695040888963407U;
    order.emplace_back(seed >> 20, v);
  }
  std::sort(order.begin(), order.end());
  WalkableMesh result = mesh;
  std::vector<Index> numbers(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    numbers[static_cast<std::size_t>(order[i].second)] = static_cast<Index>(i);
    result.vertices[i] = mesh.vertices[static_cast<std::size_t>(order[i].second)];
  }
  for (MeshTriangle& triangle : result.triangles)
    for (Index& v : triangle.corners) v = numbers[static_cast<std::size_t>(v)];
  return result;
}

using Corners = std::array<std::tuple<double, double, double>, 3>;

std::vector<Corners> simplified(const PlanKernel& kernel, const WalkableMesh& mesh) {
  RunContext context;
  const Adjacency topology = findEdges(mesh.triangles, mesh.vertices.size());
  const WalkableMesh result = Simplifier(kernel, mesh, topology, {}, context).run();
  std::vector<Corners> triangles;
  for (const MeshTriangle& triangle : result.triangles) {
    Corners& corners = triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const MeshVertex& v = result.vertices[static_cast<std::size_t>(triangle.corners[k])];
      corners[k] = {v.x, v.y, v.z};
    }
  }
  return triangles;
}

std::vector<std::uint32_t> layersOfMesh(const StatePtr& state, const WalkableMesh& mesh) {
  RunContext context;
  auto other = std::make_shared<WalkableState>(*state);
  other->mesh = std::make_shared<WalkableMesh>(mesh);
  return applyLayerSubdivision(other, {}, context).state->mesh->layers;
}

}  // namespace

class TestVertexNumbers : public QObject {
  Q_OBJECT

 private slots:
  void simplification() {
    QVERIFY(check("vertices in any order, simplified", 100, [] {
      const Soup soup = buildingOf(*buildingParts(12));
      if (soup.environment()->triangles.empty()) return;
      const StatePtr state = runFilters(soup.environment(), minimalPipeline(1));
      const WalkableMesh other = shuffled(*state->mesh, *rc::gen::arbitrary<std::uint64_t>());
      RC_ASSERT(simplified(*state->kernel, other) == simplified(*state->kernel, *state->mesh));
    }));
  }

  // Triangles over few vertices, some above others: no geometry is needed.
  void layers() {
    QVERIFY(check("vertices in any order, in layers", 2000, [] {
      WalkableMesh mesh;
      mesh.vertices.resize(8);
      for (MeshVertex& v : mesh.vertices) v.z = *below(4);
      for (const auto& corners : *upTo(40, numbersBelow<3>(8)))
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
          mesh.triangles.push_back({{corners[0], corners[1], corners[2]}, 0, 0});
      const auto count = static_cast<int>(mesh.triangles.size());
      if (count < 2) return;
      std::set<std::array<Index, 2>> pairs;
      for (const auto& [s, t] : *upTo(30, numbersBelow<2>(count)))
        if (s != t) pairs.insert({std::min(s, t), std::max(s, t)});
      const WalkableMesh other = shuffled(mesh, *rc::gen::arbitrary<std::uint64_t>());
      const auto layers = [&pairs](const WalkableMesh& of) {
        RunContext context;
        return layersOf(of, findEdges(of.triangles, of.vertices.size()), {pairs.begin(), pairs.end()}, context);
      };
      RC_ASSERT(layers(other) == layers(mesh));
    }));
  }

  void samples_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"house", "villa", "arena", "tower"}) QTest::newRow(name) << name;
  }

  void samples() {
    QFETCH(QString, name);
    const auto environment =
        importEnvironment(QString(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj").arg(name).toStdString());
    const StatePtr state = runFilters(environment, minimalPipeline(2));
    for (const std::uint64_t seed : {1, 2, 3}) {
      const WalkableMesh other = shuffled(*state->mesh, seed);
      QVERIFY(simplified(*state->kernel, other) == simplified(*state->kernel, *state->mesh));
      QVERIFY(layersOfMesh(state, other) == layersOfMesh(state, *state->mesh));
    }
  }
};

QTEST_APPLESS_MAIN(TestVertexNumbers)
#include "test_vertex_numbers.moc"
