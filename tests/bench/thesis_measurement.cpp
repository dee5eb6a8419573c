// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/thesis_measurement.hpp"

#include <chrono>
#include <map>
#include <thread>

#include "core/base/process_usage.hpp"
#include "core/io/export.hpp"
#include "footfall/errors.hpp"
#include "tests/bench/pipeline_measurement.hpp"
#include "tests/bench/sampling.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

// TBB's workers leave the arena of a run that has ended only after a hundred yields. On a busy machine, where they
// share a processor with the run that follows, that lasts as long as it does, and it has one thread.
constexpr std::chrono::milliseconds kPause{5};

void addTimes(const RunResult& result, Samples& samples) {
  const RunTimes& times = result.times;
  samples.add("total_ms", times.total);
  samples.add("cpu_ms", result.cpuMs);
  samples.add("preprocessing_ms", times.preprocessing);
  samples.add("partitioning_ms", times.partitioning);
  samples.add("parallel_ms", times.parallel);
  samples.add("merging_ms", times.merging);
  samples.add("postprocessing_ms", times.postprocessing);
  samples.add("overhead_ms", times.overhead);
  samples.add("cut_share", (times.partitioning + times.merging) / times.total);
  if (!result.blocks.empty()) samples.add("imbalance", result.blocks.back().imbalance(result.threads));
}

class TimesMeasurement {
 public:
  TimesMeasurement(const ThesisSubject& subject, const std::vector<Configuration>& configurations)
      : subject_(subject), environment_(loadSubject(subject.subject)) {
    for (const Configuration& configuration : configurations) slots_.push_back({configuration, {}, {}, 0});
  }

  void warmUp() {
    std::map<FilterList, std::string> exports;
    for (Slot& slot : slots_) {
      try {
        const RunResult result = runConfiguration(subject_, environment_, slot.configuration);
        describe(result, slot.json);
        std::string bytes = formatObj(*result.mesh, {});
        const auto [first, isFirst] = exports.try_emplace(slot.configuration.filters, std::move(bytes));
        if (!isFirst) slot.json["bytes_equal"] = first->second == bytes;
      } catch (const InputError& error) {
        slot.json["fails"] = error.what();
      }
    }
  }

  void round(bool backwards) {
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      Slot& slot = slots_[backwards ? slots_.size() - 1 - i : i];
      if (slot.json.contains("fails")) continue;
      std::this_thread::sleep_for(kPause);
      addTimes(runConfiguration(subject_, environment_, slot.configuration), slot.samples);
      ++slot.runs;
    }
  }

  Json results() {
    Json list = Json::array();
    for (Slot& slot : slots_) {
      if (!slot.json.contains("fails")) addMedians(slot);
      list.push_back(std::move(slot.json));
    }
    return list;
  }

 private:
  struct Slot {
    Configuration configuration;
    Samples samples;
    Json json;
    int runs = 0;
  };

  static void describe(const RunResult& result, Json& json) {
    json = Json::object();
    json["triangles"] = result.mesh->triangles.size();
    json["area"] = planArea(*result.mesh);
    if (result.blocks.empty()) return;
    const BlockReport& block = result.blocks.back();
    json["cells"] = block.cells.size();
    json["made_by"] = block.strategy;
    json["reason"] = block.reason.str();
  }

  static void addMedians(Slot& slot) {
    slot.json["runs"] = slot.runs;
    for (const char* figure : {"total_ms", "cpu_ms", "preprocessing_ms", "partitioning_ms", "parallel_ms", "merging_ms",
                               "postprocessing_ms", "overhead_ms", "cut_share"}) {
      slot.json[figure] = slot.samples.median(figure);
    }
    if (slot.json.contains("cells")) slot.json["imbalance"] = slot.samples.median("imbalance");
  }

  const ThesisSubject& subject_;
  std::shared_ptr<const Environment> environment_;
  std::vector<Slot> slots_;
};

}  // namespace

RunResult runConfiguration(const ThesisSubject& subject, const std::shared_ptr<const Environment>& environment,
                           const Configuration& configuration) {
  RunContext context;
  const Pipeline pipeline = makeThesisPipeline(subject, *environment, configuration.filters, configuration.strategy);
  return runPipeline(environment, pipeline, context, nullptr, configuration.threads);
}

Json measureTimes(const ThesisSubject& subject, const std::vector<Configuration>& configurations,
                  const Rounds& rounds) {
  TimesMeasurement measurement(subject, configurations);
  measurement.warmUp();
  const Stopwatch watch;
  for (int done = 0; done == 0 || (watch.wallMs() < 1000 * rounds.mostSeconds &&
                                   (done < rounds.runs || watch.wallMs() < 1000 * rounds.leastSeconds));
       ++done) {
    measurement.round(done % 2 == 1);
  }
  return measurement.results();
}

Json measureMemory(const ThesisSubject& subject, const Configuration& configuration) {
  const std::shared_ptr<const Environment> environment = loadSubject(subject.subject);
  runConfiguration(subject, environment, configuration);
  return {{"triangles", environment->triangles.size()}, {"peak_bytes", peakRssBytes()}};
}

}  // namespace footfall::bench
