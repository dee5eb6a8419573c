// The places where runs are computed: the choice, the session, runs by several processes, failing and cancelling.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QPushButton>
#include <algorithm>
#include <array>
#include <functional>
#include <optional>

#include "footfall/errors.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/commands/translations.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/cells/cell_legend.hpp"
#include "ui/cells/cells_feature.hpp"
#include "ui/cells/load_panel.hpp"
#include "ui/cells/run_place_dialog.hpp"
#include "ui/run/run_places.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline =
    "GridStrategy 3 3\nSlopeFilter 30\nVerticalClearanceFilter 2\nCollapse\nLayerSubdivisionFilter\n";

RunPlace processes(int count) {
  RunPlace place;
  place.kind = RunPlace::Kind::Processes;
  place.processes = count;
  return place;
}

RunPlace hostsIn(const QTemporaryDir& folder, int count) {
  RunPlace place = processes(count);
  place.kind = RunPlace::Kind::Hosts;
  place.hostFile = writeFile(folder, "hosts", "localhost\n").toStdString();
  place.folder = folder.path().toStdString();
  return place;
}

/// A program in place of mpirun.
void setMpirun(const QTemporaryDir& folder, const QByteArray& text) {
  const QString path = writeFile(folder, "mpirun", "#!/bin/sh\n" + text);
  QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  qputenv("FOOTFALL_MPIRUN", path.toUtf8());
  qputenv("FOOTFALL_MPI", path.toUtf8());
}

/// One in place of mpirun that fails, and how often it was started.
void setFailingMpirun(const QTemporaryDir& folder) {
  setMpirun(folder, "echo run >>'" + folder.filePath("runs").toUtf8() + "'\nexit 1\n");
}
qsizetype runsStarted(const QTemporaryDir& folder) { return readFile(folder.filePath("runs")).count('\n'); }

/// Does something that makes a run, and waits until it has failed.
bool failsAfter(EditorWindow& window, const std::function<void()>& change) {
  QSignalSpy failed(&window.controller(), &RunController::failed);
  change();
  return QTest::qWaitFor([&] { return window.idle() && failed.count() > 0; }, 60000);
}

/// The entries that are checked in the menu.
QStringList checkedPlaces(EditorWindow& window) {
  QStringList checked;
  for (const char* place : {"this_program", "processes", "hosts", "slurm"})
    if (window.findChild<QAction*>(QStringLiteral("pipeline.runOn.") + place)->isChecked()) checked << place;
  return checked;
}

QByteArray exported(EditorWindow& window, const QTemporaryDir& folder) {
  static int number = 0;
  const QString path = folder.filePath(QString("result%1.obj").arg(++number));
  QSignalSpy written(&window, &EditorWindow::written);
  window.exportResult(path);
  return written.count() > 0 || written.wait() ? readFile(path) : QByteArray();
}

QStringList jobsLeft() { return QDir(QDir::tempPath()).entryList({"footfall-????????????"}, QDir::Dirs); }

}  // namespace

class TestRunPlaces : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { qputenv("TMPDIR", temporary_.path().toUtf8()); }
  void cleanup() {
    qunsetenv("FOOTFALL_MPI");
    qunsetenv("FOOTFALL_MPIRUN");
  }

  void theSessionKeepsTheChoice() {
    RunPlaces places;
    QSignalSpy changed(&places, &RunPlaces::changed);
    RunPlace hosts = processes(12);
    hosts.kind = RunPlace::Kind::Hosts;
    hosts.hostFile = "/jobs/hosts";
    hosts.folder = "/jobs";
    RunPlace slurm = processes(8);
    slurm.kind = RunPlace::Kind::Slurm;
    slurm.partition = "long";
    slurm.folder = "/jobs";
    for (const RunPlace& place : {processes(2), hosts, slurm, RunPlace()}) {
      places.choose(place);
      RunPlaces again;
      again.load(places.save());
      // Other machines are used only when the user chooses them, and the suggestion is kept until then.
      const bool isHere = place.kind == RunPlace::Kind::ThisProcess || place.kind == RunPlace::Kind::Processes;
      QVERIFY(again.chosen() == (isHere ? place : RunPlace()));
      QVERIFY(again.suggested() == (isHere ? std::nullopt : std::optional(place)));
      QCOMPARE(again.save(), places.save());
      again.choose(place);
      QVERIFY(again.chosen() == place && !again.suggested());
      again.load(places.save());
      QVERIFY(again.chosen() == place);
    }
    QCOMPARE(changed.count(), 4);
    places.choose(slurm);
    places.load({});
    QVERIFY(places.chosen() == RunPlace());
    for (const char* wrong :
         {"{}", R"({"on":"moon"})", R"({"on":"processes","processes":0})", R"({"on":"processes","processes":1025})",
          R"({"on":"processes","processes":4294967298})", R"({"on":"processes","processes":18446744073709551618})",
          R"({"on":"processes","processes":2.5})", R"({"on":"processes","processes":"2"})", "nonsense"})
      QVERIFY_EXCEPTION_THROWN(places.load(wrong), std::exception);
    QVERIFY(places.chosen() == RunPlace());
  }

  void aSuggestionThatIsDroppedIsTold() {
    const QTemporaryDir folder;
    RunPlaces far, places;
    far.choose(hostsIn(folder, 3));
    QSignalSpy changed(&places, &RunPlaces::changed);
    places.load(far.save());
    QCOMPARE(changed.count(), 1);
    places.choose({});
    QVERIFY(!places.suggested());
    QCOMPARE(changed.count(), 2);
    places.choose(processes(2));
    places.forgetSuggestion();
    QVERIFY(places.chosen() == processes(2));
    QCOMPARE(changed.count(), 3);
  }

  void openingASessionStartsNobodyElsewhere() {
    const QTemporaryDir folder;
    setFailingMpirun(folder);
    const QString level = writeFile(folder, "waves.obj", wavesObj(10)), session = folder.filePath("far.footfall");
    const RunPlace far = hostsIn(folder, 3);
    {
      EditorWindow window;
      QVERIFY(showWindow(window));
      QVERIFY(openZUp(window, level, kPipeline));
      QVERIFY(failsAfter(window, [&] { partOf<CellsFeature>(window).places().choose(far); }));
      window.saveSession(session);
      QVERIFY(waitUntilIdle(window));
    }
    QCOMPARE(runsStarted(folder), 1);
    EditorWindow window;
    window.setRemembering(false);
    QVERIFY(showWindow(window));
    window.open(session);
    QVERIFY(waitUntilIdle(window) && window.controller().upToDate());
    QVERIFY(partOf<CellsFeature>(window).places().chosen() == RunPlace());
    QVERIFY(partOf<CellsFeature>(window).places().suggested() == far);
    QCOMPARE(runsStarted(folder), 1);

    // Another level has nothing to do with it.
    QVERIFY(openZUp(window, level, kPipeline));
    QVERIFY(!partOf<CellsFeature>(window).places().suggested());
    QCOMPARE(partOf<CellsFeature>(window).places().save(), RunPlaces().save());

    window.open(session);
    QVERIFY(waitUntilIdle(window) && partOf<CellsFeature>(window).places().suggested() == far);
    const QList<QPushButton*> buttons = partOf<MessageBar>(window).findChildren<QPushButton*>();
    const auto again = std::ranges::find(buttons, QString("Run there again"), &QPushButton::text);
    QVERIFY(again != buttons.end() && (*again)->isVisible());
    QVERIFY(failsAfter(window, [&] { QTest::mouseClick(*again, Qt::LeftButton); }));
    QVERIFY(partOf<CellsFeature>(window).places().chosen() == far &&
            !partOf<CellsFeature>(window).places().suggested());
    QCOMPARE(runsStarted(folder), 2);
  }

  // Nothing runs on the earlier level while another one is opened with its filters and its place.
  void theLevelBeforeIsNotRun() {
    const QTemporaryDir folder;
    setFailingMpirun(folder);
    const QString first = writeFile(folder, "first.obj", wavesObj(10));
    const QString session = folder.filePath("second.footfall");
    EditorWindow window;
    window.setRemembering(false);
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "second.obj", wavesObj(11)), kPipeline));
    QVERIFY(failsAfter(window, [&] { partOf<CellsFeature>(window).places().choose(processes(2)); }));
    window.saveSession(session);
    QVERIFY(waitUntilIdle(window));
    QCOMPARE(runsStarted(folder), 1);

    std::shared_ptr<const Environment> before;
    int ofBefore = 0;
    const auto look = [&] { ofBefore += window.controller().busy() && window.controller().environment() == before; };
    connect(&partOf<Document>(window), &Document::filtersChanged, &window, look);
    connect(&partOf<CellsFeature>(window).places(), &RunPlaces::changed, &window, look);
    before = partOf<LevelComposer>(window).level();
    QVERIFY(failsAfter(window, [&] {
      ImportOptions import;
      import.up = UpAxis::Z;
      window.openWith(first, parsePipeline(std::string(kPipeline) + "AreaFilter 0.5\n", "test"), import);
    }));
    QCOMPARE(runsStarted(folder), 2);
    before = nullptr;
    partOf<CellsFeature>(window).places().choose({});
    QVERIFY(waitUntilIdle(window) && window.controller().upToDate());
    before = partOf<LevelComposer>(window).level();
    QVERIFY(failsAfter(window, [&] { window.open(session); }));
    QVERIFY(partOf<CellsFeature>(window).places().chosen() == processes(2));
    QCOMPARE(runsStarted(folder), 3);
    QCOMPARE(ofBefore, 0);
  }

  void theDialogAsksForWhatIsNeeded() {
    const QTemporaryDir folder;
    setMpirun(folder, "exit 0\n");
    RunPlaceDialog here(processes(4));
    QVERIFY(here.place() == processes(4));
    QVERIFY(here.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
    RunPlace hosts = processes(4);
    hosts.kind = RunPlace::Kind::Hosts;
    hosts.hostFile = folder.filePath("none").toStdString();
    hosts.folder = folder.path().toStdString();
    RunPlaceDialog list(hosts);
    QVERIFY(!list.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
    QVERIFY(list.findChild<QLabel*>("problem")->text().contains("host file cannot be read"));
    const QString file = writeFile(folder, "hosts.txt", "localhost\n");
    for (QLineEdit* field : list.findChildren<QLineEdit*>())
      if (field->text() == QString::fromStdString(hosts.hostFile)) field->setText(file);
    QVERIFY(list.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
    QCOMPARE(list.place().hostFile, file.toStdString());
    shoot(list, "run_place_hosts");
  }

  void menuAndPanelShowTheChoice() {
    EditorWindow window;
    auto* box = partOf<LoadPanel>(window).findChild<QComboBox*>("runOn");
    QVERIFY(box);
    QCOMPARE(box->currentText(), QString("This program"));
    partOf<CellsFeature>(window).places().choose(processes(3));
    QCOMPARE(box->currentText(), placeText(processes(3)));
    QVERIFY(window.findChild<QAction*>("pipeline.runOn.processes")->isChecked());
    emit box->activated(0);
    QVERIFY(partOf<CellsFeature>(window).places().chosen() == RunPlace());
    QVERIFY(window.findChild<QAction*>("pipeline.runOn.this_program")->isChecked());
  }

  // Whatever becomes of the question.
  void theMenuShowsTheChoiceAtAllTimes() {
    const QTemporaryDir folder;
    setFailingMpirun(folder);
    EditorWindow window;
    QVERIFY(showWindow(window));
    const auto answer = [&](const char* place, bool accepts) {
      window.findChild<QAction*>(QStringLiteral("pipeline.runOn.") + place)->trigger();
      const QStringList asked = checkedPlaces(window);
      auto* dialog = window.findChild<RunPlaceDialog*>();
      if (dialog == nullptr) return QStringList{"no dialog"};
      dialog->done(accepts ? QDialog::Accepted : QDialog::Rejected);
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
      return asked + checkedPlaces(window);
    };
    QCOMPARE(checkedPlaces(window), QStringList{"this_program"});
    for (const char* place : {"slurm", "hosts", "processes"})
      QCOMPARE(answer(place, false), (QStringList{"this_program", "this_program"}));
    QCOMPARE(answer("processes", true), (QStringList{"this_program", "processes"}));
    QCOMPARE(answer("processes", true), (QStringList{"processes", "processes"}));
    QCOMPARE(answer("slurm", false), (QStringList{"processes", "processes"}));
    window.findChild<QAction*>("pipeline.runOn.this_program")->trigger();
    QCOMPARE(checkedPlaces(window), QStringList{"this_program"});
    QVERIFY(partOf<CellsFeature>(window).places().chosen() == RunPlace());
  }

  // A run by mpirun, if installed: the same bytes, and cells by rank.
  void processesGiveTheSameResult() {
    qputenv("FOOTFALL_MPI", (QCoreApplication::applicationDirPath() + "/../footfall-mpi").toUtf8());
    if (const Text problem = problemOf(processes(2), runPrograms()); !problem.empty()) QSKIP(problem.str().c_str());
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1280, 900);
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "waves.obj", wavesObj(30)), kPipeline));
    const QByteArray all = exported(window, folder);
    for (const char* shown : {"view.cells", "view.load"}) window.findChild<QAction*>(shown)->trigger();
    QSignalSpy finished(&window.controller(), &RunController::finished);
    partOf<CellsFeature>(window).places().choose(processes(2));
    QVERIFY(QTest::qWaitFor([&] { return finished.count() > 0 && window.idle(); }, 60000));
    const std::vector<int> threads = window.controller().finishedRun()->ranks.threads;
    QCOMPARE(threads.size(), std::size_t{2});
    const CellBlock& block = *partOf<CellsFeature>(window).model().shownBlock();
    QVERIFY(block.complete());
    QCOMPARE(block.busyMsOfRanks().size(), std::size_t{2});
    for (const CellReport& cell : block.report.cells) QVERIFY(block.ranks.placeOf(cell.thread).rank >= 0);
    QVERIFY(partOf<LoadPanel>(window).figuresText().contains("2 rank"));
    QVERIFY(partOf<CellsFeature>(window).model().describe({0, 0}).contains("rank"));
    QCOMPARE(partOf<CellLegend>(window).findChild<QComboBox*>()->itemText(0), QString("Colours: Rank"));
    shoot(window, "run_on_processes");
    QCOMPARE(exported(window, folder), all);
    QVERIFY(jobsLeft().isEmpty());

    // The filters behind the block run here; the block stays.
    QSignalSpy again(&window.controller(), &RunController::finished);
    partOf<Document>(window).removeFilter(partOf<Document>(window).filters().back().id);
    QVERIFY(QTest::qWaitFor([&] { return again.count() > 0 && window.idle(); }, 60000));
    QCOMPARE(window.controller().finishedRun()->ranks.threads, std::vector<int>());
    QCOMPARE(partOf<CellsFeature>(window).model().shownBlock()->ranks.threads, threads);
  }

  void aFailureLeavesTheLastResult() {
    const QTemporaryDir folder;
    EditorWindow window;
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "waves.obj", wavesObj(10)), kPipeline));
    const auto before = window.controller().finishedRun();
    setMpirun(folder, "echo 'footfall-mpi: rank 1: memory ran out' >&2\nexit 1\n");
    QSignalSpy failed(&window.controller(), &RunController::failed);
    partOf<CellsFeature>(window).places().choose(processes(2));
    QVERIFY(QTest::qWaitFor([&] { return window.idle() && failed.count() > 0; }, 60000));
    QCOMPARE(failed.count(), 1);
    QVERIFY2(failed[0][0].toString().contains("rank 1: memory ran out"), qPrintable(failed[0][0].toString()));
    QVERIFY(window.controller().finishedRun() == before);
    QVERIFY(!window.view().content().walkable.empty());
    QVERIFY(jobsLeft().isEmpty());
    QSignalSpy finished(&window.controller(), &RunController::finished);
    partOf<CellsFeature>(window).places().choose({});
    QVERIFY(QTest::qWaitFor([&] { return window.idle() && finished.count() > 0; }, 60000));
    QVERIFY(window.controller().upToDate());
  }

  void cancellingEndsTheProcesses() {
    const QTemporaryDir folder;
    EditorWindow window;
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "waves.obj", wavesObj(10)), kPipeline));
    setMpirun(folder, "echo $$ >'" + folder.filePath("pid").toUtf8() + "'\nexec sleep 60\n");
    partOf<CellsFeature>(window).places().choose(processes(2));
    QVERIFY(QTest::qWaitFor([&] { return !readFile(folder.filePath("pid")).isEmpty(); }, 60000));
    const QString process = "/proc/" + readFile(folder.filePath("pid")).trimmed();
    QVERIFY(QFile::exists(process));
    window.controller().cancel();
    QVERIFY(QTest::qWaitFor([&] { return !QFile::exists(process) && jobsLeft().isEmpty(); }, 20000));
  }

  // Last, as what is translated stays so.
  void oneIsOne() {
    for (const auto& [language, one, three] : {std::array{"en", "1 process here", "3 processes here"},
                                               std::array{"de", "1 Prozess hier", "3 Prozesse hier"}}) {
      loadTranslations(language);
      QCOMPARE(placeText(processes(1)), QString(one));
      QCOMPARE(placeText(processes(3)), QString(three));
    }
  }

 private:
  const QTemporaryDir temporary_;  ///< folder for jobs, which others leave in the machine's, too
};

FOOTFALL_EDITOR_SUITE(TestRunPlaces)
#include "test_run_places.moc"
