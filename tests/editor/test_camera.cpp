// Where one looks from, and how mouse, keys, trackpad and commands change it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "tests/editor/editor_driver.hpp"

using namespace footfall;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\n";

double distance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

}  // namespace

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
    const CameraPose before = view.cameraPose();
    const Vec3 lower{-1, -1, 0.5};
    const Vec3 upper{1, 1, 1};
    view.frame(lower, upper);
    QCOMPARE(view.cameraPose().orientation, before.orientation);
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
    view.frame({0, 0, 1}, {0, 0, 1});
    QVERIFY(distance(view.cameraPose().position, {0, 0, 1}) > 0.01);
  }

  void looksAtAPlace() {
    LevelView& view = window_->view();
    const CameraPose before = view.cameraPose();
    view.lookAt({3, 3, 0});
    const auto at = view.project({3, 3, 0});
    QVERIFY(at);
    QVERIFY((*at - QRectF(view.rect()).center()).manhattanLength() < 3);
    QCOMPARE(view.cameraPose().orientation, before.orientation);
    QVERIFY(std::abs(distance(view.cameraPose().position, {3, 3, 0}) - distance(before.position, before.pivot)) < 1e-6);
  }

  void framesTheSelectionOrWhatTheMousePointsAt() {
    LevelView& view = window_->view();
    view.setSelectionBounds(SceneBox{{5, -2, 0}, {6, 2, 1.7}});
    view.frameSelection();
    const auto middle = view.project({5.5, 0, 0.85});
    QVERIFY(middle);
    QVERIFY((*middle - QRectF(view.rect()).center()).manhattanLength() < 0.2 * view.width());
    view.setSelectionBounds(std::nullopt);
    view.fit();
    const auto table = view.project({0.5, 0.5, 1});
    QVERIFY(table);
    const double before = distance(view.cameraPose().position, {0.5, 0.5, 1});
    QCursor::setPos(view.mapToGlobal(table->toPoint()));
    QVERIFY(QTest::qWaitFor([&] { return view.mapFromGlobal(QCursor::pos()) == table->toPoint(); }));
    view.frameSelection();
    QVERIFY(distance(view.cameraPose().position, {0.5, 0.5, 1}) < 0.6 * before);
  }

 private:
  QTemporaryDir folder_;
  QString level_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestCamera)
#include "test_camera.moc"
