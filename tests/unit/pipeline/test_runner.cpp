// Running pipelines: statistics, events, the cache, cancelling, and what is refused before anything runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "core/pipeline/runner.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/pipeline.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

using EnvironmentPtr = std::shared_ptr<const Environment>;

void addRectangle(Environment& environment, double x0, double y0, double x1, double y1, double z) {
  const auto first = static_cast<std::uint32_t>(environment.vertices.size());
  environment.vertices.insert(environment.vertices.end(), {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}});
  environment.triangles.push_back({first, first + 1, first + 2});
  environment.triangles.push_back({first, first + 2, first + 3});
}

// A floor of 10 by 10 with a board of 2 by 2 one above it.
EnvironmentPtr floorWithBoard() {
  Environment environment;
  environment.source = "floor with board";
  addRectangle(environment, 0, 0, 10, 10, 0);
  addRectangle(environment, 4, 4, 6, 6, 1);
  return std::make_shared<const Environment>(std::move(environment));
}

Pipeline pipelineOf(const std::string& text) { return parsePipeline(text, "test"); }

const std::string kFourSteps = "DegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 1\n";

std::vector<bool> fromCache(const RunResult& result) {
  std::vector<bool> flags;
  for (const StepStatistics& step : result.steps) flags.push_back(step.fromCache);
  return flags;
}

bool sameMesh(const NavigationMesh& a, const NavigationMesh& b) {
  return a.vertices == b.vertices && a.triangles == b.triangles && a.layers == b.layers &&
         a.layerCount == b.layerCount && a.sourceTriangles == b.sourceTriangles && a.obstacleEdges == b.obstacleEdges &&
         a.connections == b.connections;
}

// Collects events; worker threads may call it.
struct Recorder {
  RunContext::Listener listener() {
    return [this](const RunEvent& event) {
      const std::lock_guard lock(mutex);
      events.push_back(event);
    };
  }
  // "+0 -0 +1 -1" for steps that start and finish.
  std::string steps() {
    std::string text;
    for (const RunEvent& event : events) {
      if (event.kind == RunEvent::Kind::StepStarted) text += '+' + std::to_string(event.step) + ' ';
      if (event.kind == RunEvent::Kind::StepFinished) text += '-' + std::to_string(event.step) + ' ';
    }
    return text;
  }
  std::mutex mutex;
  std::vector<RunEvent> events;
};

template <typename Error>
std::string messageOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace

class TestRunner : public QObject {
  Q_OBJECT
 private slots:
  void statisticsOfEachStep();
  void disabledStepsDoNotRun();
  void noStepsAtAll();
  void eventsInOrder();
  void wholeResultsOnlyForThoseWhoWantThem();
  void secondRunIsCached();
  void onlyTheLastStepRunsAgain();
  void anEarlyChangeRunsAllBehindIt();
  void shorterPipelineIsCached();
  void equalEnvironmentsAreDifferentKeys();
  void negativeZeroIsZero();
  void leastRecentlyUsedGoesFirst();
  void memoryBoundsTheCache();
  void clearedCache();
  void cacheSharedByThreads();
  void cachedPrefixSurvivesCancelling();
  void cancelledBeforeItStarts();
  void switchedOffBlocksDoNotRun();
  void invalidStepsAreRefused_data();
  void invalidStepsAreRefused();
  void failuresNameTheStep();
  void sameResultWithAnyNumberOfThreads();
};

void TestRunner::statisticsOfEachStep() {
  RunContext context;
  const RunResult result = runPipeline(floorWithBoard(), pipelineOf(kFourSteps), context, nullptr, 2);
  QCOMPARE(result.steps.size(), std::size_t{4});
  QCOMPARE(result.steps[1].name, std::string("SlopeFilter"));
  QCOMPARE(result.steps[1].parameters, (std::vector<double>{45, 0.01}));
  QCOMPARE(result.steps[0].in.triangles, std::uint64_t{4});
  for (std::size_t i = 0; i < result.steps.size(); ++i) {
    QVERIFY(result.steps[i].wallMs >= 0 && result.steps[i].cpuMs >= 0);
    QVERIFY(!result.steps[i].fromCache);
    if (i > 0) QCOMPARE(result.steps[i].in.triangles, result.steps[i - 1].out.triangles);
    if (i > 0) QCOMPARE(result.steps[i].in.area, result.steps[i - 1].out.area);
  }
  QCOMPARE(result.steps[1].out.area, 104.0);
  QCOMPARE(result.steps[2].out.area, 100.0);  // the floor loses what the board covers
  QCOMPARE(result.summary.area, result.steps.back().out.area);
  QCOMPARE(result.threads, 2);
  QVERIFY(result.mesh != nullptr && !result.mesh->triangles.empty());
  QVERIFY(result.totalMs >= result.finishMs);
}

void TestRunner::disabledStepsDoNotRun() {
  Recorder recorder;
  RunContext context(recorder.listener());
  const RunResult result = runPipeline(floorWithBoard(), pipelineOf("#off AreaFilter 1000\nSlopeFilter 45\n"), context);
  QCOMPARE(result.steps.size(), std::size_t{1});
  QCOMPARE(result.steps[0].name, std::string("SlopeFilter"));
  QCOMPARE(result.summary.area, 104.0);
  QCOMPARE(recorder.steps(), std::string("+0 -0 "));
}

void TestRunner::noStepsAtAll() {
  RunContext context;
  ResultCache cache;
  const EnvironmentPtr environment = floorWithBoard();
  const RunResult result = runPipeline(environment, Pipeline{}, context, &cache);
  QVERIFY(result.steps.empty());
  QCOMPARE(result.summary.area, 104.0);
  QCOMPARE(runPipeline(environment, Pipeline{}, context, &cache).mesh, result.mesh);
}

void TestRunner::eventsInOrder() {
  Recorder recorder;
  RunContext context(recorder.listener());
  ResultCache cache;
  const EnvironmentPtr environment = floorWithBoard();
  runPipeline(environment, pipelineOf(kFourSteps), context, &cache);
  QCOMPARE(recorder.steps(), std::string("+0 -0 +1 -1 +2 -2 +3 -3 "));
  const auto started = std::ranges::find(recorder.events, RunEvent::Kind::StepStarted, &RunEvent::kind);
  QCOMPARE(started->text, std::string("DegeneracyFilter"));
  for (const RunEvent& event : recorder.events) QVERIFY(event.fraction >= 0 && event.fraction <= 1);
  recorder.events.clear();
  runPipeline(environment, pipelineOf(kFourSteps + "DegeneracyFilter"), context, &cache);
  QCOMPARE(recorder.steps(), std::string("+0 -0 +1 -1 +2 -2 +3 -3 +4 -4 "));
}

void TestRunner::wholeResultsOnlyForThoseWhoWantThem() {
  for (const bool wanted : {false, true}) {
    Recorder recorder;
    RunContext context(recorder.listener(), wanted);
    runPipeline(floorWithBoard(), pipelineOf(kFourSteps), context);
    for (const RunEvent& event : recorder.events) {
      if (event.kind == RunEvent::Kind::StepFinished) QCOMPARE(event.part != nullptr, wanted);
    }
  }
}

void TestRunner::secondRunIsCached() {
  RunContext context;
  ResultCache cache;
  const EnvironmentPtr environment = floorWithBoard();
  const RunResult first = runPipeline(environment, pipelineOf(kFourSteps), context, &cache);
  QCOMPARE(fromCache(first), (std::vector<bool>{false, false, false, false}));
  const RunResult second = runPipeline(environment, pipelineOf(kFourSteps), context, &cache);
  QCOMPARE(fromCache(second), (std::vector<bool>{true, true, true, true}));
  QCOMPARE(second.mesh, first.mesh);
  QCOMPARE(second.summary.area, first.summary.area);
  QCOMPARE(second.steps[2].out.area, first.steps[2].out.area);
}

void TestRunner::onlyTheLastStepRunsAgain() {
  RunContext context;
  ResultCache cache;
  const EnvironmentPtr environment = floorWithBoard();
  const std::string beginning = "DegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\n";
  runPipeline(environment, pipelineOf(beginning + "AreaFilter 1"), context, &cache);
  const RunResult changed = runPipeline(environment, pipelineOf(beginning + "AreaFilter 50"), context, &cache);
  QCOMPARE(fromCache(changed), (std::vector<bool>{true, true, true, false}));
  QCOMPARE(changed.summary.area, 96.0);  // area without the board itself
  const RunResult back = runPipeline(environment, pipelineOf(beginning + "AreaFilter 1"), context, &cache);
  QCOMPARE(fromCache(back), (std::vector<bool>{true, true, true, true}));
  QCOMPARE(back.summary.area, 100.0);
}

void TestRunner::anEarlyChangeRunsAllBehindIt() {
  RunContext context;
  ResultCache cache;
  const EnvironmentPtr environment = floorWithBoard();
  runPipeline(environment, pipelineOf(kFourSteps), context, &cache);
  Pipeline changed = pipelineOf(kFourSteps);
  changed.steps[1].values[0] = 30;
  QCOMPARE(fromCache(runPipeline(environment, changed, context, &cache)),
           (std::vector<bool>{true, false, false, false}));
}

void TestRunner::shorterPipelineIsCached() {
  RunContext context;
  ResultCache cache;
  const EnvironmentPtr environment = floorWithBoard();
  runPipeline(environment, pipelineOf(kFourSteps), context, &cache);
  Pipeline shorter = pipelineOf(kFourSteps);
  shorter.steps[3].enabled = false;
  const RunResult result = runPipeline(environment, shorter, context, &cache);
  QCOMPARE(fromCache(result), (std::vector<bool>{true, true, true}));
  QCOMPARE(result.summary.area, 100.0);
  QVERIFY(result.mesh != nullptr);
}

void TestRunner::equalEnvironmentsAreDifferentKeys() {
  RunContext context;
  ResultCache cache;
  const Pipeline pipeline = pipelineOf("SlopeFilter 45");
  for (int i = 0; i < 4; ++i) {
    // Each is freed before the next is made, which may then get the same address.
    QCOMPARE(fromCache(runPipeline(floorWithBoard(), pipeline, context, &cache)), std::vector<bool>{false});
  }
}

void TestRunner::negativeZeroIsZero() {
  RunContext context;
  ResultCache cache;
  const EnvironmentPtr environment = floorWithBoard();
  Pipeline pipeline = pipelineOf("AreaFilter 0");
  runPipeline(environment, pipeline, context, &cache);
  pipeline.steps[0].values[0] = -0.0;
  QCOMPARE(fromCache(runPipeline(environment, pipeline, context, &cache)), std::vector<bool>{true});
}

void TestRunner::leastRecentlyUsedGoesFirst() {
  RunContext context;
  ResultCache cache(2);
  const EnvironmentPtr environment = floorWithBoard();
  const Pipeline one = pipelineOf("SlopeFilter 10"), two = pipelineOf("SlopeFilter 20"),
                 three = pipelineOf("SlopeFilter 30");
  const auto cached = [&](const Pipeline& pipeline) {
    return runPipeline(environment, pipeline, context, &cache).steps[0].fromCache;
  };
  QVERIFY(!cached(one));  // keeps the start and one
  QVERIFY(!cached(two));  // keeps the start (just used) and two
  QVERIFY(!cached(three));
  QVERIFY(cached(three));
  QVERIFY(!cached(one));
  QVERIFY(!cached(two));
}

void TestRunner::memoryBoundsTheCache() {
  RunContext context;
  ResultCache ample(32, std::size_t{1} << 30), scarce(32, 1);
  const EnvironmentPtr environment = floorWithBoard();
  const auto lastIsCached = [&](int slope, ResultCache& cache) {
    const Pipeline pipeline = pipelineOf("SlopeFilter " + std::to_string(slope) +
                                         "\nVerticalClearanceFilter 1\nAreaFilter 0\nLayerSubdivisionFilter");
    return runPipeline(environment, pipeline, context, &cache).steps.back().fromCache;
  };
  for (ResultCache* cache : {&ample, &scarce}) {
    for (const int slope : {10, 20, 30, 40}) QVERIFY(!lastIsCached(slope, *cache));
    QVERIFY(lastIsCached(40, *cache));  // a whole run is kept, whatever it takes
  }
  QVERIFY(lastIsCached(10, ample));
  QVERIFY(!lastIsCached(10, scarce));
}

void TestRunner::clearedCache() {
  RunContext context;
  ResultCache cache;
  const EnvironmentPtr environment = floorWithBoard();
  const Pipeline pipeline = pipelineOf("SlopeFilter 45");
  runPipeline(environment, pipeline, context, &cache);
  cache.clear();
  QCOMPARE(fromCache(runPipeline(environment, pipeline, context, &cache)), std::vector<bool>{false});
}

void TestRunner::cacheSharedByThreads() {
  ResultCache cache(4);
  const EnvironmentPtr environment = floorWithBoard();
  RunContext single;
  const RunResult expected = runPipeline(environment, pipelineOf(kFourSteps), single);
  std::vector<int> good(4, 0);
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < good.size(); ++t) {
      threads.emplace_back([&, t] {
        for (int i = 0; i < 10; ++i) {
          RunContext context;
          const RunResult result = runPipeline(environment, pipelineOf(kFourSteps), context, &cache, 2);
          good[t] += sameMesh(*result.mesh, *expected.mesh);
          if (i % 3 == 0) cache.clear();
        }
      });
    }
  }
  QCOMPARE(good, std::vector<int>(4, 10));
}

void TestRunner::cachedPrefixSurvivesCancelling() {
  ResultCache cache;
  const EnvironmentPtr environment = floorWithBoard();
  RunContext* running = nullptr;
  RunContext cancelling([&](const RunEvent& event) {
    if (event.kind == RunEvent::Kind::StepFinished && event.step == 1) running->cancel();
  });
  running = &cancelling;
  QVERIFY_THROWS_EXCEPTION(Cancelled, runPipeline(environment, pipelineOf(kFourSteps), cancelling, &cache));
  RunContext context;
  QCOMPARE(fromCache(runPipeline(environment, pipelineOf(kFourSteps), context, &cache)),
           (std::vector<bool>{true, true, false, false}));
}

void TestRunner::cancelledBeforeItStarts() {
  Recorder recorder;
  RunContext context(recorder.listener());
  context.cancel();
  QVERIFY_THROWS_EXCEPTION(Cancelled, runPipeline(floorWithBoard(), pipelineOf(kFourSteps), context));
  QVERIFY(recorder.events.empty());
}

void TestRunner::switchedOffBlocksDoNotRun() {
  Recorder recorder;
  RunContext context(recorder.listener());
  Pipeline pipeline = pipelineOf("SlopeFilter 45\n\nSmartRecursiveStrategy 50 3 true\nCollapse\n");
  QCOMPARE(runPipeline(floorWithBoard(), pipeline, context).steps.size(), std::size_t{3});
  pipeline.steps[1].enabled = pipeline.steps[2].enabled = false;
  const RunResult result = runPipeline(floorWithBoard(), pipeline, context);
  QCOMPARE(result.steps.size(), std::size_t{1});
  QVERIFY(result.blocks.empty());
}

void TestRunner::invalidStepsAreRefused_data() {
  QTest::addColumn<QString>("filter");
  QTest::addColumn<QList<double>>("values");
  QTest::addColumn<QString>("says");
  QTest::newRow("out of range") << "SlopeFilter" << QList<double>{95, 0}
                                << "step 1 (Slope), SlopeFilter: max_slope 95 is out";
  QTest::newRow("too few") << "SlopeFilter" << QList<double>{}
                           << "step 1 (Slope), SlopeFilter: values given: 0; give 2";
  QTest::newRow("too many") << "DegeneracyFilter" << QList<double>{1}
                            << "step 1 (Degeneracy), DegeneracyFilter: values given: 1; give 0";
  QTest::newRow("tiny clearance")
      << "VerticalClearanceFilter" << QList<double>{1e-300}
      << "step 1 (Vertical clearance), VerticalClearanceFilter: a clearance of 1e-300 is too small beside "
         "coordinates of up to ";
  QTest::newRow("structure") << "Collapse" << QList<double>{} << "step 1 (Collapse): Collapse ends no parallel block";
}

void TestRunner::invalidStepsAreRefused() {
  QFETCH(QString, filter);
  QFETCH(QList<double>, values);
  QFETCH(QString, says);
  Pipeline pipeline;
  pipeline.steps.push_back({findFilter(filter.toStdString()), {values.begin(), values.end()}, true, 0});
  RunContext context;
  const std::string message = messageOf<InputError>([&] { runPipeline(floorWithBoard(), pipeline, context); });
  QVERIFY2(message.starts_with(says.toStdString()), message.c_str());
  pipeline.steps[0].enabled = false;  // a step that is switched off may be anything
  QVERIFY(runPipeline(floorWithBoard(), pipeline, context).steps.empty());
}

void TestRunner::failuresNameTheStep() {
  RunContext poor([](const RunEvent& event) {
    if (event.kind == RunEvent::Kind::StepStarted && event.step == 2) throw std::bad_alloc();
  });
  std::string message = messageOf<RunError>([&] { runPipeline(floorWithBoard(), pipelineOf(kFourSteps), poor); });
  QVERIFY2(message.starts_with("line 3, VerticalClearanceFilter: memory ran out; "), message.c_str());
  RunContext broken([](const RunEvent& event) {
    if (event.kind == RunEvent::Kind::StepStarted) throw std::runtime_error("broken");
  });
  message = messageOf<RunError>([&] { runPipeline(floorWithBoard(), pipelineOf(kFourSteps), broken); });
  QVERIFY2(message.starts_with("line 1, DegeneracyFilter: internal error (broken); "), message.c_str());
}

void TestRunner::sameResultWithAnyNumberOfThreads() {
  RunContext context;
  const RunResult one = runPipeline(floorWithBoard(), pipelineOf(kFourSteps), context, nullptr, 1);
  for (const int threads : {2, 3, 8}) {
    const RunResult many = runPipeline(floorWithBoard(), pipelineOf(kFourSteps), context, nullptr, threads);
    QCOMPARE(many.threads, threads);
    QVERIFY(sameMesh(*one.mesh, *many.mesh));
  }
  QVERIFY(runPipeline(floorWithBoard(), pipelineOf(kFourSteps), context).threads >= 1);
}

QTEST_APPLESS_MAIN(TestRunner)
#include "test_runner.moc"
