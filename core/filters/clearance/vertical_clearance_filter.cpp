// VerticalClearanceFilter: removes what has an obstacle within the clearance above it (model, Vertical clearance,
// thesis 3.2).
// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <atomic>

#include "core/base/parallel.hpp"
#include "core/filters/clearance/clearance_pass.hpp"
#include "core/filters/filter_registry.hpp"

namespace footfall::detail {
namespace {

constexpr Index kFacesPerTask = 64;

// Floors that are a large share of all, largest first. They carry most of the obstacles, and neighbours among them have
// neighbouring numbers: each is a task of its own, begun before all others.
std::vector<Index> findGiants(const SourceMesh& mesh, const std::vector<char>& walkable) {
  constexpr double kShare = 1.0 / 64;
  const auto planArea = [&](Index t) {
    const Box box = boxOf(mesh, t);
    return (box.upper[0] - box.lower[0]) * (box.upper[1] - box.lower[1]);
  };
  const auto count = static_cast<Index>(walkable.size());
  double sum = 0;
  for (Index t = 0; t < count; ++t)
    if (walkable[t] != 0) sum += planArea(t);
  std::vector<std::pair<double, Index>> giants;
  for (Index t = 0; t < count; ++t)
    if (walkable[t] != 0)
      if (const double area = planArea(t); area > sum * kShare) giants.emplace_back(-area, t);
  std::sort(giants.begin(), giants.end());
  std::vector<Index> result;
  for (const auto& [area, t] : giants) result.push_back(t);
  return result;
}

}  // namespace

FilterOutcome applyVerticalClearance(const StatePtr& state, double height, const Recall& recall, RunContext& context) {
  ClearancePass pass(state, height, {}, {}, recall, context);
  const auto count = static_cast<Index>(state->walkable.size());
  const std::vector<Index> giants = findGiants(state->kernel->mesh(), state->walkable);
  std::vector<char> isGiant(count, 0);
  for (const Index t : giants) isGiant[t] = 1;
  const auto giantCount = static_cast<Index>(giants.size());
  // Progress of a giant under a crowd, whose work does not depend on its being one face of many.
  std::atomic<double> shareOfGiants{0};
  std::vector<std::atomic<double>> giantsDone(giants.size());
  std::atomic<Index> done{0}, nextTask{0};
  const auto reportProgress = [&] {
    double sum = 0;
    for (const std::atomic<double>& one : giantsDone) sum += one.load(std::memory_order_relaxed);
    const double giantShare = shareOfGiants.load(std::memory_order_relaxed);
    const double ofGiants = giants.empty() ? 0 : giantShare * sum / static_cast<double>(giants.size());
    const Index faces = done.load(std::memory_order_relaxed);
    context.progress(0.5 * (ofGiants + (1 - giantShare) * faces / count));
  };
  parallelFor(giantCount + (count + kFacesPerTask - 1) / kFacesPerTask, [&](Index) {
    const Index task = nextTask.fetch_add(1, std::memory_order_relaxed);
    ClearancePass::Worker& own = pass.worker();
    if (task < giantCount) {
      context.checkCancelled();
      pass.clip(giants[task], own, [&](double share) {
        shareOfGiants.store(0.25, std::memory_order_relaxed);
        giantsDone[task] = share;
        reportProgress();
      });
      giantsDone[task] = 1;
      return;
    }
    const Index first = (task - giantCount) * kFacesPerTask, last = std::min(first + kFacesPerTask, count);
    for (Index t = first; t != last; ++t) {
      context.checkCancelled();
      if (state->walkable[t] != 0 && isGiant[t] == 0) pass.clip(t, own);
    }
    done.fetch_add(last - first, std::memory_order_relaxed);
    reportProgress();
  });
  return pass.finish(state->walkable, state->removed, false);
}

}  // namespace footfall::detail
