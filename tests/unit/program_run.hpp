// Running the built program as a user does.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QProcess>
#include <QTest>

namespace footfall::test {

struct Outcome {
  int exitCode = -1;
  bool crashed = false;
  QByteArray out;
  QByteArray err;
};

/// `footfall ARGUMENTS...` with nothing on its standard input; killed after two minutes.
inline Outcome runProgram(const QStringList& arguments) {
  QProcess process;
  process.start(FOOTFALL_PROGRAM, arguments);
  process.closeWriteChannel();
  Outcome outcome;
  if (!process.waitForFinished(120000)) {
    process.kill();
    process.waitForFinished();
  }
  outcome.crashed = process.exitStatus() != QProcess::NormalExit;
  outcome.exitCode = process.exitCode();
  outcome.out = process.readAllStandardOutput();
  outcome.err = process.readAllStandardError();
  return outcome;
}

/// Empty when the file cannot be read.
inline QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline void write(const QString& path, const QByteArray& content) {
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  QCOMPARE(file.write(content), content.size());
}

}  // namespace footfall::test
