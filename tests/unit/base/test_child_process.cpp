// Other programs: their output, their end, and that none of their children survives.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <string>

#include "core/base/child_process.hpp"
#include "core/base/process_usage.hpp"
#include "footfall/errors.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

ChildResult runShell(const std::string& text, Poll poll = {}, ChildEnding ending = ChildEnding::Killed,
                     double graceMs = kChildGraceMs) {
  return runChild({"sh", "-c", text}, poll, ending, graceMs);
}

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll().trimmed() : QByteArray();
}

/// A poll that cancels as soon as there is something in the file.
auto cancelsAfter(const QString& path) {
  return [path] {
    if (!contentOf(path).isEmpty()) throw Cancelled();
  };
}

/// True for a process that is over, also if its status was never read.
bool isGone(const QByteArray& id) {
  const QByteArray status = contentOf("/proc/" + id + "/stat");
  return status.isEmpty() || status.mid(status.lastIndexOf(')') + 2, 1) == "Z";
}

}  // namespace

class TestChildProcess : public QObject {
  Q_OBJECT

 private slots:
  void whatItWritesAndHowItEnds() {
    const ChildResult result = runShell("echo one; echo two >&2; exit 7");
    QCOMPARE(result.status, 7);
    QCOMPARE(result.output, std::string("one\n"));
    QCOMPARE(result.errors, std::string("two\n"));
    QCOMPARE(runShell("kill -9 $$").status, 137);
    QCOMPARE(runChild({"/none/at/all"}, {}).status, 127);
    QCOMPARE(runShell("cat").output, std::string());
    const ChildResult much = runShell("head -c 1000000 /dev/zero; head -c 1000000 /dev/zero >&2");
    QCOMPARE(much.output.size(), std::size_t{1000000});
    QCOMPARE(much.errors.size(), std::size_t{64 * 1024});
    // The program continues after closing its output.
    QCOMPARE(runShell("exec >&- 2>&-; sleep 0.2; exit 3").status, 3);
  }

  // A script that starts mpirun and waits for it: the signal has to reach what it has started.
  void thoseThatItStartedEndWithIt() {
    for (const ChildEnding ending : {ChildEnding::Killed, ChildEnding::Asked}) {
      const QTemporaryDir folder;
      const QString id = folder.filePath("id");
      QVERIFY_EXCEPTION_THROWN(
          runShell("sleep 60 & echo $! >'" + id.toStdString() + "'; wait", cancelsAfter(id), ending), Cancelled);
      QVERIFY(isGone(contentOf(id)));
    }
  }

  // A process that tidies up when it is terminated is waited for, though its parent has ended.
  void thoseThatItStartedMayTidyUp() {
    const QTemporaryDir folder;
    const QString id = folder.filePath("id"), tidy = folder.filePath("tidy");
    const std::string inner = "trap \"sleep 0.5; echo tidy >'" + tidy.toStdString() + "'; exit\" TERM; echo $$ >'" +
                              id.toStdString() + "'; while :; do sleep 0.05; done";
    QFile script(folder.filePath("inner"));
    QVERIFY(script.open(QIODevice::WriteOnly) && script.write(QByteArray::fromStdString(inner)) > 0);
    script.close();
    QVERIFY_EXCEPTION_THROWN(
        runShell("sh '" + script.fileName().toStdString() + "' & wait", cancelsAfter(id), ChildEnding::Asked),
        Cancelled);
    QCOMPARE(contentOf(tidy), QByteArray("tidy"));
    QVERIFY(isGone(contentOf(id)));
  }

  // More than a pipe holds.
  void whatItWritesAtTheEndDoesNotHoldIt() {
    const QTemporaryDir folder;
    const QString id = folder.filePath("id"), tidy = folder.filePath("tidy");
    QVERIFY_EXCEPTION_THROWN(
        runShell("trap \"head -c 1000000 /dev/zero; echo tidy >'" + tidy.toStdString() + "'; exit\" TERM; echo $$ >'" +
                     id.toStdString() + "'; while :; do sleep 0.05; done",
                 cancelsAfter(id), ChildEnding::Asked),
        Cancelled);
    QCOMPARE(contentOf(tidy), QByteArray("tidy"));
  }

  void whoDoesNotListenIsKilled() {
    const QTemporaryDir folder;
    const QString id = folder.filePath("id");
    const Stopwatch watch;
    QVERIFY_EXCEPTION_THROWN(runShell("trap '' TERM; echo $$ >'" + id.toStdString() + "'; while :; do sleep 1; done",
                                      cancelsAfter(id), ChildEnding::Asked, 700),
                             Cancelled);
    QVERIFY(isGone(contentOf(id)));
    QVERIFY(watch.wallMs() >= 700);
  }
};

QTEST_GUILESS_MAIN(TestChildProcess)
#include "test_child_process.moc"
