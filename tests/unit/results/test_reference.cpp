// The reference itself on known answers, and against the definition point by point.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>

#include "tests/reference/walkable_area.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::test;
using namespace footfall::reference;

namespace {

Rational planArea(const WalkableArea& area) { return Rational(twiceArea(area) / 2); }

WalkableArea walkable(const Soup& soup, double clearance = 2, double slope = 45) {
  return computeWalkableArea(*soup.environment(), {slope, clearance});
}

std::size_t partsOf(const WalkableArea& area) {
  return countParts(reference::connectedParts(area, findMeetings(area)));
}

double blocked(const WalkableArea& area) {
  double sum = 0;
  for (const Meeting& m : findMeetings(area)) sum += m.blockedLength;
  return sum;
}

}  // namespace

class TestReference : public QObject {
  Q_OBJECT
 private slots:
  void polygons() {
    const Polygon square{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, triangle{{1, 1}, {3, 1}, {1, 3}};
    QVERIFY(twiceArea(square) == 8);
    QVERIFY(twiceCommonArea(square, triangle) == 2);
    Rational left = 0;
    for (const Polygon& piece : subtract({square}, triangle)) left += twiceArea(piece);
    QVERIFY(left == 6);
    QVERIFY(intersection(square, {{2, 0}, {3, 0}, {3, 1}}).empty());
    QVERIFY(cleaned({{0, 0}, {1, 0}, {2, 0}}).empty());
    QCOMPARE(cleaned({{0, 0}, {1, 0}, {2, 0}, {0, 1}}).size(), std::size_t{3});
  }

  // Turns that doubles cannot decide, and numbers that they cannot even hold.
  void turns() {
    const auto number = [](const char* text) { return Rational(text); };
    const Rational third(1, 3), tiny = number("1/1000000000000000000000000000000000000000000000000000000000000"),
                                huge = 1 / tiny, least = tiny * tiny * tiny * tiny * tiny * tiny, most = 1 / least;
    for (const Rational& size : {Rational(1), third, tiny, huge, least, most, Rational(third * most)}) {
      const Point2 a{-size, -third * size}, b{2 * size, Rational(2 * third * size)};
      QCOMPARE(turn(a, b, {0, 0}), 0);
      QCOMPARE(turn(b, a, {0, 0}), 0);
      for (const Rational& part : {Rational(1), Rational(1, 1000), tiny, least}) {
        const Rational off = size * part;
        QCOMPARE(turn(a, b, {0, off}), 1);
        QCOMPARE(turn(b, a, {0, off}), -1);
        QCOMPARE(turn(a, b, {off, 0}), -1);
        QVERIFY(mayTouch(boxOf(Segment2{{0, 0}, {off, off}}), boxOf(Segment2{{off, off}, {size, size}})));
      }
    }
    QVERIFY(!mayTouch(boxOf(Segment2{{0, 0}, {1, 1}}), boxOf(Segment2{{0, 2}, {1, 3}})));
    QVERIFY(!mayTouch(boxOf(Segment2{{-3, 0}, {-2, 1}}), boxOf(Segment2{{-1, 0}, {1, 1}})));
    QVERIFY(!mayTouch(boxOf(Polygon{}), boxOf(Segment2{{-1, 0}, {1, 1}})));
  }

  void segments() {
    const Segment2 s{{0, 0}, {4, 0}};
    QVERIFY(!commonPart(s, {{4, 0}, {5, 0}}));
    QVERIFY(!commonPart(s, {{0, 0}, {4, 1}}));
    QVERIFY((commonPart(s, {{5, 0}, {3, 0}})->from == Point2{3, 0}));
    QCOMPARE(uncoveredParts(s, {{{1, 0}, {2, 0}}, {{2, 0}, {3, 0}}}).size(), std::size_t{2});
    QVERIFY(uncoveredParts(s, {{{3, 0}, {-1, 0}}, {{2, 0}, {9, 0}}}).empty());
    QVERIFY(passesThrough(s, {{1, -1}, {2, -1}, {2, 1}}));
    QVERIFY(!passesThrough(s, {{1, 0}, {2, 0}, {2, 1}}));
  }

  void slopes() {
    const auto ramp = [](double rise) { return cornersOf(*Soup().ramp(0, 0, 1, 1, 0, rise).environment(), 0); };
    QVERIFY(isWithinSlope(ramp(1), 45));
    QVERIFY(!isWithinSlope(ramp(std::nextafter(1, 2)), 45));
    QVERIFY(isWithinSlope(ramp(std::tan(std::atan(1.0) / 2) - 1e-9), 22.5));
    QVERIFY(!isWithinSlope(ramp(std::tan(std::atan(1.0) / 2) + 1e-9), 22.5));
    QVERIFY(isWithinSlope(ramp(0), 1e-6));
  }

  void tableOverFloor() {
    const Soup soup = Soup().floor(0, 0, 10, 10, 0).floor(2, 2, 5, 4, 1);
    QVERIFY(planArea(walkable(soup)) == 100);
    QVERIFY(planArea(walkable(soup, 1)) == 106);
    QCOMPARE(partsOf(walkable(soup)), std::size_t{2});
  }

  void wallWithDoor() {
    const Soup soup = Soup().floor(0, 0, 4, 4, 0).wall(0, 2, 1, 2, 0, 3).wall(2, 2, 4, 2, 0, 3);
    QCOMPARE(partsOf(walkable(soup)), std::size_t{1});
    QCOMPARE(blocked(walkable(soup)), 3.0);
    const Soup closed = Soup(soup).wall(1, 2, 2, 2, 1, 3);
    QCOMPARE(partsOf(walkable(closed)), std::size_t{2});
    QCOMPARE(partsOf(walkable(closed, 1)), std::size_t{1});
  }

  void coplanarOverlap() {
    const Soup soup = Soup().floor(0, 0, 2, 2, 0).floor(1, 1, 3, 3, 0).floor(1, 1, 3, 3, 0);
    QVERIFY(planArea(walkable(soup)) == 7);
    QCOMPARE(partsOf(walkable(soup)), std::size_t{1});
  }

  void rampThroughFloor() {
    // The ramp rises at 1:2 from -1 at x = 0 to 1 at x = 4; agents of height 1 walk on it from x = 2.
    const Soup soup = Soup().floor(0, 0, 4, 2, 0).ramp(0, 0, 4, 2, -1, 1);
    const auto area = walkable(soup, 1);
    QVERIFY(planArea(area) == 8);
    QCOMPARE(partsOf(area), std::size_t{1});
    QCOMPARE(blocked(area), 0.0);
  }

  void degenerateTrianglesContributeNothing() {
    const Soup soup = Soup().floor(0, 0, 4, 4, 0).triangle({0, 2, 1}, {4, 2, 1}, {2, 2, 1});
    QCOMPARE(partsOf(walkable(soup)), std::size_t{1});
  }

  void agreesWithTheDefinitionPointByPoint() {
    // Points with large odd denominators: on no edge of a grid soup, nor on a line between heights.
    QVERIFY(check("points", 3000, [] {
      const auto environment = soupOf(*gridTriangles(8, 4, 3)).environment();
      const double clearance = *below(2) == 0 ? 1 : 1.5;
      const auto area = computeWalkableArea(*environment, {60, clearance});
      const auto weights = *numbersBelow<2>(1 << 18);
      for (const Region& region : area.regions) {
        for (const std::uint32_t floor : region.floors) {
          const auto corners = cornersOf(*environment, floor);
          Rational u(weights[0], 262147), v(weights[1], 262151);
          u.canonicalize();
          v.canonicalize();
          if (u + v >= 1 || u == 0 || v == 0) continue;
          const auto mix = [&](const Rational& a, const Rational& b, const Rational& c) {
            return Rational(a + u * (b - a) + v * (c - a));
          };
          const Point2 p{mix(corners[0].x, corners[1].x, corners[2].x), mix(corners[0].y, corners[1].y, corners[2].y)};
          int inside = 0;
          for (const Polygon& cell : region.cells) {
            bool in = true;
            for (std::size_t k = 0; k < cell.size(); ++k)
              in = in && leftOf(cell[k], cell[(k + 1) % cell.size()]).at(p) > 0;
            inside += in;
          }
          RC_ASSERT(inside == static_cast<int>(isFree(*environment, floor, p, clearance)));
        }
      }
    }));
  }
};

QTEST_APPLESS_MAIN(TestReference)
#include "test_reference.moc"
