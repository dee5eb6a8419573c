// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/gap_corners.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "core/base/index_and_box.hpp"
#include "core/base/lexicographic_order.hpp"
#include "core/base/numbered_table.hpp"
#include "core/base/triangle_tree.hpp"
#include "core/mesh/mesh_topology.hpp"

namespace footfall::detail {
namespace {

/// A search ends after this many triangles on either side; a link may then stay although it is not needed.
constexpr std::size_t kMostTriangles = 256;
/// Squares are as wide as half of what is right there: what is within so much of that from a square's middle is right
/// there from all of the square, whose corners are 0.354 from its middle.
constexpr double kEverywhere = 0.64;
constexpr double kMostSquares = 0x1p30;
/// A square is grouped after this many searches in it, and again after twice as many each time.
constexpr std::size_t kFirstSearches = 4;
/// A group ends after this many triangles; further triangles are searched for one by one. This limit, as that of
/// searches, decides which needless gaps are found. Each run searches among all gaps anew, after edits too, so that the
/// answer does not depend on earlier runs.
constexpr std::size_t kMostGrouped = 1 << 14;
constexpr std::size_t kPolled = 1024;

/// The connections around a place: the mesh with its steps, and the gaps that are needed in any case.
class Neighbourhood {
 public:
  Neighbourhood(const std::vector<StepStretch>& steps, const BorderSplits& splits, double reach, Poll poll)
      : splits_(splits),
        reach_(reach),
        side_(reach / 2),
        sides_(splits.mesh().triangles, splits.topology(), splits.borders().size()),
        borderAt_(3 * splits.mesh().triangles.size(), -1),
        beyond_(borderAt_.size(), kUnknown),
        stamps_(splits.mesh().triangles.size(), 0),
        firstWay_(splits.borders().size(), -1) {
    const auto count = static_cast<Index>(splits.borders().size());
    for (Index number = 0; number < count; ++number) borderAt_[splits.border(number).side] = number;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (i % kPolled == 0) poll();
      const PlanSegment part = planSegment(steps[i].begin, steps[i].end);
      add({steps[i].first, steps[i].second, {part, part}});
    }
  }

  void add(const GapWay& way) {
    addWay(way.first, {way.parts[0], triangleOf(way.second), -1});
    addWay(way.second, {way.parts[1], triangleOf(way.first), -1});
  }
  void add(const GapStretch& gap) { add(gapWay(splits_, gap.first, gap.second, gap.piece, gap.piece.ends)); }

  /// Returns whether an agent gets from one side to the other close to the gap.
  [[nodiscard]] bool joins(const GapStretch& gap) {
    const Vec3& place = *gap.piece.corner;
    const Index first = triangleOf(gap.first), second = triangleOf(gap.second);
    const double column = std::floor(place.x / side_), row = std::floor(place.y / side_);
    if (!(std::max(std::fabs(column), std::fabs(row)) < kMostSquares)) return search(first, second, place);
    const auto [number, isNew] = squareAt_.insert({static_cast<std::int32_t>(column), static_cast<std::int32_t>(row)});
    if (isNew) squares_.emplace_back();
    Square& square = squares_[static_cast<std::size_t>(number)];
    const Index group = square.groupOf(first);
    if (group >= 0 && group == square.groupOf(second)) return true;
    if (!search(first, second, place)) return false;
    if (++square.searches == square.next) {
      square.next *= 2;
      addGroup(square, first, {(column + 0.5) * side_, (row + 0.5) * side_, 0});
    }
    return true;
  }

 private:
  /// Triangles that hang together right at every place of a square of the plan, in groups. Ways only ever come in:
  /// what hangs together stays so.
  struct Square {
    std::size_t searches = 0, next = kFirstSearches;
    Index groups = 0;
    std::vector<std::array<Index, 2>> groupAt;  ///< triangles with their groups, in a table of open addresses
    [[nodiscard]] Index groupOf(Index triangle) const {
      if (groupAt.empty()) return -1;
      for (std::size_t place = placeOf(triangle); groupAt[place][0] >= 0; place = (place + 1) & (groupAt.size() - 1))
        if (groupAt[place][0] == triangle) return groupAt[place][1];
      return -1;
    }
    void setGroups(const std::vector<std::array<Index, 2>>& all) {
      groupAt.assign(std::bit_ceil(2 * all.size() + 1), {-1, -1});
      for (const auto& known : all) {
        std::size_t place = placeOf(known[0]);
        while (groupAt[place][0] >= 0) place = (place + 1) & (groupAt.size() - 1);
        groupAt[place] = known;
      }
    }

   private:
    [[nodiscard]] std::size_t placeOf(Index triangle) const {
      return (static_cast<std::size_t>(triangle) * 0x9E3779B97F4A7C15U >> 32) & (groupAt.size() - 1);
    }
  };

  /// Adds everything that is connected with a triangle near a square to a group of the square.
  void addGroup(Square& square, Index triangle, const Vec3& middle) {
    ++search_;
    std::vector<Index>& reached = reached_[0];
    const auto isNew = [&](Index other) { return stamps_[other] != 2 * search_; };
    const auto reach = [&](Index other) {
      if (!isNew(other)) return;
      stamps_[other] = 2 * search_;
      reached.push_back(other);
    };
    reached.clear();
    reach(triangle);
    for (std::size_t i = 0; i < reached.size() && i < kMostGrouped; ++i)
      visitNeighbours(reached[i], middle, kEverywhere * reach_, isNew, reach);
    std::vector<std::array<Index, 2>> groups;
    for (const Index other : reached) groups.push_back({other, square.groups});
    ++square.groups;
    for (const auto& known : square.groupAt)
      if (known[0] >= 0 && isNew(known[0])) groups.push_back(known);
    square.setGroups(groups);
  }

  /// Searches alternately from both sides. When one side has reached everything that is connected with it, the sides
  /// are apart.
  [[nodiscard]] bool search(Index first, Index second, const Vec3& place) {
    ++search_;
    bool isMet = false;
    const auto reach = [&](std::size_t from, Index triangle) {
      std::uint64_t& stamp = stamps_[triangle];
      if (stamp == 2 * search_ + from) return;
      if (stamp == 2 * search_ + 1 - from) isMet = true;
      stamp = 2 * search_ + from;
      reached_[from].push_back(triangle);
    };
    for (const std::size_t from : {0, 1}) {
      reached_[from].clear();
      reach(from, from == 0 ? first : second);
    }
    for (std::size_t i = 0; i < kMostTriangles; ++i)
      for (const std::size_t from : {0, 1}) {
        if (isMet) return true;
        if (i == reached_[from].size()) return false;
        const auto isNew = [&](Index triangle) { return stamps_[triangle] != 2 * search_ + from; };
        visitNeighbours(reached_[from][i], place, reach_, isNew, [&](Index triangle) { reach(from, triangle); });
      }
    return isMet;
  }

  /// A way over a part of a border to a triangle.
  struct Way {
    PlanSegment part;
    Index other = -1;  ///< triangle
    Index next = -1;
  };

  static constexpr Index kUnknown = -2;

  /// The triangle behind a side that is no border, or -1. Most searches see a small part of the mesh.
  [[nodiscard]] Index beyond(Index side) {
    Index& known = beyond_[side];
    if (known != kUnknown) return known;
    known = -1;
    const TriangleCorners corners(splits_.mesh().triangles);
    const Index from = corners.beginOf(side), to = corners.endOf(side);
    if (const Index other = sides_.find(to, from); other >= 0) known = other / 3;
    return known;
  }

  void addWay(Index border, Way way) {
    way.next = std::exchange(firstWay_[border], static_cast<Index>(ways_.size()));
    ways_.push_back(way);
  }
  /// Calls visit(triangle) for triangles on the other side of an edge, a step or a gap near a place. isNew(triangle)
  /// must hold; it is cheaper than the distance of the edge and is tested first.
  template <class IsNew, class Visit>
  void visitNeighbours(Index triangle, const Vec3& place, double reach, const IsNew& isNew, const Visit& visit) {
    const WalkableMesh& mesh = splits_.mesh();
    const auto& corners = mesh.triangles[triangle].corners;
    for (int k = 0; k < 3; ++k) {
      const Index side = 3 * triangle + k, border = borderAt_[side];
      if (border >= 0) {
        for (Index w = firstWay_[border]; w >= 0; w = ways_[w].next)
          if (isNew(ways_[w].other) && ways_[w].part.isNear(place, reach)) visit(ways_[w].other);
      } else if (const Index other = beyond(side); other >= 0 && isNew(other)) {
        const MeshVertex &a = mesh.vertices[corners[k]], &b = mesh.vertices[corners[next(k)]];
        if (planSegment(a, b).isNear(place, reach)) visit(other);
      }
    }
  }
  [[nodiscard]] Index triangleOf(Index border) const { return splits_.border(border).side / 3; }

  const BorderSplits& splits_;
  double reach_, side_;
  SideFinder sides_;
  NumberedTable<std::array<std::int32_t, 2>> squareAt_;
  std::vector<Square> squares_;        ///< by number in squareAt_
  std::vector<Index> borderAt_;        ///< by side
  std::vector<Index> beyond_;          ///< by side: beyond(), or kUnknown
  std::vector<std::uint64_t> stamps_;  ///< by triangle: the last search that reached it, and from which end
  std::uint64_t search_ = 0;
  std::array<std::vector<Index>, 2> reached_;
  std::vector<Index> firstWay_;  ///< by border, in ways_
  std::vector<Way> ways_;
};

bool isOptional(const GapStretch& gap) { return gap.piece.corner.has_value(); }
double lengthOf(const GapStretch& gap) { return gap.piece.ends[1] - gap.piece.ends[0]; }

/// Sorts ascending numbers of gaps in the order in which they are needed: the longest first.
void sortByLength(std::vector<std::size_t>& numbers, const std::vector<GapStretch>& gaps, const Poll& poll) {
  std::vector<double> lengths;  // gaps themselves are large
  lengths.reserve(numbers.size());
  for (const std::size_t number : numbers) lengths.push_back(lengthOf(gaps[number]));
  const auto valueOf = [&](std::uint32_t i, int axis) { return axis == 0 ? -lengths[i] : 0; };
  const std::vector<std::uint32_t> order = lexicographicOrder(numbers.size(), valueOf, poll);
  std::vector<std::size_t> sorted(numbers.size());
  for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = numbers[order[i]];
  numbers = std::move(sorted);
}

/// Moves the chosen gaps from one list to another, in their order.
void moveChosen(std::vector<GapStretch>& from, const std::vector<char>& isChosen, std::vector<GapStretch>& to) {
  const auto count = static_cast<std::size_t>(std::count(isChosen.begin(), isChosen.end(), 1));
  if (count == 0) return;
  std::vector<GapStretch> kept;
  kept.reserve(from.size() - count);
  to.reserve(to.size() + count);
  for (std::size_t i = 0; i < from.size(); ++i) (isChosen[i] != 0 ? to : kept).push_back(std::move(from[i]));
  from = std::move(kept);
}

}  // namespace

NeedlessGaps::NeedlessGaps(const BorderSplits& splits, double gap)
    : splits_(splits), reach_(std::ldexp(2 * gap, splits.kernel()->mesh().grid.scaleExponent())) {}

void NeedlessGaps::takeFrom(std::vector<GapStretch>& gaps, const std::vector<StepStretch>& steps, Poll poll) {
  if (std::none_of(gaps.begin(), gaps.end(), isOptional)) return;
  Neighbourhood neighbourhood(steps, splits_, reach_, poll);
  std::vector<std::size_t> optional;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (i % kPolled == 0) poll();
    if (isOptional(gaps[i]))
      optional.push_back(i);
    else
      neighbourhood.add(gaps[i]);
  }
  sortByLength(optional, gaps, poll);
  std::vector<char> isNeedless(gaps.size(), 0);
  for (const std::size_t i : optional) {
    poll();
    isNeedless[i] = neighbourhood.joins(gaps[i]) ? 1 : 0;
    if (isNeedless[i] == 0) neighbourhood.add(gaps[i]);
  }
  moveChosen(gaps, isNeedless, gaps_);
}

// Where needles cross each other, thousands of parts and of gaps lie about one place: for each gap a search ends with
// the first part that is near.
std::vector<std::size_t> NeedlessGaps::findNear(const std::vector<PlanSegment>& lost, Poll poll) const {
  std::vector<std::size_t> near;
  if (lost.empty() || gaps_.empty()) return near;
  std::vector<Box> boxes;
  std::vector<std::int32_t> numbers(lost.size()), stack;
  boxes.reserve(lost.size());
  for (const PlanSegment& part : lost) {
    const auto [left, right] = std::minmax(part.fromX, part.toX);
    const auto [bottom, top] = std::minmax(part.fromY, part.toY);
    boxes.push_back({{left, bottom, 0}, {right, top, 0}});
  }
  std::iota(numbers.begin(), numbers.end(), 0);
  TriangleTree tree;
  tree.build(boxes, numbers, poll);
  const double reach = reach_ * (1 + 0x1p-20);  // more than isNear() can be off by
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    if (i % kPolled == 0) poll();
    const Vec3& place = *gaps_[i].piece.corner;
    bool isNear = false;
    tree.visitOverlapping({{place.x - reach, place.y - reach, 0}, {place.x + reach, place.y + reach, 0}}, stack,
                          [&](std::int32_t part) {
                            isNear = lost[static_cast<std::size_t>(part)].isNear(place, reach_);
                            return !isNear;
                          });
    if (isNear) near.push_back(i);
  }
  return near;
}

std::vector<GapStretch> NeedlessGaps::takeNeeded(const std::vector<PlanSegment>& lost,
                                                 const std::vector<StepStretch>& steps,
                                                 const std::function<std::vector<GapWay>()>& findWays, Poll poll) {
  std::vector<GapStretch> needed;
  std::vector<std::size_t> near = findNear(lost, poll);
  if (near.empty()) return needed;
  Neighbourhood neighbourhood(steps, splits_, reach_, poll);
  for (const GapWay& way : findWays()) neighbourhood.add(way);
  sortByLength(near, gaps_, poll);
  std::vector<char> isNeeded(gaps_.size(), 0);
  for (const std::size_t i : near) {
    poll();
    isNeeded[i] = neighbourhood.joins(gaps_[i]) ? 0 : 1;
    if (isNeeded[i] != 0) neighbourhood.add(gaps_[i]);
  }
  moveChosen(gaps_, isNeeded, needed);
  return needed;
}

}  // namespace footfall::detail
