// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/thesis_report.hpp"

#include <array>
#include <cstdio>

#include "tests/bench/markdown.hpp"
#include "tests/bench/thesis_figures.hpp"

namespace footfall::bench {
namespace {

std::string formatted(const char* format, double value) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

// "1.72"; the thesis's least speed-up needs more digits.
std::string ratio(double value) { return formatted(value < 0.0995 ? "%.2g" : "%.2f", value); }

std::string percent(double share) { return formatted("%.1f %%", 100 * share); }

std::string figure(const Json& entry, const char* key) {
  return entry.contains(key) ? number(entry[key]) : std::string();
}

std::string failure(const Json& entry) { return "fails: " + entry["fails"].get<std::string>(); }

// t_preprocessing to t_overhead (5.4).
constexpr std::array kPhases{"preprocessing_ms", "partitioning_ms",   "parallel_ms",
                             "merging_ms",       "postprocessing_ms", "overhead_ms"};

class ThesisReport {
 public:
  explicit ThesisReport(const Json& results) : results_(results) {}

  std::string format() {
    std::string text = "Footfall " + results_["program"]["version"].get<std::string>() + " on " + processors() +
                       ". Times are in ms: medians of at least " + std::to_string(results_["runs"].get<int>()) +
                       " runs after one warm-up." + otherWork() + "\n\n" + failures();
    if (has("due")) text += "### What is due\n\n" + due();
    if (has("strategies")) text += "### By strategy and depth, " + tableThreads() + " (thesis, 5.4)\n\n" + strategies();
    if (has("printed"))
      text += "### The listings as they are printed, " + tableThreads() + " (thesis, 5.4)\n\n" + printed();
    if (has("scaling")) text += "### Scaling over threads (thesis, 5.6)\n\n" + scaling();
    if (has("correctness")) text += "### Correctness (thesis, 5.5)\n\n" + correctness();
    return text;
  }

 private:
  [[nodiscard]] std::string processors() const {
    const int count = results_["processors"];
    return "a machine with " + std::to_string(count) + (count == 1 ? " processor" : " processors");
  }
  // The load of the last minute before the measurement.
  [[nodiscard]] std::string otherWork() const {
    constexpr double kIdle = 0.5;
    const Json& load = results_["machine"]["load"];
    if (load.is_null() || load.get<double>() <= kIdle) return "";
    return " **Other work ran on this machine** (a load of " + number(load) +
           " at the start): times are too long, and two threads gain less than they do alone.";
  }
  [[nodiscard]] std::string tableThreads() const { return threadText(results_["table_threads"]); }
  [[nodiscard]] bool has(const char* experiment) const {
    for (const Json& environment : results_["environments"])
      if (environment.contains(experiment)) return true;
    return false;
  }
  [[nodiscard]] std::string failures() const {
    std::string text;
    for (const Json& environment : results_["environments"]) {
      if (environment.contains("fails"))
        text += "- " + environment["name"].get<std::string>() + ' ' + failure(environment) + '\n';
    }
    return text.empty() ? text : text + '\n';
  }

  std::string due() const {
    const std::string threads = threadText(results_["due_threads"]);
    Table table({"environment", "triangles", "1 thread", threads + ", no block", threads + ", Auto", "cells", "S",
                 "at least", "", "part. + merging", "at most", ""});
    int met = 0, all = 0;
    for (const Json& environment : results_["environments"]) {
      if (!environment.contains("due")) continue;
      const Json& times = environment["due"];
      std::vector<std::string> row{environment["name"],
                                   grouped(environment["triangles"]),
                                   figure(times["sequential"], "total_ms"),
                                   figure(times["plain"], "total_ms"),
                                   figure(times["auto"], "total_ms"),
                                   times["auto"].contains("cells") ? grouped(times["auto"]["cells"]) : ""};
      for (const Json& judged : results_["due"]) {
        if (judged["environment"] != &environment - &results_["environments"].front()) continue;
        const bool isRatio = judged["at_least"];
        const auto text = [&](const Json& value, const char* ratioFormat) {
          return isRatio ? formatted(ratioFormat, value) : percent(value);
        };
        row.insert(row.end(), {judged["measured"].is_null() ? "fails" : text(judged["measured"], "%.3f"),
                               text(judged["due"], "%.2f"), judged["met"].get<bool>() ? "met" : "**missed**"});
        met += judged["met"].get<bool>() ? 1 : 0;
        ++all;
      }
      table.addRow(row);
    }
    return table.text() + std::to_string(met) + " of " + std::to_string(all) +
           " are met. Filters: the sample's own pipeline, else the default pipeline. *S*: the time of 1 thread over "
           "that "
           "of Auto. *part. + merging*: their share of the total.\n\n";
  }

  std::string strategies() const {
    std::string text;
    for (const Json& environment : results_["environments"])
      if (environment.contains("strategies")) text += strategiesOf(environment);
    return text +
           "Times in ms; *pre* to *overh.* are the thesis's t_preprocessing, t_partitioning, t_parallel, t_merging, "
           "t_postprocessing and t_overhead. *imbal.*: load imbalance. *MB*: the peak of a process that loads the "
           "environment and runs once. *the thesis's parallel listing*: sorted recursive of depth 3, and it rounds and "
           "simplifies approximately, which the others do not; its S is over the first row too, as in the thesis. *the "
           "thesis*: its own figures for the row above, with 32 threads on 16 cores; ?: scrambled in the text that we "
           "have.\n\n";
  }

  static std::string strategiesOf(const Json& environment) {
    const std::string name = environment["name"];
    Table table(
        {"cells by", "total", "S", "pre", "part.", "parallel", "merge", "post", "overh.", "cells", "imbal.", "MB"});
    std::string notes;
    int compared = 0, equal = 0;
    for (const Json& entry : environment["strategies"]) {
      const std::string label = entry["label"];
      std::vector<std::string> row{label};
      if (entry.contains("fails")) {
        row.insert(row.end(), 11, "");
        row[1] = "fails";
        notes += label + ' ' + failure(entry) + ". ";
      } else {
        const std::vector<std::string> cells = strategyFigures(entry);
        row.insert(row.end(), cells.begin(), cells.end());
      }
      table.addRow(row);
      if (entry.contains("thesis")) table.addRow(thesisRow(entry["thesis"]));
      if (entry.contains("bytes_equal")) {
        ++compared;
        equal += entry["bytes_equal"].get<bool>() ? 1 : 0;
        if (!entry["bytes_equal"].get<bool>()) notes += label + " gives **other bytes** than the first row. ";
      }
      if (entry["strategy"] == "AutoStrategy" && entry.contains("reason"))
        notes += label + ": " + entry["reason"].get<std::string>() + ' ';
    }
    notes += std::to_string(equal) + " of " + std::to_string(compared) +
             " other ways to run these filters give the bytes of the first row.";
    return "#### " + name + ", " + grouped(environment["triangles"]) + " triangles\n\n" + filtersOf(environment) +
           table.text() + notes + "\n\n";
  }

  static std::vector<std::string> strategyFigures(const Json& entry) {
    std::vector<std::string> cells{figure(entry, "total_ms"),
                                   entry.contains("speed_up") ? ratio(entry["speed_up"]) : ""};
    const bool block = entry.contains("cells");
    for (const char* phase : kPhases) cells.push_back(block ? figure(entry, phase) : "");
    cells.push_back(block ? grouped(entry["cells"]) : "");
    cells.push_back(block ? ratio(entry["imbalance"]) : "");
    cells.push_back(megabytes(entry["peak_bytes"]));
    return cells;
  }

  static std::vector<std::string> thesisRow(const Json& thesis) {
    std::vector<std::string> row{"*the thesis*", grouped(thesis["total_ms"]),
                                 thesis["speed_up"].is_null() ? "-" : ratio(thesis["speed_up"])};
    for (const char* phase : kPhases) row.push_back(thesis[phase].is_null() ? "?" : grouped(thesis[phase]));
    row.insert(row.end(), {"", "", ""});
    return row;
  }

  [[nodiscard]] std::string printed() const {
    Table table({"environment", "listing", "total", "S", "pre", "part.", "parallel", "merge", "post", "overh.", "cells",
                 "triangles left", "area left"},
                2);
    std::string notes;
    for (const Json& environment : results_["environments"]) {
      if (!environment.contains("printed")) continue;
      for (const char* which : {"sequential", "parallel"}) {
        const Json& entry = environment["printed"][which];
        const std::string name = environment["name"];
        if (entry.contains("fails")) {
          notes += name + ", " + which + ' ' + failure(entry) + ". ";
          continue;
        }
        std::vector<std::string> row{name, which, figure(entry, "total_ms"),
                                     entry.contains("speed_up") ? ratio(entry["speed_up"]) : ""};
        for (const char* phase : kPhases) row.push_back(entry.contains("cells") ? figure(entry, phase) : "");
        row.insert(row.end(), {entry.contains("cells") ? grouped(entry["cells"]) : "", grouped(entry["triangles"]),
                               groupedWithDecimals(entry["area"], 1)});
        table.addRow(row);
      }
    }
    return "The two listings with the numbers that are printed there: 60 degrees, 3, 0.005 and 500, in the unit of "
           "each "
           "file, and `SmartRecursiveStrategy 50 3 true`. Our samples are in metres: a clearance of 3 m and areas of "
           "500 square metres leave less than their own pipelines do. Areas are in the plan.\n\n" +
           table.text() + (notes.empty() ? "" : notes + "\n\n");
  }

  static std::string filtersOf(const Json& environment) {
    if (!environment["sample"].get<bool>())
      return "Filters: the default pipeline with a clearance of " + number(environment["clearance"]) + ".\n\n";
    std::string text = "Filters: the thesis's sequential listing.";
    if (const auto thesis = findThesisEnvironment(environment["name"])) {
      text += " Its own environment had " + grouped(thesis->triangles) + " triangles; its sequential pipeline ";
      text += thesis->sequentialMs == 0   ? "never ended"
              : thesis->sequentialIsBound ? "ran out of memory after " + grouped(thesis->sequentialMs) + " ms"
                                          : "took " + grouped(thesis->sequentialMs) + " ms";
      text += '.';
    }
    return text + "\n\n";
  }

  std::string scaling() const {
    std::vector<std::string> header{"environment", "cells by", "1 thread, no block"};
    for (const Json& threads : results_["threads"]) header.push_back("S (E), " + threadText(threads));
    Table table(header, 2);
    std::string notes;
    for (const Json& environment : results_["environments"]) {
      if (!environment.contains("scaling")) continue;
      const Json& scaling = environment["scaling"];
      const std::string name = environment["name"];
      if (scaling.contains("fails")) {
        notes += name + ' ' + failure(scaling) + ". ";
        continue;
      }
      for (const Json& line : scaling["lines"]) {
        const bool first = &line == &scaling["lines"].front();
        std::vector<std::string> row{first ? name : "", line["label"], first ? number(scaling["sequential_ms"]) : ""};
        for (const Json& point : line["points"]) {
          row.push_back(point.contains("speed_up") ? ratio(point["speed_up"]) + " (" + ratio(point["efficiency"]) + ')'
                                                   : "fails");
        }
        table.addRow(row);
      }
    }
    return "Speed-up S and efficiency E over one thread without a block, whose time is in ms. "
           "Filters: the sample's own pipeline, else the default pipeline. This is " +
           processors() +
           ": more threads than that take turns, and say nothing about scaling. The thesis shows its own scaling as "
           "plots, without numbers.\n\n" +
           table.text() + (notes.empty() ? "" : notes + "\n\n");
  }

  // Counts over all experiments.
  [[nodiscard]] std::array<int, 2> countEqualBytes() const {
    std::array<int, 2> counts{};
    const auto count = [&](const Json& entry) {
      if (!entry.contains("bytes_equal")) return;
      ++counts[1];
      counts[0] += entry["bytes_equal"].get<bool>() ? 1 : 0;
    };
    for (const Json& environment : results_["environments"]) {
      if (environment.contains("due"))
        for (const Json& entry : environment["due"]) count(entry);
      if (environment.contains("strategies"))
        for (const Json& entry : environment["strategies"]) count(entry);
      if (environment.contains("scaling") && environment["scaling"].contains("lines"))
        for (const Json& line : environment["scaling"]["lines"])
          for (const Json& point : line["points"]) count(point);
    }
    return counts;
  }

  std::string correctness() const {
    const auto [equal, compared] = countEqualBytes();
    std::string text;
    if (compared > 0) {
      text =
          "In all tables, " + std::to_string(equal) + " of " + std::to_string(compared) +
          " ways to run (strategies, depths, threads) gave the bytes that the same filters give on one thread without "
          "a block.\n\n";
    }
    text += "Below, the sequential output against that of a sorted recursive block of depth 4 on " + tableThreads() +
            ": with the *same filters*, and with the *thesis's listings*, whose parallel one rounds and simplifies "
            "approximately where the sequential one does not.\n\n";
    return text + distances() + areas();
  }

  std::string distances() const {
    Table table({"distances, m", "pipelines", "bytes", "d_min", "d_max", "d_mean", "d_rms", "at most", "thesis: d_max",
                 "thesis: d_mean", "thesis: d_rms", "table 5: d_max", "d_mean", "d_rms"},
                3);
    std::string notes;
    forEachCorrectness([&](const std::string& name, const Json& entry, bool first) {
      std::vector<std::string> row{first ? name : "", entry["label"]};
      if (entry.contains("fails")) {
        row.emplace_back("fails");
        row.insert(row.end(), 11, "");
        notes += name + ", " + entry["label"].get<std::string>() + ' ' + failure(entry) + ". ";
        table.addRow(row);
        return;
      }
      row.emplace_back(entry["bytes_equal"].get<bool>() ? "equal" : "differ");
      for (const char* key : {"min", "max", "mean", "rms", "upper"}) {
        row.push_back(entry.contains("distances")
                          ? metres(entry["distances"][key].get<double>() * entry["metres_per_unit"].get<double>())
                          : "-");
      }
      for (const char* key : {"max", "mean", "rms"})
        row.push_back(hasThesis(entry) ? metres(entry["thesis"][key]) : "");
      for (const char* key : {"max_units", "mean_units", "rms_units"})
        row.push_back(hasThesis(entry) ? formatted("%.6f", entry["thesis"][key]) : "");
      table.addRow(row);
    });
    return table.text() + notes +
           "*d_...*: sampled at the vertices of the sequential output, as in the thesis. *at most*: no point of that "
           "output is farther from the parallel one. The thesis's figures (its table 6, where every d_min is 0) are of "
           "its own environments; its table 5 has them in units: of its villa 1 is 0.0235 m, of its arena 0.5 m, of "
           "its "
           "house 1 m. Its villa's mean and rms contradict table 5.\n\n";
  }

  static bool hasThesis(const Json& entry) { return entry.contains("thesis") && entry["label"] != "same filters"; }

  static std::string metres(double value) { return value == 0 ? "0" : formatted("%.2g", value); }

  std::string areas() const {
    Table table({"walkable space", "pipelines", "sequential", "parallel", "covered", "thesis: sequential",
                 "thesis: parallel", "thesis: covered"},
                2);
    forEachCorrectness([&](const std::string& name, const Json& entry, bool first) {
      if (entry.contains("fails")) return;
      std::vector<std::string> row{first ? name : "", entry["label"]};
      addAreas(entry, row);
      if (hasThesis(entry))
        addAreas(entry["thesis"], row);
      else
        row.insert(row.end(), 3, "");
      table.addRow(row);
    });
    return table.text() +
           "Areas in space, in the square of each file's unit. *covered*: the parallel area over the sequential one, "
           "as "
           "the thesis has it.\n\n";
  }

  static void addAreas(const Json& entry, std::vector<std::string>& row) {
    for (const Json& area : entry["areas"]) row.push_back(groupedWithDecimals(area, 3));
    row.push_back(!entry.contains("covered")            ? "-"
                  : entry["covered"].get<double>() == 1 ? "1"
                                                        : formatted("%.9f", entry["covered"]));
  }

  template <class Visit>
  void forEachCorrectness(const Visit& visit) const {
    for (const Json& environment : results_["environments"]) {
      if (!environment.contains("correctness")) continue;
      bool first = true;
      for (const Json& entry : environment["correctness"]) {
        visit(environment["name"].get<std::string>(), entry, first);
        first = false;
      }
    }
  }

  const Json& results_;
};

}  // namespace

std::string formatThesisReport(const Json& results) { return ThesisReport(results).format(); }

}  // namespace footfall::bench
