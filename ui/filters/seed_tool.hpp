// The tool "Place seeds": clicks the places from where a ReachableFilter keeps what can be reached.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "ui/base/level_units.hpp"
#include "ui/document/document.hpp"
#include "ui/view/level_view.hpp"
#include "ui/view/view_tool.hpp"

namespace footfall::ui {

/// A click places a seed, one with Ctrl or Shift on a seed removes it, Backspace the last one; seeds are dragged. Where
/// the pipeline has no filter for seeds, the first click adds one.
///
/// A seed has to lie at or over its floor, exactly, and what is clicked is known as well as the view's floats can tell.
/// So seeds are put a little higher, on numbers of few digits.
class SeedTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  SeedTool(Document& document, LevelView& view, QObject* parent);

  /// The filter whose seeds are drawn and edited; -1: none.
  void setFilter(int id);
  [[nodiscard]] int filter() const { return filter_; }
  /// Draws seeds, also while the tool does not have the mouse.
  void setShown(bool shown);
  void setUnits(const LevelUnits& units);
  /// The largest extent of the level, in its units.
  void setExtent(double extent);

  bool mousePressed(const ViewMouse& mouse) override;
  void mouseMoved(const ViewMouse& mouse) override;
  void mouseReleased(const ViewMouse& mouse) override;
  void clicked(const ViewMouse& mouse) override;
  bool keyPressed(const QKeyEvent& event) override;
  void mouseLeft() override;
  void ended() override;
  [[nodiscard]] QString hint() const override;

 signals:
  void hintChanged(const QString& hint);
  /// The first click added a filter.
  void filterAdded(int id);
  void draggingChanged(bool dragging);

 private:
  [[nodiscard]] std::optional<std::size_t> seedAt(const QPoint& place) const;
  /// Along the file's axes, for a place of the level.
  [[nodiscard]] Vec3 seedFor(const Vec3& place) const;
  void endDrag();
  void draw();

  Document& document_;
  LevelView& view_;
  LevelUnits units_;
  int filter_ = -1;
  double grain_ = 0.001;  ///< what coordinates of placed seeds are multiples of
  bool shown_ = false;
  std::optional<std::size_t> dragged_, hovered_;
  int session_ = 0;  ///< one more with each drag
};

}  // namespace footfall::ui
