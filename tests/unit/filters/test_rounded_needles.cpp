// Needles between lines that nearly coincide: their repair moves nothing by more than roundings.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "core/assembly/mesh_assembly.hpp"
#include "core/base/vector.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/filters/rounding/rounded_mesh.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "core/mesh/triangle_corners.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using test::Soup;

namespace {

using Edge = std::array<Vec3, 2>;

/// Off the grid, where lines that were one are several.
Soup turned(const Soup& soup) {
  return soup.mapped([](const Vec3& p) { return Vec3{0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y, p.z}; });
}
Soup building(std::uint32_t seed, int number) {
  std::mt19937 random(seed);
  std::vector<test::PartNumbers> parts;
  for (int i = 0; i <= number; ++i) {
    parts.resize(3 + random() % 9);
    for (auto& part : parts)
      for (int& n : part) n = static_cast<int>(random() % 64);
  }
  return turned(test::buildingOf(parts));
}

double planAreaOf(const Vec3& a, const Vec3& b, const Vec3& c) {
  return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}
double distanceTo(const Edge& edge, const Vec3& p) {
  const Vec3 d = edge[1] - edge[0];
  const double square = dot(d, d), t = square > 0 ? std::clamp(dot(p - edge[0], d) / square, 0.0, 1.0) : 0;
  return length(p - (edge[0] + t * d));
}

/// The same rounded mesh before and after its repair.
struct Compared {
  double before = 0, behind = 0;  ///< areas in the plan
  double largest = 0;             ///< coordinate
  double farthest = 0;            ///< distance of the product's border from the border before, in the plan and up
  std::string error;
};
Compared compare(const StatePtr& given) {
  RunContext context;
  ExactFallbacks fallbacks;
  const StatePtr state = withMesh(given, context, fallbacks);
  std::vector<char> exact;
  const std::vector<Vec3> places = roundVertices(*state->kernel, state->mesh->vertices, exact, context);
  Compared result;
  for (const Vec3& p : places) result.largest = std::max({result.largest, std::fabs(p.x), std::fabs(p.y), p.z});
  for (const MeshTriangle& t : state->mesh->triangles)
    result.before += planAreaOf(places[t.corners[0]], places[t.corners[1]], places[t.corners[2]]);
  const NavigationMesh product = test::navigationMesh(state);
  result.error = test::findMeshError(product);
  std::vector<Edge> borders;
  const auto topology = topologyOf(*state);
  const TriangleCorners corners(state->mesh->triangles);
  for (Index e = 0; e < topology->edgeCount(); ++e) {
    const auto sides = topology->sidesOf(e);
    if (sides.size() == 1 || isObstacle(state->mesh->triangles, sides))
      borders.push_back({places[corners.beginOf(sides[0])], places[corners.endOf(sides[0])]});
  }
  std::map<std::array<std::uint32_t, 2>, int> sides;
  for (const Triangle& t : product.triangles) {
    result.behind += planAreaOf(product.vertices[t[0]], product.vertices[t[1]], product.vertices[t[2]]);
    for (int k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [ends, count] : sides) {
    if (sides.count({ends[1], ends[0]}) != 0) continue;
    const Vec3 &a = product.vertices[ends[0]], &b = product.vertices[ends[1]];
    for (const double share : {0.0, 0.13, 0.5, 0.77}) {
      double least = 1e300;
      for (const Edge& border : borders) least = std::min(least, distanceTo(border, a + share * (b - a)));
      result.farthest = std::max(result.farthest, least);
    }
  }
  return result;
}

}  // namespace

class TestRoundedNeedles : public QObject {
  Q_OBJECT

 private slots:
  // Two needles on either side of one edge, whose corners came to lie on the other side of it: whichever goes first,
  // the other one is in its way.
  void twoNeedlesThatTurnEachOtherOver() {
    for (const double hair : {0x1p-53, 0x1p-52, 0x1p-51}) {
      RoundedMesh mesh;
      enum : Index { kA, kB, kAbove, kBelow, kTop, kBottom };
      mesh.vertices = {{0, 0, 0}, {3, 0, 0}, {1, -hair, 0}, {2, hair, 0}, {1.5, 3, 0}, {1.5, -3, 0}};
      mesh.triangles = {{{kA, kB, kAbove}, 0, 0},          {{kB, kA, kBelow}, 1, 0},
                        {{kAbove, kB, kTop}, 2, 0b010},    {{kA, kAbove, kTop}, 3, 0b100},
                        {{kA, kBottom, kBelow}, 4, 0b001}, {{kBottom, kB, kBelow}, 5, 0b001}};
      RunContext context;
      const RoundingCases cases = repairRounding(mesh, std::vector<char>(6, 0), context);
      QVERIFY(cases.collapsed.empty() && cases.flipped == 2);
      double area = 0;
      std::vector<char> isUsed(6, 0);
      for (const MeshTriangle& t : mesh.triangles) {
        const auto& c = t.corners;
        QVERIFY(facing(mesh.vertices[c[0]], mesh.vertices[c[1]], mesh.vertices[c[2]]) > 0);
        area += planAreaOf(mesh.vertices[c[0]], mesh.vertices[c[1]], mesh.vertices[c[2]]);
        for (const Index v : c) isUsed[v] = 1;
      }
      QVERIFY(std::fabs(area - 9) < 1e-14);
      QVERIFY(std::count(isUsed.begin(), isUsed.end(), 1) == 6);
      QCOMPARE(std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                             [](const MeshTriangle& t) { return t.obstacleEdges != 0; }),
               std::ptrdiff_t{4});
    }
  }

  // Links end a little inside of what they stand for, which leaves needles along borders: in the first ones borders
  // went up to a metre from where they were.
  void buildingsWithSteps() {
    std::vector<Soup> soups;
    for (const auto& [seed, number] : {std::array{15, 0},
                                       {18, 15},
                                       {27, 36},
                                       {36, 0},
                                       {44, 54},
                                       {49, 15},
                                       {64, 57},
                                       {78, 18},
                                       {94, 9},
                                       {141, 33},
                                       {244, 45},
                                       {304, 30},
                                       {363, 24},
                                       {48, 0},
                                       {59, 3},
                                       {969, 11}})
      soups.push_back(building(static_cast<std::uint32_t>(seed), number));
    std::mt19937 random(static_cast<unsigned>(test::seed()));
    for (int i = 0; i < test::rounds(300); ++i) soups.push_back(building(static_cast<std::uint32_t>(random()), 0));
    for (std::size_t i = 0; i < soups.size(); ++i) {
      StatePtr state = test::runFilters(soups[i].environment(i % 5 == 0),
                                        test::minimalPipeline(1.5) + (i < 15 || i % 2 == 0 ? "\nStepFilter 0.5" : ""));
      for (const bool isSimplified : {false, true}) {
        if (isSimplified) state = test::runFilters(state, "SimplificationFilter");
        const Compared found = compare(state);
        const double most = 0x1p-42 * found.largest;
        QCOMPARE(found.error, std::string());
        QVERIFY2(found.farthest <= most, qPrintable(QString("%1: %2").arg(i).arg(found.farthest)));
        QVERIFY2(std::fabs(found.behind - found.before) <= 100 * most,
                 qPrintable(QString("%1: %2, %3").arg(i).arg(found.before).arg(found.behind)));
      }
    }
  }

  // Floors that begin at one line, of which rounding lets one lie over the other: the needle between them goes.
  void noTwoTrianglesOnOneSide() {
    Soup upright;
    upright.triangle({1.2000000000000004, 3.4, 0}, {4.4, 5.800000000000001, 3}, {2.6000000000000005, 8.2, 3});
    upright.triangle({1.2000000000000004, 3.4, 0}, {2.6000000000000005, 8.2, 3}, {-0.5999999999999996, 5.8, 0});
    upright.triangle({1.8000000000000003, 2.5999999999999996, 0}, {5.000000000000001, 5, 3},
                     {2.6000000000000005, 8.2, 3});
    upright.triangle({2, 4, 2}, {4.4, 5.800000000000001, 3}, {2.000000000000001, 9, 3});
    Soup folded;
    folded.triangle({-0.6, 0.8, 1}, {2.6, 3.2, 2}, {2, 4, 2});
    folded.triangle({2.6, 3.2, 3}, {3.4000000000000004, 8.8, 3}, {0.20000000000000018, 6.4, 3});
    folded.triangle({3.2, 2.4, 2}, {5.2, 6.4, 2}, {2, 4, 2});
    for (const auto& [soup, filters] : {std::pair{upright, "RadiusFilter 0.3 0"},
                                        {folded, "StepFilter 0.5\nRadiusFilter 0 0.3"},
                                        {folded, "RadiusFilter 0 0.3"}}) {
      const NavigationMesh mesh =
          test::navigationMesh(test::runFilters(soup.environment(), test::minimalPipeline(1.5) + "\n" + filters));
      QCOMPARE(test::findMeshError(mesh), std::string());
      QVERIFY(test::planArea(mesh) > 1);
    }
  }
};

QTEST_GUILESS_MAIN(TestRoundedNeedles)
#include "test_rounded_needles.moc"
