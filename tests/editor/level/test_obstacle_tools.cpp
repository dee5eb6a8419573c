// Obstacles by mouse and keyboard in the real window: placing, handles, numbers, undo, sessions and exports.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>
#include <string>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "tests/support/run_filters.hpp"
#include "ui/level/import_panel.hpp"
#include "ui/level/obstacle_features.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;
using Handle = ObstacleHandle;
using Shape = PlacedObstacle::Shape;

namespace {

/// Two rooms of 6 x 6, left and right of a wall without thickness that is 3 high, with a doorway of 1 in its middle.
QByteArray roomsObj() {
  return "v -6 -3 0\nv 6 -3 0\nv 6 3 0\nv -6 3 0\nf 1 2 3 4\n"
         "v 0 -3 0\nv 0 -0.5 0\nv 0 -0.5 3\nv 0 -3 3\nf 5 6 7 8\n"
         "v 0 0.5 0\nv 0 3 0\nv 0 3 3\nv 0 0.5 3\nf 9 10 11 12\n";
}

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 2\n";

}  // namespace

class TestObstacleTools : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    window_ = std::make_unique<EditorWindow>();
    window_->setRemembering(false);
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
    QVERIFY(openZUp(*window_, writeFile(folder_, "rooms.obj", roomsObj()), kPipeline));
    features_ = window_->findChild<ObstacleFeatures*>();
    QVERIFY(features_);
    view().cameraController().viewFromTop();
    view().setFocus();
  }
  void cleanup() {
    window_.reset();
    features_ = nullptr;
  }

  // The crate closes the doorway; moved away, it opens it again.
  void aCrateInADoorway() {
    QCOMPARE(rooms(), std::size_t{1});
    const double before = walkableArea();
    const QByteArray empty = exported("before.obj");
    command("obstacle.box")->trigger();
    QVERIFY(view().tool() == &features_->placeTool(Shape::Box));
    move({0, 0, 0}, Qt::NoButton, Qt::ShiftModifier);
    QVERIFY(features_->placeTool(Shape::Box).preview());
    click({0, 0, 0}, Qt::ShiftModifier);
    QCOMPARE(features_->editor().obstacles().size(), std::size_t{1});
    QCOMPARE(obstacle().base, (Vec3{0, 0, 0}));
    QCOMPARE(obstacle().size, (Vec3{1, 1, 1}));
    QCOMPARE(QString::fromStdString(obstacle().name), QStringLiteral("Box 1"));
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(rooms(), std::size_t{2});
    QVERIFY(std::abs(walkableArea() - (before - 1)) < 1e-9);
    QVERIFY(exported("closed.obj") != empty);
    // The tool for moving it has taken over, with the crate selected.
    QVERIFY(view().tool() == &features_->selectTool());
    QVERIFY(features_->editor().selected());

    drag(handle(Handle::MovePlan), {3, 1, 0}, Qt::ShiftModifier);
    QVERIFY(obstacle().base.x > 2 && obstacle().base.y >= 0.25);
    QCOMPARE(obstacle().base.z, 0.0);
    QCOMPARE(partOf<Document>(*window_).undoStack()->count(), 2);
    QCOMPARE(partOf<Document>(*window_).undoStack()->undoText(), QStringLiteral("Move Box 1"));
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(rooms(), std::size_t{1});

    QTest::keyClick(&view(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(obstacle().base, (Vec3{0, 0, 0}));
    QCOMPARE(rooms(), std::size_t{2});
    QTest::keyClick(&view(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(features_->editor().obstacles().empty());
    QCOMPARE(rooms(), std::size_t{1});
    QCOMPARE(exported("after.obj"), empty);
    QTest::keyClick(&view(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(rooms(), std::size_t{2});
  }

  void basesAndHeightsAreDrawn() {
    view().cameraController().viewOblique();
    for (const Shape shape : {Shape::Box, Shape::Cylinder, Shape::Ramp}) {
      view().setTool(&features_->placeTool(shape));
      press({-4, -2, 0});
      move({-3, -1, 0}, Qt::LeftButton);
      move({-2.5, 1, 0}, Qt::LeftButton);
      release({-2.5, 1, 0});
      QVERIFY(features_->editor().obstacles().empty());
      // Upward on the screen is higher.
      const QPoint end = at({-2.5, 1, 0});
      for (int i = 1; i <= 5; ++i) send(QEvent::MouseMove, end - QPoint(0, 12 * i), Qt::NoButton, Qt::NoButton, {});
      const auto preview = features_->placeTool(shape).preview();
      QVERIFY(preview && preview->size.z > 0.5);
      QTest::mouseClick(&view(), Qt::LeftButton, Qt::NoModifier, end - QPoint(0, 60));
      QCOMPARE(features_->editor().obstacles().size(), std::size_t{1});
      const PlacedObstacle made = obstacle();
      QVERIFY(made.shape == shape);
      QVERIFY(std::abs(made.base.x + 3.25) < 0.1 && std::abs(made.base.y + 0.5) < 0.1);
      const bool ramp = shape == Shape::Ramp;  // along the longer side, upward the way it was drawn
      QVERIFY(std::abs((ramp ? made.size.y : made.size.x) - 1.5) < 0.1);
      QVERIFY(std::abs((ramp ? made.size.x : made.size.y) - 3) < 0.1);
      QCOMPARE(made.turn, ramp ? 90.0 : 0.0);
      QCOMPARE(made.size.z, preview->size.z);
      QTest::keyClick(&view(), Qt::Key_Delete);
      QVERIFY(features_->editor().obstacles().empty());
    }
    // Esc takes back what is begun and keeps the tool, then ends it.
    view().setTool(&features_->placeTool(Shape::Box));
    press({-4, -2, 0});
    move({-2, 0, 0}, Qt::LeftButton);
    release({-2, 0, 0});
    QTest::keyClick(&view(), Qt::Key_Escape);
    QVERIFY(view().tool() == &features_->placeTool(Shape::Box));
    QTest::keyClick(&view(), Qt::Key_Escape);
    QVERIFY(!view().tool());
    QVERIFY(features_->editor().obstacles().empty());
  }

  void handlesMoveTurnAndResize() {
    view().cameraController().viewOblique();
    place({Shape::Box, {-3, 0, 0}});
    const PlacedObstacle start = obstacle();
    const auto along = [&](Handle which, const Vec3& by) {
      const Vec3 from = placeOfHandle(which);
      drag(at(from), at({from.x + by.x, from.y + by.y, from.z + by.z}));
      const PlacedObstacle result = obstacle();
      partOf<Document>(*window_).undoStack()->undo();
      return result;
    };
    PlacedObstacle after = along(Handle::MoveX, {1.5, 0, 0});
    QVERIFY(std::abs(after.base.x + 1.5) < 0.15 && after.base.y == 0 && after.base.z == 0);
    after = along(Handle::MoveY, {0, -1, 0});
    QVERIFY(std::abs(after.base.y + 1) < 0.15 && after.base.x == -3);
    after = along(Handle::MoveZ, {0, 0, 1});
    QVERIFY(std::abs(after.base.z - 1) < 0.15 && after.base.x == -3);
    after = along(Handle::UpperX, {1, 0, 0});
    QVERIFY(std::abs(after.size.x - 2) < 0.15);
    QVERIFY(std::abs((after.base.x - after.size.x / 2) - (-3.5)) < 1e-9);  // the other side stays
    after = along(Handle::LowerY, {0, -1, 0});
    QVERIFY(std::abs(after.size.y - 2) < 0.15);
    QVERIFY(std::abs((after.base.y + after.size.y / 2) - 0.5) < 1e-9);
    after = along(Handle::Top, {0, 0, 1.5});
    QVERIFY(std::abs(after.size.z - 2.5) < 0.2 && after.base == start.base);
    after = along(Handle::Top, {0, 0, -9});
    QVERIFY(after.size.z > 0);
    // The ring: a quarter of it, from between two axes to between the next two.
    const Vec3 grip = placeOfHandle(Handle::Turn);
    const double x = grip.x + 3, y = grip.y;
    after = along(Handle::Turn, {-y - x, x - y, 0});
    QVERIFY(std::abs(after.turn - 90) < 3);
    QCOMPARE(obstacle(), start);
    QCOMPARE(partOf<Document>(*window_).undoStack()->redoText(), QStringLiteral("Turn Box 1"));
    // Shift turns in steps of 15 degrees.
    drag(at(grip), at({-3 + x * 0.8 - y * 0.6, x * 0.6 + y * 0.8, 0}), Qt::ShiftModifier);
    QCOMPARE(std::fmod(obstacle().turn, 15.0), 0.0);
    QVERIFY(obstacle().turn != 0);
  }

  void escTakesADragBack() {
    place({Shape::Box, {-3, 0, 0}});
    QVERIFY(waitUntilIdle(*window_));
    const double area = walkableArea();
    const int entries = partOf<Document>(*window_).undoStack()->count();
    const QPoint from = handle(Handle::MovePlan);
    send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton, {});
    for (int i = 1; i <= 20; ++i) {
      send(QEvent::MouseMove, from + QPoint(6 * i, 0), Qt::NoButton, Qt::LeftButton, {});
      QTest::qWait(10);
    }
    QVERIFY(obstacle().base.x > -3);
    QTest::keyClick(&view(), Qt::Key_Escape);
    send(QEvent::MouseButtonRelease, from + QPoint(120, 0), Qt::LeftButton, Qt::NoButton, {});
    QCOMPARE(obstacle().base, (Vec3{-3, 0, 0}));
    QCOMPARE(partOf<Document>(*window_).undoStack()->count(), entries);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(walkableArea(), area);
    QVERIFY(view().tool() == &features_->selectTool());
  }

  // Results come while the mouse moves: no run is cancelled by the next movement, and none is queued behind.
  void theResultFollowsTheDrag() {
    place({Shape::Box, {-4, 0, 0}});
    QVERIFY(waitUntilIdle(*window_));
    const QSignalSpy finished(&window_->controller(), &RunController::finished);
    const QSignalSpy started(&window_->controller(), &RunController::started);
    const QPoint from = handle(Handle::MovePlan);
    send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton, {});
    int whileMoving = 0;
    // Back and forth, until there are some or it is clear that there will be none.
    for (int i = 1; i <= 2000 && whileMoving < 5; ++i) {
      send(QEvent::MouseMove, from + QPoint(i % 180, 0), Qt::NoButton, Qt::LeftButton, {});
      QTest::qWait(8);
      whileMoving = static_cast<int>(finished.count());
    }
    QVERIFY2(whileMoving >= 5, qPrintable(QString::number(whileMoving)));
    QVERIFY2(started.count() - finished.count() <= 1, qPrintable(QString::number(started.count())));
    send(QEvent::MouseButtonRelease, from + QPoint(180, 0), Qt::LeftButton, Qt::NoButton, {});
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(window_->controller().finishedRun()->environment, partOf<LevelComposer>(*window_).level());
    QCOMPARE(partOf<Document>(*window_).undoStack()->count(), 2);
  }

  void theBodyMovesOverTheGround() {
    place({Shape::Box, {-4, 1, 0}, {3, 3, 0.5}});
    place({Shape::Box, {-4, -2, 0}});
    view().setTool(&features_->selectTool());
    features_->editor().select(std::nullopt);
    // Its middle comes to lie on the flat box, and it stands on that.
    drag(at({-4, -2, 1}), at({-4, 1, 1}));
    QCOMPARE(QString::fromStdString(features_->editor().selected()->name), QStringLiteral("Box 2"));
    QCOMPARE(features_->editor().selected()->base.z, 0.5);
    drag(at({-4, 1, 1.5}), at({-1, 1, 1.5}));
    QCOMPARE(features_->editor().selected()->base.z, 0.0);
    features_->panel().stickBox()->click();
    drag(at({-1, 1, 1}), at({-4, 1, 1}));
    QCOMPARE(features_->editor().selected()->base.z, 0.0);
    // A click beside all of them selects none.
    QTest::mouseClick(&view(), Qt::LeftButton, Qt::NoModifier, at({4, 0, 0}));
    QVERIFY(!features_->editor().selected());
  }

  void keysNudgeDuplicateAndDelete() {
    place({Shape::Box, {-3, 0, 0}});
    QTest::keyClick(&view(), Qt::Key_Right);
    QTest::keyClick(&view(), Qt::Key_Right);
    QTest::keyClick(&view(), Qt::Key_Up, Qt::ShiftModifier);
    QTest::keyClick(&view(), Qt::Key_PageUp);
    QCOMPARE(obstacle().base, (Vec3{-2.8, 0.25, 0.1}));
    QTest::qWait(800);
    QTest::keyClick(&view(), Qt::Key_Left);
    QTest::qWait(800);
    QCOMPARE(partOf<Document>(*window_).undoStack()->count(), 3);  // nudges in a row are one
    QTest::keyClick(&view(), Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(features_->editor().obstacles().size(), std::size_t{2});
    QCOMPARE(QString::fromStdString(features_->editor().selected()->name), QStringLiteral("Box 2"));
    QCOMPARE(features_->editor().selected()->base.x, obstacle().base.x + 1);
    QTest::keyClick(&view(), Qt::Key_Delete);
    QCOMPARE(features_->editor().obstacles().size(), std::size_t{1});
    QVERIFY(!features_->editor().selected());
    QTest::keyClick(&view(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(features_->editor().obstacles().size(), std::size_t{2});
    // Alt drags a copy, one edit.
    features_->editor().select(1);
    const int entries = partOf<Document>(*window_).undoStack()->count();
    drag(handle(Handle::MoveX), handle(Handle::MoveX) + QPoint(90, 0), Qt::AltModifier);
    QCOMPARE(features_->editor().obstacles().size(), std::size_t{3});
    QCOMPARE(partOf<Document>(*window_).undoStack()->undoText(), QStringLiteral("Duplicate Box 1"));
    QVERIFY(partOf<Document>(*window_).undoStack()->count() <= entries + 1);
  }

  void numbersInThePanel() {
    place({Shape::Box, {-3, 0, 0}});
    place({Shape::Cylinder, {3, 0, 0}});
    command("view.obstacles")->trigger();
    ObstaclePanel& panel = features_->panel();
    QVERIFY(QTest::qWaitFor([&] { return panel.isVisible(); }));
    QCOMPARE(panel.list()->count(), 2);
    QCOMPARE(panel.list()->currentRow(), 1);
    panel.list()->setCurrentRow(0);
    QCOMPARE(features_->editor().selected()->name, std::string("Box 1"));
    const auto type = [&](std::size_t field, const char* text) {
      panel.field(field)->setFocus();
      panel.field(field)->selectAll();
      QTest::keyClicks(panel.field(field), QLatin1String(text));
    };
    type(0, "1.5");
    type(5, "2.25");
    type(6, "30");
    QCOMPARE(obstacle().base.x, 1.5);
    QCOMPARE(obstacle().size.z, 2.25);
    QCOMPARE(obstacle().turn, 30.0);
    QTRY_COMPARE(partOf<Document>(*window_).undoStack()->count(), 5);  // one for each field
    // A size that is no extent is explained, and the last one stays.
    type(3, "-1");
    QVERIFY(!panel.field(3)->problem().isEmpty());
    QVERIFY(panel.findChild<QLabel*>(QStringLiteral("rowError"))->isVisible());
    QVERIFY(obstacle().size.x > 0);
    QTest::keyClick(panel.field(3), Qt::Key_Escape);
    panel.nameField()->setFocus();
    panel.nameField()->selectAll();
    QTest::keyClicks(panel.nameField(), QStringLiteral("crate"));
    QTest::keyClick(panel.nameField(), Qt::Key_Return);
    QCOMPARE(obstacle().name, std::string("crate"));
    QVERIFY(panel.list()->item(0)->text().startsWith(QStringLiteral("crate")));
    const CameraPose before = view().cameraController().pose();
    emit panel.list()->itemDoubleClicked(panel.list()->item(0));
    QVERIFY(!(view().cameraController().pose().position == before.position));
    QVERIFY(waitUntilIdle(*window_));
  }

  void sessionsKeepThem() {
    place({Shape::Ramp, {-3, 0, 0}, {2, 1, 1}, 90});
    place({Shape::Box, {0, 0, 0}});
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(rooms(), std::size_t{2});
    const QByteArray before = exported("kept.obj");
    const auto obstacles = features_->editor().obstacles();
    const QString path = folder_.filePath(QStringLiteral("rooms.footfall"));
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(path);
    QVERIFY(written.wait());
    cleanup();
    window_ = std::make_unique<EditorWindow>();
    window_->setRemembering(false);
    QVERIFY(showWindow(*window_));
    window_->open(path);
    QVERIFY(waitUntilIdle(*window_));
    features_ = window_->findChild<ObstacleFeatures*>();
    QCOMPARE(features_->editor().obstacles(), obstacles);
    QCOMPARE(rooms(), std::size_t{2});
    QCOMPARE(exported("again.obj"), before);
    // The view has them, with the numbers of the level.
    QCOMPARE(view().environmentGeometry()->surface.size(),
             3 * partOf<LevelComposer>(*window_).level()->triangles.size());
    view().cameraController().viewFromTop();
    const auto seen = view().pick(at({-3, 0.4, 0}));
    QVERIFY(seen);
    QCOMPARE(partOf<LevelComposer>(*window_).obstacleOf(seen->triangle), std::optional<std::uint32_t>(obstacles[0].id));
    // The obstacles stay when the file is read again.
    partOf<ImportPanel>(*window_).bothSidesBox()->click();
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(view().environmentGeometry()->surface.size(),
             3 * partOf<LevelComposer>(*window_).level()->triangles.size());
  }

 private:
  struct Wanted {
    Shape shape = Shape::Box;
    Vec3 base;
    Vec3 size{1, 1, 1};
    double turn = 0;
  };

  LevelView& view() { return window_->view(); }
  QAction* command(const char* id) { return window_->findChild<QAction*>(QLatin1String(id)); }
  const PlacedObstacle& obstacle() { return *features_->editor().find(features_->editor().obstacles().front().id); }
  /// Places by the editor; the tool for moving is on then.
  void place(const Wanted& wanted) {
    PlacedObstacle obstacle;
    obstacle.shape = wanted.shape;
    obstacle.base = wanted.base;
    obstacle.size = wanted.size;
    obstacle.turn = wanted.turn;
    features_->editor().add(obstacle);
    view().setTool(&features_->selectTool());
  }

  QPoint at(const Vec3& place) { return placeInView(*window_, place); }
  Vec3 placeOfHandle(Handle which) { return features_->selectTool().gizmo()->placeOf(which); }
  QPoint handle(Handle which) { return at(placeOfHandle(which)); }
  void send(QEvent::Type type, const QPoint& place, Qt::MouseButton button, Qt::MouseButtons buttons,
            Qt::KeyboardModifiers modifiers) {
    QMouseEvent event(type, place, view().mapToGlobal(place), button, buttons, modifiers);
    QCoreApplication::sendEvent(&view(), &event);
  }
  void press(const Vec3& place) { QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, at(place)); }
  void release(const Vec3& place) { QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, at(place)); }
  void move(const Vec3& place, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers = {}) {
    send(QEvent::MouseMove, at(place), Qt::NoButton, buttons, modifiers);
  }
  void click(const Vec3& place, Qt::KeyboardModifiers modifiers) { clickInView(*window_, place, modifiers); }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {}) {
    send(QEvent::MouseMove, from, Qt::NoButton, Qt::NoButton, modifiers);
    send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton, modifiers);
    for (int i = 1; i <= 8; ++i)
      send(QEvent::MouseMove, from + (to - from) * i / 8, Qt::NoButton, Qt::LeftButton, modifiers);
    send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton, modifiers);
  }
  void drag(const QPoint& from, const Vec3& to, Qt::KeyboardModifiers modifiers) { drag(from, at(to), modifiers); }

  std::size_t rooms() { return countParts(*window_->controller().finishedRun()->result.mesh); }
  double walkableArea() { return area(*window_->controller().finishedRun()->result.mesh); }
  QByteArray exported(const char* name) {
    const QString path = folder_.filePath(QLatin1String(name));
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->exportResult(path);
    if (!written.wait()) qWarning("not written");
    QByteArray text = readFile(path);
    return text.mid(text.indexOf("\nv "));  // The text without the comments.
  }

  QTemporaryDir folder_;
  std::unique_ptr<EditorWindow> window_;
  ObstacleFeatures* features_ = nullptr;
};

FOOTFALL_EDITOR_SUITE(TestObstacleTools)
#include "test_obstacle_tools.moc"
