// Shows the progress of long work in the status bar, with the time left, and in the task bar.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "ui/base/work/time_estimate.hpp"

namespace footfall::ui {

/// Sends the progress to the desktop's task bar by LauncherEntry's signal "Update", which panels of KDE and others show
/// on the program's icon. It has no effect without such a panel. `fraction` below 0: no progress.
void showTaskbarProgress(double fraction);

/// Estimates the time left from the time that a share of the work took. Gives no estimate in the first moments, and
/// changes smoothly.
class TimeLeft {
 public:
  void begin();
  /// Seconds left; empty while they cannot be estimated. Both arguments belong to the same work.
  std::optional<double> estimate(double elapsedSeconds, double fraction);

 private:
  std::optional<double> shown_;
  double at_ = 0;
};

/// A rounded text of an estimate: "about 12 s left".
QString timeLeftText(double seconds);
/// The text of an estimate: the time left, that the work takes longer than estimated, or that no estimate is possible;
/// empty while it is too early.
QString timeLeftText(const EndEstimate::Told& told);

class ProgressDisplay : public QWidget {
  Q_OBJECT

 public:
  explicit ProgressDisplay(QWidget* parent = nullptr);

  /// `fraction` below 0 means unknown. The time left is estimated unless `secondsLeft` has it (infinite: unknown). The
  /// shown time continues with the clock between two calls.
  void showProgress(double fraction, std::optional<double> secondsLeft = {});
  void finish();

  [[nodiscard]] QProgressBar* bar() const { return bar_; }
  [[nodiscard]] QString timeText() const { return time_->text(); }

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showTime();

  QProgressBar* bar_;
  QLabel* time_;
  QElapsedTimer elapsed_;
  QTimer tick_;
  QElapsedTimer sinceMoved_;  ///< time since a bar of unknown share moved
  TimeLeft left_;
  EndEstimate end_;
  double lastFraction_ = -1;
};

}  // namespace footfall::ui
