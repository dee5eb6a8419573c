// The tool "Try it": two clicks set the ends of a path, which is drawn; both ends can be dragged.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/base/text/level_units.hpp"
#include "ui/path/path_model.hpp"
#include "ui/view/level_view.hpp"
#include "ui/view/view_tool.hpp"

namespace footfall::ui {

/// A click sets the start, the next one the target, and a third begins again. An end under the mouse can be dragged.
/// Backspace removes the last end.
class PathTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  PathTool(PathModel& model, LevelView& view, QObject* parent);

  /// Sets whether ends and path are drawn while the tool is not active.
  void setShown(bool shown);
  /// Sets the units of the label.
  void setUnits(const LevelUnits& units);

  bool mousePressed(const ViewMouse& mouse) override;
  void mouseMoved(const ViewMouse& mouse) override;
  void mouseReleased(const ViewMouse& mouse) override;
  void clicked(const ViewMouse& mouse) override;
  bool keyPressed(const QKeyEvent& event) override;
  void mouseLeft() override;
  void ended() override;
  [[nodiscard]] QString hint() const override;

 signals:
  void hintChanged(const QString& hint);
  /// Space was pressed: the path is to be walked, or the walker is to stop.
  void playRequested();

 private:
  enum class End { None, Start, Target };
  [[nodiscard]] End endAt(const QPoint& place) const;
  void draw();

  PathModel& model_;
  LevelView& view_;
  End dragged_ = End::None, hovered_ = End::None;
  bool shown_ = false;
  LevelUnits units_;
};

}  // namespace footfall::ui
