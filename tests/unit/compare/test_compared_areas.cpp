// Comparing meshes as exact sets: areas and heights against rationals, whatever the triangulation.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>
#include <limits>
#include <random>

#include "tests/reference/plan_geometry.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/compare/compared_soups.hpp"

using namespace footfall;
using namespace footfall::test;

namespace {

/// The same triangle in pieces: halved at the middle of a side, or in three around a point inside; coordinates that are
/// small whole numbers stay exact. Sides that other triangles share are halved on one side only: T-joints.
void addPieces(const Corners& t, int depth, std::mt19937& random, std::vector<Corners>& pieces) {
  const unsigned kind = depth == 0 ? 3 : random() % 4;
  if (kind == 3) {
    pieces.push_back(t);
  } else if (kind == 2) {
    const Vec3 inside = mix(mix(t[0], t[1], 0.5), t[2], 0.5);
    for (std::size_t k = 0; k < 3; ++k) addPieces({t[k], t[(k + 1) % 3], inside}, depth - 1, random, pieces);
  } else {
    const std::size_t k = random() % 3;
    const Vec3 point = mix(t[k], t[(k + 1) % 3], kind == 0 ? 0.5 : 0.25);
    addPieces({t[k], point, t[(k + 2) % 3]}, depth - 1, random, pieces);
    addPieces({point, t[(k + 1) % 3], t[(k + 2) % 3]}, depth - 1, random, pieces);
  }
}

Soup retriangulated(const Soup& soup, std::mt19937& random) {
  std::vector<Corners> pieces;
  for (const Corners& t : soup.triangles()) addPieces(t, 4, random, pieces);
  std::shuffle(pieces.begin(), pieces.end(), random);
  Soup result;
  for (Corners& piece : pieces) {
    std::rotate(piece.begin(), piece.begin() + random() % 3, piece.end());
    if (random() % 4 == 0) std::swap(piece[0], piece[1]);  // sets have no sides
    result.triangle(piece[0], piece[1], piece[2]);
  }
  return result;
}

/// Planes whose points over whole numbers are doubles, one of them vertical.
Vec3 inPlane(int plane, double x, double y) {
  switch (plane % 4) {
    case 0:
      return {x, y, 1};
    case 1:
      return {x, y, x / 2 + y / 4 - 3};
    case 2:
      return {x, y, 1e6 - 3 * x + y};
    default:
      return {x + y, x + y, x - y};
  }
}

using Numbers = std::vector<std::array<int, 7>>;

rc::Gen<Numbers> planarTriangles(int count, int size) {
  return upTo(count, rc::gen::map(numbersBelow<7>(1 << 20), [=](std::array<int, 7> n) {
                for (std::size_t i = 1; i < 7; ++i) n[i] %= size;
                return n;
              }));
}

Soup inPlanes(const Numbers& numbers, int planes) {
  Soup soup;
  for (const auto& n : numbers) {
    const int plane = n[0] % planes;
    soup.triangle(inPlane(plane, n[1], n[2]), inPlane(plane, n[3], n[4]), inPlane(plane, n[5], n[6]));
  }
  return soup;
}

reference::Rational area(const std::vector<reference::Polygon>& pieces) {
  reference::Rational sum = 0;
  for (const auto& piece : pieces) sum += reference::twiceArea(piece) / 2;
  return sum;
}

/// The part of the polygons in the plan, each place once, outside of all holes.
reference::Rational areaWithout(const std::vector<reference::Polygon>& polygons,
                                const std::vector<reference::Polygon>& holes) {
  reference::Rational sum = 0;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (polygons[i].empty()) continue;
    std::vector<reference::Polygon> pieces = {polygons[i]};
    for (std::size_t k = 0; k < i; ++k) pieces = reference::subtract(pieces, polygons[k]);
    for (const auto& hole : holes) pieces = reference::subtract(pieces, hole);
    sum += area(pieces);
  }
  return sum;
}

std::array<reference::Point3, 3> pointsOf(const Corners& t) {
  return {reference::toPoint(t[0]), reference::toPoint(t[1]), reference::toPoint(t[2])};
}

std::vector<reference::Polygon> planTriangles(const Soup& soup) {
  std::vector<reference::Polygon> result;
  for (const Corners& t : soup.triangles())
    if (auto polygon = reference::planTriangle(pointsOf(t)); !polygon.empty()) result.push_back(polygon);
  return result;
}

/// The uncovered area in the plan, triangle by triangle, from the definition.
reference::Rational uncoveredFromDefinition(const Soup& a, const Soup& b, const reference::Rational& height) {
  reference::Rational sum = 0;
  for (const Corners& t : a.triangles()) {
    const auto polygon = reference::planTriangle(pointsOf(t));
    if (polygon.empty()) continue;
    const auto plane = reference::planeThrough(pointsOf(t));
    std::vector<reference::Polygon> pieces = {polygon};
    for (const Corners& other : b.triangles()) {
      const auto shadow = reference::planTriangle(pointsOf(other));
      if (!reference::mayTouch(polygon, shadow)) continue;
      const auto over = reference::planeThrough(pointsOf(other));
      const reference::Linear above{over->a - plane->a, over->b - plane->b, over->c - plane->c};
      const auto near = reference::clip(reference::clip(shadow, {-above.a, -above.b, height - above.c}),
                                        {above.a, above.b, above.c + height});
      if (!near.empty()) pieces = reference::subtract(pieces, near);
    }
    sum += area(pieces);
  }
  return sum;
}

}  // namespace

class TestComparedAreas : public QObject {
  Q_OBJECT
 private slots:
  void equalWhateverTheTriangulation();
  void equalWhereOneOverlapsItself();
  void oneUlpWithinThePlane();
  void oneUlpOutOfThePlane();
  void areasAsRationalsSay();
  void areasOnOddCoordinates();
  void heightsAsRationalsSay();
  void storeysDoNotCoverEachOther();
  void layersOneByOne();
};

void TestComparedAreas::equalWhateverTheTriangulation() {
  QVERIFY(check("equal in other triangulations", 150, [](unsigned seed) {
    std::mt19937 random(seed);
    Soup soup;
    for (int i = 0; i < 12; ++i) {
      const int plane = static_cast<int>(random() % 4);
      const double x = 16 * (random() % 5), y = 16 * (random() % 5), w = 16 + 16 * (random() % 2);
      soup.quad(inPlane(plane, x, y), inPlane(plane, x + w, y), inPlane(plane, x + w, y + 16),
                inPlane(plane, x, y + 16));
    }
    const auto c = compare(retriangulated(soup, random), retriangulated(soup, random));
    RC_ASSERT(isEqualInAll(c));
    RC_ASSERT(isNear(c.sets.areas[2].surface, compare(soup, soup).sets.areas[2].surface));
  }));
}

void TestComparedAreas::equalWhereOneOverlapsItself() {
  const Soup once = Soup().floor(0, 0, 4, 4, 0);
  const Soup twice = Soup().floor(0, 0, 3, 4, 0).floor(1, 0, 4, 4, 0).floor(1, 1, 2, 2, 0);
  QVERIFY(isEqualInAll(compare(once, twice)));
  QVERIFY(isEqualInAll(compare(twice, once)));
  const auto c = compare(once, twice);
  QCOMPARE(c.sets.areas[2].surface, 16.0);
  QCOMPARE(c.meshes[1].whole.areas.surface, 25.0);  // triangles added up
  QCOMPARE(*c.areaRatio(), 25.0 / 16);
  // The piece that both have is not the reason that the rest is covered.
  const auto hole = compare(Soup().floor(0, 0, 4, 4, 0).floor(0, 0, 1, 1, 0), Soup().floor(0, 0, 1, 1, 0));
  QCOMPARE(hole.sets.areas[0].surface, 15.0);
  QVERIFY(!hole.sets.hasArea[1]);
}

void TestComparedAreas::oneUlpWithinThePlane() {
  const double beyond = std::nextafter(1.0, 2.0);
  const Soup square = Soup().quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  const Soup moved = Soup().quad({0, 0, 0}, {1, 0, 0}, {beyond, 1, 0}, {0, 1, 0});
  const auto c = compare(square, moved);
  QVERIFY(!c.equal() && !c.sets.hasArea[0] && c.sets.hasArea[1]);
  QCOMPARE(c.sets.areas[0].surface, 0.0);
  QVERIFY(isNear(c.sets.areas[1].surface, (beyond - 1) / 2));
  QCOMPARE(c.sets.areas[2].surface, 1.0);
  QCOMPARE(c.distances->at(0).max, 0.0);
  QVERIFY(isNear(c.distances->at(1).max, beyond - 1, 0.01));
}

void TestComparedAreas::oneUlpOutOfThePlane() {
  const Soup square = Soup().quad({0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1});
  const Soup moved = Soup().quad({0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, std::nextafter(1.0, 2.0)});
  const auto exact = compare(square, moved, 0.0);
  QVERIFY(exact.sets.hasArea[0] && exact.sets.hasArea[1]);
  QCOMPARE(exact.sets.areas[0].surface, 0.5);
  QCOMPARE(exact.meshes[0].whole.uncovered.plan, 0.5);
  QVERIFY(isNear(exact.sets.areas[1].surface, 0.5));
  // The default height serves this case.
  const auto usual = compare(square, moved);
  QVERIFY(!usual.equal());
  QCOMPARE(usual.meshes[0].whole.uncovered.plan, 0.0);
  QCOMPARE(usual.meshes[1].whole.uncovered.plan, 0.0);
  QCOMPARE(usual.covered(), 1.0);
  QVERIFY(usual.distances->at(1).upper < 1e-8);
}

void TestComparedAreas::areasAsRationalsSay() {
  QVERIFY(check("areas of random triangles in one plane", 300, [] {
    const Soup a = inPlanes(*planarTriangles(9, 8), 1), b = inPlanes(*planarTriangles(9, 8), 1);
    const auto c = compare(a, b);
    const auto planA = planTriangles(a), planB = planTriangles(b);
    const auto onlyA = areaWithout(planA, planB), onlyB = areaWithout(planB, planA);
    RC_ASSERT(c.sets.hasArea[0] == (onlyA > 0));
    RC_ASSERT(c.sets.hasArea[1] == (onlyB > 0));
    RC_ASSERT(isNear(c.sets.areas[0].surface, onlyA.get_d()));
    RC_ASSERT(isNear(c.sets.areas[1].surface, onlyB.get_d()));
    RC_ASSERT(isNear(c.sets.areas[2].plan, reference::Rational(areaWithout(planA, {}) - onlyA).get_d()));
  }));
  QVERIFY(check("several planes are several times one plane", 100, [] {
    const Numbers a = *planarTriangles(12, 6), b = *planarTriangles(12, 6);
    const auto together = compare(inPlanes(a, 4), inPlanes(b, 4));
    double sum = 0;
    for (int plane = 0; plane < 4; ++plane) {
      Numbers partA, partB;
      for (const auto& n : a)
        if (n[0] % 4 == plane) partA.push_back({0, n[1], n[2], n[3], n[4], n[5], n[6]});
      for (const auto& n : b)
        if (n[0] % 4 == plane) partB.push_back({0, n[1], n[2], n[3], n[4], n[5], n[6]});
      const double stretch = std::array{1.0, std::sqrt(21.0 / 16), std::sqrt(11.0), std::sqrt(8.0)}[plane];
      sum += stretch * compare(inPlanes(partA, 1), inPlanes(partB, 1)).sets.areas[0].surface;
    }
    RC_ASSERT(isNear(together.sets.areas[0].surface, sum, 1e-12));
  }));
}

void TestComparedAreas::areasOnOddCoordinates() {
  QVERIFY(check("areas of thin triangles on any doubles", 200, [](unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-1000, 1000), small(-1e-9, 1e-9);
    std::vector<Vec3> points;
    for (int i = 0; i < 6; ++i) points.push_back({place(random), place(random), 0});
    for (int i = 0; i < 6; ++i) points.push_back({points[i].x + small(random), points[i].y + small(random), 0});
    Soup a, b;
    for (int i = 0; i < 5; ++i) {
      a.triangle(points[random() % 12], points[random() % 12], points[random() % 12]);
      b.triangle(points[random() % 12], points[random() % 12], points[random() % 12]);
    }
    const auto c = compare(a, b);
    const auto onlyA = areaWithout(planTriangles(a), planTriangles(b));
    RC_ASSERT(c.sets.hasArea[0] == (onlyA > 0));
    RC_ASSERT(isNear(c.sets.areas[0].surface, onlyA.get_d()));
    RC_ASSERT(isNear(c.meshes[0].whole.uncovered.plan, uncoveredFromDefinition(a, b, 1).get_d(), 1e-12));
  }));
}

void TestComparedAreas::heightsAsRationalsSay() {
  QVERIFY(check("what heights cover", 250, [] {
    const Soup a = soupOf(*gridTriangles(6, 7, 4)), b = soupOf(*gridTriangles(6, 7, 4));
    const double height = *rc::gen::elementOf(std::vector<double>{0, 0.5, 1, 1.3});
    const auto c = compare(a, b, height);
    const double expected = uncoveredFromDefinition(a, b, reference::Rational(height)).get_d();
    RC_ASSERT(std::fabs(c.meshes[0].whole.uncovered.plan - expected) <= 1e-12);
    if (expected == 0) RC_ASSERT(c.meshes[0].whole.uncovered.plan <= 1e-40);
  }));
}

void TestComparedAreas::storeysDoNotCoverEachOther() {
  const Soup storeys = Soup().floor(0, 0, 8, 8, 0).floor(0, 0, 8, 8, 3).floor(0, 0, 8, 8, 6);
  const Soup missing = Soup().floor(0, 0, 8, 8, 0).floor(0, 0, 4, 8, 3).floor(0, 0, 8, 8, 6.25);
  const auto strict = compare(storeys, missing, 0.2);
  QCOMPARE(strict.meshes[0].whole.uncovered.plan, 32.0 + 64);
  QCOMPARE(strict.meshes[1].whole.uncovered.plan, 64.0);
  const auto loose = compare(storeys, missing, 0.25);  // reached is covered
  QCOMPARE(loose.meshes[0].whole.uncovered.plan, 32.0);
  QCOMPARE(loose.meshes[1].whole.uncovered.plan, 0.0);
  QCOMPARE(loose.covered(), 1 - 32.0 / 192);
  // A ramp leaves its floor's height in the middle.
  const auto ramp = compare(Soup().floor(0, 0, 8, 2, 0), Soup().ramp(0, 0, 8, 2, 0, 2), 1);
  QCOMPARE(ramp.meshes[0].whole.uncovered.plan, 8.0);
}

void TestComparedAreas::layersOneByOne() {
  NavigationMesh a = meshOf(Soup().floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, 3));
  a.layers = {0, 0, 1, 1};
  a.layerCount = 2;
  const auto c = compare(a, meshOf(Soup().floor(0, 0, 4, 4, 0).floor(0, 0, 4, 1, 3)));
  QCOMPARE(c.meshes[0].layers.size(), std::size_t{2});
  QCOMPARE(c.meshes[0].layers[0].uncovered.plan, 0.0);
  QCOMPARE(c.meshes[0].layers[1].uncovered.plan, 12.0);
  QCOMPARE(c.meshes[0].layers[1].areas.plan, 16.0);
  QCOMPARE(c.meshes[0].layers[1].triangles, std::size_t{2});
  QVERIFY(c.meshes[1].layers.empty());
}

QTEST_GUILESS_MAIN(TestComparedAreas)
#include "test_compared_areas.moc"
