// How a closed level is shown when it is opened: with its roofs faded.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSettings>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/house_obj.hpp"
#include "ui/view/widgets/view_hint.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\nLayerSubdivisionFilter\n";

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
    view().cameraController().endGlide();
    view().cameraController().fit();
    view().cameraController().endGlide();
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
