// The use of the threads' time in a run: the whole timeline, waiting times, histograms, colours, measuring.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/block_builder.hpp"
#include "tests/editor/editor_driver.hpp"
#include "ui/cells/cells_feature.hpp"
#include "ui/cells/timeline_lanes.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

// The four cells, on two threads, in a run of 100 ms: first state 0 to 5, a step from 62 to 90 on one thread and a
// half, the navigation mesh from 90 on; other programs take 8 ms while cells run.
CellBlock wholeRun() {
  CellBlock block = fourCells();
  RunFigures figures = *block.run;
  figures.times.total = 100;
  figures.parts = {{RunPart::Kind::Start, {}, 0, 5},
                   {RunPart::Kind::Step, "SimplificationFilter", 66, 90, 36},
                   {RunPart::Kind::Finish, {}, 90, 100}};
  block.run = std::make_shared<const RunFigures>(figures);
  return block;
}

const Timeline::Serial* partAt(const Timeline& timeline, double time) {
  for (const Timeline::Serial& part : timeline.serial)
    if (time >= part.start && time < part.end) return &part;
  return nullptr;
}

}  // namespace

class TestTimeUse : public QObject {
  Q_OBJECT

 private slots:
  void theWholeRunIsOnTheTimeline() {
    const Timeline timeline = makeTimeline({wholeRun()}, 0);
    QCOMPARE(timeline.start, 0.0);
    QCOMPARE(timeline.end, 100.0);
    // Every moment belongs to the cells, or to a part with a name.
    for (double time = 0.5; time < 100; time += 1) {
      const bool inCells = time > 20 && time < 60;
      QVERIFY2((partAt(timeline, time) != nullptr) != inCells, qPrintable(QString::number(time)));
    }
    QCOMPARE(labelOf(*partAt(timeline, 2)), QString("first state"));
    QCOMPARE(labelOf(*partAt(timeline, 8)), QString("between the steps"));
    QCOMPARE(labelOf(*partAt(timeline, 15)), QString("partitioning"));
    QCOMPARE(labelOf(*partAt(timeline, 62)), QString("merging"));
    QCOMPARE(labelOf(*partAt(timeline, 80)), QString("Simplification"));
    QCOMPARE(labelOf(*partAt(timeline, 95)), QString("navigation mesh"));
    QCOMPARE(partAt(timeline, 80)->threads, 1.5);
    QCOMPARE(partAt(timeline, 95)->threads, 1.0);
  }

  void waitingIsToldApart() {
    CellBlock block = wholeRun();
    const TimeUse use = timeUse(makeTimeline({block}, 0));
    QCOMPARE(use.total(), 200.0);  // two threads for 100 ms
    QCOMPARE(use.cells, 66.0);
    QCOMPARE(use.waitingForWork, 14.0);
    QCOMPARE(use.steps, 60.0 + 12.0);  // one thread of all but the cells, and half a one more of the step
    QCOMPARE(use.waitingForStep, 48.0);
    QCOMPARE(use.otherPrograms, 0.0);
    // The counters of the system: other programs have a processor for 8 ms while cells run.
    RunFigures figures = *block.run;
    figures.processors.samples = {{0, 0, 0}, {20, 20, 0}, {60, 78, 8}, {100, 118, 8}};
    block.run = std::make_shared<const RunFigures>(figures);
    const TimeUse shared = timeUse(makeTimeline({block}, 0));
    QCOMPARE(shared.total(), 200.0);
    QCOMPARE(shared.otherPrograms, 8.0);
    QCOMPARE(shared.cells, 58.0);
    QCOMPARE(shared.waitingForWork, 14.0);
  }

  void samplesAreInterpolated() {
    const ProcessorUse use{{{0, 0, 0}, {10, 20, 4}, {20, 20, 4}}};
    QCOMPARE(use.cpuMs(0, 5), 10.0);
    QCOMPARE(use.cpuMs(5, 15), 10.0);
    QCOMPARE(use.waitedMs(-5, 50), 4.0);
    QVERIFY(!ProcessorUse{}.known());
    ProcessorWatch watch;
    watch.sample();
    watch.sample();
    const ProcessorUse own = watch.use();
    for (std::size_t i = 1; i < own.samples.size(); ++i) {
      QVERIFY(own.samples[i].atMs >= own.samples[i - 1].atMs);
      QVERIFY(own.samples[i].waitedMs >= own.samples[i - 1].waitedMs);
    }
  }

  void histogramsCountEveryValue() {
    QVERIFY(histogramOf({}, 5).counts.empty());
    QCOMPARE(histogramOf({3, 3}, 5).counts, (std::vector<int>{2}));
    const Histogram histogram = histogramOf({1, 1.5, 10, 99, 100, 1000, 0}, 3);
    QCOMPARE(histogram.counts.size(), std::size_t{3});
    QCOMPARE(histogram.counts, (std::vector<int>{3, 2, 2}));
    QCOMPARE(histogram.bounds.front(), 1.0);
    QCOMPARE(histogram.bounds.back(), 1000.0);
  }

  void oneSlowCellDoesNotWashOutTheOthers() {
    BlockBuilder builder(5);
    const std::array times{4.0, 8.0, 6.0, 2.0, 900.0};
    for (std::size_t i = 0; i < times.size(); ++i)
      builder.work(i, "SlopeFilter", 0, 1000.0 * static_cast<double>(i), 1000.0 * static_cast<double>(i) + times[i]);
    const CellBlock block = builder.phases(0, 0, 5000, 0).ran({}, 1).block();
    const CellScale scale(block, CellColouring::Time);
    QCOMPARE(scale.maximum(), 900.0);
    QVERIFY(scale.darkest() < 30);
    QCOMPARE(*scale.colourOf(4), scaleColour(1));
    QVERIFY(std::abs(scale.colourOf(1)->lightnessF() - scale.colourOf(3)->lightnessF()) > 0.05F);
    // Even values use the whole scale.
    QCOMPARE(darkestValue({1, 2, 3, 4}), 4.0);
    QCOMPARE(darkestValue({}), 0.0);
  }

  void measuringTakesNothingFromCaches() {
    QTemporaryDir folder;
    EditorWindow window;
    window.resize(1300, 900);
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "waves.obj", wavesObj(40)),
                    "GridStrategy 2 2\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\nAreaFilter 0\n"));
    window.findChild<QAction*>("view.load")->trigger();
    auto* feature = window.findChild<CellsFeature*>();
    QVERIFY(feature);
    LoadPanel& panel = feature->panel();
    // A run with a cached block says so.
    QTest::keyClick(&window, Qt::Key_F5);
    QVERIFY(waitUntilIdle(window));
    QTRY_VERIFY2(panel.strategyText().contains("from the cache"), qPrintable(panel.strategyText()));
    panel.pages().setCurrentIndex(3);
    MeasurePage& page = panel.measurePage();
    page.countBox()->setValue(3);
    QSignalSpy finished(&feature->measurement(), &LoadMeasurement::finished);
    QTest::mouseClick(page.button(), Qt::LeftButton);
    QVERIFY(feature->measurement().busy());
    QVERIFY(finished.count() > 0 || finished.wait(kWaitMs));
    QCOMPARE(feature->measurement().runs().size(), std::size_t{3});
    for (const MeasuredRun& run : feature->measurement().runs()) {
      QCOMPARE(run.result.blocks.size(), std::size_t{1});
      for (const StepStatistics& step : run.result.steps) QVERIFY(!step.fromCache);
    }
    QVERIFY(panel.strategyText().contains("measured"));
    QVERIFY(page.tableText().contains("median") && page.tableText().contains("whole run"));
    QVERIFY(!panel.timeline().timeline().serial.empty());
    shoot(window, "load-measured");
    // An edit ends it.
    QTest::mouseClick(page.button(), Qt::LeftButton);
    partOf<Document>(window).setValue(partOf<Document>(window).filters()[1].id, 0, 30, 1);
    QVERIFY(!feature->measurement().busy());
    QVERIFY(feature->measurement().runs().empty());
    QVERIFY(waitUntilIdle(window));
    QTRY_VERIFY(!panel.strategyText().contains("measured"));
  }

  void medianAndSpread() {
    const Spread odd = spreadOf({3, 1, 2});
    QCOMPARE(odd.median, 2.0);
    QCOMPARE(odd.least, 1.0);
    QCOMPARE(odd.most, 3.0);
    QCOMPARE(spreadOf({4, 1, 2, 3}).median, 2.0);
    std::vector<MeasuredRun> runs(3);
    runs[0].result.totalMs = 30;
    runs[1].result.totalMs = 10;
    runs[2].result.totalMs = 20;
    QCOMPARE(medianRun(runs), std::size_t{2});
  }
};

FOOTFALL_EDITOR_SUITE(TestTimeUse)
#include "test_time_use.moc"
