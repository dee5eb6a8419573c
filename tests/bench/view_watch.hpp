// Measures what a person in front of the editor would see with a stopwatch in hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>

#include "ui/window/editor_window.hpp"

namespace footfall::bench {
using namespace detail;
using namespace ui;

/// Milliseconds since an edit.
struct EditTimes {
  std::optional<double> visible;  ///< the first frame with other pixels was on its way to the screen
  double begun = 0;               ///< OpenGL got the first command of that frame
  double visibleCpu = 0;    ///< processor time of all threads until then, which others on the machine cannot stretch
  double finished = 0;      ///< the frame with the finished result was
  double longestPause = 0;  ///< longest pause in which the window could do nothing else
  double slowestFrame = 0;  ///< slowest frame of the view
};

/// Follows one edit at a time: call begin(), make the edit, and wait until done().
class ViewWatch : public QObject {
 public:
  explicit ViewWatch(EditorWindow& window);

  void begin();
  /// The run that the edit led to has finished, and its result is on the screen.
  [[nodiscard]] bool done() const { return done_; }
  [[nodiscard]] const EditTimes& times() const { return times_; }

 private:
  void frameShown();
  void tick();
  [[nodiscard]] std::size_t pixels();
  [[nodiscard]] double msUntil(std::chrono::steady_clock::time_point time) const {
    return std::chrono::duration<double, std::milli>(time - begun_).count();
  }

  EditorWindow& window_;
  std::chrono::steady_clock::time_point begun_;
  QElapsedTimer sinceTick_;
  double cpuBefore_ = 0;
  QTimer pulse_;
  EditTimes times_;
  std::size_t before_ = 0;
  bool watching_ = false, resultReady_ = false, done_ = true;
};

}  // namespace footfall::bench
