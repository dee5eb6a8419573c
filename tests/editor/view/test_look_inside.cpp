// How a closed level is shown when it is opened: framed alike each time, with its roofs faded.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSettings>
#include <cmath>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/house_obj.hpp"
#include "ui/view/widgets/view_hint.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\nLayerSubdivisionFilter\n";

double distance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

}  // namespace

class TestLookInside : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { house_ = writeFile(folder_, "house.obj", houseObj()); }
  void init() {
    QSettings().clear();
    makeWindow();
  }
  void cleanup() { window_.reset(); }

  // A flat roof may be walked on: it lets what lies behind it through, and is never gone.
  void aRoofThatMayBeWalkedOnFades() {
    QVERIFY(openZUp(*window_, house_, kPipeline));
    QVERIFY(view().environmentGeometry()->covered);
    view().cameraController().viewOblique();
    const Vec3 roof{0, 0, 3.2}, wall{0, -2, 1.5};
    QVERIFY(view().inside());
    const QImage open = picture();
    view().setInside(false);
    const QImage closed = picture();
    const double roofShown = sameShare(open, closed, view().project(roof).value().toPoint());
    QVERIFY2(roofShown > 0.15 && roofShown < 0.45, qPrintable(QString::number(roofShown)));
    // An upright wall in the way goes altogether.
    const double wallShown = sameShare(open, closed, view().project(wall).value().toPoint());
    QVERIFY2(wallShown < 0.15, qPrintable(QString::number(wallShown)));
  }

  // Whatever was opened before, whether a hint is shown, and whether the camera still glides.
  void levelsAreFramedAlikeEachTime() {
    const QString other = writeFile(folder_, "floor.obj", floorObj());
    const auto frame = [this](const QString& path) {
      if (!openZUp(*window_, path, kPipeline)) return CameraPose();
      QTest::qWait(400);  // for glides, and for listeners behind the run's
      return window_->view().cameraController().pose();
    };
    const CameraPose first = frame(house_);
    QVERIFY(view().findChild<ViewHint*>()->isVisible());  // once, and not again
    const double reach = distance(first.position, first.pivot);
    QVERIFY(reach > 0);
    const auto isSame = [&](const CameraPose& pose) {
      return distance(pose.position, first.position) < 1e-3 * reach && distance(pose.pivot, first.pivot) < 1e-3 * reach;
    };
    QVERIFY(isSame(frame(house_)));
    QVERIFY(view().findChild<ViewHint*>()->isHidden());
    frame(other);
    QVERIFY(isSame(frame(house_)));
    view().cameraController().viewFromTop();
    window_->setInteractive(true);
    QVERIFY(isSame(frame(house_)));
    makeWindow();
    QVERIFY(isSame(frame(house_)));
  }

  // A message about what was there before makes the view lower until the level arrives.
  void aMessageBeforeALevelOpensChangesNothing() {
    QVERIFY(openZUp(*window_, house_, kPipeline));
    QTest::qWait(100);
    const CameraPose first = view().cameraController().pose();
    window_->messageBar().showHint(QStringLiteral("A word"));
    QTest::qWait(50);
    QVERIFY(openZUp(*window_, house_, kPipeline));
    QTest::qWait(100);
    QVERIFY(window_->messageBar().text().isEmpty());
    const CameraPose second = view().cameraController().pose();
    QVERIFY(distance(second.position, first.position) < 1e-3 * distance(first.position, first.pivot));
  }

 private:
  LevelView& view() { return window_->view(); }
  void makeWindow() {
    window_.reset();
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1100, 760);
    QVERIFY(showWindow(*window_));
  }
  QImage picture() { return view().grabFramebuffer(); }
  // The share of the pixels around a place that are the same in both pictures.
  double sameShare(const QImage& a, const QImage& b, const QPoint& place) {
    constexpr int kReach = 8;
    int same = 0, all = 0;
    for (int y = -kReach; y < kReach; ++y) {
      for (int x = -kReach; x < kReach; ++x, ++all)
        same += a.pixel(place + QPoint(x, y)) == b.pixel(place + QPoint(x, y)) ? 1 : 0;
    }
    return static_cast<double>(same) / all;
  }

  QTemporaryDir folder_;
  QString house_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestLookInside)
#include "test_look_inside.moc"
