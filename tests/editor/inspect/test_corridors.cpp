// The panel "Corridors" as a person uses it: widths in the view, the list of bottlenecks, an agent's width, sessions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractItemModel>
#include <QDockWidget>
#include <QLabel>
#include <QSignalSpy>
#include <algorithm>
#include <cmath>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/look/core_colours.hpp"
#include "ui/inspect/corridors/corridor_colours.hpp"
#include "ui/inspect/corridors/corridor_lines.hpp"
#include "ui/inspect/corridors/corridors_feature.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 0.5\n";

/// Two rooms of 4 x 4 and a passage between them, 1 long and 0.8 wide; Z up.
QByteArray roomsObj() {
  return "v 0 0 0\nv 4 0 0\nv 4 1.6 0\nv 4 2.4 0\nv 4 4 0\nv 0 4 0\nf 1 2 3 4 5 6\n"
         "v 5 1.6 0\nv 5 2.4 0\nf 3 7 8 4\n"
         "v 5 0 0\nv 9 0 0\nv 9 4 0\nv 5 4 0\nf 9 10 11 12 8 7\n";
}

constexpr Vec3 kPassage{4.5, 2, 0};

/// One edge of the map: a parabola about a corner over a straight border.
CorridorMap parabola() {
  CorridorMap map;
  const Vec3 corner{0, 2, 0};
  const auto on = [&](double x) { return Vec3{x, (x * x + 4) / 4, 0}; };
  for (const double x : {-2.0, 2.0}) map.vertices.push_back({on(x), 2 * on(x).y, 0});
  CorridorEdge edge;
  edge.to = 1;
  edge.shape = CorridorShape::Parabola;
  edge.left = {corner, corner};
  edge.right = {Vec3{-2, 0, 0}, Vec3{2, 0, 0}};
  edge.width = 2;
  map.edges.push_back(edge);
  return map;
}

}  // namespace

class TestCorridors : public EditorSuite {
  Q_OBJECT

 private slots:
  void init() { QVERIFY(openLevel(roomsObj(), kPipeline)); }
  void cleanup() { closeWindow(); }

  void linesFollowParabolasAndWidths() {
    const CorridorLines lines = makeCorridorLines(parabola(), 0, 1000);
    QVERIFY(lines.lines.size() > 3);
    QCOMPARE(lines.leftOut, std::size_t{0});
    for (const CorridorLine& line : lines.lines) {
      for (const Vec3& p : line.ends) QVERIFY(std::abs(p.y - (p.x * p.x + 4) / 4) < 1e-12);
      QVERIFY(std::abs(line.width - 2 * std::min(line.ends[0].y, line.ends[1].y)) < 1e-12);
    }
    QVERIFY(std::ranges::is_sorted(lines.lines, {}, &CorridorLine::width));
    QCOMPARE(makeCorridorLines(parabola(), 5, 1000).lines.size(), std::size_t{0});  // a slit
    QCOMPARE(makeCorridorLines(parabola(), 0, 1).lines.size(), std::size_t{1});
    QCOMPARE(makeCorridorLines(parabola(), 0, 0).leftOut, std::size_t{1});
  }

  void listsTheBottleneck() {
    QVERIFY(feature().watch().shown() == nullptr);  // no map is made before the panel is shown
    open();
    QCOMPARE(text(0, BottleneckModel::Width), QString("0.8"));
    QCOMPARE(text(0, BottleneckModel::Agent), QString("fits"));
    QCOMPARE(text(0, BottleneckModel::Place), QString("4.5, 2, 0"));
    QVERIFY2(text(0, BottleneckModel::Sides).contains("the only way"), qPrintable(text(0, BottleneckModel::Sides)));
    QVERIFY2(text(0, BottleneckModel::Sides).startsWith("16.40 units²"), qPrintable(text(0, BottleneckModel::Sides)));
    QCOMPARE(panel().summary(), QString("1 bottleneck"));
    QTest::mouseClick(panel().findChild<QPushButton*>("corridorsCopy"), Qt::LeftButton);
    const QStringList lines = QApplication::clipboard()->text().split('\n');
    QCOMPARE(lines.size(), 3);
    QVERIFY2(lines[1].startsWith("0.8\tfits\t"), qPrintable(lines[1]));
    shoot(*window_, "corridors");
  }

  void theAgentsWidthMarksWhatIsTooNarrow() {
    open();
    NumberField* width = panel().widthField();
    QCOMPARE(width->value(), 0.6);
    width->setFocus();
    QTest::keyClick(width, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(width, QStringLiteral("1"));
    QCOMPARE(text(0, BottleneckModel::Agent), QString("too narrow"));
    QVERIFY(index(0, BottleneckModel::Width).data(Qt::ForegroundRole).isValid());
    QCOMPARE(panel().summary(), QString("1 bottleneck, 1 too narrow for the agent"));
    QTest::keyClick(width, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(width, QStringLiteral("0"));
    QVERIFY(!width->problem().isEmpty());
    QCOMPARE(text(0, BottleneckModel::Agent), QString("too narrow"));  // the last valid width
  }

  void theMapIsColouredByWidth() {
    open();
    const Vec3 beside{4.25, 2, 0};
    window_->view().cameraController().viewFromTop();
    window_->view().cameraController().endGlide();
    QTRY_VERIFY(isLike(colourInView(*window_, beside), widthColour(1)));
    panel().setAgentWidth(0.45);  // the same passage is wider for it
    QTRY_VERIFY(isLike(colourInView(*window_, beside), widthColour(2)));
    panel().setAgentWidth(0.6);
    panel().setMapShown(false);
    QTRY_VERIFY(!isLike(colourInView(*window_, beside), widthColour(1)));
    panel().setMapShown(true);
    QTRY_VERIFY(isLike(colourInView(*window_, beside), widthColour(1)));
    // Closing the panel removes the map and frees its memory.
    dock()->close();
    QTRY_VERIFY(!isLike(colourInView(*window_, beside), widthColour(1)));
    QVERIFY(feature().watch().shown() == nullptr);
  }

  void aClickShowsWidthAndBorders() {
    open();
    const auto pose = [&] { return window_->view().cameraController().pose(); };
    const Vec3 before = pose().position;
    QTableView* table = panel().table();
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(index(0, 0)).center());
    QVERIFY(!(pose().position == before));
    window_->view().cameraController().endGlide();
    const auto middle = window_->view().project(kPassage);
    QVERIFY(middle);
    QVERIFY((*middle - QRectF(window_->view().rect()).center()).manhattanLength() < window_->view().width() / 3.0);
    for (const double y : {1.6, 2.4}) {
      const auto border = window_->view().project({4.5, y, 0});
      QVERIFY(border && QRectF(window_->view().rect()).contains(*border));
      QVERIFY(isLike(colourInView(*window_, {4.5, y, 0}), toColour(kYellow)));
    }
    shoot(*window_, "corridors-framed");
    // Return does the same as a click.
    const Vec3 framed = pose().position;
    window_->view().cameraController().fit();
    table->setFocus();
    QTest::keyClick(table, Qt::Key_Return);
    QTRY_VERIFY(distance(pose().position, framed) < 1e-6);
  }

  void onlyThoseWithoutAnotherWay() {
    // A pillar in the middle of the first room has a way around on each side.
    const QByteArray pillar = roomsObj() +
                              "v 1 2 0\nv 2 1.5 0\nv 2 2.5 0\nv 1 2 1\nv 2 1.5 1\nv 2 2.5 1\n"
                              "f 13 14 17 16\nf 14 15 18 17\nf 15 13 16 18\nf 16 17 18\n";
    open();
    QVERIFY(openZUp(*window_, writeFile(*folder_, "pillar.obj", pillar), kPipeline));
    QTRY_VERIFY(panel().model().rowCount() > 1);
    panel().setOnlyWays(true);
    QCOMPARE(panel().model().rowCount(), 1);
    QCOMPARE(text(0, BottleneckModel::Place), QString("4.5, 2, 0"));
    panel().setOnlyWays(false);
    QVERIFY(panel().model().rowCount() > 1);
  }

  void ofARoughPassageOnePlaceIsListed() {
    // The passage has a small niche on either side, in its middle.
    const QByteArray rough =
        "v 0 0 0\nv 4 0 0\nv 4 1.6 0\nv 4 2.4 0\nv 4 4 0\nv 0 4 0\nf 1 2 3 4 5 6\n"
        "v 4.4 1.6 0\nv 4.4 2.4 0\nf 3 7 8 4\n"
        "v 4.4 1.59 0\nv 4.6 1.59 0\nv 4.6 2.41 0\nv 4.4 2.41 0\nf 9 10 11 12\n"
        "v 4.6 1.6 0\nv 5 1.6 0\nv 5 2.4 0\nv 4.6 2.4 0\nf 13 14 15 16\n"
        "v 5 0 0\nv 9 0 0\nv 9 4 0\nv 5 4 0\nf 17 18 19 20 15 14\n";
    open();
    QVERIFY(openZUp(*window_, writeFile(*folder_, "rough.obj", rough), kPipeline));
    const QString note = "from which the way gets wider by less than 5 %.";
    QTRY_VERIFY2_WITH_TIMEOUT(panel().summary().contains(note), qPrintable(panel().summary()), kWaitMs);
    QCOMPARE(panel().model().rowCount(), 1);
    QCOMPARE(text(0, BottleneckModel::Width), QString("0.8"));
  }

  // A radius makes passages narrower; the panel has them as they are, and its width is the agent's.
  void itFollowsTheResult() {
    open();
    Document& document = partOf<Document>(*window_);
    document.addFilter(filterDescriptor(FilterType::Radius), 1);
    const int radius = document.filters().back().id;
    document.setValue(radius, 0, 0.25, 1);
    QVERIFY(waitUntilIdle(*window_));
    QTRY_VERIFY(panel().summary().contains("without the filter Radius"));
    QCOMPARE(text(0, BottleneckModel::Width), QString("0.8"));
    QCOMPARE(panel().agentWidth(), 0.5);
    // Nothing is left, so no bottleneck is either.
    document.setEnabled(radius, false);
    document.setValue(document.filters()[1].id, 0, 0.25, 2);
    QVERIFY(waitUntilIdle(*window_));
    QTRY_COMPARE(panel().summary(), QString("1 bottleneck"));
    document.addFilter(filterDescriptor(FilterType::Area), 1);
    document.setValue(document.filters().back().id, 0, 100, 3);
    QVERIFY(waitUntilIdle(*window_));
    QTRY_COMPARE(panel().summary(), QString("No bottlenecks"));
    QCOMPARE(panel().model().rowCount(), 0);
    document.undoStack()->undo();
    QTRY_COMPARE(panel().model().rowCount(), 1);
  }

  void sessionsKeepIt() {
    open();
    panel().widthField()->setFocus();
    QTest::keyClick(panel().widthField(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(panel().widthField(), QStringLiteral("1.5"));
    panel().setMapShown(false);
    const QString session = folder_->filePath("rooms.footfall");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(session);
    QVERIFY(written.wait());
    window_ = std::make_unique<EditorWindow>();
    window_->setRemembering(false);
    QVERIFY(showWindow(*window_));
    QVERIFY(dock()->isHidden());
    window_->open(session);
    QVERIFY(waitUntilIdle(*window_));
    QTRY_COMPARE_WITH_TIMEOUT(panel().model().rowCount(), 1, kWaitMs);
    QVERIFY(!dock()->isHidden());
    QCOMPARE(panel().agentWidth(), 1.5);
    QVERIFY(!panel().isMapShown());
    QCOMPARE(text(0, BottleneckModel::Agent), QString("too narrow"));
    // Another level has a width of its own.
    QVERIFY(openZUp(*window_, writeFile(*folder_, "other.obj", floorObj()), kPipeline));
    QCOMPARE(panel().agentWidth(), 0.6);
  }

 private:
  [[nodiscard]] CorridorsFeature& feature() const { return partOf<CorridorsFeature>(*window_); }
  [[nodiscard]] CorridorsPanel& panel() const { return feature().panel(); }
  [[nodiscard]] QDockWidget* dock() const {
    return window_->findChild<QDockWidget*>(QStringLiteral("panel.corridors"));
  }
  [[nodiscard]] QModelIndex index(int row, int column) const { return panel().model().index(row, column); }
  [[nodiscard]] QString text(int row, int column) const { return index(row, column).data().toString(); }
  static double distance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }
  static bool isLike(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) < 60;
  }
  void open() {
    QAction* action = window_->findChild<QAction*>(QStringLiteral("panel.corridors"));
    QVERIFY(action != nullptr);
    action->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(panel().model().rowCount(), 1, kWaitMs);
  }
};

FOOTFALL_EDITOR_SUITE(TestCorridors)
#include "test_corridors.moc"
