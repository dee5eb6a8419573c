// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/targets.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "tests/bench/sampling.hpp"

namespace footfall::bench {
namespace {

struct Figure {
  std::string where;
  double value = 0;
};
using Figures = std::vector<Figure>;

class Judge {
 public:
  explicit Judge(const Json& results) : results_(results), threads_(results["threads"].back().get<int>()) {}

  Json judge() {
    const Figures prototype = overEnvironments([&](const Json& e) { return ratioTo(e, "prototype"); });
    worst("prototype", "time to the walkable environment, worst", prototype, 1.0, "times");
    mean("prototype", "the same, geometric mean", prototype, 0.8, "times");
    worst("processor time", "a triangle, one thread, worst above 30,000", overEnvironments(timePerTriangle()), 1.4,
          "us");
    const Figures fine = recastRatios(0.1), coarse = recastRatios(0.3);
    worst("Recast at 0.1 m", "one thread each, worst", fine, 0.5, "times");
    worst("Recast at 0.3 m", "one thread each, worst", coarse, 1.5, "times");
    mean("Recast at 0.3 m", "one thread each, geometric mean", coarse, 0.6, "times");
    if (threads_ == 2)
      least("one thread", "two threads, least above 20,000", overEnvironments(gainOfThreads()), 1.8, "times");
    least("the thesis", "speed-up, least", overEnvironments(thesisSpeedUp()), 1500, "times");
    mean("the floor", "time, geometric mean", overEnvironments([&](const Json& e) { return ratioTo(e, "floor"); }), 5,
         "times");
    worst("town", "time", overEnvironments([&](const Json& e) { return townMs(e); }), 100, "ms");
    judgeEdits();
    judgeGrowth();
    worst("cancelling", "until the caller knows, longest", cancelFigures(), 50, "ms");
    worst("memory", "a triangle above 60 MB, worst", memoryFigures(), 1024, "bytes");
    least("load of OBJ", "one core, files above 1 MB, least", loadRates(), 100, "MB/s");
    return targets_;
  }

 private:
  using Measure = std::function<std::optional<double>(const Json&)>;

  Figures overEnvironments(const Measure& measure) const {
    Figures figures;
    for (const Json& environment : results_["environments"]) {
      if (const auto value = measure(environment)) figures.push_back({environment["name"], *value});
    }
    return figures;
  }

  const Json* ours(const Json& environment) const { return atThreads(environment["footfall"], threads_); }

  // Our time over a peer's that was measured once a thread count.
  std::optional<double> ratioTo(const Json& environment, const char* peer) const {
    const Json* own = ours(environment);
    if (own == nullptr || !environment.contains(peer)) return std::nullopt;
    const Json* other = atThreads(environment[peer], threads_);
    if (other == nullptr) return std::nullopt;
    const Json& mine = other->contains("ours_ms") ? (*other)["ours_ms"] : (*own)["run_ms"];
    return mine.get<double>() / (*other)["wall_ms"].get<double>();
  }

  // Recast has one thread.
  Figures recastRatios(double cell) const {
    return overEnvironments([&](const Json& e) -> std::optional<double> {
      const Json* own = atThreads(e["footfall"], 1);
      if (own == nullptr || !e.contains("recast")) return std::nullopt;
      for (const Json& entry : e["recast"]) {
        if (entry["cell"] == cell && entry.contains("wall_ms"))
          return (*own)["run_ms"].get<double>() / entry["wall_ms"].get<double>();
      }
      return std::nullopt;
    });
  }

  static Measure timePerTriangle() {
    return [](const Json& e) -> std::optional<double> {
      const Json* own = atThreads(e["footfall"], 1);
      if (own == nullptr || (*own)["triangles"] < 30'000) return std::nullopt;
      return 1e3 * (*own)["run_cpu_ms"].get<double>() / (*own)["triangles"].get<double>();
    };
  }

  Measure gainOfThreads() const {
    return [this](const Json& e) -> std::optional<double> {
      const Json *one = atThreads(e["footfall"], 1), *own = ours(e);
      if (one == nullptr || own == nullptr || (*own)["triangles"] < 20'000) return std::nullopt;
      return (*one)["run_ms"].get<double>() / (*own)["run_ms"].get<double>();
    };
  }

  Measure thesisSpeedUp() const {
    return [this](const Json& e) -> std::optional<double> {
      const Json* own = ours(e);
      if (own == nullptr || !e.contains("thesis_s")) return std::nullopt;
      return 1000 * e["thesis_s"].get<double>() / (*own)["run_ms"].get<double>();
    };
  }

  std::optional<double> townMs(const Json& e) const {
    const Json* own = ours(e);
    if (own == nullptr || e["name"] != "town_model") return std::nullopt;
    return (*own)["run_ms"].get<double>();
  }

  // Judges levels of about 60,000 triangles.
  void judgeEdits() {
    constexpr const char* kObstacleMoves = "an obstacle of 100 triangles moves, worst";
    constexpr int kSmallest = 40'000, kLargest = 65'000;
    constexpr double kDueMs = 8;
    Figures obstacle;
    for (const Json& entry : results_["live"]) {
      if (entry.contains("fails")) {
        addFailure("live", kObstacleMoves, kDueMs, "ms",
                   entry["name"].get<std::string>() + ": " + entry["fails"].get<std::string>());
        continue;
      }
      if (const int triangles = entry["triangles"]; triangles >= kSmallest && triangles <= kLargest)
        obstacle.push_back({entry["name"], entry["obstacle_ms"]});
    }
    worst("live", kObstacleMoves, obstacle, kDueMs, "ms");
  }

  void judgeGrowth() {
    Figures time, memory, large, largest;
    for (const Json& step : growthExponents(results_)) {
      const std::string where = step["series"].get<std::string>() + " to " + std::to_string(step["to"].get<int>());
      time.push_back({where, step["time"]});
      memory.push_back({where, step["memory"]});
    }
    for (const Json& entry : results_["growth"]) {
      if (entry["size"] != 1'000'000) continue;
      if (entry.contains("fails")) {
        addFailure("growth", "time for 1 M", 1.8, "s", entry["fails"]);
        continue;
      }
      large.push_back({entry["series"], entry["run_ms"].get<double>() / 1e3});
      largest.push_back({entry["series"], entry["peak_bytes"].get<double>() / 1e6});
    }
    worst("growth", "exponent of time, worst", time, 1.05, "");
    worst("growth", "exponent of memory, worst", memory, 1.0, "");
    worst("growth", "time for 1 M", large, 1.8, "s");
    worst("growth", "memory for 1 M", largest, 600, "MB");
  }

  Figures cancelFigures() const {
    Figures figures;
    for (const Json& entry : results_["cancelling"])
      if (!entry.contains("fails")) figures.push_back({entry["name"], entry["longest_ms"]});
    return figures;
  }

  Figures memoryFigures() const {
    constexpr double kFixed = 60e6;
    const auto perTriangle = [](const Json& figures) {
      return std::max(0.0, figures["peak_bytes"].get<double>() - kFixed) / figures["triangles"].get<double>();
    };
    Figures result = overEnvironments([&](const Json& e) -> std::optional<double> {
      const Json* own = ours(e);
      return own == nullptr ? std::nullopt : std::optional(perTriangle(*own));
    });
    for (const Json& entry : results_["growth"]) {
      if (!entry.contains("peak_bytes")) continue;
      result.push_back(
          {entry["series"].get<std::string>() + ' ' + std::to_string(entry["size"].get<int>()), perTriangle(entry)});
    }
    return result;
  }

  Figures loadRates() const {
    constexpr double kLargeFile = 1e6;
    return overEnvironments([&](const Json& e) -> std::optional<double> {
      const Json* own = atThreads(e["footfall"], 1);
      if (own == nullptr || (*own)["file_bytes"].get<double>() < kLargeFile || !(*own)["is_obj"].get<bool>())
        return std::nullopt;
      return (*own)["load_mb_per_s"].get<double>();
    });
  }

  void worst(const char* against, const char* what, const Figures& figures, double due, const char* unit) {
    const auto found = std::ranges::max_element(figures, {}, &Figure::value);
    if (found != figures.end()) add(against, what, *found, due, unit, false);
  }
  void least(const char* against, const char* what, const Figures& figures, double due, const char* unit) {
    const auto found = std::ranges::min_element(figures, {}, &Figure::value);
    if (found != figures.end()) add(against, what, *found, due, unit, true);
  }
  void mean(const char* against, const char* what, const Figures& figures, double due, const char* unit) {
    std::vector<double> values;
    for (const Figure& figure : figures) values.push_back(figure.value);
    if (!values.empty()) add(against, what, {"", geometricMean(values)}, due, unit, false);
  }
  void add(const char* against, const char* what, const Figure& figure, double due, const char* unit, bool atLeast) {
    targets_.push_back({{"against", against},
                        {"what", what},
                        {"due", due},
                        {"measured", figure.value},
                        {"unit", unit},
                        {"at_least", atLeast},
                        {"met", atLeast ? figure.value >= due : figure.value <= due},
                        {"where", figure.where}});
  }

  void addFailure(const char* against, const char* what, double due, const char* unit, const std::string& where) {
    targets_.push_back({{"against", against},
                        {"what", what},
                        {"due", due},
                        {"measured", nullptr},
                        {"unit", unit},
                        {"at_least", false},
                        {"met", false},
                        {"where", where}});
  }

  const Json& results_;
  int threads_;
  Json targets_ = Json::array();
};

}  // namespace

Json judgeTargets(const Json& results) { return Judge(results).judge(); }

const Json* atThreads(const Json& list, int threads) {
  for (const Json& entry : list) {
    if (entry["threads"] == threads && !entry.contains("fails")) return &entry;
  }
  return nullptr;
}

Json growthExponents(const Json& results) {
  Json exponents = Json::array();
  const Json& growth = results["growth"];
  for (std::size_t i = 1; i < growth.size(); ++i) {
    const Json &small = growth[i - 1], &large = growth[i];
    if (small["series"] != large["series"] || small.contains("fails") || large.contains("fails")) continue;
    const auto logarithm = [&](const Json& entry, const char* figure) { return std::log(entry[figure].get<double>()); };
    const auto exponent = [&](const char* figure) {
      return (logarithm(large, figure) - logarithm(small, figure)) /
             (logarithm(large, "triangles") - logarithm(small, "triangles"));
    };
    exponents.push_back({{"series", large["series"]},
                         {"from", small["size"]},
                         {"to", large["size"]},
                         {"time", exponent("run_ms")},
                         {"memory", exponent("peak_above_start_bytes")}});
  }
  return exponents;
}

}  // namespace footfall::bench
