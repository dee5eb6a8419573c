// Decides when a run begins.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

namespace footfall::ui {

/// A run begins at once, when edits stop, or after the frame that shows the known changes of the edit, because both
/// need the same processors. One run is planned at a time.
class RunSchedule : public QObject {
  Q_OBJECT

 public:
  enum class Begin { AtOnce, WhenEditsStop, BehindFrame };

  RunSchedule();
  /// Plans a run and replaces the earlier plan. due() is emitted inside this call for a run that begins at once.
  void plan(Begin when);
  /// Drops the planned run.
  void drop();
  /// Returns whether a run waits until edits stop.
  [[nodiscard]] bool settling() const { return planned_ == Begin::WhenEditsStop; }
  /// Starts a run that waits until edits stop, because none follow.
  void endSettling();
  /// Waits for a frame, with or without a plan: framePassed() is emitted when it has been shown, or after a while (a
  /// hidden view shows none).
  void awaitFrame();
  void frameShown();

 signals:
  /// Emitted when the planned run should begin.
  void due();
  /// Emitted when a frame has been shown and no run has waited for it.
  void framePassed();

 private:
  void begin();

  std::optional<Begin> planned_;
  QTimer settleTimer_;
  QTimer frameTimer_;  ///< ends the wait for a frame that is not shown
};

}  // namespace footfall::ui
