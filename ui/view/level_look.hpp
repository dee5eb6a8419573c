// How the level is looked at: the mode, hidden layers, heights and the cut plane, with their commands and docks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QObject>
#include <QString>
#include <optional>
#include <set>
#include <string>

#include "ui/view/cut_bar.hpp"
#include "ui/view/layer_panel.hpp"
#include "ui/view/view_hint.hpp"
#include "ui/view/view_modes.hpp"
#include "ui/window/editor_window.hpp"

namespace footfall::ui {

/// Lives as long as the window. Kept in sessions as the section "look".
class LevelLook : public QObject {
  Q_OBJECT

 public:
  explicit LevelLook(EditorWindow& window);

  [[nodiscard]] LayerPanel& layers() { return *layers_; }
  [[nodiscard]] ViewModes& modes() { return modes_; }
  [[nodiscard]] CutBar& cutBar() { return *cutBar_; }

 private:
  void addLayers();
  void addCutPlane();
  void addInside();
  void stepFloor(int direction);
  [[nodiscard]] std::string save() const;
  void load(const std::string& text);
  void takeEnvironment();

  EditorWindow& window_;
  ViewModes modes_;
  LayerPanel* layers_ = nullptr;
  CutBar* cutBar_ = nullptr;
  QAction* inside_ = nullptr;
  ViewHint* hint_ = nullptr;
  bool fresh_ = false;  ///< there is no result yet of what has been opened
  QString source_;      ///< the file whose level is shown
  /// Of a session whose environment is about to be shown.
  struct Kept {
    std::set<std::uint32_t> hidden;
    HeightRange heights;
    ViewMode mode = ViewMode::Result;
    std::optional<CutPlane> cut;
    bool inside = true;
  };
  std::optional<Kept> pending_;
};

/// For EditorWindow::createFeatures().
void installLevelLook(EditorWindow& window);

}  // namespace footfall::ui
