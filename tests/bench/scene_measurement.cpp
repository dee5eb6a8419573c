// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/scene_measurement.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>
#include <stdexcept>

#include "core/base/background_release.hpp"
#include "core/base/process_usage.hpp"
#include "core/io/import.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/agent.hpp"
#include "footfall/inspect.hpp"
#include "samples/generator/scenes.hpp"
#include "tests/support/changed_level.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

using Level = std::shared_ptr<const Environment>;

Level loadWithGrid(const Subject& subject, GridChoice grid) {
  ImportOptions options;
  options.metresPerUnit = subject.metresPerUnit();
  options.grid = grid;
  return importEnvironment(subject.path, options);
}

// The agent is 2 m high, whatever the subject's unit.
Pipeline pipelineOf(const Environment& level, const SceneRun& run) {
  Agent agent;
  agent.radius = run.radius;
  agent.drop = run.drop;
  if (run.filters == SceneFilters::WithoutSteps) agent.step = 0;
  return pipelineFor(level, agent);
}

/// One kind of run and what its rounds gave.
class Contender {
 public:
  Contender(Level level, const SceneRun& run)
      : level_(std::move(level)), pipeline_(pipelineOf(*level_, run)), threads_(run.threads) {}

  void once() {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads_));
    RunContext context;
    const Stopwatch watch;
    result_ = runPipeline(level_, pipeline_, context, nullptr, threads_);
    samples_.add("cpu_ms", watch.cpuMs());
    samples_.add("wall_ms", watch.wallMs());
  }
  void forgetTimes() { samples_.clear(); }

  [[nodiscard]] Json figures() const {
    std::uint64_t decisions = 0;
    for (const StepStatistics& step : result_.steps) decisions += step.fallbacks.total();
    const double metres = level_->metresPerUnit;
    return {{"threads", threads_},
            {"wall_ms", samples_.least("wall_ms")},
            {"cpu_ms", samples_.least("cpu_ms")},
            {"exact_decisions", decisions},
            {"square_metres", result_.summary.area * metres * metres},
            {"share", findComponents(*result_.mesh).connectedShare()}};
  }

 private:
  Level level_;
  Pipeline pipeline_;
  int threads_;
  Samples samples_;
  RunResult result_;
};

void takeTurns(std::vector<Contender>& contenders, const Repetition& repetition) {
  repeat(
      repetition,
      [&] {
        for (Contender& contender : contenders) contender.once();
      },
      [&] {
        for (Contender& contender : contenders) contender.forgetTimes();
      });
}

}  // namespace

Json measureSceneRuns(const Subject& subject, const std::vector<SceneRun>& runs, const Repetition& repetition) {
  keepFreedMemory();  // Like `footfall run`.
  std::map<GridChoice, Level> levels{{GridChoice::Auto, loadWithGrid(subject, GridChoice::Auto)}};
  std::vector<Contender> contenders;
  for (const SceneRun& run : runs) {
    Level& level = levels[run.grid];
    if (level == nullptr) level = loadWithGrid(subject, run.grid);
    contenders.emplace_back(level, run);
  }
  takeTurns(contenders, repetition);
  const Environment& usual = *levels[GridChoice::Auto];
  Json json{{"triangles", usual.triangles.size()}, {"grid_step", usual.grid.step * usual.metresPerUnit}};
  for (std::size_t i = 0; i < runs.size(); ++i) json[runs[i].key] = contenders[i].figures();
  return json;
}

Json measureScenePeak(const Subject& subject, int threads) {
  keepFreedMemory();
  std::vector<Contender> contenders;
  SceneRun run;
  run.threads = threads;
  contenders.emplace_back(loadWithGrid(subject, GridChoice::Auto), run);
  contenders.front().once();
  return {{"peak_bytes", peakRssBytes()}};
}

Json measureTurned(const Subject& subject, const Repetition& repetition) {
  keepFreedMemory();
  const Level original = loadWithGrid(subject, GridChoice::Auto);
  const test::LevelChange turn{kTurnDegrees, 1, 0};
  const Level on = test::changedLevel(*original, turn, GridChoice::On);
  const Level off = test::changedLevel(*original, turn, GridChoice::Off);
  std::vector<Contender> contenders;
  for (const Level& level : {original, on, off}) contenders.emplace_back(level, SceneRun{});
  takeTurns(contenders, repetition);
  return {{"triangles", original->triangles.size()}, {"welded", on->grid.weldedVertices},
          {"split", on->grid.splitTriangles},        {"original", contenders[0].figures()},
          {"on", contenders[1].figures()},           {"off", contenders[2].figures()}};
}

void writeScene(const std::string& kind, std::uint64_t triangles, const std::string& path) {
  const auto found =
      std::ranges::find(samples::kScenes, kind, [](const samples::SceneKind& scene) { return scene.name; });
  if (found == samples::kScenes.end()) throw std::runtime_error(kind + ": is no kind of scene");
  std::ofstream file(path, std::ios::binary);
  found->write(file, triangles, 1);
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

std::vector<std::string> sceneKinds() {
  std::vector<std::string> names;
  for (const samples::SceneKind& scene : samples::kScenes) names.emplace_back(scene.name);
  return names;
}

}  // namespace footfall::bench
