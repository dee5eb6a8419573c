// A legend of the cells' colours in the view, which also chooses the cells that are shown.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QLabel>

#include "ui/cells/cell_model.hpp"
#include "ui/view/widgets/overlay_frame.hpp"

namespace footfall::ui {

/// Lies in a corner of the view at first. Its box chooses the colouring of the model.
class CellLegend : public OverlayFrame {
  Q_OBJECT

 public:
  CellLegend(CellModel& model, QWidget* parent);

  /// The text beside the colours.
  [[nodiscard]] QString text() const { return text_->text(); }

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

}  // namespace footfall::ui
