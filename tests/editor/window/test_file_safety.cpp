// Files in use are never overwritten, others only after a question, and messages end with their subject.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/messages/progress_display.hpp"
#include "ui/base/messages/status_line.hpp"
#include "ui/window/export_dialog.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

class TestFileSafety : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    QSettings().clear();
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1100, 760);
    QVERIFY(showWindow(*window_));
    writeFile(*folder_, "table.mtl", "newmtl wood\nmap_Kd wood.png\n");
    writeFile(*folder_, "wood.png", "no picture");
    content_ = "mtllib table.mtl\n" + tableObj();
    table_ = writeFile(*folder_, "table.obj", content_);
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\nVerticalClearanceFilter 2\n"));
    QTRY_VERIFY_WITH_TIMEOUT(!window_->drawing(), kWaitMs);  // the status line then has nothing to add
  }
  void cleanup() {
    window_.reset();
    folder_.reset();
  }

  // --- The environment and what belongs to it

  void anExportNeverReplacesTheEnvironment() {
    QVERIFY(QFile::link(table_, folder_->filePath("link.obj")));
    QCOMPARE(::link(qPrintable(table_), qPrintable(folder_->filePath("hard.obj"))), 0);
    openExport();
    for (const QString& name : {table_, folder_->filePath("link.obj"), folder_->filePath("hard.obj"),
                                folder_->path() + "/./table.obj", folder_->filePath("wood.png")}) {
      typeName(name);
      QVERIFY2(problem().contains("would be overwritten"), qPrintable(name + ": " + problem()));
      QTest::keyClick(nameField(), Qt::Key_Return);
      QTest::qWait(50);
      QVERIFY(exportDialog());  // nothing was exported
    }
    closeExport();
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(readFile(table_), content_);
    QCOMPARE(readFile(folder_->filePath("wood.png")), QByteArray("no picture"));
  }

  void noOtherWayLeadsThere() {
    QSignalSpy written(window_.get(), &EditorWindow::written);
    const auto refused = [&](const QString& path) {
      if (!partOf<MessageBar>(*window_).text().startsWith(path + ": would be overwritten")) return false;
      partOf<MessageBar>(*window_).clear();
      return true;
    };
    window_->exportResult(table_);
    QVERIFY(refused(table_));
    window_->saveSession(table_);
    QVERIFY(refused(table_));
    window_->savePipeline(folder_->filePath("table.mtl"));
    QVERIFY(refused(folder_->filePath("table.mtl")));
    choose("file.saveAs");
    answerFileDialog(table_);
    QVERIFY(QTest::qWaitFor([&] { return refused(table_); }));
    choose("pipeline.save");
    answerFileDialog(table_);
    QVERIFY(QTest::qWaitFor([&] { return refused(table_); }));
    QCOMPARE(readFile(table_), content_);
    QCOMPARE(written.count(), 0);
  }

  void sessionAndPipelineAreKeptFromOtherKinds() {
    const QString session = folder_->filePath("work.footfall"), pipeline = folder_->filePath("work.pipeline");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(session);
    QVERIFY(written.wait());
    window_->savePipeline(pipeline);
    QVERIFY(written.wait());
    const QByteArray before = readFile(session);
    window_->savePipeline(session);
    QVERIFY(partOf<MessageBar>(*window_).text().contains("is the session that is open"));
    window_->exportResult(pipeline);
    QVERIFY(partOf<MessageBar>(*window_).text().contains("is the pipeline that is open"));
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(readFile(session), before);
    QCOMPARE(readFile(pipeline), QByteArray("SlopeFilter 45\nVerticalClearanceFilter 2\n"));
  }

  // --- Other files

  void anExportAsksBeforeItReplaces() {
    const QString other = writeFile(*folder_, "other.obj", "kept");
    openExport();
    typeName(other);
    QCOMPARE(problem(), QString());
    QTest::keyClick(nameField(), Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return question() != nullptr; }));
    QVERIFY(question()->text().contains("other.obj"));
    QTest::keyClick(question(), Qt::Key_Return);  // a hasty one keeps the file
    QVERIFY(QTest::qWaitFor([&] { return question() == nullptr; }));
    QVERIFY(exportDialog() && window_->idle());
    QCOMPARE(readFile(other), QByteArray("kept"));

    QTest::keyClick(nameField(), Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return question() != nullptr; }));
    shoot(*QApplication::activeWindow(), "replace-question");
    QTest::mouseClick(question()->findChild<QPushButton*>("replaceAccept"), Qt::LeftButton);
    QTRY_VERIFY(readFile(other).startsWith("# "));
    QTRY_VERIFY(!exportDialog());
  }

  void aSessionAsksUnlessItIsTheOpenOne() {
    const QString other = writeFile(*folder_, "other.footfall", "kept");
    choose("file.saveAs");
    answerFileDialog(other);
    QVERIFY(QTest::qWaitFor([&] { return question() != nullptr; }));
    QTest::keyClick(question(), Qt::Key_Escape);
    QVERIFY(QTest::qWaitFor([&] { return question() == nullptr; }));
    QCOMPARE(readFile(other), QByteArray("kept"));

    const QString own = folder_->filePath("own.footfall");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    for (int i = 0; i < 2; ++i) {  // the second replaces the first, which is what saving means
      choose("file.saveAs");
      answerFileDialog(own);
      QVERIFY(written.wait());
      QVERIFY(!question());
    }
  }

  void aSaveThatIsTakenBackClosesNothing() {
    const QString other = writeFile(*folder_, "other.footfall", "kept");
    edit(50);
    QVERIFY(!window_->close());
    auto* unsaved = window_->findChild<QMessageBox*>("unsavedQuestion");
    QVERIFY(unsaved);
    QTest::mouseClick(unsaved->button(QMessageBox::Save), Qt::LeftButton);
    answerFileDialog(other);
    QVERIFY(QTest::qWaitFor([&] { return question() != nullptr; }));
    QTest::keyClick(question(), Qt::Key_Escape);
    QVERIFY(QTest::qWaitFor([&] { return question() == nullptr; }));
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(folder_->filePath("later.footfall"));
    QVERIFY(written.wait());
    QTest::qWait(100);
    QVERIFY(window_->isVisible());
    QCOMPARE(readFile(other), QByteArray("kept"));
  }

  void whatIsUnsavedIsCalledASession() {
    edit(50);
    QVERIFY(!window_->close());
    auto* box = window_->findChild<QMessageBox*>("unsavedQuestion");
    QVERIFY(box);
    QCOMPARE(box->text(), QString("Save the changes as a session?"));
    QVERIFY(box->informativeText().contains("The file table.obj itself stays as it is."));
    shoot(*QApplication::activeWindow(), "unsaved-question");
    QTest::keyClick(box, Qt::Key_Escape);
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(folder_->filePath("work.footfall"));
    QVERIFY(written.wait());
    edit(55);
    QTRY_VERIFY(!window_->findChild<QMessageBox*>("unsavedQuestion"));
    QVERIFY(!window_->close());
    box = window_->findChild<QMessageBox*>("unsavedQuestion");
    QVERIFY(box);
    QCOMPARE(box->text(), QString("Save the changes to the session work.footfall?"));
    QTest::keyClick(box, Qt::Key_Escape);
  }

  // --- Places that cannot be written

  void whyAPlaceCannotBeWritten() {
    QVERIFY(QDir(folder_->path()).mkdir("exp"));
    openExport();
    typeName(folder_->filePath("exp"));
    QVERIFY(problem().startsWith(folder_->filePath("exp") + " is a folder"));
    typeName(table_ + "/a.obj");
    QVERIFY2(problem().contains(table_ + " is a file, not a folder"), qPrintable(problem()));
    typeName(folder_->filePath(QString(300, 'x') + ".obj"));
    QVERIFY2(problem().contains("too long"), qPrintable(problem()));
    typeName(folder_->filePath("none/a.obj"));
    QVERIFY2(problem().contains("its folder does not exist"), qPrintable(problem()));
    closeExport();
  }

  // --- Messages end with what they are about

  void loadingEndsWithAFailure() {
    const QString before = status();
    for (const auto& [name, content] : {std::pair<const char*, QByteArray>{"empty.obj", ""},
                                        {"nothing.obj", "# nothing\n"},
                                        {"nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
                                        {"cut.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n"},
                                        {"text.gltf", "this is no mesh"},
                                        {"bad.footfall", "{\"footfall_session\": 1, \"envir"}}) {
      const QString path = writeFile(*folder_, name, content);
      window_->open(path);
      QVERIFY(waitUntilIdle(*window_));
      QVERIFY2(partOf<MessageBar>(*window_).text().contains(name), qPrintable(partOf<MessageBar>(*window_).text()));
      QCOMPARE(status(), before);
      QVERIFY(window_->windowTitle().startsWith("table.obj"));
      QVERIFY(!partOf<ProgressDisplay>(*window_).bar()->isVisible());
      QVERIFY(!window_->findChild<QPushButton*>("cancel")->isVisible());
    }
    window_->open(folder_->filePath("gone.obj"));
    QTRY_VERIFY(partOf<MessageBar>(*window_).text().contains("no such file"));
    // The next file that is opened replaces it.
    window_->open(writeFile(*folder_, "floor.obj", floorObj()));
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(!partOf<MessageBar>(*window_).text().contains("no such file"));
  }

  void aPipelineThatCanBeReadEndsTheErrorOfOneThatCannot() {
    const Pipeline before = partOf<Document>(*window_).pipeline();
    window_->openPipeline(writeFile(*folder_, "bad.pipeline", "SlopeFilter\n"));
    QVERIFY(partOf<MessageBar>(*window_).isVisible());
    QCOMPARE(partOf<Document>(*window_).pipeline(), before);
    window_->openPipeline(writeFile(*folder_, "good.pipeline", "SlopeFilter 30\n"));
    QVERIFY(!partOf<MessageBar>(*window_).isVisible());
  }

  void aToolsHintEndsWithTheTool() {
    const QString before = status();
    QTest::keyClick(&window_->view(), Qt::Key_P);
    QVERIFY(window_->view().tool());
    QVERIFY(status() != before);
    QTest::keyClick(&window_->view(), Qt::Key_Escape);
    QVERIFY(!window_->view().tool());
    QCOMPARE(status(), before);
  }

  void aWritingErrorEndsWithASuccess() {
    window_->exportResult(folder_->filePath("none/a.obj"));
    QTRY_VERIFY(partOf<MessageBar>(*window_).isVisible());
    window_->exportResult(folder_->filePath("a.obj"));
    QTRY_VERIFY(QFile::exists(folder_->filePath("a.obj")) && window_->idle());
    QVERIFY(!partOf<MessageBar>(*window_).isVisible());
    QVERIFY(status().startsWith("Wrote "));
    // A note about a finished action disappears after a while.
    partOf<StatusLine>(*window_).setNoteDuration(1);
    partOf<StatusLine>(*window_).say(StatusSubject::Note, "news");
    QTRY_VERIFY(status() != "news" && !status().startsWith("Wrote "));
  }

  void othersMessagesStay() {
    partOf<MessageBar>(*window_).showErrorOf(MessageSubject::Writing, "the disk is full");
    edit(50);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(partOf<MessageBar>(*window_).text(), QString("the disk is full"));
  }

  void aHintAboutFiltersEndsWhenTheyChange() {
    edit(33);
    window_->open(writeFile(*folder_, "floor.obj", floorObj()));
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(partOf<MessageBar>(*window_).text().contains("filters were kept"));
    edit(34);
    QVERIFY(!partOf<MessageBar>(*window_).isVisible());
  }

  // --- Errors name rows as the list does

  void anErrorNamesTheRow() {
    DocumentState next = partOf<Document>(*window_).state();
    next.filters.push_back(next.filters.front());
    next.filters.back().id = partOf<Document>(*window_).newFilterId();
    next.filters.back().step = defaultStep(filterDescriptor(FilterType::GridStrategy), 1);
    partOf<Document>(*window_).edit(next, "a strategy without an end");
    QVERIFY(QTest::qWaitFor([&] { return partOf<MessageBar>(*window_).isVisible(); }));
    QVERIFY2(partOf<MessageBar>(*window_).text().startsWith("step 3 (Grid strategy): "),
             qPrintable(partOf<MessageBar>(*window_).text()));
    // Gone with the cause.
    partOf<Document>(*window_).undoStack()->undo();
    QVERIFY(waitUntilIdle(*window_));
    QTRY_VERIFY(!partOf<MessageBar>(*window_).isVisible());
  }

  // --- Exports that wait

  void everyExportThatWaitsIsWritten() {
    edit(80);
    for (const char* name : {"a.obj", "b.glb", "c.png", "d.html"}) window_->exportResult(folder_->filePath(name));
    QVERIFY(!window_->idle());
    QVERIFY(waitUntilIdle(*window_));
    for (const char* name : {"a.obj", "b.glb", "c.png", "d.html"})
      QVERIFY2(QFile::exists(folder_->filePath(name)), name);
    QVERIFY(readFile(folder_->filePath("a.obj")).contains("SlopeFilter 80"));
  }

  void anExportThatWaitsIsNotOfTheNextEnvironment() {
    const QString target = folder_->filePath("late.obj");
    QVERIFY(openZUp(*window_, writeFile(*folder_, "waves.obj", wavesObj(90)), "SlopeFilter 45\n"));
    const auto before = window_->file().environment();
    DocumentState next = partOf<Document>(*window_).state();
    for (const char* name : {"VerticalClearanceFilter", "LayerSubdivisionFilter"}) {  // work that takes a while
      next.filters.push_back({partOf<Document>(*window_).newFilterId(), defaultStep(*findFilter(name), 1)});
    }
    partOf<Document>(*window_).edit(next, "more work");
    window_->exportResult(target);
    ImportOptions import;
    import.up = UpAxis::Z;
    window_->openWith(writeFile(*folder_, "floor.obj", floorObj()), std::nullopt, import);
    QVERIFY(QTest::qWaitFor([&] { return window_->file().environment() != before; }, 20000));
    const QString told = partOf<MessageBar>(*window_).text();
    QVERIFY(waitUntilIdle(*window_));
    // A run that was faster than the file is of the environment that it began with.
    if (QFile::exists(target)) {
      QVERIFY(readFile(target).contains("waves.obj"));
    } else {
      QVERIFY2(told.startsWith(target + ": not written, as another environment was opened"), qPrintable(told));
    }
  }

  void aCancelledRunTellsWhatIsNotWritten() {
    const QString target = folder_->filePath("late.obj");
    edit(80);
    window_->exportResult(target);
    window_->controller().cancel();
    QTRY_VERIFY2(partOf<MessageBar>(*window_).text().startsWith(target + ": not written"),
                 qPrintable(partOf<MessageBar>(*window_).text()));
    QVERIFY(window_->idle());
    QVERIFY(!QFile::exists(target));
  }

  void closingWaitsForWhatIsWritten() {
    std::atomic<bool> go = false;
    const QString target = folder_->filePath("slow.obj");
    window_->writer().write(
        [&] {
          while (!go) QTest::qSleep(5);
          throw RunError(Text("slow.obj: the disk is full"));
        },
        target);
    QVERIFY(!window_->close());
    QVERIFY(window_->isVisible());
    go = true;
    QTRY_VERIFY(partOf<MessageBar>(*window_).text().contains("the disk is full"));
    QVERIFY(window_->isVisible());  // the message must be visible
    go = false;
    window_->writer().write(
        [&] {
          while (!go) QTest::qSleep(5);
        },
        target);
    QVERIFY(!window_->close());
    go = true;
    QTRY_VERIFY(!window_->isVisible());
  }

  void closingAsksForWhatWaitsForTheRun() {
    const QString target = folder_->filePath("late.obj");
    edit(80);
    window_->saveSession(folder_->filePath("work.footfall"));  // nothing is unsaved
    QTRY_VERIFY(!partOf<SessionFiles>(*window_).hasUnsavedChanges() && window_->idle());
    // Another number of threads runs anew, and its findings arrive by the event loop: not before close().
    window_->controller().setThreads(3);
    window_->exportResult(target);
    QVERIFY(!window_->close());
    auto* box = window_->findChild<QMessageBox*>("pendingQuestion");
    QVERIFY(box != nullptr && !QFile::exists(target));
    QTest::keyClick(box, Qt::Key_Return);  // write, then close
    QTRY_VERIFY(!window_->isVisible());
    QVERIFY(readFile(target).contains("SlopeFilter 80"));
  }

  // --- Reports

  void aReportsPicturesAreOfTheirCameras() {
    window_->setInteractive(true);  // the camera glides
    LevelView& view = window_->view();
    view.cameraController().zoomBy(1.5);
    view.cameraController().viewFrom(ViewSide::Front);
    const QString target = folder_->filePath("report.html");
    window_->exportResult(target);
    QTRY_VERIFY(QFile::exists(target) && window_->idle());
    const CameraPose after = view.cameraController().pose();
    QVERIFY(after.orthographic && std::abs(after.orientation[0] - std::sqrt(0.5)) < 1e-6);  // along Y, as before

    QList<QImage> pictures;
    for (const QByteArray& part : readFile(target).split('"'))
      if (part.startsWith("data:image/png;base64,"))
        pictures << QImage::fromData(QByteArray::fromBase64(part.mid(22))).convertToFormat(QImage::Format_RGB32);
    QVERIFY(pictures.size() > 3);
    pictures = pictures.mid(pictures.size() - 3);  // The picture is behind the legend's.
    window_->setInteractive(false);
    const QSize seen = view.size().scaled(1600, 1000, Qt::KeepAspectRatio);
    QCOMPARE(pictures[0], view.picture(seen, 1.25));
    QCOMPARE(pictures[1], view.picture({1600, 1000}, 1.25, PictureCamera::Top));
    QCOMPARE(pictures[2], view.picture({1600, 1000}, 1.25, PictureCamera::Oblique));
    QVERIFY(pictures[1] != pictures[2]);
    // The level fills them, whatever the shape of the view.
    const QSize whole = view.size();
    view.cameraController().setCovered({});  // Nothing lies over a picture.
    view.cameraController().viewFromTop();
    const QImage jumped = view.picture(whole * view.devicePixelRatioF(), view.devicePixelRatioF());
    QCOMPARE(jumped, view.picture(whole * view.devicePixelRatioF(), view.devicePixelRatioF(), PictureCamera::Top));
  }

  void aReportHasItsDateAndLegend() {
    qputenv("SOURCE_DATE_EPOCH", "86400");
    const QString target = folder_->filePath("report.html");
    window_->exportResult(target);
    QTRY_VERIFY(QFile::exists(target) && window_->idle());
    qunsetenv("SOURCE_DATE_EPOCH");
    const QByteArray html = readFile(target);
    for (const char* text : {"on 1970-01-02 00:00 UTC", "Nothing was left out on import.", "Walkable</li>",
                             "Not walkable: removed by SlopeFilter", "Walls, ceilings and the rest"})
      QVERIFY2(html.contains(text), text);
  }

 private:
  void edit(double slope) {
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[0].id, 0, slope, -1);
  }
  void choose(const char* command) { window_->findChild<QAction*>(QLatin1String(command))->trigger(); }
  QString status() { return partOf<StatusLine>(*window_).text(); }
  ExportDialog* exportDialog() { return window_->findChild<ExportDialog*>(); }
  QLineEdit* nameField() { return exportDialog()->findChild<QLineEdit*>("fileNameEdit"); }
  QString problem() { return exportDialog()->findChild<QLabel*>("rowError")->text(); }
  QMessageBox* question() { return window_->findChild<QMessageBox*>("replaceQuestion"); }
  void openExport() {
    QTest::keyClick(window_.get(), Qt::Key_E, Qt::ControlModifier);
    if (!QTest::qWaitFor([&] { return exportDialog() != nullptr; })) qFatal("no dialog for exports");
    exportDialog()->activateWindow();
    if (!QTest::qWaitForWindowActive(exportDialog())) qFatal("the dialog does not get the focus");
  }
  void closeExport() {
    QTest::keyClick(exportDialog(), Qt::Key_Escape);
    QTRY_VERIFY(!exportDialog());
  }
  void typeName(const QString& path) {
    nameField()->setFocus();
    QTest::keyClick(nameField(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(nameField(), path);
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
  QByteArray content_;
  QString table_;
};

FOOTFALL_EDITOR_SUITE(TestFileSafety)
#include "test_file_safety.moc"
