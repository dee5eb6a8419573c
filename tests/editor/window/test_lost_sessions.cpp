// Sessions offered after a crash, with their undo history; saving to the session's file; and when the picture is
// complete.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/messages/status_line.hpp"
#include "ui/window/session_history.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

QDir keptFolder() { return {QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation)}; }
QStringList autosaves() { return keptFolder().entryList({"autosave-*.footfall"}, QDir::Files); }

bool waitForHistory(int edits) {
  return QTest::qWaitFor(
      [edits] {
        for (const QString& name : autosaves()) {
          const auto kept = readKeptSession(keptFolder().filePath(name));
          if (kept && kept->history && static_cast<int>(kept->history->edits.size()) == edits) return true;
        }
        return false;
      },
      kWaitMs);
}

}  // namespace

class TestLostSessions : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    for (const QString& name : keptFolder().entryList(QDir::Files)) keptFolder().remove(name);
    QSettings().clear();
    folder_ = std::make_unique<QTemporaryDir>();
    table_ = writeFile(*folder_, "table.obj", tableObj());
    window_ = makeWindow();
  }
  void cleanup() { window_.reset(); }

  void theUndoHistorySurvivesRestoring() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\nAreaFilter 2\n"));
    Document& document = partOf<Document>(*window_);
    document.setValue(document.filters()[0].id, 0, 50, 1);
    document.addFilter(filterDescriptor(FilterType::Degeneracy), 1);
    document.setEnabled(document.filters()[1].id, false);
    document.undoStack()->undo();
    const Pipeline before = document.pipeline();
    QVERIFY(waitForHistory(3));
    window_.reset();  // not closed: as if it had ended unexpectedly
    window_ = makeWindow();
    window_->offerRestoring();
    QTest::mouseClick(button("Restore"), Qt::LeftButton);
    QVERIFY(
        QTest::qWaitFor([&] { return window_->file().environment() != nullptr && waitUntilIdle(*window_); }, kWaitMs));
    Document& restored = partOf<Document>(*window_);
    QCOMPARE(restored.pipeline(), before);
    QCOMPARE(restored.undoStack()->count(), 3);
    QCOMPARE(restored.undoStack()->index(), 2);
    QCOMPARE(restored.undoStack()->undoText(), QString("Add Degeneracy"));
    QVERIFY(restored.undoStack()->redoText().startsWith("Switch off"));
    const int slope = restored.filters()[0].id;
    restored.undoStack()->undo();
    restored.undoStack()->undo();
    QCOMPARE(restored.pipeline(), parsePipeline("SlopeFilter 45\nAreaFilter 2\n", "test"));
    QCOMPARE(restored.filters()[0].id, slope);  // the same row
    restored.undoStack()->setIndex(3);
    QVERIFY(!restored.filters()[1].step.enabled);
    QVERIFY(waitUntilIdle(*window_));
  }

  void historiesAreBoundedAndChecked() {
    EditHistory history;
    history.first.filters.push_back({1, defaultStep(filterDescriptor(FilterType::Slope), 1)});
    for (int i = 0; i < 30; ++i) {
      EditHistory::Edit edit{QStringLiteral("Edit %1").arg(i), history.first};
      edit.after.filters[0].step.values[0] = 10 + i;
      history.edits.push_back(edit);
    }
    history.index = 30;
    const auto read = parseHistory(formatHistory(history, 10));
    QVERIFY(read);
    QCOMPARE(read->edits.size(), std::size_t{10});
    QCOMPARE(read->index, 10);
    QCOMPARE(read->first.filters[0].step.values[0], 29.0);
    QCOMPARE(read->edits.back().after.filters[0].step.values[0], 39.0);
    QVERIFY(!parseHistory("{\"index\": 1}"));
    QVERIFY(!parseHistory("no json"));
    Document document;
    document.reset(parsePipeline("SlopeFilter 12\n", "test"), {});
    QVERIFY(!document.restoreHistory(*read));  // it leads elsewhere
    QCOMPARE(document.undoStack()->count(), 0);
  }

  void olderLostSessionsAreOfferedToo() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    QTRY_COMPARE_WITH_TIMEOUT(autosaves().size(), 1, kWaitMs);
    window_.reset();
    window_ = makeWindow();
    const QString floor = writeFile(*folder_, "floor.obj", floorObj());
    QVERIFY(openZUp(*window_, floor, "SlopeFilter 45\n"));
    QTRY_COMPARE_WITH_TIMEOUT(autosaves().size(), 2, kWaitMs);
    window_.reset();
    window_ = makeWindow();
    // The one of the file that is opened comes first.
    window_->offerRestoring(table_);
    QVERIFY2(partOf<MessageBar>(*window_).text().contains("2 sessions"),
             qPrintable(partOf<MessageBar>(*window_).text()));
    QVERIFY(partOf<MessageBar>(*window_).text().contains("Restore table.obj"));
    window_->offerRestoring(floor);
    QVERIFY(partOf<MessageBar>(*window_).text().contains("Restore floor.obj"));
    QTest::mouseClick(button("Others..."), Qt::LeftButton);
    QMenu* menu = nullptr;
    QTRY_VERIFY((menu = window_->findChild<QMenu*>("lostSessions")) != nullptr);
    QCOMPARE(menu->actions().size(), 2);
    menu->close();
    // The other one is offered once the first is there.
    window_->offerRestoring(floor);
    QTest::mouseClick(button("Restore"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(partOf<MessageBar>(*window_).text().contains("while table.obj was open"), kWaitMs);
    QVERIFY(waitUntilIdle(*window_));
  }

  void savingGoesWhereTheSessionCameFrom() {
    const QString path = folder_->filePath("work.footfall");
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(path);
    QVERIFY(written.count() > 0 || written.wait(kWaitMs));
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[0].id, 0, 33, 1);
    QVERIFY(partOf<SessionFiles>(*window_).hasUnsavedChanges());
    window_->findChild<QAction*>("file.save")->trigger();
    QVERIFY(!QApplication::activeModalWidget());
    QTRY_VERIFY_WITH_TIMEOUT(!partOf<SessionFiles>(*window_).hasUnsavedChanges(), kWaitMs);
    QCOMPARE(readSession(path.toStdString()).pipeline.steps[0].values[0], 33.0);
    // Saves to another file, with a dialog.
    window_->findChild<QAction*>("file.saveAs")->trigger();
    QTRY_VERIFY(QApplication::activeModalWidget());
    QApplication::activeModalWidget()->close();
  }

  // Counts and picture belong together; otherwise the status line says that they do not yet.
  void theStatusSaysThatThePictureIsOlder() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    QTRY_VERIFY_WITH_TIMEOUT(!window_->drawing(), kWaitMs);
    QSignalSpy finished(&window_->controller(), &RunController::finished);
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[0].id, 0, 70, 1);
    QVERIFY(finished.count() > 0 || finished.wait(kWaitMs));
    // The picture comes with a later frame.
    QTRY_VERIFY_WITH_TIMEOUT(!window_->drawing(), kWaitMs);
    QVERIFY(window_->view().isWhole());
    QVERIFY(!partOf<StatusLine>(*window_).text().contains("Drawing"));
  }

 private:
  static std::unique_ptr<EditorWindow> makeWindow() {
    auto window = std::make_unique<EditorWindow>();
    window->resize(1000, 700);
    if (!showWindow(*window)) qFatal("no window");
    return window;
  }
  QPushButton* button(const QString& text) {
    for (auto* found : partOf<MessageBar>(*window_).findChildren<QPushButton*>()) {
      if (found->text() == text && found->isVisible()) return found;
    }
    qFatal("no button %s", qPrintable(text));
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
  QString table_;
};

FOOTFALL_EDITOR_SUITE(TestLostSessions)
#include "test_lost_sessions.moc"
