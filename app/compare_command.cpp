// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "app/command_list.hpp"
#include "app/command_session.hpp"
#include "core/base/number_text.hpp"
#include "core/base/process_usage.hpp"
#include "core/compare/comparison_report.hpp"
#include "core/io/export.hpp"
#include "core/io/write_targets.hpp"
#include "core/report/distance_picture.hpp"
#include "footfall/compare.hpp"
#include "footfall/errors.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::app {
using namespace detail;
namespace {

struct CompareOptions {
  std::array<std::string, 2> files;  ///< A, the ground truth, and B
  ComparisonOptions comparison;
  std::string up;  ///< empty: what the files state
  bool json = false;
  bool failIfDifferent = false;
  std::optional<double> failAbove;  ///< area in the plan
  std::string picture;              ///< empty: none
  int threads = 0;
  bool quiet = false;
};

constexpr std::size_t kSteps = 4;            // of compareMeshes()
constexpr std::size_t kMostDrawn = 300'000;  // triangles of a picture, which readers still open

std::array<NavigationMeshFile, 2> readBoth(const CompareOptions& options, RunContext& context) {
  const std::optional<UpAxis> up = upAxisFrom(options.up);
  std::array<NavigationMeshFile, 2> files;
  files[0] = readNavigationMesh(options.files[0], up, UpAxis::Y, &context);
  // A file that states no axis lies as the other does.
  files[1] = readNavigationMesh(options.files[1], up, files[0].up, &context);
  if (!up && !files[0].statedUp && files[1].statedUp && files[1].up != files[0].up)
    files[0] = readNavigationMesh(options.files[0], files[1].up, UpAxis::Y, &context);
  return files;
}

/// One line, when the meshes differ by more than the options allow; else empty.
std::string differenceOf(const CompareOptions& options, const MeshComparison& comparison) {
  const std::string names = options.files[0] + " and " + options.files[1];
  if (options.failIfDifferent && !comparison.equal())
    return names + " are not the same set of points; " + howDifferent(comparison);
  if (!options.failAbove) return {};
  const double most = std::max(comparison.meshes[0].whole.uncovered.plan, comparison.meshes[1].whole.uncovered.plan);
  if (most <= *options.failAbove) return {};
  std::string text = names + ": an area of ";
  appendNumber(text, most);
  text += " is not covered by the other; at most ";
  appendNumber(text, *options.failAbove);
  return text + " was allowed";
}

/// Says what was drawn, for stdout; nothing with --json.
std::string drawPicture(const CompareOptions& options, const std::array<NavigationMeshFile, 2>& files,
                        CommandSession& session) {
  session.begin("drawing");
  const DistanceBands bands = findDistanceBands(files[0].mesh, files[1].mesh, kMostDrawn, session.context());
  if (bands.isEmpty())
    throw InputError("--picture: there is no distance, because " +
                     options.files[files[0].mesh.triangles.empty() ? 0 : 1] +
                     " has no triangle with an area; leave --picture out");
  writeFileSafely(options.picture, formatDistancePicture(options.picture, bands, options.files));
  session.end();
  return options.json ? std::string() : options.picture + '\n';
}

void compareFiles(const CompareOptions& options) {
  if (options.failAbove && !(std::isfinite(*options.failAbove) && *options.failAbove >= 0))
    throw InputError("--fail-above: must be an area in the files' units; give 0 or more");
  if (!options.picture.empty()) {
    checkPictureName(options.picture);
    WriteTargets targets;
    for (const std::string& file : options.files) targets.protect(file, FOOTFALL_TEXT("one of the two meshes"));
    targets.add(options.picture, FOOTFALL_TEXT("the picture"));
  }
  CommandSession session(options.threads, options.quiet);
  const Stopwatch loading;
  session.begin("loading");
  const auto files = readBoth(options, session.context());
  const double loadMs = loading.wallMs();
  const Stopwatch comparing;
  session.begin("comparing", kSteps);
  const MeshComparison comparison = compareMeshes(files[0].mesh, files[1].mesh, options.comparison, &session.context());
  const ComparisonTimes times{loadMs, comparing.wallMs()};
  session.end();
  print(options.json ? formatComparisonJson(files, comparison, times) : formatComparison(files, comparison, times));
  if (!options.picture.empty()) print(drawPicture(options, files, session));
  const std::string difference = differenceOf(options, comparison);
  if (!difference.empty()) throw RunError(difference);
}

}  // namespace

void addCompareCommand(CLI::App& app) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App& command = *app.add_subcommand("compare", "Report how two navigation meshes differ");
  command
      .add_option("A", options->files[0], "The ground truth: an OBJ file that `footfall run -o` wrote, or any other")
      ->required();
  command.add_option("B", options->files[1], "The OBJ file to compare with it")->required();
  command
      .add_option("--height", options->comparison.height,
                  "The largest difference in height at which two surfaces still cover each other, in the files' units; "
                  "almost 0 by default")
      ->type_name("H");
  command
      .add_option("--error", options->comparison.error,
                  "The accuracy of the bounds of the Hausdorff distances, in the files' units; a thousandth of the "
                  "diagonal by default")
      ->type_name("E");
  addUpAxis(command, "--up", options->up, "The up axis of both files; by default the one that they state, else y");
  command.add_flag("--json", options->json, "Print one JSON object");
  command.add_flag("--fail-if-different", options->failIfDifferent,
                   "Exit with 1 unless both are the same set of points, exactly");
  command
      .add_option("--fail-above", options->failAbove,
                  "Exit with 1 when more than this area of one, in the plan, is not covered by the other")
      ->type_name("AREA");
  command
      .add_option("--picture", options->picture,
                  "Draw A from above, coloured by the distance to B at its vertices, with a legend")
      ->type_name("FILE.svg|.pdf");
  addThreads(command, options->threads);
  command.add_flag("--quiet", options->quiet, "No progress bar");
  command.callback([options] { compareFiles(*options); });
}

}  // namespace footfall::app
