// The window's files: writing, sessions that are kept, and what has not been saved.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCloseEvent>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <utility>

#include "core/io/export.hpp"
#include "core/io/write_targets.hpp"
#include "ui/base/core_text.hpp"
#include "ui/base/guarded_application.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/window/editor_window.hpp"
#include "ui/window/replace_question.hpp"

namespace footfall::ui {
namespace {

std::string toPath(const QString& path) { return QFile::encodeName(path).toStdString(); }
QString fromPath(const std::string& path) { return QFile::decodeName(QByteArray::fromStdString(path)); }

}  // namespace

void EditorWindow::writeInBackground(std::function<void()> write, const QString& path, std::function<void(bool)> then) {
  ++exports_;
  messages_->finish(MessageSubject::Writing);
  showProgress(tr("Writing %1").arg(QFileInfo(path).fileName()), -1);
  writing_.post([this, write = std::move(write), then = std::move(then), path] {
    const QString error = errorOf(write);
    QMetaObject::invokeMethod(
        this,
        [this, error, path, then] {
          --exports_;
          if (idle()) hideProgress();
          if (error.isEmpty()) {
            messages_->finish(MessageSubject::Writing);
            say(tr("Wrote %1").arg(path));
            log_.add(MessageLevel::Note, tr("Wrote %1").arg(path));
          } else {
            messages_->showErrorOf(MessageSubject::Writing, error);
          }
          if (then) then(error.isEmpty());
          if (error.isEmpty()) emit written(path);
          closeIfWritten(error.isEmpty());
        },
        Qt::QueuedConnection);
  });
}

// --- What must not be written over

QString EditorWindow::refusal(const QString& path, WrittenKind kind) const {
  WriteTargets targets;
  if (loaded_.environment) targets.protectEnvironment(loaded_.environment->source, loaded_.companions);
  if (opening_) targets.protectEnvironment(toPath(opening_->path));
  if (kind != WrittenKind::Session) targets.protect(toPath(sessionPath_), FOOTFALL_TEXT("the session that is open"));
  if (kind != WrittenKind::Pipeline) targets.protect(toPath(pipelinePath_), FOOTFALL_TEXT("the pipeline that is open"));
  return errorOf([&] { targets.check(toPath(path)); });
}

void EditorWindow::writeAsking(const QString& path, WrittenKind kind, std::function<void()> write,
                               std::function<void()> keep) {
  const QString why = refusal(path, kind);
  if (!why.isEmpty()) {
    messages_->showErrorOf(MessageSubject::Writing, why);
    if (keep) keep();
    return;
  }
  const QString own = kind == WrittenKind::Session    ? sessionPath_
                      : kind == WrittenKind::Pipeline ? pipelinePath_
                                                      : QString();
  if (sameFile(toPath(path), toPath(own))) {
    write();
  } else {
    askReplacing(this, path, std::move(write), std::move(keep));
  }
}

void EditorWindow::savePipeline(const QString& path) {
  const QString why = refusal(path, WrittenKind::Pipeline);
  if (!why.isEmpty()) {
    messages_->showErrorOf(MessageSubject::Writing, why);
    return;
  }
  writeInBackground(
      [text = formatPipeline(document_.pipeline()), target = toPath(path)] { writeFileSafely(target, text); }, path,
      [this, path](bool done) {
        if (done) pipelinePath_ = path;
      });
}

// --- Sessions

Session EditorWindow::currentSession() const {
  Session session;
  if (loaded_.environment) session.environment = loaded_.environment->source;
  session.import = document_.state().import;
  session.pipeline = document_.pipeline();
  if (loaded_.environment) session.camera = view_->cameraPose();
  session.cells = cellsShown();
  session.agents = document_.state().agents;
  session.agent = document_.state().agent;
  session.partRules = document_.state().partRules;
  session.obstacles = document_.state().obstacles;
  for (const SessionSection& section : sections_) session.sections[section.name.toStdString()] = section.save();
  return session;
}

void EditorWindow::addSessionSection(SessionSection section) { sections_.push_back(std::move(section)); }

void EditorWindow::loadSections(const std::map<std::string, std::string>& sections) {
  for (const SessionSection& section : sections_) {
    const auto found = sections.find(section.name.toStdString());
    try {
      section.load(found == sections.end() ? std::string() : found->second);
    } catch (const std::exception& error) {
      messages_->showErrorOf(MessageSubject::Opening,
                             tr("session, '%1': %2; this part was left out").arg(section.name, coreText(error)));
    }
  }
}

void EditorWindow::saveSession(const QString& path) {
  const QString why = refusal(path, WrittenKind::Session);
  if (!why.isEmpty()) {
    messages_->showErrorOf(MessageSubject::Writing, why);
    afterSaving_ = nullptr;
    return;
  }
  // Saved is what the file got, and only once it has it.
  const DocumentState written = document_.state();
  const std::string target = toPath(path);
  writeInBackground([session = currentSession(), target] { writeFileSafely(target, formatSession(session, target)); },
                    path,
                    [this, written, path](bool done) {
                      const std::function<void()> next = std::exchange(afterSaving_, nullptr);
                      if (!done) return;
                      sessionPath_ = path;
                      if (document_.state() == written) document_.undoStack()->setClean();
                      updateTitle();
                      if (remembering_) recent_.add(path);
                      keepSession();
                      if (next && !hasUnsavedChanges()) next();
                    });
}

void EditorWindow::keepSession() {
  if (remembering_ && loaded_.environment) keeper_.keep(currentSession(), sessionPath_, hasUnsavedChanges());
}

// --- What is not saved yet

bool EditorWindow::hasUnsavedChanges() { return loaded_.environment && !document_.undoStack()->isClean(); }

void EditorWindow::askUnsaved(std::function<void()> next) {
  if (!remembering_ || !hasUnsavedChanges()) {
    next();
    return;
  }
  if (findChild<QMessageBox*>(QStringLiteral("unsavedQuestion"))) return;  // asked already
  // The environment's own file never changes.
  const QString level = QFileInfo(fromPath(loaded_.environment->source)).fileName();
  const QString question = sessionPath_.isEmpty()
                               ? tr("Save the changes as a session?")
                               : tr("Save the changes to the session %1?").arg(QFileInfo(sessionPath_).fileName());
  auto* box = new QMessageBox(QMessageBox::Question, tr("Unsaved changes"), question,
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
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
        if (sessionPath_.isEmpty()) {
          saveSessionDialog();
        } else {
          saveSession(sessionPath_);
        }
        break;
      case QMessageBox::Discard:
        // Later, when the question is gone.
        QMetaObject::invokeMethod(this, next, Qt::QueuedConnection);
        break;
      default:
        break;
    }
  });
  box->open();
}

void EditorWindow::closeEvent(QCloseEvent* event) {
  if (!closing_ && remembering_ && hasUnsavedChanges()) {
    event->ignore();
    askUnsaved([this] {
      closing_ = true;
      close();
    });
    return;
  }
  if (closesLater()) {
    event->ignore();
    return;
  }
  if (remembering_) {
    keepSession();
    keeper_.close();
    saveLayout();
  }
  QMainWindow::closeEvent(event);
}

// --- What is not written yet

// Nobody would be told what goes wrong with a file after the window is gone. Returns whether closing has to wait.
bool EditorWindow::closesLater() {
  if (closeWhenWritten_ || (exports_ == 0 && pendingExports_.empty())) return false;  // asked twice: at once
  if (pendingExports_.empty()) {
    closeWhenWritten_ = true;
    say(tr("Closes when the file is written; close again to close at once"));
    return true;
  }
  if (findChild<QMessageBox*>(QStringLiteral("pendingQuestion"))) return true;
  auto* box = new QMessageBox(QMessageBox::Question, tr("Not written yet"),
                              tr("%1 waits for the run.").arg(QFileInfo(pendingExports_.front().first).fileName()),
                              QMessageBox::Cancel, this);
  box->setObjectName(QStringLiteral("pendingQuestion"));
  QPushButton* wait = box->addButton(tr("&Write, then close"), QMessageBox::AcceptRole);
  QPushButton* leave = box->addButton(tr("Close &without it"), QMessageBox::DestructiveRole);
  box->setDefaultButton(wait);
  box->setAttribute(Qt::WA_DeleteOnClose);
  connect(box, &QMessageBox::finished, this, [this, box, wait, leave] {
    if (box->clickedButton() == leave) pendingExports_.clear();
    // What it waited for may be there by now.
    closeWhenWritten_ = box->clickedButton() == wait && !(exports_ == 0 && pendingExports_.empty());
    if (box->clickedButton() != leave && box->clickedButton() != wait) closing_ = false;
    if (box->clickedButton() != leave && (box->clickedButton() != wait || closeWhenWritten_)) return;
    QMetaObject::invokeMethod(this, &EditorWindow::close, Qt::QueuedConnection);
  });
  box->open();
  return true;
}

void EditorWindow::closeIfWritten(bool written) {
  if (!closeWhenWritten_ || (written && (exports_ > 0 || !pendingExports_.empty()))) return;
  closeWhenWritten_ = false;
  if (written) {
    close();
  } else {
    closing_ = false;  // there is something to be told first
  }
}

// --- After a crash

void EditorWindow::offerRestoring() {
  const std::vector<KeptSession> found = keeper_.abandoned();
  if (found.empty()) return;
  const KeptSession kept = found.front();
  const QString level = QFileInfo(kept.environment).fileName();
  const QString name =
      kept.session.isEmpty() ? level : QStringLiteral("%1 (%2)").arg(QFileInfo(kept.session).fileName(), level);
  const QString text = tr("Footfall ended unexpectedly while %1 was open (last change %2). Restore the session?")
                           .arg(name, QLocale().toString(kept.time, QLocale::ShortFormat));
  messages_->showHint(
      text, tr("Restore"), [this, kept] { openKept(kept); }, tr("Discard"),
      [this, kept] {
        keeper_.forget(kept);
        offerRestoring();
      });
}

void EditorWindow::continueLastSession() {
  const std::optional<KeptSession> last = keeper_.lastSession();
  if (last) openKept(*last);
}

void EditorWindow::openKept(const KeptSession& kept) {
  askUnsaved([this, kept] { openFile(kept.path, std::nullopt, {}, kept); });
}

}  // namespace footfall::ui
