// The number of threads of runs: a setting that is remembered, that runs follow, and that no result depends on.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QSettings>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/cells/cells_feature.hpp"
#include "ui/cells/load_panel.hpp"
#include "ui/run/run_threads.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

class TestRunThreads : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { QSettings().remove("threads"); }

  void choicesEndWithAllProcessors() {
    QCOMPARE(threadChoices(1), (std::vector<int>{1}));
    QCOMPARE(threadChoices(4), (std::vector<int>{1, 2, 3, 4}));
    QCOMPARE(threadChoices(12), (std::vector<int>{1, 2, 4, 8, 12}));
  }

  void theChoiceIsRemembered() {
    if (processorCount() < 2) QSKIP("there is nothing to choose on one processor");
    {
      RunThreads threads;
      QCOMPARE(threads.chosen(), 0);
      QCOMPARE(threads.count(), processorCount());
      threads.choose(1);
    }
    RunThreads again;
    QCOMPARE(again.chosen(), 1);
    QCOMPARE(again.count(), 1);
    again.choose(processorCount());
    QCOMPARE(RunThreads().chosen(), 0);
  }

  void runsFollowTheSettingAndTheirResultDoesNot() {
    if (processorCount() < 2) QSKIP("there is nothing to choose on one processor");
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1000, 800);
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "waves.obj", wavesObj(30)),
                    "GridStrategy 3 3\nSlopeFilter 30\nVerticalClearanceFilter 2\nCollapse\nLayerSubdivisionFilter\n"));
    QCOMPARE(window.controller().finishedRun()->result.threads, processorCount());
    const QByteArray all = exported(window, folder);
    QSignalSpy finished(&window.controller(), &RunController::finished);
    window.findChild<QAction*>("pipeline.threads.1")->trigger();
    QTRY_VERIFY(finished.count() > 0 && window.idle());
    QCOMPARE(window.controller().finishedRun()->result.threads, 1);
    QCOMPARE(partOf<CellsFeature>(window).model().threads(), 1);
    QCOMPARE(partOf<LoadPanel>(window).findChild<QComboBox*>("threads")->currentText(), QString("1 thread"));
    QCOMPARE(exported(window, folder), all);
  }

  void theLoadPanelHasTheChoiceToo() {
    if (processorCount() < 2) QSKIP("there is nothing to choose on one processor");
    EditorWindow window;
    auto* box = partOf<LoadPanel>(window).findChild<QComboBox*>("threads");
    QVERIFY(box);
    emit box->activated(0);
    QCOMPARE(partOf<CellsFeature>(window).threads().chosen(), 1);
    QVERIFY(window.findChild<QAction*>("pipeline.threads.1")->isChecked());
  }

 private:
  static QByteArray exported(EditorWindow& window, const QTemporaryDir& folder) {
    static int number = 0;
    const QString path = folder.filePath(QString("result%1.obj").arg(++number));
    QSignalSpy written(&window, &EditorWindow::written);
    window.exportResult(path);
    return written.count() > 0 || written.wait() ? readFile(path) : QByteArray();
  }
};

FOOTFALL_EDITOR_SUITE(TestRunThreads)
#include "test_run_threads.moc"
