// How a closed level is shown when it is opened: framed alike each time, with its roofs faded.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSettings>
#include <cmath>

#include "core/pipeline/pipeline_fragment.hpp"
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

bool isAlike(const CameraPose& a, const CameraPose& b) {
  const double least = 1e-6 * distance(a.position, a.pivot);
  return least > 0 && distance(a.position, b.position) < least && distance(a.pivot, b.pivot) < least;
}

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

  // Another level before, the hint that is shown once, a turned camera and glides change nothing.
  void levelsAreFramedAlikeEachTime() {
    const QString other = writeFile(folder_, "floor.obj", floorObj());
    const auto frame = [this](const QString& path) {
      return openZUp(*window_, path, kPipeline) ? view().cameraController().pose() : CameraPose();
    };
    const CameraPose first = frame(house_);
    QVERIFY(view().findChild<ViewHint*>()->isVisible());
    QVERIFY(isAlike(first, frame(house_)));
    QVERIFY(view().findChild<ViewHint*>()->isHidden());
    frame(other);
    QVERIFY(isAlike(first, frame(house_)));
    view().cameraController().viewFromTop();
    window_->setInteractive(true);
    QVERIFY(isAlike(first, frame(house_)));
    makeWindow();
    QVERIFY(isAlike(first, frame(house_)));
  }

  // A message of the time before makes the view lower until the level arrives.
  void aMessageBeforeALevelOpensChangesNothing() {
    QVERIFY(openZUp(*window_, house_, kPipeline));
    const CameraPose first = view().cameraController().pose();
    partOf<MessageBar>(*window_).showHint(QStringLiteral("A word"));
    QTest::qWait(50);
    QVERIFY(openZUp(*window_, house_, kPipeline));
    QVERIFY(partOf<MessageBar>(*window_).text().isEmpty());
    QVERIFY(isAlike(first, view().cameraController().pose()));
  }

  // A hint about the filters makes the view lower: it comes before the first result or after it.
  void aLevelWithAHintIsFramedAlikeEachTime() {
    constexpr const char* kTooDeep = "SlopeFilter 45\nVerticalClearanceFilter 2\nDropFilter 100\n";
    QVERIFY(openZUp(*window_, house_, kTooDeep));
    QVERIFY(!partOf<MessageBar>(*window_).text().isEmpty());
    const CameraPose first = view().cameraController().pose();
    for (int i = 0; i < 3; ++i) {
      QVERIFY(openZUp(*window_, house_, kTooDeep));
      QVERIFY(isAlike(first, view().cameraController().pose()));
    }
  }

  // A list that cannot run has no result to wait for.
  void aListThatCannotRunIsFramedToo() {
    ImportOptions import;
    import.up = UpAxis::Z;
    window_->openWith(house_, parsePipelineFragment("GridStrategy 2 2\nSlopeFilter 45\n", "test"), import);
    QVERIFY(QTest::qWaitFor([&] { return window_->file().environment() != nullptr; }, kWaitMs));
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(!window_->controller().finishedRun());
    QVERIFY(QRectF(view().rect()).contains(view().project({0, 0, 1.5}).value()));
  }

  // Once the level is there, a panel moves nothing on the screen, and the camera is not sent back.
  void aPanelDoesNotFrameTheLevelAgain() {
    QVERIFY(openZUp(*window_, house_, kPipeline));
    const Vec3 pivot = view().cameraController().pose().pivot;
    const auto onScreen = [&] { return view().project(pivot).value() + view().mapTo(window_.get(), QPointF(0, 0)); };
    QCursor::setPos(window_->mapToGlobal(QPoint(1, 1)));  // what lies under the mouse in the view would stay
    const QPointF before = onScreen();
    const int width = view().width();
    window_->findChild<QAction*>("panel.layers")->trigger();
    QVERIFY(QTest::qWaitFor([&] { return view().width() < width; }, kWaitMs));
    QTest::qWait(50);
    QVERIFY2((onScreen() - before).manhattanLength() < 1.5, qPrintable(QString::number((onScreen() - before).x())));
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
