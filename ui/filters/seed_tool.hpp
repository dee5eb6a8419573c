// The tool "Place seeds": a click places a seed, from which a ReachableFilter keeps everything that can be reached.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "ui/base/text/level_units.hpp"
#include "ui/document/document.hpp"
#include "ui/view/level_view.hpp"
#include "ui/view/view_tool.hpp"

namespace footfall::ui {

/// A click places a seed, a click with Ctrl or Shift on a seed removes it, Backspace removes the last one; seeds can be
/// dragged. Where the pipeline has no filter for seeds, the first click adds one.
///
/// A seed has to lie on or over its floor, exactly, and a clicked place has the precision of the view's floats. Seeds
/// are therefore placed a little higher, at numbers of few digits.
class SeedTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  SeedTool(Document& document, LevelView& view, QObject* parent);

  /// Sets the filter whose seeds are drawn and edited; -1: none.
  void setFilter(int id);
  [[nodiscard]] int filter() const { return filter_; }
  /// Sets whether seeds are drawn while the tool is not active.
  void setShown(bool shown);
  void setUnits(const LevelUnits& units);
  /// Sets the largest extent of the level, in its units.
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
  /// Emitted when the first click has added a filter.
  void filterAdded(int id);
  void draggingChanged(bool dragging);

 private:
  [[nodiscard]] std::optional<std::size_t> seedAt(const QPoint& place) const;
  /// The seed for a place of the level, along the file's axes.
  [[nodiscard]] Vec3 seedFor(const Vec3& place) const;
  void endDrag();
  void draw();

  Document& document_;
  LevelView& view_;
  LevelUnits units_;
  int filter_ = -1;
  double grain_ = 0.001;  ///< coordinates of placed seeds are multiples of this
  bool shown_ = false;
  std::optional<std::size_t> dragged_, hovered_;
  int session_ = 0;  ///< grows by one with each drag
};

}  // namespace footfall::ui
