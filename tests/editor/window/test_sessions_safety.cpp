// No work is lost by kills, two windows at once, unsaved changes, or full and read-only disks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QProcess>
#include <QSignalSpy>
#include <QStandardPaths>
#include <csignal>

#include "core/io/export.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/window/session_keeper.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

QDir keptFolder() { return {QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation)}; }
QStringList autosaves() { return keptFolder().entryList({"autosave-*.footfall"}, QDir::Files); }

/// The program that is built beside the suites.
QString editorProgram() { return QCoreApplication::applicationDirPath() + "/../footfall-editor"; }

}  // namespace

class TestSessionsSafety : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    for (const QString& name : keptFolder().entryList(QDir::Files)) keptFolder().remove(name);
    folder_ = std::make_unique<QTemporaryDir>();
    table_ = writeFile(*folder_, "table.obj", tableObj());
    window_ = makeWindow();
  }
  void cleanup() { window_.reset(); }

  void aKilledEditorIsRestored() {
    window_.reset();
    const QString session = folder_->filePath("work.footfall");
    Session saved;
    saved.environment = table_.toStdString();
    saved.import.up = UpAxis::Z;
    saved.pipeline = parsePipeline("SlopeFilter 31\nAreaFilter 2\n", "test");
    writeFileSafely(session.toStdString(), formatSession(saved, session.toStdString()));

    QProcess editor;  // The program uses the settings of this suite.
    editor.setProcessChannelMode(QProcess::ForwardedChannels);
    editor.start(editorProgram(), {session});
    QVERIFY2(editor.waitForStarted(), qPrintable(editorProgram()));
    QVERIFY(QTest::qWaitFor([] { return !autosaves().isEmpty(); }, 60000));
    // Its files belong to it as long as it lives.
    {
      auto other = makeWindow();
      other->offerRestoring();
      QVERIFY(!partOf<MessageBar>(*other).isVisible());
    }
    ::kill(static_cast<pid_t>(editor.processId()), SIGKILL);
    QVERIFY(editor.waitForFinished());

    window_ = makeWindow();
    window_->offerRestoring();
    QVERIFY(partOf<MessageBar>(*window_).isVisible());
    QVERIFY(partOf<MessageBar>(*window_).text().contains("table.obj"));
    QTest::mouseClick(button("Restore"), Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return window_->file().environment() != nullptr; }));
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(partOf<Document>(*window_).pipeline(), saved.pipeline);
    QCOMPARE(window_->file().environment()->up, UpAxis::Z);
    QVERIFY(window_->windowTitle().contains("work.footfall"));  // saving goes where it went before
    QVERIFY(!partOf<SessionFiles>(*window_).hasUnsavedChanges());
    // A restored session is kept by this window now, and offered to no other.
    QTRY_COMPARE(autosaves().size(), 1);
    auto other = makeWindow();
    other->offerRestoring();
    QVERIFY(!partOf<MessageBar>(*other).isVisible());
  }

  void unsavedChangesComeBackAsUnsaved() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[0].id, 0, 50, 0);
    QVERIFY(partOf<SessionFiles>(*window_).hasUnsavedChanges());
    QVERIFY(QTest::qWaitFor([] { return !autosaves().isEmpty(); }));
    QTest::qWait(1300);  // the last change is in
    window_.reset();     // not closed: as if it had ended unexpectedly
    window_ = makeWindow();
    window_->offerRestoring();
    QTest::mouseClick(button("Restore"), Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return window_->file().environment() != nullptr; }));
    QCOMPARE(partOf<Document>(*window_).filters().at(0).step.values[0], 50.0);
    QVERIFY(partOf<SessionFiles>(*window_).hasUnsavedChanges());
  }

  void whatIsNotWantedIsDiscarded() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    QVERIFY(QTest::qWaitFor([] { return !autosaves().isEmpty(); }));
    window_.reset();
    window_ = makeWindow();
    window_->offerRestoring();
    QTest::mouseClick(button("Discard"), Qt::LeftButton);
    QVERIFY(!partOf<MessageBar>(*window_).isVisible());
    QTRY_VERIFY(autosaves().isEmpty());
  }

  void brokenAutosavesAreNotOffered() {
    QFile broken(keptFolder().filePath("autosave-1-0.footfall"));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("{\"footfall_session\": 1, \"environ");
    broken.close();
    window_->offerRestoring();
    QVERIFY(!partOf<MessageBar>(*window_).isVisible());
    QVERIFY(autosaves().isEmpty());
  }

  void twoWindowsKeepTheirOwn() {
    auto other = makeWindow();
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 11\n"));
    QVERIFY(openZUp(*other, writeFile(*folder_, "floor.obj", floorObj()), "SlopeFilter 22\n"));
    QTRY_COMPARE(autosaves().size(), 2);
    QStringList environments;
    for (const QString& name : autosaves()) {
      const auto kept = readKeptSession(keptFolder().filePath(name));
      QVERIFY(kept);
      environments << QFileInfo(kept->environment).fileName();
    }
    environments.sort();
    QCOMPARE(environments, (QStringList{"floor.obj", "table.obj"}));
    other->close();
    QTRY_COMPARE(autosaves().size(), 1);
    QVERIFY(QFile::exists(keptFolder().filePath("last-session.footfall")));
  }

  void closingAsksOnceAndOnlyForChanges() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    QVERIFY(window_->close());  // nothing changed
    window_->show();
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[0].id, 0, 50, 0);

    QVERIFY(!window_->close());
    QVERIFY(!window_->close());  // The question was shown already.
    QCOMPARE(window_->findChildren<QMessageBox*>().size(), 1);
    answer(QMessageBox::Cancel);
    QVERIFY(window_->isVisible() && partOf<SessionFiles>(*window_).hasUnsavedChanges());

    QVERIFY(!window_->close());
    answer(QMessageBox::Discard);
    QTRY_VERIFY(!window_->isVisible());
  }

  void closingSavesWhenAsked() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[0].id, 0, 50, 0);
    const QString target = folder_->filePath("saved.footfall");
    QVERIFY(!window_->close());
    answer(QMessageBox::Save);
    answerFileDialog(target);
    QTRY_VERIFY(!window_->isVisible());
    QCOMPARE(readSession(target.toStdString()).pipeline.steps[0].values[0], 50.0);
  }

  void aSaveThatIsCalledOffClosesNothing() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[0].id, 0, 50, 0);
    QVERIFY(!window_->close());
    answer(QMessageBox::Save);
    QWidget* dialog = nullptr;
    QVERIFY(QTest::qWaitFor([&] { return (dialog = QApplication::activeModalWidget()) != nullptr; }));
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY(!QApplication::activeModalWidget());
    QVERIFY(window_->isVisible());
    // A later save must not close it either.
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(folder_->filePath("later.footfall"));
    QVERIFY(written.wait());
    QTest::qWait(100);
    QVERIFY(window_->isVisible());
  }

  void openingAsksToo() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[0].id, 0, 50, 0);
    const auto before = window_->file().environment();
    const QString other = writeFile(*folder_, "floor.obj", floorObj());
    window_->openAsking(other);
    answer(QMessageBox::Cancel);
    QTest::qWait(100);
    QCOMPARE(window_->file().environment(), before);
    window_->openAsking(other);
    answer(QMessageBox::Discard);
    QTRY_VERIFY(window_->file().environment() != before);
  }

  void savingThatFailsLeavesTheDocumentUnsaved() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    const QString good = folder_->filePath("good.footfall");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(good);
    QVERIFY(written.wait());
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[0].id, 0, 50, 0);
    const QByteArray before = readFile(good);
    QVERIFY(window_->isWindowModified());

    window_->saveSession(folder_->filePath("no/such/folder/x.footfall"));
    QTRY_VERIFY(partOf<MessageBar>(*window_).isVisible());
    QVERIFY(partOf<MessageBar>(*window_).text().contains("no/such/folder"));
    QVERIFY(partOf<SessionFiles>(*window_).hasUnsavedChanges() && window_->isWindowModified());
    QVERIFY(window_->windowTitle().contains("good.footfall"));

    // A device that is always full.
    if (QFileInfo::exists("/dev/full")) {
      partOf<MessageBar>(*window_).clear();
      window_->saveSession("/dev/full");
      QTRY_VERIFY(partOf<MessageBar>(*window_).text().contains("full"));
      QVERIFY(partOf<SessionFiles>(*window_).hasUnsavedChanges());
    }
    QCOMPARE(readFile(good), before);
    window_->saveSession(good);
    QTRY_VERIFY(!partOf<SessionFiles>(*window_).hasUnsavedChanges());
    QCOMPARE(written.count(), 2);
  }

  void editsWhileSavingStayUnsaved() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[0].id, 0, 50, 0);
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(folder_->filePath("work.footfall"));
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[0].id, 0, 60, 1);
    QVERIFY(written.wait());
    QVERIFY(partOf<SessionFiles>(*window_).hasUnsavedChanges());
  }

  void aSettingsFolderThatCannotBeWrittenIsToldOnce() {
    // A file where the folder should be: root, too, cannot write there.
    QTemporaryDir elsewhere;
    QFile blocking(elsewhere.filePath("footfall"));
    QVERIFY(blocking.open(QIODevice::WriteOnly));
    const QByteArray before = qgetenv("XDG_CONFIG_HOME");
    qputenv("XDG_CONFIG_HOME", elsewhere.path().toUtf8());
    auto window = makeWindow();
    const bool opened = openZUp(*window, table_, "SlopeFilter 45\n");
    const bool told = QTest::qWaitFor([&] { return partOf<MessageBar>(*window).isVisible(); });
    const QString text = partOf<MessageBar>(*window).text();
    partOf<MessageBar>(*window).clear();
    window->findChild<SessionFiles*>()->keepSoon();
    QTest::qWait(1300);
    const bool toldAgain = partOf<MessageBar>(*window).isVisible();
    qputenv("XDG_CONFIG_HOME", before);
    QVERIFY(opened && told && !toldAgain);
    QVERIFY(text.contains("after a crash"));
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
  void answer(QMessageBox::StandardButton which) {
    auto* box = window_->findChild<QMessageBox*>("unsavedQuestion");
    QVERIFY(box);
    QTest::mouseClick(box->button(which), Qt::LeftButton);
    QTRY_VERIFY(!window_->findChild<QMessageBox*>("unsavedQuestion"));
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
  QString table_;
};

FOOTFALL_EDITOR_SUITE(TestSessionsSafety)
#include "test_sessions_safety.moc"
