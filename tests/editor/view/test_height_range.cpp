// The slider with two heights, and what it leaves out of the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/view/widgets/height_slider.hpp"

using namespace footfall;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

/// Three floors over each other, at the heights 0, 3 and 6, all walkable.
QByteArray storeysObj() {
  QByteArray text;
  for (int floor = 0; floor < 3; ++floor) {
    const QByteArray z = QByteArray::number(3 * floor) + '\n';
    const QByteArray side = QByteArray::number(4 - floor);
    text += "v -" + side + " -4 " + z + "v " + side + " -4 " + z + "v " + side + " 4 " + z + "v -" + side + " 4 " + z;
    const int first = 4 * floor + 1;
    text += 'f';
    for (int corner = 0; corner < 4; ++corner) text += ' ' + QByteArray::number(first + corner);
    text += '\n';
  }
  return text;
}

constexpr HeightRange kAll;

}  // namespace

class TestHeightRange : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
    QVERIFY(openZUp(*window_, writeFile(folder_, "storeys.obj", storeysObj()), "SlopeFilter 45\n"));
    window_->view().cameraController().viewFromTop();
  }
  void cleanup() { window_.reset(); }

  void knowsTheFloors() {
    QCOMPARE(slider().floors(), (std::vector<double>{0, 3, 6}));
    QVERIFY(slider().range() == kAll);
  }

  void draggingCutsFromAboveAndSnaps() {
    QCOMPARE(topAt({1, 1, 6}), 6.0);
    // Nearly at the middle floor: the handle goes there, and the floor stays.
    drag(HeightSlider::Handle::Upper, yOf(3) + 3);
    QCOMPARE(slider().range().upper, 3.0);
    QCOMPARE(topAt({1, 1, 3}), 3.0);
    drag(HeightSlider::Handle::Upper, yOf(3) + 3, Qt::AltModifier);
    QVERIFY(slider().range().upper < 3);
    QCOMPARE(topAt({1, 1, 0}), 0.0);
    QTest::mouseDClick(&slider(), Qt::LeftButton, Qt::NoModifier, slider().handlePlace(HeightSlider::Handle::Lower));
    QVERIFY(slider().range() == kAll);
  }

  void draggingCutsFromBelow() {
    // Seen through where the floors above are narrower.
    QCOMPARE(topAt({3.5, 1, 0}), 0.0);
    drag(HeightSlider::Handle::Lower, yOf(3));
    QCOMPARE(slider().range().lower, 3.0);
    QVERIFY(!window_->view().pick(window_->view().project({3.5, 1, 0})->toPoint()));
    const QImage picture = window_->view().grabFramebuffer();
    const QPointF place = *window_->view().project({3.5, 1, 0}) * picture.devicePixelRatio();
    QVERIFY(picture.pixelColor(place.toPoint()).lightness() > 200);  // the background
    // One handle stops at the other.
    drag(HeightSlider::Handle::Upper, yOf(0));
    QCOMPARE(slider().range().upper, slider().range().lower);
  }

  void keysMoveTheHandles() {
    slider().setFocus(Qt::TabFocusReason);
    QCOMPARE(slider().activeHandle(), HeightSlider::Handle::Upper);
    QTest::keyClick(&slider(), Qt::Key_PageDown);
    QCOMPARE(slider().range().upper, 3.0);
    QTest::keyClick(&slider(), Qt::Key_Down);
    QCOMPARE(slider().range().upper, 3.0 - 0.06);
    QTest::keyClick(&slider(), Qt::Key_Tab);
    QCOMPARE(slider().activeHandle(), HeightSlider::Handle::Lower);
    QVERIFY(slider().hasFocus());
    QTest::keyClick(&slider(), Qt::Key_Up);
    QCOMPARE(slider().range().lower, 0.06);
    QTest::keyClick(&slider(), Qt::Key_End);
    QCOMPARE(slider().range().lower, kAll.lower);
    QTest::keyClick(&slider(), Qt::Key_Tab);
    QVERIFY(!slider().hasFocus());
  }

  void pageKeysGoFromStoreyToStorey() {
    window_->view().setFocus();
    QTest::keyClick(&window_->view(), Qt::Key_PageUp);
    QCOMPARE(slider().shownFloor(), std::optional(0));
    QCOMPARE(topAt({1, 1, 0}), 0.0);
    QTest::keyClick(&window_->view(), Qt::Key_PageUp);
    QCOMPARE(slider().shownFloor(), std::optional(1));
    QCOMPARE(topAt({1, 1, 3}), 3.0);
    QVERIFY(!window_->view().pick(window_->view().project({3.5, 1, 0})->toPoint()));
    QTest::keyClick(&window_->view(), Qt::Key_PageUp, Qt::ShiftModifier);
    QVERIFY(slider().range() == kAll);
  }

  void sessionsKeepThem() {
    slider().setRange({1, 4});
    const QString session = folder_.filePath("heights.footfall");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(session);
    QVERIFY(written.wait());
    slider().reset();
    window_->open(session);
    QVERIFY(QTest::qWaitFor([&] { return slider().range() == HeightRange{1, 4}; }));
    QVERIFY(waitUntilIdle(*window_));
    // Another level is shown whole.
    QVERIFY(openZUp(*window_, writeFile(folder_, "floor.obj", floorObj()), "SlopeFilter 45\n"));
    QVERIFY(slider().range() == kAll);
  }

 private:
  HeightSlider& slider() { return partOf<HeightSlider>(*window_); }
  double topAt(const Vec3& place) {
    const auto at = window_->view().project(place);
    const auto found = at ? window_->view().pick(at->toPoint()) : std::nullopt;
    return found ? found->point.z : -99;
  }
  int yOf(double height) {
    const HeightRange before = slider().range();
    slider().setRange({kAll.lower, height});
    const int y = slider().handlePlace(HeightSlider::Handle::Upper).y();
    const int bottom = slider().handlePlace(HeightSlider::Handle::Lower).y();
    slider().setRange(before);
    return height <= 0 ? bottom : y;
  }
  void drag(HeightSlider::Handle handle, int y, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    const QPoint from = slider().handlePlace(handle);
    const QPoint to(from.x(), y);
    QTest::mousePress(&slider(), Qt::LeftButton, modifiers, from);
    QMouseEvent move(QEvent::MouseMove, to, slider().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, modifiers);
    QCoreApplication::sendEvent(&slider(), &move);
    QTest::mouseRelease(&slider(), Qt::LeftButton, modifiers, to);
  }

  QTemporaryDir folder_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestHeightRange)
#include "test_height_range.moc"
