// How far long work is: in the status bar with the time left, and in the task bar.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "ui/base/time_estimate.hpp"

namespace footfall::ui {

/// Tells the desktop's task bar: LauncherEntry's signal "Update", which Unity's successors, KDE's and other panels show
/// on the icon of the program. Nobody need listen. `fraction` below 0: no progress.
void showTaskbarProgress(double fraction);

/// Time left from how long a share of the work took. Says nothing of the first moments, and changes smoothly.
class TimeLeft {
 public:
  void begin();
  /// Seconds; nothing while it cannot be told. Elapsed and fraction of the same work.
  std::optional<double> estimate(double elapsedSeconds, double fraction);

 private:
  std::optional<double> shown_;
  double at_ = 0;
};

/// "about 12 s left": rounded, as it is an estimate.
QString timeLeftText(double seconds);
/// The same, or that it takes longer than estimated, or that nobody knows; empty while it is too early.
QString timeLeftText(const EndEstimate::Told& told);

class ProgressDisplay : public QWidget {
  Q_OBJECT

 public:
  explicit ProgressDisplay(QWidget* parent = nullptr);

  /// `fraction` below 0: unknown. The time left is estimated unless `secondsLeft` says it (infinite: nobody knows).
  /// What is said of it goes on with the clock, also while nothing is told.
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
  QElapsedTimer sinceMoved_;  ///< the bar, where the share is unknown
  TimeLeft left_;
  EndEstimate end_;
  double lastFraction_ = -1;
};

}  // namespace footfall::ui
