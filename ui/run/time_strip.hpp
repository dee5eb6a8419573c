// Bars of the steps' time: one in each row of the filter list, and a summary above it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QWidget>
#include <optional>

#include "ui/run/time_shares.hpp"

namespace footfall::ui {

/// The colour of the step `index` of TimeShares, in rows and in the summary.
QColor timeColour(std::size_t index);

/// A thin line whose filled part is a step's share; it takes no room without a share.
class ShareBar : public QWidget {
  Q_OBJECT

 public:
  explicit ShareBar(QWidget* parent = nullptr);
  void setShare(std::optional<double> share, const QColor& colour);
  [[nodiscard]] std::optional<double> share() const { return share_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<double> share_;
  QColor colour_;
};

/// All steps in one bar, with the names of the longest above it.
class TimeStrip : public QWidget {
  Q_OBJECT

 public:
  explicit TimeStrip(QWidget* parent = nullptr);
  void setShares(const TimeShares& shares);
  [[nodiscard]] QString text() const { return text_; }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QRect barRect() const;

  TimeShares shares_;
  QString text_;
};

}  // namespace footfall::ui
