// RoundingFilter: vertices become doubles; what that breaks is repaired and counted (model, Rounding, thesis 4.4.2 and
// 5.1.1).
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/filter_registry.hpp"
#include "core/filters/rounding/generation.hpp"

namespace footfall::detail {

FilterOutcome applyRounding(const StatePtr& state, bool repair, RunContext& context) {
  FilterOutcome outcome;
  if (!hasConstructedVertices(*state)) {
    outcome.state = state;
    outcome.note = FOOTFALL_TEXT("all vertices are exact already");
    return outcome;
  }
  const GenerationSoup soup = makeGenerationSoup(state, context, outcome.fallbacks);
  outcome.state = nextGeneration(*state, soup, false, context, outcome.fallbacks);
  if (!state->mesh->layers.empty()) outcome.state = applyLayerSubdivision(outcome.state, {}, context).state;
  const RoundingCases& c = soup.cases;
  outcome.note = Text(FOOTFALL_TEXT("case 1: %1, case 2: %2, case 3: %3, case 4: %4, case 5: %5"), Text::count(c.exact),
                      Text::count(c.edge), Text::count(c.point), Text::count(c.collinear), Text::count(c.flipped));
  if (!repair)
    outcome.note = Text(Pattern{"%1; %2"}, outcome.note,
                        FOOTFALL_TEXT("repair false changes nothing, because what rounding breaks is always repaired; "
                                      "footfall-rounding-experiment --no-repair leaves it"));
  return outcome;
}

}  // namespace footfall::detail
