// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/pipeline_check.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <random>

#include "core/io/export.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/filter.hpp"
#include "tests/reference/layer_optimum.hpp"
#include "tests/reference/product_check.hpp"
#include "tests/support/run_filters.hpp"

namespace footfall::fuzz {
using namespace detail;
namespace {

using namespace reference;

/// Pieces may reach over several input triangles of one plane, as SimplificationFilter makes them.
std::string findSetError(const WalkableArea& area, const std::vector<Piece>& pieces) {
  Rational sum = 0;
  for (const Piece& piece : pieces) {
    const auto plane = planeThrough(piece.corners);
    const auto region = std::find_if(area.regions.begin(), area.regions.end(),
                                     [&](const Region& r) { return plane.has_value() && r.plane == *plane; });
    if (region == area.regions.end()) return "in the plane of no floor: " + toText(piece);
    Rational walkable = 0;
    for (const Polygon& cell : region->cells) walkable += twiceCommonArea(cell, piece.plan);
    if (walkable != twiceArea(piece.plan)) return "walkable where it should not be: " + toText(piece);
    sum += walkable;
  }
  for (const auto& [a, b] : findOverlaps(pieces)) {
    if (planeThrough(pieces[a].corners) == planeThrough(pieces[b].corners))
      return "walkable twice: " + toText(pieces[a]) + " and " + toText(pieces[b]);
    if (pieces[a].layer >= 0 && pieces[a].layer == pieces[b].layer)
      return "overlap in a layer: " + toText(pieces[a]) + " and " + toText(pieces[b]);
  }
  if (sum != twiceArea(area))
    return "twice the plan area is " + sum.get_str() + " instead of " + twiceArea(area).get_str();
  return findConformityError(pieces);
}

std::string findLongListError(const PipelineCase& experiment, const std::shared_ptr<const Environment>& environment) {
  const StatePtr state = test::runFilters(environment, toPipelineText(experiment.sameSetFilters));
  const auto area = computeWalkableArea(*environment, {experiment.slope, experiment.clearance});
  if (auto error = findSetError(area, toPieces(exactWalkableTriangles(*state))); !error.empty()) return error;
  const auto error = test::findMeshError(test::navigationMesh(state));
  return error.empty() ? error : "rounded: " + error;
}

test::Soup repeated(const PipelineCase& experiment) {
  test::Soup soup;
  for (int i = 0; i < experiment.copies; ++i) {
    for (int j = 0; j < experiment.copies; ++j) {
      const double dx = i * experiment.copyDistance, dy = j * experiment.copyDistance;
      soup.add(experiment.soup.mapped([&](const Vec3& v) { return Vec3{v.x + dx, v.y + dy, v.z}; }));
    }
  }
  return soup;
}

std::string exportText(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline, int threads) {
  RunContext context;
  return formatObj(*runPipeline(environment, pipeline, context, nullptr, threads).mesh, {});
}

// The pipeline with its first local filters in a parallel block.
Pipeline inBlock(const Pipeline& pipeline, const std::string& strategy) {
  const auto isLocal = [](const PipelineStep& step) { return step.filter->scope == Scope::Local; };
  const auto first = std::find_if(pipeline.steps.begin(), pipeline.steps.end(), isLocal);
  const auto last = std::find_if_not(first, pipeline.steps.end(), isLocal);
  Pipeline block = parsePipeline(strategy + "\nCollapse\n", "strategy");
  block.steps.insert(block.steps.begin() + 1, first, last);
  block.steps.insert(block.steps.begin(), pipeline.steps.begin(), first);
  block.steps.insert(block.steps.end(), last, pipeline.steps.end());
  return block;
}

std::string findDependence(const PipelineCase& experiment) {
  const std::shared_ptr<const Environment> environment = repeated(experiment).environment(experiment.bothSides);
  const Pipeline pipeline = parsePipeline(toPipelineText(experiment.anyFilters), "random");
  const std::string alone = exportText(environment, pipeline, 1);
  if (exportText(environment, pipeline, 2) != alone) return "other bytes on two threads";

  constexpr std::array kStrategies{"GridStrategy 2 2",        "GridStrategy 7 3",
                                   "RecursiveStrategy 1 3",   "SortedRecursiveStrategy 1 4 false",
                                   "HeightAwareStrategy 1 4", "AutoStrategy"};
  const std::string strategy = kStrategies[experiment.order % kStrategies.size()];
  if (exportText(environment, inBlock(pipeline, strategy), 2) != alone) return "other bytes in cells of " + strategy;

  std::vector<std::uint32_t> order(environment->triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::mt19937_64 engine(experiment.order);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[engine() % i]);
  const auto other = test::shuffled(*environment, order, static_cast<std::uint32_t>(engine() % 3));
  if (exportText(other, pipeline, 2) != alone) return "other bytes when the input is shuffled";
  return {};
}

}  // namespace

std::string findPipelineError(const PipelineCase& experiment) {
  const auto environment = experiment.soup.environment(experiment.bothSides);
  const Rounding rounding = experiment.roundingIsHarmless ? Rounding::Harmless : Rounding::MayClose;
  if (const auto error = checkProduct(*environment, experiment.slope, experiment.clearance, rounding); !error.empty())
    return "slope and clearance: " + error;
  if (const auto error = findLongListError(experiment, environment); !error.empty())
    return "filters that keep the set: " + error;
  if (const auto error = findDependence(experiment); !error.empty()) return "any filters: " + error;
  return {};
}

}  // namespace footfall::fuzz
