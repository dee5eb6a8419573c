// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/thesis_correctness.hpp"

#include "core/io/export.hpp"
#include "footfall/compare.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

// The distance between the bounds of the largest distance.
constexpr double kBoundMetres = 0.001;

}  // namespace

Json measureCorrectness(const ThesisSubject& subject, const Configuration& first, const Configuration& second) {
  const std::shared_ptr<const Environment> environment = loadSubject(subject.subject);
  const RunResult a = runConfiguration(subject, environment, first);
  const RunResult b = runConfiguration(subject, environment, second);
  RunContext context;
  ComparisonOptions options;
  options.error = kBoundMetres / subject.subject.metresPerUnit();
  const MeshComparison comparison = compareMeshes(*a.mesh, *b.mesh, options, &context);
  Json json;
  json["bytes_equal"] = formatObj(*a.mesh, {}) == formatObj(*b.mesh, {});
  json["sets_equal"] = comparison.equal();
  json["areas"] = {comparison.meshes[0].whole.areas.surface, comparison.meshes[1].whole.areas.surface};
  if (const auto ratio = comparison.areaRatio()) json["covered"] = *ratio;
  if (comparison.distances) {
    const SurfaceDistances& d = (*comparison.distances)[0];
    json["distances"] = {{"samples", d.samples}, {"min", d.min}, {"max", d.max},
                         {"mean", d.mean},       {"rms", d.rms}, {"upper", d.upper}};
  }
  return json;
}

}  // namespace footfall::bench
