// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/path_measurement.hpp"

#include <tbb/global_control.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "core/base/number_text.hpp"
#include "footfall/body_path.hpp"
#include "footfall/ground.hpp"
#include "footfall/run.hpp"
#include "tests/bench/markdown.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

/// Twice the tolerance of a RadiusFilter that states none, 0.01: no way for that much more is lost behind the filter.
constexpr double kSurelyBehind = 1.02;
/// How far a place may be above or below the walkable area, in metres.
constexpr double kReach = 0.05;
constexpr double kLeastArea = 2;  // square metres
constexpr std::uint64_t kSeed = 1;

/// Processor time of this thread. Other programs do not count.
double threadMs() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

std::string pipelineText(const Subject& subject, const PathPairs& asked, bool hasRadius) {
  const double unit = 1 / subject.metresPerUnit();
  std::string text = "DuplicationFilter 0\nDegeneracyFilter\nSlopeFilter 45";
  const auto add = [&](const char* filter, double value) {
    text += '\n';
    text += filter;
    text += ' ';
    appendNumber(text, value);
  };
  add("VerticalClearanceFilter", subject.clearance);
  add("StepFilter", asked.step * unit);
  add("AreaFilter", kLeastArea * unit * unit);
  if (hasRadius) add("RadiusFilter", asked.radius * unit);
  return text;
}

/// The value that so large a share of the values does not exceed.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size()));
  return values[std::min(at, values.size() - 1)];
}

class PairFinder {
 public:
  PairFinder(std::shared_ptr<const NavigationMesh> plain, std::shared_ptr<const NavigationMesh> behind, double radius,
             double reach, double longest)
      : start_(threadMs()),
        map_(std::move(plain)),
        mapMs_(threadMs() - start_),
        behind_(std::move(behind)),
        radius_(radius),
        reach_(reach),
        longest_(longest) {}

  void run(int pairs) {
    const auto places = randomPlaces(behind_, 2 * static_cast<std::size_t>(pairs), kSeed);
    for (std::size_t i = 0; i + 1 < places.size(); i += 2) find(places[i].position, places[i + 1].position);
  }

  [[nodiscard]] Json figures() const {
    return {{"map_ms", mapMs_},
            {"found", ratios_.size()},
            {"none", none_},
            {"between", between_},
            {"missing", missing_},
            {"surplus", surplus_},
            {"longer", longer_},
            {"shorter", shorter_},
            {"longest", quantile(ratios_, 1)},
            {"shortest", quantile(ratios_, 0)},
            {"median_ms", quantile(times_, 0.5)},
            {"most_ms", quantile(times_, 0.99)}};
  }

 private:
  void find(const Vec3& from, const Vec3& to) {
    const PathResult other = behind_.find(from, to, reach_);
    const double before = threadMs();
    const BodyPath path = map_.find(from, to, {.radius = radius_}, reach_);
    const double took = threadMs() - before;
    if (other.reached()) {
      times_.push_back(took);
      if (path.reached())
        compare(from, to, path.path.planLength, other.planLength);
      else
        ++missing_;
    } else if (path.reached()) {
      const bool isSurplus = map_.find(from, to, {.radius = radius_ * kSurelyBehind}, reach_).reached();
      ++(isSurplus ? surplus_ : between_);
    } else {
      ++none_;
    }
  }

  /// A way that is too narrow for the filter by its tolerance may be much shorter than all others, so that only a path
  /// for a larger radius is surely not shorter than that behind the filter.
  void compare(const Vec3& from, const Vec3& to, double length, double other) {
    const double ratio = other > 0 ? length / other : 1;
    ratios_.push_back(ratio);
    if (ratio > longest_) ++longer_;
    if (ratio * longest_ >= 1) return;
    const BodyPath larger = map_.find(from, to, {.radius = radius_ * kSurelyBehind}, reach_);
    if (larger.reached() && larger.path.planLength * longest_ < other) ++shorter_;
  }

  double start_;
  BodyPathFinder map_;
  double mapMs_;
  PathFinder behind_;
  double radius_, reach_, longest_;
  std::size_t none_ = 0, between_ = 0, missing_ = 0, surplus_ = 0, longer_ = 0, shorter_ = 0;
  std::vector<double> ratios_, times_;
};

std::size_t failedClaims(const Json& entry) {
  std::size_t sum = 0;
  for (const char* claim : {"missing", "surplus", "longer", "shorter"}) sum += entry[claim].get<std::size_t>();
  return sum;
}

}  // namespace

Json measurePaths(const Subject& subject, const PathPairs& asked, int threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  const auto environment = loadSubject(subject);
  const auto meshOf = [&](bool hasRadius) {
    RunContext context;
    return runPipeline(environment, parsePipeline(pipelineText(subject, asked, hasRadius), "paths"), context, nullptr,
                       threads)
        .mesh;
  };
  const double unit = 1 / subject.metresPerUnit();
  const auto plain = meshOf(false);
  PairFinder finder(plain, meshOf(true), asked.radius * unit, kReach * unit, asked.longest);
  finder.run(asked.pairs);
  Json json{{"pairs", asked.pairs}, {"triangles", plain->triangles.size()}};
  json.update(finder.figures());
  return json;
}

std::string formatPaths(const Json& results) {
  Table table({"environment", "pairs", "ways found", "claims that failed", "longest ratio", "shortest ratio",
               "median, ms", "99 %, ms"});
  std::string failures;
  for (const Json& entry : results["paths"]) {
    const std::string name = entry["name"];
    if (entry.contains("fails")) {
      table.addRow({name, "", "fails", "", "", "", "", ""});
      failures += "- " + name + ": " + entry["fails"].get<std::string>() + '\n';
      continue;
    }
    table.addRow({name, grouped(entry["pairs"]), grouped(entry["found"]),
                  grouped(static_cast<double>(failedClaims(entry))), groupedWithDecimals(entry["longest"], 5),
                  groupedWithDecimals(entry["shortest"], 5), groupedWithDecimals(entry["median_ms"], 3),
                  groupedWithDecimals(entry["most_ms"], 2)});
  }
  return table.text() + (failures.empty() ? "" : "Fails:\n\n" + failures + '\n');
}

int reportFailedClaims(const std::string& program, const Json& results) {
  int code = 0;
  for (const Json& entry : results["paths"]) {
    if (entry.contains("fails") || failedClaims(entry) == 0) continue;
    code = 1;
    std::fprintf(stderr,
                 "%s: %s: of %d pairs, %zu have a path behind the RadiusFilter and none on the map, %zu one on the map "
                 "for a larger radius and none behind the filter, %zu a longer one on the map, %zu a shorter one for a "
                 "larger radius\n",
                 program.c_str(), entry["name"].get<std::string>().c_str(), entry["pairs"].get<int>(),
                 entry["missing"].get<std::size_t>(), entry["surplus"].get<std::size_t>(),
                 entry["longer"].get<std::size_t>(), entry["shorter"].get<std::size_t>());
  }
  return code;
}

}  // namespace footfall::bench
