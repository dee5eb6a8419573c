// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/level_opening.hpp"

#include <QFileInfo>
#include <utility>

#include "core/io/import.hpp"
#include "footfall/errors.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/work/guarded_application.hpp"
#include "ui/window/file_dialogs.hpp"
#include "ui/window/session.hpp"

namespace footfall::ui {

LevelOpening::LevelOpening(const Uses& uses) : QObject(&uses.window), uses_(uses) {
  connect(&uses_.file, &LevelFile::started, this, [this] {
    const Reading reading = uses_.file.reading();
    if (reading != Reading::Again && reading != Reading::OtherPart) uses_.messages.finish(MessageSubject::Opening);
  });
  connect(&uses_.file, &LevelFile::arrived, this, &LevelOpening::take);
  connect(&uses_.file, &LevelFile::failed, &uses_.messages, [&messages = uses.messages](const QString& message) {
    messages.showErrorOf(MessageSubject::Opening, message);
  });
  connect(
      &uses_.sections, &SessionSections::failed, &uses_.messages,
      [&messages = uses.messages](const QString& message) { messages.showErrorOf(MessageSubject::Opening, message); });
  connect(&uses_.recent, &RecentFiles::chosen, this, &LevelOpening::openAsking);
  connect(&uses_.sessions, &SessionFiles::restoreRequested, this, &LevelOpening::openKept);
}

void LevelOpening::open(const QString& path, const std::optional<Pipeline>& pipeline, const ImportOptions& import) {
  openFile({.path = path, .pipeline = pipeline, .import = import}, {});
}

void LevelOpening::openAsking(const QString& path) {
  uses_.sessions.askUnsaved([this, path] { open(path); });
}

void LevelOpening::openKept(const KeptSession& kept) {
  uses_.sessions.askUnsaved([this, kept] { openFile({.path = kept.path}, kept); });
}

void LevelOpening::continueLastSession() {
  if (const auto last = uses_.sessions.lastSession()) openKept(*last);
}

void LevelOpening::openSample(const QString& path, const QString& pipeline) {
  uses_.sessions.askUnsaved([this, path, pipeline] {
    try {
      std::optional<Pipeline> filters;
      if (!pipeline.isEmpty()) filters = readPipelineFile(toPath(pipeline));
      open(path, filters);
    } catch (const std::exception& error) {
      uses_.messages.showErrorOf(MessageSubject::Opening, errorText(error));
    }
  });
}

void LevelOpening::askForFile() {
  QStringList patterns;
  for (const std::string& extension : importableExtensions())
    patterns << QStringLiteral("*.") + QString::fromStdString(extension);
  patterns << QStringLiteral("*.") + QLatin1String(kSessionExtension);
  const QString filter = tr("Environments and sessions (%1)").arg(patterns.join(QLatin1Char(' '))) +
                         QStringLiteral(";;") + tr("All files (*)");
  ui::askForFile(&uses_.window, tr("Open an environment or a session"), filter, suggestedPath(uses_.file),
                 [this](const QString& path) { openAsking(path); });
}

void LevelOpening::openFile(Opening opening, const std::optional<KeptSession>& kept) {
  try {
    if (isSessionFile(toPath(opening.path)) && !readSessionInto(opening, kept)) return;
  } catch (const std::exception& error) {
    const QString message = coreText(error);
    uses_.messages.showErrorOf(MessageSubject::Opening, message);
    emit failed(message);
    return;
  }
  opening_ = std::move(opening);
  uses_.file.open(opening_.path, opening_.import);
}

bool LevelOpening::readSessionInto(Opening& opening, const std::optional<KeptSession>& kept) {
  const QString path = opening.path;
  Session session = readSession(toPath(path));
  if (session.environment.empty()) {
    if (!uses_.file.environment()) {
      throw InputError(FOOTFALL_TEXT("%1: names no environment; open one first, this session brings only filters"),
                       toPath(path));
    }
    uses_.messages.finish(MessageSubject::Opening);
    uses_.document.replacePipeline(session.pipeline, tr("Open %1").arg(QFileInfo(path).fileName()));
    return false;
  }
  opening.path = fromPath(session.environment);
  if (!opening.pipeline) opening.pipeline = session.pipeline;
  if (!opening.import.up) opening.import.up = session.import.up;
  if (!opening.import.metresPerUnit) opening.import.metresPerUnit = session.import.metresPerUnit;
  opening.import.bothSides = session.import.bothSides;
  if (opening.import.grid == GridChoice::Auto) {
    opening.import.grid = session.import.grid;
    opening.import.gridStep = session.import.gridStep;
    opening.import.keptGridStep = session.import.keptGridStep;
  }
  opening.camera = session.camera;
  opening.session = path;
  opening.cells = session.cells;
  opening.rest.agents = std::move(session.agents);
  opening.rest.agent = session.agent;
  opening.rest.partRules = std::move(session.partRules);
  opening.rest.obstacles = std::move(session.obstacles);
  opening.sections = std::move(session.sections);
  if (kept) {
    opening.session = kept->session;
    opening.unsaved = kept->unsaved;
    opening.kept = kept;
  }
  return true;
}

void LevelOpening::take(Reading reading, const std::shared_ptr<const Environment>& before) {
  // The document's options may rescale the file's level during this call.
  const LoadedEnvironment loaded = uses_.file.loaded();
  if (reading == Reading::Again) {
    uses_.composer.replaceLoaded(loaded.environment, loaded.geometry->whole);
    return;
  }
  const bool isAnother = reading == Reading::Another;
  if (isAnother) {
    uses_.messages.clear();
    uses_.status.setState({});
  }
  const CameraPose pose = uses_.view.cameraController().pose();
  uses_.view.setEnvironment(loaded.geometry, isAnother || before->up != loaded.environment->up);
  if (reading == Reading::OtherPart) uses_.view.cameraController().setPose(pose);  // with its pivot
  uses_.layout.legend().describe({});
  if (isAnother) takeDocument(before, *loaded.environment);
  uses_.composer.setLoaded(loaded.environment, loaded.geometry);
  uses_.cells.watch().setEnvironment(uses_.composer.level(), loaded.geometry->centre);
  uses_.controller.setEnvironment(uses_.composer.level(), loaded.geometry->centre);
  uses_.layout.heights().show();
  uses_.layout.update();
  uses_.sessions.keepSoon();
}

void LevelOpening::takeDocument(const std::shared_ptr<const Environment>& before, const Environment& level) {
  const Opening opening = std::exchange(opening_, {});
  // A pipeline that the user has edited is kept instead of the defaults.
  const bool own = before && !(uses_.document.pipeline() == defaultPipeline(*before));
  const Pipeline pipeline = opening.pipeline ? *opening.pipeline
                            : own
                                ? rescaleLengths(uses_.document.pipeline(), before->metresPerUnit, level.metresPerUnit)
                                : defaultPipeline(level);
  // From here on, the document and the place to run belong to the new level; nothing of them may run on the old one.
  uses_.composer.setLoaded(nullptr);
  uses_.cells.watch().setEnvironment(nullptr, {});
  uses_.controller.setEnvironment(nullptr, {});
  uses_.document.reset(pipeline, opening.import, opening.rest);
  uses_.sessions.setPath(opening.session);
  if (opening.unsaved) uses_.document.undoStack()->resetClean();
  if (opening.kept && opening.kept->history) uses_.document.restoreHistory(*opening.kept->history);
  if (opening.camera) uses_.view.cameraController().setPose(*opening.camera);
  if (opening.cells) uses_.cells.setShown(*opening.cells);
  if (opening.sections)
    uses_.sections.load(*opening.sections);
  else
    uses_.cells.places().forgetSuggestion();
  if (!opening.pipeline && own) {
    uses_.messages.showHint(tr("Your filters were kept for this environment."), tr("Use default filters"),
                            [this] { useDefaultFilters(); });
    uses_.messages.setSubject(MessageSubject::Filters);
  }
  if (uses_.sessions.remembering()) uses_.recent.add(opening.session.isEmpty() ? opening.path : opening.session);
  if (opening.kept) {
    uses_.sessions.keep();  // saved before the restored session is given up
    uses_.sessions.forget(*opening.kept);
    uses_.sessions.offerRestoring();  // offers an older one
  }
}

void LevelOpening::useDefaultFilters() {
  if (uses_.file.environment())
    uses_.document.replacePipeline(defaultPipeline(*uses_.file.environment()), tr("Use default filters"));
}

}  // namespace footfall::ui
