// The strip of a gap against comparing every side, and how few needles beside it are left.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include "core/filters/steps/gap_strip.hpp"

using namespace footfall::detail;

namespace {

using Place = GapStrip::Place;
using Triangle = std::array<Place, 3>;

double areaOf(const Place& a, const Place& b, const Place& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Exact for small whole numbers. The corners go around, either way.
template <std::size_t N>
bool isInside(const Place& p, const std::array<Place, N>& corners) {
  bool isLeft = false, isRight = false;
  Place lower = corners[0], upper = corners[0];
  for (std::size_t i = 0; i < N; ++i) {
    const double area = areaOf(corners[i], corners[(i + 1) % N], p);
    isLeft = isLeft || area > 0;
    isRight = isRight || area < 0;
    for (std::size_t k = 0; k < 2; ++k) {
      lower[k] = std::min(lower[k], corners[i][k]);
      upper[k] = std::max(upper[k], corners[i][k]);
    }
  }
  return !(isLeft && isRight) && p[0] >= lower[0] && p[0] <= upper[0] && p[1] >= lower[1] && p[1] <= upper[1];
}

bool doCross(const Place& a, const Place& b, const Place& c, const Place& d) {
  const auto sign = [](double x) { return (x > 0) - (x < 0); };
  return sign(areaOf(a, b, c)) * sign(areaOf(a, b, d)) < 0 && sign(areaOf(c, d, a)) * sign(areaOf(c, d, b)) < 0;
}

/// The corners of the strip go around.
bool haveCommonPoint(const std::array<Place, 4>& strip, const Triangle& triangle) {
  for (const Place& p : strip)
    if (isInside(p, triangle)) return true;
  for (const Place& p : triangle)
    if (isInside(p, strip)) return true;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (doCross(strip[i], strip[(i + 1) % 4], triangle[k], triangle[(k + 1) % 3])) return true;
  return false;
}

}  // namespace

class TestGapStrip : public QObject {
  Q_OBJECT

 private slots:
  void noTriangleThatTouchesIsLeftOut();
  void marginIsKept();
  void planesOffTheRoomAreFound();
  void noPlaneThroughTheRoomIsLeftOut();
  void fewNeedlesAreLeft();
};

// Triangles of all sizes, needles, walls and those that are one place among them.
void TestGapStrip::noTriangleThatTouchesIsLeftOut() {
  std::mt19937 random(7);
  const auto number = [&](int size) { return static_cast<double>(static_cast<int>(random() % (2 * size + 1)) - size); };
  int touched = 0, leftOut = 0;
  for (int n = 0; n < 50'000; ++n) {
    const double low = number(30), high = low + 1 + std::fabs(number(30)), first = number(30), second = number(30);
    const std::array<Place, 4> around{
        {{low, first}, {high, second}, {high, second + std::fabs(number(5))}, {low, first + std::fabs(number(5))}}};
    const int size = 1 << random() % 8;
    const Place at{number(40), number(40)};
    Triangle triangle;
    for (Place& p : triangle) p = {at[0] + number(size), at[1] + number(size)};
    if (random() % 4 == 0) triangle[2] = {triangle[1][0] + number(1), triangle[1][1]};
    if (random() % 8 == 0) triangle[2] = triangle[1];
    const bool isLeftOut = GapStrip({around[0], around[1], around[3], around[2]}, 0).isBeyondSide(triangle);
    const bool doesTouch = haveCommonPoint(around, triangle);
    QVERIFY2(!isLeftOut || !doesTouch, qPrintable(QString("triangle %1").arg(n)));
    touched += doesTouch ? 1 : 0;
    leftOut += isLeftOut ? 1 : 0;
  }
  QVERIFY(touched > 2'000);
  QVERIFY(leftOut > 5'000);
}

void TestGapStrip::marginIsKept() {
  const GapStrip strip({{{0, 0}, {4, 0}, {0, 1}, {4, 1}}}, 0.5);
  const auto above = [](double y) { return Triangle{{{-9, y}, {20, y}, {3, y + 7}}}; };
  QVERIFY(!strip.isBeyondSide(above(1.5)));
  QVERIFY(strip.isBeyondSide(above(1.75)));
  const Triangle turned{{{-9, 1.75}, {3, 8.75}, {20, 1.75}}}, wall{{{-9, 1.75}, {20, 1.75}, {3, 1.75}}};
  QVERIFY(strip.isBeyondSide(turned));
  QVERIFY(strip.isBeyondSide(wall));
  QVERIFY(!strip.isBeyondSide({{{9, 9}, {9, 9}, {9, 9}}}));  // it has no side
  QVERIFY(!strip.isBeyondSide({{{-9, 1.75}, {std::nan(""), 1.75}, {3, 8}}}));
}

// A needle whose end is as high as the room, over a strip where it is far lower.
void TestGapStrip::planesOffTheRoomAreFound() {
  const GapStrip strip({{{0, 0}, {4, 0}, {0, 1}, {4, 1}}}, 0.125);
  const Triangle needle{{{-1, 0.25}, {40, 0.25}, {40, 0.75}}}, turned{needle[0], needle[2], needle[1]};
  const GapStrip::Heights room{{1, 1}, {3, 3}};
  for (const Triangle& t : {needle, turned}) {
    QVERIFY(strip.isOffPlane(t, {0, 2, 2}, room));
    QVERIFY(!strip.isOffPlane(t, {0, 20, 20}, room));
    QVERIFY(strip.isOffPlane(t, {5, 5, 5}, room));
    QVERIFY(!strip.isOffPlane(t, {3.0625, 3.0625, 3.0625}, room));
    QVERIFY(!strip.isOffPlane(t, {0.9375, 0.9375, 0.9375}, room));
    QVERIFY(!strip.isOffPlane(t, {5, std::nan(""), 5}, room));
  }
  QVERIFY(!strip.isOffPlane(needle, {1, 5, 5}, {{1, 5}, {3, 7}}));
  QVERIFY(!strip.isOffPlane({needle[0], needle[1], needle[1]}, {9, 9, 9}, room));  // it has no plane
}

// Places inside triangles and inside the room, with weights that are exact.
void TestGapStrip::noPlaneThroughTheRoomIsLeftOut() {
  std::mt19937 random(9);
  const auto number = [&](int size) { return static_cast<double>(static_cast<int>(random() % (2 * size + 1)) - size); };
  const std::array<Place, 4> corners{{{0, 0}, {16, 4}, {0, 8}, {16, 12}}};
  const GapStrip::Heights room{{2, 6}, {6, 14}};
  const GapStrip strip(corners, 0);
  int touched = 0, leftOut = 0;
  for (int n = 0; n < 50'000; ++n) {
    const int size = 1 << (1 + random() % 7);
    Triangle t;
    std::array<double, 3> z{};
    const double x = number(30), y = number(30), height = number(30);
    for (std::size_t k = 0; k < 3; ++k) {
      t[k] = {x + number(size), y + number(size)};
      z[k] = height + number(size);
    }
    bool doesTouch = false;
    for (int i = 0; i <= 16; ++i)
      for (int k = 0; i + k <= 16; ++k) {
        const auto mix = [&](double a, double b, double c) { return (i * a + k * b + (16 - i - k) * c) / 16; };
        const double px = mix(t[0][0], t[1][0], t[2][0]), py = mix(t[0][1], t[1][1], t[2][1]),
                     pz = mix(z[0], z[1], z[2]);
        doesTouch = doesTouch ||
                    (px >= 0 && px <= 16 && py >= px / 4 && py <= 8 + px / 4 && pz >= 2 + px / 4 && pz <= 6 + px / 2);
      }
    const bool isLeftOut = strip.isOffPlane(t, z, room);
    QVERIFY2(!isLeftOut || !doesTouch, qPrintable(QString("triangle %1").arg(n)));
    touched += doesTouch ? 1 : 0;
    leftOut += isLeftOut ? 1 : 0;
  }
  QVERIFY(touched > 1'000);
  QVERIFY(leftOut > 1'000);
}

// A strip between two neighbours of 5,000 needles around one place. The boxes of a thousand of them touch its box.
void TestGapStrip::fewNeedlesAreLeft() {
  constexpr int kNeedles = 5'000;
  const auto rim = [](double i, double radius) {
    const double angle = 2 * std::numbers::pi * i / kNeedles;
    return Place{radius * std::cos(angle), radius * std::sin(angle)};
  };
  const Place near = rim(625, 10), far = rim(625, 49), otherNear = rim(625.5, 10), otherFar = rim(625.5, 49);
  const GapStrip strip({near, far, otherNear, otherFar}, 0x1p-20);
  int boxes = 0, left = 0;
  for (int i = 0; i < kNeedles; ++i) {
    const Triangle needle{{{0, 0}, rim(i, 50), rim(i + 1, 50)}};
    const Place upper{std::max({0.0, needle[1][0], needle[2][0]}), std::max({0.0, needle[1][1], needle[2][1]})};
    boxes += upper[0] >= near[0] && upper[1] >= near[1] ? 1 : 0;
    left += strip.isBeyondSide(needle) ? 0 : 1;
  }
  QVERIFY(boxes > 1'000);
  QVERIFY2(left >= 1 && left <= 3, qPrintable(QString::number(left)));
}

QTEST_GUILESS_MAIN(TestGapStrip)
#include "test_gap_strip.moc"
