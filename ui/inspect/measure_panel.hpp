// The panel of "Measure": a row for each piece, to read and to copy.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

#include "ui/inspect/measure_tool.hpp"
#include "ui/level/import_panel.hpp"
#include "ui/level/level_composer.hpp"
#include "ui/level/level_file.hpp"
#include "ui/view/feature_host.hpp"

namespace footfall::ui {

class MeasurePanel : public QWidget {
  Q_OBJECT

 public:
  explicit MeasurePanel(MeasureTool& tool, QWidget* parent = nullptr);
  /// Opens a dialog for the length of the last piece in metres.
  void askForLength();

 signals:
  void scaleChosen(double metresPerUnit);

 private:
  void showPlaces();

  MeasureTool& tool_;
  QTableWidget* table_;
  QLabel *sum_, *frame_ = nullptr;
  QPushButton *copy_, *back_, *scale_, *clear_;
};

/// The tool "Measure" with its panel; its places are removed with their environment.
class MeasureFeature : public QObject {
  Q_OBJECT

 public:
  MeasureFeature(const FeatureHost& host, LevelView& view, LevelFile& file, LevelComposer& composer,
                 ImportPanel& import);
  [[nodiscard]] MeasureTool& tool() { return tool_; }

 private:
  MeasureTool tool_;
};

}  // namespace footfall::ui
