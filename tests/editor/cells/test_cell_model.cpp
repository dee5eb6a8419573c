// Cells as data: colours, the timeline, figures, and the model that all views share.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "tests/editor/block_builder.hpp"
#include "tests/editor/editor_driver.hpp"
#include "ui/cells/balance_plot.hpp"
#include "ui/cells/cell_model.hpp"
#include "ui/cells/timeline.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

/// The distance of two colours for someone with the given deficiency, by Viénot, Brettel and Mollon (1999): the
/// remainder of red and green is one channel.
double distanceFor(bool protan, const QColor& a, const QColor& b) {
  const auto seen = [protan](const QColor& c) {
    const auto linear = [](double v) { return std::pow(v, 2.2); };
    const double red = linear(c.redF());
    const double green = linear(c.greenF());
    const double blue = linear(c.blueF());
    const double yellow = protan ? 0.112 * red + 0.888 * green : 0.293 * red + 0.707 * green;
    return std::array{std::pow(yellow, 1 / 2.2), std::pow(blue, 1 / 2.2)};
  };
  const auto x = seen(a);
  const auto y = seen(b);
  return std::hypot(x[0] - y[0], x[1] - y[1]);
}

}  // namespace

class TestCellModel : public QObject {
  Q_OBJECT

 private slots:
  void lanesBarsAndFilters() {
    const Timeline timeline = makeTimeline({fourCells()}, 0);
    QCOMPARE(timeline.lanes, 2);
    QCOMPARE(timeline.filters, (std::vector<std::string>{"DegeneracyFilter", "VerticalClearanceFilter"}));
    QCOMPARE(timeline.bars.size(), std::size_t{5});
    const Timeline::Bar& first = timeline.bars[0];
    QCOMPARE(first.lane, 0);
    QVERIFY((first.cell == CellId{0, 0}));
    QCOMPARE(first.start, 20.0);
    QCOMPARE(first.end, 40.0);
    QCOMPARE(first.segments.size(), std::size_t{2});
    QCOMPARE(timeline.start, 10.0);
    QCOMPARE(timeline.end, 65.0);
    QCOMPARE(timeline.bands.size(), std::size_t{3});
    QCOMPARE(timeline.bands[1].start, 20.0);
    QCOMPARE(timeline.bands[1].end, 60.0);
  }

  void whatIsUnderAPlaceOfTheTimeline() {
    const Timeline timeline = makeTimeline({fourCells()}, 0);
    QVERIFY((timeline.at(0, 30)->cell == CellId{0, 0}));
    QVERIFY((timeline.at(0, 55)->cell == CellId{0, 3}));  // it helps
    QVERIFY((timeline.at(1, 45)->cell == CellId{0, 3}));
    QVERIFY(!timeline.at(0, 50));  // The place is between its cell and its help.
    QVERIFY(!timeline.at(1, 55));  // idle at the end
    QVERIFY(!timeline.at(0, 5));   // The place is before anything.
    QVERIFY(!timeline.at(2, 30));  // no such thread
    QVERIFY(!timeline.at(-1, 30));
  }

  void aPauseEndsABar() {
    const CellBlock block = BlockBuilder(1)
                                .work(0, "SlopeFilter", 0, 0, 1)
                                .work(0, "SlopeFilter", 0, 1.01, 2)
                                .work(0, "SlopeFilter", 0, 9, 10)
                                .block();
    const Timeline timeline = makeTimeline({block}, 0);
    QCOMPARE(timeline.bars.size(), std::size_t{2});
    QCOMPARE(timeline.bars[0].end, 2.0);
    QVERIFY(!timeline.at(0, 5));
  }

  void onlyBlocksOfOneRunShareATimeline() {
    const CellBlock first = fourCells();
    const CellBlock together =
        BlockBuilder(1).phases(80, 1, 5, 1).work(0, "SlopeFilter", 0, 81, 86).ranWith(first).block();
    const CellBlock earlier = BlockBuilder(1).work(0, "SlopeFilter", 0, 0, 500).ran({}, 1).block();
    const CellBlocks blocks{first, together, earlier};
    QCOMPARE(makeTimeline(blocks, 0).end, 87.0);
    QCOMPARE(makeTimeline(blocks, 2).end, 500.0);
    QVERIFY((makeTimeline(blocks, 1).at(0, 83)->cell == CellId{1, 0}));
    QVERIFY(makeTimeline(blocks, 3).bars.empty());
  }

  void whatIsSharedHasNoCell() {
    const CellBlock block = BlockBuilder(1).work(0, "SlopeFilter", 0, 0, 1).shared("RoundingFilter", 0, 1, 3).block();
    const Timeline timeline = makeTimeline({block}, 0);
    QVERIFY(timeline.at(0, 2) && !timeline.at(0, 2)->cell);
  }

  void aPlanGivesTheLargestCellsOutFirst() {
    const Timeline plan = planTimeline(BlockBuilder(4).block(), 1, 2);  // costs 10 to 40
    QVERIFY(plan.planned);
    QCOMPARE(plan.lanes, 2);
    QVERIFY((plan.at(0, 5)->cell == CellId{1, 3}));
    QVERIFY((plan.at(1, 5)->cell == CellId{1, 2}));
    QVERIFY((plan.at(1, 35)->cell == CellId{1, 1}));
    QVERIFY((plan.at(0, 45)->cell == CellId{1, 0}));
    QCOMPARE(plan.end, 50.0);
  }

  void figuresOfTheLoad() {
    const LoadFigures figures = figuresOf(fourCells());
    QCOMPARE(figures.busyMs, (std::vector<double>{36, 30}));
    QCOMPARE(figures.workMs, 66.0);
    QCOMPARE(figures.imbalance, 36.0 / 33.0);
    QCOMPARE(figures.speedUp, 66.0 / 40.0);
    const auto phases = phasesOf(fourCells().run->times);
    double sum = 0;
    for (const PhaseTime& phase : phases) sum += phase.milliseconds;
    QCOMPARE(sum, 88.0);
    QCOMPARE(figuresOf(BlockBuilder(2).block()).imbalance, 1.0);
  }

  void coloursByMode() {
    const CellBlock block = fourCells();
    const CellScale byThread(block, CellColouring::Thread);
    QCOMPARE(byThread.threads(), 2);
    QCOMPARE(*byThread.colourOf(0), threadColour(0));
    QCOMPARE(*byThread.colourOf(3), threadColour(1));
    const CellScale byTime(block, CellColouring::Time);
    QCOMPARE(byTime.maximum(), 28.0);
    QCOMPARE(*byTime.colourOf(3), scaleColour(1));
    QCOMPARE(*byTime.colourOf(1), scaleColour(8.0 / 28.0));
    const CellScale byTriangles(block, CellColouring::Triangles);
    QCOMPARE(byTriangles.maximum(), 400.0);
    QCOMPARE(*byTriangles.colourOf(1), scaleColour(0.5));
    QVERIFY(byTriangles.allKnown());
  }

  void cellsTakeTheirColourWhenTheyFinish() {
    const CellScale running(BlockBuilder(3).work(1, "SlopeFilter", 2, 0, 1).block(), CellColouring::Thread);
    QVERIFY(!running.colourOf(0) && !running.colourOf(2));
    QCOMPARE(*running.colourOf(1), threadColour(2));
    QVERIFY(!running.allKnown());
    // Only the estimate exists before any of them has run.
    const CellScale made(BlockBuilder(3).block(), CellColouring::Time);
    QVERIFY(made.shown() == CellColouring::Cost);
    QCOMPARE(*made.colourOf(2), scaleColour(1));
  }

  void coloursCanBeToldApart() {
    for (int i = 0; i < 7; ++i) {
      for (int k = 0; k < i; ++k) {
        QVERIFY(distanceFor(true, threadColour(i), threadColour(k)) > 0.06);
        QVERIFY(distanceFor(false, threadColour(i), threadColour(k)) > 0.06);
      }
    }
    for (int i = 0; i < 21; ++i) {
      for (int k = 0; k < i; ++k) QVERIFY(threadColour(i) != threadColour(k));
    }
    for (int i = 1; i <= 20; ++i)
      QVERIFY(scaleColour(i / 20.0).lightness() < scaleColour((i - 1) / 20.0).lightness() + 12);
    QVERIFY(scaleColour(0).lightness() > scaleColour(1).lightness() + 60);
    QCOMPARE(scaleColour(-1), scaleColour(0));
    QCOMPARE(scaleColour(2), scaleColour(1));
  }

  void hoverAndSelectionAreShared() {
    CellModel model;
    model.setBlocks({fourCells()});
    QSignalSpy hovered(&model, &CellModel::hoveredChanged);
    QSignalSpy selected(&model, &CellModel::selectedChanged);
    QSignalSpy framed(&model, &CellModel::frameRequested);
    model.setHovered(CellId{0, 2});
    model.setHovered(CellId{0, 2});
    QCOMPARE(hovered.count(), 1);
    model.setHovered(CellId{0, 9});  // no such cell
    QVERIFY(!model.hovered());
    model.select(CellId{0, 1}, true);
    QCOMPARE(selected.count(), 1);
    QCOMPARE(framed.count(), 1);
    // Figures keep what is pointed at, other cells do not.
    model.setBlocks({fourCells()});
    QVERIFY((model.selected() == CellId{0, 1}));
    model.setBlocks({BlockBuilder(3).block()});
    QVERIFY(!model.selected());
  }

  void shapesChangeOnlyWithTheCells() {
    CellModel model;
    QSignalSpy shapes(&model, &CellModel::shapesChanged);
    model.setBlocks({BlockBuilder(4).block()});
    QCOMPARE(shapes.count(), 1);
    const CellModel::Shapes before = model.shapes();
    model.setBlocks({fourCells()});
    QCOMPARE(shapes.count(), 1);
    QCOMPARE(model.shapes(), before);
    model.setBlocks({});
    QCOMPARE(shapes.count(), 2);
    QVERIFY(!model.shapes() && model.empty());
  }

  void aPreviewLiesInFrontOfTheRun() {
    CellModel model;
    model.setBlocks({fourCells(), BlockBuilder(2).block()});
    model.setShownIndex(1);
    Partition partition;
    partition.strategy = "RecursiveStrategy 50 3 false";
    partition.cells.resize(2);
    partition.cells[0].cost = 5;
    partition.cells[1].cost = 20;
    partition.cells[0].bounds.upper[1] = partition.cells[1].bounds.lower[1] = 3;
    model.showPreview(partition);
    QVERIFY(model.previewing());
    QCOMPARE(model.shownIndex(), std::size_t{0});
    QCOMPARE(model.shownBlock()->report.cells.size(), std::size_t{2});
    QVERIFY(model.scaleOf(0).shown() == CellColouring::Cost);
    QVERIFY(model.describe({0, 1}).contains("preview"));
    QVERIFY(model.describe({0, 1}).contains("from 3"));
    model.endPreview();
    QCOMPARE(model.shownIndex(), std::size_t{1});
    model.showPreview(partition);
    model.setBlocks({fourCells()});  // a run has made its own
    QVERIFY(!model.previewing());
  }

  void aCellIsDescribedInFull() {
    CellModel model;
    model.setBlocks({fourCells()});
    const QString text = model.describe({0, 3});
    for (const char* part : {"Cell 4 of 4", "from 3", "everything", "400 in, 7 out", "28.0 ms", "1, helped by 0",
                             "40 units of work", "Vertical clearance"})
      QVERIFY2(text.contains(part), part);
    QVERIFY(model.describe({0, 0}).contains("below 1"));
    QVERIFY(model.describe({3, 0}).isEmpty());
    model.setBlocks({BlockBuilder(4).block()});
    QVERIFY(model.describe({0, 3}).contains("not finished"));
  }

  // An edit leaves most cells as they were; a block may come from the cache as a whole.
  void cellsSayWhatCameFromTheCache() {
    CellBlock block = fourCells();
    CellModel model;
    model.setBlocks({block});
    model.setReuse({{{10, 10}, {20, 5}, {8, 0}, {0, 0}}});
    QVERIFY(model.describe({0, 0}).contains("10 of 10 floors"));
    QVERIFY(model.describe({0, 1}).contains("5 of 20 floors"));
    for (const std::size_t cell : {2, 3}) QVERIFY(!model.describe({0, cell}).contains("from the cache"));
    for (const std::size_t cell : {0, 1, 2, 3}) QCOMPARE(model.isCached({0, cell}), cell == 0);
    QCOMPARE(model.cachedCells(), 1);
    model.setReuse({{{10, 10}}});  // of other cells
    QCOMPARE(model.cachedCells(), 0);
    block.origin = CellBlock::Origin::Measured;
    model.setBlocks({block});
    model.setReuse({{{1, 1}, {1, 1}, {1, 1}, {1, 1}}});  // a measurement takes nothing from caches
    QCOMPARE(model.cachedCells(), 0);
    block.origin = CellBlock::Origin::Cache;
    model.setBlocks({block});
    QCOMPARE(model.cachedCells(), 4);
    QVERIFY(model.describe({0, 3}).contains("with the figures of that run"));
  }
};

FOOTFALL_EDITOR_SUITE(TestCellModel)
#include "test_cell_model.moc"
