// Rounding: the cases of thesis 4.4.2 are met, counted and repaired, and obstacle edges survive them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>

#include "core/exact/source_predicates.hpp"
#include "core/filters/apply_filter.hpp"
#include "core/filters/rounding/rounded_mesh.hpp"
#include "footfall/filter.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

double planArea(const RoundedMesh& mesh) {
  double twice = 0;
  for (const MeshTriangle& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t.corners[0]], &b = mesh.vertices[t.corners[1]], &c = mesh.vertices[t.corners[2]];
    twice += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  return twice / 2;
}

bool allUpright(const RoundedMesh& mesh) {
  for (const MeshTriangle& t : mesh.triangles)
    if (facing(mesh.vertices[t.corners[0]], mesh.vertices[t.corners[1]], mesh.vertices[t.corners[2]]) <= 0)
      return false;
  return true;
}

bool hasObstacle(const RoundedMesh& mesh, const Vec3& a, const Vec3& b) {
  for (const MeshTriangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Vec3 &u = mesh.vertices[t.corners[k]], &v = mesh.vertices[t.corners[(k + 1) % 3]];
      if ((t.obstacleEdges >> k & 1) != 0 && ((u == a && v == b) || (u == b && v == a))) return true;
    }
  return false;
}

/// A square of four triangles around a middle vertex (number 4).
RoundedMesh square(const Vec3& middle) {
  RoundedMesh mesh;
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, middle};
  mesh.triangles = {{{0, 1, 4}, 0, 0}, {{1, 2, 4}, 0, 0}, {{2, 3, 4}, 0, 0}, {{3, 0, 4}, 0, 0}};
  return mesh;
}

std::shared_ptr<Environment> environmentOf(std::vector<Vec3> vertices, std::vector<Triangle> triangles) {
  auto environment = std::make_shared<Environment>();
  environment->vertices = std::move(vertices);
  environment->triangles = std::move(triangles);
  return environment;
}

std::vector<double> defaultValues(const FilterDescriptor& filter) {
  std::vector<double> values;
  for (const ParameterDescriptor& p : filter.parameters) values.push_back(p.defaultValue);
  return values;
}

StatePtr apply(const char* name, std::vector<double> values, const StatePtr& state, RunContext& context) {
  const FilterDescriptor* filter = findFilter(name);
  if (values.empty()) values = defaultValues(*filter);
  return applyFilter(*filter, values, state, context).state;
}

}  // namespace

class TestRounding : public QObject {
  Q_OBJECT

 private slots:
  void exactTrianglesStay() {
    RoundedMesh mesh = square({2, 2, 0});
    RunContext context;
    const RoundingCases cases = repairRounding(mesh, std::vector<char>(5, 1), context);
    QCOMPARE(cases.exact, 4U);
    QCOMPARE(cases.edge + cases.point + cases.collinear + cases.flipped, 0U);
    QCOMPARE(mesh.triangles.size(), std::size_t{4});
  }

  void cornersThatFallTogether() {
    RoundedMesh mesh = square({0, 0, 0});     // two triangles become edges
    mesh.triangles[0].obstacleEdges = 0b010;  // The edge goes from (4, 0) to the middle, which is (0, 0) now.
    RunContext context;
    const RoundingCases cases = repairRounding(mesh, {1, 1, 1, 1, 0}, context);
    QCOMPARE(cases.edge, 2U);
    QCOMPARE(mesh.triangles.size(), std::size_t{2});
    QVERIFY(allUpright(mesh));
    QCOMPARE(planArea(mesh), 16.0);
    QVERIFY(hasObstacle(mesh, {0, 0, 0}, {4, 0, 0}));  // algorithm 3: the neighbour has it now
  }

  void trianglesThatBecomePoints() {
    RoundedMesh mesh;
    mesh.vertices = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    mesh.triangles = {{{0, 1, 2}, 0, 0}, {{2, 3, 4}, 0, 0}, {{1, 3, 2}, 0, 0}, {{2, 4, 0}, 0, 0}};
    RunContext context;
    const RoundingCases cases = repairRounding(mesh, std::vector<char>(5, 0), context);
    QCOMPARE(cases.point, 1U);
    QCOMPARE(cases.edge, 2U);
    QCOMPARE(mesh.triangles.size(), std::size_t{1});
    QCOMPARE(planArea(mesh), 8.0);
  }

  void collinearCornersGoToTheNeighbour() {
    // the middle fell onto the edge from (0, 0) to (4, 0), where a triangle lies on the other side
    RoundedMesh mesh = square({2, 0, 0});
    mesh.vertices.push_back({2, -4, 0});
    mesh.triangles.push_back({{1, 0, 5}, 0, 0b010});  // an obstacle from (0, 0) to (2, -4)
    RunContext context;
    const RoundingCases cases = repairRounding(mesh, std::vector<char>(6, 1), context);
    QCOMPARE(cases.collinear, 1U);
    QVERIFY(allUpright(mesh));
    QCOMPARE(mesh.triangles.size(), std::size_t{5});
    QCOMPARE(planArea(mesh), 24.0);
    QVERIFY(hasObstacle(mesh, {0, 0, 0}, {2, -4, 0}));
  }

  void flippedCornersGoToTheNeighbour() {
    RoundedMesh mesh = square({2, -1e-15, 0});
    mesh.vertices.push_back({2, -4, 0});
    mesh.triangles.push_back({{1, 0, 5}, 0, 0});
    RunContext context;
    const RoundingCases cases = repairRounding(mesh, std::vector<char>(6, 1), context);
    QCOMPARE(cases.flipped, 1U);
    QVERIFY(allUpright(mesh));
    QVERIFY(std::fabs(planArea(mesh) - 24) < 1e-12);
  }

  void flatTrianglesAtTheBorderGo() {
    RoundedMesh mesh = square({2, 0, 0});
    mesh.triangles[0].obstacleEdges = 0b001;  // the border edge that the middle fell onto
    RunContext context;
    repairRounding(mesh, std::vector<char>(5, 1), context);
    QVERIFY(allUpright(mesh));
    QCOMPARE(mesh.triangles.size(), std::size_t{3});
    QCOMPARE(planArea(mesh), 16.0);
    QVERIFY(hasObstacle(mesh, {0, 0, 0}, {2, 0, 0}));
    QVERIFY(hasObstacle(mesh, {2, 0, 0}, {4, 0, 0}));
  }

  // Definitions 4.8 to 4.10: all, not all, and some but not all coordinates of a vertex are doubles. The edges of the
  // obstacle cross the floor's border y = -4 at x = 1/3 and x = 7/3.
  void partiallyRepresentableVerticesKeepTheirDoubles() {
    const auto environment =
        environmentOf({{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}, {0, -5, 1}, {3, -5, 1}, {1, -2, 1}}, {{0, 1, 2}, {3, 4, 5}});
    RunContext context;
    const StatePtr state = apply("VerticalClearanceFilter", {2}, makeInitialState(environment, context), context);
    std::vector<char> exact;
    const std::vector<Vec3> places = roundVertices(*state->kernel, state->mesh->vertices, exact, context);
    int partly = 0, whole = 0;
    for (std::size_t v = 0; v < places.size(); ++v) {
      if (places[v].z != 0) continue;  // the obstacle is walkable too
      if (exact[v] != 0) {             // 4.8
        ++whole;
        continue;
      }
      ++partly;  // 4.9 by x, and 4.10 by y and z, which must not move
      QCOMPARE(places[v].y, -4.0);
      QVERIFY(places[v].x == 1.0 / 3 || places[v].x == 7.0 / 3);
    }
    QCOMPARE(partly, 2);
    QCOMPARE(whole, 4);  // three corners, and the obstacle's at (1, -2)
  }

  // Definition 4.9 by all three coordinates: two edges of obstacles cross at x = y = 1/3 over a floor with z = x.
  void verticesWithoutAnyDoubleRoundToTheNearest() {
    const auto environment = environmentOf(
        {{-4, -4, -4}, {4, -4, 4}, {0, 4, 0}, {0, 0, 5}, {1, 1, 5}, {0, 1, 5}, {0, 1, 5}, {1, -1, 5}, {1, 1, 5}},
        {{0, 1, 2}, {3, 4, 5}, {7, 8, 6}});
    RunContext context;
    const StatePtr state = apply("VerticalClearanceFilter", {20}, makeInitialState(environment, context), context);
    std::vector<char> exact;
    const std::vector<Vec3> places = roundVertices(*state->kernel, state->mesh->vertices, exact, context);
    int found = 0;
    for (std::size_t v = 0; v < places.size(); ++v)
      if (places[v] == Vec3{1.0 / 3, 1.0 / 3, 1.0 / 3}) {
        ++found;
        QVERIFY(exact[v] == 0);
      }
    QVERIFY(found > 0);
  }

  void closedSliversBecomeObstacleEdges() {
    // A wall that leans by one unit in the last place over its height of 8: within a clearance of 1 it removes a sliver
    // that no double can show.
    const double x = 512, lean = std::nextafter(x, 1024.0);
    const auto environment = environmentOf({{0, 0, 0},
                                            {1024, 0, 0},
                                            {1024, 1024, 0},
                                            {0, 1024, 0},
                                            {x, 256, 0},
                                            {x, 768, 0},
                                            {lean, 768, 8},
                                            {lean, 256, 8}},
                                           {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
    RunContext context;
    StatePtr state = makeInitialState(environment, context);
    state = apply("SlopeFilter", {}, state, context);
    state = apply("VerticalClearanceFilter", {1}, state, context);
    for (const bool rounded : {false, true}) {
      if (rounded) state = apply("RoundingFilter", {}, state, context);
      const auto mesh = makeNavigationMesh(state, context);
      double length = 0;
      for (const auto& [a, b] : mesh->obstacleEdges) {
        QCOMPARE(mesh->vertices[a].x, x);
        QCOMPARE(mesh->vertices[b].x, x);
        length += std::fabs(mesh->vertices[a].y - mesh->vertices[b].y);
      }
      QCOMPARE(length, 512.0);
    }
  }

  void closedSliversInsideAFloorStayApart() {
    // the same inside one floor triangle, where simplification leaves only the four corners of the sliver: both its
    // ends round to one place, so the sides need points of their own in the middle
    const double lean = std::nextafter(2.0, 3.0);
    const auto environment =
        environmentOf({{-20, -20, 0}, {20, -20, 0}, {0, 40, 0}, {2, 1, 0}, {2, 3, 0}, {lean, 3, 5}, {lean, 1, 5}},
                      {{0, 1, 2}, {3, 4, 5}, {3, 5, 6}});
    RunContext context;
    StatePtr state = apply("VerticalClearanceFilter", {2}, makeInitialState(environment, context), context);
    for (const char* filter : {"", "SimplificationFilter", "RoundingFilter"}) {
      if (*filter != 0) state = apply(filter, {}, state, context);
      const auto mesh = makeNavigationMesh(state, context);
      double length = 0;
      for (const auto& [a, b] : mesh->obstacleEdges) length += std::fabs(mesh->vertices[a].y - mesh->vertices[b].y);
      QCOMPARE(length, 2.0);
    }
  }

  // An obstacle edge of a few units in the last place, whose middle lies beside it.
  void middlesOfShortEdgesTurnNothingOver() {
    const test::Soup soup =
        test::Soup()
            .triangle({122000.45633333334, 487000.74171428574, 0}, {122000.123, 487000.8845714286, 0},
                      {122000.123, 487000.456, 0})
            .triangle({122000.78966666668, 487000.74171428574, 0}, {122000.123, 487000.59885714285, 0},
                      {122001.123, 487000.456, 0})
            .triangle({122000.45633333334, 487000.8845714286, 0}, {122000.123, 487000.8845714286, 0},
                      {122000.45633333334, 487000.59885714285, 0})
            .triangle({122000.123, 487000.59885714285, 0}, {122001.123, 487000.59885714285, 0},
                      {122001.123, 487000.8845714286, 0});
    const NavigationMesh mesh =
        test::navigationMesh(test::runFilters(soup.environment(true), test::minimalPipeline(1.4, 80)));
    QCOMPARE(test::findMeshError(mesh), std::string());
    QVERIFY(mesh.triangles.size() > 10);
  }

  // The wall's foot crosses the floor's fold, and what stands above it there is as long as one unit in the last place:
  // no double lies between its ends, so that its sides cannot have vertices of their own.
  void obstaclesWithoutAMiddleGo() {
    test::Soup floors;
    floors.triangle({0.4, 2.8, 2}, {0.40000000000000036, 7.8, 3}, {0.4, 2.8, 3});
    floors.triangle({0.8, 0.6, 2}, {1.6, 1.2, 3}, {-0.19999999999999973, 3.6, 3});
    floors.triangle({1.6, 1.2, 3}, {0.6, 4.2, 3}, {-0.19999999999999973, 3.6, 3});
    const NavigationMesh mesh =
        test::navigationMesh(test::runFilters(floors.environment(), test::minimalPipeline(1.5)));
    QCOMPARE(test::findMeshError(mesh), std::string());
    QVERIFY(mesh.obstacleEdges.empty() && test::countParts(mesh) == 1);
  }

  // The thesis's files say `RoundingFilter true`; another value is read, repaired all the same, and reported.
  void unrepairedRoundingIsReported() {
    const auto environment = environmentOf({{0, 0, 0}, {9, 0, 0}, {0, 9, 0.3}, {1, 1, 1}, {3, 1.1, 1.7}, {1.3, 3, 1.2}},
                                           {{0, 1, 2}, {3, 4, 5}});
    RunContext context;
    const StatePtr state = apply("VerticalClearanceFilter", {2}, makeInitialState(environment, context), context);
    const FilterDescriptor& filter = *findFilter("RoundingFilter");
    const auto noteOf = [&](double repair) { return applyFilter(filter, {repair}, state, context).note.str(); };
    QVERIFY(noteOf(1).find("repair") == std::string::npos);
    QVERIFY(noteOf(0).find("repair false changes nothing") != std::string::npos);
    QVERIFY(noteOf(0).find("footfall-rounding-experiment") != std::string::npos);
  }

  void roundingStartsANewGeneration() {
    // a box over a floor: after rounding, clearance finds the same again
    const auto environment = environmentOf({{0, 0, 0}, {9, 0, 0}, {0, 9, 0.3}, {1, 1, 1}, {3, 1.1, 1.7}, {1.3, 3, 1.2}},
                                           {{0, 1, 2}, {3, 4, 5}});
    RunContext context;
    StatePtr state = makeInitialState(environment, context);
    state = apply("VerticalClearanceFilter", {2}, state, context);
    const double area = summarize(*state).area;
    const StatePtr rounded = apply("RoundingFilter", {}, state, context);
    QVERIFY(rounded != state);
    QVERIFY(std::fabs(summarize(*rounded).area - area) < 1e-12);
    const StatePtr again = apply("VerticalClearanceFilter", {2}, rounded, context);
    QVERIFY(std::fabs(summarize(*again).area - area) < 1e-12);
    QVERIFY(apply("RoundingFilter", {}, rounded, context) == rounded);  // nothing left to round
  }
};

QTEST_APPLESS_MAIN(TestRounding)
#include "test_rounding.moc"
