// SPDX-License-Identifier: GPL-3.0-or-later
//
// A vertex's coordinate lies within an interval, which is a single double for exact ones. Vertices are sorted by the
// lower ends. A run of intervals that touch each other is sorted again: by the next coordinate where all of them are
// one double, else by exact comparisons. Between runs, the intervals are the proof.
#include "core/filters/layers/plan_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/base/parallel_sort.hpp"
#include "core/exact/error_double.hpp"
#include "core/mesh/mesh_geometry.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kVerticesPerTask = 2048, kRunsPerTask = 64;

struct Interval {
  double lower = 0, upper = 0;
};

struct Entry {
  std::array<Interval, 2> at;  ///< x and y
  Index vertex = -1;
};

// The interval holds all values that MeshGeometry::compare() takes for possible.
Interval intervalOf(double value, double error) {
  if (error == 0) return {value, value};
  const double bound = (error + std::fabs(value) * 0x1p-51) * kInflate;
  if (!std::isfinite(value) || !std::isfinite(bound))
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  return {value - bound, value + bound};
}

// A scaled coordinate of a source vertex is exact: scaling by a power of two loses nothing but in subnormal numbers.
Interval intervalOf(const MeshVertex& vertex, const PlanKernel& kernel, std::size_t axis) {
  constexpr double kNormal = 0x1p-1000;
  const double value = axis == 0 ? vertex.x : vertex.y;
  if (vertex.source >= 0 && vertex.error != 0) {
    const Vec3& given = kernel.mesh().vertices[vertex.source];
    if (std::fabs(value) > kNormal || (axis == 0 ? given.x : given.y) == 0) return {value, value};
  }
  return intervalOf(value, vertex.error);
}

struct Local {
  MeshGeometry geometry;
  std::size_t decisions = 0;
};

class RunSorter {
 public:
  RunSorter(Local& local, RunContext& context) : local_(local), context_(context) {}

  /// Sorts entries by the coordinate and those that follow; all earlier ones are equal.
  void sort(std::span<Entry> entries, std::size_t axis) {
    if (entries.size() < 2 || axis == 2) return;
    std::sort(entries.begin(), entries.end(),
              [axis](const Entry& a, const Entry& b) { return a.at[axis].lower < b.at[axis].lower; });
    forRuns(entries, axis, [&](std::span<Entry> run) { sortRun(run, axis); });
  }

  /// Sorts entries whose intervals touch.
  void sortRun(std::span<Entry> run, std::size_t axis) {
    const double first = run[0].at[axis].lower;
    const bool isOne = std::all_of(
        run.begin(), run.end(), [&](const Entry& e) { return e.at[axis].lower == first && e.at[axis].upper == first; });
    if (isOne) return sort(run, axis + 1);
    std::sort(run.begin(), run.end(), [&](const Entry& a, const Entry& b) {
      if ((++local_.decisions & 1023) == 0) context_.checkCancelled();
      for (std::size_t k = axis; k < 2; ++k)
        if (const int sign = compare(a, b, k); sign != 0) return sign < 0;
      return a.vertex < b.vertex;
    });
  }

  /// Calls work(run) for each run of two entries or more whose intervals touch.
  template <class Work>
  static void forRuns(std::span<Entry> entries, std::size_t axis, const Work& work) {
    for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
      double upper = entries[begin].at[axis].upper;
      for (end = begin + 1; end < entries.size() && entries[end].at[axis].lower <= upper; ++end)
        upper = std::max(upper, entries[end].at[axis].upper);
      if (end - begin > 1) work(entries.subspan(begin, end - begin));
    }
  }

  [[nodiscard]] int compare(const Entry& a, const Entry& b, std::size_t axis) const {
    const Interval &s = a.at[axis], &t = b.at[axis];
    if (s.upper < t.lower) return -1;
    if (t.upper < s.lower) return 1;
    if (s.lower == s.upper && t.lower == t.upper) return 0;  // equal doubles
    return local_.geometry.compare(a.vertex, b.vertex, static_cast<int>(axis));
  }

 private:
  Local& local_;
  RunContext& context_;
};

}  // namespace

PlanOrder findPlanOrder(const std::vector<Index>& vertices, const PlanKernel& kernel, const WalkableMesh& mesh,
                        RunContext& context, ExactFallbacks& fallbacks, std::size_t& decisions) {
  std::vector<Entry> entries(vertices.size());
  parallelRanges(entries.size(), kVerticesPerTask, [&](const auto& range) {
    context.checkCancelled();
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const MeshVertex& v = mesh.vertices[vertices[i]];
      entries[i] = {{intervalOf(v, kernel, 0), intervalOf(v, kernel, 1)}, vertices[i]};
    }
  });
  parallelSort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.at[0].lower != b.at[0].lower ? a.at[0].lower < b.at[0].lower : a.vertex < b.vertex;
  });
  std::vector<std::span<Entry>> runs;
  RunSorter::forRuns(entries, 0, [&](std::span<Entry> run) { runs.push_back(run); });
  PerThread<Local> locals([&] { return Local{MeshGeometry(kernel, mesh.vertices)}; });
  forRanges(runs.size(), kRunsPerTask, [&](std::size_t first, std::size_t last) {
    context.checkCancelled();
    RunSorter sorter(locals.local(), context);
    for (std::size_t i = first; i < last; ++i) sorter.sortRun(runs[i], 0);
  });

  PlanOrder order;
  order.placeOf.resize(mesh.vertices.size());
  RunSorter sorter(locals.local(), context);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const bool isNew = i == 0 || sorter.compare(entries[i - 1], entries[i], 0) != 0 ||
                       sorter.compare(entries[i - 1], entries[i], 1) != 0;
    if (isNew) order.vertexAt.push_back(entries[i].vertex);
    order.placeOf[entries[i].vertex] = static_cast<Index>(order.vertexAt.size()) - 1;
  }
  for (const Local& local : locals) {
    fallbacks += local.geometry.fallbacks;
    decisions += local.decisions;
  }
  return order;
}

}  // namespace footfall::detail
