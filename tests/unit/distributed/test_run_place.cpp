// Where processes are started: what is typed, what is told when they fail, and runs by footfall-mpi.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <chrono>
#include <thread>

#include "core/base/child_process.hpp"
#include "core/distributed/folder_exchange.hpp"
#include "core/distributed/run_place.hpp"
#include "core/io/export.hpp"
#include "core/io/import.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/errors.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

/// An executable file with that text.
std::string script(const QTemporaryDir& folder, const char* name, const QByteArray& text) {
  QFile file(folder.filePath(name));
  if (!file.open(QIODevice::WriteOnly) || file.write("#!/bin/sh\n" + text) < 0) return {};
  file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  return file.fileName().toStdString();
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word + ' ';
  return text;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

RunPlace placeOf(RunPlace::Kind kind) {
  RunPlace place;
  place.kind = kind;
  place.processes = 3;
  return place;
}

RunPrograms programs() { return findPrograms((QCoreApplication::applicationDirPath() + "/..").toStdString()); }

/// The house by processes of a place, as the editor does it.
struct JobRun {
  JobRun(const QTemporaryDir& folder, const RunPlace& place)
      : house(std::make_shared<Environment>(load(std::string(FOOTFALL_SOURCE_DIR) + "/samples/house/house.obj"))),
        pipeline(parsePipeline(
            "GridStrategy 3 4\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\nLayerSubdivisionFilter\n", "test")),
        given(formatPipeline(pipeline)) {
    options.folder = folder.filePath("job").toStdString();
    const int threads = place.kind == RunPlace::Kind::Processes ? 1 : 0;
    options.work = [this, place, threads](const std::string& job, Poll poll) {
      writeJob(job, *house, given);
      return runJob(job, place, programs(), threads, poll);
    };
  }
  bool givesTheSame() {
    FolderExchange exchange(options);
    const RunResult result = runTogether(house, pipeline, context, exchange, 1);
    threadsOfRanks = exchange.threadsOfRanks();
    RunContext own;
    return formatObj(*result.mesh, {}) == formatObj(*runPipeline(house, pipeline, own).mesh, {});
  }

  std::shared_ptr<const Environment> house;
  Pipeline pipeline;
  std::string given;  ///< the pipeline of the job
  RunContext context;
  FolderExchange::Options options;
  std::vector<int> threadsOfRanks;
};

}  // namespace

class TestRunPlace : public QObject {
  Q_OBJECT

 private slots:
  void commands() {
    const RunPrograms programs{"/bin/footfall-mpi", "mpirun", "sbatch", "scancel"};
    const std::string here = joined(commandOf("/jobs/a b", placeOf(RunPlace::Kind::Processes), programs, 2));
    QVERIFY(has(here, "mpirun --bind-to none -n 3 ") && has(here, "--host localhost:3 "));
    QVERIFY(has(here, "/bin/footfall-mpi cells /jobs/a b --threads 2 "));
    RunPlace hosts = placeOf(RunPlace::Kind::Hosts);
    hosts.hostFile = "/jobs/hosts";
    const std::string there = joined(commandOf("/jobs/1", hosts, programs, 0));
    QVERIFY(has(there, "--hostfile /jobs/hosts ") && !has(there, "localhost") && !has(there, "--threads"));
    RunPlace slurm = placeOf(RunPlace::Kind::Slurm);
    QVERIFY(!has(joined(commandOf("/jobs/1", slurm, programs, 0)), "--partition"));
    slurm.partition = "long";
    const std::string batch = joined(commandOf("/jobs/it's", slurm, programs, 0));
    QVERIFY(has(batch, "sbatch --wait ") && has(batch, "--nodes 3 ") && has(batch, "--partition long "));
    QVERIFY(has(batch, R"('/bin/footfall-mpi' cells '/jobs/it'\''s')"));
  }

  void whatIsMissingIsTold() {
    QTemporaryDir folder;
    RunPrograms programs{"/none/footfall-mpi", "/none/mpirun", "/none/sbatch", "/none/scancel"};
    QVERIFY(problemOf(placeOf(RunPlace::Kind::ThisProcess), programs).empty());
    QVERIFY(has(problemOf(placeOf(RunPlace::Kind::Processes), programs).str(), "/none/footfall-mpi was not found"));
    programs.footfallMpi = script(folder, "footfall-mpi", "");
    QVERIFY(has(problemOf(placeOf(RunPlace::Kind::Processes), programs).str(), "/none/mpirun was not found"));
    QVERIFY(has(problemOf(placeOf(RunPlace::Kind::Slurm), programs).str(), "/none/sbatch was not found"));
    programs.mpirun = script(folder, "mpirun", "");
    QVERIFY(problemOf(placeOf(RunPlace::Kind::Processes), programs).empty());
    RunPlace hosts = placeOf(RunPlace::Kind::Hosts);
    hosts.hostFile = folder.filePath("hosts").toStdString();
    QVERIFY(has(problemOf(hosts, programs).str(), "this host file cannot be read"));
  }

  void programsBesideComeFirst() {
    QTemporaryDir folder;
    qunsetenv("FOOTFALL_MPI");
    QCOMPARE(findPrograms(folder.path().toStdString()).footfallMpi, std::string("footfall-mpi"));
    const std::string beside = script(folder, "footfall-mpi", "");
    QCOMPARE(findPrograms(folder.path().toStdString()).footfallMpi, beside);
    qputenv("FOOTFALL_MPI", "/other/footfall-mpi");
    QCOMPARE(findPrograms(folder.path().toStdString()).footfallMpi, std::string("/other/footfall-mpi"));
    qunsetenv("FOOTFALL_MPI");
  }

  void ofTheirWordsOursCount() {
    QCOMPARE(
        problemIn("-----\nfootfall-mpi: note: rank 1: a note\nfootfall-mpi: rank 1: memory ran out\nmpirun noticed\n"),
        std::string("rank 1: memory ran out"));
    QCOMPARE(problemIn("There are not enough slots\n------\n\n"), std::string("There are not enough slots"));
    QCOMPARE(problemIn(""), std::string());
    QTemporaryDir folder;
    RunPrograms programs;
    programs.footfallMpi = script(folder, "footfall-mpi", "");
    programs.mpirun = script(folder, "mpirun", "echo 'footfall-mpi: rank 2: the disk is full' >&2; exit 7\n");
    const std::string told =
        runJob(folder.path().toStdString(), placeOf(RunPlace::Kind::Processes), programs, 1, {}).str();
    QCOMPARE(told, "rank 2: the disk is full (exit code 7 of " + programs.mpirun + ")");
    programs.mpirun = script(folder, "mpirun", "exit 7\n");
    QVERIFY(has(runJob(folder.path().toStdString(), placeOf(RunPlace::Kind::Processes), programs, 1, {}).str(),
                "ended with exit code 7"));
  }

  // Slurm's job is not that of sbatch: it has to be ended by its name.
  void cancellingEndsTheJob() {
    QTemporaryDir folder;
    RunPrograms programs;
    programs.footfallMpi = script(folder, "footfall-mpi", "");
    programs.sbatch = script(folder, "sbatch", "touch '" + folder.filePath("begun").toUtf8() + "'; sleep 60\n");
    programs.scancel = script(folder, "scancel", "echo \"$@\" >'" + folder.filePath("cancelled").toUtf8() + "'\n");
    const auto poll = [&] {
      if (QFile::exists(folder.filePath("begun"))) throw Cancelled();
    };
    QVERIFY_EXCEPTION_THROWN(
        runJob(folder.filePath("job-5").toStdString(), placeOf(RunPlace::Kind::Slurm), programs, 1, poll), Cancelled);
    QFile cancelled(folder.filePath("cancelled"));
    QVERIFY(cancelled.open(QIODevice::ReadOnly));
    QCOMPARE(cancelled.readAll(), QByteArray("--name footfall-job-5\n"));
  }

  // By mpirun and footfall-mpi, where both are there.
  void processesOfThisMachine() {
    const RunPlace place = placeOf(RunPlace::Kind::Processes);
    if (const Text problem = problemOf(place, programs()); !problem.empty()) QSKIP(problem.str().c_str());
    QTemporaryDir folder;
    JobRun run(folder, place);
    QVERIFY(run.givesTheSame());
    QCOMPARE(run.threadsOfRanks, (std::vector<int>{1, 1, 1}));
    QVERIFY(QDir(folder.path()).isEmpty());

    // What the processes tell is what the run tells.
    run.given = "NoSuchFilter\n";
    try {
      run.givesTheSame();
      QFAIL("it ran");
    } catch (const RunError& error) {
      QVERIFY2(has(error.what(), "NoSuchFilter") && has(error.what(), "exit code 2"), error.what());
    }
  }

  // Two processes of a list whose only machine is this one.
  void machinesOfAHostFile() {
    QTemporaryDir folder;
    QFile file(folder.filePath("hosts"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("localhost slots=2\n") > 0);
    file.close();
    RunPlace place = placeOf(RunPlace::Kind::Hosts);
    place.processes = 2;
    place.hostFile = file.fileName().toStdString();
    if (const Text problem = problemOf(place, programs()); !problem.empty()) QSKIP(problem.str().c_str());
    if (QStandardPaths::findExecutable("ssh").isEmpty()) QSKIP("mpirun wants ssh for a host file");
    JobRun run(folder, place);
    QVERIFY(run.givesTheSame());
    QCOMPARE(run.threadsOfRanks.size(), std::size_t{2});
  }

  // Of a Slurm that is there: tests/mpi/slurm.sh brings one up.
  void machinesOfSlurm() {
    RunPlace place = placeOf(RunPlace::Kind::Slurm);
    place.processes = 2;
    if (!qEnvironmentVariableIsSet("SLURM_CONF")) QSKIP("SLURM_CONF names no Slurm");
    if (const Text problem = problemOf(place, programs()); !problem.empty()) QSKIP(problem.str().c_str());
    QTemporaryDir folder;
    JobRun run(folder, place);
    QVERIFY(run.givesTheSame());
    QCOMPARE(run.threadsOfRanks, (std::vector<int>{2, 2}));

    // A job that is cancelled leaves the queue.
    std::atomic<bool> isOver{false};
    std::thread canceller([&] {
      while (!isOver && !QFile::exists(folder.filePath("job/ranks")))
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
      run.context.cancel();
    });
    run.options.work = [&, work = run.options.work](const std::string& job, Poll poll) {
      const Text told = work(job, poll);
      isOver = true;
      return told;
    };
    try {
      run.givesTheSame();
    } catch (const Cancelled&) {
    }
    isOver = true;
    canceller.join();
    const auto queue = [] { return runChild({"squeue", "--noheader"}, {}).output; };
    for (int i = 0; i < 300 && !queue().empty(); ++i) QTest::qWait(100);
    QCOMPARE(queue(), std::string());
  }
};

QTEST_GUILESS_MAIN(TestRunPlace)
#include "test_run_place.moc"
