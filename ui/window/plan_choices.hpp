// Pages, scale, paper, colours and passages of a floor plan, as rows of a dialog.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "core/report/floor_plan.hpp"
#include "ui/base/text/level_units.hpp"
#include "ui/base/widgets/number_field.hpp"

namespace footfall::ui {

class PlanChoices : public QWidget {
  Q_OBJECT

 public:
  explicit PlanChoices(QWidget* parent = nullptr);

  [[nodiscard]] detail::PlanOptions options() const;
  void setOptions(const detail::PlanOptions& options);
  /// The unit of the width of bottlenecks, which is a metre at first.
  void setUnits(const LevelUnits& units);
  /// The reason why the options are not valid; empty when they are.
  [[nodiscard]] QString problem() const;

 signals:
  void changed();

 private:
  QComboBox *pages_, *scale_, *paper_, *colours_;
  QCheckBox *corridors_, *bottlenecks_;
  NumberField* width_;
  QLabel* unit_;
};

}  // namespace footfall::ui
