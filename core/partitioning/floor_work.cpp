// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/partitioning/floor_work.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/parallel.hpp"

namespace footfall::detail {
namespace {

// Work in units of a floor that nothing stands on, fitted to the time of the clearance filter on nine levels of 3 k to
// 59 k triangles: one unit was 2.9 to 4.6 microseconds on all of them.
constexpr double kWorkOfFloor = 1;
constexpr double kWorkOfTest = 0.03;  ///< an obstacle whose box overlaps that of the floor's clearance
constexpr double kWorkOfOverlap = 0.4;

constexpr std::size_t kPilotSize = 256;         ///< number of floors that are sampled to find how many obstacles a
                                                ///< floor has
constexpr std::size_t kLargestSample = 1024;    ///< floors
constexpr std::size_t kSampleOfCell = 32;       ///< floors; idle threads make good what is estimated badly
constexpr double kMostVisits = 60000;           ///< visits of obstacles by the sample; about two milliseconds
constexpr std::size_t kScatteredOverlaps = 16;  ///< obstacles of a floor from which on it matters where they are
constexpr std::size_t kMostPlaces = 256;        ///< number of places over which the work of one floor is spread
// The stride by which obstacles of giants in large environments are sampled; prime, so that no pattern of the triangles
// falls in with it.
constexpr unsigned kGiantStride = 7;
constexpr std::size_t kManyTriangles = 16384;
constexpr std::size_t kMostItems = 4096;
constexpr std::size_t kFloorsPerTask = 64;
constexpr std::size_t kTrianglesPerTask = 8192;
constexpr unsigned kVisitsPerPoll = 4096;

struct Chosen {
  Index floor = -1;
  double count = 1;      ///< floors that it stands for
  bool isGiant = false;  ///< chosen for its size alone
};

// A width as a part of the whole, whatever the size of the numbers.
double shareOf(double lower, double upper, double wholeLower, double wholeUpper) {
  const double whole = wholeUpper / 2 - wholeLower / 2;
  return whole > 0 ? (upper / 2 - lower / 2) / whole : 0;
}

// Floors with a large area in the plan carry much of the work, and are chosen more often (sampling with probability
// proportional to size; systematic in the order of the triangles, which is that of x).
class FloorSampler {
 public:
  FloorSampler(const StrategyInput& input, const PlanBox& whole) {
    const SourceMesh& mesh = input.mesh;
    const std::size_t triangles = mesh.triangles.size();
    for (std::size_t t = 0; t < triangles; ++t)
      if (input.walkable[t] != 0) floors_.push_back(static_cast<Index>(t));
    sizes_.resize(floors_.size());
    forRanges(floors_.size(), kTrianglesPerTask, [&](std::size_t first, std::size_t last) {
      input.poll();
      for (std::size_t i = first; i < last; ++i) {
        const PlanBox box = planBoxOf(mesh, floors_[i]);
        sizes_[i] = shareOf(box.lower[0], box.upper[0], whole.lower[0], whole.upper[0]) *
                    shareOf(box.lower[1], box.upper[1], whole.lower[1], whole.upper[1]);
      }
    });
    // Half of the chances for the number of floors, half for their areas.
    const double area = std::accumulate(sizes_.begin(), sizes_.end(), 0.0);
    const double count = static_cast<double>(floors_.size());
    for (double& size : sizes_) size = area > 0 ? (1 / count + size / area) / 2 : 1 / count;
  }

  [[nodiscard]] std::size_t size() const { return floors_.size(); }

  [[nodiscard]] std::vector<Chosen> choose(std::size_t count) const {
    std::vector<Chosen> chosen;
    if (count >= floors_.size()) {
      for (const Index floor : floors_) chosen.push_back({floor, 1});
      return chosen;
    }
    const double step = 1 / static_cast<double>(count);
    double sum = 0, next = step / 2;
    for (std::size_t i = 0; i < floors_.size(); ++i) {
      sum += sizes_[i];
      if (sum < next) continue;
      const double times = std::floor((sum - next) / step) + 1;
      next += times * step;
      // Floors that are certainly chosen represent only themselves.
      const bool isGiant = sizes_[i] >= step;
      chosen.push_back({floors_[i], isGiant ? 1 : times * step / sizes_[i], isGiant});
    }
    return chosen;
  }

 private:
  std::vector<Index> floors_;
  std::vector<double> sizes_;  ///< share of each of them; together 1
};

// True when an edge of the first triangle has all of the second on its outer side, as far as doubles can decide.
bool isApart(const SourceMesh& mesh, Index first, Index second) {
  const int facing = mesh.facing[first];
  if (facing == 0) return false;
  const auto &f = mesh.triangles[first], &g = mesh.triangles[second];
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = mesh.scaled[f[k]], &b = mesh.scaled[f[(k + 1) % 3]];
    const auto isOutside = [&](Index v) {
      const Vec3& p = mesh.scaled[v];
      return ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) * facing <= 0;
    };
    if (isOutside(g[0]) && isOutside(g[1]) && isOutside(g[2])) return true;
  }
  return false;
}

// Finds the obstacles of floors; one for each task.
class FloorExaminer {
 public:
  FloorExaminer(const StrategyInput& input, std::vector<FloorWork::Item>& items)
      : input_(input), mesh_(input.mesh), items_(items) {}

  FloorWork::Floor examine(const Chosen& chosen) {
    Box box = boxOf(mesh_, chosen.floor);
    const FloorWork::Floor floor{
        {{box.lower[0], box.lower[1]}, {box.upper[0], box.upper[1]}}, box.lower[2], box.upper[2], chosen.count};
    overlaps_.clear();
    std::size_t tests = 0;
    const unsigned stride = chosen.isGiant && mesh_.triangles.size() >= kManyTriangles ? kGiantStride : 1;
    if (input_.clearance > 0) {
      box.upper[2] += input_.clearance;
      mesh_.tree.visitOverlapping(box, stack_, [&](Index obstacle) {
        if (stride > 1 && static_cast<unsigned>(obstacle) % stride != 0) return true;
        if (++visits_ % kVisitsPerPoll == 0) input_.poll();
        if (obstacle == chosen.floor || !reachesInto(obstacle, box)) return true;
        ++tests;
        if (!isApart(mesh_, chosen.floor, obstacle) && !isApart(mesh_, obstacle, chosen.floor))
          overlaps_.push_back(obstacle);
        return true;
      });
    }
    addItems(floor, tests, stride);
    return floor;
  }

  [[nodiscard]] std::size_t visits() const { return visits_; }

 private:
  [[nodiscard]] bool reachesInto(Index obstacle, const Box& box) const {
    if (input_.removed[obstacle] != 0) return false;
    const Box other = boxOf(mesh_, obstacle);
    const auto isFlat = [&](int axis) { return other.lower[axis] == other.upper[axis]; };
    for (int axis = 0; axis < 2; ++axis)
      if (isFlat(axis) ? other.lower[axis] < box.lower[axis] || other.upper[axis] > box.upper[axis]
                       : other.upper[axis] <= box.lower[axis] || other.lower[axis] >= box.upper[axis])
        return false;
    return other.upper[2] > box.lower[2] && other.lower[2] < box.upper[2];
  }

  void addItems(const FloorWork::Floor& floor, std::size_t tests, double weight) {
    const double own = kWorkOfFloor + kWorkOfTest * weight * static_cast<double>(tests);
    const double found = kWorkOfOverlap * weight * static_cast<double>(overlaps_.size());
    const bool isScattered = overlaps_.size() >= kScatteredOverlaps;
    if (!isScattered) {
      items_.push_back({middleOf(floor.box, floor.lowest), (own + found) * floor.count});
      return;
    }
    std::sort(overlaps_.begin(), overlaps_.end());
    const std::size_t stride = (overlaps_.size() + kMostPlaces - 1) / kMostPlaces;
    const std::size_t places = (overlaps_.size() + stride - 1) / stride;
    for (std::size_t i = 0; i < overlaps_.size(); i += stride) {
      PlanBox box = planBoxOf(mesh_, overlaps_[i]);
      for (int axis = 0; axis < 2; ++axis) {
        box.lower[axis] = std::max(box.lower[axis], floor.box.lower[axis]);
        box.upper[axis] = std::min(box.upper[axis], floor.box.upper[axis]);
      }
      items_.push_back({middleOf(box, floor.lowest), (own + found) / static_cast<double>(places) * floor.count});
    }
  }

  static std::array<double, 3> middleOf(const PlanBox& box, double z) {
    return {std::midpoint(box.lower[0], box.upper[0]), std::midpoint(box.lower[1], box.upper[1]), z};
  }

  const StrategyInput& input_;
  const SourceMesh& mesh_;
  std::vector<FloorWork::Item>& items_;
  std::vector<std::int32_t> stack_;
  std::vector<Index> overlaps_;
  std::size_t visits_ = 0;
};

// The work of the floors, and how many obstacles were visited.
std::size_t examine(const std::vector<Chosen>& chosen, const StrategyInput& input, FloorWork& work) {
  const std::size_t tasks = (chosen.size() + kFloorsPerTask - 1) / kFloorsPerTask;
  std::vector<std::vector<FloorWork::Item>> items(tasks);
  std::vector<std::size_t> visits(tasks, 0);
  work.floors.resize(chosen.size());
  forRanges(tasks, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t task = begin; task < end; ++task) {
      input.poll();
      FloorExaminer examiner(input, items[task]);
      const std::size_t last = std::min((task + 1) * kFloorsPerTask, chosen.size());
      for (std::size_t i = task * kFloorsPerTask; i < last; ++i) work.floors[i] = examiner.examine(chosen[i]);
      visits[task] = examiner.visits();
    }
  });
  work.items.clear();
  for (const auto& list : items) work.items.insert(work.items.end(), list.begin(), list.end());
  return std::accumulate(visits.begin(), visits.end(), std::size_t{0});
}

// Keeps some of the items, heavy ones more likely, with the total unchanged.
void thin(std::vector<FloorWork::Item>& items, double total) {
  if (items.size() <= kMostItems) return;
  const double step = total / static_cast<double>(kMostItems);
  double sum = 0, next = step / 2;
  std::size_t kept = 0;
  for (const FloorWork::Item& item : items) {
    sum += item.work;
    if (sum < next) continue;
    const double times = std::floor((sum - next) / step) + 1;
    next += times * step;
    items[kept++] = {item.place, times * step};
  }
  items.resize(kept);
}

double totalOf(const std::vector<FloorWork::Item>& items) {
  return std::accumulate(items.begin(), items.end(), 0.0,
                         [](double sum, const FloorWork::Item& item) { return sum + item.work; });
}

}  // namespace

FloorWork estimateFloorWork(const StrategyInput& input, std::size_t cells) {
  FloorWork work;
  work.box = planBoxOf(input);
  const FloorSampler sampler(input, work.box);
  const std::size_t wanted =
      sampler.size() <= kLargestSample ? sampler.size() : std::clamp(cells * kSampleOfCell, kPilotSize, kLargestSample);
  std::size_t count = wanted;
  if (input.clearance > 0) {
    const std::vector<Chosen> pilot = sampler.choose(kPilotSize);
    const std::size_t visits = examine(pilot, input, work);
    const double affordable = kMostVisits / (static_cast<double>(visits) + 1) * static_cast<double>(pilot.size());
    count = static_cast<std::size_t>(std::clamp<double>(affordable, 0, static_cast<double>(wanted)));
  }
  if (count > kPilotSize || input.clearance <= 0) examine(sampler.choose(count), input, work);
  work.total = totalOf(work.items);
  thin(work.items, work.total);
  return work;
}

void estimateCosts(Partition& partition, const FloorWork& work) {
  for (Cell& cell : partition.cells) cell.cost = 0;
  for (const FloorWork::Item& item : work.items) {
    const std::array<double, 2> place{item.place[0], item.place[1]};
    partition.visitCells(place, place, item.place[2], [&](Index cell) { partition.cells[cell].cost += item.work; });
  }
}

}  // namespace footfall::detail
