// The panel of "Try it": both places as numbers, and what the path has to tell.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "ui/base/number_field.hpp"
#include "ui/inspect/place_fields.hpp"
#include "ui/path/path_model.hpp"

namespace footfall::ui {

class PathPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PathPanel(PathModel& model, QWidget* parent = nullptr);

  void setUnits(const LevelUnits& units);
  /// Why there is nothing to walk on; empty when there is something.
  void setNotice(const QString& notice);
  [[nodiscard]] double speed() const { return speed_->value(); }
  void setSpeed(double metresPerSecond);
  /// Puts a widget below the reason of a failure; takes it over.
  void addBelowFailure(QWidget* widget);
  [[nodiscard]] QString text() const { return text_->text(); }

 signals:
  void speedEdited();

 private:
  void showResult();

  PathModel& model_;
  LevelUnits units_;
  QString notice_;
  PlaceFields *start_, *target_;
  NumberField* speed_;
  QLabel *text_, *failure_, *frame_;
  QPushButton *swap_, *clear_, *copy_;
};

}  // namespace footfall::ui
