// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/without_radius.hpp"

#include <algorithm>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::ui {
namespace {

bool keepsOff(const PipelineStep& step) { return step.enabled && step.filter->type == FilterType::Radius; }

}  // namespace

double radiusOf(const Pipeline& pipeline) {
  double radius = 0;
  for (const PipelineStep& step : pipeline.steps)
    if (keepsOff(step)) radius = std::max(radius, step.values[0]);
  return radius;
}

bool hasRadius(const Pipeline& pipeline) { return std::ranges::any_of(pipeline.steps, keepsOff); }

std::shared_ptr<const NavigationMesh> meshWithoutRadius(const FinishedRun& run, ResultCache* cache,
                                                        RunContext& context) {
  if (!hasRadius(run.pipeline)) return run.result.mesh;
  Pipeline pipeline = run.pipeline;
  for (PipelineStep& step : pipeline.steps)
    if (keepsOff(step)) step.enabled = false;
  return runPipeline(run.environment, pipeline, context, cache).mesh;
}

}  // namespace footfall::ui
