// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_closing.hpp"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace footfall::ui {

WindowClosing::WindowClosing(QWidget& window, Document& document, SessionFiles& sessions, ResultExport& exports,
                             FileWriter& writer, StatusLine& status)
    : QObject(&window), window_(window), sessions_(sessions), exports_(exports), writer_(writer), status_(status) {
  connect(&writer_, &FileWriter::settled, this, &WindowClosing::closeIfWritten);
  connect(&exports_, &ResultExport::dropped, this, [this] { closeIfWritten(false); });
  // A user who goes on working has decided not to close the window.
  connect(document.undoStack(), &QUndoStack::indexChanged, this, [this] { isAsked_ = closesWhenWritten_ = false; });
}

bool WindowClosing::mayClose() {
  if (isAsked_ || !sessions_.remembering() || !sessions_.hasUnsavedChanges()) return !waits();
  sessions_.askUnsaved([this] {
    isAsked_ = true;
    window_.close();
  });
  return false;
}

bool WindowClosing::waits() {
  // the user closes for the second time: the window closes at once
  if (closesWhenWritten_ || !isWriting()) return false;
  if (exports_.waiting().isEmpty()) {
    closesWhenWritten_ = true;
    status_.say(StatusSubject::Note, tr("Saving the file. Footfall closes when it is done; close again to close now"));
  } else if (!window_.findChild<QMessageBox*>(QStringLiteral("pendingQuestion"))) {
    askWaiting();
  }
  return true;
}

void WindowClosing::askWaiting() {
  auto* box = new QMessageBox(QMessageBox::Question, tr("Not written yet"),
                              tr("%1 waits for the run.").arg(QFileInfo(exports_.waiting()).fileName()),
                              QMessageBox::Cancel, &window_);
  box->setObjectName(QStringLiteral("pendingQuestion"));
  QPushButton* wait = box->addButton(tr("&Write, then close"), QMessageBox::AcceptRole);
  QPushButton* leave = box->addButton(tr("Close &without it"), QMessageBox::DestructiveRole);
  box->setDefaultButton(wait);
  box->setAttribute(Qt::WA_DeleteOnClose);
  connect(box, &QMessageBox::finished, this, [this, box, wait, leave] {
    const bool leaves = box->clickedButton() == leave, waits = box->clickedButton() == wait;
    if (leaves) exports_.takeWaiting();
    closesWhenWritten_ = waits && isWriting();  // the files may be finished by now
    if (!leaves && !waits) isAsked_ = false;
    if (leaves || (waits && !closesWhenWritten_))
      QMetaObject::invokeMethod(&window_, &QWidget::close, Qt::QueuedConnection);
  });
  box->open();
}

void WindowClosing::closeIfWritten(bool written) {
  if (!closesWhenWritten_ || (written && isWriting())) return;
  closesWhenWritten_ = false;
  if (written) {
    window_.close();
  } else {
    isAsked_ = false;  // there is an error to be read first
  }
}

}  // namespace footfall::ui
