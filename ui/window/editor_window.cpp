// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/editor_window.hpp"

#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QMimeData>
#include <chrono>
#include <limits>

#include "ui/base/core_text.hpp"
#include "ui/base/number_text.hpp"
#include "ui/document/agent_rules.hpp"
#include "ui/window/welcome_page.hpp"

namespace footfall::ui {
namespace {

constexpr int kKeepAfterMs = 1000;  // between the last change and writing the session that survives a crash

std::string toPath(const QString& path) { return QFile::encodeName(path).toStdString(); }
QString fromPath(const std::string& path) { return QFile::decodeName(QByteArray::fromStdString(path)); }

QString counted(std::uint64_t count, const QString& one, const QString& many) {
  return countText(count) + QLatin1Char(' ') + (count == 1 ? one : many);
}

}  // namespace

EditorWindow::EditorWindow(QWidget* parent) : QMainWindow(parent) {
  setAcceptDrops(true);
  setObjectName(QStringLiteral("editorWindow"));
  createWidgets();
  createCellWidgets();
  createActions();
  connectParts();
  connectCells();
  createComforts();
  createFeatures();
  finishLayout();
  keepTimer_.setSingleShot(true);
  keepTimer_.setInterval(kKeepAfterMs);
  connect(&keepTimer_, &QTimer::timeout, this, &EditorWindow::keepSession);
  updateTitle();
  hideProgress();
}

EditorWindow::~EditorWindow() {
  view_->setTool(nullptr);
  // What looks at cells goes before them, and says nothing about it.
  cellsAction_->disconnect(this);
  loadDock_->toggleViewAction()->disconnect(this);
  delete cellWatch_;
  delete cellLegend_;
  delete loadDock_;
  // Docks tell that they go when the window itself is gone. Only this signal: styles listen to others of theirs.
  for (QDockWidget* dock : findChildren<QDockWidget*>())
    disconnect(dock, &QDockWidget::visibilityChanged, nullptr, nullptr);
  // The parts outlive the widgets that listen to them.
  document_.disconnect();
  document_.undoStack()->disconnect();
  controller_.disconnect();
  composer_.disconnect();
  composer_.parts().disconnect();
  loader_.disconnect();
}

void EditorWindow::connectParts() {
  connect(&document_, &Document::filtersChanged, this, [this] {
    messages_->finish(MessageSubject::Filters);
    controller_.setFilters(document_.filters());
    keepTimer_.start();
  });
  connect(&document_, &Document::importChanged, this, &EditorWindow::applyImport);
  for (const auto signal : {&Document::agentsChanged, &Document::levelChanged})
    connect(&document_, signal, this, &EditorWindow::keepSoon);
  connect(&composer_, &LevelComposer::edited, &controller_, &RunController::editEnvironment);
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
  connect(&controller_, &RunController::finished, &composer_.parts(), &PartLevel::setComputed);
  connect(document_.undoStack(), &QUndoStack::cleanChanged, this, &EditorWindow::updateTitle);
  // Who works on has not closed.
  connect(document_.undoStack(), &QUndoStack::indexChanged, this, [this] { closing_ = closeWhenWritten_ = false; });
  connect(import_, &ImportPanel::optionsEdited, this, &EditorWindow::editImport);
  connect(&units_, &UnitChoice::changed, this, &EditorWindow::takeUnits);
  takeUnits();
  connect(&recent_, &RecentFiles::chosen, this, &EditorWindow::openAsking);
  connect(cancel_, &QPushButton::clicked, this, &EditorWindow::cancelWork);
  connect(legend_, &Legend::partsChanged, view_, &LevelView::setParts);
  connect(view_, &LevelView::cameraMoved, this, [this] { keepTimer_.start(); });
  connect(view_, &LevelView::failed, messages_, &MessageBar::showError);
  connect(view_, &LevelView::toolChanged, this,
          [this] { say(view_->tool() ? view_->tool()->hint() : QString(), StatusSubject::Tool); });

  connect(&loader_, &EnvironmentLoader::started, this,
          [this](const QString& path) { showProgress(tr("Loading %1").arg(QFileInfo(path).fileName()), -1); });
  connect(&loader_, &EnvironmentLoader::loaded, this, &EditorWindow::takeLoaded);
  connect(&loader_, &EnvironmentLoader::cancelled, this, [this] {
    opening_.reset();
    hideProgress();
    say(tr("Loading cancelled"));
  });
  connect(&loader_, &EnvironmentLoader::failed, this, [this](const QString& message) {
    const bool reread = opening_ && opening_->reread;
    opening_.reset();
    hideProgress();
    if (reread) {
      emit rereadFailed(message);
      return;
    }
    messages_->showErrorOf(MessageSubject::Opening, message);
    emit loadFailed(message);
  });

  connect(&controller_, &RunController::progressed, this, [this](double fraction, const QString& text) {
    std::optional<double> left;
    if (const auto remaining = controller_.remaining())
      left = *remaining == std::chrono::milliseconds::max() ? std::numeric_limits<double>::infinity()
                                                            : std::chrono::duration<double>(*remaining).count();
    showProgress(text, fraction, left);
  });
  connect(&controller_, &RunController::contentReady, this, [this](const ViewContent& content) {
    view_->setContent(content);
    legend_->describe(content);
    placeOverlays();
  });
  connect(view_, &QOpenGLWidget::frameSwapped, &controller_, [this] {
    controller_.setPictureTime(view_->wholeFrameMs());
    controller_.frameShown();
  });
  connect(&controller_, &RunController::finished, this, &EditorWindow::showResult);
  connect(&controller_, &RunController::cancelled, this, [this] {
    hideProgress();
    messages_->finish(MessageSubject::Run);
    summary_->setState(tr("Cancelled; the view shows the result before. Press F5 to run again."));
    const QString dropped = dropPendingExports();
    if (!dropped.isEmpty())
      messages_->showErrorOf(MessageSubject::Writing,
                             tr("%1: not written, as the run was cancelled; export again").arg(dropped));
  });
  connect(&controller_, &RunController::failed, this, [this](const QString& message) {
    hideProgress();
    summary_->setState(tr("The run failed; the view shows the result before"));
    const QString dropped = dropPendingExports();
    messages_->showErrorOf(MessageSubject::Run,
                           dropped.isEmpty() ? message : tr("%1. Not written: %2").arg(message, dropped));
  });
}

// --- Opening
// ----------------------------------------------------------------------------------------------------------

void EditorWindow::open(const QString& path) { openWith(path, std::nullopt, {}); }

void EditorWindow::openAsking(const QString& path) {
  askUnsaved([this, path] { open(path); });
}

void EditorWindow::openWith(const QString& path, const std::optional<Pipeline>& pipeline, const ImportOptions& import) {
  openFile(path, pipeline, import, {});
}

void EditorWindow::openFile(const QString& path, const std::optional<Pipeline>& pipeline, const ImportOptions& import,
                            const std::optional<KeptSession>& kept) {
  Opening opening;
  opening.path = path;
  opening.pipeline = pipeline;
  opening.import = import;
  try {
    if (isSessionFile(toPath(path))) {
      const Session session = readSession(toPath(path));
      if (session.environment.empty()) {
        if (!loaded_.environment) {
          throw InputError(FOOTFALL_TEXT("%1: names no environment; open one first, this session brings only filters"),
                           toPath(path));
        }
        messages_->finish(MessageSubject::Opening);
        document_.replacePipeline(session.pipeline, tr("Open %1").arg(QFileInfo(path).fileName()));
        return;
      }
      opening.path = fromPath(session.environment);
      if (!pipeline) opening.pipeline = session.pipeline;
      opening.import = session.import;
      opening.camera = session.camera;
      opening.session = path;
      opening.cells = session.cells;
      opening.rest.agents = session.agents;
      opening.rest.agent = session.agent;
      opening.rest.partRules = session.partRules;
      opening.rest.obstacles = session.obstacles;
      opening.sections = session.sections;
      if (kept) {
        opening.session = kept->session;
        opening.unsaved = kept->unsaved;
        opening.kept = kept;
      }
      if (import.up) opening.import.up = import.up;
      if (import.metresPerUnit) opening.import.metresPerUnit = import.metresPerUnit;
    }
  } catch (const std::exception& error) {
    const QString message = coreText(error);
    messages_->showErrorOf(MessageSubject::Opening, message);
    emit loadFailed(message);
    return;
  }
  startLoading(std::move(opening));
}

void EditorWindow::startLoading(Opening opening) {
  messages_->finish(MessageSubject::Opening);
  opening_ = std::move(opening);
  loader_.load(opening_->path, opening_->import);
}

void EditorWindow::reread() {
  if (!loaded_.environment || loader_.busy()) return;
  Opening opening;
  opening.path = fromPath(loaded_.environment->source);
  opening.import = document_.state().import;
  opening.reload = opening.reread = true;
  opening_ = std::move(opening);
  loader_.load(opening_->path, opening_->import, loaded_.geometry->centre);
}

void EditorWindow::takeReread(const LoadedEnvironment& loaded) {
  loaded_ = loaded;
  keepFileScale(loaded);
  const Vec3 &lower = loaded.geometry->lower, &upper = loaded.geometry->upper;
  import_->setEnvironment(loaded.environment.get(), {upper.x - lower.x, upper.y - lower.y, upper.z - lower.z},
                          loaded.options.metresPerUnit.has_value());
  units_.setLevel(*loaded.environment);
  composer_.replaceLoaded(loaded.environment);
  emit rereadDone();
}

void EditorWindow::takeLoaded(const LoadedEnvironment& loaded) {
  if (opening_ && opening_->reread) {
    opening_.reset();
    hideProgress();
    takeReread(loaded);
    return;
  }
  const Opening opening = std::exchange(opening_, std::nullopt).value_or(Opening{});
  const std::shared_ptr<const Environment> before = loaded_.environment;
  const Environment& environment = *loaded.environment;
  const QString dropped = opening.reload ? QString() : dropPendingExports();
  hideProgress();
  if (!opening.reload) {
    messages_->clear();
    summary_->setState({});
  }
  loaded_ = loaded;
  if (!opening.reload) fileScale_.reset();
  keepFileScale(loaded);
  const Vec3& upper = loaded.geometry->upper;
  import_->setEnvironment(&environment, {2 * upper.x, 2 * upper.y, 2 * upper.z},
                          loaded.options.metresPerUnit.has_value());
  units_.setLevel(environment);
  view_->setEnvironment(loaded.geometry, !opening.reload || before->up != environment.up);
  legend_->describe({});
  showWelcome(false);

  if (!opening.reload) {
    // A pipeline that somebody has worked on is worth more than defaults.
    const bool own = before && !(document_.pipeline() == defaultPipeline(*before));
    const Pipeline pipeline =
        opening.pipeline ? *opening.pipeline
        : own            ? rescaleLengths(document_.pipeline(), before->metresPerUnit, environment.metresPerUnit)
                         : defaultPipeline(environment);
    composer_.setLoaded(nullptr);  // the document is that of the new level from here on
    document_.reset(pipeline, opening.import, opening.rest);
    sessionPath_ = opening.session;
    if (opening.unsaved) document_.undoStack()->resetClean();
    if (opening.camera) view_->setCameraPose(*opening.camera);
    if (opening.cells) setCellsShown(*opening.cells);
    if (opening.sections) loadSections(*opening.sections);
    if (!opening.pipeline && own) {
      messages_->showHint(tr("Your filters were kept for this environment."), tr("Use default filters"),
                          [this] { useDefaultFilters(); });
      messages_->setSubject(MessageSubject::Filters);
    }
    if (remembering_) recent_.add(opening.session.isEmpty() ? opening.path : opening.session);
    if (opening.kept) {
      keepSession();  // before what was restored is given up
      keeper_.forget(*opening.kept);
    }
  }
  composer_.setLoaded(loaded.environment, loaded.geometry);
  cellWatch_->setEnvironment(composer_.level(), loaded.geometry->centre);
  controller_.setEnvironment(composer_.level(), loaded.geometry->centre);
  chooseLegend();
  heights_->show();
  placeOverlays();
  updateTitle();
  keepTimer_.start();
  if (!dropped.isEmpty())
    messages_->showErrorOf(
        MessageSubject::Writing,
        tr("%1: not written, as another environment was opened; open the one before and export again").arg(dropped));
  emit environmentLoaded();
}

void EditorWindow::openPipeline(const QString& path) {
  try {
    document_.replacePipeline(readPipelineFile(toPath(path)), tr("Open %1").arg(QFileInfo(path).fileName()));
    pipelinePath_ = path;
    messages_->finish(MessageSubject::Opening);
  } catch (const std::exception& error) {
    messages_->showErrorOf(MessageSubject::Opening, coreText(error));
  }
}

void EditorWindow::useDefaultFilters() {
  if (loaded_.environment) document_.replacePipeline(defaultPipeline(*loaded_.environment), tr("Use default filters"));
}

// --- Import options
// ---------------------------------------------------------------------------------------------------

void EditorWindow::editImport(const ImportOptions& options) {
  if (!loaded_.environment) return;
  Pipeline pipeline = document_.pipeline();
  std::optional<std::vector<NamedAgent>> agents;
  QString mergeKey;
  if (options.metresPerUnit && options.metresPerUnit != document_.state().import.metresPerUnit) {
    if (import_->scaleField()->hasFocus())
      mergeKey = QStringLiteral("scale/%1").arg(import_->scaleField()->editSession());
    // What is typed passes through other numbers: all of them start from what was there before.
    if (mergeKey.isEmpty() || !scaleEdit_ || scaleEdit_->key != mergeKey)
      scaleEdit_ = ScaleEdit{mergeKey, pipeline, document_.state().agents, loaded_.environment->metresPerUnit,
                             loaded_.environment->scaleGuessed};
    const double scale = *options.metresPerUnit;
    // What was typed while the unit was a guess was typed in the file's units, and stays.
    pipeline = scaleEdit_->guessed ? rescaleDefaults(scaleEdit_->pipeline, scaleEdit_->scale, scale)
                                   : rescaleLengths(scaleEdit_->pipeline, scaleEdit_->scale, scale);
    agents = rescaledAgents(scaleEdit_->agents, scaleEdit_->scale, scale);
  }
  document_.setImportAndPipeline(options, pipeline, tr("Change import options"), mergeKey, agents);
}

// What was given instead says nothing about the file.
void EditorWindow::keepFileScale(const LoadedEnvironment& loaded) {
  if (loaded.options.metresPerUnit) return;
  fileScale_ = loaded.environment->metresPerUnit;
  fileScaleGuessed_ = loaded.environment->scaleGuessed;
}

// The document's options have changed, by an edit or by undo: read the file again where that makes a difference.
void EditorWindow::applyImport() {
  const ImportOptions& options = document_.state().import;
  import_->setOptions(options);
  keepTimer_.start();
  if (!loaded_.environment || opening_) {
    if (!opening_ || !opening_->reload) return;  // a new file brings its own
  }
  const bool sameMesh = options.up == loaded_.options.up && options.bothSides == loaded_.options.bothSides;
  const std::optional<double> scale = options.metresPerUnit ? options.metresPerUnit : fileScale_;
  if (sameMesh && scale && !loader_.busy()) {
    // The scale changes no coordinate, so nothing is computed again.
    auto rescaled = std::make_shared<Environment>(*loaded_.environment);
    rescaled->metresPerUnit = *scale;
    rescaled->scaleGuessed = !options.metresPerUnit && fileScaleGuessed_;
    loaded_.environment = std::move(rescaled);
    loaded_.options = options;
    units_.setLevel(*loaded_.environment);
    return;
  }
  Opening opening;
  opening.path = fromPath(loaded_.environment->source);
  opening.import = options;
  opening.reload = true;
  startLoading(std::move(opening));
}

// --- Showing
// ----------------------------------------------------------------------------------------------------------

void EditorWindow::showResult() {
  hideProgress();
  messages_->finish(MessageSubject::Run);
  showSummary();
  exportAction_->setEnabled(true);
  // Later, when all have heard of the result: pictures are of what they make of it.
  QMetaObject::invokeMethod(this, &EditorWindow::writePendingExports, Qt::QueuedConnection);
}

void EditorWindow::showSummary() {
  const auto run = controller_.finishedRun();
  const StateSummary& summary = run->result.summary;
  const NavigationMesh& mesh = *run->result.mesh;
  QStringList parts{counted(mesh.triangles.size(), tr("walkable triangle"), tr("walkable triangles")),
                    tr("area %1").arg(units_.units().area(summary.area))};
  if (mesh.layerCount > 0) {
    parts << counted(mesh.layerCount, tr("layer"), tr("layers"))
          << counted(mesh.connections.size(), tr("connection"), tr("connections"));
  }
  parts << counted(mesh.obstacleEdges.size(), tr("obstacle edge"), tr("obstacle edges"))
        << tr("%1 ms").arg(fixedText(run->result.totalMs, 0));
  resultText_ = parts.join(QStringLiteral("   ·   "));
  summary_->setState(resultText_, parts.join(QLatin1Char('\n')));
}

void EditorWindow::takeUnits() {
  const LevelUnits& units = units_.units();
  filters_->setUnits(units);
  heights_->setUnits(units);
  legend_->setUnits(units);
  cells_.setUnits(units);
  document_.setUnits(units);
  import_->setUnits(units);
  if (controller_.finishedRun() && summary_->state() == resultText_) showSummary();
}

void EditorWindow::say(const QString& text, StatusSubject subject) { summary_->say(subject, text); }

void EditorWindow::showProgress(const QString& text, double fraction, std::optional<double> secondsLeft) {
  summary_->say(StatusSubject::Work, text);
  progress_->showProgress(fraction, secondsLeft);
  cancel_->show();
}

void EditorWindow::hideProgress() {
  summary_->end(StatusSubject::Work);
  progress_->finish();
  cancel_->hide();
}

void EditorWindow::cancelWork() {
  if (loader_.busy()) loader_.cancel();
  controller_.cancel();
}

void EditorWindow::updateTitle() {
  QString name = tr("no environment");
  if (loaded_.environment) name = QFileInfo(fromPath(loaded_.environment->source)).fileName();
  if (!sessionPath_.isEmpty()) name += QStringLiteral(" (%1)").arg(QFileInfo(sessionPath_).fileName());
  setWindowTitle(name + QStringLiteral("[*] - Footfall"));
  setWindowModified(!document_.undoStack()->isClean());
}

void EditorWindow::setInteractive(bool on) {
  interactive_ = on;
  const QAction* smooth = commands_.find(QStringLiteral("view.animate"));
  view_->setAnimated(on && smooth && smooth->isChecked());
}

void EditorWindow::placeOverlays() {
  overlays_.legend = legend_;
  overlays_.heights = heights_;
  overlays_.cells = cellLegend_;
  overlays_.place(view_->size());
  view_->setCovered(overlays_.covered());
  welcome_->setGeometry(view_->rect());
  if (!welcome_->isHidden()) welcome_->raise();
}

bool EditorWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::Resize) placeOverlays();
  return QMainWindow::eventFilter(watched, event);
}

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

}  // namespace footfall::ui
