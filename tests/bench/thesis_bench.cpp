// footfall-thesis-bench: the thesis's experiments (5.4 to 5.6) on the samples and on other environments.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <utility>

#include "core/io/export.hpp"
#include "footfall/errors.hpp"
#include "tests/bench/machine.hpp"
#include "tests/bench/thesis_experiments.hpp"
#include "tests/bench/thesis_report.hpp"

namespace {

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::bench;

void chooseExperiments(const std::vector<std::string>& only, ThesisOptions& options) {
  if (only.empty()) return;
  const auto asked = [&](const char* name) { return std::ranges::find(only, name) != only.end(); };
  options.due = asked("due");
  options.printed = asked("printed");
  options.strategies = asked("strategies");
  options.scaling = asked("scaling");
  options.correctness = asked("correctness");
}

// Ascending, each once.
void chooseThreads(std::vector<int> threads, ThesisOptions& options) {
  std::ranges::sort(threads);
  const auto repeated = std::ranges::unique(threads);
  threads.erase(repeated.begin(), repeated.end());
  options.threads = std::move(threads);
}

/// The exit code: 1 when something could not be measured.
int runProgramWith(int argc, char** argv) {
  CLI::App app(
      "Runs the experiments of the thesis (5.4 to 5.6): times by partitioning strategy and depth, scaling over "
      "threads, "
      "and how far parallel results are from sequential ones. Each measurement happens in a process of its own; runs "
      "that are compared take turns.",
      "footfall-thesis-bench");
  std::vector<std::string> files, only;
  double clearance = 2;
  bool samples = false;
  std::string json, markdown;
  ThesisOptions options;
  std::vector<int> threads{1, 2, 4, 8, 16, 32};
  int tableThreads = 0, timeout = 600;
  app.add_option("FILES", files, "Environments, each with the clearance in its units where it is not 2")
      ->type_name("FILE[:HEIGHT]");
  app.add_option("--clearance", clearance, "For files that are given without one; it stands for 2 m")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--samples", samples, "The samples of the repository too, with their pipelines");
  app.add_option("--only", only, "Only these experiments: due, strategies, printed, scaling, correctness")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"due", "strategies", "printed", "scaling", "correctness"}))
      ->type_name("NAME,...");
  app.add_option("--strategy", options.strategyTexts,
                 "A row of the tables by strategy, such as \"SortedRecursiveStrategy 50 5 true\", instead of the usual "
                 "ones; give it once for each")
      ->allow_extra_args(false)
      ->type_name("STRATEGY");
  app.add_option("--threads", threads, "Thread counts of the scaling; more than there are processors take turns")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--table-threads", tableThreads,
                 "Threads of the tables by strategy and of correctness; as many as there are processors by default")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  app.add_option("--runs", options.rounds.runs, "Rounds of each comparison after one warm-up, at least")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--least-seconds", options.rounds.leastSeconds, "Further rounds until so long, for small environments")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--seconds", options.rounds.mostSeconds, "No further round after so long")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--timeout", timeout, "Seconds after which a measurement has failed")
      ->check(CLI::Range(1, 86400))
      ->capture_default_str();
  app.add_option("--json", json, "Write all figures to this file")->type_name("FILE");
  app.add_option("--markdown", markdown, "Write the tables to this file instead of to standard output")
      ->type_name("FILE");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);  // --help
  }

  chooseExperiments(only, options);
  for (const std::string& text : options.strategyTexts) parseStrategy(text);
  chooseThreads(threads, options);
  options.tableThreads = tableThreads > 0 ? tableThreads : processorCount();
  options.limits.time = std::chrono::seconds(timeout);
  if (samples) options.subjects = samplesWithPipelines();
  for (const std::string& file : files) options.subjects.push_back({parseSubject(file, clearance), ""});
  if (options.subjects.empty()) throw InputError("nothing to measure; give files or --samples");

  const Json results = runThesisExperiments(options);
  if (!json.empty()) writeFileSafely(json, results.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
  if (markdown.empty()) {
    std::cout << formatThesisReport(results);
  } else {
    writeFileSafely(markdown, formatThesisReport(results));
  }
  return reportFailures("footfall-thesis-bench", results);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return runProgramWith(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::cerr << "footfall-thesis-bench: " << error.what() << "; --help tells what can be given\n";
    return 2;
  } catch (const InputError& error) {
    std::cerr << "footfall-thesis-bench: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "footfall-thesis-bench: " << error.what() << '\n';
    return 1;
  }
}
