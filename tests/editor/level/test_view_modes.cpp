// The modes of the view: their content, when they are enabled, and their legends.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QStandardItemModel>
#include <cmath>

#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/level/level_look.hpp"
#include "ui/view/widgets/legend.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\n";

bool near(const QColor& a, const QColor& b, int most = 40) {
  return std::abs(a.red() - b.red()) <= most && std::abs(a.green() - b.green()) <= most &&
         std::abs(a.blue() - b.blue()) <= most;
}

bool sameHue(const QColor& a, const QColor& b) {
  const int hue = std::abs(a.hsvHue() - b.hsvHue());
  return std::min(hue, 360 - hue) < 12 && std::abs(a.hsvSaturationF() - b.hsvSaturationF()) < 0.15F;
}

}  // namespace

class TestViewModes : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
    look_ = window_->findChild<LevelLook*>();
    QVERIFY(look_);
  }
  void cleanup() { window_.reset(); }

  void modesWaitForWhatTheyShow() {
    QAction* slope = command("slope");
    QVERIFY(!slope->isEnabled());
    QVERIFY(slope->toolTip().contains("Open an environment"));
    QVERIFY(command("result")->isEnabled());
    open();
    for (const ViewMode mode : kViewModes) QVERIFY(command(nameOf(mode))->isEnabled());
    QVERIFY(slope->toolTip().contains("slope"));
  }

  void keysMenuAndBoxAgree() {
    open();
    QTest::keyClick(&window_->view(), Qt::Key_6, Qt::ShiftModifier);
    QVERIFY(settled());
    QCOMPARE(window_->view().mode(), ViewMode::Slope);
    QCOMPARE(look_->modes().box().currentText(), labelOf(ViewMode::Slope));
    QVERIFY(command("slope")->isChecked());
    QVERIFY(!command("result")->isChecked());
    QComboBox& box = look_->modes().box();
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_Home);
    QVERIFY(settled());
    QCOMPARE(window_->view().mode(), ViewMode::Result);
    command("walkable")->trigger();
    QCOMPARE(box.currentText(), labelOf(ViewMode::WalkableOnly));
  }

  void wireframesHideNothing() {
    open();
    show(ViewMode::Wireframe);
    QVERIFY(near(colourAt({2.2, 1, 0}), backgroundUpper(), 40));  // The pixel is between the edges.
    int wires = 0;
    const QImage picture = window_->view().grabFramebuffer();
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) wires += near(picture.pixelColor(x, y), wireColour(), 60) ? 1 : 0;
    }
    QVERIFY2(wires > 200, qPrintable(QString::number(wires)));
    // The floor's edge is seen through the table in the one, and not in the other.
    show(ViewMode::HiddenLine);
    QVERIFY(near(colourAt({2.2, 1, 0}), hiddenLineFill(), 12));
  }

  void walkableOnlyLeavesTheRestOut() {
    open();
    const Vec3 ramp{5.6, 0.5, 1.04};
    QVERIFY(sameHue(colourAt(ramp), removalStyle(FilterType::Slope)->paint.colour));
    show(ViewMode::WalkableOnly);
    QVERIFY(near(colourAt(ramp), backgroundUpper(), 40));
    QVERIFY(sameHue(colourAt({2.2, 1, 0}), walkablePaint().colour));
  }

  void rejectedPlacesStandOut() {
    open();
    show(ViewMode::RejectedBy);
    QVERIFY(sameHue(colourAt({5.6, 0.5, 1.04}), removalStyle(FilterType::Slope)->vivid.colour));
    QVERIFY(!sameHue(colourAt({2.2, 1, 0}), walkablePaint().colour));
  }

  void slopesHaveColoursAndALimit() {
    open();
    show(ViewMode::Slope);
    QVERIFY(near(colourAt({2.2, 1, 0}), heatColour(1), 30));                // level
    QVERIFY(near(brightestAt({5.6, 0.5, 1.04}), heatColour(1.0 / 3), 45));  // 60 degrees of 90
    auto* scale = partOf<Legend>(*window_).findChild<QLabel*>("modeScale");
    QVERIFY(scale->isVisible());
    QCOMPARE(scale->accessibleName(), QString("Slope, limit 45"));
    // The limit follows the filter.
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[0].id, 0, 70, 0);
    QCOMPARE(scale->accessibleName(), QString("Slope, limit 70"));
  }

  void freeHeightsShowTheTable() {
    open();
    show(ViewMode::Clearance);
    // The camera looks from the side, under the table: 1 of 4 units, which is less than the limit of 2.
    CameraPose low;
    low.position = {0, -9, 0.7};
    low.pivot = {0, 0, 0.1};
    const double tilt = std::atan2(0.6, 9.0);
    low.orientation = {std::sin(M_PI / 4 - tilt / 2), 0, 0, std::cos(M_PI / 4 - tilt / 2)};
    window_->view().cameraController().setPose(low);
    QVERIFY(near(brightestAt({0, -0.4, 0}), heatColour(0.25), 45));
    QVERIFY(near(brightestAt({0, -2.5, 0}), heatColour(1), 45));
    QCOMPARE(partOf<Legend>(*window_).findChild<QLabel*>("modeScale")->accessibleName(), QString("Clearance, limit 2"));
  }

  void sourceTrianglesAreToldApart() {
    open();
    show(ViewMode::SourceTriangles);
    // The two triangles of the floor have colours of their own.
    const QColor one = colourAt({3, -3, 0});
    const QColor other = colourAt({-3, 3, 0});
    const auto paints = [&](const QColor& colour) {
      int found = 0;
      for (std::uint32_t t = 0; t < 6; ++t) found += sameHue(colour, sourcePaint(t).colour) ? 1 : 0;
      return found;
    };
    QVERIFY(paints(one) > 0);
    QVERIFY(paints(other) > 0);
    QVERIFY(!sameHue(one, other));
  }

  void theModeFollowsNewResultsAndLevels() {
    open();
    show(ViewMode::SourceTriangles);
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[0].id, 0, 70, 0);
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(settled());
    QVERIFY(!sameHue(colourAt({5.6, 0.5, 1.04}), removalStyle(FilterType::Slope)->paint.colour));  // walkable now
    QVERIFY(openZUp(*window_, writeFile(folder_, "floor.obj", floorObj()), kPipeline));
    QVERIFY(settled());
    window_->view().cameraController().viewFromTop();
    QCOMPARE(window_->view().mode(), ViewMode::SourceTriangles);
    QVERIFY(sameHue(colourAt({3, -3, 0}), sourcePaint(0).colour) ||
            sameHue(colourAt({3, -3, 0}), sourcePaint(1).colour));
  }

  void sessionsKeepTheMode() {
    open();
    show(ViewMode::Slope);
    const QString session = folder_.filePath("mode.footfall");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(session);
    QVERIFY(written.wait());
    show(ViewMode::Result);
    window_->open(session);
    QVERIFY(QTest::qWaitFor([&] { return look_->modes().mode() == ViewMode::Slope; }));
    QVERIFY(settled());
  }

  void legendsFit_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("small") << QSize(1000, 640);
    QTest::newRow("usual") << QSize(1280, 800);
  }
  void legendsFit() {
    QFETCH(QSize, size);
    window_->resize(size);
    open();
    window_->setCellsShown({true, true, CellColouring::Time});
    window_->findChild<QAction*>("view.cutPlane")->setChecked(true);
    for (const ViewMode mode : kViewModes) {
      show(mode);
      QTest::qWait(50);
      std::vector<QWidget*> over;
      for (const char* name : {"legend", "axisGizmo", "heightSlider", "cutBar"}) {
        for (QWidget* widget : window_->view().findChildren<QWidget*>(name)) {
          if (widget->isVisible()) over.push_back(widget);
        }
      }
      QVERIFY(over.size() >= 4);
      for (QWidget* widget : over) {
        QVERIFY2(window_->view().rect().contains(widget->geometry()), qPrintable(widget->objectName()));
        for (QWidget* other : over) {
          QVERIFY2(widget == other || !widget->geometry().intersects(other->geometry()),
                   qPrintable(widget->objectName() + " and " + other->objectName() + ", " + labelOf(mode)));
        }
      }
    }
  }

  void theCutPlaneCuts() {
    open();
    window_->view().setFocus();
    QTest::keyClick(&window_->view(), Qt::Key_X, Qt::ShiftModifier);
    CutBar& bar = look_->cutBar();
    QVERIFY(bar.isVisible());
    QVERIFY(window_->view().cutPlane());
    const QColor ground = colourAt({3, 1, 0});
    QVERIFY(!sameHue(ground, walkablePaint().colour));
    QVERIFY(sameHue(colourAt({-3, 1, 0}), walkablePaint().colour));
    QVERIFY(!window_->view().pick(window_->view().project({3, 1, 0})->toPoint()));
    QTest::mouseClick(bar.findChild<QToolButton*>("cutFlip"), Qt::LeftButton);
    QVERIFY(sameHue(colourAt({3, 1, 0}), walkablePaint().colour));
    QVERIFY(!sameHue(colourAt({-3, 1, 0}), walkablePaint().colour));
    // Keys move to one end: nothing is cut there.
    bar.slider().setFocus();
    QTest::keyClick(&bar.slider(), Qt::Key_End);
    QVERIFY(sameHue(colourAt({-3, 1, 0}), walkablePaint().colour));
    bar.setFacing(CutBar::Facing::Y);
    bar.slider().setValue(bar.slider().maximum() / 2);
    QVERIFY(sameHue(colourAt({3, -2, 0}), walkablePaint().colour));
    QVERIFY(!sameHue(colourAt({3, 2, 0}), walkablePaint().colour));
    QTest::mouseClick(bar.findChild<QToolButton*>("cutClose"), Qt::LeftButton);
    QVERIFY(!bar.isVisible());
    QVERIFY(!window_->findChild<QAction*>("view.cutPlane")->isChecked());
    QVERIFY(sameHue(colourAt({3, 2, 0}), walkablePaint().colour));
  }

 private:
  QAction* command(std::string_view mode) {
    return window_->findChild<QAction*>("view.mode." + QString::fromUtf8(mode.data(), qsizetype(mode.size())));
  }
  void open() {
    QVERIFY(openZUp(*window_, writeFile(folder_, "table.obj", tableObj()), kPipeline));
    window_->view().cameraController().viewFromTop();
  }
  bool settled() {
    return QTest::qWaitFor([&] { return look_->modes().upToDate(); }, 20000);
  }
  void show(ViewMode mode) {
    look_->modes().setMode(mode);
    QVERIFY(settled());
    QCOMPARE(window_->view().mode(), mode);
  }
  QColor colourAt(const Vec3& place) { return colourInView(*window_, place); }
  /// The brightest colour, between the lines of a hatching.
  QColor brightestAt(const Vec3& place) {
    const QImage picture = window_->view().grabFramebuffer();
    const auto at = window_->view().project(place);
    QColor brightest(Qt::black);
    for (int x = -3; at && x <= 3; ++x) {
      const QPoint pixel = (*at * picture.devicePixelRatio()).toPoint() + QPoint(x, 0);
      const QColor colour = picture.pixelColor(pixel);
      if (colour.lightness() > brightest.lightness()) brightest = colour;
    }
    return brightest;
  }

  QTemporaryDir folder_;
  std::unique_ptr<EditorWindow> window_;
  LevelLook* look_ = nullptr;
};

FOOTFALL_EDITOR_SUITE(TestViewModes)
#include "test_view_modes.moc"
