// The window's widgets, actions and connections for the cells of parallel blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QMenu>
#include <QToolBar>

#include "ui/base/panel_dock.hpp"
#include "ui/window/editor_window.hpp"

namespace footfall::ui {
namespace {

constexpr int kLoadHeight = 250;

}  // namespace

void EditorWindow::createCellWidgets() {
  cellLegend_ = new CellLegend(cells_, view_);
  cellLegend_->hide();
  load_ = new LoadPanel(cells_, runThreads_, this);
  loadDock_ = new QDockWidget(tr("Load"), this);
  loadDock_->setObjectName(QStringLiteral("loadDock"));
  loadDock_->setWidget(new PanelArea(load_, loadDock_));
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  addDockWidget(Qt::BottomDockWidgetArea, loadDock_);
  resizeDocks({loadDock_}, {kLoadHeight}, Qt::Vertical);
  loadDock_->hide();
  cellWatch_ = new CellWatch(document_, controller_, *view_, cells_, this);
}

void EditorWindow::createCellActions() {
  addThreadCommands(commands_, runThreads_);
  const QString blocks = QStringLiteral("blocks");
  QAction* parallel =
      commands_.add({QStringLiteral("pipeline.parallel"), CommandMenu::Pipeline, blocks, tr("Run in &parallel"),
                     tr("Put an automatic strategy and a Collapse around the local filters")},
                    [this](bool) { emit load_->parallelBlockRequested(); });
  QAction* preview = commands_.add({QStringLiteral("pipeline.previewCells"),
                                    CommandMenu::Pipeline,
                                    blocks,
                                    tr("Pre&view cells"),
                                    {},
                                    {QKeySequence(Qt::SHIFT | Qt::Key_C)}},
                                   [this](bool) { previewCells(cellWatch_->firstStrategy()); });
  QMenu* pipeline = commands_.menu(CommandMenu::Pipeline);
  connect(pipeline, &QMenu::aboutToShow, this, [this, parallel, preview] {
    const bool hasStrategy = cellWatch_->firstStrategy() >= 0;
    parallel->setEnabled(loaded_.environment && !hasStrategy);
    preview->setEnabled(loaded_.environment && hasStrategy);
  });
  connect(pipeline, &QMenu::aboutToHide, this, [parallel, preview] {
    for (QAction* action : {parallel, preview}) action->setEnabled(true);  // or their keys would be dead
  });

  toolBar_->addSeparator();
  cellsAction_ = commands_.add({QStringLiteral("view.cells"),
                                CommandMenu::View,
                                QStringLiteral("cells"),
                                tr("&Cells"),
                                tr("Show the cells of the parallel block"),
                                {Qt::Key_C},
                                QStringLiteral("cells"),
                                true},
                               [this](bool on) {
                                 cellWatch_->showCells(on);
                                 legend_->showCells(on);
                                 chooseLegend();
                                 keepTimer_.start();
                               });
  QAction* load =
      commands_.adopt(makePanelAction(*loadDock_, *view_, this), {QStringLiteral("view.load"),
                                                                  CommandMenu::View,
                                                                  QStringLiteral("panels"),
                                                                  tr("&Load"),
                                                                  tr("Show how the work was spread over threads"),
                                                                  {Qt::Key_L},
                                                                  QStringLiteral("load"),
                                                                  true});
  connect(loadDock_->toggleViewAction(), &QAction::toggled, this, [this](bool on) {
    cellWatch_->showLoad(on);
    keepTimer_.start();
  });
  for (QAction* action : {cellsAction_, load}) toolBar_->addAction(action);
}

void EditorWindow::previewCells(int strategy) {
  if (!loaded_.environment || strategy < 0) return;
  cellsAction_->setChecked(true);
  cellWatch_->preview(strategy);
}

// The colours of the other legend lie under those of the cells.
void EditorWindow::chooseLegend() {
  const bool cells = cellsAction_->isChecked();
  cellLegend_->setVisible(cells);
  legend_->setVisible(loaded_.environment && !(cells && !cells_.empty()));
  placeOverlays();
}

void EditorWindow::connectCells() {
  controller_.setThreads(runThreads_.chosen());
  connect(&runThreads_, &RunThreads::changed, this, [this] { controller_.setThreads(runThreads_.chosen()); });
  for (OverlayFrame* legend : std::initializer_list<OverlayFrame*>{legend_, cellLegend_})
    connect(legend, &OverlayFrame::changed, this, &EditorWindow::placeOverlays);
  connect(&cells_, &CellModel::figuresChanged, this, [this] { keepTimer_.start(); });
  connect(&cells_, &CellModel::shapesChanged, this, &EditorWindow::chooseLegend);
  connect(load_, &LoadPanel::parallelBlockRequested, this, [this] {
    if (!loaded_.environment || document_.addParallelBlock()) return;
    messages_->showHint(tr("No local filter can run in parallel; add a clearance filter first."));
    messages_->setSubject(MessageSubject::Filters);
  });
  connect(load_, &LoadPanel::runRequested, &cells_, &CellModel::endPreview);
  connect(filters_, &FilterList::previewRequested, this, &EditorWindow::previewCells);
  connect(cellWatch_, &CellWatch::previewFailed, this,
          [this](const QString& message) { messages_->showErrorOf(MessageSubject::Filters, message); });
  const auto describeEmptyState = [this] {
    load_->setPipeline(loaded_.environment != nullptr, cellWatch_->firstStrategy() >= 0);
  };
  connect(cellWatch_, &CellWatch::blockChanged, this, describeEmptyState);
  connect(this, &EditorWindow::environmentLoaded, this, describeEmptyState);
}

void EditorWindow::setCellsShown(const CellsShown& shown) {
  cells_.setColouring(shown.colouring);
  cellsAction_->setChecked(shown.inView);
  loadDock_->setVisible(shown.load);
  if (shown.load) resizeDocks({loadDock_}, {kLoadHeight}, Qt::Vertical);
}

CellsShown EditorWindow::cellsShown() const {
  return {cellsAction_->isChecked(), !loadDock_->isHidden(), cells_.colouring()};
}

}  // namespace footfall::ui
