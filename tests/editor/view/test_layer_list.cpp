// The dock "Layers", and what hidden layers do to the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "footfall/inspect.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/view/widgets/height_slider.hpp"
#include "ui/view/widgets/layer_panel.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

/// Two floors over each other, the upper one smaller, both single-sided.
QByteArray storeysObj() { return floorObj() + "v -2 -2 4\nv 2 -2 4\nv 2 2 4\nv -2 2 4\nf 5 6 7 8\n"; }

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\nLayerSubdivisionFilter\n";

bool looksLike(const QColor& pixel, const QColor& paint) {
  const int hue = std::abs(pixel.hsvHue() - paint.hsvHue());
  return std::min(hue, 360 - hue) < 12 && std::abs(pixel.hsvSaturationF() - paint.hsvSaturationF()) < 0.15F;
}

double shareOf(const QImage& image, const QColor& paint) {
  qint64 count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) count += looksLike(image.pixelColor(x, y), paint) ? 1 : 0;
  }
  return static_cast<double>(count) / (static_cast<double>(image.width()) * image.height());
}

}  // namespace

class TestLayerList : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
    QVERIFY(openZUp(*window_, writeFile(folder_, "storeys.obj", storeysObj()), kPipeline));
    window_->findChild<QAction*>("panel.layers")->trigger();
    panel_ = window_->findChild<LayerPanel*>();
    QVERIFY(panel_);
    QVERIFY(QTest::qWaitFor([&] { return panel_->isVisible(); }));
    QCOMPARE(panel_->layers(), 2U);
    window_->view().cameraController().viewFromTop();
    for (std::uint32_t layer = 0; layer < 2; ++layer) {
      const LayerFigures& figures = window_->view().content().walkable.front()->figures.at(layer);
      (figures.area > 40 ? ground_ : deck_) = layer;
    }
  }
  void cleanup() { window_.reset(); }

  void listsAreasAndTriangles() {
    QCOMPARE(panel_->list().topLevelItemCount(), 2);
    QTreeWidgetItem* row = rowOf(ground_);
    QCOMPARE(row->text(1), QString::number(ground_));
    QCOMPARE(row->text(2), QString("64.00"));
    QVERIFY(row->text(3).toInt() >= 2);
    QVERIFY(!row->icon(1).isNull());
  }

  void saysHowManyAreNeededAtLeast() {
    const auto* summary = panel_->findChild<QLabel*>("layerSummary");
    QTRY_COMPARE(summary->text(), QString("2 layers (as few as possible)\n0 connections"));
    window_->openWith(QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/villa/villa.obj"), parsePipeline(kPipeline, "test"),
                      {});
    QVERIFY(waitUntilIdle(*window_));
    QTRY_VERIFY2(summary->text().contains(" needed)"), qPrintable(summary->text()));
    const NavigationMesh& mesh = *window_->controller().finishedRun()->result.mesh;
    const auto text = [](std::size_t count, const QString& noun, std::size_t least) {
      const QString start = QString("%1 %2").arg(count).arg(noun);
      if (count == least) return start + " (as few as possible)";
      return start +
             (least == 1 ? QString(" (at least 1 is needed)") : QString(" (at least %1 are needed)").arg(least));
    };
    QCOMPARE(summary->text().remove(QLocale().groupSeparator()),
             text(mesh.layerCount, "layers", leastLayers(mesh)) + '\n' +
                 text(mesh.connections.size(), "connections", leastConnections(mesh)));
    shoot(*window_, "layers-needed");
    // Hidden layers are counted instead.
    panel_->showOnly(0);
    QCOMPARE(summary->text(), QString("1 of %1 layers shown").arg(mesh.layerCount));
    panel_->showAll();
    QVERIFY(summary->text().contains(" needed)"));
  }

  void theEyeHidesALayerAndItsEdges() {
    const QColor deck = layerPaint(deck_).colour;
    const QColor ground = layerPaint(ground_).colour;
    const QImage all = picture();
    QVERIFY(shareOf(all, deck) > 0.02);
    click(deck_, 0);
    QCOMPARE(panel_->hidden(), (std::set<std::uint32_t>{deck_}));
    const QImage without = picture();
    QVERIFY(shareOf(without, deck) < 0.001);
    // The ground below becomes visible: the floor of the environment went with it, and so did its outline.
    QVERIFY(shareOf(without, ground) > shareOf(all, ground) + 0.5 * shareOf(all, deck));
    const auto corner = window_->view().project({2, 2, 4});
    QVERIFY(corner);
    QVERIFY(looksLike(without.pixelColor((*corner * without.devicePixelRatio()).toPoint()), ground));
    click(deck_, 0);
    QCOMPARE(picture(), all);
  }

  void picksThroughHiddenLayers() {
    const auto middle = window_->view().project({0.2, 0.3, 4});
    QVERIFY(middle);
    QCOMPARE(window_->view().pick(middle->toPoint())->point.z, 4.0);
    click(deck_, 0);
    QCOMPARE(window_->view().pick(middle->toPoint())->point.z, 0.0);
  }

  void aClickShowsOneLayerAndTheNextOneAll() {
    click(ground_, 1);
    QCOMPARE(panel_->soloLayer(), std::optional(ground_));
    QVERIFY(shareOf(picture(), layerPaint(deck_).colour) < 0.001);
    click(ground_, 1);
    QVERIFY(panel_->hidden().empty());
    click(deck_, 1);
    QTest::mouseClick(panel_->findChild<QPushButton*>("showAllLayers"), Qt::LeftButton);
    QVERIFY(panel_->hidden().empty());
  }

  void keysHideAndShow() {
    panel_->list().setFocus();
    panel_->list().setCurrentItem(rowOf(deck_));
    QTest::keyClick(&panel_->list(), Qt::Key_Space);
    QCOMPARE(panel_->hidden(), (std::set<std::uint32_t>{deck_}));
    QTest::keyClick(&panel_->list(), Qt::Key_Space);
    QTest::keyClick(&panel_->list(), Qt::Key_Return);
    QCOMPARE(panel_->soloLayer(), std::optional(deck_));
    window_->view().setFocus();
    QTest::keyClick(&window_->view(), Qt::Key_PageUp);
    QVERIFY(panel_->soloLayer() == std::optional(ground_));
    QTest::keyClick(&window_->view(), Qt::Key_PageDown);
    QVERIFY(panel_->soloLayer() == std::optional(deck_));
    QTest::keyClick(&window_->view(), Qt::Key_PageUp, Qt::ShiftModifier);
    QVERIFY(panel_->hidden().empty());
  }

  void sortsByArea() {
    panel_->list().sortByColumn(2, Qt::DescendingOrder);
    QCOMPARE(panel_->list().topLevelItem(0)->text(1), QString::number(ground_));
    panel_->list().sortByColumn(2, Qt::AscendingOrder);
    QCOMPARE(panel_->list().topLevelItem(0)->text(1), QString::number(deck_));
  }

  void hiddenLayersStayHiddenOverRuns() {
    click(deck_, 0);
    const auto& filters = partOf<Document>(*window_).filters();
    partOf<Document>(*window_).setValue(filters[1].id, 0, 1.5, 0);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(panel_->hidden(), (std::set<std::uint32_t>{deck_}));
    QVERIFY(shareOf(picture(), layerPaint(deck_).colour) < 0.001);
    QVERIFY(rowOf(deck_)->data(0, Qt::AccessibleTextRole).toString() == "hidden");
  }

  void aResultWithoutLayersIsOneRow() {
    click(deck_, 0);
    partOf<Document>(*window_).setEnabled(partOf<Document>(*window_).filters()[2].id, false);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(panel_->layers(), 0U);
    QCOMPARE(panel_->list().topLevelItemCount(), 1);
    QCOMPARE(panel_->list().topLevelItem(0)->text(2), QString("80.00"));
    QVERIFY(window_->view().hiddenLayers().empty());
    // Storeys replace layers when there are none.
    window_->view().setFocus();
    QTest::keyClick(&window_->view(), Qt::Key_PageUp);
    QVERIFY(partOf<HeightSlider>(*window_).shownFloor().has_value());
  }

  void sessionsKeepThem() {
    click(deck_, 0);
    const QString session = folder_.filePath("layers.footfall");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(session);
    QVERIFY(written.wait());
    click(deck_, 0);
    window_->open(session);
    QVERIFY(QTest::qWaitFor([&] { return panel_->hidden() == std::set<std::uint32_t>{deck_}; }));
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(window_->view().hiddenLayers(), (std::set<std::uint32_t>{deck_}));
  }

 private:
  QImage picture() { return window_->view().grabFramebuffer(); }
  QTreeWidgetItem* rowOf(std::uint32_t layer) {
    for (int i = 0; i < panel_->list().topLevelItemCount(); ++i) {
      if (panel_->list().topLevelItem(i)->text(1) == QString::number(layer)) return panel_->list().topLevelItem(i);
    }
    return nullptr;
  }
  void click(std::uint32_t layer, int column) {
    QTreeWidget& list = panel_->list();
    const QRect cell = list.visualRect(list.indexFromItem(rowOf(layer), column));
    // Two clicks in one place within the time of a double click are one.
    QTest::qWait(QApplication::doubleClickInterval() + 50);
    QTest::mouseClick(list.viewport(), Qt::LeftButton, Qt::NoModifier, cell.center());
  }

  QTemporaryDir folder_;
  std::unique_ptr<EditorWindow> window_;
  LayerPanel* panel_ = nullptr;
  std::uint32_t ground_ = 0, deck_ = 1;
};

FOOTFALL_EDITOR_SUITE(TestLayerList)
#include "test_layer_list.moc"
