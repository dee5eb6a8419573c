// Files that the editor writes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "footfall/run_context.hpp"
#include "ui/base/background_queue.hpp"
#include "ui/base/message_bar.hpp"
#include "ui/base/message_log.hpp"
#include "ui/base/status_line.hpp"
#include "ui/level/level_file.hpp"

namespace footfall::ui {

/// What a file that is written is for. Of the files that the editor works with, only those of the same kind may be
/// replaced: a session by a session.
enum class WrittenKind { Export, Session, Pipeline };

/// Writes in the background, reports errors, and refuses to write over the files that are worked with.
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

  /// `write` is called in the background and throws where it fails; `then` is called here with whether it has not,
  /// before written() is emitted.
  void write(std::function<void()> write, const QString& path, std::function<void(bool)> then = {});
  /// The same for what may take long: cancel() ends it, by its context.
  void writeLong(std::function<void(const RunContext&)> write, const QString& path);
  /// Ends what writeLong() began and is not done; nothing of it is written, and that is told.
  void cancel();
  /// Why a file must not be written to, in one line; empty where it may be. The rule is WriteTargets'.
  [[nodiscard]] QString refusal(const QString& path, WrittenKind kind) const;
  /// Shows the refusal, if there is one, and returns whether there is.
  bool refuses(const QString& path, WrittenKind kind);
  /// Asks before it replaces a file by a name that a person has chosen, and calls `write` where nothing is refused;
  /// else `keep`.
  void writeAsking(const QString& path, WrittenKind kind, std::function<void()> write, std::function<void()> keep = {});

  /// The session or the pipeline that was opened or saved last; empty: none.
  [[nodiscard]] QString openPath(WrittenKind kind) const;
  void setOpenPath(WrittenKind kind, const QString& path);
  /// Something is being written.
  [[nodiscard]] bool busy() const { return writing_ > 0; }

 signals:
  void started(const QString& path);
  /// Nothing is being done with that file any more; messages follow.
  void ended();
  void written(const QString& path);
  /// Everybody knows how it went.
  void settled(bool written);

 private:
  Uses uses_;
  QString session_, pipeline_;
  int writing_ = 0;
  std::vector<std::weak_ptr<RunContext>> contexts_;  ///< of writeLong()
};

}  // namespace footfall::ui
