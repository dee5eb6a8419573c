// StepFilter: links borders between which an agent can lift its feet (model, Links).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <stdexcept>

#include "core/assembly/earlier_result.hpp"
#include "core/assembly/mesh_assembly.hpp"
#include "core/base/counted_text.hpp"
#include "core/environment/coordinate_grid.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/filters/height_levels.hpp"
#include "core/filters/steps/chosen_steps.hpp"
#include "core/filters/steps/step_linker.hpp"

namespace footfall::detail {

FilterOutcome applyStep(const StatePtr& given, double step, double gap, const Recall& recall, RunContext& context) {
  return applyStepToChosen(given, step, gap, nullptr, true, recall, context);
}

FilterOutcome applyStepToChosen(const StatePtr& given, double step, double gap, const std::vector<char>* chosen,
                                bool linksGaps, const Recall& recall, RunContext& context) {
  FilterOutcome outcome;
  auto state = std::make_shared<WalkableState>(*withMesh(given, context, outcome.fallbacks));
  if (state->clearance == 0) throw std::logic_error("StepFilter without a clearance before it");
  const SourceMesh& source = state->kernel->mesh();
  const double height = sufficientHeight(source, climbOnGrid(state->environment->grid, step));
  checkHeight(source, height,
              FOOTFALL_TEXT("a step of %1 is too small beside coordinates of up to %2; give at least %3, or check the "
                            "scale and the largest coordinates"));
  state->kernel = kernelWithHeight(kernelWithHeight(state->kernel, state->clearance), height);
  if (const StepsAtLimit atLimit = stepsAtLimit(state->environment->grid, height); atLimit.lower > 0)
    state->kernel = kernelWithHeight(kernelWithHeight(state->kernel, atLimit.lower), atLimit.higher);
  StepLinker linker(*state, context, chosen);
  const StepMemory* before = recall.before ? recall.before->stepMemory.get() : nullptr;
  if (before != nullptr && before->step == height && before->height == state->clearance && before->gap == gap) {
    if (const auto earlier = EarlierResult::relate(recall.before, *state->kernel)) linker.reuse(*before, *earlier);
  }
  state->step = std::max(state->step, height);
  const auto memory = recall.keep ? std::make_shared<StepMemory>() : nullptr;
  state->mesh = linker.link(height, state->clearance, gap, memory.get(), linksGaps);
  state->stepMemory = memory;
  state->kernel = linker.kernel();
  state->topology = nullptr;
  outcome.fallbacks += linker.fallbacks();
  outcome.note = countedText(state->mesh->links.size(), FOOTFALL_TEXT("1 link"), FOOTFALL_TEXT("%1 links"));
  if (linker.undecided() > 0) {
    outcome.note =
        Text(FOOTFALL_TEXT("%1 (%2 more could not be verified)"), outcome.note, Text::count(linker.undecided()));
  }
  if (linker.leftOut() > 0) {
    outcome.note = Text(FOOTFALL_TEXT("%1; short ways over gaps left out, as they lead nowhere else: %2"), outcome.note,
                        Text::count(linker.leftOut()));
  }
  outcome.state = std::move(state);
  return outcome;
}

}  // namespace footfall::detail
