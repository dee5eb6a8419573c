// Controls of the vertical cut plane, over the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QFrame>
#include <QSlider>
#include <QToolButton>
#include <optional>

#include "ui/base/text/level_units.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// Shown while there is a cut plane. The slider moves the plane through the level. "Facing the camera" fixes the
/// direction that the camera has at that moment.
class CutBar : public QFrame {
  Q_OBJECT

 public:
  enum class Facing { X, Y, Camera };

  explicit CutBar(LevelView& view);

  /// The plane cuts through the middle at first.
  void setUnits(const LevelUnits& units);
  void setOn(bool on);
  [[nodiscard]] bool on() const { return view_.cutPlane().has_value(); }
  void setPlane(const std::optional<CutPlane>& plane);
  void setFacing(Facing facing);
  [[nodiscard]] QSlider& slider() { return *slider_; }
  [[nodiscard]] QComboBox& facing() { return *facing_; }

 signals:
  /// Emitted when the plane is switched, moved or turned.
  void changed(bool on);
  void closed();

 private:
  void flip();
  void apply();
  void describe();
  struct Reach {
    double lower = 0, upper = 1;
  };
  [[nodiscard]] Reach reach() const;

  LevelView& view_;
  LevelUnits units_;
  double nx_ = 1, ny_ = 0;
  QComboBox* facing_;
  QSlider* slider_;
};

}  // namespace footfall::ui
