// Distributes the mouse events of a view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeyEvent>
#include <QPoint>
#include <optional>

#include "ui/view/view_tool.hpp"

namespace footfall::ui {

/// The active tool gets events first; without a tool, the handles in the view do. The camera gets all other events.
class ToolMouse {
 public:
  /// Sets the tool; null: none. The previous tool has ended when this returns. Returns false where nothing changes.
  bool setTool(ViewTool* tool);
  [[nodiscard]] ViewTool* tool() const { return tool_; }
  /// The handles must outlive the view; null: none.
  void setHandles(ViewTool* handles) { handles_ = handles; }

  /// True: handled.
  bool press(const ViewMouse& mouse);
  bool move(const ViewMouse& mouse);
  enum class Release { Taken, Clicked, None };
  /// `Clicked`: in one place, and the press was not handled.
  Release release(const ViewMouse& mouse);
  /// A click whose press was not handled. True: a tool has handled it.
  bool click(const ViewMouse& mouse);
  void leave();
  /// True: handled.
  bool pressKey(const QKeyEvent& event);

 private:
  [[nodiscard]] ViewTool* listener() const { return tool_ ? tool_ : handles_; }

  ViewTool* tool_ = nullptr;
  ViewTool* handles_ = nullptr;
  ViewTool* holder_ = nullptr;     ///< gets all events until the button is released
  std::optional<QPoint> pressed_;  ///< set while a press may become a click
};

}  // namespace footfall::ui
