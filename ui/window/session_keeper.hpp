// Autosaves work in the settings folder, through crashes and beside other windows that do the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/base/work/background_queue.hpp"
#include "ui/document/document.hpp"
#include "ui/window/session.hpp"

namespace footfall::ui {

/// The data of an autosave beyond the session in it.
struct KeptSession {
  QString path;          ///< path of the autosave
  QString environment;   ///< path of the environment
  QString session;       ///< file that the session was opened from or saved as; empty: none
  bool unsaved = false;  ///< there are changes that this file does not have
  QDateTime time;        ///< time of the last change
  std::optional<EditHistory> history;
};

/// Every window has an autosave of its own, with a lock that ends with its process: an autosave without a living owner
/// was left by a crash. A window that is closed leaves its autosave as the last session. All files are written beside
/// their targets and renamed, in the background.
class SessionKeeper : public QObject {
  Q_OBJECT

 public:
  /// `writing` must run all its jobs before it ends, and must outlive this object or be waited for before.
  SessionKeeper(BackgroundQueue& writing, QObject* parent);
  /// The window was not closed: the autosave stays for the next start.
  ~SessionKeeper() override;

  /// Writes the autosave.
  void keep(Session session, const QString& sessionPath, bool unsaved, EditHistory history);
  /// Called when the window was closed properly: the last autosave becomes the last session. Has no effect without an
  /// autosave.
  void close();

  [[nodiscard]] std::optional<KeptSession> lastSession() const;
  /// Autosaves of windows that were not closed and whose process has ended, the newest first. Other windows are not
  /// offered them while this object lives.
  [[nodiscard]] std::vector<KeptSession> abandoned();
  /// Removes one of abandoned(), after everything that was kept until now has been written.
  void forget(const KeptSession& kept);

 signals:
  /// Emitted when the autosave cannot be written; not repeated until it can be written again.
  void failed(const QString& message);
  /// Emitted when it can be written again.
  void recovered();

 private:
  bool takeOwnPath();

  BackgroundQueue& writing_;
  QString folder_;
  QString ownPath_;  ///< empty before the first autosave
  std::shared_ptr<QLockFile> ownLock_;
  std::vector<std::shared_ptr<QLockFile>> taken_;  ///< locks of abandoned()
  std::vector<KeptSession> abandoned_;
  bool failing_ = false;
};

/// The content of a file in the settings folder; empty when it cannot be read or names no environment.
std::optional<KeptSession> readKeptSession(const QString& path);

}  // namespace footfall::ui
