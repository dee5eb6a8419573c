// The passage that limits a body on the path of "Try it": a dimension line in the view, and a button that goes there.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>
#include <optional>

#include "ui/base/text/level_units.hpp"
#include "ui/path/path_model.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// The button; hidden while there is no such place. Where the start or the target has too little room, the place is
/// one that has enough.
class PassageView : public QPushButton {
  Q_OBJECT

 public:
  PassageView(PathModel& model, LevelView& view, QWidget* parent = nullptr);

  void setUnits(const LevelUnits& units);
  /// `margin` is the size of the surroundings that are shown.
  void setMargin(double margin) { margin_ = margin; }
  /// Sets whether the place is drawn while the panel is hidden.
  void setShown(bool shown);
  /// The place with its surroundings; nothing where there is none.
  [[nodiscard]] std::optional<SceneBox> bounds() const;

 private:
  void update();

  PathModel& model_;
  LevelView& view_;
  LevelUnits units_;
  double margin_ = 1;
  bool shown_ = false;
};

}  // namespace footfall::ui
