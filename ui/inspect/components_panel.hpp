// The panel "Components": the connected parts of the walkable area.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>

#include "ui/inspect/components_model.hpp"

namespace footfall::ui {

/// Shows the components of an Inspector and emits a signal for the chosen one.
class ComponentsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ComponentsPanel(QWidget* parent = nullptr);

  /// Null: no components. The component with the chosen rank stays chosen if there is one.
  void setInspector(std::shared_ptr<const Inspector> inspector);
  void choose(std::uint32_t component);
  void setUnits(const LevelUnits& units);

  /// The panel is wide enough for all columns.
  [[nodiscard]] QSize sizeHint() const override;

  [[nodiscard]] ComponentsModel& model() { return model_; }
  [[nodiscard]] QTableView* table() const { return table_; }
  [[nodiscard]] QLineEdit* smallerThanField() const { return smallerThan_; }
  [[nodiscard]] QPushButton* copyButton() const { return copy_; }
  [[nodiscard]] QString totalText() const { return total_->text(); }

 signals:
  /// Emitted when a row becomes the current one.
  void chosen(std::uint32_t component);
  /// Emitted when a component is clicked, or Return is pressed on it.
  void frameRequested(std::uint32_t component);

 private:
  void filter();
  void describe();

  ComponentsModel model_;
  LevelUnits units_;
  QLineEdit* smallerThan_;
  QLabel* error_;
  QTableView* table_;
  QLabel* total_;
  QLabel* frame_;
  QPushButton* copy_;
};

}  // namespace footfall::ui
