// The dock "Load" with reports made by hand: timeline, load, phases, and its texts without cells.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/block_builder.hpp"
#include "tests/editor/editor_driver.hpp"
#include "ui/cells/cell_legend.hpp"
#include "ui/cells/load_panel.hpp"
#include "ui/run/run_threads.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

class TestLoadPanel : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    model_ = std::make_unique<CellModel>();
    panel_ = std::make_unique<LoadPanel>(*model_, threads_, places_, measurement_);
    panel_->resize(1000, 260);
    panel_->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
  }
  void cleanup() {
    panel_.reset();
    model_.reset();
  }

  void withoutABlockItSaysWhatToDo() {
    QVERIFY(panel_->showsEmptyState());
    QVERIFY(!panel_->parallelButton()->isVisible());
    panel_->setPipeline(true, false);
    QVERIFY(panel_->emptyText().contains("Add a strategy"));
    QVERIFY2(panel_->minimumSizeHint().width() < 230, qPrintable(QString::number(panel_->minimumSizeHint().width())));
    QSignalSpy asked(panel_.get(), &LoadPanel::parallelBlockRequested);
    QTest::mouseClick(panel_->parallelButton(), Qt::LeftButton);
    QCOMPARE(asked.count(), 1);
    panel_->setPipeline(true, true);
    QVERIFY(!panel_->parallelButton()->isVisible());
    model_->setBlocks({fourCells()});
    QVERIFY(!panel_->showsEmptyState());
    model_->setBlocks({});
    QVERIFY(panel_->showsEmptyState());
  }

  void noTextIsCut_data() {
    QTest::addColumn<double>("scale");
    QTest::newRow("usual font") << 1.0;
    QTest::newRow("large font") << 1.6;
  }
  void noTextIsCut() {
    QFETCH(double, scale);
    const QFont usual = QApplication::font();
    QFont font = usual;
    font.setPointSizeF(usual.pointSizeF() * scale);
    QApplication::setFont(font);
    const auto back = qScopeGuard([&] { QApplication::setFont(usual); });
    panel_.reset();
    panel_ = std::make_unique<LoadPanel>(*model_, threads_, places_, measurement_);
    panel_->resize(1100, 300);
    panel_->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
    model_->setBlocks({fourCells()});
    CellLegend legend(*model_, nullptr);
    legend.show();
    legend.fitInto({1400, 900});
    const auto cutText = [&]() -> QString {
      for (const QWidget* part : std::initializer_list<QWidget*>{panel_.get(), &legend}) {
        for (const QLabel* label : part->findChildren<QLabel*>()) {
          if (!label->isVisible() || label->text().isEmpty()) continue;
          const bool ignored = label->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored;
          const int height =
              label->wordWrap() ? label->heightForWidth(label->width()) : label->minimumSizeHint().height();
          if (!ignored && label->width() < label->minimumSizeHint().width()) return label->text();
          if (label->height() < height) return label->text();
        }
      }
      return {};
    };
    QTRY_COMPARE(cutText(), QString());  // the window grows a moment later
  }

  // A long reason would take the room of the plots: the tool tip has it.
  void aLongReasonGivesWayToThePlots() {
    std::string reason = "because";
    for (int i = 0; i < 50; ++i) reason += " of this";
    model_->setBlocks({BlockBuilder(2, "GridStrategy 2 1").reason(reason).block()});
    panel_->resize(700, 300);
    QTRY_VERIFY(!panel_->strategyText().contains("because"));
    QVERIFY(panel_->strategyText().contains("2 cells"));
    panel_->resize(2400, 300);
    QTRY_VERIFY(panel_->strategyText().contains("because"));
  }

  void hoveringABarHighlightsItsCell() {
    model_->setBlocks({fourCells()});
    TimelinePlot& plot = shownTimeline();
    const Timeline::Bar& bar = plot.timeline().bars[0];
    const QPointF place = plot.placeOf(bar);
    QVERIFY((plot.barAt(place)->cell == CellId{0, 0}));
    QTest::mouseMove(&plot, place.toPoint());
    QTRY_VERIFY((model_->hovered() == CellId{0, 0}));
    // The space between the lanes is empty.
    QVERIFY(!plot.barAt({place.x(), plot.yAxis->coordToPixel(0.5)}));
    // Idle.
    QVERIFY(!plot.barAt({plot.xAxis->coordToPixel(55), plot.yAxis->coordToPixel(1)}));
  }

  void clickingABarSelectsAndFrames() {
    model_->setBlocks({fourCells()});
    TimelinePlot& plot = shownTimeline();
    const QSignalSpy framed(model_.get(), &CellModel::frameRequested);
    const Timeline::Bar* bar = plot.timeline().at(1, 25);
    QTest::mouseClick(&plot, Qt::LeftButton, Qt::NoModifier, plot.placeOf(*bar).toPoint());
    QVERIFY((model_->selected() == CellId{0, 2}));
    QCOMPARE(framed.count(), 1);
    QTest::mouseClick(&plot, Qt::LeftButton, Qt::NoModifier,
                      QPointF(plot.xAxis->coordToPixel(57), plot.yAxis->coordToPixel(1)).toPoint());
    QVERIFY(!model_->selected());
  }

  void aHighlightFromElsewhereIsSeen() {
    model_->setBlocks({fourCells()});
    TimelinePlot& plot = shownTimeline();
    const QImage before = plot.toPixmap().toImage();
    model_->setHovered(CellId{0, 2});
    QVERIFY(plot.toPixmap().toImage() != before);
    model_->setHovered({});
    QCOMPARE(plot.toPixmap().toImage(), before);
  }

  void barsHaveTheColoursOfTheView() {
    model_->setBlocks({fourCells()});
    TimelinePlot& plot = shownTimeline();
    const auto upperPart = [&](const Timeline::Bar& bar) {
      const QPixmap picture = plot.toPixmap();
      return picture.toImage().pixelColor(static_cast<int>(plot.xAxis->coordToPixel(bar.start)) + 4,
                                          static_cast<int>(plot.yAxis->coordToPixel(bar.lane - 0.3)));
    };
    for (const double time : {30.0, 44.0, 55.0}) {
      const Timeline::Bar* bar = plot.timeline().at(0, time);
      QCOMPARE(upperPart(*bar), *model_->scaleOf(0).colourOf(bar->cell->cell));
    }
    model_->setColouring(CellColouring::Time);
    const Timeline::Bar* bar = plot.timeline().at(1, 40);
    QCOMPARE(upperPart(*bar), scaleColour(1));
  }

  void theWheelZoomsInTimeAndADoubleClickShowsAll() {
    model_->setBlocks({fourCells()});
    TimelinePlot& plot = shownTimeline();
    const QCPRange all = plot.xAxis->range();
    const QCPRange lanes = plot.yAxis->range();
    const QPointF place = plot.placeOf(plot.timeline().bars[0]);
    const auto turn = [&](int angle) {
      QWheelEvent wheel(place, plot.mapToGlobal(place), {}, {0, angle}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                        false);
      QCoreApplication::sendEvent(&plot, &wheel);
    };
    turn(240);
    QVERIFY(plot.xAxis->range().size() < 0.8 * all.size());
    QCOMPARE(plot.yAxis->range(), lanes);
    model_->setHovered(CellId{0, 1});
    model_->setColouring(CellColouring::Cost);  // new colours do not move the visible part
    QVERIFY(plot.xAxis->range().size() < 0.8 * all.size());
    for (int i = 0; i < 20; ++i) turn(-240);
    QVERIFY(plot.xAxis->range().lower >= plot.timeline().start - 1);
    QVERIFY(plot.xAxis->range().upper <= plot.timeline().end + 1);
    turn(240);
    QTest::mouseDClick(&plot, Qt::LeftButton, Qt::NoModifier, place.toPoint());
    QCOMPARE(plot.xAxis->range().size(), all.size());
  }

  void loadAndPhasesInNumbers() {
    model_->setBlocks({fourCells()});
    QVERIFY2(panel_->figuresText().contains("1.09"), qPrintable(panel_->figuresText()));
    QVERIFY(panel_->figuresText().contains("1.65"));
    QCOMPARE(panel_->busyPlot().bars()->data()->size(), 2);
    QCOMPARE(panel_->busyPlot().bars()->data()->at(0)->value, 36.0);
    double sum = 0;
    for (const QCPBars* bar : panel_->phasePlot().bars()) sum += bar->data()->at(0)->value;
    QCOMPARE(sum, 88.0);
    panel_->pages().setCurrentIndex(2);
    QVERIFY(panel_->phasePlot().isVisible());
  }

  void cellsAppearAsTheyFinish() {
    model_->setBlocks({BlockBuilder(4).block()});
    TimelinePlot& plot = shownTimeline();
    QVERIFY(plot.timeline().planned);
    QCOMPARE(plot.timeline().bars.size(), std::size_t{4});
    QVERIFY(panel_->figuresText().contains("Expected"));
    QVERIFY(!panel_->phasePlot().isVisible());
    model_->setBlocks({BlockBuilder(4).work(2, "SlopeFilter", 0, 1, 5).block()});
    QCOMPARE(plot.timeline().bars.size(), std::size_t{1});
    QVERIFY(panel_->strategyText().contains("1 of 4 cells finished"));
    model_->setBlocks({BlockBuilder(4).work(2, "SlopeFilter", 0, 1, 5).work(0, "SlopeFilter", 1, 2, 90).block()});
    QVERIFY(plot.xAxis->range().upper >= 90);  // all of it is in sight
  }

  void itSaysHowManyCellsCameFromTheCache() {
    model_->setBlocks({fourCells()});
    QVERIFY(!panel_->strategyText().contains("from the cache"));
    const QImage plain = shownTimeline().grab().toImage();
    model_->setReuse({{{10, 10}, {20, 5}, {8, 8}, {3, 0}}});
    QVERIFY2(panel_->strategyText().contains("2 from the cache"), qPrintable(panel_->strategyText()));
    QVERIFY(shownTimeline().grab().toImage() != plain);  // their bars are crossed out
    model_->setBlocks({fourCells()});
    QVERIFY(!panel_->strategyText().contains("from the cache"));
  }

  void theReasonOfAStrategyIsShownAndIsNoMarkup() {
    model_->setBlocks({BlockBuilder(2, "GridStrategy 2 1").reason("2 threads <b>& more</b>").block()});
    QVERIFY(panel_->strategyText().contains("Grid strategy 2 · 1"));
    QVERIFY(panel_->strategyText().contains("2 threads &lt;b&gt;&amp; more"));
  }

  void severalBlocksCanBeChosen() {
    const CellBlock first = fourCells();
    model_->setBlocks({first, BlockBuilder(2).work(1, "SlopeFilter", 0, 70, 80).ranWith(first).block()});
    auto* box = panel_->findChild<QComboBox*>();
    QVERIFY(box->isVisible());
    QCOMPARE(box->count(), 2);
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Down);
    QCOMPARE(model_->shownIndex(), std::size_t{1});
    // One timeline for both, as they ran in one run.
    QCOMPARE(panel_->timeline().timeline().end, 80.0);
    // A bar of the other block selects it again.
    TimelinePlot& plot = shownTimeline();
    QTest::mouseClick(&plot, Qt::LeftButton, Qt::NoModifier, plot.placeOf(*plot.timeline().at(0, 30)).toPoint());
    QCOMPARE(model_->shownIndex(), std::size_t{0});
  }

  void thousandsOfCellsStayQuick() {
    constexpr std::size_t kCells = 4000;
    BlockBuilder builder(kCells);
    for (std::size_t i = 0; i < kCells; ++i)
      builder.work(i, "VerticalClearanceFilter", static_cast<int>(i % 16), static_cast<double>(i),
                   static_cast<double>(i) + 15);
    const CellBlock block = builder.phases(0, 0, kCells + 15, 0).ran({}, 16).block();
    QElapsedTimer clock;
    clock.start();
    model_->setBlocks({block});
    TimelinePlot& plot = shownTimeline();
    qInfo("4,000 cells: %lld ms until they are drawn", clock.restart());
    for (std::size_t i = 0; i < 20; ++i) {
      model_->setHovered(CellId{0, i});
      plot.replot();
    }
    qInfo("20 highlights: %lld ms", clock.elapsed());
    QVERIFY(clock.elapsed() < 20 * 400);  // far above what it takes: a busy machine is no failure
  }

 private:
  TimelinePlot& shownTimeline() {
    QCoreApplication::processEvents();
    panel_->timeline().replot();
    return panel_->timeline();
  }

  LoadMeasurement measurement_;
  std::unique_ptr<CellModel> model_;
  RunThreads threads_;
  RunPlaces places_;
  std::unique_ptr<LoadPanel> panel_;
};

FOOTFALL_EDITOR_SUITE(TestLoadPanel)
#include "test_load_panel.moc"
