// Floors at gaps in groups that run apart from each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <stdexcept>

#include "core/tiles/gap_groups.hpp"

using namespace footfall::detail;

class TestGapGroups : public QObject {
  Q_OBJECT

 private slots:
  void nothing();
  void joinedFloors();
  void cornersNearSides();
  void eachFloorIsListed();
  void floorsAreCharged();
  void middles();
};

namespace {

using Floors = std::vector<std::uint32_t>;

std::vector<Floors> listsOf(const GapGroups& groups) {
  std::vector<Floors> lists;
  for (std::size_t i = 0; i < groups.count(); ++i) lists.push_back(groups.list(i, i + 1).floors);
  return lists;
}

}  // namespace

void TestGapGroups::nothing() { QCOMPARE(GapGroups(FloorsAtGaps{}, 1, {}).count(), std::size_t{0}); }

// Groups come in the order of their first floors, each with its floors in ascending order. Floors that are at no gap
// join nothing.
void TestGapGroups::joinedFloors() {
  FloorsAtGaps all;
  all.floors = {7, 3, 9, 1, 5, 3};
  all.joined = {{9, 3}, {1, 9}, {5, 100}, {100, 7}};
  const GapGroups groups(std::move(all), 1, {});
  QCOMPARE(listsOf(groups), (std::vector<Floors>{{7}, {1, 3, 9}, {5}}));
  QCOMPARE(groups.list(0, 3).floors, (Floors{1, 3, 5, 7, 9}));
  QCOMPARE(groups.list(1, 3).floors, (Floors{1, 3, 5, 9}));
}

// Sides within two gaps of a corner decide about it; sides far from it do not, however near their boxes are to others.
void TestGapGroups::cornersNearSides() {
  FloorsAtGaps all;
  all.floors = {1, 2, 3, 4};
  all.corners = {{1, 10, 10}, {4, 100, 0}, {4, 100, 0}};
  all.sides = {{1, {10, 10}, {10, 10}}, {2, {11.5, 0}, {11.5, 20}}, {3, {15, 0}, {15, 20}}, {4, {100, 0}, {101, 0}}};
  const GapGroups groups(std::move(all), 1, {});
  QCOMPARE(listsOf(groups), (std::vector<Floors>{{1, 2}, {3}, {4}}));
  QCOMPARE(groups.list(0, 1).corners.size(), std::size_t{1});
  QVERIFY(groups.list(1, 2).corners.empty());
  QCOMPARE(groups.list(2, 3).corners.size(), std::size_t{1});
}

// A list that leaves a floor out would be read behind its end.
void TestGapGroups::eachFloorIsListed() {
  for (const bool isCorner : {true, false}) {
    FloorsAtGaps all;
    all.floors = {1, 2};
    if (isCorner)
      all.corners = {{3, 0, 0}};
    else
      all.sides = {{0, {0, 0}, {1, 1}}};
    QVERIFY_EXCEPTION_THROWN(GapGroups(std::move(all), 1, {}), std::logic_error);
  }
}

// Each floor takes more than its number in the list.
void TestGapGroups::floorsAreCharged() {
  FloorsAtGaps all;
  for (std::uint32_t floor = 0; floor < 1000; ++floor) all.floors.push_back(floor);
  QVERIFY(GapGroups::bytesToMake(all) >= 1000 * 60);
  const std::uint64_t before = GapGroups::bytesToMake(all);
  const GapGroups groups(std::move(all), 1, {});
  QVERIFY(groups.bytes() < before);
  QCOMPARE(groups.list(0, 10).bytes(), std::uint64_t{10 * sizeof(std::uint32_t)});
}

void TestGapGroups::middles() {
  FloorsAtGaps all;
  all.floors = {1, 2, 3, 4, 5, 6};
  all.joined = {{1, 2}, {1, 3}, {1, 4}};
  const GapGroups groups(std::move(all), 1, {});
  QCOMPARE(groups.count(), std::size_t{3});
  QCOMPARE(groups.middleOf(0, 3), std::size_t{1});
  QCOMPARE(groups.middleOf(1, 3), std::size_t{2});
  QCOMPARE(groups.middleOf(0, 2), std::size_t{1});
}

QTEST_APPLESS_MAIN(TestGapGroups)
#include "test_gap_groups.moc"
