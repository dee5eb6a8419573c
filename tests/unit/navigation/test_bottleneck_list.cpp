// The rule by which bottlenecks are listed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "core/navigation/bottleneck_list.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

/// Bottlenecks of these widths, narrowest first, each with a place on either side that is wider by `prominence`.
CorridorMap mapOf(const std::vector<std::pair<double, double>>& widthsAndProminences) {
  CorridorMap map;
  for (const auto& [width, prominence] : widthsAndProminences) {
    Bottleneck bottleneck;
    bottleneck.width = width;
    for (BottleneckSide& side : bottleneck.sides) side.widest = static_cast<std::uint32_t>(map.vertices.size());
    map.vertices.push_back({{}, width * (1 + prominence), 0});
    map.bottlenecks.push_back(bottleneck);
  }
  return map;
}

using Numbers = std::vector<std::size_t>;

}  // namespace

class TestBottleneckList : public QObject {
  Q_OBJECT

 private slots:
  void leavesOutSlitsAndShallowOnes() {
    const CorridorMap map = mapOf({{0.05, 3}, {0.1, 0.01}, {0.125, 1}, {1, 0.01}, {2, 0.5}, {4, 0}});
    const BottleneckList list = listBottlenecks(map, usualBottlenecks(1));
    QCOMPARE(list.listed, (Numbers{2, 4}));
    QCOMPARE(list.slits, std::size_t{2});
    QCOMPARE(list.shallow, std::size_t{2});
  }

  void theSmallestPassageIsInMetres() {
    const CorridorMap map = mapOf({{0.125, 1}, {9, 1}, {11, 1}});
    QCOMPARE(listBottlenecks(map, usualBottlenecks(1)).listed, (Numbers{0, 1, 2}));
    QCOMPARE(listBottlenecks(map, usualBottlenecks(0.01)).listed, (Numbers{2}));
  }

  void boundsCanBeSet() {
    const CorridorMap map = mapOf({{0.05, 3}, {1, 0.01}, {2, 0.5}, {4, 0}});
    BottleneckRule rule;
    QCOMPARE(listBottlenecks(map, rule).listed, (Numbers{0, 2}));
    rule.leastProminence = 0;
    QCOMPARE(listBottlenecks(map, rule).listed, (Numbers{0, 1, 2, 3}));
    // Bottlenecks that are too wide are left out without a word.
    rule = {.widerThan = 1, .narrowerThan = 4, .leastProminence = 0.6};
    const BottleneckList list = listBottlenecks(map, rule);
    QVERIFY(list.listed.empty());
    QCOMPARE(list.slits, std::size_t{2});
    QCOMPARE(list.shallow, std::size_t{1});
  }
};

QTEST_GUILESS_MAIN(TestBottleneckList)
#include "test_bottleneck_list.moc"
