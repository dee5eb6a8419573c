// Agents: sizes that the filters follow, results that are there at once, a table to compare them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/agents/agent_edits.hpp"
#include "ui/agents/agents_panel.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/level/import_panel.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline =
    "DegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 0.5\nLayerSubdivisionFilter\n";

NamedAgent agentOf(const char* name, double height, double slope) { return {0, name, height, slope}; }

}  // namespace

class TestAgents : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
    panel_ = window_->findChild<AgentsPanel*>();
    QVERIFY(panel_);
  }
  void cleanup() { window_.reset(); }

  void theFiltersFollowTheActiveAgent() {
    open();
    addPreset("Human");
    addPreset("Wheelchair");
    QCOMPARE(document().state().agents.size(), std::size_t{2});
    QCOMPARE(slope(), 5.0);
    QCOMPARE(clearance(), 1.5);
    QTest::keyClick(window_.get(), Qt::Key_1, Qt::AltModifier);
    QCOMPARE(slope(), 45.0);
    QCOMPARE(clearance(), 2.0);
    QCOMPARE(document().undoStack()->undoText(), QString("Switch to agent Human"));
    QTest::keyClick(window_.get(), Qt::Key_2, Qt::AltModifier);
    QTest::keyClick(window_.get(), Qt::Key_1, Qt::AltModifier);
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);  // all switches are one edit
    QCOMPARE(slope(), 5.0);
    QCOMPARE(activeAgent(document().state())->name, std::string("Wheelchair"));
  }

  void clicksAndKeysInTheTableSwitch() {
    open();
    addPreset("Human");
    addPreset("Child");
    QTableView* table = panel_->table();
    QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier,
                      table->visualRect(table->model()->index(0, 0)).center());
    QCOMPARE(clearance(), 2.0);
    table->setFocus();
    QTest::keyClick(table, Qt::Key_Down);
    QCOMPARE(clearance(), 1.2);
    QTest::keyClick(window_.get(), Qt::Key_0, Qt::AltModifier);
    QCOMPARE(document().state().agent, 0);
    QCOMPARE(clearance(), 1.2);
    QVERIFY(!table->selectionModel()->hasSelection());
  }

  void editingARowEditsItsAgent() {
    open();
    addPreset("Human");
    const int count = document().undoStack()->count();
    auto* field = openField(*window_, 1);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "30");
    QCOMPARE(document().state().agents[0].maxSlope, 30.0);
    QCOMPARE(document().undoStack()->count(), count + 1);
    QCOMPARE(document().undoStack()->undoText(), QString::fromUtf8("Change maximum slope 45° → 30°"));
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(document().state().agents[0].maxSlope, 45.0);
    QCOMPARE(slope(), 45.0);
    // A row does not activate anything without an active agent.
    panel_->letGo();
    document().setValue(document().filters()[1].id, 0, 20, 9);
    QCOMPARE(document().state().agents[0].maxSlope, 45.0);
  }

  void allStepsFollowAndForeignValuesLetGo() {
    open();
    addPreset("Child");
    document().addFilter(filterDescriptor(FilterType::VerticalClearance), 1);
    QCOMPARE(document().filters().back().step.values[0], 1.2);
    QVERIFY(document().state().agent != 0);
    document().setValue(document().filters()[2].id, 0, 1.3, 1);
    QCOMPARE(document().filters().back().step.values[0], 1.3);
    document().replacePipeline(parsePipeline("SlopeFilter 12\n", "test"), "test");
    QCOMPARE(document().state().agent, 0);
    QCOMPARE(document().filters()[0].step.values[0], 12.0);
    document().undoStack()->undo();
    QVERIFY(document().state().agent != 0);
  }

  void cellsAreTypedInto() {
    open();
    addPreset("Human");
    QTableView* table = panel_->table();
    QCOMPARE(filterNames(*window_)[4], QString("RadiusFilter"));
    typeInto(AgentModel::Radius, "0.4");
    QCOMPARE(document().state().agents[0].radius, 0.4);
    QCOMPARE(document().filters()[4].step.values, (std::vector<double>{0.4, 0.4, 0.01}));
    typeInto(AgentModel::Radius, "0");
    QVERIFY(!filterNames(*window_).contains("RadiusFilter"));
    typeInto(AgentModel::Height, "1.75");
    QCOMPARE(document().state().agents[0].height, 1.75);
    QCOMPARE(clearance(), 1.75);
    QCOMPARE(document().undoStack()->undoText(), QString::fromUtf8("Change height of Human 2 → 1.75"));
    typeInto(AgentModel::Step, "0.3");
    QCOMPARE(document().state().agents[0].step, 0.3);
    QCOMPARE(filterNames(*window_)[3], QString("StepFilter"));
    QCOMPARE(document().filters()[3].step.values[0], 0.3);
    typeInto(AgentModel::Step, "0");
    QVERIFY(!filterNames(*window_).contains("StepFilter"));
    QVERIFY(document().state().agent != 0);
    typeInto(AgentModel::Step, "-1");
    QVERIFY2(partOf<MessageBar>(*window_).text().contains("-1 is out of range"),
             qPrintable(partOf<MessageBar>(*window_).text()));
    QCOMPARE(document().state().agents[0].step, 0.0);
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(filterNames(*window_)[3], QString("StepFilter"));
    typeInto(AgentModel::Drop, "1.5");
    QCOMPARE(document().state().agents[0].drop, 1.5);
    QCOMPARE(filterNames(*window_).count("DropFilter"), 1);
    typeInto(AgentModel::Drop, "0");
    QVERIFY(!filterNames(*window_).contains("DropFilter"));
    typeInto(AgentModel::Name, "Tall, \"old\" human");
    QCOMPARE(QString::fromStdString(document().state().agents[0].name), QString("Tall, \"old\" human"));
    typeInto(AgentModel::MaxSlope, "95");
    QCOMPARE(slope(), 45.0);
    QVERIFY2(partOf<MessageBar>(*window_).text().contains("95 is out of range"),
             qPrintable(partOf<MessageBar>(*window_).text()));
    QVERIFY(table->isVisible());
  }

  void duplicatingAndRemoving() {
    open();
    addPreset("Cart");
    QTest::mouseClick(button("duplicateAgent"), Qt::LeftButton);
    QCOMPARE(document().state().agents[1].name, std::string("Cart 2"));
    QCOMPARE(document().state().agent, document().state().agents[1].id);
    QTest::mouseClick(button("removeAgent"), Qt::LeftButton);
    QCOMPARE(document().state().agents.size(), std::size_t{1});
    QCOMPARE(document().state().agent, 0);
    QCOMPARE(slope(), 10.0);
    QVERIFY(!button("removeAgent")->isEnabled());
    panel_->addButton()->menu()->findChild<QAction*>("agentOfFilters")->trigger();
    QCOMPARE(document().state().agents[1], (NamedAgent{2, "Agent", 1.2, 10, 0.013, 0.013, 0.3}));
    document().removeFilter(document().filters()[3].id);
    panel_->addButton()->menu()->findChild<QAction*>("agentOfFilters")->trigger();
    QCOMPARE(document().state().agents[2], (NamedAgent{3, "Agent 2", 1.2, 10, 0, 0.05, 0.3}));
  }

  void missingFiltersAreToldAndAdded() {
    open();
    addPreset("Human");
    document().setEnabled(document().filters()[1].id, false);
    QVERIFY2(panel_->hintText().contains("'Slope'"), qPrintable(panel_->hintText()));
    document().removeFilter(document().filters()[2].id);
    QVERIFY(panel_->hintText().contains("'Vertical clearance'"));
    QTest::mouseClick(panel_->hintButton(), Qt::LeftButton);
    QVERIFY(sizesWithoutEffect(document().state()).empty());
    QVERIFY(!panel_->hintButton()->isVisible());
    QCOMPARE(filterNames(*window_).front(), QString("VerticalClearanceFilter"));
    QVERIFY(document().state().agent != 0);
  }

  void heightsStayTheSameInMetres() {
    open();
    addPreset("Human");
    auto* scale = partOf<ImportPanel>(*window_).scaleField();
    scale->setFocus();
    scale->selectAll();
    QTest::keyClicks(scale, "0.05");
    QCOMPARE(document().state().agents[0].height, 40.0);
    QCOMPARE(clearance(), 40.0);
    QCOMPARE(document().state().agents[0].step, 4.4);
    QCOMPARE(document().filters()[3].step.values[0], 4.4);
    QVERIFY(document().state().agent != 0);
    addPreset("Crawler");
    QCOMPARE(clearance(), 10.0);
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(scale, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(document().state().agents[0].height, 2.0);
    QCOMPARE(clearance(), 2.0);
  }

  void allAreComputedInTheBackgroundAndCompared() {
    open();
    for (const char* name : {"Human", "Child", "Crawler"}) {
      addPreset(name);
      resizeAgent(document(), document().state().agent, AgentSize::Radius, 0);
    }
    QVERIFY(waitUntilIdle(*window_));
    panel_->letGo();
    QSignalSpy ahead(&window_->controller(), &RunController::aheadChanged);
    QTest::mouseClick(button("computeAgents"), Qt::LeftButton);
    QTRY_VERIFY(!ahead.isEmpty() && ahead.last()[0] == ahead.last()[1]);
    for (int row = 0; row < 3; ++row) {
      QTRY_VERIFY(panel_->results().figures(panel_->model().agentAt(row)).has_value());
      QVERIFY(panel_->results().ready(panel_->model().agentAt(row)));
    }
    // Only the crawler fits under the table (1 high); the ramp (60 degrees) is its limit, too.
    const auto human = *panel_->results().figures(panel_->model().agentAt(0));
    const auto crawler = *panel_->results().figures(panel_->model().agentAt(2));
    QCOMPARE(human.area, 64.0);  // floor without what is under the table, and the table
    QVERIFY(crawler.area > 67.9);
    QCOMPARE(human.components, std::size_t{2});
    QVERIFY(crawler.components >= 2);
    QVERIFY(human.layers >= 1);

    button("copyAgents")->menu()->findChild<QAction*>("copyCsv")->trigger();
    const QStringList csv = QApplication::clipboard()->text().split("\r\n");
    QCOMPARE(csv[0], QString::fromUtf8("Agent,Height (units),Slope (°),Step (units),Gap (units),Radius (units),"
                                       "Drop (units),Area (units²),Layers,Components,Connections"));
    QVERIFY2(csv[1].startsWith("Human,2,45,0.22,0.05,0,0,64.00,"), qPrintable(csv[1]));
    button("copyAgents")->menu()->findChild<QAction*>("copyText")->trigger();
    const QStringList text = QApplication::clipboard()->text().split('\n');
    QVERIFY(text[0].startsWith("Agent") && text[0].size() == text[1].size());
  }

  void switchingBackIsInstant() {
    // About 60,000 triangles.
    window_->openWith(writeFile(*folder_, "waves.obj", wavesObj(173)), parsePipeline(kPipeline, "test"), zUp());
    QVERIFY(QTest::qWaitFor([&] { return window_->file().environment() && window_->idle(); }, 120000));
    addAgent(document(), agentOf("low", 1, 50));
    QVERIFY(QTest::qWaitFor([&] { return window_->controller().upToDate(); }, 120000));
    addAgent(document(), agentOf("steep", 2, 30));
    QVERIFY(QTest::qWaitFor([&] { return window_->controller().upToDate(); }, 120000));
    QTest::qWait(300);
    const QSignalSpy started(&window_->controller(), &RunController::started);
    double slowest = 0;
    for (int i = 0; i < 6; ++i) {
      bool drawn = false;
      const auto frame = connect(&window_->view(), &QOpenGLWidget::frameSwapped, this, [&] { drawn = true; });
      QElapsedTimer clock;
      clock.start();
      panel_->activate(i % 2);
      QVERIFY(window_->controller().upToDate());  // true at once
      const double shown = static_cast<double>(clock.nsecsElapsed()) / 1e6;
      QTRY_VERIFY(drawn);
      disconnect(frame);
      qInfo("switch %.1f ms, to the picture %.1f ms", shown, static_cast<double>(clock.nsecsElapsed()) / 1e6);
      slowest = std::max(slowest, shown);
    }
    QCOMPARE(started.count(), 0);
    QVERIFY(slowest < 500);
    const FinishedRuns& known = window_->controller().finishedRuns();
    qInfo("%zu results take %.1f of at most %.0f MiB", known.count(), known.bytes() / 1048576.0,
          FinishedRuns::kBytes / 1048576.0);
    QVERIFY(known.bytes() <= FinishedRuns::kBytes);
  }

  void resultsAreBoundedByMemory() {
    FinishedRuns runs(10000);
    const auto run = [](std::size_t triangles) {
      auto made = std::make_shared<FinishedRun>();
      auto mesh = std::make_shared<NavigationMesh>();
      mesh->triangles.resize(triangles);
      made->result.mesh = mesh;
      return made;
    };
    runs.store("a", run(300), {});
    runs.store("b", run(300), {});
    QVERIFY(runs.find("a"));
    runs.store("c", run(300), {});  // 3 times 3600 bytes are too many
    QVERIFY(runs.find("a") && runs.find("c") && !runs.find("b"));
    QCOMPARE(runs.bytes(), std::size_t{7200});
    runs.store("large", run(1000), {});
    QVERIFY(!runs.peek("large") && runs.peek("a"));
    runs.store("a", run(10), {});
    QCOMPARE(runs.bytes(), std::size_t{3720});
  }

  void sessionsCarryAgents() {
    open();
    addPreset("Human");
    addPreset("Wheelchair");
    const QString path = folder_->filePath("a.footfall");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(path);
    QVERIFY(written.count() > 0 || written.wait());
    EditorWindow other;
    QVERIFY(showWindow(other));
    other.open(path);
    QVERIFY(QTest::qWaitFor([&] { return other.file().environment() != nullptr; }));
    QVERIFY(waitUntilIdle(other));
    QCOMPARE(partOf<Document>(other).state().agents.size(), std::size_t{2});
    QCOMPARE(activeAgent(partOf<Document>(other).state())->name, std::string("Wheelchair"));
    QCOMPARE(activeAgent(partOf<Document>(other).state())->step, 0.013);
    QCOMPARE(other.findChild<AgentsPanel*>()->table()->currentIndex().row(), 1);
  }

 private:
  static ImportOptions zUp() {
    ImportOptions options;
    options.up = UpAxis::Z;
    return options;
  }
  void open() {
    QVERIFY(openZUp(*window_, writeFile(*folder_, "table.obj", tableObj()), kPipeline));
    window_->findChild<QAction*>("panel.agents")->trigger();
    QVERIFY(QTest::qWaitFor([&] { return panel_->isVisible(); }));
  }
  void addPreset(const char* name) {
    for (QAction* action : panel_->addButton()->menu()->actions()) {
      if (action->data() == QVariant(name)) {
        action->trigger();
        return;
      }
    }
    QFAIL(name);
  }
  void typeInto(int column, const char* text) {
    QTableView* table = panel_->table();
    const QModelIndex index = table->model()->index(0, column);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, table->visualRect(index).center());
    table->setFocus();
    QTest::keyClick(table, Qt::Key_F2);
    auto* editor = table->viewport()->findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor, text);
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_VERIFY(!table->viewport()->findChild<QLineEdit*>());
  }
  QToolButton* button(const char* name) { return panel_->findChild<QToolButton*>(name); }
  Document& document() { return partOf<Document>(*window_); }
  double slope() { return document().filters()[1].step.values[0]; }
  double clearance() { return document().filters()[2].step.values[0]; }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
  AgentsPanel* panel_ = nullptr;
};

FOOTFALL_EDITOR_SUITE(TestAgents)
#include "test_agents.moc"
