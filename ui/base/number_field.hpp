// A field for one parameter of a filter, made from its descriptor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <optional>

#include "footfall/filter.hpp"
#include "ui/base/level_units.hpp"

namespace footfall::ui {

/// Takes any number as typed, in full precision; nothing is clamped or rounded. Lengths and areas are shown and typed
/// in the unit of setUnits(), while value() stays in the file's units. Long numbers show their beginning, and all of
/// them in the tool tip. Enter and Escape give the keys back to the view. While the text is no valid value, the field
/// is marked, problem() says why, and the last valid value stays in force. Up and Down, the wheel while the field has
/// the focus, and dragging sideways change it by steps that suit the unit (Shift: tenths of them, Ctrl: tens); Escape
/// brings back the value in force, or the one from before the drag. A drag goes no further than the range, and
/// problem() says so while the mouse is beyond. A field that has the focus already selects text when dragged over.
class NumberField : public QLineEdit {
  Q_OBJECT

 public:
  explicit NumberField(const ParameterDescriptor& parameter, QWidget* parent = nullptr);

  void setUnits(const LevelUnits& units);
  /// Shows `value`, unless the text already stands for it.
  void setValue(double value);
  [[nodiscard]] double value() const { return value_; }
  /// Empty when the text is a valid value.
  [[nodiscard]] QString problem() const { return problem_; }
  /// Changes whenever the field gains the focus and with each drag: what is typed or dragged in between is one edit.
  [[nodiscard]] int editSession() const { return editSession_; }
  /// Dragging on `label` changes the value, too.
  void takeDragsOf(QWidget* label);
  [[nodiscard]] bool dragging() const { return drag_ && drag_->moved; }
  /// Its tool tip, with the value in full.
  [[nodiscard]] QString help() const;

 signals:
  void valueEdited(double value);
  void problemChanged();
  /// The mouse holds the value, or has let it go.
  void draggingChanged(bool dragging);

 protected:
  /// Undo and redo are the document's, which knows what was typed: one stack for all.
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Drag {
    double from = 0;          // the number in force when it began
    double step = 1;          // of that number
    double steps = 0;         // gone so far
    double start = 0, x = 0;  // on the screen
    bool moved = false;       // far enough to be a drag and no click
    bool onField = false;
  };

  [[nodiscard]] QString textOf(double number) const;
  void showNumber();
  /// What is wrong with a number in the shown unit.
  [[nodiscard]] QString problemOf(double number) const;
  void take(double number);
  void readText(const QString& text);
  void setProblem(const QString& problem);
  [[nodiscard]] double stepSize() const;
  void stepBy(double steps);
  /// In the nearest multiple of `grain`, as far as the range goes. Says what was asked for when that is out of range.
  QString takeNear(double wanted, double grain);
  void beginDrag(double x, bool onField);
  void dragTo(double x, Qt::KeyboardModifiers modifiers);
  void endDrag(bool keep);

  ParameterDescriptor parameter_;
  ParameterDescriptor asShown_;  // with limits in the shown unit
  LevelUnits units_;
  double value_ = 0;
  double number_ = 0;  // the same in the shown unit
  QString problem_;
  int editSession_ = 0;
  std::optional<Drag> drag_;
  bool focusedByClick_ = false;
  int wheel_ = 0;  // eighths of a degree that are no whole step yet
};

/// What a value is shown and typed in, e.g. "degrees" or "m"; empty for pure numbers.
QString unitText(Unit unit, const LevelUnits& units);

}  // namespace footfall::ui
