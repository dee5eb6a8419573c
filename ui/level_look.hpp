// How the level is looked at: the mode, hidden layers, heights and the cut plane, with their commands and docks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <set>
#include <string>

#include "ui/editor_window.hpp"
#include "ui/layer_panel.hpp"

namespace footfall {

/// Lives as long as the window. Kept in sessions as the section "look".
class LevelLook : public QObject {
  Q_OBJECT

 public:
  explicit LevelLook(EditorWindow& window);

  [[nodiscard]] LayerPanel& layers() { return *layers_; }

 private:
  void addLayers();
  void stepFloor(int direction);
  [[nodiscard]] std::string save() const;
  void load(const std::string& text);
  void takeEnvironment();

  EditorWindow& window_;
  LayerPanel* layers_ = nullptr;
  QString source_;  ///< the file whose level is shown
  /// Of a session whose environment is about to be shown.
  struct Kept {
    std::set<std::uint32_t> hidden;
    HeightRange heights;
  };
  std::optional<Kept> pending_;
};

/// For EditorWindow::createFeatures().
void installLevelLook(EditorWindow& window);

}  // namespace footfall
