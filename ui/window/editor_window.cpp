// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/editor_window.hpp"

#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QStatusBar>
#include <QVBoxLayout>
#include <chrono>
#include <limits>

#include "ui/base/commands/keys_back.hpp"
#include "ui/base/commands/theme_commands.hpp"
#include "ui/base/commands/translations.hpp"
#include "ui/base/widgets/focus_ring.hpp"
#include "ui/base/widgets/hover_reset.hpp"
#include "ui/base/widgets/panel_dock.hpp"
#include "ui/base/work/guarded_application.hpp"
#include "ui/filters/filter_tools.hpp"
#include "ui/filters/parameter_handles.hpp"
#include "ui/filters/parameter_notes.hpp"
#include "ui/filters/seed_feature.hpp"
#include "ui/inspect/compare_feature.hpp"
#include "ui/inspect/corridors/corridors_feature.hpp"
#include "ui/inspect/inspection_feature.hpp"
#include "ui/inspect/measure_panel.hpp"
#include "ui/inspect/side_by_side/side_by_side.hpp"
#include "ui/level/environment_tools.hpp"
#include "ui/level/import_edits.hpp"
#include "ui/level/level_look.hpp"
#include "ui/level/obstacle_features.hpp"
#include "ui/level/packed_feature.hpp"
#include "ui/level/skipped_feature.hpp"
#include "ui/level/unit_tools.hpp"
#include "ui/path/path_feature.hpp"
#include "ui/run/result_summary.hpp"
#include "ui/view/camera/camera_tools.hpp"
#include "ui/window/export_commands.hpp"
#include "ui/window/palette_sources.hpp"
#include "ui/window/preferences.hpp"
#include "ui/window/turntable/turntable_feature.hpp"

namespace footfall::ui {

EditorWindow::EditorWindow(QWidget* parent) : QMainWindow(parent) {
  setAcceptDrops(true);
  setObjectName(QStringLiteral("editorWindow"));
  createWidgets();
  createMenus();
  createFiles();
  connectLevel();
  connectRuns();
  connectProgress();
  createComforts();
  createFeatures();
  layout_ = std::make_unique<WindowLayout>(*this, *bars_);
  updateTitle();
  hideProgress();
}

EditorWindow::~EditorWindow() {
  view_->setTool(nullptr);
  delete findChild<SideBySide*>();
  delete cells_;
  // Docks emit a signal when they are hidden with the window. Only this signal is disconnected, because styles use
  // others.
  for (QDockWidget* dock : findChildren<QDockWidget*>())
    disconnect(dock, &QDockWidget::visibilityChanged, nullptr, nullptr);
  // The parts outlive the widgets that are connected to them.
  document_.disconnect();
  document_.undoStack()->disconnect();
  controller_.disconnect();
  composer_.disconnect();
  composer_.parts().disconnect();
  file_.disconnect();
}

// --- Parts

void EditorWindow::createWidgets() {
  messages_ = new MessageBar(this);
  view_ = new LevelView(this);
  overlays_ = new ViewLayout(*view_);
  welcomePage_ = new WelcomePage(view_);
  auto* central = new QWidget(this);
  auto* layout = new QVBoxLayout(central);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(messages_);
  views_ = new QSplitter(Qt::Horizontal, central);
  views_->setChildrenCollapsible(false);
  views_->addWidget(view_);
  layout->addWidget(views_, 1);
  setCentralWidget(central);
  setKeysGoTo(*central, *view_);

  createStatusBar();
  host_ = std::make_unique<FeatureHost>(FeatureHost{*this, commands_, *new Panels(*this, commands_, *view_),
                                                    *new ViewTools(commands_, *view_, this), *status_, *messages_,
                                                    sections_, units_});
  import_ = new ImportPanel(this);
  filters_ = new FilterList(document_, controller_, this);
  QDockWidget* environment =
      host_->panels.addDock(tr("Environment"), QStringLiteral("environmentDock"), import_, Qt::LeftDockWidgetArea);
  static_cast<PanelArea*>(environment->widget())->setFitsContent();
  host_->panels.addDock(tr("Filters"), QStringLiteral("filterDock"), filters_, Qt::LeftDockWidgetArea);
  new ImportEdits(document_, file_, *import_, units_);
}

void EditorWindow::createStatusBar() {
  status_ = new StatusLine(this);
  status_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  progress_ = new ProgressDisplay(this);
  cancel_ = new QPushButton(tr("Cancel"), this);
  cancel_->setObjectName(QStringLiteral("cancel"));
  cancel_->setShortcut(Qt::Key_Escape);
  cancel_->setToolTip(tr("Stop loading, running or exporting; the last result stays (Esc)"));
  connect(cancel_, &QPushButton::clicked, this, &EditorWindow::cancelWork);
  statusBar()->addWidget(status_, 1);
  statusBar()->addPermanentWidget(progress_);
  statusBar()->addPermanentWidget(cancel_);
}

void EditorWindow::createFiles() {
  writer_ = new FileWriter(
      {.window = *this, .level = file_, .queue = writing_, .messages = *messages_, .log = log_, .status = *status_});
  sessions_ = new SessionFiles({.window = *this,
                                .document = document_,
                                .level = file_,
                                .view = *view_,
                                .cells = *cells_,
                                .sections = sections_,
                                .writer = *writer_,
                                .recent = recent_,
                                .messages = *messages_,
                                .writing = writing_});
  pipelines_ = new PipelineFiles(*this, document_, file_, *writer_, *messages_);
  opening_ = new LevelOpening({.window = *this,
                               .document = document_,
                               .file = file_,
                               .composer = composer_,
                               .controller = controller_,
                               .view = *view_,
                               .layout = *overlays_,
                               .cells = *cells_,
                               .sections = sections_,
                               .sessions = *sessions_,
                               .recent = recent_,
                               .messages = *messages_,
                               .status = *status_});
  connect(writer_, &FileWriter::written, this, &EditorWindow::written);
  connect(opening_, &LevelOpening::failed, this, &EditorWindow::loadFailed);
  connect(&file_, &LevelFile::failed, this, &EditorWindow::loadFailed);
}

void EditorWindow::createComforts() {
  addThemeCommands(commands_);
  addLanguageCommands(commands_);
  new FocusRing(this);
  new HoverReset(this);
  runLog_ = new RunLog(*host_, log_, document_, file_, controller_, *writer_);
  if (auto* application = qobject_cast<GuardedApplication*>(qApp))
    connect(application, &GuardedApplication::problemReported, messages_, &MessageBar::showError);
  auto* keys = new UserKeys(commands_, this);
  commands_.add({QStringLiteral("edit.preferences"),
                 CommandMenu::Edit,
                 QStringLiteral("preferences"),
                 tr("&Preferences..."),
                 tr("Units, threads, theme, language, size of the interface, and keys"),
                 {QKeySequence(Qt::CTRL | Qt::Key_Comma)}},
                [this, keys](bool) {
                  auto* dialog = new Preferences(commands_, *keys, units_, cells_->threads(), this);
                  dialog->setAttribute(Qt::WA_DeleteOnClose);
                  dialog->open();
                });
  palette_ = new CommandPalette(this);
  addPaletteSources(*palette_, commands_, document_, file_, recent_, *opening_);
  commands_.add({QStringLiteral("help.palette"),
                 CommandMenu::Help,
                 QStringLiteral("help"),
                 tr("&Find a command..."),
                 tr("Find any command by a few letters"),
                 {QKeySequence(Qt::CTRL | Qt::Key_K)},
                 QStringLiteral("search")},
                [this](bool) { palette_->openUp(); });
  welcome_ = new Welcome(*welcomePage_, *view_, commands_, file_, recent_, *sessions_, *opening_);
  const auto openFile = [this] {
    const QString file = sessions_->path().isEmpty() ? file_.path() : sessions_->path();
    return sessions_->remembering() ? file : QString();
  };
  pictures_ = new RecentPhotographer(*view_, controller_, recent_, openFile, writing_, this);
  connect(pictures_, &RecentPhotographer::changed, welcome_, &Welcome::refresh);
  help_ = new HelpPanel(document_, *filters_);
  host_->panels.add({QStringLiteral("view.help"),
                     tr("Help"),
                     tr("Describes the filter that has the focus"),
                     {QKeySequence(Qt::SHIFT | Qt::Key_F1)},
                     QStringLiteral("help")},
                    help_);
  commands_.add({QStringLiteral("view.resetLayout"), CommandMenu::View, QStringLiteral("layout"),
                 tr("&Reset window layout"), tr("Move all panels and tool bars back to their default places")},
                [this](bool) { layout_->reset(); });
}

// Features are children of the window, in the order of their commands in the menus.
void EditorWindow::createFeatures() {
  const FeatureHost& host = *host_;
  addFilterTools(host, *view_, document_, controller_, *filters_);
  installUnitTools(host);
  auto* environment = new EnvironmentTools(host, *view_, document_, file_, composer_, *import_);
  connect(writer_, &FileWriter::written, environment, &EnvironmentTools::acknowledge);
  look_ = new LevelLook(host, *view_, *overlays_, document_, file_, composer_, controller_);
  bars_->main().addSeparator();
  bars_->main().addWidget(&look_->modes().box());
  camera_ = new CameraTools(host, *view_, *overlays_);
  new PathFeature(host, *view_, document_, file_, controller_);
  new SeedFeature(host, *view_, document_, controller_, *filters_);
  new ParameterHandles(host, *view_, document_, controller_, *filters_);
  new MeasureFeature(host, *view_, file_, composer_, *import_);
  new InspectionFeature(host, *view_, document_, file_, composer_, controller_, *filters_);
  new ObstacleFeatures(host, *view_, document_, file_, composer_, controller_);
  new SkippedFeature(host, *view_, file_, *import_);
  new CompareFeature(host, *view_, *overlays_, document_, file_, controller_);
  new CorridorsFeature(host, *view_, file_, controller_);
  new SideBySide(host, *views_, *view_, document_, file_, composer_, controller_);
  auto* notes = new ParameterNotes(document_, file_, *messages_, this);
  connect(notes, &ParameterNotes::measured, import_,
          [this](const LevelMeasures& measures) { import_->setEvidence(findScale(measures)); });
  connect(notes, &ParameterNotes::settled, look_, &LevelLook::takeNotes);
  connect(notes, &ParameterNotes::scaleChosen, import_, &ImportPanel::chooseScale);
  packed_ = new PackedFeature(host, *statusBar(), *view_, file_);
  exports_ = new ResultExport({.window = *this,
                               .document = document_,
                               .level = file_,
                               .units = units_,
                               .controller = controller_,
                               .view = *view_,
                               .modes = look_->modes(),
                               .legend = overlays_->legend(),
                               .writer = *writer_,
                               .messages = *messages_,
                               .log = log_});
  addExportCommands(commands_, *exports_);
  turntable_ = new TurntableFeature({.window = *this,
                                     .commands = commands_,
                                     .level = file_,
                                     .controller = controller_,
                                     .view = *view_,
                                     .queue = writing_,
                                     .messages = *messages_,
                                     .log = log_,
                                     .status = *status_});
  const Turntable* turntable = &turntable_->turntable();
  connect(turntable, &Turntable::progressed, this, [this](int written, int all) {
    showProgress(tr("Turntable: %1 of %2 frames").arg(written).arg(all), static_cast<double>(written) / all);
  });
  connect(turntable, &Turntable::finished, this, &EditorWindow::hideProgress);
  connect(turntable, &Turntable::stopped, this, &EditorWindow::hideProgress);
  closing_ = new WindowClosing(*this, document_, *sessions_, *exports_, *writer_, *status_);
}

// --- Connections

void EditorWindow::connectLevel() {
  connect(&document_, &Document::filtersChanged, this, [this] {
    messages_->finish(MessageSubject::Filters);
    controller_.setFilters(document_.filters());
  });
  connect(&composer_, &LevelComposer::edited, &controller_, &RunController::editEnvironment);
  connect(&composer_, &LevelComposer::edited, &cells_->watch(), &CellWatch::editEnvironment);
  connect(&composer_.parts(), &PartLevel::failed, this,
          [this](const QString& message) { messages_->showErrorOf(MessageSubject::Level, message); });
  connect(&composer_.parts(), &PartLevel::changed, this, [this] { messages_->finish(MessageSubject::Level); });
  connect(&composer_, &LevelComposer::failed, this, [this](const QString& message) {
    messages_->showErrorOf(MessageSubject::Level, message);
    levelFailed_ = true;
  });
  connect(&composer_, &LevelComposer::edited, this, [this] {
    if (!std::exchange(levelFailed_, false)) messages_->finish(MessageSubject::Level);
  });
  connect(&units_, &UnitChoice::changed, this, &EditorWindow::takeUnits);
  takeUnits();
  connect(document_.undoStack(), &QUndoStack::cleanChanged, this, &EditorWindow::updateTitle);
  connect(sessions_, &SessionFiles::pathChanged, this, &EditorWindow::updateTitle);
  connect(&file_, &LevelFile::opened, this, &EditorWindow::updateTitle);
  connect(view_, &LevelView::failed, messages_, &MessageBar::showError);
  connect(view_, &LevelView::toolChanged, this,
          [this] { status_->say(StatusSubject::Tool, view_->tool() ? view_->tool()->hint() : QString()); });
}

void EditorWindow::connectRuns() {
  connect(&controller_, &RunController::finished, &composer_.parts(), &PartLevel::setComputed);
  for (const auto changed : {&RunController::started, &RunController::statusChanged})
    connect(&controller_, changed, view_, [this] { view_->setComputing(controller_.busy()); });
  for (const auto ended : {&RunController::finished, &RunController::cancelled})
    connect(&controller_, ended, view_, [this] { view_->setComputing(false); });
  connect(&controller_, &RunController::failed, view_, [this] { view_->setComputing(false); });
  connect(&controller_, &RunController::contentReady, this, [this](const ViewContent& content) {
    view_->setContent(content);
    overlays_->legend().describe(content);
    overlays_->update();
  });
  connect(view_, &QOpenGLWidget::frameSwapped, &controller_, [this] {
    controller_.setPictureTime(view_->wholeFrameMs());
    controller_.frameShown();
  });
  connect(&controller_, &RunController::finished, this, [this] {
    hideProgress();
    messages_->finish(MessageSubject::Run);
    exportAction_->setEnabled(true);
    commands_.find(QStringLiteral("file.plan"))->setEnabled(true);
  });
  new ResultSummary(controller_, units_, *status_);
  drawingNote_ = new DrawingNote(controller_, *view_, *status_, this);
  connect(&controller_, &RunController::cancelled, this, [this] {
    hideProgress();
    messages_->finish(MessageSubject::Run);
    status_->setState(tr("Cancelled; the view shows the previous result. Press F5 to run again."));
  });
  connect(&controller_, &RunController::failed, this, [this](const QString& message) {
    hideProgress();
    status_->setState(tr("The run failed; the view shows the previous result"));
    const QString files = exports_->takeWaiting();
    messages_->showErrorOf(MessageSubject::Run,
                           files.isEmpty() ? message : tr("%1. Not written: %2").arg(message, files));
  });
}

void EditorWindow::connectProgress() {
  connect(&file_, &LevelFile::started, this,
          [this](const QString& path) { showProgress(tr("Loading %1").arg(QFileInfo(path).fileName()), -1); });
  connect(&file_, &LevelFile::arrived, this, &EditorWindow::hideProgress);
  connect(&file_, &LevelFile::failed, this, &EditorWindow::hideProgress);
  connect(&file_, &LevelFile::rereadFailed, this, &EditorWindow::hideProgress);
  connect(&file_, &LevelFile::cancelled, this, [this] {
    hideProgress();
    status_->say(StatusSubject::Note, tr("Loading cancelled"));
  });
  connect(&controller_, &RunController::progressed, this, [this](double fraction, const QString& text) {
    std::optional<double> left;
    if (const auto remaining = controller_.remaining())
      left = *remaining == std::chrono::milliseconds::max() ? std::numeric_limits<double>::infinity()
                                                            : std::chrono::duration<double>(*remaining).count();
    showProgress(text, fraction, left);
  });
  connect(writer_, &FileWriter::started, this, [this](const QString& path) {
    writtenName_ = QFileInfo(path).fileName();
    showWriting();
  });
  connect(writer_, &FileWriter::ended, this, [this] {
    if (idle()) hideProgress();
  });
}

void EditorWindow::takeUnits() {
  const LevelUnits& units = units_.units();
  filters_->setUnits(units);
  overlays_->heights().setUnits(units);
  overlays_->legend().setUnits(units);
  document_.setUnits(units);
  import_->setUnits(units);
}

// --- Work under way

void EditorWindow::showProgress(const QString& text, double fraction, std::optional<double> secondsLeft) {
  status_->say(StatusSubject::Work, text);
  progress_->showProgress(fraction, secondsLeft);
  cancel_->show();
}

void EditorWindow::hideProgress() {
  if (writer_ && writer_->busy()) return showWriting();  // an export goes on, and can be cancelled
  status_->end(StatusSubject::Work);
  progress_->finish();
  cancel_->hide();
}

void EditorWindow::showWriting() { showProgress(tr("Writing %1").arg(writtenName_), -1); }

void EditorWindow::cancelWork() {
  if (turntable_->turntable().isRunning()) {
    turntable_->turntable().cancel();
    return;
  }
  file_.cancel();
  if (controller_.busy() || !writer_->busy()) controller_.cancel();
  writer_->cancel();
}

void EditorWindow::updateTitle() {
  QString name = file_.environment() ? QFileInfo(file_.path()).fileName() : tr("no environment");
  if (!sessions_->path().isEmpty()) name += QStringLiteral(" (%1)").arg(QFileInfo(sessions_->path()).fileName());
  setWindowTitle(name + QStringLiteral("[*] - Footfall"));
  setWindowModified(!document_.undoStack()->isClean());
}

void EditorWindow::setRemembering(bool on) {
  sessions_->setRemembering(on);
  exports_->setRemembering(on);
}

bool EditorWindow::idle() const {
  return !file_.busy() && !look_->isFraming() && !controller_.busy() && !composer_.busy() && !packed_->busy() &&
         !writer_->busy() && exports_->waiting().isEmpty() && !turntable_->turntable().isRunning();
}

void EditorWindow::setInteractive(bool on) { camera_->setInteractive(on); }

// --- Events

void EditorWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (!urls.isEmpty() && urls.front().isLocalFile()) event->acceptProposedAction();
}

void EditorWindow::dropEvent(QDropEvent* event) {
  const QString path = event->mimeData()->urls().value(0).toLocalFile();
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  if (path.endsWith(QStringLiteral(".pipeline"), Qt::CaseInsensitive)) {
    openPipeline(path);
  } else {
    openAsking(path);
  }
}

void EditorWindow::closeEvent(QCloseEvent* event) {
  if (!closing_->mayClose()) {
    event->ignore();
    return;
  }
  if (sessions_->remembering()) layout_->save();
  sessions_->close();
  QMainWindow::closeEvent(event);
}

void EditorWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  bars_->shareWidth();
}

void EditorWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && view_) view_->update();  // it draws in its own colours
}

}  // namespace footfall::ui
