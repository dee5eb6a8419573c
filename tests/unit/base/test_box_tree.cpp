// The tree over boxes of a mesh against looking at every box, and what depends on it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#undef emit  // Qt's word for nothing; the thread library has functions of this name
#include "core/base/box_tree.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using Tree = BoxTree<2>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool overlaps(const Tree::Bounds& a, const Tree::Bounds& b) {
  for (int k = 0; k < 2; ++k)
    if (a.lower[k] > b.upper[k] || a.upper[k] < b.lower[k]) return false;
  return true;
}

}  // namespace

class TestBoxTree : public QObject {
  Q_OBJECT

 private slots:
  void noOverlapIsMissed_data() {
    QTest::addColumn<double>("size");
    QTest::addColumn<double>("infinite");  // share of the boxes
    for (const double size : {1.0, 1e-310, 1e40, 1.7e308})
      for (const double infinite : {0.0, 0.02, 1.0})
        QTest::addRow("%g, %g infinite", size, infinite) << size << infinite;
  }
  void noOverlapIsMissed() {
    QFETCH(double, size);
    QFETCH(double, infinite);
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> share(0, 1);
    for (const Index count : {1, 2, 3, 5, 17, 700}) {
      std::vector<Tree::Bounds> boxes(count);
      std::vector<Index> ids(count);
      for (Index i = 0; i < count; ++i) {
        ids[i] = i;
        for (int k = 0; k < 2; ++k) {
          boxes[i].lower[k] = (share(random) * 1.9 - 1) * size;
          boxes[i].upper[k] = boxes[i].lower[k] + share(random) * 0.1 * size;
        }
        if (share(random) < infinite) boxes[i] = {{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};
      }
      Tree tree;
      tree.build(
          ids, [&](Index i) { return boxes[i]; }, [] {});
      for (Index i = 0; i < count; ++i) {
        std::vector<char> seen(count, 0);
        tree.visitOverlapping(boxes[i], [&](Index o) {
          QVERIFY(o >= 0 && o < count);
          seen[o] = 1;
        });
        for (Index o = 0; o < count; ++o) QVERIFY(seen[o] != 0 || !overlaps(boxes[i], boxes[o]));
      }
      // Rows may begin anywhere: the same pairs, each once.
      const auto findPairs = [&](Index begin, const auto& queries) {
        std::vector<std::array<Index, 2>> pairs;
        for (Index place = begin; place < count; place += Tree::kRow) {
          std::vector<Tree::Bounds> row;
          for (Index k = place; k < std::min(place + Tree::kRow, count); ++k) row.push_back(boxes[tree.idAt(k)]);
          queries(place, row, pairs);
        }
        std::ranges::sort(pairs);
        return pairs;
      };
      for (const Index begin : {0, 1, 3}) {
        const auto inRows = findPairs(begin, [&](Index place, const auto& row, auto& pairs) {
          tree.visitOverlapping(place, row, [&](Index own, Index o) { pairs.push_back({own, o}); });
        });
        const auto oneByOne = findPairs(begin, [&](Index place, const auto& row, auto& pairs) {
          for (std::size_t k = 0; k < row.size(); ++k) {
            const Index own = place + static_cast<Index>(k);
            tree.visitOverlapping(
                row[k],
                [&](Index o) {
                  pairs.push_back({own, o});
                },
                own + 1);
          }
        });
        const auto isLater = [&](const std::array<Index, 2>& pair) {
          for (Index k = 0; k <= pair[0]; ++k)
            if (tree.idAt(k) == pair[1]) return false;
          return true;
        };
        for (const auto& pair : inRows) QVERIFY(isLater(pair));
        QVERIFY(std::ranges::adjacent_find(inRows) == inRows.end());
        QVERIFY(std::ranges::includes(oneByOne, inRows));
        for (const auto& pair : oneByOne) QVERIFY(std::ranges::binary_search(inRows, pair) || !isLater(pair));
      }
    }
  }

  // There are enough boxes that all threads sort. Along an axis, places follow the coordinates; boxes at one place keep
  // their order.
  void placesDoNotDependOnBlocks() {
    constexpr Index kCount = 30000;
    std::vector<Index> ids(kCount);
    std::iota(ids.begin(), ids.end(), Index{0});
    std::ranges::shuffle(ids, std::mt19937(3));
    const auto build = [&](auto boundsOf) {
      Tree tree;
      tree.build(ids, boundsOf, [] {});
      std::vector<Index> places(kCount);
      for (Index place = 0; place < kCount; ++place) places[place] = tree.idAt(place);
      return places;
    };
    const auto onAxis = build([](Index i) {
      const auto x = static_cast<double>(i);
      return Tree::Bounds{{x, 0}, {x, 0}};
    });
    QVERIFY(std::ranges::is_sorted(onAxis));
    QVERIFY(build([](Index) { return Tree::Bounds{{1, 2}, {3, 4}}; }) == ids);
  }

  // Doubles cannot decide on which side of its long edge the sliver's third corner lies, so a cut on it has no bounded
  // place. Overlaps elsewhere are still found.
  void sliverSpoilsNoLayers() {
    const auto level =
        Soup()
            .triangle({0.56455938733252509, 0.48555748271869681, 0}, {1.2460526521838422, 0.96143186829115423, 0},
                      {1.0149939543370208, 0.80008777064549763, 0})
            .triangle({0.9594268771674086, -5, 1}, {9, -5, 1}, {0.9594268771674086, 9, 1})
            .floor(20, 0, 24, 4, 0)
            .floor(20, 0, 24, 4, 5)
            .environment();
    const auto mesh = navigationMesh(runFilters(level, minimalPipeline(2) + "LayerSubdivisionFilter\n"));
    QCOMPARE(mesh.layerCount, 2U);
  }

  // Coordinates that no float holds.
  void bordersOfGiants() {
    const double s = 1e40;
    const auto level = Soup()
                           .triangle({-s, -s, -s}, {s, s, s}, {-s, s, 0})
                           .triangle({s, s, s}, {-s, -s, -s}, {s, -s, 0})
                           .triangle({-s, -s, -s / 2}, {s, s, 2 * s}, {s, s, 1.5 * s})
                           .environment();
    QCOMPARE(navigationMesh(runFilters(level, "VerticalClearanceFilter 3e40")).obstacleEdges.size(), std::size_t{1});
  }
};

QTEST_GUILESS_MAIN(TestBoxTree)
#include "test_box_tree.moc"
