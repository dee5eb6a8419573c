// Floor plans of the result, drawn in the background.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include "core/report/floor_plan.hpp"
#include "ui/level/level_file.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/feature_host.hpp"
#include "ui/window/file_writer.hpp"

namespace footfall::ui {

/// A command in the file menu, a dialog, and what is written then.
class FloorPlans : public QObject {
  Q_OBJECT

 public:
  FloorPlans(const FeatureHost& host, const LevelFile& level, const RunController& controller, FileWriter& writer);

  void showDialog();
  /// Draws the last finished result; its ending chooses between PDF and SVG. Reports where there is none of the filters
  /// as they are.
  void write(const QString& path, const detail::PlanOptions& options);

 private:
  void askForTarget(const detail::PlanOptions& options);

  QWidget& window_;
  MessageBar& messages_;
  const LevelFile& level_;
  const RunController& controller_;
  FileWriter& writer_;
};

}  // namespace footfall::ui
