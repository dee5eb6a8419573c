// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/pipeline_measurement.hpp"

#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/process_usage.hpp"
#include "core/base/triangle_tree.hpp"
#include "core/io/export.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/report.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

// The processor time between the steps, which the runner's own statistics do not have.
class CpuMarks {
 public:
  RunContext::Listener listener() {
    return [this](const RunEvent& event) {
      if (event.kind == RunEvent::Kind::StepStarted && firstStep_ < 0) firstStep_ = processCpuMs();
      if (event.kind == RunEvent::Kind::StepFinished) lastStep_ = processCpuMs();
    };
  }
  [[nodiscard]] double startMs() const { return firstStep_ - begun_; }
  [[nodiscard]] double finishMs() const { return processCpuMs() - lastStep_; }

 private:
  double begun_ = processCpuMs();
  double firstStep_ = -1;
  double lastStep_ = begun_;
};

// The tree over all triangles alone; it is a part of the start.
double measureTree(const Environment& environment) {
  std::vector<Box> boxes;
  std::vector<std::int32_t> ids;
  for (const Triangle& t : environment.triangles) {
    Box box{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (const std::uint32_t corner : t) {
      const Vec3& v = environment.vertices[corner];
      const std::array<double, 3> place{v.x, v.y, v.z};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.lower[axis] = std::min(box.lower[axis], place[axis]);
        box.upper[axis] = std::max(box.upper[axis], place[axis]);
      }
    }
    ids.push_back(static_cast<std::int32_t>(boxes.size()));
    boxes.push_back(box);
  }
  const Stopwatch watch;
  TriangleTree tree;
  tree.build(std::move(boxes), std::move(ids));
  return watch.wallMs();
}

// A file that goes with the measurement.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& ending)
      : path_(std::filesystem::temp_directory_path() / ("footfall-bench-" + std::to_string(::getpid()) + ending)) {}
  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

Json countFallbacks(const RunResult& result) {
  ExactFallbacks sum;
  for (const StepStatistics& step : result.steps) sum += step.fallbacks;
  return {{"slope", sum.slope}, {"height", sum.height}, {"orientation", sum.orientation},
          {"side", sum.side},   {"order", sum.order},   {"area", sum.area}};
}

class Measurement {
 public:
  Measurement(const Subject& subject, int threads)
      : subject_(subject),
        threads_(threads),
        limit_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)),
        export_(".obj") {}

  void once() {
    const Stopwatch loading;
    environment_ = loadSubject(subject_);
    const double loadMs = loading.wallMs();
    samples_.add("load_ms", loadMs);
    samples_.add("load_cpu_ms", loading.cpuMs());

    const Pipeline pipeline = pipelineWithoutSteps(subject_, *environment_);
    const Stopwatch running;
    CpuMarks marks;
    RunContext context(marks.listener());
    result_ = runPipeline(environment_, pipeline, context, nullptr, threads_);
    samples_.add("run_cpu_ms", running.cpuMs());
    samples_.add("navigation_mesh_cpu_ms", marks.finishMs());
    samples_.add("run_ms", result_.totalMs);
    samples_.add("start_ms", result_.startMs);
    samples_.add("start_cpu_ms", marks.startMs());
    samples_.add("navigation_mesh_ms", result_.finishMs);
    double toWalkable = loadMs + result_.startMs;
    bool walkable = false;
    for (std::size_t i = 0; i < result_.steps.size(); ++i) {
      const StepStatistics& step = result_.steps[i];
      samples_.add(stepKey(i, "wall"), step.wallMs);
      samples_.add(stepKey(i, "cpu"), step.cpuMs);
      if (!walkable) toWalkable += step.wallMs;
      walkable = walkable || step.name == "VerticalClearanceFilter";
    }
    samples_.add("file_to_walkable_ms", toWalkable);

    const Stopwatch exporting;
    save(*result_.mesh, export_.path(), {}, makeExportHeader(pipeline));
    samples_.add("export_ms", exporting.wallMs());
    samples_.add("export_cpu_ms", exporting.cpuMs());
  }

  // Call this after the first run: its memory counts, its times do not.
  void keepWarm() {
    peakBytes_ = peakRssBytes();
    samples_.clear();
  }

  [[nodiscard]] Json result(int runs) const {
    Json json;
    json["threads"] = threads_;
    json["runs"] = runs;
    json["triangles"] = environment_->triangles.size();
    json["is_obj"] = subject_.path.ends_with(".obj");
    json["file_bytes"] = std::filesystem::file_size(subject_.path);
    for (const char* figure : {"load_ms", "load_cpu_ms", "start_ms", "start_cpu_ms"}) addFigure(json, figure);
    json["load_mb_per_s"] = json["file_bytes"].get<double>() / 1e3 / samples_.median("load_ms");
    Samples tree;
    for (int i = 0; i < runs; ++i) tree.add("tree", measureTree(*environment_));
    json["tree_ms"] = tree.median("tree");
    json["steps"] = Json::array();
    for (std::size_t i = 0; i < result_.steps.size(); ++i) {
      json["steps"].push_back({{"name", result_.steps[i].name},
                               {"wall_ms", samples_.median(stepKey(i, "wall"))},
                               {"cpu_ms", samples_.median(stepKey(i, "cpu"))}});
    }
    for (const char* figure : {"navigation_mesh_ms", "navigation_mesh_cpu_ms", "export_ms", "export_cpu_ms", "run_ms",
                               "run_cpu_ms", "file_to_walkable_ms"}) {
      addFigure(json, figure);
    }
    json["run_least_ms"] = samples_.least("run_ms");
    json["run_most_ms"] = samples_.most("run_ms");
    json["peak_bytes"] = peakBytes_;
    json["peak_above_start_bytes"] = peakBytes_ - startBytes_;
    json["exact_fallbacks_by_kind"] = countFallbacks(result_);
    json["walkable_triangles"] = result_.mesh->triangles.size();
    json["layers"] = result_.mesh->layerCount;
    json["plan_area"] = planArea(*result_.mesh);
    return json;
  }

 private:
  static std::string stepKey(std::size_t step, const char* clock) { return std::to_string(step) + clock; }
  void addFigure(Json& json, const char* name) const { json[name] = samples_.median(name); }

  Subject subject_;
  int threads_;
  tbb::global_control limit_;  // covers work outside the runner, too
  ScratchFile export_;
  Samples samples_;
  std::shared_ptr<const Environment> environment_;
  RunResult result_;
  std::uint64_t startBytes_ = residentMemory().now;
  std::uint64_t peakBytes_ = 0;
};

}  // namespace

Pipeline pipelineFor(const Subject& subject, const Environment& environment) {
  Pipeline pipeline = defaultPipeline(environment);
  for (PipelineStep& step : pipeline.steps) {
    if (step.filter->type == FilterType::VerticalClearance) step.values[0] = subject.clearance;
  }
  return pipeline;
}

Pipeline pipelineWithoutSteps(const Subject& subject, const Environment& environment) {
  Pipeline pipeline = pipelineFor(subject, environment);
  std::erase_if(pipeline.steps, [](const PipelineStep& step) { return step.filter->type == FilterType::Step; });
  return pipeline;
}

double planArea(const NavigationMesh& mesh) {
  double twice = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    twice += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  return twice / 2;
}

Json measurePipeline(const Subject& subject, int threads, const Repetition& repetition) {
  Measurement measurement(subject, threads);
  const int runs = repeat(
      repetition, [&] { measurement.once(); }, [&] { measurement.keepWarm(); });
  return measurement.result(runs);
}

}  // namespace footfall::bench
