// Writes pictures from all around the level: a sequence for films and web pages.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSize>
#include <QString>
#include <optional>
#include <vector>

#include "ui/base/work/background_queue.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

struct TurntableSettings {
  QString folder;
  int frames = 72;
  QSize pixels{1280, 720};
};
inline constexpr int kLeastFrames = 2, kMostFrames = 3600;

/// FOLDER/frame_0001.png; the first frame is number 1.
QString turntableFrame(const QString& folder, int number);

/// Frames are drawn one after the other, each after the one before is written. They show the finished result as the
/// view does; another run ends the sequence. A folder that has frames already is refused, so that sequences do not mix.
class Turntable : public QObject {
  Q_OBJECT

 public:
  /// `queue` must do all its jobs at its end.
  Turntable(LevelView& view, RunController& controller, BackgroundQueue& queue, QObject* parent);

  /// Makes the folder where it is missing. One of finished() and stopped() follows, maybe at once.
  void start(const TurntableSettings& settings);
  void cancel();
  [[nodiscard]] bool isRunning() const { return settings_.has_value(); }

 signals:
  void progressed(int written, int all);
  void finished(const QString& folder, int frames);
  /// One line: what, where and what to do.
  void stopped(const QString& message);

 private:
  [[nodiscard]] QString problemOf(const TurntableSettings& settings) const;
  void drawNext();
  void takeWritten(const QString& error);
  void stop(const QString& message);

  LevelView& view_;
  RunController& controller_;
  BackgroundQueue& queue_;
  std::optional<TurntableSettings> settings_;  ///< while it is running
  std::vector<CameraPose> poses_;
  CameraPose before_;
  int written_ = 0;
};

}  // namespace footfall::ui
