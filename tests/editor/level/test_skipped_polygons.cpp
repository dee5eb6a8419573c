// The polygons that import left out, in the real window: the list, and the way to each place.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>

#include "tests/editor/editor_driver.hpp"
#include "ui/level/skipped_feature.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\n";

}  // namespace

class TestSkippedPolygons : public QObject {
  Q_OBJECT
 private slots:
  void aClickGoesToThePlace() {
    const QTemporaryDir folder;
    EditorWindow window;
    window.setRemembering(false);
    window.resize(1280, 800);
    QVERIFY(showWindow(window));
    const QString bad = writeFile(folder, "bad.obj", floorObj() + "f 1 2\nf 3 3 3 4\nsurf 0 1 0 1 1 2\n");
    QVERIFY(openZUp(window, bad, kPipeline));
    auto* feature = window.findChild<SkippedFeature*>();
    QVERIFY(feature);
    QVERIFY(feature->showButton()->isVisible());
    // Told once, by the button.
    QVERIFY(!window.findChild<QLabel*>("environmentFigures")->text().contains("polygon"));
    QTest::mouseClick(feature->showButton(), Qt::LeftButton);
    QTableWidget* table = feature->panel().table();
    QTRY_VERIFY(table->isVisible());
    QCOMPARE(table->rowCount(), 3);
    QCOMPARE(table->item(0, 0)->text(), QString("line 7"));
    QCOMPARE(table->item(0, 1)->text(), QString("has two corners; a polygon needs three"));
    QVERIFY(table->columnWidth(1) > table->fontMetrics().horizontalAdvance(table->item(0, 1)->text()));
    QCOMPARE(table->item(1, 0)->text(), QString("line 8"));
    QVERIFY(table->item(1, 2)->text().contains('4'));
    QCOMPARE(table->item(2, 2)->text(), QString("nowhere"));

    const CameraPose pose = window.view().cameraController().pose();
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualItemRect(table->item(1, 1)).center());
    QTRY_VERIFY(!(window.view().cameraController().pose().position == pose.position));
    const auto seen = window.view().project({0, 4, 0});  // the middle of both corners
    QVERIFY(seen && window.view().rect().contains(seen->toPoint()));
    shoot(window, "skipped");
    // Selects by the keyboard; a polygon without a place moves nothing.
    const CameraPose there = window.view().cameraController().pose();
    table->setCurrentCell(2, 0);
    table->setFocus();
    QTest::keyClick(table, Qt::Key_Return);
    QCOMPARE(window.view().cameraController().pose().position, there.position);

    // Another level, of which nothing was left out.
    QVERIFY(openZUp(window, writeFile(folder, "good.obj", floorObj()), kPipeline));
    QVERIFY(!feature->showButton()->isVisible());
    QCOMPARE(table->rowCount(), 0);
    QCOMPARE(feature->panel().summary(), QString("No polygon of the file was left out."));
  }
};

FOOTFALL_EDITOR_SUITE(TestSkippedPolygons)
#include "test_skipped_polygons.moc"
