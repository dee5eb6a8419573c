// The panel of "Try it": both places as numbers, and the length, time and slopes of the path.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "ui/base/widgets/number_field.hpp"
#include "ui/inspect/place_fields.hpp"
#include "ui/path/body_fields.hpp"
#include "ui/path/path_model.hpp"

namespace footfall::ui {

class PathPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PathPanel(PathModel& model, QWidget* parent = nullptr);

  void setUnits(const LevelUnits& units);
  /// Sets the reason why there is no area to walk on; empty when there is one.
  void setNotice(const QString& notice);
  /// Sets whether the result has margins of a RadiusFilter, which bodies walk without.
  void setMargins(bool margins);
  [[nodiscard]] double speed() const { return speed_->value(); }
  void setSpeed(double metresPerSecond);
  /// Puts a widget below the reason of a failure, and takes ownership of it.
  void addBelowFailure(QWidget* widget);
  /// Puts a button behind the others, and takes ownership of it.
  void addButton(QPushButton* button);
  /// The same as addBelowFailure() below what the path takes.
  void addBelowText(QWidget* widget);

 signals:
  void speedEdited();

 private:
  void showResult();

  PathModel& model_;
  LevelUnits units_;
  QString notice_;
  PlaceFields *start_, *target_;
  BodyFields* body_;
  QLayout* buttons_;
  NumberField* speed_;
  bool hasMargins_ = false;
  QLabel *text_, *failure_, *frame_;
  QPushButton *swap_, *clear_, *copy_;
};

}  // namespace footfall::ui
