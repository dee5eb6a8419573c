// Large pictures are drawn and uploaded in slices: they look as if drawn in one go, the one before stays until then,
// and the window answers in between.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QRandomGenerator>
#include <vector>

#include "tests/editor/editor_driver.hpp"
#include "ui/base/work/frame_watchdog.hpp"
#include "ui/level/level_look.hpp"
#include "ui/run/provisional_content.hpp"
#include "ui/view/scene/appearance.hpp"
#include "ui/view/scene/drawing_slice.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

struct Primitive {
  std::size_t batch = 0;
  int number = 0;
  bool operator==(const Primitive&) const = default;
};

void draw(DrawingSlice& slice, const std::vector<int>& batches, std::vector<Primitive>& drawn) {
  for (std::size_t batch = 0; batch < batches.size(); ++batch) {
    const auto [first, count] = slice.take(batches[batch]);
    for (int i = first; i < first + count; ++i) drawn.push_back({batch, i});
  }
}

double shareOfWalkable(const QImage& image) {
  const QColor paint = walkablePaint().colour;
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor pixel = image.pixelColor(x, y);
      const int hue = std::abs(pixel.hsvHue() - paint.hsvHue());
      if (std::min(hue, 360 - hue) < 12 && pixel.hsvSaturationF() > paint.hsvSaturationF() / 2) ++count;
    }
  }
  return static_cast<double>(count) / (static_cast<double>(image.width()) * image.height());
}

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\nLayerSubdivisionFilter\n";

}  // namespace

class TestDrawingSlices : public QObject {
  Q_OBJECT

 private slots:
  void goesDrawEveryPrimitiveOnceInOrder() {
    QRandomGenerator random(1);
    for (int round = 0; round < 300; ++round) {
      std::vector<int> batches(random.bounded(1, 9));
      for (int& count : batches) count = random.bounded(4) == 0 ? 0 : random.bounded(1, 60);
      std::vector<Primitive> whole, sliced;
      DrawingSlice slice;
      slice.beginWhole();
      draw(slice, batches, whole);
      QVERIFY(slice.end());
      slice.restart();
      bool complete = false;
      for (int goes = 0; !complete; ++goes) {
        const int most = random.bounded(1, 300);
        slice.begin(most);
        const std::size_t before = sliced.size();
        draw(slice, batches, sliced);
        complete = slice.end();
        QVERIFY(static_cast<int>(sliced.size() - before) <= most);
        QVERIFY(slice.spent() <= most + DrawingSlice::kBatch);
        QVERIFY(complete || sliced.size() < whole.size());
        QVERIFY(goes < 1000);
      }
      QVERIFY(sliced == whole);
    }
  }

  void slicesLookLikeOneGo_data() {
    QTest::addColumn<ViewMode>("mode");
    QTest::newRow("result") << ViewMode::Result;
    QTest::newRow("rejected by") << ViewMode::RejectedBy;
    QTest::newRow("slope") << ViewMode::Slope;
    QTest::newRow("hidden line") << ViewMode::HiddenLine;
  }
  void slicesLookLikeOneGo() {
    QFETCH(ViewMode, mode);
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1100, 800);
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "waves.obj", wavesObj(174)), kPipeline));  // 60,552 triangles
    LevelView& view = window.view();
    auto& modes = window.findChild<LevelLook*>()->modes();
    modes.setMode(mode);
    QTRY_VERIFY_WITH_TIMEOUT(modes.upToDate(), 30000);
    // Draws in slices, however fast the machine: the picture is dropped, and continued in events.
    int slices = 0;
    view.cameraController().zoomBy(1.3);
    QVERIFY(!view.isWhole());
    while (!view.isWhole() && slices < 10000) {
      QTest::qWait(1);
      ++slices;
    }
    QVERIFY(view.isWhole());
    const QImage sliced = view.grabFramebuffer();
    // Another picture in between, so that this one is drawn anew, in one go.
    const SceneParts parts = view.parts();
    SceneParts none = parts;
    none.environment = none.walkable = false;
    view.setParts(none);
    QVERIFY(view.grabFramebuffer() != sliced);
    view.setParts(parts);
    QCOMPARE(view.grabFramebuffer(), sliced);
  }

  void thePictureBeforeStaysUntilTheNextIsComplete() {
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1100, 800);
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "waves.obj", wavesObj(174)), kPipeline));
    LevelView& view = window.view();
    const QImage before = view.grabFramebuffer();
    SceneParts parts = view.parts();
    parts.environment = false;
    const auto frame = [&] { return static_cast<QOpenGLWidget&>(view).grabFramebuffer(); };
    view.setParts(parts);
    const QImage first = frame();
    if (view.isWhole()) QSKIP("60,552 triangles are drawn before the first slice is over: nothing to see in between");
    QCOMPARE(first, before);
    QTRY_VERIFY(view.isWhole());
    QVERIFY(frame() != before);
    QCOMPARE(frame(), view.grabFramebuffer());
  }

  // Parts arrive as from a run on a large level: each with a surface and lines of its own.
  void thousandsOfPartsLeaveTheWindowAlive() {
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1100, 800);
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "floor.obj", floorObj()), "SlopeFilter 45\n"));
    LevelView& view = window.view();
    // The floor of 8 x 8, once for each of 71 x 71 places on it.
    const auto part = [floor = *view.content().walkable.front()](int number) {
      constexpr int kSide = 71;
      auto made = std::make_shared<NavigationMeshGeometry>(floor);
      const auto move = [number](std::array<float, 3>& p) {
        p[0] = p[0] / kSide + 8.0F * static_cast<float>(number % kSide) / kSide - 4;
        p[1] = p[1] / kSide + 8.0F * static_cast<float>(number / kSide) / kSide - 4;
      };
      for (SurfaceVertex& vertex : made->surface) move(vertex.position);
      for (LineSegment& line : made->outline) {
        move(line.from);
        move(line.to);
      }
      return made;
    };
    ViewContent content;
    FrameWatchdog watchdog;
    watchdog.start();
    for (int step = 0; step < 5; ++step) {
      for (int i = 0; i < 1000; ++i) content.walkable.push_back(part(1000 * step + i));
      view.setContent(content);
      QTest::qWait(50);
    }
    QTRY_VERIFY_WITH_TIMEOUT(view.isWhole(), 60000);
    view.cameraController().turnBy(10, 0);  // while the camera moves, too
    QTRY_VERIFY_WITH_TIMEOUT(view.isWhole(), 60000);
    watchdog.stop();
    QVERIFY(shareOfWalkable(view.grabFramebuffer()) > 0.1);
    qInfo("5,000 parts: longest stall %.0f ms in %s", watchdog.longestStallMs(),
          qPrintable(watchdog.longestStall().during));
    QVERIFY(watchdog.longestStallMs() < 2000);  // far above what it takes: a busy machine is no failure
  }

  void aLargeLevelLeavesTheWindowAlive() {
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1100, 800);
    QVERIFY(showWindow(window));
    FrameWatchdog watchdog;
    watchdog.start();
    QVERIFY(openZUp(window, writeFile(folder, "waves.obj", wavesObj(300)), kPipeline));  // 180,000 triangles
    QTRY_VERIFY_WITH_TIMEOUT(window.view().isWhole(), 60000);
    for (int i = 0; i < 10; ++i) {
      window.view().cameraController().turnBy(3, 0);
      QTest::qWait(1);
    }
    QTRY_VERIFY_WITH_TIMEOUT(window.view().isWhole(), 60000);
    watchdog.stop();
    qInfo("180,000 triangles: longest stall %.0f ms in %s, %zu above 100 ms", watchdog.longestStallMs(),
          qPrintable(watchdog.longestStall().during), watchdog.stallsOver(100).size());
    QVERIFY(watchdog.longestStallMs() < 2000);  // far above what it takes: a busy machine is no failure
  }
};

FOOTFALL_EDITOR_SUITE(TestDrawingSlices)
#include "test_drawing_slices.moc"
