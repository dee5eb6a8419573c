// Who gets the mouse in a view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeyEvent>
#include <QPoint>
#include <optional>

#include "ui/view/view_tool.hpp"

namespace footfall::ui {

/// The tool comes first, where there is one; without a tool, what lies in the view to be held (handles). What they do
/// not take is the camera's.
class ToolMouse {
 public:
  /// Null: none. The tool before has ended when this returns. False where nothing changes.
  bool setTool(ViewTool* tool);
  [[nodiscard]] ViewTool* tool() const { return tool_; }
  /// They must outlive the view; null: none.
  void setHandles(ViewTool* handles) { handles_ = handles; }

  /// True: taken.
  bool press(const ViewMouse& mouse);
  bool move(const ViewMouse& mouse);
  enum class Release { Taken, Clicked, None };
  /// `Clicked`: in one place, and nobody took it.
  Release release(const ViewMouse& mouse);
  /// A click that nobody took by pressing. True: a tool has it.
  bool click(const ViewMouse& mouse);
  void leave();
  /// True: taken.
  bool pressKey(const QKeyEvent& event);

 private:
  [[nodiscard]] ViewTool* listener() const { return tool_ ? tool_ : handles_; }

  ViewTool* tool_ = nullptr;
  ViewTool* handles_ = nullptr;
  ViewTool* holder_ = nullptr;     ///< has the button until it is released
  std::optional<QPoint> pressed_;  ///< where a click may have begun
};

}  // namespace footfall::ui
