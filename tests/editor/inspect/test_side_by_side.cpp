// Two pipelines side by side: counts, linked cameras, which one stays.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/editor/editor_driver.hpp"
#include "ui/inspect/side_by_side/side_by_side.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\nLayerSubdivisionFilter\n";

double distance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

}  // namespace

class TestSideBySide : public EditorSuite {
  Q_OBJECT

 private slots:
  void init() {
    QVERIFY(openLevel(tableObj(), kPipeline, {1440, 900}));
    side_ = window_->findChild<SideBySide*>();
    QVERIFY(side_);
  }
  void cleanup() { closeWindow(); }

  void bothAreCounted() {
    openPair();
    // The same twice: the floor without what lies under the table, and the table.
    QCOMPARE(side_->bar().cell(0, 0), side_->bar().cell(1, 0));
    QCOMPARE(side_->bar().cell(0, 1), QString("1"));
    QCOMPARE(side_->bar().cell(0, 2), QString("2"));
    QCOMPARE(side_->bar().cell(2, 0), QString("0.00 units²"));
    QCOMPARE(side_->bar().cell(2, 2), QString("0"));
    // A is edited; B stays.
    const QString before = side_->bar().cell(1, 0);
    setClearance(0.5);
    QVERIFY(waitForBoth());
    QCOMPARE(side_->bar().cell(1, 0), before);
    QTRY_COMPARE(side_->bar().cell(0, 0), QString("68.00 units²"));  // floor and table
    QCOMPARE(side_->bar().cell(2, 0), QString("\u22124.00 units²"));
    shoot(*window_, "side-by-side");
    QVERIFY(side_->other() == parsePipeline(kPipeline, "test"));
    // Both views show their own results.
    QVERIFY(window_->view().content().walkable != side_->otherView()->content().walkable);
    QVERIFY(!side_->otherView()->content().walkable.empty());
  }

  void camerasAreLinked() {
    openPair();
    CameraController& a = window_->view().cameraController();
    CameraController& b = side_->otherView()->cameraController();
    a.viewFromTop();
    QTRY_VERIFY(distance(a.pose().position, b.pose().position) < 1e-9);
    QVERIFY(b.pose().orthographic);
    b.turnBy(30, 20);
    QVERIFY(distance(a.pose().position, b.pose().position) < 1e-9);
    QVERIFY(a.pose().orientation == b.pose().orientation);
    // What is cut away is cut away in both.
    window_->view().setHeights({0, 0.5});
    QTRY_VERIFY(side_->otherView()->heights() == window_->view().heights());
    window_->view().setMode(ViewMode::WalkableOnly);
    QTRY_COMPARE(side_->otherView()->mode(), ViewMode::WalkableOnly);
    window_->view().setMode(ViewMode::Slope);
    QTRY_COMPARE(side_->otherView()->mode(), ViewMode::Result);  // B has no scale
    // Each has half of the place, and the camera is where it was afterwards.
    QVERIFY(std::abs(window_->view().width() - side_->otherView()->width()) < 12);
    const CameraPose pose = a.pose();
    QTest::mouseClick(side_->bar().keepAButton(), Qt::LeftButton);
    QVERIFY(!side_->isOpen() && !side_->otherView());
    QTest::qWait(50);
    QVERIFY(distance(a.pose().position, pose.position) < 1e-9);
    QVERIFY(!window_->findChild<QAction*>("view.sideBySide")->isChecked());
  }

  // Each half shows all that was in sight, and the one view afterwards is as large as it was.
  void aWideLevelFitsIntoTheHalves_data() {
    QTest::addColumn<bool>("fromTop");
    QTest::newRow("oblique") << false;
    QTest::newRow("from the top") << true;
  }
  void aWideLevelFitsIntoTheHalves() {
    QFETCH(const bool, fromTop);
    const QByteArray street = "v -40 -4 0\nv 40 -4 0\nv 40 4 0\nv -40 4 0\nf 1 2 3\nf 1 3 4\n";
    QVERIFY(openZUp(*window_, writeFile(*folder_, "street.obj", street), kPipeline));
    CameraController& camera = window_->view().cameraController();
    if (fromTop) camera.viewFromTop();
    const auto isInSight = [&](LevelView& view) {
      return std::ranges::all_of(std::array{-40.0, 40.0}, [&](double x) {
        return std::ranges::all_of(std::array{-4.0, 4.0}, [&](double y) {
          const auto at = view.project({x, y, 0});
          return at && QRectF(view.rect()).contains(*at);
        });
      });
    };
    QVERIFY(isInSight(window_->view()));
    const CameraPose before = camera.pose();
    openPair();
    QTRY_VERIFY(isInSight(window_->view()));
    QTRY_VERIFY(isInSight(*side_->otherView()));
    QTest::mouseClick(side_->bar().keepAButton(), Qt::LeftButton);
    QTRY_VERIFY(distance(camera.pose().position, before.position) < 1e-6);
  }

  void oneOfThemStays() {
    openPair();
    setClearance(0.5);
    QVERIFY(waitForBoth());
    const Pipeline a = partOf<Document>(*window_).pipeline();
    const Pipeline b = side_->other();
    QVERIFY(!(a == b));
    QTest::mouseClick(side_->bar().swapButton(), Qt::LeftButton);
    QVERIFY(partOf<Document>(*window_).pipeline() == b && side_->other() == a);
    QVERIFY(waitForBoth());
    QTRY_COMPARE(side_->bar().cell(1, 0), QString("68.00 units²"));
    QCOMPARE(side_->bar().cell(2, 0), QString("+4.00 units²"));
    QTest::mouseClick(side_->bar().keepBButton(), Qt::LeftButton);
    QVERIFY(!side_->isOpen());
    QVERIFY(partOf<Document>(*window_).pipeline() == a);
    QCOMPARE(partOf<Document>(*window_).undoStack()->undoText(), QString("Keep pipeline B"));
    partOf<Document>(*window_).undoStack()->undo();
    QVERIFY(partOf<Document>(*window_).pipeline() == b);
  }

  void sourcesOfB() {
    openPair();
    QMenu* menu = side_->bar().sources();
    emit menu->aboutToShow();
    QAction* preset = nullptr;
    for (QAction* action : menu->actions())
      if (action->text() == builtInName()) preset = action;
    QVERIFY(preset);
    preset->trigger();
    QVERIFY(waitForBoth());
    QVERIFY(!(side_->other() == parsePipeline(kPipeline, "test")));
    QVERIFY(partOf<Document>(*window_).pipeline() == parsePipeline(kPipeline, "test"));
    // One that fails says so, and the view keeps what it showed.
    side_->open(parsePipeline("SlopeFilter 45\nReachableFilter 100 100 100\n", "test"), "fails");
    QTRY_VERIFY2(side_->bar().note().startsWith("B: "), qPrintable(side_->bar().note()));
    QCOMPARE(side_->bar().cell(2, 0), QString("…"));
  }

  void followsTheLevel() {
    openPair();
    // An obstacle is an obstacle for both.
    DocumentState next = partOf<Document>(*window_).state();
    PlacedObstacle box;
    box.id = 1;
    box.name = "box";
    box.base = {-3, -3, 0};
    box.size = {1, 1, 1};
    next.obstacles.push_back(box);
    const QString before = side_->bar().cell(1, 2);
    partOf<Document>(*window_).edit(next, "place a box");
    QVERIFY(waitForBoth());
    QTRY_VERIFY(side_->bar().cell(1, 2) != before && side_->bar().cell(1, 2) != "…");  // its top is a part
    QTRY_COMPARE(side_->bar().cell(0, 2), side_->bar().cell(1, 2));
    QTRY_VERIFY(side_->otherView()->environmentGeometry() == window_->view().environmentGeometry());
    // A session keeps B.
    const QString session = folder_->filePath("pair.footfall");
    window_->saveSession(session);
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(openZUp(*window_, writeFile(*folder_, "floor.obj", floorObj()), "SlopeFilter 45\n"));
    QVERIFY(!side_->isOpen());  // another level
    window_->open(session);
    QVERIFY(QTest::qWaitFor([&] { return side_->isOpen(); }, kWaitMs));
    QVERIFY(waitForBoth());
    QVERIFY(side_->other() == parsePipeline(kPipeline, "test"));
    QTRY_COMPARE(side_->bar().cell(2, 0), QString("0.00 units²"));
  }

  void nothingToCompareBeforeALevel() {
    EditorWindow empty;
    empty.setRemembering(false);
    QVERIFY(!empty.findChild<QAction*>("view.sideBySide")->isEnabled());
  }

 private:
  static QString builtInName() { return "Parallel"; }
  void openPair() {
    window_->findChild<QAction*>("view.sideBySide")->trigger();
    QVERIFY(side_->isOpen());
    QVERIFY(window_->findChild<QAction*>("view.sideBySide")->isChecked());
    QVERIFY(waitForBoth());
    QTRY_VERIFY(side_->bar().cell(2, 0) != "…");
  }
  bool waitForBoth() {
    return waitUntilIdle(*window_) && QTest::qWaitFor([&] { return !side_->isBusy(); }, kWaitMs);
  }
  void setClearance(double value) {
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[1].id, 0, value, -1);
    QVERIFY(waitUntilIdle(*window_));
  }

  SideBySide* side_ = nullptr;
};

FOOTFALL_EDITOR_SUITE(TestSideBySide)
#include "test_side_by_side.moc"
