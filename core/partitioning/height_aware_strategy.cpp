// HeightAwareStrategy: a tree of cuts through the floors alone, across x, y or between heights, by estimated work
// (ours; thesis 6.1, first proposal).
// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/parallel.hpp"
#include "core/base/sorted_list.hpp"
#include "core/partitioning/floor_work.hpp"

namespace footfall::detail {
namespace {

// Work in units of a trivial triangle, as that of FloorWork.
constexpr double kWorkOfCutFloor = 2;  ///< cut at a border, twice begun, and put together again
// A floor that reaches across a cut between heights costs nothing, but where many do there are slopes, not storeys, and
// cells would lie in one another like contour lines.
constexpr double kWorkOfSlope = 0.5;
// Cuts are looked for where either side has at least so much of the work.
constexpr double kSmallestSide = 0.35;
// The worst division that is still made.
constexpr double kWorstSide = 0.02;
// The penalty of a cut between heights whose sides do not lie above one another: there are no storeys, and a cut in the
// plan would keep together what is near.
constexpr double kLossBesideStoreys = 0.5;
constexpr double kStackedShare = 0.5;  ///< so much of the work above or below other work is a storey
constexpr int kStackColumns = 16;      ///< along each axis
constexpr std::size_t kParallelSize = 1024;

struct Candidate {
  int axis = -1;
  double coordinate = 0;
  double score = CellBounds::kInfinity;  ///< work of the larger side and of the cut itself, as a part of all
};

// The sum of the weights of all keys that are less than a number.
class Ranking {
 public:
  /// Good for numbers from `first` to `last`.
  template <class Keys>
  Ranking(std::size_t count, const Keys& keys, double first = -CellBounds::kInfinity,
          double last = CellBounds::kInfinity) {
    double before = 0;
    entries_.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::pair<double, double> entry = keys(i);
      if (entry.first < first)
        before += entry.second;
      else if (entry.first <= last)
        entries_.push_back(entry);
    }
    std::sort(entries_.begin(), entries_.end());
    sums_.reserve(entries_.size() + 1);
    sums_.push_back(before);
    for (const auto& entry : entries_) sums_.push_back(sums_.back() + entry.second);
  }

  [[nodiscard]] double below(double key) const { return sums_[placeOf(key)]; }
  [[nodiscard]] std::size_t placeOf(double key) const {
    const auto less = [](const auto& entry, double k) { return entry.first < k; };
    return static_cast<std::size_t>(std::lower_bound(entries_.begin(), entries_.end(), key, less) - entries_.begin());
  }
  /// The first key up to which, itself included, there is more than so much.
  [[nodiscard]] double keyAt(double sum) const {
    const auto found = std::upper_bound(sums_.begin() + 1, sums_.end() - 1, sum);
    return entries_[static_cast<std::size_t>(found - sums_.begin()) - 1].first;
  }

 private:
  std::vector<std::pair<double, double>> entries_;
  std::vector<double> sums_;
};

class FloorTree {
 public:
  struct Part {
    std::vector<Index> items, floors;  ///< items of work, and their floors
    PlanBox box;
  };

  FloorTree(const RecursionLimits& limits, const FloorWork& work, const std::string& name, const StrategyInput& input)
      : limits_(limits), work_(work), input_(input), cellLimit_(name, RecursionLimits::kAdvice) {}

  void grow(CutTree& tree, Part part, int depth) {
    if (depth >= limits_.depth) return;
    double total = 0;
    for (const Index i : part.items) total += work_.items[i].work;
    if (total <= limits_.triangles) return;
    input_.poll();
    const Candidate cut = bestCut(part, total);
    if (cut.axis < 0) return;
    cellLimit_.add(1);
    tree.axis = cut.axis;
    tree.coordinate = cut.coordinate;
    tree.below = std::make_unique<CutTree>();
    tree.above = std::make_unique<CutTree>();
    const bool isLarge = part.items.size() >= kParallelSize;
    std::array<Part, 2> parts = split(std::move(part), cut);
    const auto below = [&] { grow(*tree.below, std::move(parts[0]), depth + 1); };
    const auto above = [&] { grow(*tree.above, std::move(parts[1]), depth + 1); };
    if (isLarge)
      parallelInvoke(below, above);
    else
      below(), above();
  }

 private:
  Candidate bestCut(const Part& part, double total) const {
    std::array<Candidate, 3> best;
    const auto find = [&](int axis) { best[axis] = bestCut(part, total, axis); };
    if (part.items.size() >= kParallelSize)
      parallelFor(3, find);
    else
      for (int axis = 0; axis < 3; ++axis) find(axis);
    // Heights are cut first, since no floor is cut then.
    Candidate result = best[2];
    for (int axis = 0; axis < 2; ++axis)
      if (best[axis].score < result.score) result = best[axis];
    return result;
  }

  Candidate bestCut(const Part& part, double total, int axis) const {
    const Ranking items(part.items.size(), [&](std::size_t i) {
      const FloorWork::Item& item = work_.items[part.items[i]];
      return std::pair(item.place[axis], item.work);
    });
    const std::vector<double> places = placesToCut(part, items, total, axis);
    if (places.empty()) return {};
    const Ranking begins(
        part.floors.size(), [&](std::size_t i) { return range(part.floors[i], axis, 0); }, places.front(),
        places.back());
    const Ranking ends(
        part.floors.size(), [&](std::size_t i) { return range(part.floors[i], axis, 1); }, places.front(),
        places.back());
    Candidate best;
    for (const double place : places) {
      const double share = items.below(place) / total;
      const double smaller = std::min(share, 1 - share);
      if (smaller < kWorstSide) continue;
      // Floors that begin below and end above.
      const double cut = begins.below(place) - ends.below(std::nextafter(place, CellBounds::kInfinity));
      const double score = 1 - smaller + cut * (axis == 2 ? kWorkOfSlope : kWorkOfCutFloor) / total;
      if (score < best.score) best = {axis, place, score};
    }
    if (best.axis == 2)
      best.score += kLossBesideStoreys * std::max(0.0, kStackedShare - stackedWork(part, best.coordinate) / total);
    return best;
  }

  // The work in columns of the plan that have some both below and above a height.
  double stackedWork(const Part& part, double height) const {
    PlanBox box;
    for (const Index i : part.items)
      for (int axis = 0; axis < 2; ++axis) {
        box.lower[axis] = std::min(box.lower[axis], work_.items[i].place[axis]);
        box.upper[axis] = std::max(box.upper[axis], work_.items[i].place[axis]);
      }
    const auto columnOf = [&](const FloorWork::Item& item) {
      int column = 0;
      for (int axis = 0; axis < 2; ++axis) {
        const double width = box.upper[axis] / 2 - box.lower[axis] / 2;
        const double share = width > 0 ? (item.place[axis] / 2 - box.lower[axis] / 2) / width : 0;
        column = column * kStackColumns + std::clamp(static_cast<int>(share * kStackColumns), 0, kStackColumns - 1);
      }
      return column;
    };
    std::array<std::array<double, 2>, kStackColumns * kStackColumns> columns{};
    for (const Index i : part.items) {
      const FloorWork::Item& item = work_.items[i];
      columns[columnOf(item)][item.place[2] < height ? 0 : 1] += item.work;
    }
    double work = 0;
    for (const auto& [below, above] : columns)
      if (below > 0 && above > 0) work += below + above;
    return work;
  }

  // Cuts lie where floors begin and end, if the sides are about equal; else at the middle of the work.
  std::vector<double> placesToCut(const Part& part, const Ranking& items, double total, int axis) const {
    const double first = items.keyAt(kSmallestSide * total), last = items.keyAt((1 - kSmallestSide) * total);
    std::vector<double> places;
    const auto add = [&](double place) {
      if (axis == 2 || part.box.isInside(axis, place)) places.push_back(place);
    };
    for (const Index floor : part.floors) {
      const double begin = range(floor, axis, 0).first, end = range(floor, axis, 1).first;
      if (first <= begin && begin <= last) add(begin);
      if (axis < 2 && first <= end && end <= last) add(end);
    }
    // All the work of one place lies above a cut there: the next place is the other choice.
    const double middle = items.keyAt(total / 2);
    add(middle);
    const std::size_t next = items.placeOf(std::nextafter(middle, CellBounds::kInfinity));
    if (next < part.items.size()) add(items.keyAt(items.below(std::nextafter(middle, CellBounds::kInfinity))));
    sortOnce(places);
    return places;
  }

  // Begin or end of a floor of the sample, and for how many floors it stands.
  [[nodiscard]] std::pair<double, double> range(Index floor, int axis, int end) const {
    const FloorWork::Floor& f = work_.floors[floor];
    if (axis == 2) return {end == 0 ? f.lowest : f.highest, f.count};
    return {end == 0 ? f.box.lower[axis] : f.box.upper[axis], f.count};
  }

  [[nodiscard]] std::array<Part, 2> split(Part part, const Candidate& cut) const {
    std::array<Part, 2> parts;
    for (const Index i : part.items) parts[work_.items[i].place[cut.axis] < cut.coordinate ? 0 : 1].items.push_back(i);
    for (const Index i : part.floors) {
      const double begin = range(i, cut.axis, 0).first;
      const double end = cut.axis == 2 ? begin : range(i, cut.axis, 1).first;
      if (begin < cut.coordinate) parts[0].floors.push_back(i);
      if (end > cut.coordinate || begin >= cut.coordinate) parts[1].floors.push_back(i);
    }
    parts[0].box = parts[1].box = part.box;
    if (cut.axis < 2) parts[0].box.upper[cut.axis] = parts[1].box.lower[cut.axis] = cut.coordinate;
    return parts;
  }

  const RecursionLimits& limits_;
  const FloorWork& work_;
  const StrategyInput& input_;
  CellLimit cellLimit_;
};

}  // namespace

std::unique_ptr<CutTree> growHeightAware(const RecursionLimits& limits, const FloorWork& work, const std::string& name,
                                         const StrategyInput& input) {
  auto tree = std::make_unique<CutTree>();
  if (work.items.empty()) return tree;
  FloorTree::Part all{std::vector<Index>(work.items.size()), std::vector<Index>(work.floors.size()), {}};
  std::iota(all.items.begin(), all.items.end(), 0);
  std::iota(all.floors.begin(), all.floors.end(), 0);
  all.box = work.box;
  FloorTree(limits, work, name, input).grow(*tree, std::move(all), 0);
  return tree;
}

}  // namespace footfall::detail
