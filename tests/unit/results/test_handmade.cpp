// Small environments with answers known by hand (slope 45, clearance 2 by default). Each is also compared exactly with
// the reference.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "tests/reference/product_check.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using namespace footfall::test;
using reference::Rational;
using reference::Rounding;

namespace {

struct Expected {
  Rational planArea;
  std::size_t parts = 1;
  double obstacleLength = 0;
  double clearance = 2;
  double slope = 45;
};

/// Checks the exact plan area in the product, parts and obstacle edges in the rounded mesh, and all of it against the
/// reference.
void expect(const Soup& soup, const Expected& expected) {
  const auto environment = soup.environment();
  const std::string error =
      reference::checkProduct(*environment, expected.slope, expected.clearance, Rounding::Harmless);
  QVERIFY2(error.empty(), error.c_str());
  const StatePtr state = runFilters(environment, minimalPipeline(expected.clearance, expected.slope));
  Rational twice = 0;
  for (const auto& piece : reference::toPieces(exactWalkableTriangles(*state))) twice += twiceArea(piece.plan);
  const Rational area = twice / 2;
  QVERIFY2(area == expected.planArea, ("plan area " + area.get_str()).c_str());
  const NavigationMesh mesh = navigationMesh(state);
  QCOMPARE(countParts(mesh), expected.parts);
  QVERIFY2(std::fabs(obstacleLength(mesh) - expected.obstacleLength) < 1e-9,
           std::to_string(obstacleLength(mesh)).c_str());
}

/// A floor of 4 x 4 at 0 in two triangles; their shared edge is the diagonal from (0, 0) to (4, 4).
Soup room() { return Soup().floor(0, 0, 4, 4, 0); }

constexpr double kDiagonal = 4 * std::numbers::sqrt2;

}  // namespace

class TestHandmade : public QObject {
  Q_OBJECT
 private slots:
  // --- obstacles with an area ---
  void tableOverFloor() {
    const Soup soup = Soup().floor(0, 0, 10, 10, 0).floor(2, 3, 5, 4, 1);
    expect(soup, {.planArea = 100, .parts = 2});
    expect(soup, {.planArea = 103, .parts = 2, .clearance = 1});
    expect(Soup().floor(0, 0, 10, 10, 0).ceiling(2, 3, 5, 4, 1), {.planArea = 97});
  }
  void hangingSignAtExactlyTheClearance() {
    expect(room().ceiling(1, 1, 3, 3, 2), {.planArea = 16});
    expect(room().ceiling(1, 1, 3, 3, std::nextafter(2, 0)), {.planArea = 12});
    expect(room().ceiling(1, 1, 3, 3, std::nextafter(2, 3)), {.planArea = 16});
  }
  void slopingCeilingCutsAtTheClearance() {
    // The ramp rises from 0 at x = 0 to 4 at x = 4: lower than 2 up to x = 2.
    expect(room().quad({0, 0, 0}, {0, 4, 0}, {4, 4, 4}, {4, 0, 4}), {.planArea = 8});
  }
  void boxOnTheFloor() { expect(room().box({1, 1, 0}, {2, 3, 1}), {.planArea = 16, .parts = 2}); }
  void touchingBoxes() {  // their tops are one area
    expect(room().box({1, 1, 0}, {2, 2, 1}).box({2, 1, 0}, {3, 2, 1}), {.planArea = 16, .parts = 2});
  }
  void interpenetratingBoxes() {
    // The higher box removes what it covers of the lower one's top.
    expect(room().box({0.5, 0.5, 0}, {2, 2, 1}).box({1, 1, -1}, {3, 3, 1.5}), {.planArea = 16, .parts = 3});
  }
  void boxesThatShareATopPlane() {
    expect(room().box({0.5, 0.5, 0}, {2, 2, 1}).box({1, 1, 0}, {3, 3, 1}), {.planArea = 16, .parts = 2});
  }

  // --- walls without thickness ---
  void thinWallWithADoor() {
    const Soup soup = room().wall(0, 2, 1, 2, 0, 3).wall(2, 2, 4, 2, 0, 3);
    expect(soup, {.planArea = 16, .obstacleLength = 3});
    expect(Soup(soup).wall(1, 2, 2, 2, 1.5, 3), {.planArea = 16, .parts = 2, .obstacleLength = 4});
  }
  void wallThatDoesNotReachTheFloor() {
    expect(room().wall(0, 2, 4, 2, 1, 3), {.planArea = 16, .parts = 2, .obstacleLength = 4});
    expect(room().wall(0, 2, 4, 2, 2, 3), {.planArea = 16});
    expect(room().wall(0, 2, 4, 2, 2.5, 3), {.planArea = 16});
    expect(room().wall(0, 2, 4, 2, -3, 0), {.planArea = 16});
    expect(room().wall(0, 2, 4, 2, std::nextafter(2, 0), 3), {.planArea = 16, .parts = 2, .obstacleLength = 4});
  }
  void triangularWall() {  // a gable: its top corner at 4, its lower edge from 0 to 4 at heights 1 and 3
    const Soup soup = room().triangle({0, 2, 1}, {4, 2, 3}, {4, 2, 4});
    expect(soup, {.planArea = 16, .obstacleLength = 2});
  }
  void wallInATrianglesInterior() {
    expect(room().wall(2, 1, 3, 1, 0, 1), {.planArea = 16, .obstacleLength = 1});
    // Four walls around a yard that lies in one triangle.
    expect(room().wall(2, 0.5, 3, 0.5, 0, 1).wall(3, 0.5, 3, 1, 0, 1).wall(3, 1, 2, 1, 0, 1).wall(2, 1, 2, 0.5, 0, 1),
           {.planArea = 16, .parts = 2, .obstacleLength = 3});
  }
  void wallExactlyOnASharedEdge() {
    expect(room().wall(0, 0, 4, 4, 0, 3), {.planArea = 16, .parts = 2, .obstacleLength = kDiagonal});
    expect(room().wall(1, 1, 4, 4, 0, 3), {.planArea = 16, .obstacleLength = kDiagonal * 3 / 4});
    expect(room().wall(-1, -1, 5, 5, 0, 3), {.planArea = 16, .parts = 2, .obstacleLength = kDiagonal});
  }
  void wallWithTwoFreeEndsOnASharedEdge() {
    expect(room().wall(1, 1, 2, 2, 0, 3), {.planArea = 16, .obstacleLength = kDiagonal / 4});
  }
  void wallSegmentWithTwoFreeEnds() {
    const Soup soup = room().wall(1, 2, 1.5, 2, 0, 3);
    expect(soup, {.planArea = 16, .obstacleLength = 0.5});
    // Its sides differ only in a point in the middle.
    const NavigationMesh mesh = navigationMesh(runFilters(soup.environment(), minimalPipeline(2)));
    std::set<std::uint32_t> ends;
    for (const auto& edge : mesh.obstacleEdges) ends.insert(edge.begin(), edge.end());
    QCOMPARE(mesh.obstacleEdges.size(), std::size_t{2});
    QCOMPARE(ends.size(), std::size_t{3});
  }
  void wallOnTheRimBlocksNothing() { expect(room().wall(0, 0, 4, 0, 0, 3), {.planArea = 16}); }
  void wallBetweenFloors() {
    expect(room().floor(4, 0, 8, 4, 0).wall(4, 1, 4, 4, 0, 1), {.planArea = 32, .obstacleLength = 3});
    expect(room().floor(4, 0, 8, 4, 0).wall(4, 0, 4, 4, 0, 1), {.planArea = 32, .parts = 2, .obstacleLength = 4});
  }
  void crossingWalls() {
    expect(room().wall(0, 2, 4, 2, 0, 1).wall(2, 0, 2, 4, 0, 1), {.planArea = 16, .parts = 4, .obstacleLength = 8});
    expect(room().wall(1, 2, 3, 2, 0, 1).wall(2, 1, 2, 3, 0, 1), {.planArea = 16, .obstacleLength = 4});
  }
  void overlappingWalls() {
    expect(room().wall(0, 2, 3, 2, 0, 1).wall(1, 2, 4, 2, 0, 2).wall(0, 2, 4, 2, 0, 1),
           {.planArea = 16, .parts = 2, .obstacleLength = 4});
  }
  void nearlyVerticalWalls() {
    // Leaning by 2^-24: each removes a sliver as wide as it leans on the way to the clearance, from end to end.
    const double lean = 0x1p-24;
    const Soup leaning = room().quad({2, 0, 0}, {2, 4, 0}, {2 + lean, 4, 2}, {2 + lean, 0, 2});
    expect(leaning, {.planArea = 16 - Rational(lean) * 4, .parts = 2});
    const Soup open = room().quad({2, 0, 0}, {2, 3, 0}, {2 + lean, 3, 2}, {2 + lean, 0, 2});
    expect(open, {.planArea = 16 - Rational(lean) * 3});
  }
  void sliverThatRoundingClosesStaysAnObstacle() {
    // Far from the origin, the sliver that the leaning wall removes lies between neighbouring doubles.
    const double x = 0x1p52;
    const Soup soup = Soup()
                          .quad({x - 16, 0, 0}, {x + 16, 0, 0}, {x + 16, 32, 0}, {x - 16, 32, 0})
                          .quad({x, 0, 0}, {x, 32, 0}, {x + 1, 32, 16}, {x + 1, 0, 16});
    const auto environment = soup.environment();
    const auto error = reference::checkProduct(*environment, 45, 2, Rounding::MayClose);
    QVERIFY2(error.empty(), error.c_str());
    const NavigationMesh mesh = navigationMesh(runFilters(environment, minimalPipeline(2)));
    QCOMPARE(countParts(mesh), std::size_t{2});
    QCOMPARE(obstacleLength(mesh), 32.0);
  }

  // --- slopes, contacts, conformity ---
  void rampOf45DegreesAt45Degrees() {
    expect(Soup().ramp(0, 0, 3, 2, 0, 3), {.planArea = 6});
    expect(Soup().ramp(0, 0, 3, 2, 0, std::nextafter(3, 4)), {.planArea = 0, .parts = 0});
    expect(Soup().triangle({0, 0, 0}, {3, 4, 5}, {-4, 3, 0}), {.planArea = Rational(25, 2)});
  }
  void downwardFacesAreNoFloors() { expect(Soup().ceiling(0, 0, 4, 4, 0), {.planArea = 0, .parts = 0}); }
  void tJointsInTheInput() {
    expect(room().triangle({4, 0, 0}, {6, 2, 0}, {4, 1, 0}).triangle({4, 1, 0}, {6, 2, 0}, {4, 4, 0}),
           {.planArea = 20});
    // Both edges have corners on the other one.
    expect(room().floor(4, -1, 5, 3, 0).floor(4, 3, 5, 6, 0), {.planArea = 23});
  }
  void rampsFootInsideAFloorTriangle() {
    // Rises from (1, 1) - (1, 1.5) to 3 at x = 4; the floor below it is lost where it is lower than 2, up to x = 3.
    const Soup soup = Soup().floor(0, 0, 8, 8, 0).ramp(4, 1, 7, 1.5, 0, 3);
    expect(soup, {.planArea = Rational(64) - 1 + Rational(3, 2)});
    // The ramp would be a part of its own without the join at its foot.
    expect(Soup(soup).wall(4, 1, 4, 1.5, 0, 1),
           {.planArea = Rational(64) - 1 + Rational(3, 2), .parts = 2, .obstacleLength = 0.5});
  }
  void rampThatPiercesAFloor() {
    // The ramp rises from -2 at x = 0 to 2 at x = 4, through the floor at x = 2; all of the floor behind that is too
    // low.
    expect(room().ramp(0, 1, 4, 2, -2, 2), {.planArea = Rational(16) - 2 + 2});
    // A wall stands there: the floor before it, the two sides behind it, the ramp.
    expect(room().ramp(0, 1, 4, 2, -2, 2).wall(2, 0, 2, 4, 0, 1), {.planArea = 16, .parts = 4, .obstacleLength = 4});
  }
  void pavementThatEndsOnTheGround() {
    // A slab whose upper side comes down to the ground in a line inside it.
    expect(Soup().floor(0, 0, 8, 8, 0).floor(1, 1, 3, 3, 0.5).quad({3, 1, 0.5}, {5, 1, 0}, {5, 3, 0}, {3, 3, 0.5}),
           {.planArea = 64});
  }
  void stairs() {
    // Treads 1 deep with risers of 0.5 are parts of their own: a step is no ramp.
    Soup soup;
    for (int i = 0; i < 4; ++i) soup.floor(i, 0, i + 1, 2, 0.5 * i).wall(i + 1, 0, i + 1, 2, 0.5 * i, 0.5 * i + 0.5);
    expect(soup, {.planArea = 8, .parts = 4});
  }
  void stairsAsShallowRamps() {
    Soup soup;
    for (int i = 0; i < 4; ++i) soup.floor(2 * i, 0, 2 * i + 1, 2, i).ramp(2 * i + 1, 0, 2 * i + 2, 2, i, i + 1);
    expect(soup, {.planArea = 16});
  }

  // --- overlap in one plane ---
  void coplanarOverlapIsKeptOnceAndJoined() {
    expect(Soup().floor(0, 0, 4, 4, 0).floor(2, 2, 6, 6, 0), {.planArea = 28});
    expect(Soup().triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0}).triangle({1, 1, 0}, {4, 1, 0}, {4, 4, 0}),
           {.planArea = 8 + Rational(9, 2) - 1});
    expect(Soup().floor(0, 0, 4, 4, 0).floor(1, 1, 2, 2, 0), {.planArea = 16});
  }
  void coplanarOverlapOnASlope() { expect(Soup().ramp(0, 0, 4, 4, 0, 2).ramp(2, 2, 6, 6, 1, 3), {.planArea = 28}); }
  void coincidentTwins() {
    expect(room().floor(0, 0, 4, 4, 0), {.planArea = 16});
    expect(room().add(room()).add(room()).wall(0, 2, 4, 2, 0, 1).wall(0, 2, 4, 2, 0, 1),
           {.planArea = 16, .parts = 2, .obstacleLength = 4});
    expect(room().quad({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}).triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0}),
           {.planArea = 16});
  }
  void coplanarRejectedTriangleRemovesNothing() { expect(room().ceiling(1, 1, 3, 3, 0), {.planArea = 16}); }

  // --- slivers ---
  void sliverTriangles() {
    const double thin = 0x1p-20;
    expect(room().triangle({0, 1, 1}, {4, 1, 1}, {2, 1 + thin, 1}), {.planArea = 16, .parts = 3, .obstacleLength = 0});
    expect(Soup().triangle({0, 0, 0}, {1024, 0, 0}, {1024, thin, 0}).triangle({0, 0, 0}, {1024, thin, 0}, {0, 1, 0}),
           {.planArea = Rational(thin) * 512 + 512});
  }

  // --- layers ---
  void spiralRampOverItself() {
    // Eight flights around a pillar, each rises 1: after four it is above itself, 4 higher.
    Soup soup;
    const std::array<std::array<double, 2>, 4> inner{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
    for (int i = 0; i < 8; ++i) {
      const auto& a = inner[static_cast<std::size_t>(i % 4)];
      const auto& b = inner[static_cast<std::size_t>((i + 1) % 4)];
      const double z = i;
      soup.quad({a[0], a[1], z}, {3 * a[0], 3 * a[1], z}, {3 * b[0], 3 * b[1], z + 1}, {b[0], b[1], z + 1});
    }
    expect(soup, {.planArea = 64});
    const NavigationMesh mesh =
        navigationMesh(runFilters(soup.environment(), minimalPipeline(2) + "LayerSubdivisionFilter\n"));
    QCOMPARE(mesh.layerCount, 2u);
    QCOMPARE(mesh.connections.size(), std::size_t{1});
    QCOMPARE(countParts(mesh), std::size_t{1});
  }
  void twoFloorsAndARamp() {
    const Soup soup = Soup()
                          .floor(0, 0, 8, 4, 0)
                          .floor(0, 0, 8, 4, 4)
                          .ramp(8, 0, 12, 4, 0, 4)
                          .floor(12, 0, 14, 4, 4)
                          .floor(8, 4, 14, 6, 4)
                          .floor(0, 4, 8, 6, 4);
    expect(soup, {.planArea = 32 + 32 + 16 + 8 + 12 + 16});
    const NavigationMesh mesh =
        navigationMesh(runFilters(soup.environment(), minimalPipeline(2) + "LayerSubdivisionFilter\n"));
    QCOMPARE(mesh.layerCount, 2u);
    QCOMPARE(mesh.connections.size(), std::size_t{1});
  }
  void separateFloorsNeedNoConnections() {
    const NavigationMesh mesh =
        navigationMesh(runFilters(Soup().floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, 3).floor(5, 0, 6, 4, 1).environment(),
                                  minimalPipeline(2) + "LayerSubdivisionFilter\n"));
    QCOMPARE(mesh.layerCount, 2u);
    QVERIFY(mesh.connections.empty());
    QVERIFY2(findMeshError(mesh).empty(), findMeshError(mesh).c_str());
  }

  // --- size ---
  void oneGiantGroundTriangleUnderTenThousandObstacles() {
    // 100 x 100 signs of 1 x 1 at height 1, two apart; the ground is one triangle that holds them all.
    Soup soup = Soup().triangle({-1, -1, 0}, {1023, -1, 0}, {-1, 1023, 0});
    for (int i = 0; i < 100; ++i)
      for (int j = 0; j < 100; ++j) soup.ceiling(2 * i, 2 * j, 2 * i + 1, 2 * j + 1, 1);
    const auto environment = soup.environment();
    QElapsedTimer timer;
    timer.start();
    const StatePtr state = runFilters(environment, minimalPipeline(2));
    const NavigationMesh mesh = navigationMesh(state);
    qInfo("%lld ms", static_cast<long long>(timer.elapsed()));
    Rational twice = 0;
    for (const auto& piece : reference::toPieces(exactWalkableTriangles(*state))) twice += twiceArea(piece.plan);
    QVERIFY(twice == Rational(1024) * 1024 - 20000);
    QCOMPARE(countParts(mesh), std::size_t{1});
    QVERIFY2(findMeshError(mesh).empty(), findMeshError(mesh).c_str());
    QCOMPARE(planArea(mesh), (1024.0 * 1024 - 20000) / 2);
    QVERIFY(mesh.obstacleEdges.empty());
  }
};

QTEST_APPLESS_MAIN(TestHandmade)
#include "test_handmade.moc"
