// Files that are installed beside the programs are found there, else in the source tree.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "ui/base/files/installed_files.hpp"

using namespace footfall;
using namespace footfall::ui;

class TestInstalledFiles : public QObject {
  Q_OBJECT

 private slots:
  void samplesBesideTheProgramComeFirst() {
    const QTemporaryDir prefix;
    QVERIFY(QDir(prefix.path()).mkpath(QStringLiteral("share/footfall/samples")));
    QCOMPARE(samplesFolder(prefix.filePath(QStringLiteral("bin"))),
             prefix.filePath(QStringLiteral("share/footfall/samples")));
  }

  void aBuildTreeTakesThoseOfTheSources() {
    QVERIFY(QFile::exists(samplesFolder() + QStringLiteral("/villa/villa.obj")));
    const QTemporaryDir empty;
    QCOMPARE(samplesFolder(empty.path()), samplesFolder());
  }
};

QTEST_GUILESS_MAIN(TestInstalledFiles)
#include "test_installed_files.moc"
