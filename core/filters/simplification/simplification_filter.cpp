// SimplificationFilter: each coplanar region with as few triangles as its outline needs (model, Simplification,
// thesis 3.2 and 5.1.2).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/assembly/mesh_assembly.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/filters/rounding/generation.hpp"
#include "core/filters/simplification/simplifier.hpp"

namespace footfall::detail {
namespace {

double diagonal(const SourceMesh& mesh) {
  Vec3 low = mesh.scaled.front(), high = low;
  for (const Vec3& v : mesh.scaled) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  return std::hypot(high.x - low.x, high.y - low.y, high.z - low.z);
}

StatePtr simplify(const StatePtr& state, const ApproximateSimplification& approximate, const Recall& recall,
                  RunContext& context, ExactFallbacks& fallbacks) {
  const auto topology = topologyOf(*state, context);
  Simplifier simplifier(*state->kernel, *state->mesh, *topology, approximate, context);
  const auto earlier = EarlierResult::relate(recall.before, *state->kernel);
  if (earlier && recall.before->simplifierMemory) simplifier.reuse(*recall.before->simplifierMemory, *earlier);
  auto result = std::make_shared<WalkableState>(*state);
  std::shared_ptr<SimplifierMemory> memory;
  if (recall.keep) {
    memory = std::make_shared<SimplifierMemory>();
    memory->given = state->mesh;
  }
  result->mesh = std::make_shared<WalkableMesh>(simplifier.run(memory.get()));
  result->simplifierMemory = std::move(memory);
  result->topology = nullptr;
  result->simplified = true;
  fallbacks += simplifier.fallbacks();
  return result;
}

}  // namespace

// Approximately: vertices take double coordinates first, and what comes out starts a new generation, because its
// triangles lie in no source plane any more. No vertex is moved; one that is taken away was within `tolerance` times
// the diagonal of the environment of what replaces it.
FilterOutcome applySimplification(const StatePtr& given, bool approximate, double tolerance, const Recall& recall,
                                  RunContext& context) {
  FilterOutcome outcome;
  StatePtr state = withMesh(given, context, outcome.fallbacks);
  if (!approximate || state->mesh->triangles.empty()) {
    outcome.state = simplify(state, {}, approximate ? Recall{} : recall, context, outcome.fallbacks);
    return outcome;
  }
  const bool layered = !state->mesh->layers.empty();
  state = simplify(state, {}, {}, context, outcome.fallbacks);  // Vertices that go exactly need no judgement.
  if (hasConstructedVertices(*state))
    state = nextGeneration(*state, makeGenerationSoup(state, context, outcome.fallbacks), false, context,
                           outcome.fallbacks);
  const double bound = tolerance * diagonal(state->kernel->mesh());
  state = simplify(state, {true, tolerance, bound}, {}, context, outcome.fallbacks);
  outcome.state =
      nextGeneration(*state, makeGenerationSoup(state, context, outcome.fallbacks), false, context, outcome.fallbacks);
  if (layered) outcome.state = applyLayerSubdivision(outcome.state, {}, context).state;
  return outcome;
}

}  // namespace footfall::detail
