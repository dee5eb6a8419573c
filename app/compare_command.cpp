// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare_command.hpp"

#include <oneapi/tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "app/interrupt_watcher.hpp"
#include "app/progress_bar.hpp"
#include "core/base/number_text.hpp"
#include "core/base/process_usage.hpp"
#include "core/compare/comparison_report.hpp"
#include "core/environment/up_axis.hpp"

namespace footfall::app {
using namespace detail;
namespace {

constexpr std::size_t kSteps = 4;  // of compareMeshes()

std::array<NavigationMeshFile, 2> readBoth(const CompareArguments& arguments, RunContext& context) {
  const std::optional<UpAxis> up = upAxisFrom(arguments.up);
  std::array<NavigationMeshFile, 2> files;
  files[0] = readNavigationMesh(arguments.files[0], up, UpAxis::Y, &context);
  // What states no axis lies as the other does.
  files[1] = readNavigationMesh(arguments.files[1], up, files[0].up, &context);
  if (!up && !files[0].statedUp && files[1].statedUp && files[1].up != files[0].up)
    files[0] = readNavigationMesh(arguments.files[0], files[1].up, UpAxis::Y, &context);
  return files;
}

std::string differenceOf(const CompareArguments& arguments, const MeshComparison& comparison) {
  const std::string names = arguments.files[0] + " and " + arguments.files[1];
  if (arguments.failIfDifferent && !comparison.equal()) return names + " are not the same set of points";
  if (!arguments.failAbove) return {};
  const double most = std::max(comparison.meshes[0].whole.uncovered.plan, comparison.meshes[1].whole.uncovered.plan);
  if (most <= *arguments.failAbove) return {};
  std::string text = names + ": an area of ";
  appendNumber(text, most);
  text += " is not covered by the other; at most ";
  appendNumber(text, *arguments.failAbove);
  return text + " was allowed";
}

}  // namespace

CompareOutcome compareFiles(const CompareArguments& arguments) {
  if (arguments.failAbove && !(std::isfinite(*arguments.failAbove) && *arguments.failAbove >= 0))
    throw InputError("--fail-above: must be an area in the files' units; give 0 or more");
  ProgressBar bar(!arguments.quiet && isatty(STDERR_FILENO) != 0);
  RunContext context([&bar](const RunEvent& event) { bar.show(event); });
  const InterruptWatcher watcher(context);
  std::optional<tbb::global_control> limit;
  if (arguments.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(arguments.threads));
  }
  const Stopwatch loading;
  bar.begin("loading", 0);
  const auto files = readBoth(arguments, context);
  const double loadMs = loading.wallMs();
  const Stopwatch comparing;
  bar.begin("comparing", kSteps);
  const MeshComparison comparison = compareMeshes(files[0].mesh, files[1].mesh, arguments.options, context);
  const ComparisonTimes times{loadMs, comparing.wallMs()};
  bar.clear();
  return {arguments.json ? formatComparisonJson(files, comparison, times) : formatComparison(files, comparison, times),
          differenceOf(arguments, comparison)};
}

}  // namespace footfall::app
