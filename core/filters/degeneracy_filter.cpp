// DegeneracyFilter: takes triangles of zero area out of the environment (model, Degeneracy, thesis 3.2 and 4.4.2).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "core/base/counted_text.hpp"
#include "core/filters/filter_registry.hpp"

namespace footfall::detail {

// An obstacle edge of a removed triangle stays where it is. Obstacle edges are identified by their vertices, so the
// neighbour that shares such an edge has it too (algorithm 3).
FilterOutcome applyDegeneracy(const StatePtr& state, RunContext& context) {
  context.checkCancelled();
  const SourceMesh& mesh = state->kernel->mesh();
  auto result = std::make_shared<WalkableState>(*state);
  std::size_t count = 0, walkable = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.degenerate[t] == 0 || result->removed[t] != 0) continue;
    walkable += result->walkable[t] != 0 ? 1U : 0U;
    result->removed[t] = 1;
    result->walkable[t] = 0;
    ++count;
  }
  if (count == 0) return {state, {}, {}};
  // The numbers of triangles beside a note are those of walkable ones, and of these hardly any has no area.
  Text note = walkable > 0 ? Text(FOOTFALL_TEXT("triangles without area left out: %1, walkable among them: %2"),
                                  Text::count(count), Text::count(walkable))
                           : countedText(count, FOOTFALL_TEXT("1 triangle without area left out; it was not walkable"),
                                         FOOTFALL_TEXT("%1 triangles without area left out; none was walkable"));
  return {result, std::move(note), {}};
}

}  // namespace footfall::detail
