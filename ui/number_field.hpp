// A field for one parameter of a filter, made from its descriptor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <optional>

#include "core/filters/descriptor.hpp"

namespace footfall {

/// Takes any number as typed, in full precision; nothing is clamped or rounded. While the text is no valid value, the
/// field is marked, problem() says why, and the last valid value stays in force. Up and Down change it by a step that
/// suits the unit; Escape brings the value in force back.
class NumberField : public QLineEdit {
  Q_OBJECT

 public:
  explicit NumberField(const ParameterDescriptor& parameter, QWidget* parent = nullptr);

  /// Shows `value`, unless the text already stands for it.
  void setValue(double value);
  [[nodiscard]] double value() const { return value_; }
  /// Empty when the text is a valid value.
  [[nodiscard]] QString problem() const { return problem_; }
  /// Changes whenever the field gains the focus: what is typed in between is one edit.
  [[nodiscard]] int editSession() const { return editSession_; }

 signals:
  void valueEdited(double value);
  void problemChanged();

 protected:
  /// Undo and redo are the document's, which knows what was typed: one stack for all.
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

 private:
  void readText(const QString& text);
  void setProblem(const QString& problem);
  void stepBy(int steps);

  ParameterDescriptor parameter_;
  double value_ = 0;
  QString problem_;
  int editSession_ = 0;
};

/// A number as typed, in the notation of pipeline files (a point for decimals, exponents allowed), or nothing.
std::optional<double> parseNumber(const QString& text);

/// The shortest text that reads back to the same number.
QString numberText(double value);

/// What follows a value, e.g. " degrees"; lengths and areas are in the environment's units.
QString unitText(Unit unit);

}  // namespace footfall
