// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/live_measurement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "core/base/process_usage.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/edit.hpp"
#include "footfall/filter.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

constexpr int kEditsPerRun = 12;
constexpr std::uint32_t kSides = 26;  // sides of a prism with 4 * 26 - 4 = 100 triangles

/// An upright prism, its corners on a grid of 1/64 of `unit` as those of levels are on grids.
TriangleSoup pillar(const Vec3& foot, double radius, double height, double unit) {
  const auto onGrid = [unit](double x) { return std::round(x / unit * 64) * unit / 64; };
  TriangleSoup soup;
  for (const double z : {foot.z, foot.z + height})
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSides;
      soup.vertices.push_back(
          {onGrid(foot.x + radius * std::cos(angle)), onGrid(foot.y + radius * std::sin(angle)), z});
    }
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t next = (i + 1) % kSides;
    soup.triangles.push_back({i, next, kSides + next});
    soup.triangles.push_back({i, kSides + next, kSides + i});
    if (i < 2) continue;
    soup.triangles.push_back({0, i, i - 1});
    soup.triangles.push_back({kSides, kSides + i - 1, kSides + i});
  }
  return soup;
}

class Measurement {
 public:
  Measurement(const Subject& subject, int threads)
      : subject_(subject),
        threads_(threads),
        environment_(loadSubject(subject)),
        pipeline_(pipelineWithoutSteps(subject, *environment_)) {}

  void once() {
    ResultCache cache;
    const auto run = [&](const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline) {
      RunContext context;
      return runPipeline(environment, pipeline, context, &cache, threads_);
    };
    const RunResult first = run(environment_, pipeline_);
    samples_.add("full_ms", first.totalMs);
    samples_.add("slope_ms", run(environment_, edited("SlopeFilter", [](double v) { return v + 1; })).totalMs);
    samples_.add("clearance_ms",
                 run(environment_, edited("VerticalClearanceFilter", [](double v) { return v * 1.05; })).totalMs);
    if (first.mesh->triangles.empty()) return;

    EditableEnvironment editable(environment_);
    std::optional<ObstacleId> obstacle;
    std::mt19937 random(1);
    const double unit = subject_.clearance / 2;
    for (int i = 0; i < kEditsPerRun; ++i) {
      const Triangle& floor = first.mesh->triangles[random() % first.mesh->triangles.size()];
      const double radius = unit * (1 + random() % 3) / 2, height = unit * (1 + random() % 6) / 4;
      const TriangleSoup soup = pillar(first.mesh->vertices[floor[0]], radius, height, unit);
      const Stopwatch watch;
      if (!obstacle) {
        obstacle = editable.add(soup);
      } else if (i + 1 < kEditsPerRun) {
        editable.replace(*obstacle, soup);
      } else {
        editable.remove(*obstacle);
      }
      run(editable.environment(), pipeline_);
      samples_.add("obstacle_ms", watch.wallMs());
    }
  }

  void keepWarm() { samples_.clear(); }

  [[nodiscard]] Json result(int runs) const {
    Json json{{"threads", threads_}, {"triangles", environment_->triangles.size()}};
    for (const char* figure : {"full_ms", "obstacle_ms", "slope_ms", "clearance_ms"})
      json[figure] = samples_.median(figure);
    json["obstacle_most_ms"] = samples_.most("obstacle_ms");
    json["edits"] = runs * kEditsPerRun;
    return json;
  }

 private:
  template <class Change>
  Pipeline edited(std::string_view filter, Change change) const {
    Pipeline pipeline = pipeline_;
    for (PipelineStep& step : pipeline.steps)
      if (step.filter->name == filter) step.values[0] = change(step.values[0]);
    return pipeline;
  }

  Subject subject_;
  int threads_;
  std::shared_ptr<const Environment> environment_;
  Pipeline pipeline_;
  Samples samples_;
};

}  // namespace

Json measureLive(const Subject& subject, int threads, const Repetition& repetition) {
  Measurement measurement(subject, threads);
  const int runs = repeat(
      repetition, [&] { measurement.once(); }, [&] { measurement.keepWarm(); });
  return measurement.result(runs);
}

}  // namespace footfall::bench
