// A slider beside the view whose two handles hide everything above the one and below the other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QPoint>
#include <QSize>
#include <QWidget>
#include <optional>
#include <vector>

#include "ui/base/text/level_units.hpp"
#include "ui/view/scene/scene_picker.hpp"

namespace footfall::ui {

/// Heights are the environment's. A handle at its end hides nothing. Handles snap to floors (not with Alt held). Keys:
/// Tab switches between handles, arrows move one, Page Up and Page Down move it to the next floor, Home and End to the
/// ends; a double click resets both.
class HeightSlider : public QWidget {
  Q_OBJECT

 public:
  enum class Handle { Upper, Lower };

  explicit HeightSlider(QWidget* parent = nullptr);

  /// Sets the bounds of the level, and the heights with much floor, from the lowest up. The handles move to their ends.
  void setLevel(double lower, double upper, std::vector<double> floors);
  /// The numbers are the file's coordinates along its up axis.
  void setUnits(const LevelUnits& units);
  /// A handle beyond the level moves to its end.
  void setRange(const HeightRange& range);
  [[nodiscard]] const HeightRange& range() const { return range_; }
  [[nodiscard]] const std::vector<double>& floors() const { return floors_; }
  void reset() { setRange({}); }
  /// Shows one storey: from a floor to well below the next. An index out of range has no effect.
  void showFloor(int floor);
  /// The number of the shown storey; empty for any other range.
  [[nodiscard]] std::optional<int> shownFloor() const;

  [[nodiscard]] Handle activeHandle() const { return active_; }
  /// The middle of a handle, for code that moves the mouse.
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
  double grip_ = 0;  ///< from the handle's middle to the mouse that holds it
};

}  // namespace footfall::ui
