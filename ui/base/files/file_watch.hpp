// Detects that another program has saved a file, once the file is complete.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <chrono>
#include <optional>
#include <vector>

namespace footfall::ui {

/// Watches one file and the files that belong to it (the .bin files that a .gltf names), or a folder and the meshes in
/// it. Notifications of the system are used where it sends them. Sizes and times are also checked from time to time,
/// for network drives and for programs that write another file and rename it. changed() is emitted when nothing has
/// changed for a while. A version that could not be read is offered again a few times, because it may be incomplete.
class FileWatch : public QObject {
  Q_OBJECT

 public:
  struct Timings {
    std::chrono::milliseconds poll{1000};
    std::chrono::milliseconds settle{250};  ///< time without changes before a version is offered
    std::chrono::milliseconds retry{400};   ///< wait after the first failure; each further failure doubles it
  };
  static constexpr int kRetries = 4;

  explicit FileWatch(QObject* parent = nullptr);

  /// Starts watching; the version on the disk counts as known. An empty path stops watching.
  void watch(const QString& path);
  [[nodiscard]] const QString& path() const { return path_; }
  /// While watching is disabled, changed() is not emitted; it is emitted for changes of that time when watching is
  /// enabled again.
  void setEnabled(bool on);
  [[nodiscard]] bool enabled() const { return enabled_; }
  /// Called when the version that changed() was emitted for has been read.
  void readSucceeded();
  /// Called when that version could not be read; changed() is emitted again, or givenUp() with the message.
  void readFailed(const QString& message);
  /// Marks the version on the disk as the editor's own.
  void acknowledge();
  void setTimings(const Timings& timings);

 signals:
  /// Emitted for another version that seems to be complete.
  void changed();
  void vanished();
  /// Emitted when a version cannot be read and waiting has not helped.
  void givenUp(const QString& message);

 private:
  struct Stamp {
    bool exists = false;
    qint64 size = 0, seconds = 0, nanoseconds = 0;
    quint64 inode = 0;
    bool operator==(const Stamp&) const = default;
  };
  using Stamps = std::vector<Stamp>;
  static Stamp stampOf(const QString& path);
  [[nodiscard]] Stamps stamps() const;
  [[nodiscard]] QStringList companions() const;
  void listen();
  void look();
  void settled();

  QString path_;
  QStringList files_;  ///< the file comes first
  bool enabled_ = true;
  bool gone_ = false;  ///< vanished() was emitted
  Stamps known_;       ///< stamps of the version that was read last, or offered
  Stamps seen_;        ///< stamps of the last check
  int failures_ = 0;   ///< failures of the version that is offered
  Timings timings_;
  QFileSystemWatcher watcher_;
  QTimer poll_, settle_, retry_;
};

}  // namespace footfall::ui
