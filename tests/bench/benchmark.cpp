// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/benchmark.hpp"

#include <array>
#include <cstdio>
#include <map>
#include <utility>

#include "core/base/background_release.hpp"
#include "tests/bench/cancel_measurement.hpp"
#include "tests/bench/edit_measurement.hpp"
#include "tests/bench/export_measurement.hpp"
#include "tests/bench/generated_levels.hpp"
#include "tests/bench/live_measurement.hpp"
#include "tests/bench/markdown.hpp"
#include "tests/bench/prototype_measurement.hpp"
#include "tests/bench/reach_measurement.hpp"
#include "tests/bench/scene_benchmark.hpp"
#include "tests/bench/scratch_folder.hpp"
#if FOOTFALL_BENCH_RECAST
#include "tests/bench/recast_measurement.hpp"
#endif
#if FOOTFALL_BENCH_EMBREE
#include "footfall/version.hpp"
#include "tests/bench/floor_measurement.hpp"
#endif

namespace footfall::bench {
namespace {

// Seconds that the thesis took for environments of the sizes of our samples (its section 5.4), on 16 cores.
const std::map<std::string, double>& thesisSeconds() {
  static const std::map<std::string, double> seconds{{"house", 3.3}, {"villa", 97}, {"arena", 122}, {"docks", 466}};
  return seconds;
}

void tell(const std::string& name, const std::string& what) {
  std::fprintf(stderr, "%s: %s\n", name.c_str(), what.c_str());
}

class Benchmark {
 public:
  explicit Benchmark(const BenchmarkOptions& options) : options_(options) {}

  Json run() {
    Json results;
    results["program"] = {{"version", FOOTFALL_VERSION},
                          {"recast", FOOTFALL_BENCH_RECAST != 0 && options_.recast},
                          {"embree", FOOTFALL_BENCH_EMBREE != 0 && options_.embree},
                          {"prototype", !options_.prototype.empty()}};
    results["threads"] = options_.threads;
    results["runs"] = options_.repetition.runs;
    results["environments"] = Json::array();
    for (const char* part : {"growth", "cancelling", "live", "exports", "reach", "paths", "crates", "scenes", "turned"})
      results[part] = Json::array();
    if (options_.scenes) {
      results.update(measureScenes(options_));
      return results;
    }
    if (options_.paths.pairs > 0) {
      for (const Subject& subject : options_.given) results["paths"].push_back(measureThePaths(subject, "given"));
      for (const Subject& subject : options_.samples) results["paths"].push_back(measureThePaths(subject, "sample"));
      return results;
    }
    if (options_.crateEdits > 0) {
      for (const Subject& subject : options_.given) addCrates(subject, "given", results["crates"]);
      for (const Subject& subject : options_.samples) addCrates(subject, "sample", results["crates"]);
      return results;
    }
    if (options_.reach) {
      for (const Subject& subject : options_.given) results["reach"].push_back(measureTheReach(subject, "given"));
      for (const Subject& subject : options_.samples) results["reach"].push_back(measureTheReach(subject, "sample"));
      return results;
    }
    for (const Subject& subject : options_.given) results["environments"].push_back(measure(subject, "given"));
    for (const Subject& subject : options_.samples) results["environments"].push_back(measure(subject, "sample"));
    if (options_.growth) results["growth"] = measureGrowth();
    if (options_.cancelMoments > 0) results["cancelling"] = measureCancellings();
    if (options_.live) results["live"] = measureEdits();
    for (const std::uint32_t triangles : options_.exports) {
      tell(std::to_string(triangles) + " triangles", "exports");
      results["exports"].push_back(
          runIsolated([&] { return measureExports(triangles, scratch_.file(""), options_.repetition); },
                      {options_.limits.time, 0}));
    }
    return results;
  }

 private:
  Json ours(const Subject& subject, int threads) const {
    tell(subject.name, "Footfall, " + threadText(threads));
    // The limit of memory is for peers that take what they can get: threads reserve address space they never use.
    return runIsolated(
        [&] {
          detail::keepFreedMemory();  // Like `footfall run`; edits are the editor's, which does not.
          return measurePipeline(subject, threads, options_.repetition);
        },
        {options_.limits.time, 0});
  }

  Json measureTheReach(const Subject& subject, const char* group) const {
    const double step = options_.step / subject.metresPerUnit();
    const int threads = options_.threads.back();
    tell(subject.name, "who can reach whom");
    Json entry{{"name", subject.name}, {"group", group}};
    entry.update(runIsolated([&] { return measureReach(subject, step, threads); }, {options_.limits.time, 0}));
#if FOOTFALL_BENCH_RECAST
    if (options_.recast) {
      tell(subject.name, "who can reach whom in Recast");
      entry["recast"] = runIsolated([&] { return compareReach(subject, step, threads); }, options_.limits);
    }
#endif
    return entry;
  }

  Json measureThePaths(const Subject& subject, const char* group) const {
    PathPairs asked = options_.paths;
    asked.step = options_.step;
    tell(subject.name, "paths for a radius");
    Json entry{{"name", subject.name}, {"group", group}};
    entry.update(
        runIsolated([&] { return measurePaths(subject, asked, options_.threads.back()); }, {options_.limits.time, 0}));
    return entry;
  }

  void addCrates(const Subject& subject, const char* group, Json& entries) const {
    for (const double radius : {0.0, 0.3}) {
      const std::string name = subject.name + (radius > 0 ? ", radius 0.3" : "");
      tell(name, "moves of a crate");
      Json entry{{"name", name}, {"group", group}};
      entry.update(
          runIsolated([&] { return measureCrate(subject, radius, options_.threads.back(), options_.crateEdits); },
                      {options_.limits.time, 0}));
      entries.push_back(std::move(entry));
    }
  }

  Json measure(const Subject& subject, const char* group) {
    Json entry;
    entry["name"] = subject.name;
    entry["group"] = group;
    entry["clearance"] = subject.clearance;
    entry["metres_per_unit"] = subject.metresPerUnit();
    entry["footfall"] = Json::array();
    for (const int threads : options_.threads) {
      entry["footfall"].push_back(ours(subject, threads));
      entry["footfall"].back()["threads"] = threads;
    }
    if (!options_.prototype.empty()) entry["prototype"] = measureThePrototype(subject, entry["footfall"]);
#if FOOTFALL_BENCH_EMBREE
    if (options_.embree) entry["floor"] = measureTheFloor(subject);
#endif
#if FOOTFALL_BENCH_RECAST
    if (options_.recast) entry["recast"] = compareRecast(subject, entry["footfall"].back());
#endif
    if (const auto thesis = thesisSeconds().find(subject.name); thesis != thesisSeconds().end() && group[0] == 's')
      entry["thesis_s"] = thesis->second;
    return entry;
  }

  Json measureThePrototype(const Subject& subject, const Json& footfall) const {
    // Recast reads OBJ with Y up, so Footfall is measured on the same OBJ.
    Subject same = subject;
    const std::string ending = ".obj";
    if (!subject.path.ends_with(ending)) {
      same.path = scratch_.file(subject.name + ending);
      const Json written = runIsolated([&] {
        writeEnvironment(same.path, *loadSubject(subject));
        return Json::object();
      });
      if (written.contains("fails")) {
        Json failed = Json::array();
        for (const int threads : options_.threads)
          failed.push_back({{"fails", written["fails"]}, {"threads", threads}});
        return failed;
      }
    }
    Json entries = Json::array();
    for (std::size_t i = 0; i < options_.threads.size(); ++i) {
      tell(subject.name, "prototype, " + threadText(options_.threads[i]));
      Json entry = measurePrototype(options_.prototype, same, options_.threads[i], options_.repetition);
      entry["threads"] = options_.threads[i];
      const Json own = same.path == subject.path ? footfall[i] : ours(same, options_.threads[i]);
      if (own.contains("file_to_walkable_ms")) entry["ours_ms"] = own["file_to_walkable_ms"];
      entries.push_back(std::move(entry));
    }
    return entries;
  }

#if FOOTFALL_BENCH_EMBREE
  Json measureTheFloor(const Subject& subject) const {
    Json entries = Json::array();
    for (const int threads : options_.threads) {
      tell(subject.name, "reading and Embree's tree, " + threadText(threads));
      entries.push_back(
          runIsolated([&] { return measureFloor(subject.path, *loadSubject(subject), threads, options_.repetition); },
                      {options_.limits.time, 0}));
      entries.back()["threads"] = threads;
    }
    return entries;
  }
#endif

#if FOOTFALL_BENCH_RECAST
  Json compareRecast(const Subject& subject, const Json& footfall) const {
    constexpr std::array<RecastCell, 3> kCells{{{0.3, 0.2}, {0.1, 0.05}, {0.05, 0.05}}};
    Json entries = Json::array();
    for (const RecastCell& cell : kCells) {
      Json entry{{"cell", cell.size}, {"cell_height", cell.height}};
      char text[64];
      std::snprintf(text, sizeof text, "Recast, cells of %g m", cell.size);
      tell(subject.name, text);
      entry.update(runIsolated(
          [&] { return measureRecast(*loadSubject(subject), subject.metresPerUnit(), cell, options_.repetition); },
          options_.limits));
      if (entry.contains("plan_area") && footfall.contains("plan_area"))
        entry["area_percent"] = 100 * (entry["plan_area"].get<double>() / footfall["plan_area"].get<double>() - 1);
      entries.push_back(std::move(entry));
    }
    return entries;
  }
#endif

  using Make = Environment (*)(std::uint32_t);

  Json writeGenerated(const char* series, Make make, std::uint32_t size, Subject& subject) const {
    subject = {std::string(series) + ' ' + std::to_string(size), scratch_.file("generated.obj"), 2};
    return runIsolated([&] {
      writeEnvironment(subject.path, make(size));
      return Json::object();
    });
  }

  Json measureEdits() const {
    constexpr std::uint32_t kTerrainSize = 50'000;
    std::vector<Subject> subjects = options_.given;
    subjects.insert(subjects.end(), options_.samples.begin(), options_.samples.end());
    const Subject terrain{"terrain", scratch_.file("terrain.obj"), 2};
    runIsolated([&] {
      writeEnvironment(terrain.path, makeTerrain(kTerrainSize));
      return Json::object();
    });
    subjects.push_back(terrain);
    Json entries = Json::array();
    for (const Subject& subject : subjects) {
      tell(subject.name, "edits, " + threadText(options_.threads.back()));
      Json entry{{"name", subject.name}};
      entry.update(runIsolated([&] { return measureLive(subject, options_.threads.back(), options_.repetition); },
                               {options_.limits.time, 0}));
      entries.push_back(std::move(entry));
    }
    return entries;
  }

  Json measureGrowth() const {
    Json entries = Json::array();
    const auto series = [&](const char* name, Make make, const std::array<std::uint32_t, 3>& sizes) {
      for (const std::uint32_t size : sizes) {
        Subject subject;
        const Json written = writeGenerated(name, make, size, subject);
        Json entry{{"series", name}, {"size", size}};
        entry.update(written.contains("fails") ? written : ours(subject, options_.threads.back()));
        entries.push_back(std::move(entry));
      }
    };
    series("terrain with obstacles", makeTerrain, {10'000, 100'000, 1'000'000});
    series("obstacles on one floor", makeGiantFloor, {1'000, 10'000, 100'000});
    return entries;
  }

  Json measureCancellings() const {
    Json entries = Json::array();
    const auto add = [&](const Subject& subject) {
      tell(subject.name, "cancelling");
      Json entry{{"name", subject.name}};
      entry.update(
          runIsolated([&] { return measureCancelling(subject, options_.threads.back(), options_.cancelMoments); },
                      {options_.limits.time * (options_.cancelMoments + 1), 0}));
      entries.push_back(std::move(entry));
    };
    const auto addGenerated = [&](const char* series, Make make, std::uint32_t size) {
      Subject subject;
      const Json written = writeGenerated(series, make, size, subject);
      if (written.contains("fails"))
        throw std::runtime_error(subject.path + ": " + written["fails"].get<std::string>());
      add(subject);
    };
    for (const Subject& subject : options_.given) add(subject);
    for (const Subject& subject : options_.samples) add(subject);
    if (options_.growth) {
      addGenerated("terrain with obstacles", makeTerrain, 1'000'000);
      addGenerated("obstacles on one floor", makeGiantFloor, 100'000);
    }
    return entries;
  }

  BenchmarkOptions options_;
  ScratchFolder scratch_;
};

}  // namespace

Json runBenchmark(const BenchmarkOptions& options) { return Benchmark(options).run(); }

}  // namespace footfall::bench
