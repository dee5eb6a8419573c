// What the colours of the cells in the view mean, and which of them are shown.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QFrame>
#include <QLabel>

#include "ui/cell_model.hpp"

namespace footfall {

/// Lies in a corner of the view. Its box chooses the colouring of the model.
class CellLegend : public QFrame {
  Q_OBJECT

 public:
  CellLegend(CellModel& model, QWidget* parent);

  [[nodiscard]] QComboBox* colouringBox() const { return colouring_; }
  /// The text beside the colours.
  [[nodiscard]] QString text() const { return text_->text(); }

 signals:
  void resized();

 private:
  void describe();
  void describeThreads(const CellScale& scale);
  void describeScale(const CellScale& scale);

  CellModel& model_;
  QLabel* title_;
  QComboBox* colouring_;
  QLabel* colours_;
  QLabel* text_;
  QLabel* unfinished_;
};

}  // namespace footfall
