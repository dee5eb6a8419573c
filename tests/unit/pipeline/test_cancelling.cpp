// Cancelling large runs: what they leave goes elsewhere, and all of it goes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>

#include "core/base/background_release.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/pipeline.hpp"
#include "tests/support/cancelled_run.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

using namespace std::chrono_literals;

/// Tells which thread took it down.
class Witness {
 public:
  using Told = std::shared_ptr<std::promise<std::thread::id>>;  // Stays alive until it has reported, however long
                                                                // others wait for it.

  explicit Witness(Told gone) : gone_(std::move(gone)) {}
  ~Witness() { gone_->set_value(std::this_thread::get_id()); }
  Witness(const Witness&) = delete;
  Witness& operator=(const Witness&) = delete;

 private:
  Told gone_;
};

// The thread that frees something after an exception passed, or after an uninterrupted end.
std::thread::id whereFreed(bool isLarge, bool throws) {
  const auto gone = std::make_shared<std::promise<std::thread::id>>();
  auto result = gone->get_future();
  try {
    ReleaseOnException large(isLarge);
    const auto thing = std::make_shared<Witness>(gone);
    large.hold(thing);
    if (throws) throw std::runtime_error("interrupted");
  } catch (const std::runtime_error&) {
  }
  return result.wait_for(10s) == std::future_status::ready ? result.get() : std::thread::id();
}

// Squares of 1 m, enough of them for a large environment, with a board above each tenth.
std::shared_ptr<const Environment> makeLargeEnvironment() {
  constexpr std::uint32_t kSide = 175;
  auto environment = std::make_shared<Environment>();
  environment->source = "many squares";
  const auto addSquare = [&](double x, double y, double z, double size) {
    const auto first = static_cast<std::uint32_t>(environment->vertices.size());
    for (const auto& [dx, dy] : {std::pair{0., 0.}, {size, 0.}, {size, size}, {0., size}})
      environment->vertices.push_back({x + dx, y + dy, z});
    environment->triangles.push_back({first, first + 1, first + 2});
    environment->triangles.push_back({first, first + 2, first + 3});
  };
  for (std::uint32_t row = 0; row < kSide; ++row) {
    for (std::uint32_t column = 0; column < kSide; ++column) {
      addSquare(column, row, 0, 1);
      if ((row * kSide + column) % 10 == 0) addSquare(column + 0.25, row + 0.5, 1, 1);
    }
  }
  return environment;
}

class TestCancelling : public QObject {
  Q_OBJECT

 private slots:
  void exceptionsLeaveLargeThingsToOthers();
  void whatIsStillInUseStays();
  void eachStepOfALargeRun_data();
  void eachStepOfALargeRun();
  void bordersAsLongAsTheLevel();
};

void TestCancelling::exceptionsLeaveLargeThingsToOthers() {
  const auto here = std::this_thread::get_id();
  QCOMPARE(whereFreed(true, false), here);
  QCOMPARE(whereFreed(false, true), here);
  const auto elsewhere = whereFreed(true, true);
  QVERIFY(elsewhere != here);
  QVERIFY(elsewhere != std::thread::id());
}

void TestCancelling::whatIsStillInUseStays() {
  const auto gone = std::make_shared<std::promise<std::thread::id>>();
  auto result = gone->get_future();
  auto thing = std::make_shared<Witness>(gone);
  try {
    ReleaseOnException large(true);
    large.hold(thing);
    throw std::runtime_error("interrupted");
  } catch (const std::runtime_error&) {
  }
  QCOMPARE(thing.use_count(), 1L);
  thing = nullptr;
  QCOMPARE(result.get(), std::this_thread::get_id());
}

void TestCancelling::eachStepOfALargeRun_data() {
  QTest::addColumn<int>("step");
  for (int step = 0; step < 8; ++step) QTest::addRow("step %d", step + 1) << step;
}

// The caller gets Cancelled both when a step starts and in its middle, and the environment, which all results of a run
// refer to, is soon free again.
void TestCancelling::eachStepOfALargeRun() {
  QFETCH(int, step);
  auto environment = makeLargeEnvironment();
  QVERIFY(environment->triangles.size() >= kLargeRelease);
  const Pipeline pipeline = defaultPipeline(*environment);
  QCOMPARE(pipeline.steps.size(), std::size_t{8});
  for (const RunEvent::Kind kind : {RunEvent::Kind::StepStarted, RunEvent::Kind::Progress}) {
    RunContext* running = nullptr;
    std::atomic<bool> told{false};
    RunContext context([&](const RunEvent& event) {
      if (event.kind != kind || event.step != static_cast<std::size_t>(step)) return;
      told = true;
      running->cancel();
    });
    running = &context;
    bool cancelled = false;
    try {
      runPipeline(environment, pipeline, context, nullptr, 2);
    } catch (const Cancelled&) {
      cancelled = true;
    }
    QCOMPARE(cancelled, told.load());
    QVERIFY(told || kind == RunEvent::Kind::Progress);  // Quick steps report nothing in between.
    QTRY_COMPARE_WITH_TIMEOUT(environment.use_count(), 1L, 10000);
  }
}

// The vertices of links stay between two linked borders, and those of the far borders go: one group of triangles, and
// so one task, as long as the level.
void TestCancelling::bordersAsLongAsTheLevel() {
  constexpr int kTreads = 16000;
  auto environment = std::make_shared<Environment>();
  const auto addFloor = [&](double x, double y, double z) {
    const auto first = static_cast<std::uint32_t>(environment->vertices.size());
    for (const auto& [dx, dy] : {std::pair{0., 0.}, {0.5, 0.}, {0.5, 2.}, {0., 2.}})
      environment->vertices.push_back({x + dx, y + dy, z});
    environment->triangles.push_back({first, first + 1, first + 2});
    environment->triangles.push_back({first, first + 2, first + 3});
  };
  for (int i = 0; i < kTreads; ++i) {
    addFloor(0.5 * i, 0, 0);
    addFloor(0.5 * i + 0.25, -2, 0.25);
  }
  const Pipeline pipeline =
      parsePipeline("SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4\nSimplificationFilter\n", "test");
  const double all = test::stepCpuMs(environment, pipeline, 3);
  for (const double share : {0.1, 0.4}) {
    const auto known = test::cpuMsAfterCancelling(environment, pipeline, 3, share * all);
    QVERIFY2(known, "the run was over each time before it was cancelled");
    QVERIFY2(*known < 50, qPrintable(QString("%1 ms at %2").arg(*known).arg(share)));
  }
}

}  // namespace

QTEST_GUILESS_MAIN(TestCancelling)
#include "test_cancelling.moc"
