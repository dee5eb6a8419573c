// Parallel blocks: whatever the strategy, its parameters and the number of threads, the bytes are those of the same
// filters without a block.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QFile>
#include <QtTest>
#include <atomic>
#include <mutex>
#include <numeric>
#include <set>

#include "core/io/export.hpp"
#include "core/io/import.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using EnvironmentPtr = std::shared_ptr<const Environment>;

RunResult run(const EnvironmentPtr& environment, const std::string& pipeline, int threads,
              ResultCache* cache = nullptr) {
  RunContext context;
  return runPipeline(environment, parsePipeline(pipeline, "test"), context, cache, threads);
}

std::string bytes(const RunResult& result) { return formatObj(*result.mesh, {}); }

/// The pipeline without its strategies and Collapse.
std::string withoutBlocks(const std::string& pipeline) {
  Pipeline filters = parsePipeline(pipeline, "test");
  std::erase_if(filters.steps, [](const PipelineStep& step) { return step.filter->kind != FilterKind::Filter; });
  return formatPipeline(filters);
}

/// The difference between a run with blocks and the same without; empty when there is none.
std::string difference(const EnvironmentPtr& environment, const std::string& pipeline, int threads) {
  const RunResult sequential = run(environment, withoutBlocks(pipeline), 1);
  const RunResult parallel = run(environment, pipeline, threads);
  if (bytes(parallel) != bytes(sequential)) return "the export";
  std::vector<StepStatistics> steps = parallel.steps;
  std::erase_if(steps, [](const StepStatistics& s) { return findFilter(s.name)->kind != FilterKind::Filter; });
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const StepStatistics &a = steps[i], &b = sequential.steps[i];
    if (a.name != b.name || a.out.triangles != b.out.triangles || a.out.area != b.out.area ||
        a.out.rejected != b.out.rejected || a.out.layers != b.out.layers ||
        a.out.obstacleEdges != b.out.obstacleEdges || a.out.links != b.out.links || a.note != b.note)
      return "what step " + std::to_string(i) + ", " + a.name + ", says";
  }
  return {};
}

const std::vector<std::string> kStrategies{"GridStrategy 1 1",
                                           "GridStrategy 2 1",
                                           "GridStrategy 3 4",
                                           "GridStrategy 13 7",
                                           "RecursiveStrategy 1 2 true",
                                           "RecursiveStrategy 3 4 false",
                                           "SortedRecursiveStrategy 1 3 true",
                                           "SortedRecursiveStrategy 2 6 false",
                                           "HeightAwareStrategy 1 2",
                                           "HeightAwareStrategy 1 6 false",
                                           "AutoStrategy"};

/// Pipelines with S for the strategy.
const std::vector<std::string> kPipelines{
    "S\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n",
    "DegeneracyFilter\nSlopeFilter 50\nS\nVerticalClearanceFilter 1.5\nCollapse\nAreaFilter 0.5\n"
    "SimplificationFilter\nLayerSubdivisionFilter\n",
    "S\nDegeneracyFilter\nSlopeFilter 60\nSlopeFilter 45\nVerticalClearanceFilter 1\nVerticalClearanceFilter 2\n"
    "Collapse\n",
    "VerticalClearanceFilter 1\nS\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\nSimplificationFilter\n",
    "VerticalClearanceFilter 1\nAreaFilter 0.7\nS\nVerticalClearanceFilter 2\nSlopeFilter 40\nCollapse\n",
    "SlopeFilter 45\nS\nVerticalClearanceFilter 2\nRoundingFilter\nCollapse\nDuplicationFilter 0.01\n"
    "SimplificationFilter true 0.000001\nPEELFilter\n",
    "S\nVerticalClearanceFilter 1\nRoundingFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n",
    "S\nSlopeFilter 45\nCollapse\nS\nVerticalClearanceFilter 2\nCollapse\nLayerSubdivisionFilter\n",
    "S\nSlopeFilter 45\nVerticalClearanceFilter 1\nStepFilter 0.4 0.3\nVerticalClearanceFilter 2\nSlopeFilter 40\n"
    "Collapse\nAreaFilter 0.5\nSimplificationFilter\nLayerSubdivisionFilter\n",
    "SlopeFilter 45\nS\nVerticalClearanceFilter 2\nStepFilter 1 0\nRoundingFilter\nStepFilter 0.4 0.3\nCollapse\n"
    "AreaFilter 0.1\n",
    "S\nDegeneracyFilter\nSlopeFilter 30\nCollapse\n",
    "S\nCollapse\nVerticalClearanceFilter 2\n"};

std::string replaced(std::string text, const std::string& strategy) {
  for (std::size_t at = text.find("S\n"); at != text.npos; at = text.find("S\n", at + strategy.size()))
    if (at == 0 || text[at - 1] == '\n') text.replace(at, 1, strategy);
  return text;
}

rc::Gen<Soup> anySoup() {
  return rc::gen::oneOf(rc::gen::map(gridTriangles(20, 3, 3), [](const auto& numbers) { return soupOf(numbers); }),
                        rc::gen::map(gridTriangles(20, 6, 2), [](const auto& numbers) { return soupOf(numbers); }),
                        rc::gen::map(gridTriangles(24, 1000, 20), [](const auto& numbers) { return soupOf(numbers); }),
                        rc::gen::map(buildingParts(12), [](const auto& numbers) { return buildingOf(numbers); }),
                        rc::gen::map(upTo(20, below(64)), [](const auto& steps) { return walkOf(steps); }));
}

/// Moved far away, made tiny or huge, or sheared so that edges are parallel to no axis.
Soup placed(const Soup& soup, int kind) {
  switch (kind) {
    case 0:
      return soup.mapped([](const Vec3& v) { return Vec3{v.x + 122000.123, v.y - 487000.456, v.z + 0.1}; });
    case 1:
      return soup.mapped([](const Vec3& v) { return Vec3{v.x * 1e-3 + v.y * 1e-4, v.y * 1e-3, v.z}; });
    case 2:
      return soup.mapped([](const Vec3& v) { return Vec3{v.x * 1e150, v.y * 1e150, v.z}; });
    case 3:
      return soup.mapped([](const Vec3& v) { return Vec3{v.x - v.y / 3, v.y + v.x / 7, v.z}; });
    case 4:
      return soup.mapped([](const Vec3& v) { return Vec3{v.x * 1e-160, v.y * 1e-160, v.z}; });
    default:
      return soup;
  }
}

QString sharedFile(const char* name) {
  return qEnvironmentVariable("FOOTFALL_SHARED") + "/envs/" + QString::fromLatin1(name) + ".obj";
}

}  // namespace

class TestParallelBlocks : public QObject {
  Q_OBJECT
 private slots:
  void randomSoups() {
    QVERIFY(check("blocks give the sequential bytes", 1500, [] {
      const Soup soup = placed(*rc::gen::noShrink(anySoup()), *below(12));
      const std::string strategy = kStrategies[static_cast<std::size_t>(*below(static_cast<int>(kStrategies.size())))];
      const std::string pipeline =
          replaced(kPipelines[static_cast<std::size_t>(*below(static_cast<int>(kPipelines.size())))], strategy);
      const int threads = 1 + *below(4);
      RC_LOG() << pipeline << threads << " threads\n" << toText(*soup.environment());
      const std::string differs = difference(soup.environment(*below(4) == 0), pipeline, threads);
      if (!differs.empty()) RC_FAIL("not the same: " + differs);
    }));
  }

  // Many small triangles under many obstacles, so that borders cross everything and threads meet.
  void denseSoups() {
    QVERIFY(check("dense blocks give the sequential bytes", 40, [] {
      Soup soup;
      soup.floor(0, 0, 20, 20, 0).floor(0, 0, 20, 20, 3);
      for (const auto& n : *rc::gen::container<std::vector<PartNumbers>>(150, numbersBelow<7>(1 << 16))) {
        const double x = n[0] % 1900 / 100.0, y = n[1] % 1900 / 100.0, z = n[2] % 400 / 100.0;
        const double a = n[3] % 300 / 100.0, b = n[4] % 300 / 100.0;
        soup.quad({x, y, z}, {x + a, y + b / 3, z}, {x + a, y + b, z + n[5] % 100 / 100.0}, {x, y + b, z + 0.5});
      }
      const std::string strategy = kStrategies[static_cast<std::size_t>(*below(static_cast<int>(kStrategies.size())))];
      RC_LOG() << strategy << "\n" << toText(*soup.environment());
      const std::string differs = difference(soup.environment(), replaced(kPipelines[1], strategy), 1 + *below(4));
      if (!differs.empty()) RC_FAIL("not the same: " + differs);
    }));
  }

  // A border along edges, through vertices and through crossings of edges.
  void bordersOnVertices() {
    Soup soup;
    soup.floor(0, 0, 4, 4, 0);
    for (int i = 0; i < 4; ++i) {
      soup.wall(i, 0, i, 4, 0, 1).wall(0, i, 4, i, 0, 1);
      soup.box({double(i), double(i), 0.5}, {i + 1.0, i + 1.0, 1});
      soup.triangle({double(i), 0, 1}, {i + 2.0, 2, 1}, {double(i), 4, 1.5});
    }
    for (const char* strategy : {"GridStrategy 2 2", "GridStrategy 4 4", "GridStrategy 8 8", "GridStrategy 4 1",
                                 "SortedRecursiveStrategy 1 8 false", "RecursiveStrategy 1 4 false"})
      for (const std::string& pipeline : kPipelines)
        QCOMPARE(difference(soup.environment(), replaced(pipeline, strategy), 2), std::string());
  }

  void realEnvironments_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<double>("clearance");
    for (const char* name : {"house", "tower", "villa", "arena", "docks"}) {
      const QString sample = QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj").arg(name);
      QTest::newRow(name) << sample << 2.0;
    }
    for (const char* name : {"nav_test", "level", "ot", "turbine", "dutility", "complex"})
      QTest::newRow(name) << sharedFile(name) << 2.0;
    for (const char* name : {"steelribs", "fortitude"}) QTest::newRow(name) << sharedFile(name) << 40.0;
  }

  void realEnvironments() {
    QFETCH(QString, file);
    QFETCH(double, clearance);
    if (!QFile::exists(file)) QSKIP("this environment is not here; set FOOTFALL_SHARED to the folder that holds envs/");
    const EnvironmentPtr environment = importEnvironment(file.toStdString(), {});
    const std::string filters = "SlopeFilter 45\nVerticalClearanceFilter " + std::to_string(clearance) + "\n";
    const std::string behind = "AreaFilter " + std::to_string(clearance) + "\nSimplificationFilter\nPEELFilter\n";
    const std::string expected = bytes(run(environment, filters + behind, 1));
    for (const char* strategy :
         {"GridStrategy 3 3", "GridStrategy 20 15", "RecursiveStrategy 50 3 true", "RecursiveStrategy 50 5 false",
          "SortedRecursiveStrategy 50 3 true", "SortedRecursiveStrategy 50 6 false", "HeightAwareStrategy 50 3 true",
          "HeightAwareStrategy 20 7 false", "AutoStrategy"}) {
      for (const int threads : {1, 3}) {
        const std::string pipeline = std::string(strategy) + "\n" + filters + "Collapse\n" + behind;
        QVERIFY2(bytes(run(environment, pipeline, threads)) == expected, strategy);
      }
    }
  }

  // The parallel listing of 5.4 as it stands, against its filters without the block.
  void thesisListing() {
    const std::string listing =
        "DegeneracyFilter\nSlopeFilter 60\nDuplicationFilter 0.005\nSmartRecursiveStrategy 50 3 true\n"
        "DegeneracyFilter\nVerticalClearanceFilter 3\nRoundingFilter true\nCollapse\nDegeneracyFilter\n"
        "DuplicationFilter 0.005\nAreaFilter 500\nSimplificationFilter true 0.000001\nPEELFilter\n";
    for (const char* name : {"house", "villa"}) {
      const EnvironmentPtr environment =
          importEnvironment(std::string(FOOTFALL_SOURCE_DIR "/samples/") + name + "/" + name + ".obj", {});
      QCOMPARE(difference(environment, listing, 2), std::string());
    }
  }

  void reports() {
    const EnvironmentPtr environment = importEnvironment(FOOTFALL_SOURCE_DIR "/samples/villa/villa.obj", {});
    std::mutex mutex;
    std::size_t announced = 0;
    std::multiset<std::size_t> finished;
    RunContext context([&](const RunEvent& event) {
      const std::lock_guard lock(mutex);
      if (event.kind == RunEvent::Kind::CellsMade) announced = event.block->cells.size();
      if (event.kind == RunEvent::Kind::CellFinished) finished.insert(event.cell);
    });
    const RunResult result = runPipeline(
        environment,
        parsePipeline("DegeneracyFilter\nGridStrategy 4 3\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n"
                      "SimplificationFilter\n",
                      "test"),
        context, nullptr, 2);
    QCOMPARE(result.blocks.size(), std::size_t{1});
    const BlockReport& block = result.blocks[0];
    QCOMPARE(block.firstStep, std::size_t{1});
    QCOMPARE(block.lastStep, std::size_t{4});
    QCOMPARE(block.cells.size(), std::size_t{12});
    QCOMPARE(announced, std::size_t{12});
    QCOMPARE(finished.size(), std::size_t{12});
    QCOMPARE(std::set<std::size_t>(finished.begin(), finished.end()).size(), std::size_t{12});
    std::uint64_t out = 0;
    double work = 0;
    for (const CellReport& cell : block.cells) {
      out += cell.trianglesOut;
      work += cell.workMs();
      QVERIFY(cell.startMs >= block.startMs && cell.endMs >= cell.startMs && cell.endMs <= result.totalMs);
      QVERIFY(cell.thread == 0 || cell.thread == 1);
      QCOMPARE(cell.spans.front().filter, std::string("SlopeFilter"));
      for (const CellSpan& span : cell.spans) {
        QVERIFY(span.startMs >= cell.startMs && span.endMs >= span.startMs && span.endMs <= cell.endMs);
        QVERIFY(span.thread == 0 || span.thread == 1);
      }
    }
    // Joining splits triangles where others touch them, and no filter adds any.
    QVERIFY(out > 0 && out <= result.steps[3].out.triangles);
    const std::vector<double> busy = block.busyMs(2);
    QVERIFY(std::abs(busy[0] + busy[1] - work) < 1e-6);
    QVERIFY(block.imbalance(2) >= 1 && block.imbalance(2) <= 2);
    const RunTimes& t = result.times;
    QCOMPARE(t.total, result.totalMs);
    QVERIFY(t.partitioning > 0 && t.parallel > 0 && t.merging > 0 && t.postprocessing > 0 && t.overhead > 0);
    // Bars on one lane do not overlap.
    for (int thread = 0; thread < 2; ++thread) {
      std::vector<std::pair<double, double>> lane;
      for (const CellReport& cell : block.cells)
        for (const CellSpan& span : cell.spans)
          if (span.thread == thread) lane.emplace_back(span.startMs, span.endMs);
      std::sort(lane.begin(), lane.end());
      for (std::size_t i = 1; i < lane.size(); ++i) QVERIFY(lane[i].first >= lane[i - 1].second);
    }
  }

  // Rejected triangles are no floors for the next pass over the cells, and a report is about all passes.
  void reportsOfSeveralPasses() {
    Soup soup;
    for (int i = 0; i < 8; ++i)
      soup.floor(i, 0, i + 1, 8, 0).quad({double(i), 9, 0}, {i + 1.0, 9, 0}, {i + 1.0, 10, 8}, {double(i), 10, 8});
    const RunResult result = run(soup.environment(),
                                 "GridStrategy 2 2\nSlopeFilter 60\nSlopeFilter 45\nVerticalClearanceFilter 1\n"
                                 "VerticalClearanceFilter 2\nCollapse\n",
                                 2);
    std::uint64_t out = 0;
    for (const CellReport& cell : result.blocks[0].cells) {
      out += cell.trianglesOut;
      for (const CellSpan& span : cell.spans) QVERIFY(cell.startMs <= span.startMs && span.endMs <= cell.endMs);
    }
    QCOMPARE(out, result.steps[4].out.triangles);
    double filters = 0;
    for (int i = 1; i <= 4; ++i) filters += result.steps[i].wallMs;
    QVERIFY(filters <= result.times.parallel * (1 + 1e-9));
  }

  // The last cell on a shared floor differs from run to run; the reports do not.
  void reportedTrianglesOfCellsAreTheSame() {
    Soup soup;
    soup.floor(0, 0, 30, 30, 0);
    for (int i = 0; i < 30; ++i)
      for (int j = 0; j < 30; ++j) soup.box({i + 0.2, j + 0.3, 0.5}, {i + 0.6, j + 0.7, 1});
    std::vector<std::uint64_t> first;
    for (int repetition = 0; repetition < 30; ++repetition) {
      const RunResult result =
          run(soup.environment(), "GridStrategy 5 5\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n",
              1 + repetition % 4);
      std::vector<std::uint64_t> out;
      for (const CellReport& cell : result.blocks[0].cells) out.push_back(cell.trianglesOut);
      if (first.empty()) first = out;
      QCOMPARE(out, first);
    }
    QVERIFY(std::accumulate(first.begin(), first.end(), std::uint64_t{0}) > 900);
  }

  // A thread that puts together what other cells left does so between two floors of its own cell.
  void lanesOfManyThreads() {
    Soup soup;
    for (int i = 0; i < 30; ++i)
      for (int j = 0; j < 30; ++j)
        soup.floor(i, j, i + 1, j + 1, 0).box({i + 0.2, j + 0.3, 0.5}, {i + 0.6, j + 0.7, 1});
    for (const int threads : {4, 8, 12, 16, 4, 8, 12, 16}) {
      const RunResult result =
          run(soup.environment(), "GridStrategy 7 7\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n", threads);
      std::vector<std::vector<std::pair<double, double>>> lanes(static_cast<std::size_t>(threads));
      for (const CellReport& cell : result.blocks[0].cells) {
        const auto startsBefore = [](const CellSpan& a, const CellSpan& b) { return a.startMs < b.startMs; };
        QVERIFY(std::is_sorted(cell.spans.begin(), cell.spans.end(), startsBefore));
        for (const CellSpan& span : cell.spans)
          lanes.at(static_cast<std::size_t>(span.thread)).emplace_back(span.startMs, span.endMs);
      }
      for (auto& lane : lanes) {
        std::sort(lane.begin(), lane.end());
        for (std::size_t i = 1; i < lane.size(); ++i) QVERIFY(lane[i].first >= lane[i - 1].second);
      }
    }
  }

  // Two triangles of floor that carry thousands of walls are work for all threads.
  void fewFloorsWithMuchOnThem() {
    Soup soup = Soup().floor(0, 0, 100, 100, 0);
    for (int i = 0; i < 100; ++i)
      for (int j = 0; j < 100; ++j) soup.wall(i + 0.1, j + 0.2, i + 0.7, j + 0.2 + 0.5 * ((i + j) % 2), 0, 1);
    for (const char* strategy : {"AutoStrategy", "GridStrategy 4 4"}) {
      bool isShared = false;  // Other threads may come too late on a busy machine.
      for (int tries = 0; tries < 50 && !isShared; ++tries) {
        const RunResult result =
            run(soup.environment(), std::string(strategy) + "\nVerticalClearanceFilter 2\nCollapse\n", 4);
        const std::vector<double> busy = result.blocks[0].busyMs(4);
        isShared = std::count_if(busy.begin(), busy.end(), [](double ms) { return ms > 0; }) > 1;
      }
      QVERIFY2(isShared, strategy);
    }
  }

  void previewHasTheCellsOfTheRun() {
    const EnvironmentPtr environment = importEnvironment(FOOTFALL_SOURCE_DIR "/samples/villa/villa.obj", {});
    const Pipeline pipeline = parsePipeline(
        "SortedRecursiveStrategy 50 4 false\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse", "test");
    RunContext context;
    const Partition preview = previewPartition(environment, pipeline, 0, context, 2);
    const RunResult result = runPipeline(environment, pipeline, context, nullptr, 2);
    QCOMPARE(preview.cells.size(), result.blocks[0].cells.size());
    for (std::size_t i = 0; i < preview.cells.size(); ++i) {
      QCOMPARE(preview.cells[i].bounds.lower, result.blocks[0].cells[i].bounds.lower);
      QCOMPARE(preview.cells[i].bounds.upper, result.blocks[0].cells[i].bounds.upper);
      QCOMPARE(preview.cells[i].cost, result.blocks[0].cells[i].cost);
    }
    QVERIFY_THROWS_EXCEPTION(InputError, previewPartition(environment, pipeline, 1, context));
    context.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, previewPartition(environment, pipeline, 0, context));
  }

  void tooManyCellsAreRefused() {
    const EnvironmentPtr environment = Soup().floor(0, 0, 1, 1, 0).environment();
    RunContext context;
    const Pipeline pipeline = parsePipeline("SlopeFilter 45\nGridStrategy 70000 70000\nCollapse\n", "test");
    try {
      runPipeline(environment, pipeline, context);
      QFAIL("accepted");
    } catch (const InputError& error) {
      QVERIFY2(std::string(error.what()).starts_with("line 2: GridStrategy 70000 70000 would make"), error.what());
    }
  }

  void cancelledAnywhere() {
    const EnvironmentPtr environment = importEnvironment(FOOTFALL_SOURCE_DIR "/samples/house/house.obj", {});
    const Pipeline pipeline = parsePipeline(
        "GridStrategy 4 4\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\nSimplificationFilter\n", "test");
    for (int events = 0; events < 40; ++events) {
      RunContext* running = nullptr;
      std::atomic<int> left = events;
      RunContext context([&](const RunEvent&) {
        if (left-- == 0) running->cancel();
      });
      running = &context;
      QVERIFY_THROWS_EXCEPTION(Cancelled, runPipeline(environment, pipeline, context, nullptr, 2));
    }
  }

  void cachedBlocks() {
    const EnvironmentPtr environment = importEnvironment(FOOTFALL_SOURCE_DIR "/samples/house/house.obj", {});
    const std::string block = "GridStrategy 3 3\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n";
    ResultCache cache;
    run(environment, block + "AreaFilter 1\n", 2, &cache);
    const RunResult again = run(environment, block + "AreaFilter 2\n", 2, &cache);
    QVERIFY(again.blocks.empty());
    QVERIFY(again.steps[3].fromCache && !again.steps[4].fromCache);
    QVERIFY(again.times.postprocessing > 0 && again.times.preprocessing == 0);
    // Another clearance reuses the data of the block, and still gives the same bytes.
    const std::string higher = "GridStrategy 3 3\nSlopeFilter 45\nVerticalClearanceFilter 2.5\nCollapse\n";
    QCOMPARE(bytes(run(environment, higher, 2, &cache)), bytes(run(environment, withoutBlocks(higher), 1)));
  }
};

QTEST_APPLESS_MAIN(TestParallelBlocks)
#include "test_parallel_blocks.moc"
