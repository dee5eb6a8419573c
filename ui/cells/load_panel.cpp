// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/load_panel.hpp"

#include <QHBoxLayout>
#include <QResizeEvent>
#include <QSplitter>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>
#include <span>

#include "core/partitioning/load_balancing.hpp"
#include "ui/base/commands/keys_back.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/text/filter_text.hpp"
#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

constexpr int kPlotWidth = 324;
constexpr int kTimelineWidth = 240;  // a lane must be visible beside the names of threads
constexpr int kTextLines = 2;        // more lines of a text would take the room of the plots

QString swatch(const QColor& colour) {
  return QStringLiteral("<span style='color:%1'>&#9632;</span>&nbsp;").arg(colour.name());
}

QString tableOf(std::span<const PhaseTime> phases, std::size_t columns = 2) {
  QString text = QStringLiteral("<table width='100%' cellspacing=0 cellpadding=0>");
  for (std::size_t i = 0; i < phases.size(); i += columns) {
    text += QStringLiteral("<tr>");
    for (std::size_t k = i; k < std::min(i + columns, phases.size()); ++k)
      text += QStringLiteral("<td>%1%2&nbsp;</td><td align='right'>%3&nbsp;&nbsp;&nbsp;</td>")
                  .arg(swatch(phases[k].colour), phases[k].name.toHtmlEscaped(), durationText(phases[k].milliseconds));
    text += QStringLiteral("</tr>");
  }
  return text + QStringLiteral("</table>");
}

// Shows a text, or its brief form where the text needs too many lines; the tool tip has the whole text then.
void showFitting(QLabel& label, const QString& text, const QString& brief) {
  label.setText(text);
  const bool fits = label.heightForWidth(label.width()) <= kTextLines * label.fontMetrics().lineSpacing() + 2;
  label.setToolTip(fits || text == brief ? QString() : text);
  if (!fits) label.setText(brief);
}

}  // namespace

LoadPanel::LoadPanel(CellModel& model, RunThreads& threads, RunPlaces& places, LoadMeasurement& measurement,
                     QWidget* parent)
    : QWidget(parent), model_(model), measure_(new MeasurePage(measurement, this)) {
  setObjectName(QStringLiteral("loadPanel"));
  makeThreadBox(threads);
  makePlaceBox(places);
  stack_ = new QStackedWidget(this);
  stack_->addWidget(makeEmptyPage());
  stack_->addWidget(makeContentPage());
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(stack_);
  connect(&model_, &CellModel::figuresChanged, this, &LoadPanel::refresh);
  setPipeline(false, false);
  refresh();
}

void LoadPanel::makeThreadBox(RunThreads& threads) {
  threadBox_ = new QComboBox(this);
  threadBox_->setObjectName(QStringLiteral("threads"));
  threadBox_->setAccessibleName(tr("Threads of a run"));
  threadBox_->setToolTip(tr("The largest number of threads of a run; the result does not depend on it"));
  std::vector<int> choices = threadChoices(processorCount());
  choices.back() = 0;
  for (const int n : choices) threadBox_->addItem(threadsText(n), n);
  const auto show = [this, &threads] {
    if (threadBox_->findData(threads.chosen()) < 0)
      threadBox_->addItem(threadsText(threads.chosen()), threads.chosen());
    threadBox_->setCurrentIndex(threadBox_->findData(threads.chosen()));
    model_.setThreads(threads.count());
  };
  show();
  connect(&threads, &RunThreads::changed, this, show);
  connect(threadBox_, &QComboBox::activated, &threads,
          [this, &threads](int index) { threads.choose(threadBox_->itemData(index).toInt()); });
}

// The last item shows the chosen place with its figures, and cannot be chosen itself.
void LoadPanel::makePlaceBox(RunPlaces& places) {
  using Kind = RunPlace::Kind;
  placeBox_ = new QComboBox(this);
  placeBox_->setObjectName(QStringLiteral("runOn"));
  placeBox_->setAccessibleName(tr("Run on"));
  placeBox_->setToolTip(tr("Where the cells of a run are computed; the result does not depend on it"));
  for (const Kind kind : {Kind::ThisProcess, Kind::Processes, Kind::Hosts, Kind::Slurm})
    placeBox_->addItem(kind == Kind::ThisProcess ? placeText(kind) : placeText(kind) + QStringLiteral("..."),
                       static_cast<int>(kind));
  const int kinds = placeBox_->count();
  const auto show = [this, kinds, &places] {
    while (placeBox_->count() > kinds) placeBox_->removeItem(kinds);
    if (places.chosen().kind != Kind::ThisProcess) placeBox_->addItem(placeText(places.chosen()), -1);
    placeBox_->setCurrentIndex(places.chosen().kind == Kind::ThisProcess ? 0 : kinds);
  };
  show();
  connect(&places, &RunPlaces::changed, this, show);
  connect(placeBox_, &QComboBox::activated, this, [this, &places, show](int index) {
    const int kind = placeBox_->itemData(index).toInt();
    if (kind == static_cast<int>(Kind::ThisProcess))
      places.choose({});
    else if (kind > 0)
      emit placeRequested(static_cast<Kind>(kind));
    show();
  });
}

QWidget* LoadPanel::makeEmptyPage() {
  auto* page = new QWidget(this);
  emptyText_ = new QLabel(page);
  emptyText_->setAlignment(Qt::AlignCenter);
  emptyText_->setWordWrap(true);
  parallel_ = new QPushButton(tr("Run in parallel"), page);
  parallel_->setToolTip(tr("Put an automatic strategy and a Collapse around the local filters; one step of undo"));
  auto* layout = new QVBoxLayout(page);
  layout->addStretch(1);
  layout->addWidget(emptyText_);
  layout->addWidget(parallel_, 0, Qt::AlignHCenter);
  layout->addStretch(1);
  giveKeysBackAfterClick(*parallel_);
  connect(parallel_, &QPushButton::clicked, this, &LoadPanel::parallelBlockRequested);
  return page;
}

QWidget* LoadPanel::makeContentPage() {
  auto* page = new QWidget(this);
  strategy_ = new QLabel(page);
  strategy_->setTextFormat(Qt::RichText);
  strategy_->setWordWrap(true);
  strategy_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  strategy_->installEventFilter(this);
  block_ = new QComboBox(page);
  block_->setAccessibleName(tr("Parallel block"));
  block_->setToolTip(tr("Which parallel block is shown"));
  connect(block_, &QComboBox::activated, this,
          [this](int index) { model_.setShownIndex(static_cast<std::size_t>(index)); });
  back_ = new QPushButton(tr("Show the last run"), page);
  back_->setToolTip(tr("Leave the preview"));
  giveKeysBackAfterClick(*back_);
  connect(back_, &QPushButton::clicked, this, &LoadPanel::runRequested);
  auto* head = new QHBoxLayout;
  head->addWidget(strategy_, 1);
  head->addWidget(back_);
  head->addWidget(block_);
  head->addWidget(placeBox_);
  head->addWidget(threadBox_);

  timeline_ = new TimelinePlot(model_, page);
  timeline_->setMinimumWidth(kTimelineWidth);
  filters_ = new QLabel(page);
  filters_->setTextFormat(Qt::RichText);
  filters_->setWordWrap(true);
  filters_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  filters_->installEventFilter(this);
  auto* left = new QWidget(page);
  auto* leftLayout = new QVBoxLayout(left);
  leftLayout->setContentsMargins(0, 0, 0, 0);
  leftLayout->setSpacing(2);
  leftLayout->addWidget(timeline_, 1);
  leftLayout->addWidget(filters_);
  auto* splitter = new QSplitter(page);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(left);
  splitter->addWidget(makeFigures());
  splitter->setStretchFactor(0, 1);
  splitter->setStretchFactor(1, 0);

  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->setSpacing(4);
  layout->addLayout(head);
  layout->addWidget(splitter, 1);
  return page;
}

QWidget* LoadPanel::makeFigures() {
  pages_ = new QTabWidget(this);
  pages_->setDocumentMode(true);
  pages_->setFocusPolicy(Qt::NoFocus);
  pages_->tabBar()->setFocusPolicy(Qt::TabFocus);
  pages_->tabBar()->setAccessibleName(tr("Pages of the load"));
  const auto page = [this](const QString& name, std::initializer_list<QWidget*> parts, QWidget* stretched) {
    auto* widget = new QWidget(pages_);
    auto* layout = new QVBoxLayout(widget);
    layout->setContentsMargins(6, 2, 0, 0);
    layout->setSpacing(3);
    for (QWidget* part : parts) layout->addWidget(part, part == stretched ? 1 : 0);
    if (!stretched) layout->addStretch(1);
    pages_->addTab(widget, name);
  };
  const auto label = [this] {
    auto* text = new QLabel(this);
    text->setTextFormat(Qt::RichText);
    return text;
  };
  figures_ = label();
  figures_->setWordWrap(true);
  busy_ = new BusyPlot(this);
  busy_->setMinimumWidth(kPlotWidth);  // a part of the width: the texts may need more
  use_ = new PhasePlot(this);
  use_->setObjectName(QStringLiteral("usePlot"));
  use_->setAccessibleName(tr("How the time of all threads was used"));
  useTexts_ = label();
  page(tr("Threads"), {figures_, busy_, use_, useTexts_}, busy_);
  histogram_ = new HistogramPlot(this);
  histogramText_ = label();
  histogramText_->setWordWrap(true);
  page(tr("Cells"), {histogram_, histogramText_}, histogram_);
  phases_ = new PhasePlot(this);
  phaseTexts_ = label();
  page(tr("Phases"), {phases_, phaseTexts_}, nullptr);
  pages_->addTab(measure_, tr("Measure"));
  return pages_;
}

void LoadPanel::setPipeline(bool hasEnvironment, bool hasBlock) {
  if (!hasEnvironment) {
    emptyText_->setText(tr("Open an environment to see how the work on it is spread over threads."));
  } else if (hasBlock) {
    emptyText_->setText(tr("The cells of the parallel block show here as soon as they are made."));
  } else {
    emptyText_->setText(
        tr("This pipeline has no parallel block. Add a strategy before the local filters and a Collapse behind them to "
           "divide the environment into cells, and to see here how the work is spread."));
  }
  parallel_->setVisible(hasEnvironment && !hasBlock);
}

// A stack is as wide as its widest page, and hidden plots must not cut off the texts.
void LoadPanel::showPage(int page) {
  for (int i = 0; i < stack_->count(); ++i) {
    const QSizePolicy::Policy policy = i == page ? QSizePolicy::Preferred : QSizePolicy::Ignored;
    stack_->widget(i)->setSizePolicy(policy, policy);
  }
  stack_->setCurrentIndex(page);
}

void LoadPanel::refresh() {
  const CellBlock* block = model_.shownBlock();
  showPage(block ? 1 : 0);
  if (!block) return;
  QString text =
      QStringLiteral("<b>%1</b>&nbsp; · &nbsp;").arg(ui::strategyText(block->report.strategy).toHtmlEscaped());
  const std::size_t cells = block->report.cells.size();
  const auto finished = static_cast<std::size_t>(std::ranges::count(block->finished, 1));
  const QString count = cells == 1 ? tr("1 cell") : tr("%1 cells").arg(cells);
  if (model_.previewing()) {
    text += tr("%1, before a run").arg(count);
  } else if (finished < cells) {
    text += tr("%1 of %2 finished").arg(finished).arg(count);
  } else {
    text += count;
  }
  if (block->origin == CellBlock::Origin::Cache)
    text += QStringLiteral("&nbsp; · &nbsp;<b>") + tr("from the cache: figures of the run that computed it") +
            QStringLiteral("</b>");
  else if (const int cached = model_.cachedCells(); cached > 0)
    text += QStringLiteral("&nbsp; · &nbsp;<b>") + tr("%n from the cache", nullptr, cached) + QStringLiteral("</b>");
  if (block->origin == CellBlock::Origin::Measured)
    text += QStringLiteral("&nbsp; · &nbsp;<b>") + tr("measured: the median run") + QStringLiteral("</b>");
  head_ = {text, text};
  if (!block->report.reason.empty())
    head_.whole += QStringLiteral("&nbsp; · &nbsp;") + coreText(block->report.reason).toHtmlEscaped();

  back_->setVisible(model_.previewing());
  const CellBlocks& blocks = model_.blocks();
  block_->setVisible(blocks.size() > 1);
  if (block_->count() != static_cast<int>(blocks.size())) {
    block_->clear();
    for (std::size_t i = 0; i < blocks.size(); ++i) block_->addItem(tr("Block %1").arg(i + 1));
  }
  block_->setCurrentIndex(static_cast<int>(model_.shownIndex()));
  showFigures(*block);
  showPhases(*block);
  showTimeUse(*block);
  histogram_->show(*block);
  histogramText_->setText(block->begun() ? histogram_->summary().toHtmlEscaped()
                                         : tr("No cell has run yet.").toHtmlEscaped());
  showFilters();
  fitTexts();
}

void LoadPanel::fitTexts() {
  if (!model_.shownBlock()) return;
  showFitting(*strategy_, head_.whole, head_.brief);
  showFitting(*filters_, key_.whole, key_.brief);
}

bool LoadPanel::eventFilter(QObject* watched, QEvent* event) {
  // A layout that resizes its parts takes no notice of what changes meanwhile.
  const auto* resize = event->type() == QEvent::Resize ? static_cast<QResizeEvent*>(event) : nullptr;
  if (resize && resize->size().width() != resize->oldSize().width())
    QMetaObject::invokeMethod(this, &LoadPanel::fitTexts, Qt::QueuedConnection);
  return QWidget::eventFilter(watched, event);
}

// Only finished runs have these figures: waiting times are not known during a run.
void LoadPanel::showTimeUse(const CellBlock& block) {
  const bool known = block.complete();
  use_->setVisible(known);
  useTexts_->setVisible(known);
  if (!known) return;
  const TimeUse use = timeUse(timeline_->timeline());
  use_->show(use);
  useTexts_->setText(tableOf(timesOf(use), 1));
  use_->setToolTip(
      tr("The time of all threads from the beginning of the run to its end: %1").arg(durationText(use.total())));
}

void LoadPanel::showFigures(const CellBlock& block) {
  if (!block.begun()) {
    std::vector<double> costs;
    for (const CellReport& cell : block.report.cells) costs.push_back(cell.cost);
    const LoadBalance balance = assignLongestFirst(costs, static_cast<std::size_t>(model_.threads()));
    const QString imbalance = fixedText(balance.imbalance(), 2);
    figures_->setText(model_.threads() == 1
                          ? tr("Expected: imbalance <b>%1</b> on 1 thread").arg(imbalance)
                          : tr("Expected: imbalance <b>%1</b> on %2 threads").arg(imbalance).arg(model_.threads()));
    busy_->showPlan(balance.loads);
    return;
  }
  const LoadFigures figures = figuresOf(block);
  QString text = tr("Imbalance <b>%1</b>").arg(fixedText(figures.imbalance, 2));
  if (block.complete() && figures.speedUp > 0) {
    const QString speedUp = fixedText(figures.speedUp, 2);
    const auto ranks = static_cast<int>(block.ranks.threads.size());
    if (ranks > 0)
      text += tr(", speed-up <b>%1</b> on %n rank(s)", nullptr, ranks).arg(speedUp);
    else
      text += block.threads() == 1 ? tr(", speed-up <b>%1</b> on 1 thread").arg(speedUp)
                                   : tr(", speed-up <b>%1</b> on %2 threads").arg(speedUp).arg(block.threads());
  }
  figures_->setText(text);
  figures_->setToolTip(
      tr("Load imbalance: the busiest thread's time over the mean, 1 at best. Speed-up: the work of all "
         "threads on cells over the time that the cells took."));
  busy_->show(block);
}

void LoadPanel::showPhases(const CellBlock& block) {
  const bool known = block.complete();
  phases_->setVisible(known);
  phaseTexts_->setVisible(known);
  if (!known) return;
  phases_->show(block.run->times);
  phaseTexts_->setText(tableOf(phasesOf(block.run->times)));
  phases_->setToolTip(tr("The whole run: %1").arg(durationText(block.run->times.total)));
}

void LoadPanel::showFilters() {
  const std::vector<std::string>& names = timeline_->timeline().filters;
  QStringList parts;
  for (std::size_t i = 0; i < names.size(); ++i)
    parts << swatch(filterColour(i)) + filterName(names[i]).toHtmlEscaped();
  if (!names.empty()) {
    key_.brief = parts.join(QStringLiteral("&nbsp;&nbsp; "));
    parts << tr("hatched: waiting for work") << tr("dotted: waiting for a serial step");
    if (model_.cachedCells() > 0) parts << tr("crossed out: from the cache");
    key_.whole = tr("Filters below the cells: ") + parts.join(QStringLiteral("&nbsp;&nbsp; "));
  } else {
    key_.whole = key_.brief = timeline_->timeline().planned
                                  ? tr("Before a run: the cells by estimated cost, each on the first free thread.")
                                  : tr("The lanes of the threads fill when cells run.");
  }
}

}  // namespace footfall::ui
