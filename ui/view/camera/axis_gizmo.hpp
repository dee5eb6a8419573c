// The gizmo of the file's three axes. A click on an axis turns the camera along it; dragging turns freely.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPoint>
#include <QPointF>
#include <QString>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "ui/base/text/level_units.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// Lies in a corner of the view and follows its camera. All its actions also have keys and commands.
class AxisGizmo : public QWidget {
  Q_OBJECT

 public:
  /// The gizmo becomes a child of the view.
  explicit AxisGizmo(LevelView& view);

  void setUnits(const LevelUnits& units);

  /// The drawn end of an axis; nearer ends come last.
  struct End {
    ViewSide side = ViewSide::Top;
    QString letter;  ///< letter of the file's axis that points there; empty at the opposite ends
    QColor colour;
    QPointF place;
    double depth = 0;  ///< larger values are nearer to the eye
  };
  [[nodiscard]] std::vector<End> ends() const;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  [[nodiscard]] std::optional<ViewSide> endAt(const QPointF& place) const;

  LevelView& view_;
  CameraController& camera_;
  LevelUnits units_;
  std::array<double, 4> painted_{};  ///< the orientation that is shown
  std::optional<QPoint> pressed_;    ///< set while a press may become a click
  QPoint last_;
  std::optional<ViewSide> hovered_;
};

}  // namespace footfall::ui
