// Places the widgets over the view so that they neither overlap nor are cut off.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QRect>
#include <QWidget>
#include <vector>

#include "ui/view/level_view.hpp"
#include "ui/view/widgets/height_slider.hpp"
#include "ui/view/widgets/legend.hpp"
#include "ui/view/widgets/overlay_frame.hpp"
#include "ui/view/widgets/view_hint.hpp"

namespace footfall::ui {

/// All widgets are children of the view; null and hidden ones take no place. Legends that the user has moved stay
/// there.
class ViewLayout : public QObject {
  Q_OBJECT

 public:
  /// Makes the legend and the heights; features set the others.
  explicit ViewLayout(LevelView& view);

  [[nodiscard]] Legend& legend() const { return *legend_; }          ///< lower left
  [[nodiscard]] HeightSlider& heights() const { return *heights_; }  ///< upper right, below the gizmo or beside it
  void setGizmo(QWidget* gizmo) { gizmo_ = gizmo; }                  ///< upper right
  /// Beside the heights, which it explains; below them in a narrow view.
  void setHint(ViewHint* hint) { hint_ = hint; }
  void setCellLegend(OverlayFrame* legend) { cells_ = legend; }  ///< lower right
  void setCutBar(QWidget* bar) { cutBar_ = bar; }                ///< upper left

  /// Called when one of them has been shown, hidden or changed.
  void update();
  /// The rectangles of the view that they cover.
  [[nodiscard]] std::vector<QRect> covered() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place(const QSize& view) const;

  LevelView& view_;
  Legend* legend_;
  HeightSlider* heights_;
  QPointer<QWidget> gizmo_, cutBar_;
  QPointer<ViewHint> hint_;
  QPointer<OverlayFrame> cells_;
};

}  // namespace footfall::ui
