// The walker of "Try it", and walking in first person, in the real window.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/messages/status_line.hpp"
#include "ui/path/path_feature.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4\nDropFilter 3\n";

/// A floor, a step of 0.25 to the right of it, and a platform of 2 to the left, from which one drops.
QByteArray levelObj() {
  return floorObj() +
         "v 4 -4 0.25\nv 8 -4 0.25\nv 8 4 0.25\nv 4 4 0.25\nf 5 6 7 8\n"
         "v -8 -4 2\nv -4 -4 2\nv -4 4 2\nv -8 4 2\nf 9 10 11 12\n"
         "v -4 -4 0\nv -4 4 0\nf 13 10 11 14\nf 2 5 8 3\n";
}

double distance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

}  // namespace

class TestWalker : public EditorSuite {
  Q_OBJECT
 private slots:
  void init() {
    QVERIFY(openLevel(levelObj(), kPipeline));
    feature_ = window_->findChild<PathFeature*>();
    QVERIFY(feature_);
  }
  void cleanup() { closeWindow(); }

  void timesFollowSpeedAndGravity() {
    PathResult path;
    path.points = {{0, 0, 2}, {3, 0, 2}, {3, 0, 0}, {3, 4, 0}, {3, 4, 0.5}};
    path.drops = {1};
    const WalkTrack track(path, 0.5, 1);
    const double fall = std::sqrt(2 * 1 / 9.81);
    QVERIFY(std::fabs(track.seconds() - (1.5 + fall + 2 + 0.25)) < 1e-12);
    QVERIFY(distance(track.feetAt(0.75), {1.5, 0, 2}) < 1e-12);
    QVERIFY(distance(track.feetAt(1.5 + fall / 2), {3, 0, 1.5}) < 1e-12);  // a quarter of the depth
    QVERIFY(track.isFallingAt(1.5 + fall / 2) && !track.isFallingAt(1.4));
    QVERIFY(distance(track.feetAt(-1), path.points.front()) < 1e-12);
    QVERIFY(distance(track.feetAt(100), path.points.back()) < 1e-12);
    QVERIFY(std::fabs(track.turnAt(0.5)) < 1e-9);
    QVERIFY(std::fabs(track.turnAt(3) - 90) < 1e-9);
    QVERIFY(std::fabs(track.turnAt(track.seconds()) - 90) < 1e-9);
    // One place, and none.
    path.points = {{1, 2, 3}};
    path.drops.clear();
    QCOMPARE(WalkTrack(path, 1, 1).seconds(), 0.0);
    QVERIFY(WalkTrack(path, 1, 1).feetAt(5) == (Vec3{1, 2, 3}));
    QVERIFY(WalkTrack().isEmpty() && WalkTrack().seconds() == 0);
  }

  void theWalkerWalksThePathToItsEnd() {
    showPath({-2, 0, 0}, {6, 0, 0.25});
    const double all = walker().track().seconds();
    QVERIFY(std::fabs(all - 8.25 / 1.4) < 1e-6);
    QVERIFY(bar().isEnabled());
    QTest::keyClick(&window_->view(), Qt::Key_Space);
    QVERIFY(walker().isPlaying());
    QTRY_VERIFY(walker().time() > 0.1);
    QTest::keyClick(&window_->view(), Qt::Key_Space);
    QVERIFY(!walker().isPlaying());
    const double at = walker().time();
    QTest::qWait(60);
    QCOMPARE(walker().time(), at);
    // What the slider says, and the label.
    bar().slider()->setValue(500);
    QVERIFY(std::fabs(walker().time() - all / 2) < 1e-6);
    QCOMPARE(bar().timeText(), QString("2.9 of 5.9 s"));
    shoot(*window_, "walker");
    // It ends at the end, and begins anew from there.
    bar().paceBox()->setCurrentIndex(bar().paceBox()->count() - 1);
    QCOMPARE(walker().pace(), 8.0);
    QTest::mouseClick(bar().playButton(), Qt::LeftButton);
    QTRY_VERIFY(!walker().isPlaying());
    QCOMPARE(walker().time(), all);
    walker().setPlaying(true);
    QVERIFY(walker().time() < all);
    // Another path: it stays at the same share of the way. Half the speed takes twice as long.
    walker().setPlaying(false);
    bar().slider()->setValue(250);
    feature_->walk().setSpeed(0.7);
    QVERIFY(std::fabs(walker().time() - all / 2) < 1e-6);
    feature_->model().setPlaces(std::nullopt, std::nullopt);
    QVERIFY(!bar().isEnabled() && walker().track().isEmpty());
  }

  void sessionsKeepPaceAndCamera() {
    showPath({-2, 0, 0}, {6, 0, 0.25});
    bar().paceBox()->setCurrentIndex(0);
    bar().cameraBox()->setCurrentIndex(1);
    const QString session = folder_->filePath("walk.footfall");
    window_->saveSession(session);
    QVERIFY(waitUntilIdle(*window_));
    bar().paceBox()->setCurrentIndex(3);
    bar().cameraBox()->setCurrentIndex(0);
    window_->open(session);
    QTRY_COMPARE(bar().paceBox()->currentIndex(), 0);
    QCOMPARE(walker().pace(), 0.25);
    QCOMPARE(feature_->walk().walkerView().camera(), WalkCamera::Follows);
  }

  void itFallsDownDrops() {
    showPath({-6, 0, 2}, {-2, 0, 0});
    const auto& track = walker().track();
    double highest = 0;
    bool falls = false;
    for (double t = 0; t < track.seconds(); t += 0.01) {
      falls = falls || track.isFallingAt(t);
      highest = std::max(highest, track.feetAt(t).z);
    }
    QVERIFY(falls);
    QCOMPARE(highest, 2.0);
    QVERIFY(
        window_->findChild<QLabel*>("pathText")->text().contains(QString("%1 s at").arg(track.seconds(), 0, 'f', 1)));
  }

  void theCameraFollowsOrLooksThroughItsEyes() {
    showPath({-2, 0, 0}, {6, 0, 0.25});
    CameraController& camera = window_->view().cameraController();
    const CameraPose before = camera.pose();
    bar().cameraBox()->setCurrentIndex(2);
    QCOMPARE(camera.pose().position.x, -2.0);
    QVERIFY(std::fabs(camera.pose().position.z - 0.93 * 2) < 1e-9);
    QVERIFY(!camera.pose().orthographic);
    QVERIFY(std::fabs(sightOf(camera.pose()).turn) < 1e-6);
    bar().slider()->setValue(1000);
    QVERIFY(distance(camera.pose().position, {6, 0, 0.25 + 0.93 * 2}) < 1e-9);
    bar().slider()->setValue(400);
    shoot(*window_, "walker-eyes");
    bar().cameraBox()->setCurrentIndex(0);
    QVERIFY(distance(camera.pose().position, before.position) < 1e-9);
    QCOMPARE(camera.pose().orthographic, before.orthographic);
    // Following keeps the way from the walker to the camera.
    bar().slider()->setValue(0);
    camera.viewOblique();
    bar().cameraBox()->setCurrentIndex(1);
    const Vec3 first = camera.pose().position;
    bar().slider()->setValue(1000);
    QVERIFY(distance(camera.pose().position, {first.x + 8, first.y, first.z + 0.25}) < 1e-6);
    shoot(*window_, "walker-follows");
    // The tool's end ends it.
    window_->view().setTool(nullptr);
    QVERIFY(!walker().isPlaying());
  }

  void aWalkInFirstPerson() {
    LevelView& view = window_->view();
    CameraController& camera = view.cameraController();
    camera.viewFromTop();
    const CameraPose before = camera.pose();
    QTest::keyClick(window_.get(), Qt::Key_W, Qt::ShiftModifier);
    WalkTool& tool = feature_->walk().tool();
    QCOMPARE(view.tool(), static_cast<ViewTool*>(&tool));
    QTRY_VERIFY(tool.isReady());
    QVERIFY(partOf<StatusLine>(*window_).text().contains("click where to stand"));
    QTest::mouseMove(&view, placeInView(*window_, {2, 1, 0}));
    shoot(*window_, "walk-where");
    clickInView(*window_, {2, 1, 0});
    QVERIFY(tool.isWalking());
    QVERIFY(distance(tool.feet(), {2, 1, 0}) < 0.05);
    QVERIFY(std::fabs(camera.pose().position.z - 0.93 * 2) < 1e-9);
    QVERIFY(std::fabs(tool.sight().turn - 90) < 1e-6);  // up in the plan
    // W walks ahead; letters are no commands meanwhile.
    QTest::keyPress(&view, Qt::Key_W);
    QTRY_VERIFY(tool.feet().y > 1.2);
    QTest::keyRelease(&view, Qt::Key_W);
    QVERIFY(std::fabs(tool.feet().x - 2) < 0.05);
    // D walks to the right, up the step; the eyes follow.
    QTest::keyPress(&view, Qt::Key_Right);
    QTRY_VERIFY(tool.feet().x > 4.2);
    QTest::keyRelease(&view, Qt::Key_Right);
    QCOMPARE(tool.feet().z, 0.25);
    QTRY_VERIFY(std::fabs(camera.pose().position.z - 0.93 * 2 - 0.25) < 1e-9);
    shoot(*window_, "walk");
    // At the border it stays on the area.
    QTest::keyPress(&view, Qt::Key_W);
    QTRY_VERIFY(tool.feet().y > 3.7);
    QTest::qWait(200);
    QTest::keyRelease(&view, Qt::Key_W);
    QVERIFY(tool.feet().y < 4);
    // A new result is walked on.
    DocumentState next = partOf<Document>(*window_).state();
    for (FilterEntry& entry : next.filters)
      if (entry.step.filter->type == FilterType::VerticalClearance) entry.step.values[0] = 1.5;
    partOf<Document>(*window_).edit(next, "lower the clearance");
    QVERIFY(waitUntilIdle(*window_));
    QTRY_VERIFY(tool.isReady());
    QVERIFY(tool.isWalking());
    QTRY_VERIFY(std::fabs(camera.pose().position.z - 0.93 * 1.5 - 0.25) < 1e-9);
    QTest::keyClick(&view, Qt::Key_Escape);
    QVERIFY(!view.tool() && !tool.isWalking());
    QVERIFY(distance(camera.pose().position, before.position) < 1e-9);
    QCOMPARE(camera.pose().orthographic, before.orthographic);
  }

  void walkingFromThePlatformFalls() {
    LevelView& view = window_->view();
    window_->findChild<QAction*>("tools.walk")->trigger();
    WalkTool& tool = feature_->walk().tool();
    tool.standAt({-6, 0, 2});  // before it is prepared
    QTRY_VERIFY(tool.isWalking());
    QCOMPARE(tool.feet().z, 2.0);
    const auto moveMouse = [&view](const QPointF& to) {
      QMouseEvent move(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, Qt::NoButton, {});
      QApplication::sendEvent(&view, &move);
    };
    const QPointF middle(view.rect().center());
    for (int i = 0; i < 400 && std::fabs(std::remainder(tool.sight().turn, 360)) > 1; ++i) {
      moveMouse(middle);
      moveMouse(middle + QPointF(std::remainder(tool.sight().turn, 360) > 0 ? 5 : -5, 0));
      QEvent leave(QEvent::Leave);  // the next place of the mouse is a beginning
      QApplication::sendEvent(&view, &leave);
    }
    QVERIFY(std::fabs(std::remainder(tool.sight().turn, 360)) <= 1);
    QTest::keyPress(&view, Qt::Key_W);
    QTRY_COMPARE(tool.feet().z, 0.0);
    QTest::keyRelease(&view, Qt::Key_W);
    QTRY_VERIFY(std::fabs(view.cameraController().pose().position.z - 0.93 * 2) < 1e-9);
    // Another level ends it.
    QVERIFY(openZUp(*window_, writeFile(*folder_, "floor.obj", floorObj()), kPipeline));
    QVERIFY(!tool.isWalking());
  }

  void thereMayBeNothingToWalkOn() {
    EditorWindow empty;
    empty.setRemembering(false);
    empty.findChild<QAction*>("tools.walk")->trigger();
    QVERIFY(partOf<StatusLine>(empty).text().contains("nothing is walkable"));
    QVERIFY(!empty.findChild<QAction*>("tools.walkPath")->isEnabled());
  }

 private:
  Walker& walker() { return feature_->walk().walker(); }
  WalkBar& bar() { return *feature_->walk().bar(); }
  void showPath(const Vec3& from, const Vec3& to) {
    window_->view().cameraController().viewOblique();
    QTest::keyClick(window_.get(), Qt::Key_P);
    QTest::qWait(50);
    feature_->model().setPlaces(from, to);
    QVERIFY(QTest::qWaitFor(
        [&] {
          return !feature_->model().busy() && feature_->model().result() && feature_->model().result()->reached();
        },
        kWaitMs));
  }

  PathFeature* feature_ = nullptr;
};

FOOTFALL_EDITOR_SUITE(TestWalker)
#include "test_walker.moc"
