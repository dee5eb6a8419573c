// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/thesis_experiments.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "footfall/version.hpp"
#include "tests/bench/machine.hpp"
#include "tests/bench/markdown.hpp"
#include "tests/bench/thesis_correctness.hpp"
#include "tests/bench/thesis_figures.hpp"

namespace footfall::bench {
namespace {

constexpr int kDueThreads = 2;
constexpr const char* kAuto = "AutoStrategy";
// The thesis's choice for 5.5 and 5.6.
constexpr const char* kSortedFour = "SortedRecursiveStrategy 50 4 true";
// Used in its parallel listing (5.4).
constexpr const char* kSortedThree = "SortedRecursiveStrategy 50 3 true";

constexpr std::array kPhases{"preprocessing_ms", "partitioning_ms",   "parallel_ms",
                             "merging_ms",       "postprocessing_ms", "overhead_ms"};

std::vector<std::string> defaultStrategies(const std::string& name) {
  std::vector<std::string> texts{"GridStrategy 2 2", "GridStrategy 3 3", "GridStrategy 4 4"};
  if (name == "tower") texts = {"GridStrategy 2 1", "GridStrategy 2 2"};
  for (const char* text :
       {"RecursiveStrategy 50 2 true", "RecursiveStrategy 50 3 true", "SortedRecursiveStrategy 50 2 true", kSortedThree,
        kSortedFour, "HeightAwareStrategy 50 2", "HeightAwareStrategy 50 3", "HeightAwareStrategy 50 4", kAuto})
    texts.emplace_back(text);
  return texts;
}

Json thesisRunJson(const ThesisRun& run) {
  Json json{{"total_ms", run.totalMs}};
  json["speed_up"] = run.speedUp ? Json(*run.speedUp) : Json();
  for (std::size_t i = 0; i < kPhases.size(); ++i)
    json[kPhases[i]] = run.phasesMs[i] < 0 ? Json() : Json(run.phasesMs[i]);
  return json;
}

class Experiments {
 public:
  explicit Experiments(const ThesisOptions& options) : options_(options) {}

  Json run() const {
    Json results;
    results["program"] = {{"version", FOOTFALL_VERSION}};
    results["machine"] = describeMachine();
    results["processors"] = processorCount();
    results["threads"] = options_.threads;
    results["table_threads"] = options_.tableThreads;
    results["due_threads"] = kDueThreads;
    results["runs"] = options_.rounds.runs;
    results["environments"] = Json::array();
    for (const ThesisSubject& subject : options_.subjects) results["environments"].push_back(measure(subject));
    results["due"] = judge(results["environments"]);
    return results;
  }

 private:
  struct Labelled {
    std::string label;
    Configuration configuration;
  };

  static void tell(const ThesisSubject& subject, const std::string& what) {
    std::fprintf(stderr, "%s: %s\n", subject.subject.name.c_str(), what.c_str());
  }

  Json measure(const ThesisSubject& subject) const {
    Json entry;
    entry["name"] = subject.subject.name;
    entry["sample"] = subject.isSample();
    entry["clearance"] = subject.subject.clearance;
    const Json size = memoryOf(subject, {});
    entry.update(size.contains("fails") ? size : Json{{"triangles", size["triangles"]}});
    if (entry.contains("fails")) return entry;
    if (options_.due && processorCount() >= kDueThreads) entry["due"] = measureDue(subject);
    if (options_.strategies) entry["strategies"] = measureStrategies(subject);
    if (options_.printed && subject.isSample()) entry["printed"] = measurePrinted(subject);
    if (options_.scaling) entry["scaling"] = measureScaling(subject);
    if (options_.correctness) entry["correctness"] = measureAllCorrectness(subject);
    return entry;
  }

  Json memoryOf(const ThesisSubject& subject, const Configuration& configuration) const {
    return runIsolated([&] { return measureMemory(subject, configuration); }, options_.limits);
  }

  // One entry a configuration, each with the reason when all fail together.
  Json timesOf(const ThesisSubject& subject, const std::vector<Configuration>& configurations) const {
    Json list = runIsolated([&] { return measureTimes(subject, configurations, options_.rounds); }, options_.limits);
    if (list.is_array()) return list;
    Json failures = Json::array();
    for (std::size_t i = 0; i < configurations.size(); ++i) failures.push_back(list);
    return failures;
  }

  Json measureDue(const ThesisSubject& subject) const {
    tell(subject, "Auto on " + threadText(kDueThreads) + " against one thread");
    const FilterList own = FilterList::Own;
    Json times = timesOf(subject, {{own, "", 1}, {own, "", kDueThreads}, {own, kAuto, kDueThreads}});
    for (std::size_t i = 1; i < times.size(); ++i) addSpeedUp(times[0], times[i]);
    return {{"sequential", times[0]}, {"plain", times[1]}, {"auto", times[2]}};
  }

  static void addSpeedUp(const Json& sequential, Json& entry) {
    if (sequential.contains("total_ms") && entry.contains("total_ms"))
      entry["speed_up"] = sequential["total_ms"].get<double>() / entry["total_ms"].get<double>();
  }

  // The first is what the others are compared with.
  std::vector<Labelled> strategyRows(const ThesisSubject& subject) const {
    const FilterList filters = subject.isSample() ? FilterList::ThesisSequential : FilterList::Own;
    const int threads = options_.tableThreads;
    std::vector<Labelled> rows{{"no block, 1 thread", {filters, "", 1}}};
    if (threads > 1) rows.push_back({"no block, " + threadText(threads), {filters, "", threads}});
    const std::vector<std::string> texts =
        options_.strategyTexts.empty() ? defaultStrategies(subject.subject.name) : options_.strategyTexts;
    for (const std::string& text : texts) rows.push_back({describeStrategy(text), {filters, text, threads}});
    if (subject.isSample() && options_.strategyTexts.empty())
      rows.push_back({"the thesis's parallel listing", {FilterList::ThesisParallel, kSortedThree, threads}});
    return rows;
  }

  Json measureStrategies(const ThesisSubject& subject) const {
    const std::vector<Labelled> rows = strategyRows(subject);
    Json memory = Json::array();
    std::vector<Configuration> runnable;
    for (const Labelled& row : rows) {
      tell(subject, row.label + ", memory");
      memory.push_back(memoryOf(subject, row.configuration));
      if (!memory.back().contains("fails")) runnable.push_back(row.configuration);
    }
    tell(subject, "times by strategy");
    const Json times = timesOf(subject, runnable);
    Json list = Json::array();
    std::size_t next = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Configuration& configuration = rows[i].configuration;
      Json entry{{"label", rows[i].label}, {"strategy", configuration.strategy}, {"threads", configuration.threads}};
      if (memory[i].contains("fails")) {
        entry["fails"] = memory[i]["fails"];
      } else {
        entry["peak_bytes"] = memory[i]["peak_bytes"];
        entry.update(times[next++]);
      }
      if (i > 0) addSpeedUp(list[0], entry);
      if (const auto thesis = findThesisRun(subject.subject.name, configuration.strategy);
          thesis && subject.isSample() && configuration.filters == FilterList::ThesisSequential)
        entry["thesis"] = thesisRunJson(*thesis);
      list.push_back(std::move(entry));
    }
    return list;
  }

  // 60 degrees, 3 and 500 in the units of the file, whatever they are there.
  Json measurePrinted(const ThesisSubject& subject) const {
    tell(subject, "the listings as they are printed");
    const Configuration sequential{FilterList::PrintedSequential, "", 1};
    const Configuration parallel{FilterList::PrintedParallel, "", options_.tableThreads};
    Json times = timesOf(subject, {sequential, parallel});
    addSpeedUp(times[0], times[1]);
    return {{"sequential", times[0]}, {"parallel", times[1]}};
  }

  Json measureScaling(const ThesisSubject& subject) const {
    tell(subject, "scaling over threads");
    std::vector<Labelled> lines{{"Auto", {FilterList::Own, kAuto, 1}},
                                {describeStrategy(kSortedFour), {FilterList::Own, kSortedFour, 1}},
                                {"no block", {FilterList::Own, "", 1}}};
    if (subject.isSample()) {
      for (const char* text : {"GridStrategy 4 4", "RecursiveStrategy 50 3 true", "HeightAwareStrategy 50 4"})
        lines.push_back({describeStrategy(text), {FilterList::Own, text, 1}});
    }
    std::vector<Configuration> configurations{{FilterList::Own, "", 1}};
    for (const Labelled& line : lines) {
      for (const int threads : options_.threads) {
        configurations.push_back(line.configuration);
        configurations.back().threads = threads;
      }
    }
    Json times = timesOf(subject, configurations);
    if (times[0].contains("fails")) return times[0];
    Json scaling{{"sequential_ms", times[0]["total_ms"]}, {"lines", Json::array()}};
    std::size_t next = 1;
    for (const Labelled& line : lines) {
      Json points = Json::array();
      for (const int threads : options_.threads) {
        Json point{{"threads", threads}};
        point.update(times[next++]);
        addSpeedUp(times[0], point);
        if (point.contains("speed_up")) point["efficiency"] = point["speed_up"].get<double>() / threads;
        points.push_back(std::move(point));
      }
      scaling["lines"].push_back({{"label", line.label}, {"points", std::move(points)}});
    }
    return scaling;
  }

  Json measureAllCorrectness(const ThesisSubject& subject) const {
    tell(subject, "correctness");
    const int threads = options_.tableThreads;
    struct Pair {
      const char* label;
      Configuration sequential, parallel;
    };
    std::vector<Pair> pairs{
        {"same filters", {FilterList::Own, "", 1}, {FilterList::Own, kSortedFour, threads}},
        {"the thesis's listings",
         {FilterList::ThesisSequential, "", 1},
         {FilterList::ThesisParallel, kSortedFour, threads}},
    };
    Json list = Json::array();
    for (const Pair& pair : pairs) {
      Json entry{{"label", pair.label}, {"metres_per_unit", subject.subject.metresPerUnit()}};
      entry.update(
          runIsolated([&] { return measureCorrectness(subject, pair.sequential, pair.parallel); }, options_.limits));
      if (const auto thesis = findThesisCorrectness(subject.subject.name); thesis && subject.isSample())
        entry["thesis"] = {{"min", thesis->min},
                           {"max", thesis->max},
                           {"mean", thesis->mean},
                           {"rms", thesis->rms},
                           {"max_units", thesis->maxUnits},
                           {"mean_units", thesis->meanUnits},
                           {"rms_units", thesis->rmsUnits},
                           {"areas", {thesis->sequentialArea, thesis->parallelArea}},
                           {"covered", thesis->parallelArea / thesis->sequentialArea}};
      list.push_back(std::move(entry));
    }
    return list;
  }

  // Judges the requirements, for each environment.
  static Json judge(const Json& environments) {
    constexpr int kLarge = 20'000;
    constexpr double kDueLarge = 1.7, kDueSmall = 0.95, kDueTower = 1.0, kDueShare = 0.15;
    Json list = Json::array();
    const auto add = [&](const Json& environment, const char* what, double due, bool atLeast, const char* figure) {
      const Json& measured = environment["due"]["auto"];
      Json entry{{"environment", &environment - &environments.front()},
                 {"name", environment["name"]},
                 {"triangles", environment["triangles"]},
                 {"what", what},
                 {"due", due},
                 {"at_least", atLeast},
                 {"measured", Json()},
                 {"met", false}};
      if (measured.contains(figure)) {
        const double value = measured[figure];
        entry["measured"] = value;
        entry["met"] = atLeast ? value >= due : value <= due;
      }
      list.push_back(std::move(entry));
    };
    for (const Json& environment : environments) {
      if (!environment.contains("due")) continue;
      const bool tower = environment["sample"].get<bool>() && environment["name"] == "tower";
      const bool large = environment["triangles"].get<int>() >= kLarge;
      add(environment, "speed-up", tower ? kDueTower : large ? kDueLarge : kDueSmall, true, "speed_up");
      add(environment, "partitioning and merging", kDueShare, false, "cut_share");
    }
    return list;
  }

  const ThesisOptions& options_;
};

}  // namespace

Json runThesisExperiments(const ThesisOptions& options) { return Experiments(options).run(); }

}  // namespace footfall::bench
