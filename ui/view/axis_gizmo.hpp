// The file's three axes as the view sees them; a click on one looks along it, dragging turns.
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

#include "ui/base/level_units.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// Lies in a corner of the view and follows its camera. What it does there are keys and commands for, too.
class AxisGizmo : public QWidget {
  Q_OBJECT

 public:
  /// A child of the view.
  explicit AxisGizmo(LevelView& view);

  void setUnits(const LevelUnits& units);

  /// Where the end of an axis is drawn; the nearer ones come last.
  struct End {
    ViewSide side = ViewSide::Top;
    QString letter;  ///< of the file's axis that points there; empty at the ends that one points away from
    QColor colour;
    QPointF place;
    double depth = 0;  ///< towards the eye
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
  std::optional<QPoint> pressed_;    ///< a click may have begun
  QPoint last_;
  std::optional<ViewSide> hovered_;
};

}  // namespace footfall::ui
