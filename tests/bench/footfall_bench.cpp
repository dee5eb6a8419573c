// footfall-bench: where the time goes, and what others need for the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "core/io/export.hpp"
#include "footfall/errors.hpp"
#include "tests/bench/benchmark.hpp"
#include "tests/bench/path_measurement.hpp"
#include "tests/bench/report.hpp"
#include "tests/bench/scene_report.hpp"
#include "tests/bench/targets.hpp"

namespace {

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::bench;

void addPathOptions(CLI::App& app, PathPairs& paths) {
  app.add_option("--paths", paths.pairs,
                 "Instead of times: paths for a radius between so many random pairs of places, on the corridor map and "
                 "behind a RadiusFilter; the exit code is 1 when only one has a path, or a longer one")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("PAIRS");
  app.add_option("--radius", paths.radius, "With --paths: the radius, in metres")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--longest", paths.longest,
                 "With --paths: a path on the map is at most as many times as long as that behind the filter")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

/// The exit code: 1 when something could not be measured, or when a claim about paths failed.
int runProgramWith(int argc, char** argv) {
  CLI::App app(
      "Measures Footfall on environments, in one run beside Recast's voxels, the time that reading the file and "
      "Embree's tree take, and a prototype. Each measurement happens in a process of its own.",
      "footfall-bench");
  std::vector<std::string> files, turned;
  double clearance = 2;
  bool samples = false, noRecast = false, noEmbree = false;
  std::string json, markdown;
  BenchmarkOptions options;
  int timeout = 300;
  app.add_option("FILES", files, "Environments, each with the clearance in its units where it is not 2")
      ->type_name("FILE[:HEIGHT]");
  app.add_option("--clearance", clearance, "For files that are given without one; it stands for 2 m")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--samples", samples, "The samples of the repository too");
  app.add_flag("--growth", options.growth, "Generated environments of up to a million triangles too");
  app.add_option("--cancel", options.cancelMoments,
                 "Cancel runs of each environment (of the generated ones the largest) at so many moments")
      ->check(CLI::Range(1, 1000))
      ->type_name("MOMENTS");
  app.add_flag("--live", options.live, "Edits of each environment and of a generated terrain too");
  app.add_option("--crate", options.crateEdits,
                 "Instead of all else: a crate is moved by half a metre, so many times at each of five places, with "
                 "the default pipeline, and with a RadiusFilter of 0.3 m; processor time of each step")
      ->check(CLI::Range(1, 1000))
      ->type_name("EDITS");
  app.add_option("--exports", options.exports,
                 "Write meshes of so many triangles in each format, such as 60000,1000000: time and size")
      ->delimiter(',')
      ->check(CLI::Range(2U, 10'000'000U))
      ->type_name("TRIANGLES");
  app.add_flag("--reach", options.reach,
               "Instead of times: how likely two random places are connected, without steps, with them, and in Recast");
  app.add_option("--step", options.step, "With --reach and --paths: how high agents climb at once, in metres")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addPathOptions(app, options.paths);
  app.add_flag(
      "--scenes", options.scenes,
      "Instead of all else: FILES as scenes and one generated scene of each kind, beside Recast, with a radius, "
      "on and off the grid; and levels that are turned (--turned, --samples)");
  app.add_option("--scene-triangles", options.sceneTriangles, "With --scenes: triangles of a generated scene")
      ->check(CLI::Range(100U, 10'000'000U))
      ->capture_default_str();
  app.add_option("--turned", turned, "With --scenes: levels to turn by 17 degrees, as FILES")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("FILE[:HEIGHT],...");
  app.add_option("--runs", options.repetition.runs, "Runs of each measurement after one warm-up")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--seconds", options.repetition.seconds, "No further run of a measurement after so long")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--threads", options.threads, "Thread counts; peers are compared at the largest")
      ->delimiter(',')
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--timeout", timeout, "Seconds after which a measurement has failed")
      ->check(CLI::Range(1, 86400))
      ->capture_default_str();
  app.add_option("--prototype", options.prototype,
                 "The program of another implementation, for OBJ with Y up, called "
                 "as: PROGRAM ENV.obj CLEARANCE OUT.obj THREADS")
      ->check(CLI::ExistingFile)
      ->type_name("PROGRAM");
  app.add_flag("--no-recast", noRecast, "Leave Recast out");
  app.add_flag("--no-embree", noEmbree, "Leave Embree out");
  app.add_option("--json", json, "Write all figures to this file")->type_name("FILE");
  app.add_option("--markdown", markdown, "Write the tables to this file instead of to standard output")
      ->type_name("FILE");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);  // --help
  }

  std::ranges::sort(options.threads);
  options.recast = !noRecast;
  options.embree = !noEmbree;
  options.limits.time = std::chrono::seconds(timeout);
  for (const std::string& file : files) options.given.push_back(parseSubject(file, clearance));
  for (const std::string& file : turned) options.turned.push_back(parseSubject(file, clearance));
  if (samples) options.samples = sampleSubjects();
  if (options.given.empty() && options.samples.empty() && !options.growth && !options.live && options.exports.empty() &&
      !options.scenes)
    throw InputError("nothing to measure; give files, --samples, --growth, --live, --exports or --scenes");
  if (!turned.empty() && !options.scenes) throw InputError("--turned belongs to --scenes; give that, too");

  Json results = runBenchmark(options);
  const bool hasTargets = !options.reach && options.paths.pairs == 0 && options.crateEdits == 0;
  results["targets"] = options.scenes ? judgeScenes(results) : hasTargets ? judgeTargets(results) : Json::array();
  const std::string tables = options.scenes ? formatScenes(results) : formatReport(results);
  if (!json.empty()) writeFileSafely(json, results.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
  if (markdown.empty()) {
    std::cout << tables;
  } else {
    writeFileSafely(markdown, tables);
  }
  return std::max(reportFailures("footfall-bench", results), reportFailedClaims("footfall-bench", results));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return runProgramWith(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::cerr << "footfall-bench: " << error.what() << "; --help tells what can be given\n";
    return 2;
  } catch (const InputError& error) {
    std::cerr << "footfall-bench: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "footfall-bench: " << error.what() << '\n';
    return 1;
  }
}
