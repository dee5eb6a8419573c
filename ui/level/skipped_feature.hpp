// Elements that import left out: a panel, a button that opens it, and marks in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QObject>
#include <QPushButton>

#include "ui/level/import_panel.hpp"
#include "ui/level/level_file.hpp"
#include "ui/level/skipped_panel.hpp"
#include "ui/view/feature_host.hpp"

namespace footfall::ui {

/// A child of its window; found as window.findChild<SkippedFeature*>().
class SkippedFeature : public QObject {
  Q_OBJECT

 public:
  SkippedFeature(const FeatureHost& host, LevelView& view, LevelFile& file, ImportPanel& import);

  [[nodiscard]] SkippedPanel& panel() { return *panel_; }
  /// The button in the panel of the environment; hidden while nothing was left out.
  [[nodiscard]] QPushButton* showButton() const { return show_; }

 private:
  void follow();
  void frame(int row);

  LevelView& view_;
  LevelFile& file_;
  UnitChoice& units_;
  StatusLine& status_;
  SkippedPanel* panel_;
  QDockWidget* dock_;
  QPushButton* show_;
};

}  // namespace footfall::ui
