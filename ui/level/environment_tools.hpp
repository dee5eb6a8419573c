// The roles of the environment's parts, and reloading its file when it changes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QObject>
#include <cstdint>
#include <vector>

#include "ui/base/files/file_watch.hpp"
#include "ui/level/import_panel.hpp"
#include "ui/level/level_composer.hpp"
#include "ui/level/level_file.hpp"
#include "ui/level/part_panel.hpp"
#include "ui/view/feature_host.hpp"

namespace footfall::ui {

/// A child of its window; found as window.findChild<EnvironmentTools*>().
class EnvironmentTools : public QObject {
  Q_OBJECT

 public:
  EnvironmentTools(const FeatureHost& host, LevelView& view, Document& document, LevelFile& file,
                   LevelComposer& composer, ImportPanel& import);

  /// Called when the editor has written this file: when it is the level's own, it is not read again.
  void acknowledge(const QString& path);

  [[nodiscard]] PartPanel& panel() { return *panel_; }
  [[nodiscard]] QDockWidget* dock() const { return dock_; }
  [[nodiscard]] FileWatch& watch() { return watch_; }

 private:
  void createPanel(const FeatureHost& host);
  void createWatch(ImportPanel& import);
  void follow();
  void reread();
  void rereadIfPending();
  void highlight(const std::vector<std::uint32_t>& parts);
  void frame(const std::vector<std::uint32_t>& parts);
  [[nodiscard]] QString fileName() const;

  LevelView& view_;
  Document& document_;
  LevelFile& file_;
  LevelComposer& composer_;
  MessageBar& messages_;
  PartPanel* panel_ = nullptr;
  QDockWidget* dock_ = nullptr;
  FileWatch watch_;
  bool rereading_ = false;
  bool highlighted_ = false;  ///< the view's selection shows parts
  bool pending_ = false;      ///< another version was saved while a file was being read
};

}  // namespace footfall::ui
