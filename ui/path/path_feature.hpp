// Brings "Try it" into the window: tool, panel, what it walks on, and what sessions keep of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <string>

#include "ui/path/path_model.hpp"
#include "ui/path/path_panel.hpp"
#include "ui/path/path_tool.hpp"
#include "ui/path/separation_view.hpp"

class QDockWidget;

namespace footfall::ui {

class EditorWindow;

class PathFeature : public QObject {
  Q_OBJECT

 public:
  explicit PathFeature(EditorWindow& window);

  [[nodiscard]] PathModel& model() { return model_; }

 private:
  void takeResult();
  void follow();
  void boundSelection();
  [[nodiscard]] std::string save() const;
  void load(const std::string& text);

  EditorWindow& window_;
  PathModel model_;
  PathTool tool_;
  PathPanel* panel_;
  SeparationView* separation_;
  QDockWidget* dock_;
  std::string environment_;   ///< that the places lie in
  bool fromSession_ = false;  ///< they came with the file that is being opened
};

}  // namespace footfall::ui
