// footfall-rounding-experiment: what cutting obstacles and rounding the cuts costs (thesis 5.1.1), beside Footfall's
// own way, and how far its result is from the exact one (thesis 5.5).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "core/base/counted_text.hpp"
#include "core/io/export.hpp"
#include "footfall/compare.hpp"
#include "footfall/errors.hpp"
#include "tests/bench/machine.hpp"
#include "tests/bench/markdown.hpp"
#include "tests/bench/rounding_experiment/experiment_run.hpp"
#include "tests/bench/thesis_measurement.hpp"

namespace {

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::bench;

struct Options {
  std::vector<ThesisSubject> subjects;
  std::vector<std::string> strategies;
  int threads = 2, runs = 3;
  bool repair = true;
};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

Json casesJson(const CutCases& cases) {
  return {{"case_1", cases.exact},     {"case_2", cases.edge},    {"case_3", cases.point},
          {"case_4", cases.collinear}, {"case_5", cases.flipped}, {"only_moved", cases.moved}};
}

Json comparisonJson(const NavigationMesh& sequential, const NavigationMesh& experiment, double metresPerUnit) {
  const MeshComparison comparison = compareMeshes(sequential, experiment);
  Json json;
  json["sets_equal"] = comparison.equal();
  if (const auto ratio = comparison.areaRatio()) json["covered"] = *ratio;
  if (comparison.distances) {
    const SurfaceDistances& d = (*comparison.distances)[0];
    json["metres"] = {{"min", d.min * metresPerUnit},
                      {"max", d.max * metresPerUnit},
                      {"mean", d.mean * metresPerUnit},
                      {"rms", d.rms * metresPerUnit}};
  }
  return json;
}

/// Times of the experiment, and in turns with it of Footfall's sequential run and of its run with the same strategy.
Json timesJson(const ThesisSubject& subject, const std::shared_ptr<const Environment>& environment,
               const Pipeline& pipeline, const std::string& strategy, const Options& options, Json& figures) {
  std::vector<ExperimentResult> results;
  std::vector<double> sequential, sequentialCpu, own, ownCpu;
  for (int i = 0; i < options.runs; ++i) {
    results.push_back(runExperiment(environment, pipeline, options.repair, options.threads));
    const RunResult one = runConfiguration(subject, environment, {FilterList::ThesisSequential, "", 1});
    sequential.push_back(one.times.total);
    sequentialCpu.push_back(one.cpuMs);
    const RunResult many =
        runConfiguration(subject, environment, {FilterList::ThesisSequential, strategy, options.threads});
    own.push_back(many.times.total);
    ownCpu.push_back(many.cpuMs);
  }
  const auto of = [&](double ExperimentTimes::*phase) {
    std::vector<double> values;
    for (const ExperimentResult& result : results) values.push_back(result.times.*phase);
    return median(values);
  };
  const double cpu = of(&ExperimentTimes::cpu);
  figures = comparisonJson(*runConfiguration(subject, environment, {FilterList::ThesisSequential, "", 1}).mesh,
                           *results.front().mesh, subject.subject.metresPerUnit());
  const ExperimentResult& first = results.front();
  return {{"cells", first.cells},
          {"triangles", first.triangles},
          {"cut_triangles", first.cutTriangles},
          {"cut_vertices", first.cutVertices},
          {"preprocessing_ms", of(&ExperimentTimes::preprocessing)},
          {"partitioning_ms", of(&ExperimentTimes::partitioning)},
          {"parallel_ms", of(&ExperimentTimes::parallel)},
          {"merging_ms", of(&ExperimentTimes::merging)},
          {"postprocessing_ms", of(&ExperimentTimes::postprocessing)},
          {"total_ms", of(&ExperimentTimes::total)},
          {"cpu_ms", cpu},
          {"sequential_ms", median(sequential)},
          {"sequential_cpu_ms", median(sequentialCpu)},
          {"own_ms", median(own)},
          {"own_cpu_ms", median(ownCpu)},
          {"cpu_over_sequential", cpu / median(sequentialCpu)}};
}

Json measureStrategy(const ThesisSubject& subject, const std::string& strategy, const Options& options) {
  const auto environment = loadSubject(subject.subject);
  const Pipeline pipeline = makeThesisPipeline(subject, *environment, FilterList::ThesisParallel, strategy);
  Json entry{{"environment", subject.subject.name}, {"strategy", strategy}, {"repair", options.repair}};
  Json figures;
  entry.update(timesJson(subject, environment, pipeline, strategy, options, figures));
  entry["comparison"] = std::move(figures);
  entry["cases"] = casesJson(countExperimentCases(environment, pipeline, options.threads));  // after all that is timed
  return entry;
}

std::string format(const Json& entries) {
  Table times({"environment", "cells by", "triangles", "after the cuts", "t_pre", "t_part", "t_parallel", "t_merge",
               "t_post", "total", "Footfall, 1 thread", "the same cells", "processor time over 1 thread"},
              2);
  Table results({"environment", "cells by", "case 1", "case 2", "case 3", "case 4", "case 5", "only moved", "d_max, m",
                 "d_rms, m", "covered"},
                2);
  std::string notes;
  for (const Json& e : entries) {
    const std::string name = e["environment"], strategy = e["strategy"];
    if (e.contains("fails")) {
      notes += name + ", " + strategy + ": " + e["fails"].get<std::string>() + "\n";
      continue;
    }
    const auto ms = [&](const char* key) { return number(e[key]); };
    times.addRow({name, describeStrategy(strategy), grouped(e["triangles"]), grouped(e["cut_triangles"]),
                  ms("preprocessing_ms"), ms("partitioning_ms"), ms("parallel_ms"), ms("merging_ms"),
                  ms("postprocessing_ms"), ms("total_ms"), ms("sequential_ms"), ms("own_ms"),
                  number(e["cpu_over_sequential"])});
    std::vector<std::string> row{name, describeStrategy(strategy)};
    for (const char* key : {"case_1", "case_2", "case_3", "case_4", "case_5", "only_moved"})
      row.push_back(grouped(e["cases"][key]));
    const Json& comparison = e["comparison"];
    for (const char* key : {"max", "rms"})
      row.push_back(comparison.contains("metres") ? formatted(comparison["metres"][key].get<double>(), "%.2g") : "-");
    row.push_back(comparison.contains("covered") ? formatted(comparison["covered"].get<double>(), "%.9f") : "-");
    results.addRow(row);
  }
  return times.text() + results.text() + notes;
}

void runProgramWith(int argc, char** argv) {
  CLI::App app(
      "Repeats what the thesis tried in 5.1.1: all triangles, obstacles too, are cut along the cells, cut points are "
      "rounded, and cases 2 to 5 are repaired. Footfall itself does none of this. Times leave out counting the cases.",
      "footfall-rounding-experiment");
  std::vector<std::string> files;
  double clearance = 2;
  Options options;
  std::string json;
  bool isUnrepaired = false, samples = false;
  int timeout = 600;
  app.add_option("FILES", files, "Environments, each with the clearance in its units where it is not 2")
      ->type_name("FILE[:HEIGHT]");
  app.add_flag("--samples", samples, "The samples of the repository too, with their pipelines");
  app.add_option("--strategy", options.strategies, "Such as \"GridStrategy 2 2\"; give it once for each")
      ->allow_extra_args(false)
      ->type_name("STRATEGY");
  app.add_option("--threads", options.threads, "Threads of the runs with cells")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--runs", options.runs, "Runs of each, in turns; medians are told")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_flag("--no-repair", isUnrepaired, "Leave what rounding breaks to the filters");
  app.add_option("--timeout", timeout, "Seconds after which a measurement has failed")
      ->check(CLI::Range(1, 86400))
      ->capture_default_str();
  app.add_option("--json", json, "Write all figures to this file")->type_name("FILE");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    app.exit(success);  // --help
    return;
  }
  options.repair = !isUnrepaired;
  if (options.strategies.empty())
    options.strategies = {"GridStrategy 2 1", "GridStrategy 2 2", "SortedRecursiveStrategy 50 3 true"};
  for (const std::string& text : options.strategies) parseStrategy(text);
  if (samples) options.subjects = samplesWithPipelines();
  for (const std::string& file : files) options.subjects.push_back({parseSubject(file, clearance), ""});
  if (options.subjects.empty()) throw InputError("nothing to measure; give files or --samples");

  Json entries = Json::array();
  for (const ThesisSubject& subject : options.subjects) {
    for (const std::string& strategy : options.strategies) {
      Json entry =
          runIsolated([&] { return measureStrategy(subject, strategy, options); }, {std::chrono::seconds(timeout), 0});
      if (entry.contains("fails")) entry.update(Json{{"environment", subject.subject.name}, {"strategy", strategy}});
      entries.push_back(std::move(entry));
    }
  }
  const Json all{
      {"machine", describeMachine()}, {"threads", options.threads}, {"runs", options.runs}, {"entries", entries}};
  if (!json.empty()) writeFileSafely(json, all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
  std::cout << format(entries);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    runProgramWith(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    std::cerr << "footfall-rounding-experiment: " << error.what() << "; --help tells what can be given\n";
    return 2;
  } catch (const InputError& error) {
    std::cerr << "footfall-rounding-experiment: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "footfall-rounding-experiment: " << error.what() << '\n';
    return 1;
  }
}
