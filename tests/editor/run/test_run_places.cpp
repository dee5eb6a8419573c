// Where runs are computed: the choice, the session, runs by several processes, failing and cancelling.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QPushButton>
#include <optional>

#include "footfall/errors.hpp"
#include "tests/editor/editor_driver.hpp"
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

/// A program in place of mpirun.
void setMpirun(const QTemporaryDir& folder, const QByteArray& text) {
  const QString path = writeFile(folder, "mpirun", "#!/bin/sh\n" + text);
  QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  qputenv("FOOTFALL_MPIRUN", path.toUtf8());
  qputenv("FOOTFALL_MPI", path.toUtf8());
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
      // Other machines are used when somebody says so, and are not forgotten until then.
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
    for (const char* wrong : {"{}", R"({"on":"moon"})", R"({"on":"processes","processes":0})", "nonsense"})
      QVERIFY_EXCEPTION_THROWN(places.load(wrong), std::exception);
    QVERIFY(places.chosen() == RunPlace());
  }

  void openingASessionStartsNobodyElsewhere() {
    EditorWindow window;
    QVERIFY(showWindow(window));
    const QTemporaryDir folder;
    setMpirun(folder, "echo $$ >'" + folder.filePath("pid").toUtf8() + "'\nexit 1\n");
    QVERIFY(openZUp(window, writeFile(folder, "waves.obj", wavesObj(10)), kPipeline));
    RunPlaces far;
    far.choose(processes(64));
    window.runPlaces().load(far.save());
    QVERIFY(waitUntilIdle(window));
    QVERIFY(window.runPlaces().chosen() == RunPlace());
    QVERIFY(!QFile::exists(folder.filePath("pid")));
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
    auto* box = window.loadPanel().findChild<QComboBox*>("runOn");
    QVERIFY(box);
    QCOMPARE(box->currentText(), QString("This program"));
    window.runPlaces().choose(processes(3));
    QCOMPARE(box->currentText(), QString("3 processes here"));
    QVERIFY(window.commands().find("pipeline.runOn.processes")->isChecked());
    emit box->activated(0);
    QVERIFY(window.runPlaces().chosen() == RunPlace());
    QVERIFY(window.commands().find("pipeline.runOn.this_program")->isChecked());
  }

  // By mpirun, where it is there: the same bytes, and cells by rank.
  void processesGiveTheSameResult() {
    qputenv("FOOTFALL_MPI", (QCoreApplication::applicationDirPath() + "/../footfall-mpi").toUtf8());
    if (const Text problem = problemOf(processes(2), runPrograms()); !problem.empty()) QSKIP(problem.str().c_str());
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1280, 900);
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "waves.obj", wavesObj(30)), kPipeline));
    const QByteArray all = exported(window, folder);
    for (const char* shown : {"view.cells", "view.load"}) window.commands().find(shown)->trigger();
    QSignalSpy finished(&window.controller(), &RunController::finished);
    window.runPlaces().choose(processes(2));
    QVERIFY(QTest::qWaitFor([&] { return finished.count() > 0 && window.idle(); }, 60000));
    const std::vector<int> threads = window.controller().finishedRun()->ranks.threads;
    QCOMPARE(threads.size(), std::size_t{2});
    const CellBlock& block = *window.cells().shownBlock();
    QVERIFY(block.complete());
    QCOMPARE(block.busyMsOfRanks().size(), std::size_t{2});
    for (const CellReport& cell : block.report.cells) QVERIFY(block.ranks.placeOf(cell.thread).rank >= 0);
    QVERIFY(window.loadPanel().figuresText().contains("2 rank"));
    QVERIFY(window.cells().describe({0, 0}).contains("rank"));
    QCOMPARE(window.cellLegend().findChild<QComboBox*>()->itemText(0), QString("Colours: Rank"));
    shoot(window, "run_on_processes");
    QCOMPARE(exported(window, folder), all);
    QVERIFY(jobsLeft().isEmpty());

    // What is behind the block is run here; the block is as it was.
    QSignalSpy again(&window.controller(), &RunController::finished);
    window.document().removeFilter(window.document().filters().back().id);
    QVERIFY(QTest::qWaitFor([&] { return again.count() > 0 && window.idle(); }, 60000));
    QCOMPARE(window.controller().finishedRun()->ranks.threads, std::vector<int>());
    QCOMPARE(window.cells().shownBlock()->ranks.threads, threads);
  }

  void aFailureLeavesTheLastResult() {
    const QTemporaryDir folder;
    EditorWindow window;
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "waves.obj", wavesObj(10)), kPipeline));
    const auto before = window.controller().finishedRun();
    setMpirun(folder, "echo 'footfall-mpi: rank 1: memory ran out' >&2\nexit 1\n");
    QSignalSpy failed(&window.controller(), &RunController::failed);
    window.runPlaces().choose(processes(2));
    QVERIFY(QTest::qWaitFor([&] { return window.idle() && failed.count() > 0; }, 60000));
    QCOMPARE(failed.count(), 1);
    QVERIFY2(failed[0][0].toString().contains("rank 1: memory ran out"), qPrintable(failed[0][0].toString()));
    QVERIFY(window.controller().finishedRun() == before);
    QVERIFY(!window.view().content().walkable.empty());
    QVERIFY(jobsLeft().isEmpty());
    QSignalSpy finished(&window.controller(), &RunController::finished);
    window.runPlaces().choose({});
    QVERIFY(QTest::qWaitFor([&] { return window.idle() && finished.count() > 0; }, 60000));
    QVERIFY(window.controller().upToDate());
  }

  void cancellingEndsTheProcesses() {
    const QTemporaryDir folder;
    EditorWindow window;
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "waves.obj", wavesObj(10)), kPipeline));
    setMpirun(folder, "echo $$ >'" + folder.filePath("pid").toUtf8() + "'\nexec sleep 60\n");
    window.runPlaces().choose(processes(2));
    QVERIFY(QTest::qWaitFor([&] { return !readFile(folder.filePath("pid")).isEmpty(); }, 60000));
    const QString process = "/proc/" + readFile(folder.filePath("pid")).trimmed();
    QVERIFY(QFile::exists(process));
    window.controller().cancel();
    QVERIFY(QTest::qWaitFor([&] { return !QFile::exists(process) && jobsLeft().isEmpty(); }, 20000));
  }
};

FOOTFALL_EDITOR_SUITE(TestRunPlaces)
#include "test_run_places.moc"
