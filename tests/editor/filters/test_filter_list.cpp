// The filter list by mouse and keys: selection, clipboard, context menu, where time goes, running by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDropEvent>
#include <QMimeData>

#include "footfall/filter.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/level/import_panel.hpp"
#include "ui/run/stale_badge.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "DegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 0.5\n";

}  // namespace

class TestFilterList : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    table_ = writeFile(*folder_, "table.obj", tableObj());
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
    QVERIFY(openZUp(*window_, table_, kPipeline));
  }
  void cleanup() { window_.reset(); }

  void rowsAreSelectedByMouseAndKeys() {
    click(1);
    QCOMPARE(selected(), (QList<int>{1}));
    QVERIFY(row(1)->hasFocus());
    click(3, Qt::ShiftModifier);
    QCOMPARE(selected(), (QList<int>{1, 2, 3}));
    click(2, Qt::ControlModifier);
    QCOMPARE(selected(), (QList<int>{1, 3}));
    click(0);
    key(Qt::Key_Down);
    QCOMPARE(selected(), (QList<int>{1}));
    QVERIFY(row(1)->hasFocus());
    key(Qt::Key_Down, Qt::ShiftModifier);
    key(Qt::Key_Down, Qt::ShiftModifier);
    QCOMPARE(selected(), (QList<int>{1, 2, 3}));
    key(Qt::Key_Up, Qt::ShiftModifier);
    QCOMPARE(selected(), (QList<int>{1, 2}));
    key(Qt::Key_End);
    QCOMPARE(selected(), (QList<int>{3}));
    key(Qt::Key_Home);
    QCOMPARE(selected(), (QList<int>{0}));
    key(Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(selected(), (QList<int>{0, 1, 2, 3}));
    QVERIFY(row(2)->property("selected").toBool());
  }

  void tabGoesThroughARowAndTakesTheSelectionAlong() {
    click(1);
    key(Qt::Key_Return);  // into the first field
    QCOMPARE(QApplication::focusWidget(), row(1)->field(0));
    QTest::keyClick(row(1)->field(0), Qt::Key_Tab);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QVERIFY(row(2)->isAncestorOf(QApplication::focusWidget()) || row(2)->hasFocus() ||
            row(1)->removeButton()->hasFocus());
    row(2)->enabledBox()->setFocus();
    QCOMPARE(selected(), (QList<int>{2}));
  }

  void deletingDuplicatingAndMovingSeveral() {
    click(1);
    click(2, Qt::ShiftModifier);
    key(Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(names(), (QStringList{"Degeneracy", "Slope", "Clearance", "Slope", "Clearance", "Area"}));
    QCOMPARE(selected(), (QList<int>{3, 4}));
    QCOMPARE(undoText(), QString("Duplicate 2 filters"));
    key(Qt::Key_Up, Qt::AltModifier);
    QCOMPARE(names(), (QStringList{"Degeneracy", "Slope", "Slope", "Clearance", "Clearance", "Area"}));
    QCOMPARE(undoText(), QString("Move 2 filters up"));
    key(Qt::Key_Delete);
    QCOMPARE(names(), (QStringList{"Degeneracy", "Slope", "Clearance", "Area"}));
    QCOMPARE(undoText(), QString("Remove 2 filters"));
    QCOMPARE(selected().size(), 1);  // the one that stands there now
    for (int i = 0; i < 3; ++i) QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(names(), (QStringList{"Degeneracy", "Slope", "Clearance", "Area"}));
    click(2);
    key(Qt::Key_Up, Qt::AltModifier);
    QCOMPARE(undoText(), QString("Move Vertical clearance up"));
    key(Qt::Key_Down, Qt::AltModifier);
    key(Qt::Key_Down, Qt::AltModifier);
    QCOMPARE(undoText(), QString("Move Vertical clearance down"));
    QVERIFY(row(3)->hasFocus());
  }

  void severalAreDraggedTogether() {
    click(0);
    click(1, Qt::ShiftModifier);
    QWidget* handle = row(1)->handle();
    const QPoint below = handle->mapFromGlobal(row(3)->mapToGlobal(QPoint(30, row(3)->height() - 2)));
    QTest::mousePress(handle, Qt::LeftButton);
    QTest::mouseMove(handle, below / 2);
    QTest::mouseMove(handle, below);
    QTest::mouseRelease(handle, Qt::LeftButton, Qt::NoModifier, below);
    QCOMPARE(names(), (QStringList{"Clearance", "Area", "Degeneracy", "Slope"}));
    QCOMPARE(undoText(), QString("Move 2 filters down"));
    QTest::mousePress(row(0)->handle(), Qt::LeftButton);
    QTest::mouseMove(row(0)->handle(), QPoint(5, 200));
    QTest::keyClick(row(0)->handle(), Qt::Key_Escape);
    QTest::mouseRelease(row(0)->handle(), Qt::LeftButton);
    QCOMPARE(names().front(), QString("Clearance"));
  }

  void theClipboardIsTextOfAPipeline() {
    click(1);
    click(2, Qt::ShiftModifier);
    key(Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QApplication::clipboard()->text(), QString("SlopeFilter 45\nVerticalClearanceFilter 2\n"));
    key(Qt::Key_X, Qt::ControlModifier);
    QCOMPARE(names(), (QStringList{"Degeneracy", "Area"}));
    // Out of a text editor, with a comment and a row that is off.
    QApplication::clipboard()->setText("# mine\n#off SlopeFilter 30.5\nCollapse\n");
    click(0);
    key(Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(names(), (QStringList{"Degeneracy", "Slope", "Collapse", "Area"}));
    QCOMPARE(selected(), (QList<int>{1, 2}));
    QVERIFY(!partOf<Document>(*window_).filters()[1].step.enabled);
    QCOMPARE(partOf<Document>(*window_).filters()[1].step.values[0], 30.5);
    QCOMPARE(undoText(), QString("Paste 2 filters"));
  }

  void brokenTextSaysWhere() {
    QApplication::clipboard()->setText("SlopeFilter 45\n  ClearanceFilter 2\n");
    click(0);
    key(Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(names().size(), 4);
    QVERIFY2(partOf<MessageBar>(*window_).text().startsWith("clipboard:2:3: unknown filter \"ClearanceFilter\""),
             qPrintable(partOf<MessageBar>(*window_).text()));
    QApplication::clipboard()->setText("just words");
    key(Qt::Key_V, Qt::ControlModifier);
    QVERIFY(partOf<MessageBar>(*window_).text().startsWith("clipboard:1:1:"));
    QApplication::clipboard()->setText("# nothing\n");
    key(Qt::Key_V, Qt::ControlModifier);
    QVERIFY(partOf<MessageBar>(*window_).text().contains("holds no filters"));
  }

  void aFieldKeepsItsOwnClipboard() {
    auto* field = openField(*window_, 1);
    field->setFocus();
    field->selectAll();
    QTest::keyClick(field, Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QApplication::clipboard()->text(), QString("45"));
    QTest::keyClick(field, Qt::Key_Delete);
    QCOMPARE(names().size(), 4);
  }

  void spaceSwitchesTheSelectedRows() {
    click(1);
    click(2, Qt::ShiftModifier);
    key(Qt::Key_Space);
    QCOMPARE(enabled(), (QList<bool>{true, false, false, true}));
    key(Qt::Key_Space);
    QCOMPARE(enabled(), (QList<bool>{true, true, true, true}));
    // Space on a button belongs to the button.
    row(0)->removeButton()->setFocus();
    QTest::keyClick(row(0)->removeButton(), Qt::Key_Space);
    QTRY_COMPARE(names().size(), 3);
  }

  void runsOnlyUpToAStep() {
    click(1);
    key(Qt::Key_Return, Qt::ControlModifier);
    QCOMPARE(enabled(), (QList<bool>{true, true, false, false}));
    QCOMPARE(undoText(), QString("Run only up to Slope"));
    trigger("filters.allOn");
    QCOMPARE(enabled(), (QList<bool>{true, true, true, true}));
    click(2);
    trigger("filters.othersOff");
    QCOMPARE(enabled(), (QList<bool>{false, false, true, false}));
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->controller().upToDate());
  }

  void aBlockKeepsWhatItNeeds() {
    partOf<Document>(*window_).replacePipeline(
        parsePipeline("DegeneracyFilter\nGridStrategy 2 2\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n"
                      "AreaFilter 0.5\n",
                      "test"),
        "test");
    click(2);
    key(Qt::Key_Return, Qt::ControlModifier);
    QCOMPARE(enabled(), (QList<bool>{true, true, true, false, true, false}));
    trigger("filters.allOn");
    click(3);
    trigger("filters.othersOff");
    QCOMPARE(enabled(), (QList<bool>{false, true, false, true, true, false}));
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->controller().upToDate());
  }

  void theContextMenuInsertsAtTheRow() {
    click(0);
    QMenu* menu = openMenu(2);
    QVERIFY(menu);
    QCOMPARE(selected(), (QList<int>{2}));
    for (const char* text : {"Cu&t filters", "Run &only up to here", "Switch all ot&hers off"}) {
      QVERIFY2(std::ranges::any_of(menu->actions(), [&](QAction* action) { return action->text() == text; }), text);
    }
    choose(menu->findChild<QMenu*>("insertBefore"), "AreaFilter");
    QCOMPARE(names(), (QStringList{"Degeneracy", "Slope", "Area", "Clearance", "Area"}));
    QCOMPARE(selected(), (QList<int>{2}));
    menu = openMenu(3);
    QVERIFY(menu);
    choose(menu->findChild<QMenu*>("insertBehind"), "StepFilter");
    QCOMPARE(names(), (QStringList{"Degeneracy", "Slope", "Area", "Clearance", "Step", "Area"}));
    QCOMPARE(undoText(), QString("Insert Steps"));
  }

  void rowsShowWhereTheTimeGoes() {
    double sum = 0;
    for (FilterRow* each : partOf<FilterList>(*window_).rows()) {
      QVERIFY(each->shareBar().share().has_value());
      sum += *each->shareBar().share();
    }
    QVERIFY(std::abs(sum - 1) < 1e-9);
    const TimeStrip& strip = partOf<FilterList>(*window_).timeStrip();
    QVERIFY(strip.isVisible());
    QVERIFY2(strip.text().contains(" ms: ") && strip.text().contains(" %"), qPrintable(strip.text()));
    row(0)->enabledBox()->click();
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(!row(0)->shareBar().share().has_value());
  }

  void summariesNameTheLongest() {
    std::vector<FilterEntry> filters;
    int id = 0;
    for (const char* name : {"DegeneracyFilter", "SlopeFilter", "VerticalClearanceFilter", "AreaFilter"})
      filters.push_back({++id, defaultStep(*findFilter(name), 1)});
    filters[3].step.enabled = false;
    const TimeShares shares = timeShares(filters, [](int step) {
      StepStatus status;
      status.wallMs = 10.0 * step * step;  // 10, 40, 90
      return status;
    });
    QCOMPARE(shares.totalMs, 140.0);
    QCOMPARE(timeSummary(shares), QString("140 ms: Vertical clearance 64 %, Slope 29 %, Degeneracy 7 %"));
    QVERIFY(timeSummary({}).isEmpty());
  }

  void draggingAValueFollowsAndIsOneEdit() {
    auto* field = openField(*window_, 1);
    const int count = partOf<Document>(*window_).undoStack()->count();
    const auto at = [&](int x) { return QPoint(8 + x, field->height() / 2); };
    QTest::mousePress(field, Qt::LeftButton, Qt::NoModifier, at(0));
    const QPoint origin = field->mapToGlobal(QPoint());  // the row may make way for longer texts meanwhile
    for (int x = 4; x <= 80; x += 4) {
      QMouseEvent move(QEvent::MouseMove, at(x), origin + at(x), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(field, &move);
      QTest::qWait(5);
    }
    QCOMPARE(slope(), 65.0);
    QTest::mouseRelease(field, Qt::LeftButton, Qt::NoModifier, at(80));
    QCOMPARE(partOf<Document>(*window_).undoStack()->count(), count + 1);
    QCOMPARE(undoText(), QString::fromUtf8("Change maximum slope 45° → 65°"));
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->controller().upToDate());
    QCOMPARE(window_->controller().finishedRun()->pipeline.steps[1].values[0], 65.0);
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(slope(), 45.0);
    QVERIFY(window_->controller().upToDate());  // cached: no run
  }

  void theWheelScrollsWhereNoFieldHasTheFocus() {
    auto* field = row(1)->field(0);
    click(0);
    const QPointF at(field->rect().center());
    QWheelEvent event(at, field->mapToGlobal(at), QPoint(), QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(field, &event);
    QCOMPARE(slope(), 45.0);
  }

  void byHandTheViewSaysThatItIsOld() {
    auto* badge = window_->view().findChild<StaleBadge*>();
    QVERIFY(badge && !badge->isVisible());
    QTest::mouseClick(partOf<FilterList>(*window_).automaticBox(), Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
    QVERIFY(!window_->controller().automatic());
    QVERIFY(!window_->findChild<QAction*>("pipeline.automatic")->isChecked());
    const QSignalSpy started(&window_->controller(), &RunController::started);
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[1].id, 0, 70, 1);
    QTest::qWait(200);
    QCOMPARE(started.count(), 0);
    QVERIFY(badge->isVisible());
    QCOMPARE(row(1)->stateText(), QString("out of date"));
    QTest::keyClick(window_.get(), Qt::Key_F5);
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(!badge->isVisible());
    QCOMPARE(window_->controller().finishedRun()->pipeline.steps[1].values[0], 70.0);
    // The mark's own button, and switching back.
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[1].id, 0, 71, 2);
    QTRY_VERIFY(badge->isVisible());
    QTest::mouseClick(badge->runButton(), Qt::LeftButton);
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->controller().upToDate());
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[1].id, 0, 72, 3);
    window_->findChild<QAction*>("pipeline.automatic")->trigger();
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->controller().upToDate());
    QVERIFY(partOf<FilterList>(*window_).automaticBox()->isChecked());
  }

  void sessionsKeepWhetherItRunsByItself() {
    partOf<FilterList>(*window_).automaticBox()->click();
    const QString path = folder_->filePath("a.footfall");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(path);
    QVERIFY(written.count() > 0 || written.wait());
    EditorWindow other;
    QVERIFY(showWindow(other));
    other.open(path);
    QVERIFY(QTest::qWaitFor([&] { return other.file().environment() != nullptr; }));
    QVERIFY(waitUntilIdle(other));
    QVERIFY(!other.controller().automatic());
    QVERIFY(other.controller().upToDate());  // opening runs once
  }

  void theHistoryNamesEditsAndGoesBack() {
    window_->findChild<QAction*>("panel.history")->trigger();
    auto* history = window_->findChild<QAbstractItemView*>("undoHistory");
    QVERIFY(history && history->isVisible());
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[1].id, 0, 50, 1);
    click(2);
    key(Qt::Key_Delete);
    QCOMPARE(history->model()->rowCount(), 3);
    QCOMPARE(history->model()->index(1, 0).data().toString(), QString::fromUtf8("Change maximum slope 45° → 50°"));
    QCOMPARE(history->model()->index(2, 0).data().toString(), QString("Remove Vertical clearance"));
    QCOMPARE(window_->findChild<QAction*>("edit.undo")->text(), QString("&Undo Remove Vertical clearance"));
    QTest::mouseClick(history->viewport(), Qt::LeftButton, Qt::NoModifier,
                      history->visualRect(history->model()->index(0, 0)).center());
    QCOMPARE(names().size(), 4);
    QCOMPARE(slope(), 45.0);
  }

  void aPipelineFileIsDroppedOntoTheList() {
    const QString path = writeFile(*folder_, "mine.pipeline", "SlopeFilter 33\nAreaFilter 2\n");
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    // The event goes to the window, at a place over the list, as from a window system.
    const QPoint at = row(2)->mapTo(window_.get(), QPoint(20, 10));
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window_->windowHandle(), &enter);
    QDropEvent drop(QPointF(at), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window_->windowHandle(), &drop);
    QTRY_COMPARE(names(), (QStringList{"Slope", "Area"}));
    QCOMPARE(undoText(), QString("Open mine.pipeline"));
  }

  void unitsFollowTheScale() {
    auto* scale = partOf<ImportPanel>(*window_).scaleField();
    QCOMPARE(row(1)->unitOf(0), QString("degrees"));
    QCOMPARE(row(2)->unitOf(0), QString("units"));
    scale->setFocus();
    scale->selectAll();
    QTest::keyClicks(scale, "0.05");
    QCOMPARE(row(2)->unitOf(0), QString("m"));
    auto* field = openField(*window_, 2);
    QCOMPARE(field->text(), QString("2"));
    QCOMPARE(field->value(), 40.0);
  }

 private:
  FilterRow* row(int index) { return partOf<FilterList>(*window_).rows()[static_cast<std::size_t>(index)]; }
  void click(int index, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::mouseClick(row(index), Qt::LeftButton, modifiers, QPoint(row(index)->width() / 2, 3));
  }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(QApplication::focusWidget(), key, modifiers);
  }
  QMenu* openMenu(int index) {
    const QPoint at(20, 5);
    QTest::mousePress(row(index), Qt::RightButton, Qt::NoModifier, at);
    QTest::mouseRelease(row(index), Qt::RightButton, Qt::NoModifier, at);
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, row(index)->mapToGlobal(at));
    QApplication::sendEvent(row(index), &event);
    return qobject_cast<QMenu*>(QApplication::activePopupWidget());
  }
  static void choose(QMenu* menu, const char* filter) {
    for (QAction* action : menu->actions()) {
      if (action->data() == QVariant(filter)) action->trigger();
    }
    QApplication::activePopupWidget()->close();
  }
  void trigger(const char* action) { window_->findChild<QAction*>(action)->trigger(); }
  double slope() { return partOf<Document>(*window_).filters()[1].step.values[0]; }
  QString undoText() { return partOf<Document>(*window_).undoStack()->undoText(); }
  QList<int> selected() {
    QList<int> indices;
    for (std::size_t i = 0; i < partOf<FilterList>(*window_).rows().size(); ++i) {
      if (partOf<FilterList>(*window_).selection().contains(partOf<FilterList>(*window_).rows()[i]->entryId()))
        indices << static_cast<int>(i);
    }
    return indices;
  }
  QList<bool> enabled() {
    QList<bool> on;
    for (const FilterEntry& entry : partOf<Document>(*window_).filters()) on << entry.step.enabled;
    return on;
  }
  QStringList names() {
    QStringList names;
    for (QString name : filterNames(*window_)) names << name.replace("VerticalClearance", "Clearance").remove("Filter");
    return names;
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
  QString table_;
};

FOOTFALL_EDITOR_SUITE(TestFilterList)
#include "test_filter_list.moc"
