// Somebody who walks a path: the time, and whether it goes on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "ui/path/walk/walk_track.hpp"

namespace footfall::ui {

class Walker : public QObject {
  Q_OBJECT

 public:
  explicit Walker(QObject* parent = nullptr);

  /// Sets another path, or an empty one, which ends playing. The walker stays at the same share of the time.
  void setTrack(WalkTrack track);
  [[nodiscard]] const WalkTrack& track() const { return track_; }
  /// Seconds since the start.
  void setTime(double seconds);
  [[nodiscard]] double time() const { return time_; }
  /// Plays, from the start where the end was reached; stops at the end. Nothing without a track.
  void setPlaying(bool on);
  [[nodiscard]] bool isPlaying() const { return timer_.isActive(); }
  /// So many seconds of the walk pass in one second.
  void setPace(double pace) { pace_ = pace; }
  [[nodiscard]] double pace() const { return pace_; }
  /// Lets time pass, as the clock does while it plays.
  void advance(double seconds);

 signals:
  /// The track, the time or isPlaying() is another.
  void changed();

 private:
  WalkTrack track_;
  double time_ = 0;
  double pace_ = 1;
  QTimer timer_;
  QElapsedTimer sinceStep_;
};

}  // namespace footfall::ui
