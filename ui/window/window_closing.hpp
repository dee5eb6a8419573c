// Decides whether the window may close.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QWidget>

#include "ui/base/messages/status_line.hpp"
#include "ui/document/document.hpp"
#include "ui/window/file_writer.hpp"
#include "ui/window/result_export.hpp"
#include "ui/window/session_files.hpp"

namespace footfall::ui {

/// Asks about unsaved changes and about exports that wait for the run, and waits for files that are being written,
/// because no message about them could be shown after the window has closed.
class WindowClosing : public QObject {
  Q_OBJECT

 public:
  WindowClosing(QWidget& window, Document& document, SessionFiles& sessions, ResultExport& exports, FileWriter& writer,
                StatusLine& status);

  /// Returns whether the window may close now. Otherwise it is closed later, if everything succeeds.
  [[nodiscard]] bool mayClose();

 private:
  [[nodiscard]] bool isWriting() const { return writer_.busy() || !exports_.waiting().isEmpty(); }
  [[nodiscard]] bool waits();
  void askWaiting();
  void closeIfWritten(bool written);

  QWidget& window_;
  SessionFiles& sessions_;
  ResultExport& exports_;
  FileWriter& writer_;
  StatusLine& status_;
  bool isAsked_ = false;  ///< the question about unsaved changes has been answered
  bool closesWhenWritten_ = false;
};

}  // namespace footfall::ui
