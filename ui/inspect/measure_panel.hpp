// The panel of "Measure": every piece as a row, to read and to copy.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

#include "ui/inspect/measure_tool.hpp"

namespace footfall::ui {

class EditorWindow;

class MeasurePanel : public QWidget {
  Q_OBJECT

 public:
  explicit MeasurePanel(MeasureTool& tool, QWidget* parent = nullptr);

 private:
  void showPlaces();

  MeasureTool& tool_;
  QTableWidget* table_;
  QLabel *sum_, *frame_ = nullptr;
  QPushButton *copy_, *back_, *clear_;
};

/// Brings "Measure" into the window: tool, panel, and taking back what belongs to another environment.
class MeasureFeature : public QObject {
  Q_OBJECT

 public:
  explicit MeasureFeature(EditorWindow& window);
  [[nodiscard]] MeasureTool& tool() { return tool_; }

 private:
  MeasureTool tool_;
};

}  // namespace footfall::ui
