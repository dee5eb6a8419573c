// The effect line of each filter (thesis 3.2, docs/explanation/model.md), checked exactly on what comes out.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "tests/reference/layer_optimum.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::test;
using namespace footfall::reference;

namespace {

std::vector<Piece> piecesOf(const StatePtr& state) { return toPieces(exactWalkableTriangles(*state)); }

double surfaceArea(const Piece& piece) {
  const auto plane = planeThrough(piece.corners);
  const Rational factor = 1 + plane->a * plane->a + plane->b * plane->b;
  return std::sqrt(factor.get_d()) * twiceArea(piece.plan).get_d() / 2;
}

std::vector<double> areasOfParts(const std::vector<Piece>& pieces) {
  const auto parts = reference::connectedParts(pieces);
  std::vector<double> areas(reference::countParts(parts));
  for (std::size_t i = 0; i < pieces.size(); ++i) areas[parts[i]] += surfaceArea(pieces[i]);
  return areas;
}

/// Both cover the same in every plane, and their parts have the same areas.
std::string findShapeDifference(const std::vector<Piece>& before, const std::vector<Piece>& after) {
  std::map<const Piece*, Linear> planes;
  for (const auto* side : {&before, &after})
    for (const Piece& p : *side) planes[&p] = *planeThrough(p.corners);
  for (const auto* side : {&before, &after}) {
    const auto& mine = *side;
    const auto& other = side == &before ? after : before;
    for (const Piece& p : mine) {
      Rational covered = 0;
      for (const Piece& q : other)
        if (planes[&p] == planes[&q]) covered += twiceCommonArea(p.plan, q.plan);
      if (covered != twiceArea(p.plan)) return "not covered as often as before: " + toText(p);
    }
  }
  if (std::fabs(reference::obstacleLength(before) - reference::obstacleLength(after)) > 1e-9)
    return "obstacle edges have another length";
  if (reference::countParts(reference::connectedParts(before)) !=
      reference::countParts(reference::connectedParts(after)))
    return "another number of parts";
  return {};
}

struct LayerCounts {
  std::size_t cases = 0, connections = 0, optimum = 0;
};

/// Checks the cases that are small enough to find the optimum.
LayerCounts checkLayers(const Environment& environment) {
  RC_LOG() << toText(environment);
  const StatePtr before = runFilters(std::make_shared<Environment>(environment), minimalPipeline(0.5));
  const StatePtr after = runFilters(before, "LayerSubdivisionFilter\n");
  const auto pieces = piecesOf(after);
  if (const auto error = findShapeDifference(piecesOf(before), pieces); !error.empty()) RC_FAIL(error);
  for (const Piece& p : pieces) RC_ASSERT(p.layer >= 0);
  for (const auto& [a, b] : findOverlaps(pieces)) RC_ASSERT(pieces[a].layer != pieces[b].layer);
  const std::size_t found = countConnections(pieces);
  RC_ASSERT(summarize(*after).connections == found);
  const NavigationMesh mesh = navigationMesh(after);
  if (const auto error = findMeshError(mesh); !error.empty()) RC_FAIL(error);
  RC_ASSERT(mesh.connections.size() == found);
  RC_ASSERT(test::countParts(mesh) == reference::countParts(reference::connectedParts(pieces)));
  const auto fewest = fewestConnections(pieces, 4);
  if (!fewest) return {};
  RC_ASSERT(found >= *fewest);
  return {1, found, *fewest};
}

}  // namespace

class TestEffects : public QObject {
  Q_OBJECT
 private slots:
  void degeneracyLeavesNoTriangleWithoutArea() {
    QVERIFY(check("degeneracy", 450, [] {
      const auto environment = soupOf(*gridTriangles(16, 3, 2)).environment();
      RC_LOG() << toText(*environment);
      const StatePtr state = runFilters(environment, "DegeneracyFilter\n");
      std::uint64_t sound = 0, walkable = 0;
      for (std::uint32_t t = 0; t < environment->triangles.size(); ++t) {
        sound += !isDegenerate(cornersOf(*environment, t));
        walkable += upwardCorners(*environment, t).has_value();
      }
      const StateSummary summary = summarize(*state);
      RC_ASSERT(summary.triangles == walkable);
      RC_ASSERT(summary.triangles + summary.rejected == sound);
      // Removing what has no area changes nothing else.
      const auto rest = runFilters(state, minimalPipeline(1));
      const auto error = findDifference(*environment, computeWalkableArea(*environment, {45, 1}), piecesOf(rest));
      if (!error.empty()) RC_FAIL(error);
    }));
  }

  void duplicationLeavesNoVerticesCloserThanItsDistance() {
    QVERIFY(check("duplication", 450, [] {
      const auto soup = soupOf(*gridTriangles(16, 12, 4));
      const double distance = std::array{0.0, 1.0, 1.5, 2.0, 5.0}[static_cast<std::size_t>(*below(5))];
      const auto environment = soup.environment(true);
      RC_LOG() << distance << "\n" << toText(*environment);
      std::string filter = "DuplicationFilter " + std::to_string(distance) + "\n";
      const auto pieces = piecesOf(runFilters(environment, filter));
      std::set<Point3> places;
      for (const Piece& p : pieces) places.insert(p.corners.begin(), p.corners.end());
      for (const Point3& p : places) {
        for (const Point3& q : places) {
          const Rational dx = p.x - q.x, dy = p.y - q.y, dz = p.z - q.z;
          RC_ASSERT(p == q || dx * dx + dy * dy + dz * dz >= Rational(distance) * Rational(distance));
        }
      }
      // The order of the input does not matter.
      std::vector<std::uint32_t> order(environment->triangles.size());
      std::iota(order.rbegin(), order.rend(), 0U);
      const auto other = piecesOf(runFilters(shuffled(*environment, order, 1), filter));
      std::multiset<std::string> texts, otherTexts;
      for (const auto& [list, into] : {std::pair{&pieces, &texts}, std::pair{&other, &otherTexts}}) {
        for (const Piece& p : *list) {
          std::set<Point3> corners(p.corners.begin(), p.corners.end());
          std::string text;
          for (const Point3& c : corners) text += reference::toText(c);
          into->insert(text);
        }
      }
      RC_ASSERT(texts == otherTexts);
    }));
  }

  void slopeKeepsExactlyWhatIsNotTooSteep() {
    QVERIFY(check("slope", 900, [] {
      const auto environment = soupOf(*gridTriangles(16, 4, 4)).environment(*below(2) == 1);
      const double slope = std::array{30.0, 45.0, 60.0, 1.0, 89.0, 35.3, 54.7}[static_cast<std::size_t>(*below(7))];
      RC_LOG() << slope << "\n" << toText(*environment);
      std::multiset<std::uint32_t> expected, found;
      for (std::uint32_t t = 0; t < environment->triangles.size(); ++t) {
        const auto corners = upwardCorners(*environment, t);
        if (corners && isWithinSlope(*corners, slope)) expected.insert(t);
      }
      const auto pieces = piecesOf(runFilters(environment, "SlopeFilter " + std::to_string(slope) + "\n"));
      for (const Piece& p : pieces) found.insert(p.source);
      RC_ASSERT(found == expected);
    }));
  }

  void clearanceTwiceIsTheLargerOne() {
    QVERIFY(check("clearance twice", 180, [] {
      const auto environment = buildingOf(*buildingParts(9)).environment();
      RC_LOG() << toText(*environment);
      const auto area = computeWalkableArea(*environment, {45, 1.5});
      for (const char* filters : {"VerticalClearanceFilter 1.5\nVerticalClearanceFilter 1\n",
                                  "VerticalClearanceFilter 1\nVerticalClearanceFilter 1.5\n",
                                  "VerticalClearanceFilter 1.5\nVerticalClearanceFilter 1.5\n"}) {
        const auto error = findDifference(*environment, area,
                                          piecesOf(runFilters(environment, std::string("SlopeFilter 45\n") + filters)));
        if (!error.empty()) RC_FAIL(filters + error);
      }
    }));
  }

  void areaRemovesExactlyTheSmallRegions() {
    QVERIFY(check("area", 240, [] {
      const auto environment = buildingOf(*buildingParts(10)).environment();
      const int limit = *below(8);
      RC_LOG() << limit << "\n" << toText(*environment);
      const StatePtr before = runFilters(environment, minimalPipeline(1.5));
      const StatePtr after = runFilters(before, "AreaFilter " + std::to_string(limit) + "\n");
      const auto areas = areasOfParts(piecesOf(before));
      auto kept = areasOfParts(piecesOf(after));
      std::vector<double> expected;
      for (const double a : areas) {
        // A sum of rounded square roots: what lies closer than this is equal to the limit on these grids.
        if (a > limit + 1e-9) expected.push_back(a);
      }
      std::sort(expected.begin(), expected.end());
      std::sort(kept.begin(), kept.end());
      RC_ASSERT(kept.size() == expected.size());
      for (std::size_t i = 0; i < kept.size(); ++i) RC_ASSERT(std::fabs(kept[i] - expected[i]) < 1e-9);
    }));
  }

  void areaDecidesTheBoundaryExactly() {
    const auto partsAbove = [](const Soup& soup, const std::string& limit) {
      return piecesOf(runFilters(soup.environment(), minimalPipeline(1) + "AreaFilter " + limit + "\n")).size();
    };
    QCOMPARE(partsAbove(Soup().floor(0, 0, 2, 2, 0), "4"), std::size_t{0});
    QVERIFY(partsAbove(Soup().floor(0, 0, 2, 2, 0), "3.9999999999999996") > 0);
    // A rise of 3 over 4: 5 long and 2 wide.
    QCOMPARE(partsAbove(Soup().ramp(0, 0, 4, 2, 0, 3), "10"), std::size_t{0});
    QVERIFY(partsAbove(Soup().ramp(0, 0, 4, 2, 0, 3), "9.999999999999998") > 0);
  }

  void simplificationKeepsTheShape() {
    QVERIFY(check("simplification", 80, [] {
      const auto environment = buildingOf(*buildingParts(9)).environment();
      RC_LOG() << toText(*environment);
      const StatePtr before = runFilters(environment, minimalPipeline(1.5));
      const StatePtr after = runFilters(before, "SimplificationFilter\n");
      const auto pieces = piecesOf(before), simplified = piecesOf(after);
      RC_ASSERT(simplified.size() <= pieces.size());
      if (const auto error = findShapeDifference(pieces, simplified); !error.empty()) RC_FAIL(error);
      if (const auto error = findConformityError(simplified); !error.empty()) RC_FAIL(error);
      const NavigationMesh mesh = navigationMesh(after);
      if (const auto error = findMeshError(mesh); !error.empty()) RC_FAIL(error);
      RC_ASSERT(test::countParts(mesh) == reference::countParts(reference::connectedParts(pieces)));
    }));
  }

  void simplificationUsesFewTriangles() {
    Soup grid;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) grid.floor(i, j, i + 1, j + 1, 0);
    const auto count = [&](const Soup& soup) {
      return piecesOf(runFilters(soup.environment(), minimalPipeline(1) + "SimplificationFilter\n")).size();
    };
    QCOMPARE(count(grid), std::size_t{2});
    QCOMPARE(count(Soup(grid).ceiling(2, 2, 3, 3, 0.5)), std::size_t{8});  // 4 + 4 corners around a hole
  }

  void layersDoNotOverlapAndAllIsKept() {
    QVERIFY(check("layers of buildings", 80, [&] { checkLayers(*buildingOf(*buildingParts(10)).environment()); }));
  }

  void layersOfWalksOverThemselves() {
    LayerCounts sum;
    QVERIFY(check("layers of walks", 150, [&] {
      const auto counts = checkLayers(*walkOf(*upTo(40, below(16))).environment());
      sum.cases += counts.cases;
      sum.connections += counts.connections;
      sum.optimum += counts.optimum;
    }));
    qInfo("%zu connections in %zu cases, %zu at best", sum.connections, sum.cases, sum.optimum);
    // The filter is a heuristic; it must stay close to the optimum.
    QVERIFY(sum.optimum > 0);
    QVERIFY(static_cast<double>(sum.connections) <= 1.25 * static_cast<double>(sum.optimum));
  }

  void layersAreOptimalOnSimpleCases() {
    const auto expectOptimal = [](const Soup& soup, std::size_t connections) {
      const auto pieces = piecesOf(runFilters(soup.environment(), minimalPipeline(2) + "LayerSubdivisionFilter\n"));
      QCOMPARE(fewestConnections(pieces, 6), std::optional<std::size_t>(connections));
      QCOMPARE(countConnections(pieces), connections);
    };
    expectOptimal(Soup().floor(0, 0, 4, 4, 0), 0);
    expectOptimal(Soup()
                      .floor(0, 0, 8, 4, 0)
                      .floor(0, 0, 8, 4, 4)
                      .ramp(8, 0, 12, 4, 0, 4)
                      .floor(12, 0, 14, 4, 4)
                      .floor(8, 4, 14, 6, 4)
                      .floor(0, 4, 8, 6, 4),
                  1);
    Soup spiral;  // two turns of four flights
    const std::array<std::array<double, 2>, 4> inner{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
    for (std::size_t i = 0; i < 8; ++i) {
      const auto &a = inner[i % 4], &b = inner[(i + 1) % 4];
      const auto z = static_cast<double>(i);
      spiral.quad({a[0], a[1], z}, {3 * a[0], 3 * a[1], z}, {3 * b[0], 3 * b[1], z + 1}, {b[0], b[1], z + 1});
    }
    expectOptimal(spiral, 1);
  }

  void roundingMovesNoVertexFarAndKeepsTheParts() {
    QVERIFY(check("rounding", 240, [] {
      const auto environment = soupOf(*gridTriangles(14, 4, 3)).environment();
      RC_LOG() << toText(*environment);
      const StatePtr before = runFilters(environment, minimalPipeline(1, 60));
      const StatePtr after = runFilters(before, "RoundingFilter\n");
      const auto pieces = piecesOf(before), rounded = piecesOf(after);
      for (const Piece& p : rounded) {
        for (const Point3& c : p.corners) {
          RC_ASSERT(c.x == c.x.get_d() && c.y == c.y.get_d() && c.z == c.z.get_d());
          const bool near = std::any_of(pieces.begin(), pieces.end(), [&](const Piece& q) {
            return std::any_of(q.corners.begin(), q.corners.end(), [&](const Point3& d) {
              const Rational bound(0x1p-48);
              return abs(c.x - d.x) <= bound && abs(c.y - d.y) <= bound && abs(c.z - d.z) <= bound;
            });
          });
          RC_ASSERT(near);
        }
      }
      if (const auto error = findConformityError(rounded); !error.empty()) RC_FAIL(error);
      RC_ASSERT(reference::countParts(reference::connectedParts(pieces)) ==
                reference::countParts(reference::connectedParts(rounded)));
    }));
  }
};

QTEST_APPLESS_MAIN(TestEffects)
#include "test_effects.moc"
