// The spatial tree against looking at every box.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>

#include "core/base/triangle_tree.hpp"
#include "tests/support/run_with_threads.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using Random = std::mt19937_64;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

enum class Kind { Level, Grid, Points, OnePlace, Flat, Huge, Tiny, Subnormal, Outlier, Shrinking, kCount };

double integer(Random& random, int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }
double real(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Box randomBox(Random& random, Kind kind) {
  Box box;
  const double shrink = std::ldexp(1, -static_cast<int>(integer(random, 0, 1000)));
  for (int k = 0; k < 3; ++k) {
    double low = 0, size = 0;
    switch (kind) {
      case Kind::Level:
        low = real(random, -100, 100), size = integer(random, 0, 20) == 0 ? real(random, 0, 100) : real(random, 0, 2);
        break;
      case Kind::Grid:
        low = integer(random, -4, 4), size = integer(random, 0, 2);
        break;
      case Kind::Points:
        low = real(random, -1, 1);
        break;
      case Kind::OnePlace:
        low = 122000.123, size = 1;
        break;
      case Kind::Flat:
        low = k == 2 ? 7.5 : integer(random, -400, 400) / 10, size = k == 2 ? 0 : integer(random, 0, 10) / 10;
        break;
      case Kind::Huge:
        low = real(random, -1, 0.9) * 1.7e308, size = 1e307;
        break;
      case Kind::Tiny:
        low = real(random, -1, 1) * 1e-300, size = 1e-302;
        break;
      case Kind::Subnormal:
        low = integer(random, -50, 50) * 5e-324, size = integer(random, 0, 3) * 5e-324;
        break;
      case Kind::Outlier:
        low = integer(random, 0, 500) == 0 ? 1e200 : real(random, -100, 100), size = 1;
        break;
      default:  // ever smaller towards one corner: splitting by area takes off a few at a time
        low = shrink, size = shrink / 8;
        break;
    }
    box.lower[k] = low;
    box.upper[k] = low + size;
  }
  return box;
}

std::vector<Box> randomBoxes(Random& random, Kind kind, std::size_t count) {
  std::vector<Box> boxes(count);
  for (Box& box : boxes) box = randomBox(random, kind);
  return boxes;
}

bool overlaps(const Box& a, const Box& b) {
  for (int k = 0; k < 3; ++k)
    if (a.lower[k] > b.upper[k] || a.upper[k] < b.lower[k]) return false;
  return true;
}

/// The ids are not in the order of the boxes, and have gaps.
std::vector<std::int32_t> someIds(std::size_t count) {
  std::vector<std::int32_t> ids(count);
  for (std::size_t i = 0; i < count; ++i) ids[i] = static_cast<std::int32_t>(3 * (count - i));
  return ids;
}

std::vector<std::int32_t> visited(const TriangleTree& tree, const Box& query) {
  std::vector<std::int32_t> result, stack;
  tree.visitOverlapping(query, stack, [&](std::int32_t id) {
    result.push_back(id);
    return true;
  });
  return result;
}

struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped") {}
};

}  // namespace

class TestTriangleTree : public QObject {
  Q_OBJECT

 private slots:
  void everyOverlapIsFoundOnce() {
    Random random(1);
    for (int kind = 0; kind < static_cast<int>(Kind::kCount); ++kind) {
      for (const std::size_t count : {0, 1, 2, 3, 4, 5, 6, 16, 17, 33, 200, 3000}) {
        const std::vector<Box> boxes = randomBoxes(random, static_cast<Kind>(kind), count);
        const std::vector<std::int32_t> ids = someIds(count);
        TriangleTree tree;
        tree.build(boxes, ids);
        QCOMPARE(tree.empty(), count == 0);
        std::vector<Box> queries = randomBoxes(random, static_cast<Kind>(kind), 20);
        queries.insert(queries.end(), boxes.begin(), boxes.begin() + std::min<std::ptrdiff_t>(50, boxes.size()));
        queries.push_back({{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}});
        queries.push_back({{-1e308, -1e308, 0}, {1e308, 1e308, 1e308}});
        queries.push_back({{0, 0, 0}, {0, 0, 0}});
        for (const Box& query : queries) {
          std::vector<std::int32_t> found = visited(tree, query), expected;
          std::sort(found.begin(), found.end());
          QVERIFY(std::adjacent_find(found.begin(), found.end()) == found.end());
          for (std::size_t i = 0; i < count; ++i)
            if (overlaps(boxes[i], query)) expected.push_back(ids[i]);
          std::sort(expected.begin(), expected.end());
          QVERIFY2(std::includes(found.begin(), found.end(), expected.begin(), expected.end()),
                   qPrintable(QString("kind %1, %2 boxes").arg(kind).arg(count)));
        }
      }
    }
  }

  // Boxes that only touch in the plan are distinguished from others: for certain on a grid of few bits, else never too
  // many.
  void crossingIsToldFromTouching() {
    Random random(6);
    const auto cross = [](const Box& a, const Box& b) {
      return a.lower[0] < b.upper[0] && a.upper[0] > b.lower[0] && a.lower[1] < b.upper[1] && a.upper[1] > b.lower[1];
    };
    for (const double unit : {0.25, 0x1p-40, 0x1p-24}) {
      std::vector<Box> boxes(3000);
      for (Box& box : boxes)
        for (int k = 0; k < 3; ++k) {
          box.lower[k] = integer(random, 0, 39) + unit * integer(random, 0, 2);
          box.upper[k] = box.lower[k] + integer(random, 0, 3) + unit * integer(random, 0, 2);
        }
      std::vector<std::int32_t> ids(boxes.size()), stack;
      std::iota(ids.begin(), ids.end(), 0);
      TriangleTree tree;
      tree.build(boxes, ids);
      const bool isExact = tree.isExactOn(std::ilogb(unit), 6);
      QCOMPARE(isExact, unit == 0.25);
      int crossing = 0, touching = 0;
      for (const Box& query : boxes) {
        std::size_t found = 0;
        tree.visitCrossing(query, stack, [&](std::int32_t id, bool crosses) {
          ++found;
          const bool doCross = cross(boxes[id], query);
          if (isExact ? crosses != doCross : crosses && !doCross) found += boxes.size();
          if (overlaps(boxes[id], query)) ++(doCross ? crossing : touching);
          return true;
        });
        QCOMPARE(found, visited(tree, query).size());
      }
      QVERIFY(crossing > 1000 && touching > 1000);
    }
    TriangleTree none;
    none.build({}, {});
    QVERIFY(none.isExactOn(-10, 10));
  }

  // Additional results lie within the rounding of floats, whatever the size of the numbers.
  void littleElseIsFound() {
    Random random(2);
    for (const double scale : {1.0, 0x1p-1000, 0x1p900}) {
      std::vector<Box> boxes = randomBoxes(random, Kind::Level, 2000);
      for (Box& box : boxes)
        for (int k = 0; k < 3; ++k) box.lower[k] *= scale, box.upper[k] *= scale;
      std::vector<std::int32_t> ids(boxes.size());
      std::iota(ids.begin(), ids.end(), 0);
      TriangleTree tree;
      tree.build(boxes, ids);
      for (int i = 0; i < 300; ++i) {
        Box query = boxes[i];
        for (const std::int32_t id : visited(tree, query)) {
          Box wider = boxes[id];
          for (int k = 0; k < 3; ++k) wider.lower[k] -= 1e-4 * scale, wider.upper[k] += 1e-4 * scale;
          QVERIFY(overlaps(wider, query));
        }
      }
    }
  }

  void theVisitorCanStop() {
    Random random(3);
    const std::vector<Box> boxes = randomBoxes(random, Kind::OnePlace, 100);
    TriangleTree tree;
    tree.build(boxes, someIds(100));
    std::vector<std::int32_t> stack;
    for (const int limit : {1, 2, 7}) {
      int calls = 0;
      tree.visitOverlapping(boxes[0], stack, [&](std::int32_t) { return ++calls < limit; });
      QCOMPARE(calls, limit);
    }
  }

  void sameTreeForAnyNumberOfThreads() {
    Random random(4);
    for (const Kind kind : {Kind::Level, Kind::Flat, Kind::Shrinking}) {
      const std::vector<Box> boxes = randomBoxes(random, kind, 60000);
      const std::vector<std::int32_t> ids = someIds(boxes.size());
      std::vector<std::vector<std::int32_t>> first;
      for (const int threads : {1, 2, 5}) {
        TriangleTree tree;
        runWithThreads(threads, [&] { tree.build(boxes, ids); });
        std::vector<std::vector<std::int32_t>> found;
        for (int i = 0; i < 100; ++i) found.push_back(visited(tree, boxes[i]));
        found.push_back(visited(tree, {{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}}));
        QCOMPARE(found.back().size(), boxes.size());
        if (first.empty()) first = found;
        QVERIFY(found == first);
      }
    }
  }

  // No work between two polls takes longer than some passes over the boxes.
  void buildingCanBeCancelled() {
    Random random(5);
    const std::vector<Box> boxes = randomBoxes(random, Kind::Level, 200000);
    const std::vector<std::int32_t> ids = someIds(boxes.size());
    std::atomic<int> polls{0};
    TriangleTree tree;
    tree.build(boxes, ids, [&] { ++polls; });
    const int all = polls;
    QVERIFY(all > 50);
    for (const int limit : {1, all / 4, all / 2, all - 1}) {
      polls = 0;
      QVERIFY_THROWS_EXCEPTION(Stopped, tree.build(boxes, ids, [&] {
        if (++polls >= limit) throw Stopped();
      }));
    }
    tree.build(boxes, ids);
    QCOMPARE(visited(tree, {{-200, -200, -200}, {300, 300, 300}}).size(), boxes.size());
  }
};

QTEST_APPLESS_MAIN(TestTriangleTree)
#include "test_triangle_tree.moc"
