// Notices that another program has saved a file, once the file is complete.
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

/// Watches one file and what belongs to it (the .bin files that a .gltf names), or a folder and the meshes in it. The
/// system's notices come at once where they come at all; sizes and times are looked at now and then besides, for
/// network drives and for programs that write another file and rename it. changed() is emitted when nothing has changed
/// for a while. A version that could not be read is offered again a few times, as it may still be in the making.
class FileWatch : public QObject {
  Q_OBJECT

 public:
  struct Timings {
    std::chrono::milliseconds poll{1000};
    std::chrono::milliseconds settle{250};  ///< nothing may change for so long
    std::chrono::milliseconds retry{400};   ///< after the first failure; twice as long after each other one
  };
  static constexpr int kRetries = 4;

  explicit FileWatch(QObject* parent = nullptr);

  /// The version on the disk counts as known. Empty: nothing is watched.
  void watch(const QString& path);
  [[nodiscard]] const QString& path() const { return path_; }
  /// Off: changed() is not emitted. For changes that came meanwhile it is, when the watch is switched on.
  void setEnabled(bool on);
  [[nodiscard]] bool enabled() const { return enabled_; }
  /// To be called when the version that changed() was emitted for has been read.
  void readSucceeded();
  /// It has not: changed() comes again, or givenUp() with the message.
  void readFailed(const QString& message);
  /// The version on the disk is the editor's own.
  void acknowledge();
  void setTimings(const Timings& timings);

 signals:
  /// There is another version, complete as far as can be seen.
  void changed();
  void vanished();
  /// A version cannot be read, and waiting has not helped.
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
  QStringList files_;  ///< the file first
  bool enabled_ = true;
  bool gone_ = false;  ///< and vanished() was emitted
  Stamps known_;       ///< of the version that was read last, or offered
  Stamps seen_;        ///< of the last look
  int failures_ = 0;   ///< of the version that is offered
  Timings timings_;
  QFileSystemWatcher watcher_;
  QTimer poll_, settle_, retry_;
};

}  // namespace footfall::ui
