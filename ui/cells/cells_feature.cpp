// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/cells_feature.hpp"

#include <QMenu>

#include "ui/cells/run_place_dialog.hpp"

namespace footfall::ui {
namespace {

constexpr int kLoadHeight = 290;

}  // namespace

CellsFeature::CellsFeature(const FeatureHost& host, LevelView& view, ViewLayout& layout, Document& document,
                           LevelFile& file, RunController& controller, FilterList& filters)
    : QObject(&host.window),
      panels_(host.panels),
      layout_(layout),
      document_(document),
      file_(file),
      controller_(controller),
      sections_(host.sections),
      legend_(new CellLegend(model_, &view)),
      panel_(new LoadPanel(model_, threads_, places_, measurement_, &host.window)),
      dock_(panels_.addDock(tr("Load"), QStringLiteral("loadDock"), panel_, Qt::BottomDockWidgetArea)),
      watch_(new CellWatch(document, controller, view, model_, this)) {
  legend_->hide();
  layout_.setCellLegend(legend_);
  panels_.setHeight(*dock_, kLoadHeight);
  dock_->hide();
  addCommands(host.commands);
  connectParts(host, filters);
  connectMeasurement(host.messages);
}

// The widgets that show cells are deleted before the cells.
CellsFeature::~CellsFeature() {
  cells_->disconnect(parent());
  dock_->toggleViewAction()->disconnect(this);
  delete watch_;
  delete legend_;
  delete dock_;
}

void CellsFeature::addCommands(CommandRegistry& commands) {
  addThreadCommands(commands, threads_);
  addPlaceCommands(commands, places_, [this](RunPlace::Kind kind) { askForPlace(kind); });
  const QString blocks = QStringLiteral("blocks");
  QAction* parallel =
      commands.add({QStringLiteral("pipeline.parallel"), CommandMenu::Pipeline, blocks, tr("Run in &parallel"),
                    tr("Put an automatic strategy and a Collapse around the local filters")},
                   [this](bool) { emit panel_->parallelBlockRequested(); });
  QAction* preview = commands.add({QStringLiteral("pipeline.previewCells"),
                                   CommandMenu::Pipeline,
                                   blocks,
                                   tr("Pre&view cells"),
                                   {},
                                   {QKeySequence(Qt::SHIFT | Qt::Key_C)}},
                                  [this](bool) { this->preview(watch_->firstStrategy()); });
  QMenu* pipeline = commands.menu(CommandMenu::Pipeline);
  connect(pipeline, &QMenu::aboutToShow, this, [this, parallel, preview] {
    const bool hasStrategy = watch_->firstStrategy() >= 0;
    parallel->setEnabled(file_.environment() && !hasStrategy);
    preview->setEnabled(file_.environment() && hasStrategy);
  });
  connect(pipeline, &QMenu::aboutToHide, this, [parallel, preview] {
    // the keys of disabled actions would not work
    for (QAction* action : {parallel, preview}) action->setEnabled(true);
  });
  cells_ = commands.add({QStringLiteral("view.cells"),
                         CommandMenu::View,
                         QStringLiteral("cells"),
                         tr("&Cells"),
                         tr("Show the cells of the parallel block"),
                         {Qt::Key_C},
                         QStringLiteral("cells"),
                         true},
                        [this](bool on) {
                          watch_->showCells(on);
                          layout_.legend().showCells(on);
                          chooseLegend();
                          emit sections_.changed();
                        });
  load_ = panels_.addCommand(*dock_, {QStringLiteral("view.load"),
                                      CommandMenu::View,
                                      QStringLiteral("panels"),
                                      tr("&Load"),
                                      tr("Show how the work was spread over threads"),
                                      {Qt::Key_L},
                                      QStringLiteral("load"),
                                      true});
  connect(dock_->toggleViewAction(), &QAction::toggled, this, [this](bool on) {
    watch_->showLoad(on);
    emit sections_.changed();
  });
}

void CellsFeature::connectParts(const FeatureHost& host, FilterList& filters) {
  controller_.setThreads(threads_.chosen());
  connect(&threads_, &RunThreads::changed, this, [this] { controller_.setThreads(threads_.chosen()); });
  connect(&places_, &RunPlaces::changed, this, [this] {
    controller_.setPlace(places_.chosen());
    emit sections_.changed();
  });
  connect(panel_, &LoadPanel::placeRequested, this, &CellsFeature::askForPlace);
  sections_.add({QStringLiteral("run_on"), [this] { return places_.save(); },
                 [this, &messages = host.messages](const std::string& text) {
                   places_.load(text);
                   if (const auto place = places_.suggested())
                     messages.showHint(tr("This session was run on %1.").arg(placeText(*place)), tr("Run there again"),
                                       [this, place] { places_.choose(*place); });
                 }});
  connect(legend_, &OverlayFrame::changed, &layout_, &ViewLayout::update);
  connect(&model_, &CellModel::figuresChanged, &sections_, &SessionSections::changed);
  connect(&model_, &CellModel::shapesChanged, this, &CellsFeature::chooseLegend);
  const auto takeUnits = [this, &units = host.units] { model_.setUnits(units.units()); };
  connect(&host.units, &UnitChoice::changed, this, takeUnits);
  takeUnits();
  connect(panel_, &LoadPanel::parallelBlockRequested, this, [this, &messages = host.messages] {
    if (!file_.environment() || document_.addParallelBlock()) return;
    messages.showHint(tr("No local filter can run in parallel; add a clearance filter first."));
    messages.setSubject(MessageSubject::Filters);
  });
  connect(panel_, &LoadPanel::runRequested, &model_, &CellModel::endPreview);
  connect(&filters, &FilterList::previewRequested, this, &CellsFeature::preview);
  connect(watch_, &CellWatch::previewFailed, &host.messages, [&messages = host.messages](const QString& message) {
    messages.showErrorOf(MessageSubject::Filters, message);
  });
  connect(watch_, &CellWatch::blockChanged, this, &CellsFeature::describeEmptyState);
  connect(&file_, &LevelFile::opened, this, &CellsFeature::chooseLegend);
  connect(&file_, &LevelFile::opened, this, &CellsFeature::describeEmptyState);
}

// A measurement needs all processors: a run of the list ends it and discards its figures.
void CellsFeature::connectMeasurement(MessageBar& messages) {
  connect(&panel_->measurePage(), &MeasurePage::requested, this, &CellsFeature::measureAgain);
  connect(&measurement_, &LoadMeasurement::finished, this, [this] {
    const std::vector<MeasuredRun>& runs = measurement_.runs();
    if (!runs.empty()) model_.setBlocks(blocksOf(runs[medianRun(runs)]));
  });
  connect(&measurement_, &LoadMeasurement::failed, &messages, &MessageBar::showError);
  connect(&controller_, &RunController::started, &measurement_, &LoadMeasurement::clear);
  connect(&document_, &Document::filtersChanged, &measurement_, &LoadMeasurement::clear);
  connect(&file_, &LevelFile::opened, &measurement_, &LoadMeasurement::clear);
  connect(&threads_, &RunThreads::changed, &measurement_, &LoadMeasurement::clear);
  for (const auto& signal : {&RunController::started, &RunController::finished, &RunController::cancelled})
    connect(&controller_, signal, this, &CellsFeature::describeObstacle);
  connect(&controller_, &RunController::failed, this, &CellsFeature::describeObstacle);
  connect(&places_, &RunPlaces::changed, this, &CellsFeature::describeObstacle);
  describeObstacle();
}

void CellsFeature::describeObstacle() {
  QString text;
  if (!controller_.environment())
    text = tr("Open an environment first.");
  else if (places_.chosen().kind != RunPlace::Kind::ThisProcess)
    text = tr("Only runs of this program can be measured; choose it under Run on.");
  else if (controller_.busy())
    text = tr("A run is under way; measure when it has finished.");
  panel_->measurePage().setObstacle(text);
}

void CellsFeature::measureAgain(int count) {
  if (!controller_.environment() || controller_.busy()) return;
  measurement_.start(controller_.environment(), document_.pipeline(), threads_.chosen(), count);
}

void CellsFeature::describeEmptyState() {
  panel_->setPipeline(file_.environment() != nullptr, watch_->firstStrategy() >= 0);
}

void CellsFeature::preview(int strategy) {
  if (!file_.environment() || strategy < 0) return;
  cells_->setChecked(true);
  watch_->preview(strategy);
}

void CellsFeature::askForPlace(RunPlace::Kind kind) {
  RunPlace place = places_.suggested().value_or(places_.chosen());
  place.kind = kind;
  auto* dialog = new RunPlaceDialog(place, panel_->window());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { places_.choose(dialog->place()); });
  dialog->open();
}

// The other legend shows the colours under those of the cells.
void CellsFeature::chooseLegend() {
  const bool cells = cells_->isChecked();
  legend_->setVisible(cells);
  layout_.legend().setVisible(file_.environment() && !(cells && !model_.empty()));
  layout_.update();
}

void CellsFeature::setShown(const CellsShown& shown) {
  model_.setColouring(shown.colouring);
  cells_->setChecked(shown.inView);
  dock_->setVisible(shown.load);
  if (shown.load) panels_.setHeight(*dock_, kLoadHeight);
}

CellsShown CellsFeature::shown() const { return {cells_->isChecked(), !dock_->isHidden(), model_.colouring()}; }

}  // namespace footfall::ui
