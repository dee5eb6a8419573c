// The places where processes are started: the commands, messages of failures, and runs by footfall-mpi.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

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

/// Frames a message as Open MPI does.
std::string inDashes(const std::vector<const char*>& lines) {
  const QByteArray dashes = QByteArray(74, '-') + '\n';
  QByteArray text = dashes;
  for (const char* line : lines) text.append(line).append('\n');
  return (text + dashes).toStdString();
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
    options.startMs = 60000;
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
    const RunPrograms programs{"/bin/footfall-mpi", "mpirun", "sbatch", "scancel", "squeue"};
    const std::string here = joined(commandOf("/jobs/a b", placeOf(RunPlace::Kind::Processes), programs, 2));
    QVERIFY(has(here, "mpirun --bind-to none -n 3 ") && has(here, "--host localhost:3 "));
    QVERIFY(has(here, "/bin/footfall-mpi cells /jobs/a b --threads 2 "));
    RunPlace hosts = placeOf(RunPlace::Kind::Hosts);
    hosts.hostFile = "/jobs/hosts";
    const std::string there = joined(commandOf("/jobs/1", hosts, programs, 0));
    QVERIFY(has(there, "--hostfile /jobs/hosts --map-by node ") && has(there, "--mca plm_rsh_args -o BatchMode=yes "));
    QVERIFY(!has(there, "localhost") && !has(there, "--threads"));
    RunPlace slurm = placeOf(RunPlace::Kind::Slurm);
    QVERIFY(!has(joined(commandOf("/jobs/1", slurm, programs, 0)), "--partition"));
    slurm.partition = "long";
    const std::string batch = joined(commandOf("/jobs/it's", slurm, programs, 0));
    QVERIFY(has(joined(commandOf("/jobs/footfall-5", slurm, programs, 0)), "--job-name footfall-5 "));
    QVERIFY(has(batch, "sbatch --wait ") && has(batch, "--nodes 3 ") && has(batch, "--partition long "));
    QVERIFY(has(batch, R"('/bin/footfall-mpi' cells '/jobs/it'\''s')"));
  }

  void whatIsMissingIsTold() {
    QTemporaryDir folder;
    RunPrograms programs{"/none/footfall-mpi", "/none/mpirun", "/none/sbatch", "/none/scancel", "/none/squeue"};
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
    hosts.hostFile = folder.path().toStdString();
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

  // The message of mpirun itself stands in dashes, with advice behind it.
  void ofItsWordsTheFirstCount() {
    QCOMPARE(
        problemIn(
            inDashes({"There are not enough slots available in the system to satisfy the 3",
                      "slots that were requested by the application:", "", "  true", "",
                      "Either request fewer slots for your application, or make more slots", "available for use."})),
        std::string("There are not enough slots available in the system to satisfy the 3 slots that were requested "
                    "by the application:"));
    const std::string ssh = "ssh: Could not resolve hostname no: Name or service not known";
    QCOMPARE(problemIn(ssh + "\r\n" +
                       inDashes({"ORTE was unable to reliably start one or more daemons.", "This usually is caused by:",
                                 "", "* not finding the required libraries and/or binaries on",
                                 "  one or more nodes. Please check your PATH and LD_LIBRARY_PATH"})),
             ssh);
    QCOMPARE(problemIn(inDashes({"Open RTE was unable to open the hostfile:", "    /none",
                                 "Check to make sure the path and filename are correct."}) +
                       inDashes({"An internal error has occurred in ORTE:", "", "[[15661,0],0] FORCE-TERMINATE"})),
             std::string("Open RTE was unable to open the hostfile: /none Check to make sure the path and filename are "
                         "correct."));
    QCOMPARE(problemIn(inDashes({})), std::string());
    QCOMPARE(problemIn("footfall-mpi: note: rank 1: a note\n" + inDashes({"Primary job terminated normally, but"})),
             std::string("Primary job terminated normally, but"));
  }

  // The message is that of the installed mpirun.
  void aHostFileThatIsTooShort() {
    QTemporaryDir folder;
    RunPlace place = placeOf(RunPlace::Kind::Hosts);
    place.hostFile = script(folder, "hosts", "localhost slots=1\n");
    if (const Text problem = problemOf(place, programs()); !problem.empty()) QSKIP(problem.str().c_str());
    const std::string told = runJob(folder.path().toStdString(), place, programs(), 1, {}).str();
    QVERIFY2(told.find("There are not enough slots available") == 0 && has(told, " (exit code "), told.c_str());
  }

  // Slurm's job is not that of sbatch: it has to be ended by its name.
  void cancellingEndsTheJob() {
    QTemporaryDir folder;
    RunPrograms programs;
    programs.footfallMpi = script(folder, "footfall-mpi", "");
    programs.sbatch = script(folder, "sbatch", "touch '" + folder.filePath("begun").toUtf8() + "'; sleep 60\n");
    programs.scancel = script(folder, "scancel", "echo \"$@\" >>'" + folder.filePath("cancelled").toUtf8() + "'\n");
    // The job enters the queue after the first query.
    programs.squeue =
        script(folder, "squeue",
               "echo >>'" + folder.filePath("looks").toUtf8() + "'\n[ \"$3\" = footfall-5 ] || exit 1\n" +
                   "if [ $(wc -l <'" + folder.filePath("looks").toUtf8() + "') = 1 ]; then echo 17; fi\n");
    const auto poll = [&] {
      if (QFile::exists(folder.filePath("begun"))) throw Cancelled();
    };
    const std::string job = folder.filePath("footfall-5").toStdString();
    QVERIFY_EXCEPTION_THROWN(runJob(job, placeOf(RunPlace::Kind::Slurm), programs, 1, poll), Cancelled);
    QFile cancelled(folder.filePath("cancelled"));
    QVERIFY(cancelled.open(QIODevice::ReadOnly));
    QCOMPARE(cancelled.readAll(), QByteArray("--name footfall-5\n--name footfall-5\n"));
    cancelled.close();

    // The run does not wait for the queue when all is done.
    QVERIFY(QFile::remove(folder.filePath("looks")) && cancelled.remove());
    const auto ends = [&] {
      if (QFile::exists(folder.filePath("begun"))) throw std::runtime_error("done");
    };
    QVERIFY_EXCEPTION_THROWN(runJob(job, placeOf(RunPlace::Kind::Slurm), programs, 1, ends), std::runtime_error);
    QVERIFY(cancelled.exists() && !QFile::exists(folder.filePath("looks")));

    // A Slurm that does not answer.
    programs.scancel = programs.squeue = script(folder, "asleep", "sleep 60\n");
    programs.answerMs = 200;
    programs.endMs = 1000;
    QElapsedTimer clock;
    clock.start();
    QVERIFY_EXCEPTION_THROWN(runJob(job, placeOf(RunPlace::Kind::Slurm), programs, 1, poll), Cancelled);
    QVERIFY(clock.elapsed() >= 1000 && clock.elapsed() < 40000);
  }

  // Runs by mpirun and footfall-mpi, if both are installed.
  void processesOfThisMachine() {
    const RunPlace place = placeOf(RunPlace::Kind::Processes);
    if (const Text problem = problemOf(place, programs()); !problem.empty()) QSKIP(problem.str().c_str());
    QTemporaryDir folder;
    JobRun run(folder, place);
    bool hasBegun = false;
    run.options.ranksKnown = [&](const std::vector<int>&) { hasBegun = detail::hasBegun(run.options.folder); };
    QVERIFY(run.givesTheSame());
    QCOMPARE(run.threadsOfRanks, (std::vector<int>{1, 1, 1}));
    QVERIFY(hasBegun);
    QVERIFY(QDir(folder.path()).isEmpty());

    // The run reports the messages of the processes.
    run.given = "NoSuchFilter\n";
    try {
      run.givesTheSame();
      QFAIL("it ran");
    } catch (const RunError& error) {
      QVERIFY2(has(error.what(), "NoSuchFilter") && has(error.what(), "exit code 2"), error.what());
    }
  }

  // A name that was mistyped, and ranks that come when the editor has removed the folder.
  void aJobThatIsNotThere() {
    const RunPlace place = placeOf(RunPlace::Kind::Processes);
    if (const Text problem = problemOf(place, programs()); !problem.empty()) QSKIP(problem.str().c_str());
    QTemporaryDir folder;
    const std::string told =
        runJob(folder.filePath("jbo").toStdString(), placeOf(RunPlace::Kind::Processes), programs(), 1, {}).str();
    QVERIFY2(has(told, "/jbo/job is missing; use the same version") && has(told, "exit code 2"), told.c_str());
    QVERIFY(QDir(folder.path()).isEmpty());
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

  // Needs a Slurm; tests/mpi/slurm.sh starts one.
  void machinesOfSlurm() {
    RunPlace place = placeOf(RunPlace::Kind::Slurm);
    place.processes = 2;
    if (!qEnvironmentVariableIsSet("SLURM_CONF")) QSKIP("SLURM_CONF names no Slurm");
    if (const Text problem = problemOf(place, programs()); !problem.empty()) QSKIP(problem.str().c_str());
    QTemporaryDir folder;
    JobRun run(folder, place);
    QVERIFY(run.givesTheSame());
    QCOMPARE(run.threadsOfRanks, (std::vector<int>{2, 2}));

    // A job that is cancelled has left the queue when the run ends.
    const auto queue = [] { return runChild({"squeue", "--noheader", "--name", "footfall-5"}, {}).output; };
    RunPrograms asleep = programs();
    asleep.footfallMpi = script(folder, "footfall-mpi", "exec sleep 60\n");
    QVERIFY(QDir(folder.path()).mkdir("footfall-5"));
    std::size_t seen = 0;
    const auto poll = [&] {
      seen = std::max(seen, queue().size());
      if (seen > 0) throw Cancelled();
    };
    QVERIFY_EXCEPTION_THROWN(runJob(folder.filePath("footfall-5").toStdString(), place, asleep, 0, poll), Cancelled);
    QVERIFY(seen > 0);
    QCOMPARE(queue(), std::string());
  }
};

QTEST_GUILESS_MAIN(TestRunPlace)
#include "test_run_place.moc"
