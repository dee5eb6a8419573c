// Two handles beside the view: what lies above the one or below the other is left out.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QPoint>
#include <QSize>
#include <QWidget>
#include <optional>
#include <vector>

#include "ui/base/level_units.hpp"
#include "ui/view/scene_picker.hpp"

namespace footfall::ui {

/// Heights are the environment's. A handle at its end leaves nothing out. Handles snap to floors (not with Alt held).
/// Keys: Tab goes from handle to handle, arrows move it, Page Up and Page Down go from floor to floor, Home and End to
/// the ends; a double click takes both back.
class HeightSlider : public QWidget {
  Q_OBJECT

 public:
  enum class Handle { Upper, Lower };

  explicit HeightSlider(QWidget* parent = nullptr);

  /// Bounds of the level, and heights with much floor, from the lowest up. The handles go to their ends.
  void setLevel(double lower, double upper, std::vector<double> floors);
  /// The numbers are the file's coordinates along its up axis.
  void setUnits(const LevelUnits& units);
  /// A handle that is beyond the level goes to its end.
  void setRange(const HeightRange& range);
  [[nodiscard]] const HeightRange& range() const { return range_; }
  [[nodiscard]] const std::vector<double>& floors() const { return floors_; }
  void reset() { setRange({}); }
  /// Shows one storey: from a floor to well below the next. Out of range: nothing happens.
  void showFloor(int floor);
  /// The number of the storey that is shown; nothing when the range is another.
  [[nodiscard]] std::optional<int> shownFloor() const;

  [[nodiscard]] Handle activeHandle() const { return active_; }
  /// The middle of a handle, for whoever drives the mouse.
  [[nodiscard]] QPoint handlePlace(Handle handle) const;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 signals:
  void rangeChanged(const footfall::ui::HeightRange& range);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  [[nodiscard]] double value(Handle handle) const;
  [[nodiscard]] QRectF groove() const;
  [[nodiscard]] double yOf(double height) const;
  [[nodiscard]] double heightAt(double y) const;
  [[nodiscard]] QString textOf(double height) const;
  [[nodiscard]] QString title() const;
  void moveTo(Handle handle, double height);
  void step(double heights);
  void stepFloor(int direction);
  void paintHandle(QPainter& painter, Handle handle) const;

  double lower_ = 0, upper_ = 1;
  std::vector<double> floors_;
  HeightRange range_;
  LevelUnits units_;
  Handle active_ = Handle::Upper;
  bool dragging_ = false;
  double grip_ = 0;  ///< from the handle's middle to where the mouse holds it
};

}  // namespace footfall::ui
