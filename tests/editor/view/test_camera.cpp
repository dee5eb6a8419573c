// The camera, and its changes by mouse, keys, trackpad and commands.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QNativeGestureEvent>
#include <QTabletEvent>
#include <QWheelEvent>
#include <cmath>
#include <limits>

#include "tests/editor/editor_driver.hpp"
#include "ui/view/camera/camera_tools.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\n";

double distance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

}  // namespace

Q_DECLARE_METATYPE(footfall::Vec3)

class TestCamera : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { level_ = writeFile(folder_, "table.obj", tableObj()); }
  void init() {
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1100, 800);
    QVERIFY(showWindow(*window_));
    QVERIFY(openZUp(*window_, level_, kPipeline));
  }
  void cleanup() { window_.reset(); }

  void framesABoxFromWhereOneLooks() {
    LevelView& view = window_->view();
    const CameraPose before = camera().pose();
    const Vec3 lower{-1, -1, 0.5};
    const Vec3 upper{1, 1, 1};
    camera().frame(lower, upper);
    QCOMPARE(camera().pose().orientation, before.orientation);
    double widest = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const auto at = view.project(
          {corner & 1 ? lower.x : upper.x, corner & 2 ? lower.y : upper.y, corner & 4 ? lower.z : upper.z});
      QVERIFY(at);
      QVERIFY(QRectF(view.rect()).contains(*at));
      widest = std::max({widest, std::abs(at->x() - view.width() / 2.0) / view.width(),
                         std::abs(at->y() - view.height() / 2.0) / view.height()});
    }
    QVERIFY2(widest > 0.4, qPrintable(QString::number(widest)));  // it fills the view
    // A point is shown with what is around it.
    camera().frame({0, 0, 1}, {0, 0, 1});
    QVERIFY(distance(camera().pose().position, {0, 0, 1}) > 0.01);
  }

  // The bounds of nothing are no place to go to.
  void placesThatAreNoNumbersAreLeftOut() {
    const CameraPose before = camera().pose();
    const double none = std::numeric_limits<double>::infinity();
    camera().frame({none, none, none}, {-none, -none, -none});
    camera().lookAt({std::nan(""), 0, 0});
    CameraPose pose = before;
    pose.position.x = std::nan("");
    camera().setPose(pose);
    QVERIFY(distance(camera().pose().position, before.position) < 1e-9);
    QVERIFY(distance(camera().pose().pivot, before.pivot) < 1e-9);
  }

  // The picture stays, in parallel projection as well, whose scale is the distance from the pivot.
  void aDoubleClickMakesThePlaceThePivot() {
    LevelView& view = window_->view();
    for (const bool parallel : {false, true}) {
      camera().setOrthographic(parallel);
      const Vec3 place{3, 3, 0}, other{-3, 2, 0};
      const QPointF at = view.project(place).value(), beside = view.project(other).value();
      QTest::mouseDClick(&view, Qt::LeftButton, {}, at.toPoint());
      const CameraPose pose = camera().pose();
      QVERIFY2(distance(pose.pivot, place) < 0.1, parallel ? "parallel" : "perspective");
      QVERIFY(distance(pose.pivot, pose.position) > 1);
      QVERIFY((view.project(place).value() - at).manhattanLength() < 0.1);
      QVERIFY((view.project(other).value() - beside).manhattanLength() < 0.1);
      // Where nothing is, the pivot stays.
      QTest::mouseDClick(&view, Qt::LeftButton, {}, QPoint(2, view.height() - 2));
      QVERIFY(distance(camera().pose().pivot, pose.pivot) < 1e-9);
    }
  }

  void looksAtAPlace() {
    LevelView& view = window_->view();
    const CameraPose before = camera().pose();
    camera().lookAt({3, 3, 0});
    const auto at = view.project({3, 3, 0});
    QVERIFY(at);
    QVERIFY((*at - QRectF(view.rect()).center()).manhattanLength() < 3);
    QCOMPARE(camera().pose().orientation, before.orientation);
    QVERIFY(std::abs(distance(camera().pose().position, {3, 3, 0}) - distance(before.position, before.pivot)) < 1e-6);
  }

  void framesTheSelectionOrWhatTheMousePointsAt() {
    LevelView& view = window_->view();
    camera().setSelectionBounds("tool", SceneBox{{5, -2, 0}, {6, 2, 1.7}});
    camera().setCovered({});  // A place beside overlays is not in the middle: test_view_overlays.
    camera().frameSelection();
    const auto middle = view.project({5.5, 0, 0.85});
    QVERIFY(middle);
    QVERIFY((*middle - QRectF(view.rect()).center()).manhattanLength() < 0.2 * view.width());
    camera().setSelectionBounds("tool", std::nullopt);
    camera().fit();
    const auto table = view.project({0.5, 0.5, 1});
    QVERIFY(table);
    const double before = distance(camera().pose().position, {0.5, 0.5, 1});
    QCursor::setPos(view.mapToGlobal(table->toPoint()));
    QVERIFY(QTest::qWaitFor([&] { return view.mapFromGlobal(QCursor::pos()) == table->toPoint(); }));
    camera().frameSelection();
    QVERIFY(distance(camera().pose().position, {0.5, 0.5, 1}) < 0.6 * before);
  }

  void aPanelLeavesWhatTheMousePointsAt() {
    LevelView& view = window_->view();
    camera().lookAt({-3, -3, 0});  // the pivot is elsewhere, and deeper or higher
    const Vec3 table{0.5, 0.5, 1};
    const auto onScreen = [&] {
      return view.project(table).value() + QPointF(view.mapTo(window_.get(), QPoint(0, 0)));
    };
    QVERIFY(view.project(table));
    const QPoint mouse = view.project(table)->toPoint();
    QCursor::setPos(view.mapToGlobal(mouse));
    QVERIFY(QTest::qWaitFor([&] { return view.mapFromGlobal(QCursor::pos()) == mouse; }));
    const QPointF before = onScreen();
    const QSize size = view.size();
    QTest::keyClick(&view, Qt::Key_P);
    QVERIFY(QTest::qWaitFor([&] { return view.width() < size.width(); }));
    QVERIFY2((onScreen() - before).manhattanLength() < 1.5, qPrintable(QString::number((onScreen() - before).x())));
    QTest::keyClick(&view, Qt::Key_P);
  }

  void looksAlongTheAxes_data() {
    QTest::addColumn<int>("key");
    QTest::addColumn<int>("modifiers");
    QTest::addColumn<Vec3>("direction");
    QTest::newRow("top") << int(Qt::Key_7) << int(Qt::NoModifier) << Vec3{0, 0, -1};
    QTest::newRow("below") << int(Qt::Key_7) << int(Qt::ControlModifier) << Vec3{0, 0, 1};
    QTest::newRow("front") << int(Qt::Key_1) << int(Qt::NoModifier) << Vec3{0, 1, 0};
    QTest::newRow("back") << int(Qt::Key_1) << int(Qt::ControlModifier) << Vec3{0, -1, 0};
    QTest::newRow("right") << int(Qt::Key_3) << int(Qt::NoModifier) << Vec3{-1, 0, 0};
    QTest::newRow("left") << int(Qt::Key_3) << int(Qt::ControlModifier) << Vec3{1, 0, 0};
  }
  void looksAlongTheAxes() {
    QFETCH(int, key);
    QFETCH(int, modifiers);
    QFETCH(Vec3, direction);
    LevelView& view = window_->view();
    view.setFocus();
    QTest::keyClick(&view, static_cast<Qt::Key>(key), Qt::KeyboardModifiers(modifiers));
    QVERIFY(distance(directionOf(camera()), direction) < 1e-6);
    QVERIFY(camera().pose().orthographic);
  }

  void switchesTheProjection() {
    LevelView& view = window_->view();
    camera().viewOblique();
    const auto before = view.project(camera().pose().pivot);
    const CameraPose pose = camera().pose();
    QTest::keyClick(&view, Qt::Key_5);
    QVERIFY(camera().orthographic());
    QCOMPARE(camera().pose().orientation, pose.orientation);
    QVERIFY((*view.project(pose.pivot) - *before).manhattanLength() < 1);
    QTest::keyClick(&view, Qt::Key_5);
    QVERIFY(!camera().orthographic());
  }

  void theWheelZoomsTowardsTheMouse() {
    LevelView& view = window_->view();
    camera().viewOblique();
    const Vec3 corner{3, 3, 0};
    const QPointF place = *view.project(corner);
    const double before = distance(camera().pose().position, corner);
    wheel(place, {0, 240});
    QVERIFY(distance(camera().pose().position, corner) < 0.8 * before);
    QVERIFY((*view.project(corner) - place).manhattanLength() < 3);
    // The same in a parallel projection.
    camera().viewFromTop();
    const QPointF there = *view.project(corner);
    wheel(there, {0, -120});
    QVERIFY((*view.project(corner) - there).manhattanLength() < 3);
  }

  void twoFingersTurnMoveAndPinch() {
    LevelView& view = window_->view();
    camera().viewOblique();
    const CameraPose start = camera().pose();
    const QPointF middle = QRectF(view.rect()).center();
    fingers(middle, {30, 0}, Qt::NoModifier);
    QVERIFY(camera().pose().orientation != start.orientation);
    QVERIFY(distance(camera().pose().pivot, start.pivot) < 1e-9);
    const CameraPose turned = camera().pose();
    fingers(middle, {30, 0}, Qt::ShiftModifier);
    QCOMPARE(camera().pose().orientation, turned.orientation);
    QVERIFY(distance(camera().pose().pivot, turned.pivot) > 0.01);
    const double reach = distance(camera().pose().position, camera().pose().pivot);
    QNativeGestureEvent pinch(Qt::ZoomNativeGesture, &touchpad(), 2, middle, middle, view.mapToGlobal(middle), 0.5, {});
    QCoreApplication::sendEvent(&view, &pinch);
    QVERIFY(distance(camera().pose().position, camera().pose().pivot) < 0.8 * reach);
  }

  void aPenDoesWhatTheMouseDoes() {
    LevelView& view = window_->view();
    camera().viewOblique();
    const CameraPose start = camera().pose();
    // Qt makes mouse events from tablet events that nothing accepts.
    const QPointingDevice pen("pen", 77, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
                              QInputDevice::Capability::Position, 1, 1);
    const QPointF place = QRectF(view.rect()).center();
    QTabletEvent press(QEvent::TabletPress, &pen, place, view.mapToGlobal(place), 1, 0, 0, 0, 0, 0, Qt::NoModifier,
                       Qt::LeftButton, Qt::LeftButton);
    press.setAccepted(false);
    QCoreApplication::sendEvent(&view, &press);
    QVERIFY(!press.isAccepted());  // so that they follow
    QCOMPARE(camera().pose().orientation, start.orientation);
  }

  void keysTurnAndNeverFlip() {
    LevelView& view = window_->view();
    camera().viewOblique();
    const CameraPose start = camera().pose();
    QTest::keyClick(&view, Qt::Key_Left, Qt::ControlModifier);
    QVERIFY(camera().pose().orientation != start.orientation);
    QVERIFY(distance(camera().pose().pivot, start.pivot) < 1e-9);
    for (int i = 0; i < 40; ++i) QTest::keyClick(&view, Qt::Key_Up, Qt::ShiftModifier);
    const Vec3 down = directionOf(camera());
    QVERIFY2(down.z < -0.99 && down.z > -1, qPrintable(QString::number(down.z)));
    for (int i = 0; i < 40; ++i) QTest::keyClick(&view, Qt::Key_Down, Qt::ShiftModifier);
    QVERIFY(directionOf(camera()).z > 0.99);
  }

  void flies() {
    LevelView& view = window_->view();
    camera().viewOblique();
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_F, Qt::ShiftModifier);
    auto* tools = window_->findChild<CameraTools*>();
    QCOMPARE(view.tool(), static_cast<ViewTool*>(&tools->fly()));
    QVERIFY(window_->findChild<QAction*>("view.fly")->isChecked());
    const CameraPose start = camera().pose();
    const Vec3 ahead = directionOf(camera());
    QTest::keyPress(&view, Qt::Key_W);
    QVERIFY(QTest::qWaitFor([&] { return distance(camera().pose().position, start.position) > 0.3; }));
    QTest::keyRelease(&view, Qt::Key_W);
    const CameraPose there = camera().pose();
    const double way = distance(there.position, start.position);
    QVERIFY(way > 0.2);
    const Vec3 along{(there.position.x - start.position.x) / way, (there.position.y - start.position.y) / way,
                     (there.position.z - start.position.z) / way};
    QVERIFY(distance(along, ahead) < 1e-6);
    QTest::qWait(60);
    QVERIFY(distance(camera().pose().position, there.position) < 1e-9);  // it stands still again
    // E rises, in the direction of Z.
    QTest::keyPress(&view, Qt::Key_E);
    QVERIFY(QTest::qWaitFor([&] { return camera().pose().position.z > there.position.z; }));
    QTest::keyRelease(&view, Qt::Key_E);
    QVERIFY(std::abs(camera().pose().position.x - there.position.x) < 1e-9);
    // The mouse looks; the letter T does not look from the top.
    const CameraPose before = camera().pose();
    move(view.rect().center());
    move(view.rect().center() + QPoint(40, 0));
    QVERIFY(camera().pose().orientation != before.orientation);
    QVERIFY(distance(camera().pose().position, before.position) < 1e-9);
    const double speed = tools->fly().speed();
    wheel(QRectF(view.rect()).center(), {0, 120});
    QVERIFY(tools->fly().speed() > speed);
    // However far the wheel is turned, the speed stays a number, and so does the camera's place.
    wheel(QRectF(view.rect()).center(), {0, 1'200'000'000});
    const double fastest = tools->fly().speed();
    QVERIFY(std::isfinite(fastest) && fastest > speed);
    wheel(QRectF(view.rect()).center(), {0, -1'200'000'000});
    QVERIFY(tools->fly().speed() > 0);
    QTest::keyClick(&view, Qt::Key_Escape);
    QVERIFY(!view.tool());
    camera().zoomBy(1e-300);
    camera().zoomBy(1e-300);
    const Vec3 far = camera().pose().position;
    QVERIFY(std::isfinite(far.x) && std::isfinite(far.y) && std::isfinite(far.z));
    camera().fit();
  }

  void bookmarksComeBack() {
    LevelView& view = window_->view();
    camera().viewOblique();
    const CameraPose kept = camera().pose();
    QTest::keyClick(&view, Qt::Key_3, Qt::ControlModifier | Qt::AltModifier);
    auto* tools = window_->findChild<CameraTools*>();
    QCOMPARE(tools->bookmarks().size(), std::size_t{1});
    camera().viewFromTop();
    QTest::keyClick(&view, Qt::Key_3, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(distance(camera().pose().position, kept.position) < 1e-9);
    QVERIFY(!camera().pose().orthographic);
    // The view has a name, and is kept in a session.
    tools->keepBookmark(1, "The door");
    const QString session = folder_.filePath("bookmarks.footfall");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(session);
    QVERIFY(written.wait());
    tools->keepBookmark(2);
    window_->open(session);
    QVERIFY(QTest::qWaitFor([&] { return tools->bookmarks().size() == 2; }));
    QCOMPARE(tools->bookmarks().at(1).name, QString("The door"));
  }

  void theGizmoLooksAlongItsAxes() {
    camera().viewOblique();
    AxisGizmo& gizmo = window_->findChild<CameraTools*>()->gizmo();
    QVERIFY(gizmo.isVisible());
    for (const AxisGizmo::End& end : gizmo.ends()) {
      if (end.letter != "X") continue;
      QTest::mouseClick(&gizmo, Qt::LeftButton, Qt::NoModifier, end.place.toPoint());
    }
    QVERIFY(distance(directionOf(camera()), {-1, 0, 0}) < 1e-6);
    // Dragging turns.
    const QPoint from = gizmo.rect().center();
    QTest::mousePress(&gizmo, Qt::LeftButton, Qt::NoModifier, from);
    for (const int x : {15, 30}) {
      QMouseEvent move(QEvent::MouseMove, from + QPoint(x, 0), gizmo.mapToGlobal(from + QPoint(x, 0)), Qt::NoButton,
                       Qt::LeftButton, Qt::NoModifier);
      QCoreApplication::sendEvent(&gizmo, &move);
    }
    QTest::mouseRelease(&gizmo, Qt::LeftButton, Qt::NoModifier, from + QPoint(30, 0));
    QVERIFY(distance(directionOf(camera()), {-1, 0, 0}) > 0.05);
  }

  void glidesWhereSomebodySits() {
    LevelView& view = window_->view();
    camera().viewOblique();
    window_->setInteractive(true);
    const auto lookedAlong = [&] { return view.rayAt(view.rect().center()).direction; };
    camera().viewFrom(ViewSide::Front);
    QVERIFY(distance(directionOf(camera()), {0, 1, 0}) < 1e-6);  // the direction it turns to
    QVERIFY(std::abs(lookedAlong().z) > 0.1);                    // the direction it still has
    QVERIFY(QTest::qWaitFor([&] { return camera().orthographic(); }));
    QVERIFY(std::abs(lookedAlong().z) < 1e-6);
    // The camera jumps when motion is reduced.
    window_->findChild<QAction*>("view.animate")->setChecked(false);
    camera().viewOblique();
    QVERIFY(!camera().orthographic());
    window_->findChild<QAction*>("view.animate")->setChecked(true);
  }

 private:
  CameraController& camera() { return window_->view().cameraController(); }
  static Vec3 directionOf(CameraController& camera) {
    const auto& q = camera.pose().orientation;
    return {-2 * (q[0] * q[2] + q[3] * q[1]), -2 * (q[1] * q[2] - q[3] * q[0]), -(1 - 2 * (q[0] * q[0] + q[1] * q[1]))};
  }
  static QPointingDevice& touchpad() {
    static QPointingDevice device("touchpad", 78, QInputDevice::DeviceType::TouchPad,
                                  QPointingDevice::PointerType::Finger, QInputDevice::Capability::Position, 5, 0);
    return device;
  }
  void wheel(const QPointF& place, const QPoint& angle) {
    LevelView& view = window_->view();
    QWheelEvent event(place, view.mapToGlobal(place), {}, angle, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(&view, &event);
  }
  void fingers(const QPointF& place, const QPoint& pixels, Qt::KeyboardModifiers modifiers) {
    LevelView& view = window_->view();
    QWheelEvent event(place, view.mapToGlobal(place), pixels, pixels * 8, Qt::NoButton, modifiers, Qt::ScrollUpdate,
                      false, Qt::MouseEventNotSynthesized, &touchpad());
    QCoreApplication::sendEvent(&view, &event);
  }
  void move(const QPoint& place) {
    LevelView& view = window_->view();
    QMouseEvent event(QEvent::MouseMove, place, view.mapToGlobal(place), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&view, &event);
  }

  QTemporaryDir folder_;
  QString level_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestCamera)
#include "test_camera.moc"
