// Measuring in the real window: by mouse and keyboard, with vertices to snap to.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QInputDialog>
#include <QPushButton>
#include <QTableWidget>
#include <cmath>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/inspect/measure_panel.hpp"
#include "ui/level/import_panel.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

class TestMeasureTool : public QObject {
  Q_OBJECT
 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    window_ = std::make_unique<EditorWindow>();
    window_->setRemembering(false);
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
    QVERIFY(openZUp(*window_, writeFile(*folder_, "table.obj", tableObj()), "SlopeFilter 45\n"));
    tool_ = &window_->findChild<MeasureFeature*>()->tool();
  }
  void cleanup() {
    window_.reset();
    folder_.reset();
  }

  void numbers() {
    const Measure up = measureBetween({1, 1, 0}, {4, 5, 5});
    QCOMPARE(up.plan, 5.0);
    QCOMPARE(up.height, 5.0);
    QCOMPARE(up.distance, std::sqrt(50.0));
    QCOMPARE(up.degrees, 45.0);
    QCOMPARE(up.percent, 100.0);
    const Measure down = measureBetween({0, 0, 2}, {0, 0, 0});
    QCOMPARE(down.degrees, -90.0);
    QVERIFY(std::isinf(down.percent) && down.percent < 0);
    const Measure none = measureBetween({1, 2, 3}, {1, 2, 3});
    QCOMPARE(none.degrees, 0.0);
    QCOMPARE(none.percent, 0.0);
    // Height differences below the rounding of clicks count as zero.
    const Measure level = measureBetween({0, 0, 0}, {5, 0, 7.39172e-7});
    QCOMPARE(level.height, 0.0);
    QCOMPARE(level.percent, 0.0);
  }

  void theLastPieceSetsTheScale() {
    startTool();
    tool_->setPlaces({{0, 0, 0}, {0, 0, 4}});
    press("measureScale");
    QInputDialog* dialog = nullptr;
    QTRY_VERIFY((dialog = window_->findChild<QInputDialog*>("scaleByReference")) != nullptr);
    dialog->setDoubleValue(2);
    dialog->accept();
    QTRY_COMPARE_WITH_TIMEOUT(partOf<ImportPanel>(*window_).scaleField()->value(), 0.5, kWaitMs);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(partOf<Document>(*window_).state().import.metresPerUnit.value(), 0.5);
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!partOf<Document>(*window_).state().import.metresPerUnit.has_value());
  }

  void clicksMeasureAndSnap() {
    startTool();
    // Near corners of the floor and of the table: the corners are meant.
    click({-4, -4, 0}, {4, -3});
    QCOMPARE(tool_->places().size(), 1U);
    QCOMPARE(tool_->places()[0], (Vec3{-4, -4, 0}));
    click({1, 1, 1}, {-3, 4});
    QCOMPARE(tool_->places()[1], (Vec3{1, 1, 1}));
    auto* table = window_->findChild<QTableWidget*>("measureTable");
    QCOMPARE(table->rowCount(), 1);
    for (int column = 0; column < table->columnCount(); ++column) {
      const QHeaderView& header = *table->horizontalHeader();
      const QString text = table->horizontalHeaderItem(column)->text();
      QVERIFY2(header.fontMetrics().horizontalAdvance(text) <= header.sectionSize(column), qPrintable(text));
    }
    QCOMPARE(table->item(0, 0)->text(), QString("7.141"));
    QCOMPARE(table->item(0, 1)->text(), QString("7.071"));
    QCOMPARE(table->item(0, 2)->text(), QString("1"));
    QCOMPARE(table->item(0, 3)->text(), QString("8.0"));
    QCOMPARE(table->item(0, 4)->text(), QString("14.1"));
    // Far from all corners, the surface is meant.
    click({-2, 2.5, 0}, {0, 0});
    QVERIFY(std::fabs(tool_->places()[2].x + 2) < 0.1 && std::fabs(tool_->places()[2].y - 2.5) < 0.1);
    QCOMPARE(table->rowCount(), 2);
    QVERIFY(window_->findChild<QLabel*>("measureSum")->text().startsWith("Together "));
    shoot(*window_, "measure");
  }

  void hiddenVerticesAreNotMeant() {
    startTool();
    const Vec3 corner{1, 1, 1};
    window_->view().setHeights({-1, 0.5});  // the table is cut away
    click(corner, {0, 0});
    QCOMPARE(tool_->places().size(), 1U);
    QVERIFY(!(tool_->places()[0] == corner));
    QVERIFY(std::fabs(tool_->places()[0].z) < 1e-6);
  }

  void keysCopyTakeBackAndEnd() {
    startTool();
    click({-4, -4, 0}, {0, 0});
    click({4, -4, 0}, {0, 0});
    QTest::keyClick(&window_->view(), Qt::Key_C, Qt::ControlModifier);
    const QStringList lines = QApplication::clipboard()->text().split('\n');
    QCOMPARE(lines.size(), 5);
    QCOMPARE(lines[2], QString("4\t-4\t0\t8\t8\t0\t0\t0"));
    QCOMPARE(lines[3], QString("Places are in the file's frame (Z up), in units"));
    QTest::keyClick(&window_->view(), Qt::Key_Backspace);
    QCOMPARE(tool_->places().size(), 1U);
    click({4, 4, 0}, {0, 0});
    QTest::keyClick(&window_->view(), Qt::Key_Return);
    click({-4, 4, 0}, {0, 0});  // begins another line
    QCOMPARE(tool_->places().size(), 1U);
    QTest::keyClick(&window_->view(), Qt::Key_Escape);
    QCOMPARE(window_->view().tool(), nullptr);
    QVERIFY(!window_->findChild<QAction*>("tools.measure")->isChecked());
  }

  void aDoubleClickEndsTheLine() {
    startTool();
    click({-4, -4, 0}, {0, 0});
    click({4, -4, 0}, {0, 0});
    click({4, -4, 0}, {0, 0});
    QCOMPARE(tool_->places().size(), 2U);
    click({4, 4, 0}, {0, 0});
    QCOMPARE(tool_->places().size(), 1U);
  }

  void buttonsWorkByKeyboard() {
    startTool();
    click({-4, -4, 0}, {0, 0});
    click({4, -4, 0}, {0, 0});
    click({4, 4, 0}, {0, 0});
    press("measureCopy");
    QVERIFY(QApplication::clipboard()->text().contains("sum\t\t\t16\t16\t0"));
    press("measureBack");
    QCOMPARE(tool_->places().size(), 2U);
    press("measureClear");
    QCOMPARE(tool_->places().size(), 0U);
    QVERIFY(!window_->findChild<QPushButton*>("measureCopy")->isEnabled());
  }

  void anotherEnvironmentTakesItBack() {
    startTool();
    click({-4, -4, 0}, {0, 0});
    QVERIFY(openZUp(*window_, writeFile(*folder_, "floor.obj", floorObj()), "SlopeFilter 45\n"));
    QVERIFY(tool_->places().empty());
  }

 private:
  void startTool() {
    window_->view().cameraController().viewFromTop();
    QTest::keyClick(window_.get(), Qt::Key_M);
    QVERIFY(window_->findChild<QAction*>("tools.measure")->isChecked());
    QVERIFY(window_->findChild<QDockWidget*>("panel.measure")->isVisible());
    QTest::qWait(50);
  }
  void click(const Vec3& place, const QPoint& beside) {
    const QPoint at = window_->view().project(place)->toPoint() + beside;
    QTest::mouseMove(&window_->view(), at);
    QTest::mouseClick(&window_->view(), Qt::LeftButton, {}, at);
  }
  void press(const char* name) {
    auto* button = window_->findChild<QPushButton*>(name);
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Space);
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
  MeasureTool* tool_ = nullptr;
};

FOOTFALL_EDITOR_SUITE(TestMeasureTool)
#include "test_measure_tool.moc"
