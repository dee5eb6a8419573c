// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/scene_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/bench/markdown.hpp"
#include "tests/bench/report.hpp"
#include "tests/bench/sampling.hpp"

namespace footfall::bench {
namespace {

constexpr std::array<std::string_view, 2> kGroups{"file", "generated"};

// What the program took before coordinates were put on a grid and gaps were bounded: processor ms on one thread.
struct Before {
  const char* plain;    ///< steps without gaps
  const char* regular;  ///< the default pipeline
};
const Before& beforeOf(const Json& scene) {
  static const std::map<std::string, Before> known{
      {"lowpoly_map.glb", {"5,525", "5,200"}},
      {"office.glb", {"252", "stopped after 12,000"}},
      {"house.glb", {"-", "stopped after 10,000"}},
      {"proto-level.glb", {"102", "140"}},
      {"office", {"-", "26,500"}},
      {"foliage", {"-", "17,500"}},
      {"noise", {"-", "2,000"}},
      {"town", {"-", "610"}},
      {"ramps", {"-", "290"}},
  };
  static const Before unknown{"-", "-"};
  constexpr int kGeneratedSize = 60'000;  // that was measured
  const auto found = known.find(scene["name"].get<std::string>());
  const bool isOther = scene["group"].get<std::string>() == "generated" && scene["runs"].contains("triangles") &&
                       scene["runs"]["triangles"].get<int>() < kGeneratedSize;
  return found == known.end() || isOther ? unknown : found->second;
}

std::string titleOf(const Json& scene) {
  const std::string name = scene["name"];
  return scene["group"] == "file" ? '`' + name + '`' : name;
}

std::optional<double> cpuOf(const Json& scene, const char* run) {
  if (scene["runs"].contains("fails")) return std::nullopt;
  return scene["runs"][run]["cpu_ms"].get<double>();
}

// Recast's entry for a cell size, or null where it failed or is not there.
const Json* recastOf(const Json& scene, const char* run, double cell) {
  if (scene["recast"].is_null()) return nullptr;
  for (const Json& entry : scene["recast"][run])
    if (entry["cell"] == cell && entry.contains("least_cpu_ms")) return &entry;
  return nullptr;
}

std::optional<double> overRecast(const Json& scene, const char* run, double cell) {
  const auto ours = cpuOf(scene, run);
  const Json* const theirs = recastOf(scene, run, cell);
  if (!ours || theirs == nullptr) return std::nullopt;
  return *ours / (*theirs)["least_cpu_ms"].get<double>();
}

std::optional<double> offOverOn(const Json& figures) {
  if (figures.contains("fails")) return std::nullopt;
  return figures["off"]["cpu_ms"].get<double>() / figures["on"]["cpu_ms"].get<double>();
}

using Measure = std::function<std::optional<double>(const Json&)>;

struct Figures {
  std::vector<double> values;
  std::vector<std::string> names;
  [[nodiscard]] std::size_t worst() const {
    return static_cast<std::size_t>(std::ranges::max_element(values) - values.begin());
  }
};

bool isIn(const Json& entry, std::string_view group) { return entry["group"].get<std::string>() == group; }

// An empty group stands for all entries.
Figures figuresOf(const Json& entries, std::string_view group, const Measure& measure) {
  Figures figures;
  for (const Json& entry : entries) {
    if (!group.empty() && !isIn(entry, group)) continue;
    if (const auto value = measure(entry)) {
      figures.values.push_back(*value);
      figures.names.push_back(entry["name"]);
    }
  }
  return figures;
}

class SceneJudge {
 public:
  explicit SceneJudge(const Json& results) : results_(results) {}

  Json judge() {
    for (const std::string_view group : kGroups) judgeGroup(group);
    judgeTurned();
    return std::move(targets_);
  }

 private:
  struct Due {
    const char* what;
    double due;
    const char* unit;
    bool atLeast = false;
  };

  void judgeGroup(std::string_view group) {
    const std::string scenes = std::string("scenes, ") + (group == kGroups[0] ? "files" : "generated");
    const Json& list = results_["scenes"];
    std::string failed, walkFailed;
    bool any = false;
    for (const Json& scene : list) {
      if (!isIn(scene, group)) continue;
      any = true;
      for (const char* part : {"runs", "peak"})
        if (scene[part].contains("fails") && failed.empty()) failed = scene["name"];
      if (scene["radius_drops"].contains("fails") && walkFailed.empty()) walkFailed = scene["name"];
    }
    if (!any) return;
    for (const double cell : {0.3, 0.1}) {
      const Figures ratios = figuresOf(list, group, [&](const Json& s) { return overRecast(s, "plain", cell); });
      if (ratios.values.empty() && failed.empty()) continue;
      if (cell == 0.3) {
        worst(scenes, {"Recast at 0.3 m, one thread each, without steps, worst", 8, "times"}, ratios, failed);
        mean(scenes, {"the same, geometric mean", 2, "times"}, ratios, failed);
      } else {
        mean(scenes, {"Recast at 0.1 m, geometric mean", 0.5, "times"}, ratios, failed);
      }
    }
    worst(scenes, {"default pipeline, two threads, worst", group == kGroups[0] ? 400.0 : 2000.0, "ms"},
          figuresOf(list, group, [](const Json& s) { return runFigure(s, "default_2", "wall_ms"); }), failed);
    worst(scenes, {"default pipeline, one thread, for 60,000 triangles, worst", 2000, "ms"},
          figuresOf(list, group, perSize([](const Json& s) { return runFigure(s, "default_1", "cpu_ms"); })), failed);
    worst(scenes, {"with a radius and drops, one thread, for 60,000 triangles, worst", 2000, "ms"},
          figuresOf(list, group, perSize(&walkOf)), walkFailed);
    worst(scenes, {"memory for 60,000 triangles, worst", 500, "MB"}, figuresOf(list, group, perSize(&peakOf)), failed);
    worst(scenes, {"without a grid over on it, worst", 3, "times"},
          figuresOf(list, group, [](const Json& s) { return offOverOn(s["runs"]); }), failed);
    const Figures gain = figuresOf(list, group, [](const Json& s) -> std::optional<double> {
      if (s["name"].get<std::string>() != "lowpoly_map.glb") return std::nullopt;
      const auto one = runFigure(s, "default_1", "wall_ms"), two = runFigure(s, "default_2", "wall_ms");
      return one && two ? std::optional(*one / *two) : std::nullopt;
    });
    worst(scenes, {"two threads over one", 1.8, "times", true}, gain, failed);
  }

  void judgeTurned() {
    const Json& list = results_["turned"];
    if (list.empty()) return;
    std::string failed;
    for (const Json& level : list)
      if (level.contains("fails") && failed.empty()) failed = level["name"];
    const auto over = [&](const std::function<double(const Json&)>& measure) {
      return figuresOf(list, "", [&](const Json& level) {
        return level.contains("fails") ? std::nullopt : std::optional(measure(level));
      });
    };
    worst("turned by 17 degrees", {"on the grid over itself, default pipeline, worst", 1.25, "times"},
          over([](const Json& l) { return l["on"]["cpu_ms"].get<double>() / l["original"]["cpu_ms"].get<double>(); }),
          failed);
    worst("turned by 17 degrees", {"its area beside itself, worst", 0.1, "%"}, over([](const Json& l) {
            return 100 *
                   std::abs(l["on"]["square_metres"].get<double>() / l["original"]["square_metres"].get<double>() - 1);
          }),
          failed);
    worst("turned by 17 degrees", {"its share beside itself, worst", 0.01, ""}, over([](const Json& l) {
            return std::abs(l["on"]["share"].get<double>() - l["original"]["share"].get<double>());
          }),
          failed);
    worst("turned by 17 degrees", {"without a grid over on it, worst", 3, "times"},
          over([](const Json& l) { return *offOverOn(l); }), failed);
  }

  static std::optional<double> runFigure(const Json& scene, const char* run, const char* figure) {
    if (scene["runs"].contains("fails")) return std::nullopt;
    return scene["runs"][run][figure].get<double>();
  }
  static std::optional<double> walkOf(const Json& scene) {
    if (scene["radius_drops"].contains("fails")) return std::nullopt;
    return scene["radius_drops"]["default_1"]["cpu_ms"].get<double>();
  }
  static std::optional<double> peakOf(const Json& scene) {
    if (scene["peak"].contains("fails")) return std::nullopt;
    return scene["peak"]["peak_bytes"].get<double>() / 1e6;
  }
  // Small scenes may take as much as one of 60,000 triangles.
  static Measure perSize(const Measure& measure) {
    return [measure](const Json& scene) -> std::optional<double> {
      constexpr double kSize = 60'000;
      const auto value = measure(scene);
      if (!value || scene["runs"].contains("fails")) return std::nullopt;
      return *value / std::max(1.0, scene["runs"]["triangles"].get<double>() / kSize);
    };
  }

  void worst(const std::string& against, const Due& due, const Figures& figures, const std::string& failed) {
    if (!failed.empty()) return add(against, due, std::nullopt, failed);
    if (figures.values.empty()) return;
    add(against, due, figures.values[figures.worst()], figures.names[figures.worst()]);
  }
  void mean(const std::string& against, const Due& due, const Figures& figures, const std::string& failed) {
    if (!failed.empty()) return add(against, due, std::nullopt, failed);
    add(against, due, geometricMean(figures.values), "");
  }
  void add(const std::string& against, const Due& due, std::optional<double> value, const std::string& where) {
    const bool met = value && (due.atLeast ? *value >= due.due : *value <= due.due);
    targets_.push_back({{"against", against},
                        {"what", due.what},
                        {"due", due.due},
                        {"measured", value ? Json(*value) : Json()},
                        {"unit", due.unit},
                        {"at_least", due.atLeast},
                        {"met", met},
                        {"where", where}});
  }

  const Json& results_;
  Json targets_ = Json::array();
};

std::string timesText(const std::optional<double>& ratio) { return ratio ? '(' + number(*ratio) + ')' : "-"; }

std::string recastCell(const Json& scene, const char* run, double cell) {
  if (scene["recast"].is_null()) return "-";
  const Json* const theirs = recastOf(scene, run, cell);
  if (theirs == nullptr) return "fails";
  const auto ratio = overRecast(scene, run, cell);
  return number((*theirs)["least_cpu_ms"]) + (ratio ? ' ' + timesText(ratio) : "");
}

// One row with the worst ratios and one with their means, for each group of scenes.
void addSummaries(Table& table, const Json& scenes, std::size_t columns,
                  const std::map<std::size_t, Measure>& ratioColumns) {
  for (const std::string_view group : kGroups) {
    std::vector<std::string> worst(columns), mean(columns);
    bool any = false;
    for (const auto& [column, measure] : ratioColumns) {
      const Figures figures = figuresOf(scenes, group, measure);
      if (figures.values.empty()) continue;
      any = true;
      worst[column] = timesText(figures.values[figures.worst()]);
      mean[column] = timesText(geometricMean(figures.values));
    }
    if (!any) continue;
    const std::string title = group == kGroups[0] ? "files" : "generated";
    worst[0] = "**" + title + ", worst**";
    mean[0] = "**" + title + ", geometric mean**";
    table.addRow(worst);
    table.addRow(mean);
  }
}

std::string besideRecast(const Json& scenes, std::string& failures) {
  Table table({"scene", "triangles", "before", "ours", "Recast 0.3 m", "Recast 0.1 m", "ours, radius",
               "Recast 0.3 m, radius", "Recast 0.1 m, radius"});
  const auto ratio = [](const char* run, double cell) -> Measure {
    return [run, cell](const Json& scene) { return overRecast(scene, run, cell); };
  };
  addSummaries(
      table, scenes, 9,
      {{4, ratio("plain", 0.3)}, {5, ratio("plain", 0.1)}, {7, ratio("radius", 0.3)}, {8, ratio("radius", 0.1)}});
  for (const Json& scene : scenes) {
    const auto own = [&](const char* run) {
      const auto cpu = cpuOf(scene, run);
      return cpu ? number(*cpu) : std::string("fails");
    };
    table.addRow({titleOf(scene), scene["runs"].contains("fails") ? "" : grouped(scene["runs"]["triangles"]),
                  beforeOf(scene).plain, own("plain"), recastCell(scene, "plain", 0.3), recastCell(scene, "plain", 0.1),
                  own("radius"), recastCell(scene, "radius", 0.3), recastCell(scene, "radius", 0.1)});
    for (const char* part : {"runs", "radius_drops", "peak"}) {
      if (!scene[part].contains("fails")) continue;
      failures += "- " + titleOf(scene) + ", " + part + ": " + scene[part]["fails"].get<std::string>() + '\n';
    }
    if (scene["recast"].is_null()) continue;
    for (const auto& [run, entries] : scene["recast"].items())
      for (const Json& entry : entries)
        if (entry.contains("fails"))
          failures += "- Recast on " + titleOf(scene) + " at " + number(entry["cell"]) + " m, " + run + ": " +
                      entry["fails"].get<std::string>() + '\n';
  }
  return table.text() +
         "Processor ms, the least of the rounds, from the loaded environment to the navigation mesh: the default "
         "pipeline without steps. In parentheses: ours over Recast's. *radius*: 0.3 m for both. *before*: when the "
         "coordinates of files were taken as they are (steps without gaps). Files are on the grid of import; generated "
         "scenes are OBJ, which import takes as it is.\n\n";
}

std::string defaultPipelines(const Json& scenes) {
  Table table({"scene", "triangles", "before, 1 thread", "1 thread", "2 threads, wall", "2 threads", "radius, drops",
               "peak MB"});
  std::vector<std::pair<double, const Json*>> order;
  for (const Json& scene : scenes) order.emplace_back(-cpuOf(scene, "default_1").value_or(HUGE_VAL), &scene);
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [time, scene] : order) {
    const Json& runs = (*scene)["runs"];
    std::vector<std::string> row{titleOf(*scene)};
    if (runs.contains("fails")) {
      row.insert(row.end(), {"", beforeOf(*scene).regular, "fails", "", ""});
    } else {
      row.insert(row.end(), {grouped(runs["triangles"]), beforeOf(*scene).regular, number(runs["default_1"]["cpu_ms"]),
                             number(runs["default_2"]["wall_ms"]), number(runs["default_2"]["cpu_ms"])});
    }
    const Json& walk = (*scene)["radius_drops"];
    row.push_back(walk.contains("fails") ? "fails" : number(walk["default_1"]["cpu_ms"]));
    row.push_back((*scene)["peak"].contains("fails") ? "fails" : megabytes((*scene)["peak"]["peak_bytes"]));
    table.addRow(row);
  }
  return table.text() +
         "Processor ms but for one column, the least of the rounds; the slowest scene first. *radius, drops*: with a "
         "radius "
         "of 0.3 m and drops of 1.5 m, one thread. *peak MB*: of a process that reads the file and runs the default "
         "pipeline once on two threads.\n\n";
}

void addGridRow(Table& table, const std::string& title, const Json& figures) {
  if (figures.contains("fails")) return table.addRow({title, "fails", "", "", "", "", "", "", ""});
  const Json &on = figures["on"], &off = figures["off"];
  table.addRow({title, number(on["cpu_ms"]), grouped(on["exact_decisions"]), number(off["cpu_ms"]),
                grouped(off["exact_decisions"]), timesText(offOverOn(figures)), grouped(on["square_metres"]),
                grouped(off["square_metres"]),
                groupedWithDecimals(on["share"], 3) + " / " + groupedWithDecimals(off["share"], 3)});
}

std::string gridCosts(const Json& results) {
  Table table({"scene", "on", "decisions", "off", "decisions", "off over on", "m2, on", "m2, off", "share, on / off"});
  addSummaries(table, results["scenes"], 9, {{5, [](const Json& scene) { return offOverOn(scene["runs"]); }}});
  std::vector<double> ratios;
  for (const Json& level : results["turned"])
    if (const auto ratio = offOverOn(level)) ratios.push_back(*ratio);
  if (!ratios.empty()) {
    table.addRow({"**turned, worst**", "", "", "", "", timesText(*std::ranges::max_element(ratios)), "", "", ""});
    table.addRow({"**turned, geometric mean**", "", "", "", "", timesText(geometricMean(ratios)), "", "", ""});
  }
  for (const Json& scene : results["scenes"]) addGridRow(table, titleOf(scene), scene["runs"]);
  for (const Json& level : results["turned"]) addGridRow(table, level["name"].get<std::string>() + ", turned", level);
  return table.text() +
         "`--grid on` and `--grid off`, one thread, processor ms, the least of rounds in turns. Scenes: the default "
         "pipeline without steps; levels turned by 17 degrees: with steps and gaps. *decisions*: those that doubles "
         "could not make.\n\n";
}

std::string turnedLevels(const Json& turned) {
  Table table({"level", "triangles", "as it stands", "turned", "over itself", "area", "share", "share, turned",
               "welded", "split"});
  std::vector<double> ratios;
  for (const Json& level : turned)
    if (!level.contains("fails"))
      ratios.push_back(level["on"]["cpu_ms"].get<double>() / level["original"]["cpu_ms"].get<double>());
  if (!ratios.empty()) {
    table.addRow({"**worst**", "", "", "", timesText(*std::ranges::max_element(ratios)), "", "", "", "", ""});
    table.addRow({"**geometric mean**", "", "", "", timesText(geometricMean(ratios)), "", "", "", "", ""});
  }
  std::string failures;
  std::size_t next = 0;
  for (const Json& level : turned) {
    const std::string name = level["name"];
    if (level.contains("fails")) {
      table.addRow({name, "", "fails", "", "", "", "", "", "", ""});
      failures += "- " + name + ": " + level["fails"].get<std::string>() + '\n';
      continue;
    }
    const Json &original = level["original"], &on = level["on"];
    const double area = on["square_metres"].get<double>() / original["square_metres"].get<double>() - 1;
    table.addRow({name, grouped(level["triangles"]), number(original["cpu_ms"]), number(on["cpu_ms"]),
                  timesText(ratios[next++]), groupedWithDecimals(100 * area, 4) + " %",
                  groupedWithDecimals(original["share"], 4), groupedWithDecimals(on["share"], 4),
                  grouped(level["welded"]), grouped(level["split"])});
  }
  return table.text() +
         "Turned by 17 degrees about the vertical in doubles, then put on the grid; the default pipeline with steps "
         "and "
         "gaps, one thread, processor ms, the least of rounds in turns. *area*: how much more it is than that of the "
         "level as it stands.\n\n" +
         (failures.empty() ? "" : "Fails:\n\n" + failures + '\n');
}

}  // namespace

Json judgeScenes(const Json& results) { return SceneJudge(results).judge(); }

std::string formatScenes(const Json& results) {
  std::string text = "At most " + std::to_string(results["runs"].get<int>()) + " rounds after one warm-up.\n\n";
  if (!results["targets"].empty()) text += "### What is due for scenes\n\n" + formatTargets(results["targets"]);
  std::string failures;
  text += "### Scenes beside Recast, 1 thread each\n\n" + besideRecast(results["scenes"], failures);
  if (!failures.empty()) text += "Fails:\n\n" + failures + '\n';
  text += "### Scenes, default pipeline\n\n" + defaultPipelines(results["scenes"]);
  if (!results["turned"].empty()) text += "### Levels that somebody turned\n\n" + turnedLevels(results["turned"]);
  return text + "### What `--grid off` costs\n\n" + gridCosts(results);
}

}  // namespace footfall::bench
