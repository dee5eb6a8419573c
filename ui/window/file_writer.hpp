// Writes the editor's files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "footfall/run_context.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/messages/message_log.hpp"
#include "ui/base/messages/status_line.hpp"
#include "ui/base/work/background_queue.hpp"
#include "ui/level/level_file.hpp"

namespace footfall::ui {

/// The kind of a written file. Files that the editor uses may be replaced only by files of the same kind: a session by
/// a session.
enum class WrittenKind { Export, Session, Pipeline };

/// Writes in the background, reports errors, and refuses to overwrite files that are in use.
class FileWriter : public QObject {
  Q_OBJECT

 public:
  struct Uses {
    QWidget& window;  ///< parent of questions
    const LevelFile& level;
    BackgroundQueue& queue;
    MessageBar& messages;
    MessageLog& log;
    StatusLine& status;
  };
  explicit FileWriter(const Uses& uses);

  /// `write` is called in the background and throws on failure. `then` is called on this thread with true after
  /// success, before written() is emitted.
  void write(std::function<void()> write, const QString& path, std::function<void(bool)> then = {});
  /// Writes a file that may take long; cancel() ends it, through its context.
  void writeLong(std::function<void(const RunContext&)> write, const QString& path);
  /// Cancels the unfinished writeLong(); nothing is written, and a message says so.
  void cancel();
  /// The reason why a file must not be written, in one line; empty where it may be. The rule is that of WriteTargets.
  [[nodiscard]] QString refusal(const QString& path, WrittenKind kind) const;
  /// Shows the refusal, if there is one, and returns whether there is.
  bool refuses(const QString& path, WrittenKind kind);
  /// Asks before a file is replaced whose name the user has chosen. Calls `write` where the user agrees and nothing is
  /// refused, else `keep`.
  void writeAsking(const QString& path, WrittenKind kind, std::function<void()> write, std::function<void()> keep = {});

  /// The session or the pipeline that was opened or saved last; empty: none.
  [[nodiscard]] QString openPath(WrittenKind kind) const;
  void setOpenPath(WrittenKind kind, const QString& path);
  /// Returns whether a file is being written.
  [[nodiscard]] bool busy() const { return writing_ > 0; }

 signals:
  void started(const QString& path);
  /// Emitted when a file is finished; messages follow.
  void ended();
  void written(const QString& path);
  /// Emitted after all messages about a file.
  void settled(bool written);

 private:
  Uses uses_;
  QString session_, pipeline_;
  int writing_ = 0;
  std::vector<std::weak_ptr<RunContext>> contexts_;  ///< contexts of writeLong()
};

}  // namespace footfall::ui
