// The panel "Left out": the polygons of the file that are not in the level, with the reasons.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QTableWidget>
#include <QWidget>
#include <functional>

#include "footfall/environment.hpp"

namespace footfall::ui {

class SkippedPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SkippedPanel(QWidget* parent = nullptr);

  /// `place` formats a place of the level.
  void show(const SkippedElements& skipped, const std::function<QString(const Vec3&)>& place);

  [[nodiscard]] QTableWidget* table() const { return table_; }
  [[nodiscard]] QString summary() const { return summary_->text(); }

 signals:
  /// Emitted when a row of the list is clicked, or Return is pressed on it.
  void frameRequested(int row);

 private:
  QLabel* summary_;
  QTableWidget* table_;
};

}  // namespace footfall::ui
