// Runs that are cancelled at many moments: each ends with Cancelled, soon, and the next run gives the same bytes.
//
// FOOTFALL_TEST_ROUNDS multiplies the number of moments. FOOTFALL_CANCEL_FILES adds environments, as FILE:CLEARANCE
// with spaces between them. Standard output has a row for each environment and pipeline.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "core/base/process_usage.hpp"
#include "core/io/import.hpp"
#include "footfall/edit.hpp"
#include "footfall/errors.hpp"
#include "footfall/run.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::test;

namespace {

/// Default, and the kinds of work that have groups of their own. `c` is a clearance of 2 m in the environment's units.
std::string pipelineOf(const std::string& kind, double c) {
  const auto times = [&](double factor) { return std::to_string(factor * c) + "\n"; };
  const std::string clearance = "SlopeFilter 45\nVerticalClearanceFilter " + times(1), area = "AreaFilter 0.5\n";
  std::string text = "DuplicationFilter 0\nDegeneracyFilter\n";
  if (kind == "short") return "DuplicationFilter 0\n" + clearance + area + "LayerSubdivisionFilter\n";
  text += kind == "block" ? "AutoStrategy\n" + clearance + "Collapse\n" : clearance;
  if (kind != "plain") text += "StepFilter " + times(0.2);
  if (kind == "radius") text += "RadiusFilter " + times(0.15);
  text += area + "SimplificationFilter\nLayerSubdivisionFilter\n";
  if (kind == "drops") text += "DropFilter " + times(1);
  return text;
}

/// Cancels a run some time after it was made, unless the run ends before.
class Canceller {
 public:
  Canceller(RunContext& context, double afterMs)
      : thread_([this, &context, afterMs] {
          std::unique_lock lock(mutex_);
          if (ended_.wait_for(lock, std::chrono::duration<double, std::milli>(afterMs), [this] { return isOver_; }))
            return;
          cpuMs_ = detail::processCpuMs();
          context.cancel();
        }) {}
  ~Canceller() { end(); }
  Canceller(const Canceller&) = delete;
  Canceller& operator=(const Canceller&) = delete;

  /// The processor time of all threads since the run was cancelled; nothing when it ended before.
  std::optional<double> end() {
    const double now = detail::processCpuMs();
    {
      const std::lock_guard lock(mutex_);
      isOver_ = true;
    }
    ended_.notify_all();
    if (thread_.joinable()) thread_.join();
    return cpuMs_ ? std::optional(now - *cpuMs_) : std::nullopt;
  }

 private:
  std::mutex mutex_;
  std::condition_variable ended_;
  bool isOver_ = false;
  std::optional<double> cpuMs_;
  std::thread thread_;  // last: it uses the others
};

struct Outcome {
  int cancelled = 0, ended = 0;
  double mostCpuMs = 0;
};

class Trial {
 public:
  Trial(const std::shared_ptr<const Environment>& environment, const std::string& pipeline)
      : environment_(environment), pipeline_(parsePipeline(pipeline, "test")) {}

  Outcome runFromNothing(int moments) {
    return cancelAt(moments, [this] {
      return [this](RunContext& context) { runPipeline(environment_, pipeline_, context, nullptr, 2); };
    });
  }

  /// Each run is the second with its cache: the first was of the environment with two triangles more.
  Outcome runAfterEdits(int moments) {
    const auto count = static_cast<std::uint32_t>(environment_->triangles.size());
    const auto edited = editEnvironment(environment_, {count / 3, count / 2}, {});
    return cancelAt(moments, [&] {
      const auto cache = std::make_shared<ResultCache>();
      RunContext first;
      runPipeline(environment_, pipeline_, first, cache.get(), 2);
      return [this, edited, cache](RunContext& context) { runPipeline(edited, pipeline_, context, cache.get(), 2); };
    });
  }

 private:
  /// `prepare()` returns the run that is cancelled.
  template <class Prepare>
  Outcome cancelAt(int moments, const Prepare& prepare) {
    const std::string expected = exported(whole());
    const auto uninterrupted = prepare();
    const detail::Stopwatch watch;
    RunContext untouched;
    uninterrupted(untouched);
    const double wholeMs = watch.wallMs();
    Outcome outcome;
    // On a busy machine the thread that cancels may be late each time.
    for (int i = 0; i < moments || (outcome.cancelled == 0 && i < 5 * moments); ++i) {
      const auto work = prepare();
      RunContext context;
      Canceller canceller(context, wholeMs * (i % moments + 0.5) / moments);
      try {
        work(context);
        ++outcome.ended;
      } catch (const Cancelled&) {
        if (!context.cancelled()) throw std::runtime_error("Cancelled came from a run that was not cancelled");
        ++outcome.cancelled;
      }
      if (const auto cpuMs = canceller.end()) outcome.mostCpuMs = std::max(outcome.mostCpuMs, *cpuMs);
    }
    if (exported(whole()) != expected) throw std::runtime_error("a run after cancelled runs gives other bytes");
    return outcome;
  }

  [[nodiscard]] RunResult whole() const {
    RunContext context;
    return runPipeline(environment_, pipeline_, context, nullptr, 2);
  }

  std::shared_ptr<const Environment> environment_;
  Pipeline pipeline_;
};

}  // namespace

class TestCancelledMoments : public QObject {
  Q_OBJECT

 private slots:
  void everyMomentEndsTheRun_data();
  void everyMomentEndsTheRun();
};

void TestCancelledMoments::everyMomentEndsTheRun_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<double>("clearance");
  QTest::addColumn<QString>("kind");
  const auto add = [](const std::string& file, double clearance) {
    const std::string name = file.substr(file.rfind('/') + 1);
    for (const char* kind : {"plain", "short", "steps", "radius", "drops", "block"})
      QTest::addRow("%s, %s", name.c_str(), kind) << QString::fromStdString(file) << clearance << QString(kind);
  };
  for (const std::string name : {"house", "docks"})
    add(FOOTFALL_SOURCE_DIR "/samples/" + name + '/' + name + ".obj", 2);
  std::istringstream files(qEnvironmentVariable("FOOTFALL_CANCEL_FILES").toStdString());
  for (std::string file; files >> file;) {
    const std::size_t colon = file.rfind(':');
    add(file.substr(0, colon), std::stod(file.substr(colon + 1)));
  }
}

// A group that ended because another part of it was cancelled crashed in settleProduct(), which read empty arrays.
void TestCancelledMoments::everyMomentEndsTheRun() {
  QFETCH(QString, file);
  QFETCH(double, clearance);
  QFETCH(QString, kind);
  const int moments = rounds(12);
  Trial trial(importEnvironment(file.toStdString()), pipelineOf(kind.toStdString(), clearance));
  const Outcome whole = trial.runFromNothing(moments), edits = trial.runAfterEdits(moments);
  std::printf("| %s | %d | %d | %.0f | %d | %.0f |\n", QTest::currentDataTag(), moments, whole.cancelled,
              whole.mostCpuMs, edits.cancelled, edits.mostCpuMs);
  std::fflush(stdout);
  QVERIFY(whole.cancelled > 0);
  QVERIFY2(whole.mostCpuMs < 5000 && edits.mostCpuMs < 5000, "a cancelled run goes on for seconds");
}

QTEST_APPLESS_MAIN(TestCancelledMoments)
#include "test_cancelled_moments.moc"
