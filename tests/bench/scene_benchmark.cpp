// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/scene_benchmark.hpp"

#include <array>
#include <cstdio>
#include <filesystem>

#include "tests/bench/scene_measurement.hpp"
#include "tests/bench/scratch_folder.hpp"
#if FOOTFALL_BENCH_RECAST
#include "tests/bench/recast_measurement.hpp"
#endif

namespace footfall::bench {
namespace {

void tell(const Subject& subject, const char* what) { std::fprintf(stderr, "%s: %s\n", subject.name.c_str(), what); }

class SceneBenchmark {
 public:
  explicit SceneBenchmark(const BenchmarkOptions& options) : options_(options) {}

  Json run() const {
    Json scenes = Json::array(), turned = Json::array();
    for (Subject subject : options_.given) {
      subject.name = std::filesystem::path(subject.path).filename().string();  // no generated scene has an ending
      scenes.push_back(measureScene(subject, "file"));
    }
    for (const std::string& kind : sceneKinds()) scenes.push_back(measureGenerated(kind));
    for (const std::vector<Subject>* subjects : {&options_.turned, &options_.samples})
      for (const Subject& subject : *subjects) turned.push_back(turn(subject));
    return {{"scenes", std::move(scenes)}, {"turned", std::move(turned)}};
  }

 private:
  // No limit of memory: threads reserve address space that they never use.
  [[nodiscard]] Limits ownLimits() const { return {options_.limits.time, 0}; }

  Json measureGenerated(const std::string& kind) const {
    const Subject subject{kind, scratch_.file(kind + ".obj"), 2};
    const Json written = runIsolated([&] {
      writeScene(kind, options_.sceneTriangles, subject.path);
      return Json::object();
    });
    if (!written.contains("fails")) return measureScene(subject, "generated");
    return {{"name", kind},    {"group", "generated"}, {"runs", written}, {"radius_drops", written},
            {"peak", written}, {"recast", Json()}};
  }

  Json measureScene(const Subject& subject, const char* group) const {
    const std::vector<SceneRun> runs{
        {"default_1", SceneFilters::Default, GridChoice::Auto, 0, 0, 1},
        {"default_2", SceneFilters::Default, GridChoice::Auto, 0, 0, 2},
        {"plain", SceneFilters::WithoutSteps, GridChoice::Auto, 0, 0, 1},
        {"radius", SceneFilters::WithoutSteps, GridChoice::Auto, kSceneRadius, 0, 1},
        {"on", SceneFilters::WithoutSteps, GridChoice::On, 0, 0, 1},
        {"off", SceneFilters::WithoutSteps, GridChoice::Off, 0, 0, 1},
    };
    // In a process of its own: what takes far longer than the others must not cost their figures.
    const SceneRun walk{"default_1", SceneFilters::Default, GridChoice::Auto, kSceneRadius, kSceneDrop, 1};
    Json entry{{"name", subject.name}, {"group", group}};
    tell(subject, "runs, in turns");
    entry["runs"] = runIsolated([&] { return measureSceneRuns(subject, runs, options_.repetition); }, ownLimits());
    tell(subject, "with a radius and drops");
    entry["radius_drops"] =
        runIsolated([&] { return measureSceneRuns(subject, {walk}, options_.repetition); }, ownLimits());
    tell(subject, "memory");
    entry["peak"] = runIsolated([&] { return measureScenePeak(subject, 2); }, ownLimits());
    entry["recast"] = measureRecasts(subject);
    return entry;
  }

  Json measureRecasts([[maybe_unused]] const Subject& subject) const {
#if FOOTFALL_BENCH_RECAST
    if (!options_.recast) return {};
    constexpr std::array<RecastCell, 2> kCells{{{0.3, 0.2}, {0.1, 0.05}}};
    Json all;
    for (const auto& [key, radius] : {std::pair("plain", 0.0), {"radius", kSceneRadius}}) {
      all[key] = Json::array();
      for (const RecastCell& cell : kCells) {
        tell(subject, "Recast");
        Json entry{{"cell", cell.size}};
        const double metres = subject.metresPerUnit(), agentRadius = radius;
        entry.update(runIsolated(
            [&] { return measureRecast(*loadSubject(subject), metres, cell, options_.repetition, agentRadius); },
            options_.limits));
        all[key].push_back(std::move(entry));
      }
    }
    return all;
#else
    return {};
#endif
  }

  Json turn(const Subject& subject) const {
    tell(subject, "turned");
    Json entry{{"name", subject.name}};
    entry.update(runIsolated([&] { return measureTurned(subject, options_.repetition); }, ownLimits()));
    return entry;
  }

  const BenchmarkOptions& options_;
  ScratchFolder scratch_;
};

}  // namespace

Json measureScenes(const BenchmarkOptions& options) { return SceneBenchmark(options).run(); }

}  // namespace footfall::bench
