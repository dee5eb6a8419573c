// Keeps what is being worked on in the settings folder, through crashes and beside other windows that do the same.
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

#include "ui/base/background_queue.hpp"
#include "ui/document/document.hpp"
#include "ui/window/session.hpp"

namespace footfall::ui {

/// What an autosave knows beyond the session in it.
struct KeptSession {
  QString path;          ///< of the autosave
  QString environment;   ///< path of what is worked on
  QString session;       ///< the file that it was opened from or saved as; empty: none
  bool unsaved = false;  ///< there are changes that this file has not
  QDateTime time;        ///< of the last change
  std::optional<EditHistory> history;
};

/// Every window has an autosave of its own, with a lock that dies with its process: an autosave without a living owner
/// is one of a crash. A window that is closed leaves its autosave as the last session. All files are written beside and
/// renamed, in the background.
class SessionKeeper : public QObject {
  Q_OBJECT

 public:
  /// `writing` must do all its jobs at its end, and begin later than this object ends or be waited for before.
  SessionKeeper(BackgroundQueue& writing, QObject* parent);
  /// Not closed: the autosave stays for the next start.
  ~SessionKeeper() override;

  /// Writes the autosave anew.
  void keep(Session session, const QString& sessionPath, bool unsaved, EditHistory history);
  /// The window was closed properly: what was kept last becomes the last session. Nothing when nothing was kept.
  void close();

  [[nodiscard]] std::optional<KeptSession> lastSession() const;
  /// Autosaves of windows that were not closed and whose process is gone, the newest first. Nobody else is offered them
  /// while this object lives.
  [[nodiscard]] std::vector<KeptSession> abandoned();
  /// One of abandoned() is not needed any more: after what has been kept until now is written.
  void forget(const KeptSession& kept);

 signals:
  /// The autosave cannot be written; told once until it can be written again.
  void failed(const QString& message);
  /// It can be written again.
  void recovered();

 private:
  bool takeOwnPath();

  BackgroundQueue& writing_;
  QString folder_;
  QString ownPath_;  ///< empty until something is kept
  std::shared_ptr<QLockFile> ownLock_;
  std::vector<std::shared_ptr<QLockFile>> taken_;  ///< of abandoned()
  std::vector<KeptSession> abandoned_;
  bool failing_ = false;
};

/// What a file in the settings folder holds; nothing when it cannot be read or names no environment.
std::optional<KeptSession> readKeptSession(const QString& path);

}  // namespace footfall::ui
