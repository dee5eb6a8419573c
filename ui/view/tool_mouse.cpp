// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/tool_mouse.hpp"

#include <QApplication>
#include <utility>

namespace footfall::ui {

bool ToolMouse::setTool(ViewTool* tool) {
  if (tool == tool_) return false;
  ViewTool* const before = std::exchange(tool_, tool);
  holder_ = nullptr;
  if (before) {
    before->ended();
  } else if (handles_) {
    handles_->ended();
  }
  return true;
}

bool ToolMouse::press(const ViewMouse& mouse) {
  const bool plain = mouse.button == Qt::LeftButton && mouse.modifiers == Qt::NoModifier;
  pressed_ = plain ? std::optional(mouse.place) : std::nullopt;
  ViewTool* const taker = listener();
  const bool isTaken = taker && taker->mousePressed(mouse);
  holder_ = isTaken && taker == listener() ? taker : nullptr;  // the press may have ended the tool
  if (isTaken) pressed_.reset();
  return isTaken;
}

bool ToolMouse::move(const ViewMouse& mouse) {
  if (holder_) {
    holder_->mouseMoved(mouse);
    return true;
  }
  if (mouse.buttons == Qt::NoButton) {
    if (listener()) listener()->mouseMoved(mouse);
  } else if (pressed_ && (mouse.place - *pressed_).manhattanLength() >= QApplication::startDragDistance()) {
    pressed_.reset();
  }
  return false;
}

ToolMouse::Release ToolMouse::release(const ViewMouse& mouse) {
  if (ViewTool* const holder = std::exchange(holder_, nullptr)) {
    holder->mouseReleased(mouse);
    return Release::Taken;
  }
  return std::exchange(pressed_, std::nullopt) ? Release::Clicked : Release::None;
}

bool ToolMouse::click(const ViewMouse& mouse) {
  if (listener()) listener()->clicked(mouse);
  return tool_ != nullptr;
}

void ToolMouse::leave() {
  if (listener()) listener()->mouseLeft();
}

bool ToolMouse::pressKey(const QKeyEvent& event) { return listener() && listener()->keyPressed(event); }

}  // namespace footfall::ui
