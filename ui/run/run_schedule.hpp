// When the work of a run begins.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

namespace footfall::ui {

/// Runs begin at once, when no more edits come, or behind the frame that shows what is known of the edit: both want the
/// same processors. One run at a time is planned.
class RunSchedule : public QObject {
  Q_OBJECT

 public:
  enum class Begin { AtOnce, WhenEditsStop, BehindFrame };

  RunSchedule();
  /// Replaces what was planned before. due() comes from here for a run that begins at once.
  void plan(Begin when);
  /// The planned run is not to begin any more.
  void drop();
  /// A run waits until edits stop.
  [[nodiscard]] bool settling() const { return planned_ == Begin::WhenEditsStop; }
  /// No edits follow: a run that waits for their end begins.
  void endSettling();
  /// A frame is to come, planned for or not: framePassed() comes when it has been shown, or after a while (a hidden
  /// view shows none).
  void awaitFrame();
  void frameShown();

 signals:
  /// The planned run is to begin.
  void due();
  /// A frame has been shown and no run waited for it.
  void framePassed();

 private:
  void begin();

  std::optional<Begin> planned_;
  QTimer settleTimer_;
  QTimer frameTimer_;  ///< ends waiting for a frame that does not come
};

}  // namespace footfall::ui
