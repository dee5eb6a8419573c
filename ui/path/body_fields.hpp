// Who walks the path of "Try it": a radius as a number and on a slider, and which of several ways is taken.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSlider>

#include "ui/base/widgets/number_field.hpp"
#include "ui/path/path_model.hpp"

namespace footfall::ui {

class BodyFields : public QObject {
  Q_OBJECT

 public:
  /// The widgets are children of `parent`; they follow the model's body, and change it.
  BodyFields(PathModel& model, QWidget* parent);

  void addTo(QFormLayout& form);
  void setUnits(const LevelUnits& units);
  /// The reason why the text of the radius is no radius; empty when it is one.
  [[nodiscard]] QString problem() const { return radius_->problem(); }

 signals:
  void problemChanged();

 private:
  void take(double radius);
  void showBody();

  PathModel& model_;
  LevelUnits units_;
  double step_ = 0.01;  ///< of the slider, in the shown unit
  NumberField* radius_;
  QLabel* unit_;
  QSlider* slider_;
  QComboBox* way_;
};

}  // namespace footfall::ui
