// Shows in the status line that the picture is older than the counts beside it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>
#include <optional>

#include "ui/base/messages/status_line.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// A large result takes a while to draw, and the view shows the previous content until then. Nothing is shown for quick
/// pictures.
class DrawingNote : public QObject {
  Q_OBJECT

 public:
  DrawingNote(RunController& controller, LevelView& view, StatusLine& status, QObject* parent);

  /// Returns whether the view does not show all of the last result yet.
  [[nodiscard]] bool pending() const { return since_.has_value(); }

 private:
  void look();

  LevelView& view_;
  StatusLine& status_;
  std::optional<std::chrono::steady_clock::time_point> since_;
  QTimer delay_;
};

}  // namespace footfall::ui
