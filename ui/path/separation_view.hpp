// Shows the barrier between start and target of a path: a line in the panel, and a mark in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <functional>
#include <optional>

#include "ui/path/path_model.hpp"
#include "ui/path/separation_mend.hpp"
#include "ui/path/separation_view_text.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// Hidden while there is no barrier.
class SeparationView : public QWidget {
  Q_OBJECT

 public:
  SeparationView(PathModel& model, LevelView& view, QWidget* parent = nullptr);

  /// Sets how lengths and places are formatted.
  void setWriter(LevelWriter writer);
  /// `margin` is the size of the surroundings that are shown.
  void setMargin(double margin) { margin_ = margin; }
  /// Sets the function that finds the change that the button offers.
  void setMends(std::function<std::optional<SeparationMend>(const Separation& separation)> mends);
  /// Updates the offered change.
  void refreshMend();
  /// Sets whether the mark is drawn while the panel is hidden.
  void setShown(bool shown);
  /// Moves the camera to the largest link.
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
