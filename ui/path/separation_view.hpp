// What keeps start and target of a path apart: a line in the panel, and a mark in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <functional>
#include <optional>

#include "ui/path/path_model.hpp"
#include "ui/path/separation_mend.hpp"
#include "ui/path/separation_text.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// Hidden while nothing keeps them apart.
class SeparationView : public QWidget {
  Q_OBJECT

 public:
  SeparationView(PathModel& model, LevelView& view, QWidget* parent = nullptr);

  /// How lengths and places are written.
  void setWriter(LevelWriter writer);
  /// `margin`: how much of the surroundings is shown with it.
  void setMargin(double margin) { margin_ = margin; }
  /// What the button offers to change.
  void setMends(std::function<std::optional<SeparationMend>(const Separation& separation)> mends);
  /// Looks again at what can be changed.
  void refreshMend();
  /// Draws the mark, also while the panel is hidden.
  void setShown(bool shown);
  /// Brings the largest link into sight.
  void frame();

  [[nodiscard]] QString text() const { return text_->text(); }
  [[nodiscard]] QPushButton* showButton() const { return show_; }

 signals:
  void mendRequested(const footfall::ui::SeparationMend& mend);

 private:
  void update();

  PathModel& model_;
  LevelView& view_;
  LevelWriter write_;
  double margin_ = 1;
  bool shown_ = false;
  QLabel* text_;
  QPushButton *show_, *mend_;
  std::function<std::optional<SeparationMend>(const Separation&)> mends_;
};

}  // namespace footfall::ui
