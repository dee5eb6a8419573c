// Two results compared in the real window: with the one before an edit, and with an export.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QLabel>
#include <cmath>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/inspect/compare_feature.hpp"
#include "ui/view/widgets/legend.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

/// Pipeline of the table: its top is 1 above the floor, and the space beneath is too low for 2.
constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\n";

}  // namespace

class TestCompare : public EditorSuite {
  Q_OBJECT
 private slots:
  void init() {
    QVERIFY(openLevel(tableObj(), kPipeline));
    feature_ = window_->findChild<CompareFeature*>();
    QVERIFY(feature_);
  }
  void cleanup() { closeWindow(); }

  void theLastEdit() {
    QAction* command = window_->findChild<QAction*>("view.compareEdit");
    command->trigger();
    QVERIFY(command->isChecked());
    QVERIFY(feature_->panel().isVisible());
    QVERIFY2(feature_->panel().summary().contains("There is no edit yet"), qPrintable(feature_->panel().summary()));
    // Half a metre under the table is enough now: 4 square metres appear.
    setClearance(0.5);
    QVERIFY(waitForDifference());
    QCOMPARE(difference().areas[1].surface, 4.0);
    QVERIFY(!difference().hasArea[0]);
    QVERIFY2(feature_->panel().summary().startsWith("Appeared: 4.00 units"), qPrintable(feature_->panel().summary()));
    QVERIFY(feature_->panel().summary().contains("Disappeared: nothing"));
    QVERIFY(legend().contains("Appeared: 4.00 units") && legend().contains("Disappeared: nothing"));
    QCOMPARE(feature_->panel().table()->rowCount(), 1);
    shoot(*window_, "compare-appeared");

    // A click goes there.
    const CameraPose pose = window_->view().cameraController().pose();
    QTableWidget* table = feature_->panel().table();
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualItemRect(table->item(0, 0)).center());
    QTRY_VERIFY(!(window_->view().cameraController().pose().position == pose.position));
    shoot(*window_, "compare-framed");

    // Undo is an edit, too: they go again.
    partOf<Document>(*window_).undoStack()->undo();
    QTRY_VERIFY(waitUntilIdle(*window_) && feature_->watch().difference() && difference().hasArea[0]);
    QVERIFY(!difference().hasArea[1]);
    QCOMPARE(difference().areas[0].surface, 4.0);
    QTRY_COMPARE(table->item(0, 0)->text(), QString("disappeared"));

    command->trigger();
    QVERIFY(!feature_->watch().difference());
    QVERIFY(legend().isEmpty());
    QCOMPARE(table->rowCount(), 0);
  }

  void resultsOfOneDragAreOneEdit() {
    window_->findChild<QAction*>("view.compareEdit")->trigger();
    const int id = clearanceId();
    for (const double height : {1.9, 1.5, 0.9, 0.5}) {
      partOf<Document>(*window_).setValue(id, 0, height, 7);  // one session of the field
      QVERIFY(waitUntilIdle(*window_));
    }
    QVERIFY(waitForDifference());
    QCOMPARE(difference().areas[1].surface, 4.0);
    partOf<Document>(*window_).setValue(id, 0, 0.4, 8);
    QTRY_VERIFY(waitUntilIdle(*window_) && !feature_->watch().busy() && difference().empty());
    QTRY_VERIFY(feature_->panel().summary().contains("cover the same area"));
  }

  void aSavedResult() {
    const QString saved = folder_->filePath("saved.obj");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->exportResult(saved);
    QTRY_COMPARE(written.count(), 1);
    feature_->openSaved(saved);
    QVERIFY(waitForDifference());
    QVERIFY(difference().empty());
    QTRY_VERIFY(feature_->panel().summary().contains("cover the same area"));
    setClearance(0.5);
    QVERIFY(waitForDifference());
    QTRY_COMPARE(difference().areas[1].surface, 4.0);
    setClearance(0.4);  // still against the file
    QTRY_VERIFY(waitUntilIdle(*window_) && !feature_->watch().busy());
    QCOMPARE(difference().areas[1].surface, 4.0);
    QVERIFY(feature_->panel().choiceBox()->currentText().contains("saved.obj"));
  }

  // Distances are taken at vertices, as the thesis does: the floor that appears below the table has all of its own on
  // what was there before.
  void distancesAreColoured() {
    const QString saved = folder_->filePath("saved.obj");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->exportResult(saved);
    QTRY_COMPARE(written.count(), 1);
    feature_->openSaved(saved);
    QVERIFY(waitForDifference());
    QVERIFY(!feature_->watch().distances());
    feature_->panel().distanceBox()->click();
    QTRY_VERIFY(!feature_->watch().busy() && feature_->watch().distances());
    QCOMPARE(feature_->watch().distances()->largest, 0.0);
    QVERIFY(legend().contains("Distance to the other result"));
    QVERIFY(feature_->panel().summary().contains("Distances, taken at"));
    setClearance(0.5);
    QTRY_VERIFY(waitUntilIdle(*window_) && !feature_->watch().busy() && feature_->watch().distances());
    QVERIFY(feature_->watch().distances()->samples > 0);
    QCOMPARE(feature_->watch().distances()->largest, 0.0);
    QVERIFY(feature_->panel().summary().contains("Appeared: 4.00 units"));
    QVERIFY2(feature_->panel().summary().contains("corners: at most 0"), qPrintable(feature_->panel().summary()));
    shoot(*window_, "compare-distance");
    feature_->panel().distanceBox()->click();
    QVERIFY(!feature_->watch().distances());
    QVERIFY(!legend().contains("Distance"));
    QVERIFY(!feature_->panel().summary().contains("Distances"));
  }

  void whatIsNoResultIsSaid() {
    feature_->openSaved(writeFile(*folder_, "bad.obj", "v 0 0\n"));
    QTRY_VERIFY(partOf<MessageBar>(*window_).text().contains("bad.obj"));
    QCOMPARE(feature_->watch().with(), CompareWith::Nothing);
    QCOMPARE(feature_->panel().choiceBox()->currentIndex(), int(ComparePanel::Nothing));
  }

  void anotherLevelEndsIt() {
    window_->findChild<QAction*>("view.compareEdit")->trigger();
    setClearance(0.5);
    QVERIFY(waitForDifference());
    QVERIFY(openZUp(*window_, writeFile(*folder_, "floor.obj", floorObj()), kPipeline));
    QVERIFY(!feature_->watch().difference());
    QVERIFY(legend().isEmpty());
  }

 private:
  [[nodiscard]] const SurfaceDifference& difference() const { return *feature_->watch().difference(); }
  [[nodiscard]] QString legend() const {
    auto* notes = partOf<Legend>(*window_).findChild<QLabel*>("legendNotes");
    return notes->isHidden() ? QString() : notes->text();
  }
  [[nodiscard]] int clearanceId() const {
    for (const FilterEntry& entry : partOf<Document>(*window_).filters())
      if (entry.step.filter->type == FilterType::VerticalClearance) return entry.id;
    return 0;
  }
  void setClearance(double height) {
    partOf<Document>(*window_).setValue(clearanceId(), 0, height, -1);
    QVERIFY(waitUntilIdle(*window_));
  }
  bool waitForDifference() {
    return QTest::qWaitFor([&] { return !feature_->watch().busy() && feature_->watch().difference(); }, 20000);
  }

  CompareFeature* feature_ = nullptr;
};

FOOTFALL_EDITOR_SUITE(TestCompare)
#include "test_result_comparison.moc"
