// The editor as a person drives it: mouse, keys, files.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDropEvent>
#include <QMimeData>
#include <QProgressBar>

#include "core/io/export.hpp"
#include "core/io/import.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/report.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/level/import_panel.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "DegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 0.5\n";

double slopeOf(EditorWindow& window) { return partOf<Document>(window).filters()[1].step.values[0]; }

}  // namespace

class TestEditorWindow : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    table_ = writeFile(*folder_, "table.obj", tableObj());
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1100, 800);
    QVERIFY(showWindow(*window_));
  }
  void cleanup() { window_.reset(); }

  void opensThroughTheDialog() {
    QTest::keyClick(window_.get(), Qt::Key_O, Qt::ControlModifier);
    answerFileDialog(table_);
    QVERIFY(QTest::qWaitFor([&] { return window_->file().environment() != nullptr; }));
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(window_->file().environment()->triangles.size(), std::size_t{6});
    QCOMPARE(filterNames(*window_).size(), 8);  // the default pipeline
    QCOMPARE(QSettings().value("recentFiles").toStringList().value(0), table_);
  }

  void opensWhatIsDropped() {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(table_)});
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window_.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window_.get(), &drop);
    QVERIFY(QTest::qWaitFor([&] { return window_->file().environment() != nullptr; }));
  }

  void rowsShowStatesTimesAndCounts() {
    QVERIFY(openZUp(*window_, table_, kPipeline));
    for (FilterRow* row : partOf<FilterList>(*window_).rows()) QCOMPARE(row->stateText(), QString("done"));
    const StepStatus slope = window_->controller().status(partOf<Document>(*window_).filters()[1].id);
    QVERIFY(slope.wallMs.has_value());
    QCOMPARE(*slope.trianglesIn, std::uint64_t{6});
    QCOMPARE(*slope.trianglesOut, std::uint64_t{4});  // not the ramp
  }

  void reordersByDragging() {
    QVERIFY(openZUp(*window_, table_, kPipeline));
    const auto& rows = partOf<FilterList>(*window_).rows();
    QWidget* handle = rows[3]->handle();
    const QPoint grip = handle->rect().center();
    const QPoint above = handle->mapFromGlobal(rows[0]->mapToGlobal(QPoint(30, 4)));
    QTest::mousePress(handle, Qt::LeftButton, Qt::NoModifier, grip);
    QTest::mouseMove(handle, (grip + above) / 2);
    QTest::mouseMove(handle, above);
    QTest::mouseRelease(handle, Qt::LeftButton, Qt::NoModifier, above);
    QCOMPARE(filterNames(*window_).front(), QString("AreaFilter"));
    QCOMPARE(partOf<FilterList>(*window_).rows().front()->handle(), handle);  // the row itself has moved
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->controller().upToDate());
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(filterNames(*window_).back(), QString("AreaFilter"));
  }

  void reordersByKeys() {
    QVERIFY(openZUp(*window_, table_, kPipeline));
    QTest::keyClick(partOf<FilterList>(*window_).rows()[1]->enabledBox(), Qt::Key_Down, Qt::AltModifier);
    QCOMPARE(filterNames(*window_)[2], QString("SlopeFilter"));
  }

  void typedValuesKeepFullPrecisionAndRun() {
    QVERIFY(openZUp(*window_, table_, kPipeline));
    auto* field = openField(*window_, 1);
    QVERIFY(field);
    QTest::mouseDClick(field, Qt::LeftButton);
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, "60.12345678901234");
    QCOMPARE(slopeOf(*window_), 60.12345678901234);
    QCOMPARE(field->text(), QString("60.12345678901234"));
    QVERIFY(waitUntilIdle(*window_));
    const auto rows = partOf<FilterList>(*window_).rows();
    QCOMPARE(rows[0]->stateText(), QString("cached"));
    QCOMPARE(rows[1]->stateText(), QString("done"));
    const StepStatus slope = window_->controller().status(rows[1]->entryId());
    QCOMPARE(*slope.trianglesOut, std::uint64_t{6});  // the ramp as well

    // All that was typed into the field is one edit, also while the field has the focus.
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(slopeOf(*window_), 45.0);
    QCOMPARE(field->text(), QString("45"));
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(slopeOf(*window_), 60.12345678901234);
  }

  void invalidValuesAreToldAndNotTaken() {
    QVERIFY(openZUp(*window_, table_, kPipeline));
    FilterRow* row = partOf<FilterList>(*window_).rows()[1];
    auto* field = openField(*window_, 1);
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, "95");
    QCOMPARE(slopeOf(*window_), 9.0);  // the last valid one on the way
    QCOMPARE(field->text(), QString("95"));
    QVERIFY(row->errorText().contains("95 is out of range"));
    QTest::keyClick(field, Qt::Key_Escape);
    QCOMPARE(field->text(), QString("9"));
    QVERIFY(row->errorText().isEmpty());
  }

  void switchesFiltersOffAndOn() {
    QVERIFY(openZUp(*window_, table_, kPipeline));
    const double before = window_->controller().finishedRun()->result.summary.area;
    QCheckBox* box = partOf<FilterList>(*window_).rows()[2]->enabledBox();
    QTest::mouseClick(box, Qt::LeftButton, Qt::NoModifier, QPoint(8, box->height() / 2));
    QVERIFY(!partOf<Document>(*window_).filters()[2].step.enabled);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(partOf<FilterList>(*window_).rows()[2]->stateText(), QString("off"));
    QVERIFY(window_->controller().finishedRun()->result.summary.area > before + 3.9);  // area under the table: 4
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(partOf<Document>(*window_).filters()[2].step.enabled);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(window_->controller().finishedRun()->result.summary.area, before);
  }

  void addsAndRemovesFilters() {
    QVERIFY(openZUp(*window_, table_, kPipeline));
    QMenu* menu = partOf<FilterList>(*window_).addButton()->menu();
    emit menu->aboutToShow();
    for (QAction* action : menu->actions()) {
      if (action->data() == QVariant("LayerSubdivisionFilter")) action->trigger();
    }
    QCOMPARE(filterNames(*window_).back(), QString("LayerSubdivisionFilter"));
    QTest::mouseClick(partOf<FilterList>(*window_).rows()[0]->removeButton(), Qt::LeftButton);
    QTRY_COMPARE(filterNames(*window_).size(), 4);
    QCOMPARE(filterNames(*window_).front(), QString("SlopeFilter"));
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(filterNames(*window_).size(), 4);
    QCOMPARE(filterNames(*window_).front(), QString("DegeneracyFilter"));
  }

  void editsThatChangeNothingRunNothing() {
    QVERIFY(openZUp(*window_, table_, kPipeline));
    const QSignalSpy started(&window_->controller(), &RunController::started);
    QCheckBox* box = partOf<FilterList>(*window_).rows()[2]->enabledBox();
    box->click();
    box->click();
    QTest::qWait(500);
    QCOMPARE(started.count(), 0);
    QVERIFY(window_->controller().upToDate());
  }

  void cancelKeepsTheOldResult() {
    QVERIFY(openZUp(*window_, writeFile(*folder_, "waves.obj", wavesObj(60)), kPipeline));
    const auto before = window_->controller().finishedRun();
    const std::size_t shown = window_->view().content().walkable.size();
    const QSignalSpy cancelled(&window_->controller(), &RunController::cancelled);
    connect(&window_->controller(), &RunController::started, window_.get(),
            [&] { window_->findChild<QPushButton*>("cancel")->click(); });  // it appears when a run takes a while
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[1].id, 0, 30, 0);
    QTRY_COMPARE(cancelled.count(), 1);
    QVERIFY(!window_->controller().busy());
    QCOMPARE(window_->controller().finishedRun(), before);
    QCOMPARE(window_->view().content().walkable.size(), shown);
    QCOMPARE(partOf<FilterList>(*window_).rows()[3]->stateText(), QString("cancelled"));
    QVERIFY(!window_->findChild<QPushButton*>("cancel")->isVisible());
  }

  void failingStepsAreToldOnTheirRow() {
    QVERIFY(openZUp(*window_, table_, kPipeline));
    partOf<Document>(*window_).addFilter(filterDescriptor(FilterType::Collapse), 1);
    QVERIFY(waitUntilIdle(*window_));
    FilterRow* row = partOf<FilterList>(*window_).rows().back();
    QCOMPARE(row->stateText(), QString("failed"));
    QVERIFY(row->errorText().contains("strategy"));
    QVERIFY(partOf<MessageBar>(*window_).isVisible());
    QVERIFY(window_->controller().finishedRun() != nullptr);
    QTest::mouseClick(row->removeButton(), Qt::LeftButton);
    QTRY_VERIFY(!partOf<MessageBar>(*window_).isVisible());
  }

  void badFilesKeepWhatWasThere() {
    QVERIFY(openZUp(*window_, table_, kPipeline));
    const auto before = window_->file().environment();
    const QString missing = folder_->filePath("missing.obj");
    for (const QString& path :
         {missing, writeFile(*folder_, "empty.obj", ""), writeFile(*folder_, "bad.obj", "f 1 2 9\n"),
          writeFile(*folder_, "bad.footfall", "{\"footfall_session\": 1"), folder_->path()}) {
      QSignalSpy failed(window_.get(), &EditorWindow::loadFailed);
      window_->open(path);
      QVERIFY(failed.count() > 0 || failed.wait());
      QVERIFY(partOf<MessageBar>(*window_).isVisible());
      QVERIFY(partOf<MessageBar>(*window_).text().contains(path));
      QVERIFY(!partOf<MessageBar>(*window_).text().contains('\n'));
      QCOMPARE(window_->file().environment(), before);
      QVERIFY(window_->controller().upToDate());
      QVERIFY(!window_->view().content().walkable.empty());
    }
    try {
      importEnvironment(missing.toStdString());
      QFAIL("a missing file was read");
    } catch (const InputError& error) {
      window_->open(missing);
      QTRY_COMPARE(partOf<MessageBar>(*window_).text(), QString(error.what()));
    }
  }

  void exportsWhatTheCoreWrites() {
    QVERIFY(openZUp(*window_, table_, kPipeline));
    const QString target = folder_->filePath("result.obj");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    QTest::keyClick(window_.get(), Qt::Key_E, Qt::ControlModifier);
    answerFileDialog(target);
    QVERIFY(written.count() > 0 || written.wait());
    const auto run = window_->controller().finishedRun();
    const std::string expected = formatObj(*run->result.mesh, makeExportHeader(run->pipeline));
    QCOMPARE(readFile(target), QByteArray::fromStdString(expected));
    QVERIFY(expected.find("\nf ") != std::string::npos);
  }

  void exportThatFailsIsTold() {
    QVERIFY(openZUp(*window_, table_, kPipeline));
    window_->exportResult(folder_->filePath("no/such/folder/result.obj"));
    QTRY_VERIFY(partOf<MessageBar>(*window_).text().contains("no/such/folder"));
    QVERIFY(partOf<MessageBar>(*window_).isVisible());
  }

  void importOptionsCanBeEditedAndUndone() {
    QVERIFY(openZUp(*window_, table_, kPipeline));
    QTest::mouseClick(partOf<ImportPanel>(*window_).bothSidesBox(), Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
    QTRY_VERIFY(window_->file().environment()->bothSides);
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(!window_->file().environment()->bothSides);
    QCOMPARE(window_->file().environment()->up, UpAxis::Z);
  }

  void scaleMovesDefaultsAlong() {
    window_->openWith(table_, std::nullopt, {});
    QVERIFY(waitUntilIdle(*window_) && window_->file().environment());
    NumberField* scale = partOf<ImportPanel>(*window_).scaleField();
    scale->setFocus();
    QTest::keyClick(scale, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(scale, "0.05");
    QCOMPARE(window_->file().environment()->metresPerUnit, 0.05);
    QCOMPARE(partOf<Document>(*window_).filters()[3].step.values[0], 40.0);
    QTest::keyClick(scale, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(partOf<Document>(*window_).filters()[3].step.values[0], 2.0);
    QCOMPARE(window_->file().environment()->metresPerUnit, 1.0);
    QCOMPARE(scale->text(), QString("1"));
  }

  void sessionsComeBackAsTheyWere() {
    QVERIFY(
        openZUp(*window_, table_, "SlopeFilter 12.3456789012345678\n#off AreaFilter 3\nVerticalClearanceFilter 0.7\n"));
    window_->view().cameraController().viewFromTop();
    window_->view().cameraController().zoomBy(1.7);
    const CameraPose pose = window_->view().cameraController().pose();
    const QString path = folder_->filePath("work.footfall");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(path);
    QVERIFY(written.count() > 0 || written.wait());
    QVERIFY(readFile(path).contains("\"environment\": \"table.obj\""));  // can be moved with its file

    EditorWindow other;
    other.resize(1100, 800);
    QVERIFY(showWindow(other));
    other.open(path);
    QVERIFY(QTest::qWaitFor([&] { return other.file().environment() != nullptr; }));
    QVERIFY(waitUntilIdle(other));
    QCOMPARE(partOf<Document>(other).pipeline(), partOf<Document>(*window_).pipeline());
    QVERIFY(sameImport(partOf<Document>(other).state().import, partOf<Document>(*window_).state().import));
    const CameraPose back = other.view().cameraController().pose();
    QVERIFY(back.orthographic);
    QVERIFY(std::abs(back.position.x - pose.position.x) < 1e-9);
    QVERIFY(std::abs(back.position.z - pose.position.z) < 1e-9);
    QVERIFY(std::abs(back.orientation[3] - pose.orientation[3]) < 1e-9);
  }

  void theLastSessionIsOffered() {
    QVERIFY(openZUp(*window_, table_, kPipeline));
    window_->close();
    window_.reset();
    EditorWindow other;
    other.show();
    other.continueLastSession();
    QVERIFY(QTest::qWaitFor([&] { return other.file().environment() != nullptr; }));
    QCOMPARE(filterNames(other).size(), 4);
  }

  void theWindowAnswersWhileItWorks() {
    window_->openWith(writeFile(*folder_, "waves.obj", wavesObj(120)), parsePipeline(kPipeline, "test"), {});
    QElapsedTimer sinceLast;
    qint64 longest = 0;
    sinceLast.start();
    QTimer beat;
    connect(&beat, &QTimer::timeout, [&] { longest = std::max(longest, sinceLast.restart()); });
    beat.start(5);
    QVERIFY(QTest::qWaitFor([&] { return window_->file().environment() != nullptr; }, 20000));
    QVERIFY(waitUntilIdle(*window_));
    qInfo("longest pause of the window: %lld ms", static_cast<long long>(longest));
    QVERIFY2(longest < 1000, "the window froze");
  }

 private:
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
  QString table_;
};

FOOTFALL_EDITOR_SUITE(TestEditorWindow)
#include "test_editor_window.moc"
