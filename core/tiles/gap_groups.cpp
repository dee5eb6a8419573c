// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/gap_groups.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "core/base/box_tree.hpp"
#include "core/base/disjoint_sets.hpp"
#include "core/base/sorted_list.hpp"

namespace footfall::detail {
namespace {

using Tree = BoxTree<2>;

constexpr std::size_t kPolled = 1024;
/// A corner is decided by what is within two gaps of it. The other side of a gap is at most a gap away from its first
/// one, and another gap is more than places and their boxes are off by.
constexpr double kReachInGaps = 4;

/// Joins the floors of each corner with those of all sides near it.
void joinAtCorners(const FloorsAtGaps& all, const std::vector<Index>& floorOfCorner,
                   const std::vector<Index>& floorOfSide, double gap, const Poll& poll, DisjointSets& sets) {
  if (all.corners.empty()) return;
  std::vector<Index> ids(all.sides.size());
  std::iota(ids.begin(), ids.end(), 0);
  Tree tree;
  tree.build(
      ids,
      [&](Index i) {
        const FloorsAtGaps::Side& side = all.sides[i];
        return Tree::Bounds{side.lower, side.upper};
      },
      poll);
  for (std::size_t i = 0; i < all.corners.size(); ++i) {
    if (i % kPolled == 0) poll();
    const FloorsAtGaps::Corner& corner = all.corners[i];
    const double reach = kReachInGaps * gap + std::max(std::fabs(corner.x), std::fabs(corner.y)) * 0x1p-22;
    const Tree::Bounds around{{corner.x - reach, corner.y - reach}, {corner.x + reach, corner.y + reach}};
    tree.visitOverlapping(around, [&](Index side) { sets.unite(floorOfCorner[i], floorOfSide[side]); });
  }
}

}  // namespace

// The constructor below holds the lists, for each floor its number, its set and its group, twice the begin of a group
// and the list of floors; for each corner and each side the place of its floor; and the tree of the sides.
std::uint64_t GapGroups::bytesToMake(const FloorsAtGaps& all) {
  constexpr std::uint64_t kOfFloor = 2 * sizeof(std::uint32_t) + sizeof(Index) + 16 + 2 * sizeof(Begin);
  constexpr std::uint64_t kOfCorner = sizeof(Index) + sizeof(FloorsAtGaps::Corner);
  constexpr std::uint64_t kOfSide = 2 * sizeof(Index) + 48;
  return all.bytes() + all.floors.size() * kOfFloor + all.corners.size() * kOfCorner + all.sides.size() * kOfSide;
}

GapGroups::GapGroups(FloorsAtGaps all, double gap, Poll poll) {
  std::vector<std::uint32_t> numbers = all.floors;
  sortOnce(numbers);
  const auto placeOf = [&numbers](std::uint32_t floor) {
    const auto found = std::lower_bound(numbers.begin(), numbers.end(), floor);
    return found != numbers.end() && *found == floor ? static_cast<Index>(found - numbers.begin()) : -1;
  };
  DisjointSets sets(numbers.size());
  for (const auto& [a, b] : std::exchange(all.joined, {})) {
    const Index first = placeOf(a), second = placeOf(b);
    if (first >= 0 && second >= 0) sets.unite(first, second);
  }
  poll();
  const auto placesOf = [&placeOf](const auto& some) {
    std::vector<Index> places;
    places.reserve(some.size());
    for (const auto& each : some) {
      places.push_back(placeOf(each.floor));
      if (places.back() < 0) throw std::logic_error("a gap is at a floor that is not listed");
    }
    return places;
  };
  const std::vector<Index> floorOfCorner = placesOf(all.corners);
  joinAtCorners(all, floorOfCorner, placesOf(all.sides), gap, poll, sets);
  all.sides = {};

  // Groups are numbered as their floors come, which are in the order of the environment's blocks.
  std::vector<Index> groupOf(numbers.size(), -1);
  Index count = 0;
  for (const std::uint32_t floor : all.floors)
    if (Index& group = groupOf[sets.find(placeOf(floor))]; group < 0) group = count++;
  for (std::size_t i = 0; i < groupOf.size(); ++i) groupOf[i] = groupOf[sets.find(static_cast<Index>(i))];
  all.floors = {};
  groups_.resize(static_cast<std::size_t>(count) + 1);
  for (const Index group : groupOf) ++groups_[group + 1].floor;
  for (const Index floor : floorOfCorner) ++groups_[groupOf[floor] + 1].corner;
  for (std::size_t i = 1; i < groups_.size(); ++i) {
    groups_[i].floor += groups_[i - 1].floor;
    groups_[i].corner += groups_[i - 1].corner;
  }
  std::vector<Begin> next = groups_;
  floors_.resize(numbers.size());
  corners_.resize(all.corners.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) floors_[next[groupOf[i]].floor++] = numbers[i];
  for (std::size_t i = 0; i < all.corners.size(); ++i)
    corners_[next[groupOf[floorOfCorner[i]]].corner++] = all.corners[i];
}

std::size_t GapGroups::middleOf(std::size_t first, std::size_t last) const {
  const std::size_t half = (groups_[first].floor + groups_[last].floor) / 2;
  const auto begin = groups_.begin();
  const auto found =
      std::lower_bound(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last), half,
                       [](const Begin& group, std::size_t floor) { return group.floor < floor; });
  return std::clamp(static_cast<std::size_t>(found - begin), first + 1, last - 1);
}

ListedFloors GapGroups::list(std::size_t first, std::size_t last) const {
  const auto at = [](const auto& all, std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i); };
  ListedFloors listed{{at(floors_, groups_[first].floor), at(floors_, groups_[last].floor)},
                      {at(corners_, groups_[first].corner), at(corners_, groups_[last].corner)}};
  sortOnce(listed.floors);
  sortOnce(listed.corners);
  return listed;
}

}  // namespace footfall::detail
