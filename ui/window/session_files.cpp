// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/session_files.hpp"

#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <algorithm>
#include <utility>

#include "core/io/export.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/window/file_dialogs.hpp"

namespace footfall::ui {
namespace {

constexpr int kKeepAfterMs = 1000;  // time between the last change and the autosave

}  // namespace

SessionFiles::SessionFiles(const Uses& uses) : QObject(&uses.window), uses_(uses), keeper_(uses.writing, nullptr) {
  keepTimer_.setSingleShot(true);
  keepTimer_.setInterval(kKeepAfterMs);
  connect(&keepTimer_, &QTimer::timeout, this, &SessionFiles::keep);
  for (const auto signal :
       {&Document::filtersChanged, &Document::importChanged, &Document::agentsChanged, &Document::levelChanged})
    connect(&uses_.document, signal, this, &SessionFiles::keepSoon);
  connect(&uses_.sections, &SessionSections::changed, this, &SessionFiles::keepSoon);
  connect(&uses_.view.cameraController(), &CameraController::moved, this, &SessionFiles::keepSoon);
  connect(&keeper_, &SessionKeeper::failed, &uses_.messages, [&messages = uses.messages](const QString& message) {
    messages.showErrorOf(MessageSubject::Keeping, message);
  });
  connect(&keeper_, &SessionKeeper::recovered, &uses_.messages,
          [&messages = uses.messages] { messages.finish(MessageSubject::Keeping); });
}

Session SessionFiles::current() const {
  const DocumentState& state = uses_.document.state();
  Session session;
  if (uses_.level.environment()) session.environment = uses_.level.environment()->source;
  session.import = state.import;
  if (uses_.level.environment()) session.import.keptGridStep = uses_.level.environment()->grid.step;
  session.pipeline = uses_.document.pipeline();
  if (uses_.level.environment()) session.camera = uses_.view.cameraController().pose();
  session.cells = uses_.cells.shown();
  session.agents = state.agents;
  session.agent = state.agent;
  session.partRules = state.partRules;
  session.obstacles = state.obstacles;
  session.sections = uses_.sections.save();
  return session;
}

void SessionFiles::setPath(const QString& path) {
  uses_.writer.setOpenPath(WrittenKind::Session, path);
  emit pathChanged();
}

void SessionFiles::save(const QString& path) {
  if (uses_.writer.refuses(path, WrittenKind::Session)) {
    afterSaving_ = nullptr;
    return;
  }
  // The saved state is that of the file, and only once the file is written.
  const DocumentState written = uses_.document.state();
  const std::string target = toPath(path);
  uses_.writer.write([session = current(), target] { writeFileSafely(target, formatSession(session, target)); }, path,
                     [this, written, path](bool done) {
                       const std::function<void()> next = std::exchange(afterSaving_, nullptr);
                       if (!done) return;
                       if (uses_.document.state() == written) uses_.document.undoStack()->setClean();
                       setPath(path);
                       if (remembering_) uses_.recent.add(path);
                       keep();
                       if (next && !hasUnsavedChanges()) next();
                     });
}

void SessionFiles::saveAgain() {
  if (path().isEmpty())
    askForTarget();
  else
    save(path());
}

void SessionFiles::askForTarget() {
  const QString extension = QLatin1String(kSessionExtension);
  const QString suggested = path().isEmpty() ? suggestedPath(uses_.level, QLatin1Char('.') + extension) : path();
  const auto giveUp = [this] { afterSaving_ = nullptr; };
  QFileDialog* dialog = ui::askForTarget(&uses_.window, tr("Save the session"), tr("Sessions (*.%1)").arg(extension),
                                         suggested, extension, [this, giveUp](const QString& chosen) {
                                           uses_.writer.writeAsking(
                                               chosen, WrittenKind::Session, [this, chosen] { save(chosen); }, giveUp);
                                         });
  connect(dialog, &QFileDialog::rejected, this, giveUp);
}

// --- Unsaved changes

bool SessionFiles::hasUnsavedChanges() const {
  return uses_.level.environment() && !uses_.document.undoStack()->isClean();
}

void SessionFiles::askUnsaved(std::function<void()> next) {
  if (!remembering_ || !hasUnsavedChanges()) {
    next();
    return;
  }
  if (uses_.window.findChild<QMessageBox*>(QStringLiteral("unsavedQuestion"))) return;  // the question is open already
  // The environment's own file never changes.
  const QString level = QFileInfo(uses_.level.path()).fileName();
  const QString question = path().isEmpty()
                               ? tr("Save the changes as a session?")
                               : tr("Save the changes to the session %1?").arg(QFileInfo(path()).fileName());
  auto* box = new QMessageBox(QMessageBox::Question, tr("Unsaved changes"), question,
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &uses_.window);
  box->setObjectName(QStringLiteral("unsavedQuestion"));
  box->setInformativeText(
      tr("Filters, agents, obstacles and settings of %1 have changed, and are lost otherwise. The file %1 itself stays "
         "as it is.")
          .arg(level));
  box->setDefaultButton(QMessageBox::Save);
  box->setAttribute(Qt::WA_DeleteOnClose);
  connect(box, &QMessageBox::buttonClicked, this, [this, box, next = std::move(next)](QAbstractButton* button) {
    switch (box->standardButton(button)) {
      case QMessageBox::Save:
        afterSaving_ = next;
        if (path().isEmpty()) {
          askForTarget();
        } else {
          save(path());
        }
        break;
      case QMessageBox::Discard:
        // Runs later, after the question has closed.
        QMetaObject::invokeMethod(this, next, Qt::QueuedConnection);
        break;
      default:
        break;
    }
  });
  box->open();
}

// --- After a crash, or at the next start

void SessionFiles::keep() {
  if (remembering_ && uses_.level.environment())
    keeper_.keep(current(), path(), hasUnsavedChanges(), uses_.document.history());
}

void SessionFiles::close() {
  if (!remembering_) return;
  keep();
  keeper_.close();
  keepTimer_.stop();  // a change that is saved after this would look like a session that was lost
}

// Offers the newest session first, or that of a file; one click leads to the others.
void SessionFiles::offerRestoring(const QString& path) {
  std::vector<KeptSession> found = keeper_.abandoned();
  if (found.empty()) return;
  const QString file = QFileInfo(path).canonicalFilePath();
  const auto isOfFile = [&file](const KeptSession& kept) {
    return !file.isEmpty() && (QFileInfo(kept.environment).canonicalFilePath() == file ||
                               QFileInfo(kept.session).canonicalFilePath() == file);
  };
  std::ranges::stable_partition(found, isOfFile);
  if (found.size() > 1) {
    offerSeveral(found);
    return;
  }
  const KeptSession kept = found.front();
  const QString level = QFileInfo(kept.environment).fileName();
  const QString name =
      kept.session.isEmpty() ? level : QStringLiteral("%1 (%2)").arg(QFileInfo(kept.session).fileName(), level);
  const QString text = tr("Footfall ended unexpectedly while %1 was open (last change %2). Restore the session?")
                           .arg(name, QLocale().toString(kept.time, QLocale::ShortFormat));
  uses_.messages.showHint(
      text, tr("Restore"), [this, kept] { emit restoreRequested(kept); }, tr("Discard"),
      [this, kept] {
        forget(kept);
        offerRestoring();
      });
}

void SessionFiles::offerSeveral(const std::vector<KeptSession>& found) {
  const KeptSession& first = found.front();
  const QString text =
      tr("Footfall ended unexpectedly, and %1 sessions were not closed. Restore %2 (last change %3)?")
          .arg(found.size())
          .arg(QFileInfo(first.environment).fileName(), QLocale().toString(first.time, QLocale::ShortFormat));
  uses_.messages.showHint(
      text, tr("Restore"), [this, first] { emit restoreRequested(first); }, tr("Others..."), [this] { chooseLost(); });
}

void SessionFiles::chooseLost() {
  auto* menu = new QMenu(&uses_.window);
  menu->setObjectName(QStringLiteral("lostSessions"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (const KeptSession& kept : keeper_.abandoned()) {
    const QString name =
        tr("%1, last change %2")
            .arg(QFileInfo(kept.environment).fileName(), QLocale().toString(kept.time, QLocale::ShortFormat));
    QMenu* choices = menu->addMenu(name);
    connect(choices->addAction(tr("Restore")), &QAction::triggered, this,
            [this, kept] { emit restoreRequested(kept); });
    connect(choices->addAction(tr("Discard")), &QAction::triggered, this, [this, kept] {
      forget(kept);
      uses_.messages.clear();
      offerRestoring();
    });
  }
  menu->popup(uses_.messages.mapToGlobal(uses_.messages.rect().bottomLeft()));
}

}  // namespace footfall::ui
