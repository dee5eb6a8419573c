// Cells over the environment: geometry, picking, colours on the screen, previews, and real runs in the window.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <cmath>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/block_builder.hpp"
#include "tests/editor/editor_driver.hpp"
#include "ui/cells/cell_legend.hpp"
#include "ui/cells/cells_feature.hpp"
#include "ui/cells/load_panel.hpp"
#include "ui/view/widgets/height_slider.hpp"

using namespace footfall;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kGrid = "GridStrategy 2 2\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\nAreaFilter 0\n";

/// The floor of floorObj(): 8 x 8 at the height 0.
Environment floorEnvironment() {
  Environment environment;
  environment.vertices = {{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}};
  environment.triangles = {{0, 1, 2}, {0, 2, 3}};
  return environment;
}

std::vector<CellBounds> quarters() {
  std::vector<CellBounds> cells(4);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t axis = 0; axis < 2; ++axis) (i >> axis & 1U ? cells[i].lower[axis] : cells[i].upper[axis]) = 1;
  }
  return cells;
}

double areaOf(const CellGeometry& geometry, std::size_t cell) {
  double area = 0;
  for (std::size_t v = geometry.firstVertex[cell]; v < geometry.firstVertex[cell + 1]; v += 3) {
    const auto& a = geometry.surface[v].position;
    const auto& b = geometry.surface[v + 1].position;
    const auto& c = geometry.surface[v + 2].position;
    area += 0.5 * static_cast<double>((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
  }
  return area;
}

Ray down(double x, double y) { return {{x, y, 50}, {0, 0, -1}}; }

bool near(const QColor& a, const QColor& b) {
  return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) < 60;
}

double shareOf(const QImage& image, const QColor& colour) {
  qint64 count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) count += near(image.pixelColor(x, y), colour) ? 1 : 0;
  }
  return static_cast<double>(count) / (static_cast<double>(image.width()) * image.height());
}

}  // namespace

class TestCellsInView : public EditorSuite {
  Q_OBJECT

 private slots:
  void init() { QVERIFY(openWindow({1100, 800})); }
  void cleanup() { closeWindow(); }

  void floorsAreCutAtTheBorders() {
    const auto geometry = makeCellGeometry(floorEnvironment(), {}, quarters(), [] {});
    QCOMPARE(areaOf(*geometry, 0), 25.0);  // 5 x 5
    QCOMPARE(areaOf(*geometry, 1), 15.0);
    QCOMPARE(areaOf(*geometry, 2), 15.0);
    QCOMPARE(areaOf(*geometry, 3), 9.0);
    for (std::size_t cell = 0; cell < 4; ++cell) {
      for (std::size_t v = geometry->firstVertex[cell]; v < geometry->firstVertex[cell + 1]; ++v)
        QCOMPARE(geometry->surface[v].cell, static_cast<std::uint32_t>(cell));
    }
    // Open sides end where the environment does.
    QCOMPARE(geometry->boxes[0].lower[0], -4.0F);
    QCOMPARE(geometry->boxes[3].upper[1], 4.0F);
    double border = 0;
    for (const LineSegment& segment : geometry->borders) {
      if (segment.from[0] == 1 && segment.to[0] == 1) border += std::abs(double{segment.to[1]} - segment.from[1]);
    }
    QCOMPARE(border, 8.0 + 16.0);  // across the floor, and the sides of the four rectangles
  }

  void floorsBelongToTheHeightOfTheirLowestCorner() {
    Environment environment = floorEnvironment();
    environment.vertices[2].z = 9;  // both triangles reach from 0 to 9
    std::vector<CellBounds> cells(2);
    cells[0].upper[2] = cells[1].lower[2] = 3;
    const auto geometry = makeCellGeometry(environment, {}, cells, [] {});
    QCOMPARE(areaOf(*geometry, 0), 64.0);
    QCOMPARE(areaOf(*geometry, 1), 0.0);
    QCOMPARE(geometry->boxes[1].lower[2], 3.0F);
    QCOMPARE(geometry->boxes[1].upper[2], 9.0F);
  }

  void betweenHeightsTheBorderRunsAlongEdges() {
    Environment environment = floorEnvironment();
    environment.vertices.push_back({9, 0, 5});
    environment.triangles = {{0, 1, 2}, {1, 4, 2}};
    environment.vertices[1].z = environment.vertices[2].z = 4;  // the second one lies from 4 to 5
    std::vector<CellBounds> cells(2);
    cells[0].upper[2] = cells[1].lower[2] = 3;
    const auto geometry = makeCellGeometry(environment, {}, cells, [] {});
    const auto along = [](const LineSegment& segment) {
      return segment.from[0] == 4 && segment.to[0] == 4 && segment.from[2] == 4 && segment.to[2] == 4;
    };
    QCOMPARE(std::ranges::count_if(geometry->borders, along), std::ptrdiff_t{1});
    cells[0].upper[2] = cells[1].lower[2] = 4.5;  // both in the lower cell
    const auto together = makeCellGeometry(environment, {}, cells, [] {});
    QCOMPARE(std::ranges::count_if(together->borders, along), std::ptrdiff_t{0});
  }

  void whatFacesDownHasNoCell() {
    Environment environment = floorEnvironment();
    for (Triangle& triangle : environment.triangles) std::swap(triangle[1], triangle[2]);
    QVERIFY(makeCellGeometry(environment, {}, quarters(), [] {})->surface.empty());
    environment.bothSides = true;
    QVERIFY(!makeCellGeometry(environment, {}, quarters(), [] {})->surface.empty());
    environment = {};
    QCOMPARE(makeCellGeometry(environment, {}, quarters(), [] {})->boxes.size(), std::size_t{4});
  }

  void drapingCanBeCancelled() {
    const auto cancelled = [] { throw Cancelled(); };
    bool stopped = false;
    try {
      makeCellGeometry(floorEnvironment(), {}, quarters(), cancelled);
    } catch (const Cancelled&) {
      stopped = true;
    }
    QVERIFY(stopped);
  }

  void theCellUnderTheMouse() {
    Environment environment = floorEnvironment();
    // A table over the corner, which hides the floor.
    for (const auto& [x, y] : {std::pair{2.0, 2.0}, std::pair{3.0, 2.0}, std::pair{3.0, 3.0}})
      environment.vertices.push_back({x, y, 5});
    environment.triangles.push_back({4, 5, 6});
    const auto shown = makeEnvironmentGeometry(environment);
    std::vector<CellBounds> cells = quarters();
    CellBounds above = cells[3];
    cells[3].upper[2] = above.lower[2] = 4;
    cells.push_back(above);
    const auto geometry = makeCellGeometry(environment, shown->centre, cells, [] {});
    const double z = shown->centre.z;
    const auto at = [&](double x, double y, double cut) {
      ShownSpace left;
      left.heights.upper = cut - z;
      return pickCell(down(x - shown->centre.x, y - shown->centre.y), *shown, *geometry, left).value_or(99);
    };
    QCOMPARE(at(0, 0, 100), std::size_t{0});
    QCOMPARE(at(2, 0, 100), std::size_t{1});
    QCOMPARE(at(0, 2, 100), std::size_t{2});
    QCOMPARE(at(2.8, 2.4, 100), std::size_t{4});  // the table
    QCOMPARE(at(2.8, 2.4, 3), std::size_t{3});    // the floor, with the table cut away
    QCOMPARE(at(9, 9, 100), std::size_t{99});
  }

  void aRunShowsItsCells() {
    QVERIFY(openGrid());
    QCOMPARE(model().blocks().size(), std::size_t{1});
    const CellBlock& block = model().blocks()[0];
    QCOMPARE(block.report.cells.size(), std::size_t{4});
    QVERIFY(block.complete());
    QVERIFY(std::ranges::all_of(block.finished, [](char done) { return done != 0; }));
    // The view has no cells before they are requested.
    QVERIFY(!window_->view().parts().cells);
    QTest::keyClick(window_.get(), Qt::Key_C);
    QVERIFY(window_->view().parts().cells);
    QTRY_VERIFY(window_->cellWatch().upToDate());
    QVERIFY(partOf<CellLegend>(*window_).isVisible());
    model().setColouring(CellColouring::Triangles);
    window_->view().cameraController().viewFromTop();
    const CellScale scale = model().scaleOf(0);
    const QImage picture = window_->view().grabFramebuffer();
    for (std::size_t cell = 0; cell < 4; ++cell) QVERIFY(shareOf(picture, *scale.colourOf(cell)) > 0.01);
    QVERIFY(partOf<CellLegend>(*window_).text().contains("triangles"));
    QTest::keyClick(window_.get(), Qt::Key_C);
    QVERIFY(shareOf(window_->view().grabFramebuffer(), walkablePaint().colour) > 0.1);
  }

  void pointingInOneViewShowsInTheOthers() {
    QVERIFY(openGrid());
    window_->setCellsShown({true, true, CellColouring::Thread});
    QTRY_VERIFY(window_->cellWatch().upToDate());
    LevelView& view = window_->view();
    view.cameraController().viewFromTop();
    QTest::qWait(50);
    const QPoint right(view.width() / 2 + 40, view.height() / 2 - 40);
    const auto cell = view.cellAt(right);
    QVERIFY(cell.has_value());
    const QImage before = view.grabFramebuffer();
    const QImage bars = partOf<LoadPanel>(*window_).timeline().toPixmap().toImage();
    QTest::mouseMove(&view, right);
    QTRY_VERIFY((model().hovered() == CellId{0, *cell}));
    QVERIFY(view.grabFramebuffer() != before);
    QVERIFY(partOf<LoadPanel>(*window_).timeline().toPixmap().toImage() != bars);
    model().setHovered({});
    QCOMPARE(view.grabFramebuffer(), before);
    // The other way round.
    TimelinePlot& plot = partOf<LoadPanel>(*window_).timeline();
    plot.replot();
    const Timeline::Bar& bar = plot.timeline().bars.front();
    QTest::mouseMove(&plot, plot.placeOf(bar).toPoint());
    QTRY_COMPARE(model().hovered(), bar.cell);
    QVERIFY(view.grabFramebuffer() != before);
  }

  void aClickSelectsAndFramesADragTurns() {
    QVERIFY(openGrid());
    window_->setCellsShown({true, false, CellColouring::Thread});
    QTRY_VERIFY(window_->cellWatch().upToDate());
    LevelView& view = window_->view();
    view.cameraController().viewFromTop();
    const CameraPose start = view.cameraController().pose();
    const QPoint place(view.width() / 2 + 60, view.height() / 2 - 60);
    const auto cell = view.cellAt(place);
    QVERIFY(cell.has_value());
    QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, place);
    QVERIFY((model().selected() == CellId{0, *cell}));
    QVERIFY(!(view.cameraController().pose().position == start.position));
    QCOMPARE(view.cameraController().pose().orientation, start.orientation);
    // The cell fills the view: its middle is in the middle.
    QVERIFY(view.cellAt(view.rect().center()) == cell);

    const CameraPose framed = view.cameraController().pose();
    QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, place);
    QMouseEvent move(QEvent::MouseMove, place + QPoint(60, 10), view.mapToGlobal(place + QPoint(60, 10)), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&view, &move);
    QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, place + QPoint(60, 10));
    QVERIFY(view.cameraController().pose().orientation != framed.orientation);
    QVERIFY((model().selected() == CellId{0, *cell}));
  }

  void aBlockFromTheCacheKeepsItsFigures() {
    QVERIFY(openGrid());
    const auto run = model().blocks()[0].run;
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters().back().id, 0, 1,
                                        1);  // The filter is behind Collapse.
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->controller().finishedRun()->result.blocks.empty());
    QCOMPARE(model().blocks().size(), std::size_t{1});
    QCOMPARE(model().blocks()[0].run, run);
    // The block goes, the cells go, and both come back.
    const auto id = [this](std::size_t row) { return partOf<Document>(*window_).filters()[row].id; };
    partOf<Document>(*window_).setEnabled(id(0), false);
    partOf<Document>(*window_).setEnabled(id(3), false);
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(model().empty());
    partOf<Document>(*window_).undoStack()->undo();
    partOf<Document>(*window_).undoStack()->undo();
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(model().blocks().size(), std::size_t{1});
  }

  void runningInParallelIsOneEdit() {
    QVERIFY(
        openZUp(*window_, writeFile(*folder_, "floor.obj", floorObj()),
                "DuplicationFilter 0\nDegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 0\n"));
    window_->setCellsShown({false, true, CellColouring::Thread});
    QVERIFY(partOf<LoadPanel>(*window_).showsEmptyState());
    const QStringList before = filterNames(*window_);
    const int clearance = partOf<Document>(*window_).filters()[3].id;
    QTest::mouseClick(partOf<LoadPanel>(*window_).parallelButton(), Qt::LeftButton);
    QCOMPARE(filterNames(*window_), (QStringList{"DuplicationFilter", "AutoStrategy", "DegeneracyFilter", "SlopeFilter",
                                                 "VerticalClearanceFilter", "Collapse", "AreaFilter"}));
    QCOMPARE(partOf<Document>(*window_).filters()[4].id, clearance);  // rows keep their identity
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(!partOf<LoadPanel>(*window_).showsEmptyState());
    QVERIFY(partOf<FilterList>(*window_).rows()[1]->figuresText().contains("1 cell"));
    partOf<Document>(*window_).undoStack()->undo();
    QCOMPARE(filterNames(*window_), before);
    QVERIFY(!partOf<Document>(*window_).undoStack()->canUndo());
  }

  void parallelBlocksGoRoundLocalFiltersOnly() {
    Document document;
    document.reset(parsePipeline("AreaFilter 0\n", "test"), {});
    QVERIFY(!document.addParallelBlock());
    QVERIFY(!document.undoStack()->canUndo());
    document.reset(parsePipeline("DegeneracyFilter\nSlopeFilter 45\nAreaFilter 0\nVerticalClearanceFilter 2\n", "test"),
                   {});
    QVERIFY(document.addParallelBlock());
    QCOMPARE(document.filters()[3].step.filter->name, std::string_view("AutoStrategy"));
    QCOMPARE(document.filters()[5].step.filter->name, std::string_view("Collapse"));
    document.reset(parsePipeline("GridStrategy 2 2\nSlopeFilter 45\nCollapse\nDegeneracyFilter\n", "test"), {});
    QVERIFY(document.addParallelBlock());
    QCOMPARE(document.filters()[3].step.filter->name, std::string_view("AutoStrategy"));
  }

  void aPreviewNeedsNoRun() {
    QVERIFY(openGrid());
    partOf<Document>(*window_).setEnabled(partOf<Document>(*window_).filters()[0].id, false);
    partOf<Document>(*window_).setEnabled(partOf<Document>(*window_).filters()[3].id, false);
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(model().empty());
    const auto run = window_->controller().finishedRun();
    QTest::mouseClick(partOf<FilterList>(*window_).rows()[0]->previewButton(), Qt::LeftButton);
    QTRY_VERIFY(model().previewing());
    QCOMPARE(model().shownBlock()->report.cells.size(), std::size_t{4});
    QVERIFY(window_->view().parts().cells);  // Cells were requested.
    QCOMPARE(window_->controller().finishedRun(), run);
    QVERIFY(!partOf<FilterList>(*window_).rows()[1]->previewButton());
  }

  void aStrategyWithoutItsEndIsPreviewedByItself() {
    QVERIFY(openZUp(*window_, writeFile(*folder_, "waves.obj", wavesObj(20)), "SlopeFilter 45\n"));
    window_->setCellsShown({true, true, CellColouring::Thread});
    partOf<Document>(*window_).addFilter(filterDescriptor(FilterType::GridStrategy),
                                         1);  // refused, until there is a Collapse
    QTRY_VERIFY(model().previewing());
    const std::size_t cells = model().shownBlock()->report.cells.size();
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[1].id, 0, 7, 1);
    QTRY_VERIFY(model().shownBlock()->report.cells.size() != cells);
    QVERIFY(model().previewing());
    partOf<Document>(*window_).undoStack()->undo();
    partOf<Document>(*window_).undoStack()->undo();
    QTRY_VERIFY(!model().previewing());
  }

  void previewsDoNotBlockAndTheLastOneWins() {
    std::atomic<int> begun = 0;
    std::atomic<int> cancelled = 0;
    CellPreview preview(
        nullptr, [&](const std::shared_ptr<const Environment>&, const Pipeline& block, RunContext& context, int) {
          ++begun;
          Partition partition;
          partition.cells.resize(static_cast<std::size_t>(block.steps[0].values[0]));
          while (block.steps[0].values[0] < 3) {  // Runs until it is cancelled.
            QThread::msleep(1);
            if (context.cancelled()) ++cancelled;
            context.checkCancelled();
          }
          return partition;
        });
    std::vector<std::size_t> told;
    connect(&preview, &CellPreview::ready, this,
            [&](const Partition& partition) { told.push_back(partition.cells.size()); });
    const auto environment = std::make_shared<const Environment>(floorEnvironment());
    const auto request = [&](int columns) {
      preview.request(environment,
                      parsePipeline("AreaFilter 0\nGridStrategy " + std::to_string(columns) + " 1\nCollapse\n", "test"),
                      1, 0);
    };
    QElapsedTimer clock;
    clock.start();
    request(1);
    QTRY_COMPARE(begun.load(), 1);
    request(2);
    request(3);
    QVERIFY(preview.busy());
    QTRY_COMPARE(told.size(), std::size_t{1});
    QCOMPARE(told[0], std::size_t{3});
    QVERIFY(cancelled.load() >= 1);
    QVERIFY(!preview.busy());
    request(2);
    preview.cancel();
    QTest::qWait(20);
    QCOMPARE(told.size(), std::size_t{1});
  }

  void theWindowAnswersWhileAPreviewIsMade() {
    QVERIFY(openZUp(*window_, writeFile(*folder_, "waves.obj", wavesObj(174)), "SlopeFilter 45\n"));
    window_->setCellsShown({true, true, CellColouring::Thread});
    partOf<Document>(*window_).addFilter(filterDescriptor(FilterType::GridStrategy), 1);
    qint64 longest = 0;
    QElapsedTimer clock;
    clock.start();
    QTimer tick;
    tick.setInterval(5);
    connect(&tick, &QTimer::timeout, this, [&] { longest = std::max(longest, clock.restart()); });
    tick.start();
    QTRY_VERIFY_WITH_TIMEOUT(model().previewing() && window_->cellWatch().upToDate(), 20000);
    qInfo("60,552 triangles: the window answered after at most %lld ms", longest);
    QVERIFY(longest < 1500);  // far above what it takes: a busy machine is no failure
  }

  void cellsComeWhileTheRunGoesOn() {
    std::vector<std::pair<std::size_t, bool>> told;  // finished cells, complete
    connect(&window_->controller(), &RunController::cellsChanged, this, [&](const CellBlocks& blocks) {
      if (blocks.empty()) return;
      const auto finished = std::ranges::count(blocks[0].finished, 1);
      told.emplace_back(static_cast<std::size_t>(finished), blocks[0].complete());
    });
    bool ranTogether = true;
    connect(&window_->controller(), &RunController::statusChanged, this, [&] {
      if (!window_->controller().busy()) return;
      const auto state = [&](std::size_t row) {
        return window_->controller().status(partOf<Document>(*window_).filters()[row].id).state;
      };
      // The strategy is done before its filters begin, and Collapse waits for them.
      if (state(2) == StepState::Running) ranTogether = ranTogether && state(0) == StepState::Done;
      if (state(3) == StepState::Running) ranTogether = ranTogether && state(2) != StepState::Running;
    });
    QVERIFY(openZUp(*window_, writeFile(*folder_, "waves.obj", wavesObj(174)),
                    "GridStrategy 8 8\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n"));
    QVERIFY(!told.empty());
    QVERIFY(told.back() == std::pair(std::size_t{64}, true));
    for (std::size_t i = 1; i < told.size(); ++i) QVERIFY(told[i].first >= told[i - 1].first);
    QVERIFY(ranTogether);
    const StepStatus filter = window_->controller().status(partOf<Document>(*window_).filters()[2].id);
    QVERIFY(filter.state == StepState::Done);
    QVERIFY(window_->controller().status(partOf<Document>(*window_).filters()[3].id).state == StepState::Done);
  }

  void eventsOfCellsAreKeptForTheWindow() {
    RunEventBuffer buffer([] {});
    auto made = std::make_shared<BlockReport>();
    made->cells.resize(2);
    buffer.add({.kind = RunEvent::Kind::StepStarted, .step = 0, .text = "GridStrategy"});
    buffer.add({.kind = RunEvent::Kind::CellsMade, .step = 0, .block = made});
    QCOMPARE(buffer.blocks().size(), std::size_t{1});
    const auto report = std::make_shared<CellReport>();
    buffer.add({.kind = RunEvent::Kind::CellFinished,
                .step = 0,
                .part = std::make_shared<NavigationMesh>(),
                .cell = 1,
                .cellReport = report});
    buffer.add({.kind = RunEvent::Kind::CellFinished, .step = 0, .cell = 7, .cellReport = report});  // no such cell
    QVERIFY(!buffer.blocks()[0].cells[0]);
    QCOMPARE(buffer.blocks()[0].cells[1], std::shared_ptr<const CellReport>(report));
    QCOMPARE(buffer.fetch()[0].parts.size(), std::size_t{1});
    QVERIFY(buffer.fetch()[0].parts[0].cell.has_value());
  }

  void whatIsShownIsPartOfTheSession() {
    QVERIFY(openGrid());
    window_->setCellsShown({true, true, CellColouring::Time});
    const QString path = folder_->filePath("cells.footfall");
    window_->saveSession(path);
    QVERIFY(waitUntilIdle(*window_));
    EditorWindow second;
    second.setRemembering(false);
    QVERIFY(showWindow(second));
    second.open(path);
    QVERIFY(QTest::qWaitFor([&] { return second.controller().finishedRun() != nullptr; }, 20000));
    const CellsShown shown = partOf<CellsFeature>(second).shown();
    QVERIFY(shown.inView && shown.load && shown.colouring == CellColouring::Time);
    QVERIFY(second.view().parts().cells && partOf<LoadPanel>(second).isVisible());

    const QByteArray wrong = readFile(path).replace("\"time\"", "\"mood\"");
    bool refused = false;
    try {
      readSession(writeFile(*folder_, "wrong.footfall", wrong).toStdString());
    } catch (const InputError& error) {
      refused = std::string(error.what()).find("thread, time, triangles or cost") != std::string::npos;
    }
    QVERIFY(refused);
  }

  void anotherEnvironmentHasNoOldCells() {
    QVERIFY(openGrid());
    window_->setCellsShown({true, true, CellColouring::Thread});
    window_->openWith(writeFile(*folder_, "floor.obj", floorObj()), parsePipeline("SlopeFilter 45\n", "test"), {});
    QVERIFY(QTest::qWaitFor([&] { return window_->controller().upToDate(); }, 20000));
    QTRY_VERIFY(model().empty());
    const LoadPanel& load = partOf<LoadPanel>(*window_);
    QVERIFY(load.showsEmptyState() && load.parallelButton()->isVisible());
  }

  void overlaysDoNotMeet_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("small") << QSize(1280, 800);
    QTest::newRow("large") << QSize(1920, 1000);
  }
  void overlaysDoNotMeet() {
    QFETCH(QSize, size);
    window_->resize(size);
    QVERIFY(openGrid());
    window_->setCellsShown({true, true, CellColouring::Time});
    QTRY_VERIFY(window_->cellWatch().upToDate());
    const QRect cells = partOf<CellLegend>(*window_).geometry();
    QVERIFY(window_->view().rect().contains(cells));
    QVERIFY(!cells.intersects(partOf<HeightSlider>(*window_).geometry()));
    const auto& legend = partOf<Legend>(*window_);
    QVERIFY(!legend.isVisible() || !cells.intersects(legend.geometry()));
  }

 private:
  [[nodiscard]] CellModel& model() const { return partOf<CellsFeature>(*window_).model(); }
  bool openGrid() { return openZUp(*window_, writeFile(*folder_, "waves.obj", wavesObj(20)), kGrid); }
};

FOOTFALL_EDITOR_SUITE(TestCellsInView)
#include "test_cells_in_view.moc"
