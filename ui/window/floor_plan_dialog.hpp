// The dialog for floor plans: pages, scale, paper and colours. The file is asked for afterwards.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QDialog>

#include "core/report/floor_plan.hpp"

namespace footfall::ui {

class FloorPlanDialog : public QDialog {
  Q_OBJECT

 public:
  explicit FloorPlanDialog(QWidget* parent);

  [[nodiscard]] detail::PlanOptions options() const;

 private:
  QComboBox *pages_, *scale_, *paper_, *colours_;
};

}  // namespace footfall::ui
