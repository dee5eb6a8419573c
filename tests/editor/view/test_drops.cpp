// Drops in the editor: arrows, their switch in the legend, and the legend's text.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <algorithm>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/view/geometry/render_geometry.hpp"
#include "ui/view/scene/appearance.hpp"
#include "ui/view/widgets/legend.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

class TestDrops : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    window_ = std::make_unique<EditorWindow>();
    window_->setRemembering(false);
    window_->resize(1100, 760);
    QVERIFY(showWindow(*window_));
  }
  void cleanup() { window_.reset(); }

  void arrowsLeadFromTheLedgeToTheLanding() {
    NavigationMesh mesh;
    mesh.vertices = {{0, 0, 1}, {2, 0, 1}, {0, 2, 1}, {0, -4, 0}, {2, -4, 0}, {2, 0, 0}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    mesh.layers = {0, 1};
    mesh.layerCount = 2;
    DropLink drop;
    drop.from = {0, 1};
    drop.toTriangle = 1;
    drop.start = {Vec3{0, 0, 1}, Vec3{2, 0, 1}};
    drop.landing = {Vec3{0, 0, 0}, Vec3{2, 0, 0}};
    drop.depth = 1;
    drop.width = 2;
    mesh.drops = {drop};
    const auto geometry = makeMeshGeometry(mesh, {});
    // The stretch, and two arrows of a shaft and two lines of a head.
    QCOMPARE(geometry->drops.size(), std::size_t{7});
    QCOMPARE(geometry->dropLayers.size(), std::size_t{7});
    for (const LineLayers& layers : geometry->dropLayers) QVERIFY(layers[0] == 0 && layers[1] == 1);
    int tips = 0;
    for (const LineSegment& line : geometry->drops) tips += line.to[2] == 0;
    QCOMPARE(tips, 6);
    for (const LineSegment& line : geometry->drops)
      for (const auto& end : {line.from, line.to}) QVERIFY(end[0] >= 0 && end[0] <= 2 && end[2] >= 0 && end[2] <= 1);
    mesh.drops.clear();
    QVERIFY(makeMeshGeometry(mesh, {})->drops.empty());
  }

  void theLegendSwitchesThem() {
    QVERIFY(
        openZUp(*window_, writeFile(folder_, "table.obj", tableObj()), "SlopeFilter 45\nVerticalClearanceFilter 2\n"));
    QVERIFY(!dropSwitch()->isVisible());
    QVERIFY(
        openZUp(*window_, folder_.filePath("table.obj"), "SlopeFilter 45\nVerticalClearanceFilter 2\nDropFilter 1\n"));
    QTRY_VERIFY(dropSwitch()->isVisible());
    const NavigationMesh& mesh = *window_->controller().finishedRun()->result.mesh;
    double length = 0;
    for (const DropLink& drop : mesh.drops) length += drop.width;
    QCOMPARE(length, 8.0);
    const auto pixels = [&] {
      const QImage picture = window_->view().grabFramebuffer();
      int count = 0;
      for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
          const QColor colour = picture.pixelColor(x, y);
          count += std::abs(colour.red() - dropColour().red()) + std::abs(colour.green() - dropColour().green()) +
                       std::abs(colour.blue() - dropColour().blue()) <
                   30;
        }
      return count;
    };
    QTRY_VERIFY(pixels() > 100);
    QTest::mouseClick(dropSwitch(), Qt::LeftButton, {}, QPoint(8, dropSwitch()->height() / 2));
    QVERIFY(!dropSwitch()->isChecked());
    QTRY_VERIFY(pixels() < 10);
  }

 private:
  QCheckBox* dropSwitch() {
    const auto boxes = partOf<Legend>(*window_).findChildren<QCheckBox*>();
    const auto found = std::ranges::find(boxes, QString("Drop: one way down"), &QCheckBox::text);
    return found == boxes.end() ? nullptr : *found;
  }

  QTemporaryDir folder_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestDrops)
#include "test_drops.moc"
