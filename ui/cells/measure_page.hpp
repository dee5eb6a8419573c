// The page of the dock "Load" that repeats measurements.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QWidget>

#include "ui/cells/load_measurement.hpp"

namespace footfall::ui {

class MeasurePage : public QWidget {
  Q_OBJECT

 public:
  explicit MeasurePage(LoadMeasurement& measurement, QWidget* parent = nullptr);

  /// The reason why nothing can be measured now; empty where it can.
  void setObstacle(const QString& text);

  [[nodiscard]] QSpinBox* countBox() const { return count_; }
  [[nodiscard]] QPushButton* button() const { return button_; }
  [[nodiscard]] QString tableText() const { return table_->text(); }

 signals:
  void requested(int count);

 private:
  void showProgress(int done, int all);
  void showTable();

  LoadMeasurement& measurement_;
  QSpinBox* count_;
  QPushButton* button_;
  QLabel* state_;
  QLabel* table_;
  QString obstacle_;
};

/// The figures of measured runs as rich text: median, least and most.
QString measurementTable(const std::vector<MeasuredRun>& runs);

}  // namespace footfall::ui
