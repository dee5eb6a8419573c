// DegeneracyFilter: takes triangles of zero area out of the environment (design section 2, thesis 3.2 and 4.4.2).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "core/filters/filter_registry.hpp"

namespace footfall {

// An obstacle edge of a removed triangle stays where it is: obstacle edges are known by their vertices, so the
// neighbour that shares such an edge has it too (algorithm 3).
FilterOutcome applyDegeneracy(const StatePtr& state, RunContext& context) {
  context.checkCancelled();
  const SourceMesh& mesh = state->kernel->mesh();
  auto result = std::make_shared<WalkableState>(*state);
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.degenerate[t] == 0 || result->removed[t] != 0) continue;
    result->removed[t] = 1;
    result->walkable[t] = 0;
    ++count;
  }
  if (count == 0) return {state, {}, {}};
  return {result, std::to_string(count) + " degenerate triangles removed", {}};
}

}  // namespace footfall
