// The window's files: writing, sessions that are kept, and what has not been saved.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCloseEvent>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <utility>

#include "core/environment/export.hpp"
#include "ui/core_text.hpp"
#include "ui/editor_window.hpp"
#include "ui/guarded_application.hpp"

namespace footfall {
namespace {

std::string toPath(const QString& path) { return QFile::encodeName(path).toStdString(); }
QString fromPath(const std::string& path) { return QFile::decodeName(QByteArray::fromStdString(path)); }

}  // namespace

void EditorWindow::writeInBackground(std::function<void()> write, const QString& path, std::function<void(bool)> then) {
  ++exports_;
  showProgress(tr("Writing %1").arg(QFileInfo(path).fileName()), -1);
  writing_.post([this, write = std::move(write), then = std::move(then), path] {
    const QString error = errorOf(write);
    QMetaObject::invokeMethod(
        this,
        [this, error, path, then] {
          --exports_;
          if (idle()) hideProgress();
          if (error.isEmpty()) {
            say(tr("Wrote %1").arg(path));
            log_.add(MessageLevel::Note, tr("Wrote %1").arg(path));
          } else {
            messages_->showError(error);
          }
          if (then) then(error.isEmpty());
          if (error.isEmpty()) emit written(path);
        },
        Qt::QueuedConnection);
  });
}

void EditorWindow::savePipeline(const QString& path) {
  writeInBackground(
      [text = formatPipeline(document_.pipeline()), target = toPath(path)] { writeFileSafely(target, text); }, path);
}

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
      messages_->showError(tr("session, '%1': %2; this part was left out").arg(section.name, coreText(error)));
    }
  }
}

void EditorWindow::saveSession(const QString& path) {
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
  auto* box =
      new QMessageBox(QMessageBox::Question, tr("Unsaved changes"), tr("Save the changes to %1?").arg(nameOfWork()),
                      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box->setObjectName(QStringLiteral("unsavedQuestion"));
  box->setInformativeText(tr("They are lost otherwise."));
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

QString EditorWindow::nameOfWork() const {
  if (!sessionPath_.isEmpty()) return QFileInfo(sessionPath_).fileName();
  return loaded_.environment ? QFileInfo(fromPath(loaded_.environment->source)).fileName() : QString();
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
  if (remembering_) {
    keepSession();
    keeper_.close();
    saveLayout();
  }
  QMainWindow::closeEvent(event);
}

// --- After a crash

void EditorWindow::offerRestoring() {
  const std::vector<KeptSession> found = keeper_.abandoned();
  if (found.empty()) return;
  const KeptSession kept = found.front();
  const QString text =
      tr("Footfall ended unexpectedly while %1 was open (last change %2). Restore it?")
          .arg(QFileInfo(kept.environment).fileName(), QLocale().toString(kept.time, QLocale::ShortFormat));
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

}  // namespace footfall
