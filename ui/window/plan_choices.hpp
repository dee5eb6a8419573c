// Pages, scale, paper and colours of a floor plan, as rows of a dialog.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QWidget>

#include "core/report/floor_plan.hpp"

namespace footfall::ui {

class PlanChoices : public QWidget {
  Q_OBJECT

 public:
  explicit PlanChoices(QWidget* parent = nullptr);

  [[nodiscard]] detail::PlanOptions options() const;
  void setOptions(const detail::PlanOptions& options);

 signals:
  void changed();

 private:
  QComboBox *pages_, *scale_, *paper_, *colours_;
};

}  // namespace footfall::ui
