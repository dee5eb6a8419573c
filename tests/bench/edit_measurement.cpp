// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/edit_measurement.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/base/process_usage.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/edit.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/path.hpp"
#include "tests/bench/markdown.hpp"
#include "tests/bench/sampling.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

constexpr int kPlaces = 5;
constexpr double kWidth = 0.8, kHeight = 1, kMove = 0.5;  // metres

Pipeline pipelineWithRadius(const Subject& subject, const Environment& environment, double radius) {
  Pipeline pipeline = pipelineFor(subject, environment);
  if (radius == 0) return pipeline;
  PipelineStep step = defaultStep(filterDescriptor(FilterType::Radius), environment.metresPerUnit);
  step.values[0] = step.values[1] = radius / subject.metresPerUnit();
  const auto behind = std::ranges::find_if(
      pipeline.steps, [](const PipelineStep& known) { return known.filter->type == FilterType::Step; });
  pipeline.steps.insert(behind + 1, std::move(step));
  return pipeline;
}

TriangleSoup crateAt(const Vec3& foot, double unit) {
  TriangleSoup soup;
  for (const double z : {0.0, kHeight})
    for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
      soup.vertices.push_back({foot.x + x * kWidth * unit, foot.y + y * kWidth * unit, foot.z + z * unit});
  soup.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t next = (i + 1) % 4;
    soup.triangles.push_back({i, next, 4 + next});
    soup.triangles.push_back({i, 4 + next, 4 + i});
  }
  return soup;
}

class Crate {
 public:
  Crate(const Subject& subject, double radius, int threads)
      : threads_(threads),
        unit_(1 / subject.metresPerUnit()),
        environment_(loadSubject(subject)),
        pipeline_(pipelineWithRadius(subject, *environment_, radius)) {}

  Json run(int edits) {
    const RunResult first = runOnce(environment_);
    if (first.mesh->triangles.empty()) throw std::runtime_error("nothing is walkable: there is no place for a crate");
    names_.push_back("edit");
    names_.push_back("start");
    for (const StepStatistics& step : first.steps) names_.push_back(step.name);
    names_.insert(names_.end(), {"navigation mesh", "path finder", "new path finder"});
    finder_ = std::make_unique<const PathFinder>(first.mesh);
    std::vector<double> sums(names_.size(), 0);
    EditableEnvironment editable(environment_);
    std::mt19937 random(1);
    std::optional<ObstacleId> crate;
    for (int place = 0; place < kPlaces; ++place) {
      const Triangle& floor = first.mesh->triangles[random() % first.mesh->triangles.size()];
      Vec3 foot = first.mesh->vertices[floor[0]];
      crate = crate ? (editable.replace(*crate, crateAt(foot, unit_)), *crate) : editable.add(crateAt(foot, unit_));
      runOnce(editable.environment());
      std::vector<double> least;
      for (int i = 0; i < edits; ++i) {
        foot.x += (i % 2 == 0 ? kMove : -kMove) * unit_;
        const std::vector<double> times = measureMove(editable, *crate, crateAt(foot, unit_));
        if (least.empty()) least = times;
        std::ranges::transform(least, times, least.begin(), [](double a, double b) { return std::min(a, b); });
      }
      for (std::size_t part = 0; part < sums.size(); ++part) sums[part] += least[part];
    }
    return figures(sums);
  }

 private:
  RunResult runOnce(const std::shared_ptr<const Environment>& environment, RunContext::Listener listener = {}) {
    RunContext context(std::move(listener));
    return runPipeline(environment, pipeline_, context, &cache_, threads_);
  }

  // The processor time of each part, in the order of names_.
  std::vector<double> measureMove(EditableEnvironment& editable, ObstacleId crate, const TriangleSoup& soup) {
    std::vector<double> times;
    double mark = processCpuMs();
    const auto lap = [&] {
      const double now = processCpuMs();
      times.push_back(now - std::exchange(mark, now));
    };
    editable.replace(crate, soup);
    lap();
    bool isStarted = false;
    const RunResult result = runOnce(editable.environment(), [&](const RunEvent& event) {
      if (event.kind == RunEvent::Kind::StepStarted && !std::exchange(isStarted, true)) lap();
      if (event.kind == RunEvent::Kind::StepFinished) lap();
    });
    lap();
    auto finder = std::make_unique<const PathFinder>(result.mesh, *finder_);
    lap();
    finder_ = std::move(finder);
    mark = processCpuMs();
    const PathFinder anew(result.mesh);
    lap();
    return times;
  }

  [[nodiscard]] Json figures(const std::vector<double>& sums) const {
    Json json{{"triangles", environment_->triangles.size()}, {"threads", threads_}};
    const std::size_t last = sums.size() - 2;
    json["edit_ms"] = sums[0] / kPlaces;
    json["start_ms"] = sums[1] / kPlaces;
    json["steps"] = Json::array();
    for (std::size_t part = 2; part + 1 < last; ++part)
      json["steps"].push_back({{"name", names_[part]}, {"ms", sums[part] / kPlaces}});
    json["navigation_mesh_ms"] = sums[last - 1] / kPlaces;
    double whole = 0;
    for (std::size_t part = 0; part < last; ++part) whole += sums[part] / kPlaces;
    json["whole_ms"] = whole;
    json["path_finder_ms"] = sums[last] / kPlaces;
    json["new_path_finder_ms"] = sums[last + 1] / kPlaces;
    return json;
  }

  int threads_;
  double unit_;
  std::shared_ptr<const Environment> environment_;
  Pipeline pipeline_;
  ResultCache cache_;
  std::vector<std::string> names_;
  std::unique_ptr<const PathFinder> finder_;  // of the last result
};

std::string stepText(const Json& entry, const std::string& name) {
  for (const Json& step : entry["steps"])
    if (step["name"] == name) return number(step["ms"]);
  return "";
}

}  // namespace

Json measureCrate(const Subject& subject, double radius, int threads, int edits) {
  return Crate(subject, radius, threads).run(edits);
}

std::string formatCrates(const Json& results) {
  const std::vector<std::pair<std::string, std::string>> columns{{"VerticalClearanceFilter", "clearance"},
                                                                 {"StepFilter", "steps"},
                                                                 {"RadiusFilter", "radius"},
                                                                 {"AreaFilter", "area"},
                                                                 {"SimplificationFilter", "simplification"},
                                                                 {"LayerSubdivisionFilter", "layers"}};
  std::vector<std::string> header{"environment", "triangles", "edit", "start"};
  for (const auto& [filter, heading] : columns) header.push_back(heading);
  header.insert(header.end(), {"navigation mesh", "whole", "path finder", "new path finder"});
  Table table(header);
  std::string failures;
  for (const Json& entry : results["crates"]) {
    const std::string name = entry["name"];
    if (entry.contains("fails")) {
      failures += "- " + name + ": " + entry["fails"].get<std::string>() + '\n';
      continue;
    }
    std::vector<std::string> row{name, grouped(entry["triangles"]), number(entry["edit_ms"]),
                                 number(entry["start_ms"])};
    for (const auto& [filter, heading] : columns) row.push_back(stepText(entry, filter));
    for (const char* figure : {"navigation_mesh_ms", "whole_ms", "path_finder_ms", "new_path_finder_ms"})
      row.push_back(number(entry[figure]));
    table.addRow(row);
  }
  return table.text() + (failures.empty() ? "" : "Fails:\n\n" + failures + '\n');
}

}  // namespace footfall::bench
