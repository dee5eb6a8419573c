// Regions above themselves, by their outlines alone, and pieces of them without a list of overlapping pairs: the
// answers of the plain way, and how much work they take.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <set>

#include "core/assembly/walkable_state.hpp"
#include "core/filters/layers/double_cover.hpp"
#include "core/filters/layers/layer_pieces.hpp"
#include "core/mesh/mesh_geometry.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using Pair = std::array<Index, 2>;
constexpr double kTurn = 6.283185307179586;

StatePtr walkable(const Soup& soup) { return runFilters(soup.environment(), minimalPipeline(0.0625)); }

/// All pairs that overlap, by the definition: no edge of either triangle has the other one on its outer side.
std::vector<Pair> plainOverlaps(const WalkableState& state) {
  MeshGeometry geometry(*state.kernel, state.mesh->vertices);
  const auto& triangles = state.mesh->triangles;
  const auto separates = [&](std::size_t m, std::size_t n) {
    const auto &own = triangles[m].corners, &others = triangles[n].corners;
    for (std::size_t k = 0; k < 3; ++k)
      if (std::all_of(others.begin(), others.end(),
                      [&](Index c) { return geometry.orientation(own[k], own[(k + 1) % 3], c) <= 0; }))
        return true;
    return false;
  };
  std::vector<Pair> pairs;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t s = 0; s < t; ++s)
      if (!separates(s, t) && !separates(t, s)) pairs.push_back({static_cast<Index>(s), static_cast<Index>(t)});
  return pairs;
}

std::vector<char> doubleCovers(const WalkableState& state, const std::vector<Index>& setOf, Index setCount,
                               std::size_t* decisions = nullptr) {
  RunContext context;
  ExactFallbacks fallbacks;
  const WalkableMesh& mesh = *state.mesh;
  const Adjacency topology = findEdges(mesh.triangles, mesh.vertices.size());
  return findDoubleCovers(setOf, setCount, findTrianglesAcross(mesh, topology, context), *state.kernel, mesh, context,
                          fallbacks, decisions);
}

bool coversTwice(const WalkableState& state) {
  return doubleCovers(state, std::vector<Index>(state.mesh->triangles.size(), 0), 1)[0] != 0;
}

/// Quads from one ray to the next around the origin, eight a turn, each `rise` higher at its end.
Soup ring(int quads, double rise) {
  constexpr std::array<std::array<double, 2>, 8> kRays{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  Soup soup;
  for (int i = 0; i < quads; ++i) {
    const auto at = [&](int ray, double radius) {
      const auto& [x, y] = kRays[static_cast<std::size_t>(ray % 8)];
      return Vec3{radius * x, radius * y, rise * ray};
    };
    soup.quad(at(i, 10), at(i, 20), at(i + 1, 20), at(i + 1, 10));
  }
  return soup;
}

/// A star of so many needles around a polygon, turned by an angle.
Soup star(int spikes, double z, double turned) {
  const auto at = [&](double step, double radius) {
    const double angle = turned + kTurn * step / spikes;
    return Vec3{radius * std::cos(angle), radius * std::sin(angle), z};
  };
  Soup soup;
  for (int i = 0; i < spikes; ++i) {
    const int next = (i + 1) % spikes;
    soup.triangle(at(i, 10), at(i + 0.5, 50), at(next, 10));
    if (i > 0 && next > 0) soup.triangle(at(0, 10), at(i, 10), at(next, 10));
  }
  return soup;
}

/// A disc of so many triangles around its middle.
Soup disc(int corners, double z) {
  const auto at = [&](int step) {
    const double angle = kTurn * (step % corners) / corners;
    return Vec3{50 * std::cos(angle), 50 * std::sin(angle), z};
  };
  Soup soup;
  for (int i = 0; i < corners; ++i) soup.triangle({0, 0, z}, at(i), at(i + 1));
  return soup;
}

std::vector<Index> numbersUpTo(std::size_t count) {
  std::vector<Index> numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(static_cast<Index>(i));
  return numbers;
}

/// All that subdivideRegion() is given, as if all triangles were one region.
LayerInput inputOf(const WalkableState& state, const std::vector<Pair>& overlaps) {
  const WalkableMesh& mesh = *state.mesh;
  const std::size_t count = mesh.triangles.size();
  const auto listsOf = [&](const std::vector<Pair>& pairs) {
    std::vector<std::vector<Index>> all(count);
    for (const auto& [s, t] : pairs) {
      all[static_cast<std::size_t>(s)].push_back(t);
      all[static_cast<std::size_t>(t)].push_back(s);
    }
    IndexLists lists;
    for (const auto& own : all) {
      lists.first.push_back(static_cast<Index>(lists.items.size()));
      lists.items.insert(lists.items.end(), own.begin(), own.end());
    }
    lists.first.push_back(static_cast<Index>(lists.items.size()));
    return lists;
  };
  std::vector<Pair> neighbors;
  const Adjacency topology = findEdges(mesh.triangles, mesh.vertices.size());
  for (Index e = 0; e < topology.edgeCount(); ++e) {
    const auto sides = topology.sidesOf(e);
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) neighbors.push_back({sides[i] / 3, sides[j] / 3});
  }
  std::vector<std::pair<double, Index>> heights;
  for (std::size_t t = 0; t < count; ++t) {
    const auto& c = mesh.triangles[t].corners;
    const auto z = [&](std::size_t k) { return mesh.vertices[static_cast<std::size_t>(c[k])].z; };
    heights.emplace_back(std::min({z(0), z(1), z(2)}), static_cast<Index>(t));
  }
  std::sort(heights.begin(), heights.end());
  LayerInput input;
  input.rank.resize(count);
  for (const auto& [height, t] : heights) {
    input.rank[static_cast<std::size_t>(t)] = static_cast<Index>(input.byHeight.size());
    input.byHeight.push_back(t);
  }
  input.number = numbersUpTo(count);
  input.neighbors = listsOf(neighbors);
  input.overlaps = listsOf(overlaps);
  return input;
}

struct Pieces {
  std::vector<Index> seeds, piece;
  bool operator==(const Pieces&) const = default;
};

Pieces listedPieces(LayerInput input) {
  RunContext context;
  SearchCounts counts;
  input.knowsAll = true;
  const std::vector<Index> all = numbersUpTo(input.byHeight.size());
  Pieces pieces{{}, std::vector<Index>(all.size())};
  pieces.seeds = subdivideRegion(input, all, all, pieces.piece, context, counts);
  return pieces;
}

Pieces searchedPieces(LayerInput input, const WalkableState& state, SearchCounts& counts) {
  RunContext context;
  const PlanTriangles plan(*state.mesh, context);
  input.kernel = state.kernel.get();
  input.vertices = &state.mesh->vertices;
  input.plan = &plan;
  const std::vector<Index> all = numbersUpTo(input.byHeight.size());
  Pieces pieces{{}, std::vector<Index>(all.size())};
  pieces.seeds = subdivideRegion(input, all, all, pieces.piece, context, counts);
  return pieces;
}

}  // namespace

class TestDoubleCover : public QObject {
  Q_OBJECT

 private slots:
  void rings_data() {
    QTest::addColumn<int>("quads");
    QTest::addColumn<double>("rise");
    QTest::addColumn<bool>("expected");
    QTest::newRow("half a turn") << 4 << 0.125 << false;
    QTest::newRow("closed, with a hole") << 8 << 0.0 << false;
    QTest::newRow("its ends touch along an edge, one above the other") << 8 << 0.125 << false;
    QTest::newRow("an eighth above itself") << 9 << 0.125 << true;
    QTest::newRow("two turns") << 16 << 0.125 << true;
    QTest::newRow("five turns") << 40 << 0.125 << true;
  }
  void rings() {
    QFETCH(int, quads);
    QFETCH(double, rise);
    QFETCH(bool, expected);
    QCOMPARE(coversTwice(*walkable(ring(quads, rise))), expected);
  }

  void regionsThatTouchThemselves_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<bool>("expected");
    QTest::newRow("apart") << 21.0 << 0.0 << false;
    QTest::newRow("along a piece of an edge") << 20.0 << 3.0 << false;
    QTest::newRow("along a whole edge") << 20.0 << 0.0 << false;
    QTest::newRow("a corner on a corner") << 20.0 << 20.0 << false;
    QTest::newRow("in the hole, along an edge") << -10.0 << -5.0 << false;
    QTest::newRow("in the hole, apart") << -5.0 << -5.0 << false;
    QTest::newRow("a thousandth over an edge") << 19.999 << 3.0 << true;
    QTest::newRow("around a corner") << 15.0 << 15.0 << true;
    QTest::newRow("within") << 11.0 << 11.0 << true;
  }
  // A floor five metres above a ring of width ten, and the ring, are one set.
  void regionsThatTouchThemselves() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(bool, expected);
    Soup soup = ring(8, 0);
    soup.floor(x, y, x + (x == 11.0 ? 5 : 10), y + (x == 11.0 ? 5 : 10), 5);
    QCOMPARE(coversTwice(*walkable(soup)), expected);
  }

  void aPointTouchesAnEdgeFromBelow() {
    Soup soup;
    soup.floor(0, 0, 10, 10, 0).triangle({3, 10, 1}, {6, 12, 1}, {2, 14, 1});  // a corner within an edge
    QVERIFY(!coversTwice(*walkable(soup)));
    soup.triangle({3, 9.999, 2}, {3.5, 12, 2}, {2.5, 12, 2});
    QVERIFY(coversTwice(*walkable(soup)));
  }

  // Any sets of triangles of random meshes, most of which touch themselves, have holes or lie above themselves.
  void randomSets() {
    std::array<int, 2> seen{};
    QVERIFY(check("sets that cover a place twice", 400, [&seen] {
      const int size = *rc::gen::inRange(2, 40);
      const StatePtr state = runFilters(soupOf(*gridTriangles(size, 5, 3)).environment(true), minimalPipeline(1));
      const std::size_t count = state->mesh->triangles.size();
      const auto sets = static_cast<Index>(*rc::gen::inRange(1, 8));
      std::vector<Index> setOf = *rc::gen::container<std::vector<Index>>(count, rc::gen::inRange<Index>(-1, sets));
      if (*rc::gen::arbitrary<bool>()) {
        Index regions = 0;
        setOf = findRegions(*state->mesh, findEdges(state->mesh->triangles, state->mesh->vertices.size()), regions);
        for (Index& set : setOf) set %= sets;
      }
      std::vector<char> expected(static_cast<std::size_t>(sets), 0);
      for (const auto& [s, t] : plainOverlaps(*state)) {
        const Index set = setOf[static_cast<std::size_t>(s)];
        if (set >= 0 && set == setOf[static_cast<std::size_t>(t)]) expected[static_cast<std::size_t>(set)] = 1;
      }
      for (const char covers : expected) ++seen[static_cast<std::size_t>(covers)];
      RC_ASSERT(doubleCovers(*state, setOf, sets) == expected);
    }));
    QVERIFY2(seen[0] > 100 && seen[1] > 100, qPrintable(QString("%1 and %2").arg(seen[0]).arg(seen[1])));
  }

  void randomPieces() {
    int divided = 0;
    QVERIFY(check("pieces without a list of pairs", 300, [&divided] {
      const StatePtr state =
          runFilters(soupOf(*gridTriangles(*rc::gen::inRange(2, 40), 5, 3)).environment(true), minimalPipeline(1));
      const Pieces expected = listedPieces(inputOf(*state, plainOverlaps(*state)));
      divided += expected.seeds.size() > 1 ? 1 : 0;
      SearchCounts counts;
      RC_ASSERT(searchedPieces(inputOf(*state, {}), *state, counts) == expected);
    }));
    QVERIFY2(divided > 50, qPrintable(QString::number(divided)));
  }

  void whatIsKnownChangesNoPieces() {
    int divided = 0;
    QVERIFY(check("pieces with some pairs and groups known", 500, [&divided] {
      const StatePtr state =
          runFilters(soupOf(*gridTriangles(*rc::gen::inRange(2, 40), 5, 3)).environment(true), minimalPipeline(1));
      const std::vector<Pair> pairs = plainOverlaps(*state);
      std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
      std::vector<Index> group(state->mesh->triangles.size());
      for (std::size_t t = 0; t < group.size(); ++t) {
        std::set<Index> taken;
        for (const auto& [a, b] : pairs)
          if (static_cast<std::size_t>(std::max(a, b)) == t)
            taken.insert(group[static_cast<std::size_t>(std::min(a, b))]);
        while (taken.contains(group[t])) ++group[t];
      }
      for (Index& own : group) {
        const auto choice = random() % 8;
        if (choice < 2) own = choice == 0 ? -1 : kSettled;
      }
      std::vector<Pair> known;
      for (const auto& [a, b] : pairs) {
        const bool isSettled =
            group[static_cast<std::size_t>(a)] == kSettled || group[static_cast<std::size_t>(b)] == kSettled;
        if (isSettled || random() % 3 == 0) known.push_back({a, b});
      }
      LayerInput input = inputOf(*state, known);
      input.group = group;
      const Pieces expected = listedPieces(inputOf(*state, pairs));
      divided += expected.seeds.size() > 1 ? 1 : 0;
      SearchCounts counts;
      RC_ASSERT(searchedPieces(input, *state, counts) == expected);
    }));
    QVERIFY2(divided > 50, qPrintable(QString::number(divided)));
  }

  void starsAreDecidedByTheirOutlines() {
    for (const int spikes : {1000, 4000}) {
      const StatePtr state = walkable(star(spikes, 0, 0));
      std::size_t decisions = 0;
      QVERIFY(doubleCovers(*state, std::vector<Index>(state->mesh->triangles.size(), 0), 1, &decisions)[0] == 0);
      QVERIFY2(decisions < static_cast<std::size_t>(200 * spikes), qPrintable(QString::number(decisions)));
    }
  }

  // The boxes of the needles of a disc touch a quarter of each other's, on every storey.
  void discsAreDecidedByTheirOutlines() {
    for (const int corners : {1000, 4000}) {
      Soup soup;
      for (const double z : {0.0, 3.0, 6.0}) soup.add(disc(corners, z));
      const StatePtr state = walkable(soup);
      const WalkableMesh& mesh = *state->mesh;
      Index regions = 0;
      const std::vector<Index> regionOf = findRegions(mesh, findEdges(mesh.triangles, mesh.vertices.size()), regions);
      QCOMPARE(regions, 3);
      std::size_t decisions = 0;
      QCOMPARE(doubleCovers(*state, regionOf, regions, &decisions), std::vector<char>(3, 0));
      QVERIFY2(decisions < 200 * mesh.triangles.size(), qPrintable(QString::number(decisions)));
    }
  }

  // Each triangle of a spiral of n turns overlaps n others at least.
  void aSpiralIsNotTestedPairByPair() {
    for (const int turns : {50, 400}) {
      const StatePtr state = walkable(ring(8 * turns, 0.25));
      const std::size_t triangles = state->mesh->triangles.size();
      QCOMPARE(triangles, static_cast<std::size_t>(16 * turns));
      SearchCounts counts;
      const Pieces pieces = searchedPieces(inputOf(*state, {}), *state, counts);
      QCOMPARE(std::set<Index>(pieces.piece.begin(), pieces.piece.end()).size(), static_cast<std::size_t>(turns));
      QVERIFY2(counts.tested < 60 * triangles, qPrintable(QString::number(counts.tested)));
    }
  }
};

QTEST_GUILESS_MAIN(TestDoubleCover)
#include "test_double_cover.moc"
