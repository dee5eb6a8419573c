// The timeline of a run: a lane for each thread, and a bar for each cell with its filters. Empty parts of a lane are
// idle time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

#include "ui/cells/cell_model.hpp"
#include "ui/cells/timeline.hpp"

namespace footfall::ui {

class TimelineLanes;

/// Hovering and selecting change the model. The wheel zooms in time, dragging moves, and a double click shows
/// everything.
class TimelinePlot : public QCustomPlot {
  Q_OBJECT

 public:
  explicit TimelinePlot(CellModel& model, QWidget* parent = nullptr);

  [[nodiscard]] const Timeline& timeline() const { return timeline_; }
  /// The bar at a place of the widget; null over idle time and outside.
  [[nodiscard]] const Timeline::Bar* barAt(const QPointF& place) const;
  /// The middle of a bar, in the widget.
  [[nodiscard]] QPointF placeOf(const Timeline::Bar& bar) const;
  void showAll();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void rebuild();
  void limitRange(const QCPRange& range);
  [[nodiscard]] QString describe(const Timeline::Bar& bar, const QPointF& place) const;
  [[nodiscard]] QString describeIdle(const QPointF& place) const;
  [[nodiscard]] QString describeSerial(const Timeline::Serial& part) const;
  [[nodiscard]] QString describeOthers(double time) const;

  CellModel& model_;
  Timeline timeline_;
  TimelineLanes* lanes_;
  std::shared_ptr<const RunFigures> shownRun_;
  double shownEnd_ = -1;
  std::optional<QPointF> pressed_;
};

}  // namespace footfall::ui
