// The window's widgets, actions and connections for the cells of parallel blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QMenu>
#include <QToolBar>

#include "ui/editor_window.hpp"

namespace footfall {
namespace {

constexpr int kLoadHeight = 250;

}  // namespace

void EditorWindow::createCellWidgets() {
  cellLegend_ = new CellLegend(cells_, view_);
  cellLegend_->hide();
  load_ = new LoadPanel(cells_, this);
  loadDock_ = new QDockWidget(tr("Load"), this);
  loadDock_->setObjectName(QStringLiteral("loadDock"));
  loadDock_->setWidget(load_);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  addDockWidget(Qt::BottomDockWidgetArea, loadDock_);
  resizeDocks({loadDock_}, {kLoadHeight}, Qt::Vertical);
  loadDock_->hide();
  cellWatch_ = new CellWatch(document_, controller_, *view_, cells_, this);
}

void EditorWindow::createCellActions(QMenu* pipeline, QMenu* look, QToolBar* bar) {
  QAction* parallel = pipeline->addAction(tr("Run in &parallel"));
  parallel->setToolTip(tr("Put an automatic strategy and a Collapse around the local filters"));
  connect(parallel, &QAction::triggered, load_, &LoadPanel::parallelBlockRequested);
  QAction* preview = pipeline->addAction(tr("Pre&view cells"));
  preview->setShortcut(Qt::SHIFT | Qt::Key_C);
  connect(preview, &QAction::triggered, this, [this] { previewCells(cellWatch_->firstStrategy()); });
  connect(pipeline, &QMenu::aboutToShow, this, [this, parallel, preview] {
    const bool hasStrategy = cellWatch_->firstStrategy() >= 0;
    parallel->setEnabled(loaded_.environment && !hasStrategy);
    preview->setEnabled(loaded_.environment && hasStrategy);
  });
  connect(pipeline, &QMenu::aboutToHide, this, [parallel, preview] {
    for (QAction* action : {parallel, preview}) action->setEnabled(true);  // or their keys would be dead
  });

  look->addSeparator();
  bar->addSeparator();
  cellsAction_ = look->addAction(tr("&Cells"));
  cellsAction_->setCheckable(true);
  cellsAction_->setShortcut(Qt::Key_C);
  cellsAction_->setToolTip(tr("Show the cells of the parallel block (C)"));
  connect(cellsAction_, &QAction::toggled, this, [this](bool on) {
    cellWatch_->showCells(on);
    legend_->showCells(on);
    chooseLegend();
    keepTimer_.start();
  });
  QAction* load = loadDock_->toggleViewAction();
  load->setText(tr("&Load"));
  load->setShortcut(Qt::Key_L);
  load->setToolTip(tr("Show how the work was spread over threads (L)"));
  connect(load, &QAction::toggled, this, [this](bool on) {
    cellWatch_->showLoad(on);
    keepTimer_.start();
  });
  for (QAction* action : {cellsAction_, load}) {
    look->addAction(action);
    bar->addAction(action);
  }
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
  connect(cellLegend_, &CellLegend::resized, this, &EditorWindow::placeOverlays);
  connect(&cells_, &CellModel::figuresChanged, this, [this] { keepTimer_.start(); });
  connect(&cells_, &CellModel::shapesChanged, this, &EditorWindow::chooseLegend);
  connect(load_, &LoadPanel::parallelBlockRequested, this, [this] {
    if (loaded_.environment && !document_.addParallelBlock())
      messages_->showHint(tr("No local filter can run in parallel; add a clearance filter first."));
  });
  connect(load_, &LoadPanel::runRequested, &cells_, &CellModel::endPreview);
  connect(filters_, &FilterList::previewRequested, this, &EditorWindow::previewCells);
  connect(cellWatch_, &CellWatch::previewFailed, messages_, &MessageBar::showError);
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

}  // namespace footfall
