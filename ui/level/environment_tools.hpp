// What belongs to the loaded environment beside reading it: roles of its parts, and following its file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QObject>
#include <cstdint>
#include <vector>

#include "ui/base/file_watch.hpp"
#include "ui/level/part_panel.hpp"
#include "ui/window/editor_window.hpp"

namespace footfall::ui {

/// A child of its window; found as window.findChild<EnvironmentTools*>().
class EnvironmentTools : public QObject {
  Q_OBJECT

 public:
  explicit EnvironmentTools(EditorWindow& window);

  [[nodiscard]] PartPanel& panel() { return *panel_; }
  [[nodiscard]] QDockWidget* dock() const { return dock_; }
  [[nodiscard]] FileWatch& watch() { return watch_; }

 private:
  void createPanel();
  void createWatch();
  void follow();
  void reread();
  void rereadIfPending();
  void highlight(const std::vector<std::uint32_t>& parts);
  void frame(const std::vector<std::uint32_t>& parts);
  [[nodiscard]] QString fileName() const;

  EditorWindow& window_;
  PartPanel* panel_ = nullptr;
  QDockWidget* dock_ = nullptr;
  FileWatch watch_;
  bool rereading_ = false;
  bool highlighted_ = false;  ///< the view's selection is ours
  bool pending_ = false;      ///< another version came while something was being read
};

}  // namespace footfall::ui
