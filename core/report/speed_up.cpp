// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/speed_up.hpp"

#include <algorithm>
#include <vector>

#include "footfall/filter.hpp"

namespace footfall::detail {
namespace {

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

}  // namespace

SpeedUp measureSpeedUp(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                       RunContext& context, int threads, int runs) {
  Pipeline filters = pipeline;
  std::erase_if(filters.steps, [](const PipelineStep& step) { return step.filter->kind != FilterKind::Filter; });
  std::vector<double> oneThread, parallel;
  for (int i = 0; i < std::max(runs, 1); ++i) {
    oneThread.push_back(runPipeline(environment, filters, context, nullptr, 1).totalMs);
    parallel.push_back(runPipeline(environment, pipeline, context, nullptr, threads).totalMs);
  }
  return {medianOf(std::move(oneThread)), medianOf(std::move(parallel))};
}

}  // namespace footfall::detail
