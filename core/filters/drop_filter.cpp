// DropFilter: where an agent drops from a ledge (model, Drops).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "core/assembly/mesh_assembly.hpp"
#include "core/base/counted_text.hpp"
#include "core/filters/drops/drop_finder.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/filters/height_levels.hpp"

namespace footfall::detail {

FilterOutcome applyDrop(const StatePtr& given, double depth, double reach, RunContext& context) {
  FilterOutcome outcome;
  auto state = std::make_shared<WalkableState>(*withMesh(given, context, outcome.fallbacks));
  if (state->clearance == 0) throw std::logic_error("DropFilter without a clearance before it");
  const SourceMesh& source = state->kernel->mesh();
  const double deepest = sufficientHeight(source, depth);
  checkHeight(source, deepest,
              FOOTFALL_TEXT("a drop of %1 is too small beside coordinates of up to %2; give at least %3, or check the "
                            "scale and the largest coordinates"));
  const auto kernel = state->kernel;
  for (const double height : {state->clearance, deepest, state->step})
    if (height > 0) state->kernel = kernelWithHeight(state->kernel, height);
  const auto levelOf = [&](double height) { return height > 0 ? state->kernel->levelOf(height).value() : 0; };
  DropFinder finder(*state, {levelOf(state->step), levelOf(state->clearance), levelOf(deepest)}, context);
  std::vector<MeshDrop> drops = finder.find(reach);
  outcome.fallbacks += finder.fallbacks();
  outcome.note = countedText(drops.size(), FOOTFALL_TEXT("1 drop"), FOOTFALL_TEXT("%1 drops"));
  auto mesh = std::make_shared<WalkableMesh>(*state->mesh);
  // An earlier filter may have had another depth and reach.
  std::vector<MeshDrop> both;
  std::set_union(drops.begin(), drops.end(), mesh->drops.begin(), mesh->drops.end(), std::back_inserter(both));
  mesh->drops = std::move(both);
  if (state->topologyOwner.lock() == state->mesh) state->topologyOwner = mesh;
  state->mesh = std::move(mesh);
  state->kernel = kernel;
  outcome.state = std::move(state);
  return outcome;
}

}  // namespace footfall::detail
