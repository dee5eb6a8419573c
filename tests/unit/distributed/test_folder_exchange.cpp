// A run whose cells other processes (threads here) leave in a folder: the same bytes, or a message.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <chrono>
#include <thread>

#include "core/distributed/folder_exchange.hpp"
#include "core/io/export.hpp"
#include "core/io/import.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/errors.hpp"
#include "footfall/run.hpp"
#include "tests/support/rank_runs.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using EnvironmentPtr = std::shared_ptr<const Environment>;

const char* const kFilters =
    "DegeneracyFilter\nGridStrategy 3 4\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n"
    "AreaFilter 1\nLayerSubdivisionFilter\n";

std::string bytes(const RunResult& result) { return formatObj(*result.mesh, {}); }

EnvironmentPtr house() {
  return std::make_shared<Environment>(load(std::string(FOOTFALL_SOURCE_DIR) + "/samples/house/house.obj"));
}

/// A run by a job whose processes are threads.
struct JobRun {
  explicit JobRun(EnvironmentPtr e, const std::string& text)
      : environment(std::move(e)), pipeline(parsePipeline(text, "test")) {
    options.folder = (folder.path() + "/job").toStdString();
    options.work = [this](const std::string& job, Poll poll) { return work(job, poll); };
    ranks.ranks = 3;
    ranks.leavesShares = true;
  }
  Text work(const std::string& job, Poll poll) {
    ++calls;
    writeJob(job, *environment, formatPipeline(pipeline));
    Job read = readJob(job);
    ranks.workFolder = job;
    const auto done = ranks.cellDone;
    ranks.cellDone = [done, &poll](int rank) {
      done(rank);
      poll();
    };
    const RankOutcome outcome = runOnRanks(std::make_shared<Environment>(std::move(read.environment)),
                                           parsePipeline(read.pipeline, "job"), ranks);
    return outcome.error.empty() ? Text() : Text(Pattern{"%1"}, outcome.error);
  }
  RunResult run() {
    FolderExchange exchange(options);
    RunResult result = runTogether(environment, pipeline, context, exchange, 1, cache);
    threadsOfRanks = exchange.threadsOfRanks();
    return result;
  }
  [[nodiscard]] std::string bytesOfOne() const {
    RunContext own;
    return bytes(runPipeline(environment, pipeline, own, nullptr, 1));
  }
  /// The error that the run throws.
  std::string problem() {
    try {
      run();
    } catch (const std::exception& error) {
      return error.what();
    }
    return {};
  }
  [[nodiscard]] bool leavesNothing() const { return QDir(folder.path()).isEmpty(); }

  EnvironmentPtr environment;
  Pipeline pipeline;
  QTemporaryDir folder;
  RunContext context;
  ResultCache* cache = nullptr;
  FolderExchange::Options options;
  RankOptions ranks;
  std::atomic<int> calls{0};
  std::vector<int> threadsOfRanks;
};

}  // namespace

class TestFolderExchange : public QObject {
  Q_OBJECT

 private slots:
  void randomSoups() {
    const std::vector<std::string> pipelines{
        kFilters,
        "SlopeFilter 50\nHeightAwareStrategy 1 4\nVerticalClearanceFilter 1.5\nCollapse\nStepFilter 0.4 0.1\n",
        "AutoStrategy\nVerticalClearanceFilter 1\nRoundingFilter\nSlopeFilter 45\nVerticalClearanceFilter "
        "2\nCollapse\n",
        "GridStrategy 2 2\nVerticalClearanceFilter 1\nCollapse\nSimplificationFilter\nGridStrategy 3 3\nSlopeFilter "
        "45\n"
        "VerticalClearanceFilter 2\nCollapse\n"};
    QVERIFY(check("processes that leave their shares give the bytes of one", 100, [&] {
      const Soup soup = *rc::gen::noShrink(
          rc::gen::oneOf(rc::gen::map(gridTriangles(20, 3, 3), [](const auto& numbers) { return soupOf(numbers); }),
                         rc::gen::map(buildingParts(12), [](const auto& numbers) { return buildingOf(numbers); })));
      auto environment = std::make_shared<Environment>(*soup.environment(*below(4) == 0));
      if (environment->triangles.empty()) return;
      if (*below(2) == 0) {
        environment->obstacleOnly.assign(environment->triangles.size(), 0);
        environment->obstacleOnly[0] = 1;
      }
      JobRun run(environment, pipelines[static_cast<std::size_t>(*below(static_cast<int>(pipelines.size())))]);
      run.ranks.ranks = 1 + *below(3);
      if (bytes(run.run()) != run.bytesOfOne()) RC_FAIL("not the same");
      if (run.calls != 1) RC_FAIL("the processes were not started once");
      if (!run.leavesNothing()) RC_FAIL("something is left in the folder");
    }));
  }

  void cellsAreThoseOfRanks() {
    JobRun run(house(), kFilters);
    run.ranks.threads = 2;
    const RunResult result = run.run();
    QVERIFY(bytes(result) == run.bytesOfOne());
    QCOMPARE(run.threadsOfRanks, (std::vector<int>{2, 2, 2}));
    QCOMPARE(result.threads, 7);
    // Thread 0 is that of this process, which triangulates what cells share.
    std::vector<char> works(3, 0);
    for (const CellReport& cell : result.blocks.at(0).cells) {
      QVERIFY(cell.thread >= 1 && cell.thread < 7 && cell.startMs <= cell.endMs);
      const int rank = (cell.thread - 1) / 2;
      for (const CellSpan& span : cell.spans) QVERIFY(span.thread == 0 || (span.thread - 1) / 2 == rank);
      works[static_cast<std::size_t>(rank)] = 1;
    }
    QCOMPARE(works, std::vector<char>(3, 1));
  }

  // Filters behind the block need no processes, and neither does a pipeline without one.
  void nobodyIsStartedForNothing() {
    ResultCache cache;
    JobRun run(house(), kFilters);
    run.cache = &cache;
    run.run();
    run.pipeline.steps[5].values[0] = 2;  // the area
    QVERIFY(bytes(run.run()) == run.bytesOfOne());
    QCOMPARE(run.calls.load(), 1);
    run.pipeline.steps[3].values[0] = 1.5;  // the clearance
    QVERIFY(bytes(run.run()) == run.bytesOfOne());
    QCOMPARE(run.calls.load(), 2);
    JobRun plain(house(), "SlopeFilter 45\nVerticalClearanceFilter 2\n");
    QVERIFY(bytes(plain.run()) == plain.bytesOfOne());
    QCOMPARE(plain.calls.load(), 0);
    QCOMPARE(plain.threadsOfRanks, std::vector<int>());
  }

  // A later run on this machine alone finds nothing of what threads leave for it, and runs all.
  void aLaterRunOfThisProcessIsTheSame() {
    ResultCache cache;
    JobRun run(house(), kFilters);
    run.cache = &cache;
    run.run();
    for (const double height : {1.5, 2.5}) {
      run.pipeline.steps[3].values[0] = height;
      RunContext context;
      QVERIFY(bytes(runPipeline(run.environment, run.pipeline, context, &cache, 2)) == run.bytesOfOne());
      QVERIFY(bytes(run.run()) == run.bytesOfOne());
    }
  }

  void whatGoesWrongIsTold() {
    JobRun failing(house(), kFilters);
    failing.ranks.cellDone = [](int rank) {
      if (rank == 1) throw RunError("memory ran out");
    };
    QCOMPARE(failing.problem(), std::string("rank 1: memory ran out"));
    QVERIFY(failing.leavesNothing());

    JobRun early(house(), kFilters);
    early.options.work = [](const std::string&, Poll) { return Text(Pattern{"mpirun was not found"}); };
    QCOMPARE(early.problem(), std::string("mpirun was not found"));
    QVERIFY(early.leavesNothing());

    JobRun elsewhere(house(), kFilters);
    elsewhere.options.patienceMs = 50;
    elsewhere.options.work = [](const std::string&, Poll) { return Text(); };
    QVERIFY(elsewhere.problem().find("the processes ended, and their results are not in") == 0);

    // Processes that did not run all cells.
    JobRun half(house(), kFilters);
    half.options.patienceMs = 50;
    half.options.work = [&half](const std::string& job, Poll poll) {
      const QTemporaryDir aside;
      const Text told = half.work(aside.path().toStdString(), poll);
      const QDir from(aside.path()), to(QString::fromStdString(job));
      QStringList shares = from.entryList({"*.share"});
      shares.removeLast();
      for (const QString& name : shares + QStringList{"ranks"}) QFile::copy(from.filePath(name), to.filePath(name));
      return told;
    };
    const std::string problem = half.problem();
    QVERIFY2(problem.find("the processes ended, and their results are not in") == 0, problem.c_str());

    JobRun nowhere(house(), kFilters);
    nowhere.options.folder = nowhere.folder.filePath("missing/job").toStdString();
    QVERIFY(nowhere.problem().find("this folder for shares cannot be made") != std::string::npos);
    QVERIFY(nowhere.leavesNothing());
  }

  // mpirun may wait for ever for a process that died while it was started; one that reads may take its time.
  void processesThatDoNotBeginAreTold() {
    for (const bool begins : {false, true}) {
      JobRun run(house(), kFilters);
      run.options.startMs = 1000;
      run.options.work = [&run, begins](const std::string& job, Poll poll) {
        writeJob(job, *run.environment, formatPipeline(run.pipeline));
        if (begins) sayBegun(job);
        for (const Stopwatch watch; !begins || watch.wallMs() < 1500; poll())
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return run.work(job, poll);
      };
      const std::string problem = run.problem();
      QCOMPARE(problem,
               begins
                   ? std::string()
                   : std::string("not all processes have begun within 1 s; run again, or run on this program alone"));
      QVERIFY(run.leavesNothing());
    }
  }

  void cancellingEndsTheProcesses() {
    JobRun run(house(), kFilters);
    std::atomic<bool> hasBegun{false}, isCancelled{false};
    run.options.work = [&](const std::string&, Poll poll) -> Text {
      hasBegun = true;
      try {
        for (;; std::this_thread::sleep_for(std::chrono::milliseconds(1))) poll();
      } catch (const Cancelled&) {
        isCancelled = true;
        throw;
      }
    };
    std::thread canceller([&] {
      while (!hasBegun) std::this_thread::yield();
      run.context.cancel();
    });
    const std::string problem = run.problem();
    canceller.join();
    QCOMPARE(problem, std::string(Cancelled().what()));
    QVERIFY(isCancelled);
    QVERIFY(run.leavesNothing());
  }

  void filesThatCannotBeReadAreTold() {
    QTemporaryDir folder;
    const std::string path = folder.filePath("file").toStdString();
    QVERIFY(!contentOf(path));
    QVERIFY_EXCEPTION_THROWN(contentOf(folder.path().toStdString()), BadBytes);
    QVERIFY_EXCEPTION_THROWN(contentOf("/proc/self/mem"), BadBytes);  // an error of reading it
    for (const int size : {0, 1, 1 << 18, 3000001}) {
      const QByteArray content(size, static_cast<char>('a' + size % 7));
      QFile file(QString::fromStdString(path));
      QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == size);
      file.close();
      QVERIFY(contentOf(path) == content.toStdString());
    }
  }

  // The use of the results decides how long the run waits for the processes.
  void theyLearnWhyTheyEnd() {
    for (const bool cancels : {false, true}) {
      JobRun run(house(), kFilters);
      bool isCancelled = false;
      run.options.work = [&](const std::string& job, Poll poll) -> Text {
        try {
          run.work(job, poll);
          if (cancels) run.context.cancel();
          for (;;) poll();
        } catch (const Cancelled&) {
          isCancelled = true;
          throw;
        }
      };
      if (cancels) run.ranks.cellDone = [&run](int) { run.context.cancel(); };
      QCOMPARE(run.problem(), cancels ? std::string(Cancelled().what()) : std::string());
      QCOMPARE(isCancelled, cancels);
    }
  }

  void jobsAreReadAsWritten() {
    QTemporaryDir folder;
    const std::string path = folder.path().toStdString();
    auto environment = *house();
    environment.bothSides = true;
    environment.metresPerUnit = 0.0254;
    environment.up = UpAxis::NegativeX;
    environment.obstacleOnly.assign(environment.triangles.size(), 0);
    environment.obstacleOnly[7] = 1;
    writeJob(path, environment, "SlopeFilter 45\n");
    const Job job = readJob(path);
    QCOMPARE(job.pipeline, std::string("SlopeFilter 45\n"));
    QVERIFY(job.environment.vertices == environment.vertices && job.environment.triangles == environment.triangles);
    QVERIFY(job.environment.obstacleOnly == environment.obstacleOnly && job.environment.bothSides);
    QVERIFY(job.environment.up == environment.up && job.environment.metresPerUnit == environment.metresPerUnit);
    QCOMPARE(job.environment.source, environment.source);

    writeRanks(path, {{2, 5.5}, {3, 6}});
    QCOMPARE(readRanks(path)->at(1).threads, 3);
    QCOMPARE(readRanks(path)->at(0).beganMs, 5.5);
    QVERIFY(!hasBegun(path));
    sayBegun(path);
    QVERIFY(hasBegun(path));
    sayBegun(path + "/none");
    QVERIFY(!QDir(folder.path()).exists("none"));
    {
      QFile ranks(folder.filePath("ranks"));
      QVERIFY(ranks.open(QIODevice::ReadWrite) && ranks.resize(ranks.size() - 1));
      try {
        readRanks(path);
        QFAIL("it was read");
      } catch (const InputError& error) {
        const std::string told = error.what();
        QVERIFY2(told.find(path + "/ranks is cut off; use the same version of Footfall everywhere") == 0, told.c_str());
      }
    }
    QFile file(folder.filePath("job"));
    QVERIFY(file.open(QIODevice::ReadWrite) && file.resize(file.size() / 2));
    QVERIFY_EXCEPTION_THROWN(readJob(path), InputError);
    QVERIFY(file.remove());
    QVERIFY_EXCEPTION_THROWN(readJob(path), InputError);
  }
};

QTEST_GUILESS_MAIN(TestFolderExchange)
#include "test_folder_exchange.moc"
