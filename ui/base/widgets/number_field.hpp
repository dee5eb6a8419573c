// A field for one parameter of a filter, described by its descriptor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <optional>

#include "footfall/parameter.hpp"
#include "ui/base/text/level_units.hpp"

namespace footfall::ui {

/// Accepts any typed number in full precision; nothing is clamped or rounded. Lengths and areas are shown and typed in
/// the unit of setUnits(), while value() stays in the file's units. A long number shows its beginning, and its tool tip
/// the whole number. Enter and Escape return the focus to the view. While the text is not a valid value, the field is
/// marked, problem() has the reason, and the last valid value applies. Up and Down, the wheel while the field has the
/// focus, and dragging sideways change the value by steps that suit the unit (Shift: a tenth, Ctrl: ten times). Escape
/// restores the applied value, or the value before the drag. A drag ends at the limits of the range, and problem() is
/// set while the mouse is beyond them. Dragging over a field that already has the focus selects text.
class NumberField : public QLineEdit {
  Q_OBJECT

 public:
  explicit NumberField(const ParameterDescriptor& parameter, QWidget* parent = nullptr);

  void setUnits(const LevelUnits& units);
  /// Shows `value`, unless the text already stands for it.
  void setValue(double value);
  [[nodiscard]] double value() const { return value_; }
  /// The reason why the text is not a valid value; empty when it is valid.
  [[nodiscard]] QString problem() const { return problem_; }
  /// Changes whenever the field gains the focus and with each drag; all changes between belong to one edit.
  [[nodiscard]] int editSession() const { return editSession_; }
  /// Makes dragging on `label` change the value as well.
  void takeDragsOf(QWidget* label);
  [[nodiscard]] bool dragging() const { return drag_ && drag_->moved; }
  /// The tool tip, with the number in full.
  [[nodiscard]] QString help() const;

 signals:
  void valueEdited(double value);
  void problemChanged();
  /// Emitted when a drag of the value begins or ends.
  void draggingChanged(bool dragging);

 protected:
  /// The document handles undo and redo, so that there is one stack for all edits.
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
    double from = 0;          // the applied number when it began
    double step = 1;          // step for that number
    double steps = 0;         // steps so far
    double start = 0, x = 0;  // on the screen
    bool moved = false;       // moved far enough to be a drag and not a click
    bool onField = false;
  };

  [[nodiscard]] QString textOf(double number) const;
  void showNumber();
  /// The problem of a number in the shown unit.
  [[nodiscard]] QString problemOf(double number) const;
  void take(double number);
  void readText(const QString& text);
  void setProblem(const QString& problem);
  [[nodiscard]] double stepSize() const;
  void stepBy(double steps);
  /// Sets the multiple of `grain` nearest to `wanted` within the range. Returns a message when `wanted` is out of
  /// range.
  QString takeNear(double wanted, double grain);
  void beginDrag(double x, bool onField);
  void dragTo(double x, Qt::KeyboardModifiers modifiers);
  void endDrag(bool keep);

  ParameterDescriptor parameter_;
  ParameterDescriptor asShown_;  // descriptor with limits in the shown unit
  LevelUnits units_;
  double value_ = 0;
  double number_ = 0;  // the number in the shown unit
  QString problem_;
  int editSession_ = 0;
  std::optional<Drag> drag_;
  bool focusedByClick_ = false;
  int wheel_ = 0;  // eighths of a degree that do not make a whole step yet
};

/// The unit in which a value is shown and typed, e.g. "degrees" or "m"; empty for pure numbers.
QString unitText(Unit unit, const LevelUnits& units);

}  // namespace footfall::ui
