// Pipes as input and output, links, and what killed runs leave beside their targets.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QFileInfo>
#include <QProcess>
#include <QtTest>
#include <chrono>
#include <thread>

#include "core/io/export.hpp"
#include "core/io/pipe_output.hpp"
#include "core/io/stale_files.hpp"
#include "core/pipeline/pipeline_fragment.hpp"
#include "core/tiles/tile_folder.hpp"
#include "footfall/errors.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

std::string fifoIn(const TemporaryFolder& folder) {
  const std::string path = folder.path("fifo");
  if (mkfifo(path.c_str(), 0600) != 0) qFatal("no FIFO can be made");
  return path;
}

void pause(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

/// Cancels a context after a while.
class Canceller {
 public:
  explicit Canceller(RunContext& context)
      : thread_([&context] {
          pause(200);
          context.cancel();
        }) {}
  ~Canceller() { thread_.join(); }

 private:
  std::thread thread_;
};

const std::string kHouse = FOOTFALL_SOURCE_DIR "/samples/house/house.obj";

}  // namespace

class TestPipes : public QObject {
  Q_OBJECT
 private slots:
  void writingWaitsForAReaderAndCanBeCancelled() {
    const TemporaryFolder folder;
    const std::string path = fifoIn(folder);
    RunContext context;
    const Canceller canceller(context);
    QVERIFY_EXCEPTION_THROWN(writeFileSafely(path, "text", context), Cancelled);
  }

  void aFullPipeCanBeCancelled() {
    const TemporaryFolder folder;
    const std::string path = fifoIn(folder);
    const int reader = open(path.c_str(), O_RDONLY | O_NONBLOCK);
    RunContext context;
    const Canceller canceller(context);
    QVERIFY_EXCEPTION_THROWN(writeFileSafely(path, std::string(10 << 20, 'x'), context), Cancelled);
    close(reader);
  }

  void aSlowReaderGetsAll() {
    const TemporaryFolder folder;
    const std::string path = fifoIn(folder), text(3 << 20, 'x');
    std::string taken;
    std::thread reader([&] {
      pause(200);
      readFromPipe(path, 10 << 20, taken, {});
    });
    writeFileSafely(path, text);
    reader.join();
    QVERIFY(taken == text);
  }

  void aReaderThatGoesAwayIsAnErrorAndNoSignal() {
    const TemporaryFolder folder;
    const std::string path = fifoIn(folder);
    std::thread reader([&] {
      const int file = open(path.c_str(), O_RDONLY);
      pause(100);
      close(file);
    });
    const QString message = messageOf<RunError>([&] { writeFileSafely(path, std::string(10 << 20, 'x')); });
    reader.join();
    QVERIFY2(message.contains("closed by its reader"), qPrintable(message));
  }

  void aPipelineFromASlowWriterIsReadWhole() {
    const TemporaryFolder folder;
    const std::string path = fifoIn(folder);
    std::thread writer([&] {
      pause(300);
      const int file = open(path.c_str(), O_WRONLY);
      for (const char* piece : {"SlopeFilter ", "45\nVertical", "ClearanceFilter 2\n"}) {
        if (write(file, piece, strlen(piece)) < 0) qFatal("nothing reads");
        pause(400);
      }
      close(file);
    });
    const Pipeline pipeline = readPipeline(path, nullptr);
    writer.join();
    QCOMPARE(pipeline.steps.size(), std::size_t{2});
  }

  void waitingForAPipelineCanBeCancelled() {
    const TemporaryFolder folder;
    RunContext context;
    const Canceller canceller(context);
    QVERIFY_EXCEPTION_THROWN(readPipeline(fifoIn(folder), &context), Cancelled);
  }

  void signalsEndTheProgramThatWaitsForAReader() {
    const TemporaryFolder folder;
    const QString fifo = QString::fromStdString(fifoIn(folder));
    for (const int signal : {SIGINT, SIGTERM}) {
      QProcess program;
      program.start(FOOTFALL_PROGRAM, {"run", QString::fromStdString(kHouse), "-o", fifo});
      QVERIFY(program.waitForStarted());
      pause(3000);
      ::kill(static_cast<pid_t>(program.processId()), signal);
      QVERIFY(program.waitForFinished(30000));
      QVERIFY(program.exitStatus() == QProcess::NormalExit && program.exitCode() == 1);
    }
  }

  void aDanglingLinkStaysALink() {
    const TemporaryFolder folder;
    const std::string link = folder.path("link.obj");
    QVERIFY(symlink("target.obj", link.c_str()) == 0);
    writeFileSafely(link, "text");
    QVERIFY(QFileInfo(QString::fromStdString(link)).isSymLink());
    QCOMPARE(readAll(folder.path("target.obj")), QByteArray("text"));
  }

  void aLinkIntoNothingIsAnError() {
    const TemporaryFolder folder;
    const std::string link = folder.path("link.obj"), circle = folder.path("circle.obj");
    QVERIFY(symlink("none/target.obj", link.c_str()) == 0 && symlink("circle.obj", circle.c_str()) == 0);
    QVERIFY(messageOf<RunError>([&] { writeFileSafely(link, "text"); }).contains("does not exist"));
    QVERIFY(messageOf<RunError>([&] { writeFileSafely(circle, "text"); }).contains("circle"));
  }

  void whatDeadProcessesLeftIsRemoved() {
    const TemporaryFolder folder;
    const std::string mine = temporaryName(7);
    QStringList words = QString::fromStdString(mine).split('-');
    QCOMPARE(words.size(), 5);
    words[3] += "1";  // this process began at another time
    const QByteArray dead = words.join('-').toUtf8();
    words[1] = "0";
    const QByteArray elsewhere = words.join('-').toUtf8();
    for (const QByteArray& name : {QByteArray::fromStdString(mine), dead, elsewhere}) folder.write(name, "x");
    writeFileSafely(folder.path("a.obj"), "text");
    QStringList expected{"a.obj", QString::fromStdString(mine), elsewhere};
    expected.sort();
    QStringList found = folder.files();
    found.sort();
    QCOMPARE(found, expected);
  }

  void aFolderOfTilesWithLeftoversAloneIsTaken() {
    const TemporaryFolder folder;
    const std::string path = QFileInfo(QString::fromStdString(folder.path("x"))).path().toStdString();
    QVERIFY(!hasLeftoversOnly(path));
    folder.write(".footfall-17-0.tmp", "x");
    QVERIFY(hasLeftoversOnly(path));
    folder.write("notes.txt", "x");
    QVERIFY(!hasLeftoversOnly(path));
  }

  void emptyNamesAreNone() {
    for (const QString option : {"-o", "--stats", "--trace", "--report"}) {
      QProcess program;
      program.start(FOOTFALL_PROGRAM, {"run", QString::fromStdString(kHouse), option, ""});
      QVERIFY(program.waitForFinished(60000));
      QCOMPARE(program.exitCode(), 2);
      QVERIFY(program.readAllStandardError().contains("empty name"));
    }
  }

  void aClosedStandardOutputIsSaid() {
    // The reading end is closed before the program starts, so that no write can be in time.
    int ends[2];
    QCOMPARE(pipe(ends), 0);
    close(ends[0]);
    QProcess program;
    program.setChildProcessModifier([output = ends[1]] { dup2(output, STDOUT_FILENO); });
    program.start(FOOTFALL_PROGRAM, {"info", QString::fromStdString(kHouse)});
    QVERIFY(program.waitForFinished(60000));
    close(ends[1]);
    QCOMPARE(program.exitCode(), 1);
    QVERIFY(program.readAllStandardError().contains("standard output was closed"));
  }

  void tooFewDescriptorsAreNamed() {
    for (const int most : {4, 5, 6, 8, 10, 12}) {
      QProcess shell;
      shell.start("bash", {"-c", QString("ulimit -n %1; exec \"$0\" info \"$1\"").arg(most), FOOTFALL_PROGRAM,
                           QString::fromStdString(kHouse)});
      QVERIFY(shell.waitForFinished(60000));
      QVERIFY(!shell.readAllStandardError().contains("internal error"));
    }
  }
};

QTEST_GUILESS_MAIN(TestPipes)
#include "test_pipes.moc"
