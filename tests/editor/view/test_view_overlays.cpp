// The overlays of the view, and the places that the camera chooses: beside them, and unchanged.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QPolygonF>
#include <QSettings>
#include <QToolButton>
#include <cmath>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/level/level_look.hpp"
#include "ui/level/obstacle_features.hpp"
#include "ui/view/camera/camera_tools.hpp"
#include "ui/view/overlays/label_layout.hpp"
#include "ui/view/widgets/height_slider.hpp"
#include "ui/view/widgets/legend.hpp"
#include "ui/view/widgets/view_layout.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

class TestViewOverlays : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    QSettings().clear();
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1280, 860);
    QVERIFY(showWindow(*window_));
    QVERIFY(
        openZUp(*window_, writeFile(folder_, "table.obj", tableObj()), "SlopeFilter 45\nVerticalClearanceFilter 2\n"));
  }
  void cleanup() { window_.reset(); }

  void theLegendIsMovedAndFolded() {
    Legend& legend = partOf<Legend>(*window_);
    const QPoint corner = legend.pos();
    drag(legend, QPoint(legend.width() - 3, legend.height() - 3), QPoint(220, -180));
    const QPoint there = legend.pos();
    QVERIFY2((there - corner - QPoint(220, -180)).manhattanLength() <= 4, qPrintable(QString::number(there.x())));
    // Never out of the view.
    drag(legend, QPoint(legend.width() - 3, legend.height() - 3), QPoint(-4000, 4000));
    QVERIFY(view().rect().contains(legend.geometry()));
    drag(legend, QPoint(legend.width() - 3, legend.height() - 3), there - legend.pos());
    QTest::mouseClick(&legend.foldButton(), Qt::LeftButton);
    QVERIFY(legend.folded());
    QVERIFY(legend.height() < 60);
    QVERIFY(!legend.findChild<QCheckBox*>()->isVisible());
    // Both are remembered.
    {
      EditorWindow other;
      other.resize(1280, 860);
      QVERIFY(showWindow(other));
      QVERIFY(openZUp(other, folder_.filePath("table.obj"), "SlopeFilter 45\n"));
      QVERIFY(partOf<Legend>(other).folded());
      QVERIFY(partOf<Legend>(other).x() > corner.x() + 100);
    }
    QTest::mouseClick(&legend.foldButton(), Qt::LeftButton);
    QVERIFY(!legend.folded());
    QTest::mouseDClick(&legend, Qt::LeftButton, Qt::NoModifier, QPoint(legend.width() - 3, legend.height() - 3));
    QCOMPARE(legend.pos(), corner);
  }

  void smallViewsAreNotCovered() {
    // Somebody's first window: nothing was folded or unfolded by hand.
    QSettings().clear();
    EditorWindow first;
    first.resize(1024, 700);
    QVERIFY(showWindow(first));
    QVERIFY(openZUp(first, folder_.filePath("table.obj"), "SlopeFilter 45\n"));
    const QSize size = first.view().size();
    int covered = 0;
    for (const QRect& rect : partOf<ViewLayout>(first).covered()) {
      QVERIFY(first.view().rect().contains(rect));
      covered += rect.width() * rect.height();
    }
    QVERIFY2(covered < size.width() * size.height() / 6,
             qPrintable(QStringLiteral("%1 of %2 x %3").arg(covered).arg(size.width()).arg(size.height())));
    // A legend folds itself when it would take much of the room.
    partOf<Legend>(*window_).fitInto({400, 300});
    QVERIFY(partOf<Legend>(*window_).folded());
    partOf<Legend>(*window_).fitInto({1100, 800});
    QVERIFY(!partOf<Legend>(*window_).folded());
  }

  void aHintFitsIntoEveryView() {
    ViewHint& hint = *view().findChild<ViewHint*>();
    hint.showText(QStringLiteral("Roofs and outer walls are open: Shift+I closes them.\nThe handles show one storey."));
    auto* close = hint.findChild<QToolButton*>("hintClose");
    HeightSlider& heights = partOf<HeightSlider>(*window_);
    QVERIFY(heights.isVisible());
    for (const int width : {320, 360, 420, 560, 900}) {
      // The view is as wide as docks at both sides leave it.
      view().resize(width, 560);
      partOf<ViewLayout>(*window_).update();
      const QRect here = hint.geometry();
      QCOMPARE(view().width(), width);
      QVERIFY2(here.left() >= 0 && here.right() < width, qPrintable(QString::number(width)));
      QVERIFY2(!here.intersects(heights.geometry()), qPrintable(QString::number(width)));
      QVERIFY(hint.rect().contains(close->geometry()));
      QVERIFY(hint.height() >= hint.layout()->heightForWidth(hint.width()) || width > 500);
    }
    // A person who begins to work has seen it.
    QTest::keyClick(&view(), Qt::Key_M);
    QVERIFY(hint.isHidden());
    QTest::keyClick(&view(), Qt::Key_M);
  }

  void nothingCoversWhatIsFitted() {
    for (const auto& look : {&CameraController::viewOblique, &CameraController::viewFromTop, &CameraController::fit}) {
      (view().cameraController().*look)();
      QPolygonF outline;
      for (const Vec3& p : view().environmentGeometry()->extremes) {
        const Vec3& c = view().environmentGeometry()->centre;
        const auto at = view().project({p.x + c.x, p.y + c.y, p.z + c.z});
        QVERIFY(at && QRectF(view().rect()).contains(*at));
        for (const QRect& rect : partOf<ViewLayout>(*window_).covered()) QVERIFY(!rect.contains(at->toPoint()));
        outline << *at;
      }
      // It is still large.
      QVERIFY(std::max(outline.boundingRect().width() / view().width(),
                       outline.boundingRect().height() / view().height()) > 0.5);
    }
  }

  void panelsDoNotMoveThePicture_data() {
    QTest::addColumn<bool>("parallel");
    QTest::newRow("perspective") << false;
    QTest::newRow("parallel") << true;
  }
  void panelsDoNotMoveThePicture() {
    QFETCH(bool, parallel);
    if (parallel) view().cameraController().viewFromTop();
    QCursor::setPos(window_->mapToGlobal(QPoint(2, 2)));  // A place under the mouse stays where it is: test_camera.
    QVERIFY(QTest::qWaitFor([&] { return !view().rect().contains(view().mapFromGlobal(QCursor::pos())); }));
    const auto pivot = view().cameraController().pose().pivot;
    const auto onScreen = [&](const Vec3& place) {
      return view().mapTo(window_.get(), view().project(place)->toPoint());
    };
    const auto unit = [&] {
      const qglviewer::Vec right = view().camera()->rightVector();
      const Vec3 beside{pivot.x + right.x, pivot.y + right.y, pivot.z + right.z};
      const QPointF way = *view().project(beside) - *view().project(pivot);
      return std::hypot(way.x(), way.y());
    };
    for (const char* id : {"panel.layers", "view.log", "view.load"}) {
      const QPoint before = onScreen(pivot);
      const double size = unit();
      const QSize was = view().size();
      QAction* panel = window_->findChild<QAction*>(id);
      QVERIFY(panel);
      panel->trigger();
      QVERIFY(QTest::qWaitFor([&] { return view().size() != was; }));
      QTest::qWait(30);
      QVERIFY2((onScreen(pivot) - before).manhattanLength() <= 3, id);
      QVERIFY2(std::abs(unit() / size - 1) < 0.01, id);
      panel->trigger();
      QVERIFY(QTest::qWaitFor([&] { return view().size() == was; }));
      QVERIFY2((onScreen(pivot) - before).manhattanLength() <= 3, id);
    }
    // A larger window shows the level larger, as ever.
    const double size = unit();
    window_->resize(1280, 1010);
    QTest::qWait(50);
    QVERIFY(unit() > 1.05 * size);
  }

  void labelsStayInside() {
    view().cameraController().viewFromTop();
    SceneParts none;
    none.environment = none.walkable = none.removed = none.outlines = none.obstacleEdges = false;
    view().setParts(none);
    const QImage empty = view().grabFramebuffer();
    const auto inkAt = [&](const QPoint& place) {
      const Ray ray = view().rayAt(place);
      const double way = -ray.origin.z / ray.direction.z;
      ViewOverlay overlay;
      overlay.labels.push_back({pointOn(ray, way), QStringLiteral("Box 1: at 12.5, 17.25, 0; size 1 × 1 × 1; 45°")});
      view().setOverlay("words", overlay);
      const QImage picture = view().grabFramebuffer();
      int ink = 0;
      for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x)
          ink += picture.pixelColor(x, y).lightness() < 100 && empty.pixelColor(x, y).lightness() > 150 ? 1 : 0;
      }
      return ink;
    };
    const int whole = inkAt(view().rect().center());
    QVERIFY(whole > 200);
    for (const QPoint& place : {QPoint(view().width() - 4, 300), QPoint(300, 2), QPoint(view().width() - 2, 2),
                                QPoint(view().width() - 2, view().height() - 2), QPoint(2, view().height() - 2)})
      QVERIFY2(inkAt(place) > 0.9 * whole, qPrintable(QString("%1, %2").arg(place.x()).arg(place.y())));
  }

  void labelsKeepOffEachOther() {
    const QSizeF label(80, 20);
    const QRectF slider(300, 50, 90, 200);
    const QRectF mark(195, 195, 10, 10);
    const QRectF room(0, 0, 400, 300);
    LabelLayout layout(room.size(), {slider, mark});
    std::vector<QRectF> taken{slider, mark};
    // Labels lie in the open, all at one place, beside the slider, under it, at an edge, and outside.
    for (const QPointF& at : {QPointF(100, 100), QPointF(200, 200), QPointF(200, 200), QPointF(200, 200),
                              QPointF(200, 200), QPointF(200, 200), QPointF(200, 200), QPointF(290, 120),
                              QPointF(345, 160), QPointF(398, 290), QPointF(2, 2), QPointF(-70, 40)}) {
      const QRectF box = layout.place(label, at);
      QCOMPARE(box.size(), label);
      QVERIFY(room.contains(box));
      for (const QRectF& other : taken)
        QVERIFY2(!box.intersects(other), qPrintable(QString("%1, %2").arg(at.x()).arg(at.y())));
      taken.push_back(box);
    }
    // The label is as near as possible: above to the right, where nothing is in the way.
    QCOMPARE(taken[2].bottomLeft(), QPointF(110, 96));
    // A label without any room is inside all the same.
    LabelLayout full(room.size(), {room});
    QVERIFY(room.contains(full.place(label, {200, 200})));
  }

  void nothingCoversLabels() {
    const QRect slider = partOf<HeightSlider>(*window_).geometry();
    QVERIFY(partOf<HeightSlider>(*window_).isVisible());
    SceneParts none;
    none.environment = none.walkable = none.removed = none.outlines = none.obstacleEdges = false;
    view().setParts(none);
    view().cameraController().viewFromTop();
    const auto inkOf = [&](const std::vector<QPoint>& places) {
      view().removeOverlay("words");
      const QImage empty = view().grab().toImage();
      ViewOverlay overlay;
      for (const QPoint& place : places) {
        const Ray ray = view().rayAt(place);
        overlay.labels.push_back({pointOn(ray, -ray.origin.z / ray.direction.z), QStringLiteral("Target: 12.25 m")});
      }
      view().setOverlay("words", overlay);
      const QImage picture = view().grab().toImage();
      int ink = 0;
      for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x)
          ink += picture.pixelColor(x, y).lightness() < 100 && empty.pixelColor(x, y).lightness() > 150 ? 1 : 0;
      }
      return ink;
    };
    const QPoint open(view().width() / 2, 300);
    const int whole = inkOf({open});
    QVERIFY(whole > 100);
    QVERIFY(inkOf({open, open}) > 1.9 * whole);
    QVERIFY(inkOf({QPoint(slider.left() - 4, slider.center().y())}) > 0.9 * whole);
    QVERIFY(inkOf({slider.center()}) > 0.9 * whole);
  }

  void aFoldedLegendStaysFolded() {
    class Frame : public OverlayFrame {
     public:
      explicit Frame(QWidget* parent) : OverlayFrame("Words", "testFrame", parent), words(new QLabel(this)) {
        body().addWidget(words);
      }
      QLabel* words;
    };
    Frame frame(&view());
    frame.words->setFixedSize(150, 300);
    frame.fitInto({900, 600});
    QVERIFY(frame.folded());
    // With fewer entries it does not unfold over the selection; in a larger view it does.
    frame.words->setFixedSize(150, 60);
    frame.fitInto({900, 600});
    QVERIFY(frame.folded());
    frame.fitInto({1200, 800});
    QVERIFY(!frame.folded());
    frame.fitInto({900, 600});
    QVERIFY(!frame.folded());
  }

  void theSelectionIsFramed() {
    QAction* frame = window_->findChild<QAction*>("view.frame");
    auto* obstacles = window_->findChild<ObstacleFeatures*>();
    PlacedObstacle box;
    box.name = "crate";
    box.base = {3, 3, 0};
    box.size = {0.5, 0.5, 0.5};
    const std::uint32_t id = obstacles->editor().add(box);
    obstacles->editor().select(id);
    frame->trigger();
    const auto sizeOf = [&](const Vec3& a, const Vec3& b) {
      const QPointF way = *view().project(b) - *view().project(a);
      return std::hypot(way.x(), way.y()) / view().height();
    };
    QVERIFY(sizeOf({2.75, 3, 0.25}, {3.25, 3, 0.25}) > 0.2);
    QVERIFY(view().rect().contains(view().project({3, 3, 0.25})->toPoint()));
    // The last selection counts, and removed ones do not.
    view().cameraController().setSelectionBounds("path", SceneBox{{-4, -4, 0}, {-3, -3, 0}});
    frame->trigger();
    QVERIFY(view().rect().contains(view().project({-3.5, -3.5, 0})->toPoint()));
    view().cameraController().setSelectionBounds("path", std::nullopt);
    frame->trigger();
    QVERIFY(view().rect().contains(view().project({3, 3, 0.25})->toPoint()));
  }

  void manySourceTrianglesAreNoBlackSurface() {
    QVERIFY(openZUp(*window_, writeFile(folder_, "waves.obj", wavesObj(174)), "SlopeFilter 80\n"));
    view().cameraController().viewFromTop();
    view().cameraController().zoomBy(0.5);
    window_->findChild<LevelLook*>()->modes().setMode(ViewMode::SourceTriangles);
    QVERIFY(QTest::qWaitFor([&] { return window_->findChild<LevelLook*>()->modes().upToDate(); }, 30000));
    const QImage picture = view().grabFramebuffer();
    const auto isDark = [](const QColor& c) { return std::max({c.red(), c.green(), c.blue()}) < 75; };
    int dark = 0;
    int all = 0;
    const QPoint middle = view().rect().center();
    for (int y = middle.y() - 80; y < middle.y() + 80; ++y) {
      for (int x = middle.x() - 80; x < middle.x() + 80; ++x, ++all) dark += isDark(picture.pixelColor(x, y)) ? 1 : 0;
    }
    QVERIFY2(dark < all / 4, qPrintable(QString("%1 of %2").arg(dark).arg(all)));
  }

  void threadsAreListedByTheirWork() {
    CellBlock block;
    const auto cell = [&](int thread, double ms) {
      CellReport report;
      report.thread = thread;
      report.spans = {{"SlopeFilter", thread, 0, ms}};
      block.report.cells.push_back(report);
      block.finished.push_back(1);
    };
    cell(0, 2);
    cell(1, 5);
    cell(0, 1);
    cell(2, 1);
    const std::vector<ThreadShare> shares = threadShares(block);
    QCOMPARE(shares.size(), std::size_t{3});
    QCOMPARE(shares[0].thread, 1);
    QCOMPARE(shares[1].thread, 0);
    QCOMPARE(shares[1].ms, 3.0);
    QCOMPARE(shares[1].cells, std::size_t{2});
  }

  void hugeNumbersAreShort() {
    partOf<HeightSlider>(*window_).setLevel(-1e300, 1e300, {});
    QVERIFY2(partOf<HeightSlider>(*window_).sizeHint().width() < 160,
             qPrintable(QString::number(partOf<HeightSlider>(*window_).sizeHint().width())));
  }

  void oneFliesAsFastAsTheLevelIsLarge() {
    const double slow = window_->findChild<CameraTools*>()->fly().speed();
    QVERIFY(openZUp(*window_, writeFile(folder_, "waves.obj", wavesObj(100)), "SlopeFilter 45\n"));
    const double fast = window_->findChild<CameraTools*>()->fly().speed();
    QVERIFY2(fast > 8 * slow, qPrintable(QString("%1, %2").arg(slow).arg(fast)));
    QVERIFY(window_->findChild<CameraTools*>()->fly().hint().contains(QString::number(fast, 'g', 3)));
  }

 private:
  LevelView& view() { return window_->view(); }
  static void drag(QWidget& widget, const QPoint& from, const QPoint& way) {
    const QPoint start = widget.mapToGlobal(from);  // the widget goes along
    QTest::mousePress(&widget, Qt::LeftButton, Qt::NoModifier, from);
    for (const QPoint& to : {start + way / 2, start + way}) {
      QMouseEvent move(QEvent::MouseMove, widget.mapFromGlobal(to), to, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QCoreApplication::sendEvent(&widget, &move);
    }
    QTest::mouseRelease(&widget, Qt::LeftButton, Qt::NoModifier, widget.mapFromGlobal(start + way));
  }

  QTemporaryDir folder_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestViewOverlays)
#include "test_view_overlays.moc"
