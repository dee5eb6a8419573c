// Paints the timeline, as a plottable of QCustomPlot.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

#include "ui/cells/cell_model.hpp"
#include "ui/cells/timeline.hpp"

namespace footfall::ui {

/// Lanes lie along the value axis, lane i from i - kHalfLane to i + kHalfLane; the key axis is the time.
class TimelineLanes : public QCPAbstractPlottable {
  Q_OBJECT

 public:
  static constexpr double kHalfLane = 0.42;

  TimelineLanes(QCPAxis* time, QCPAxis* lanes, const CellModel& model, const Timeline& timeline);

  /// Updates the colours of the cells of all blocks; called after the model's figures have changed.
  void takeColours();

  double selectTest(const QPointF& pos, bool onlySelectable, QVariant* details) const override;
  QCPRange getKeyRange(bool& found, QCP::SignDomain domain) const override;
  QCPRange getValueRange(bool& found, QCP::SignDomain domain, const QCPRange& keys) const override;

 protected:
  void draw(QCPPainter* painter) override;
  void drawLegendIcon(QCPPainter* painter, const QRectF& rect) const override;

 private:
  [[nodiscard]] QRectF place(int lane, double start, double end, double from, double to) const;
  void drawIdle(QCPPainter* painter) const;
  void drawBands(QCPPainter* painter) const;
  void drawSerial(QCPPainter* painter) const;
  void drawOthers(QCPPainter* painter) const;
  void drawBar(QCPPainter* painter, const Timeline::Bar& bar) const;
  void drawMark(QCPPainter* painter, const std::optional<CellId>& cell, const QColor& colour) const;
  [[nodiscard]] QColor colourOf(const Timeline::Bar& bar) const;

  const CellModel& model_;
  const Timeline& timeline_;
  std::vector<CellScale> scales_;
};

QString labelOf(Timeline::Phase phase);
QString labelOf(const Timeline::Serial& part);

}  // namespace footfall::ui
