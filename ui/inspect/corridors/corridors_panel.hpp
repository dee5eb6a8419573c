// The panel "Corridors": the colours of the map's widths, an agent's width, and the list of bottlenecks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QWidget>

#include "ui/base/widgets/number_field.hpp"
#include "ui/inspect/corridors/bottleneck_model.hpp"

namespace footfall::ui {

class CorridorsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit CorridorsPanel(QWidget* parent = nullptr);

  /// Null: there is no map, and `note` says why.
  void show(std::shared_ptr<const ShownCorridors> shown, const QString& note);
  /// Greys what belongs to an older result.
  void setWaiting(bool waiting);
  void setUnits(const LevelUnits& units);
  void setAgentWidth(double width);
  [[nodiscard]] double agentWidth() const { return width_->value(); }
  void setMapShown(bool shown) { map_->setChecked(shown); }
  [[nodiscard]] bool isMapShown() const { return map_->isChecked(); }

  /// Lists only bottlenecks that are the only way between their sides.
  void setOnlyWays(bool only) { only_->setChecked(only); }
  [[nodiscard]] bool hasOnlyWays() const { return only_->isChecked(); }

  [[nodiscard]] BottleneckModel& model() { return model_; }
  [[nodiscard]] QTableView* table() const { return table_; }
  [[nodiscard]] NumberField* widthField() const { return width_; }
  [[nodiscard]] QString summary() const { return summary_->text(); }

  [[nodiscard]] QSize sizeHint() const override;

 signals:
  void agentWidthChanged();
  /// Emitted after agentWidthChanged() where the user has entered it.
  void agentWidthEdited();
  void mapToggled(bool shown);
  void onlyWaysToggled(bool only);
  /// A row was chosen; -1: none.
  void chosen(int row);
  void frameRequested(int row);

 private:
  void describe();
  void describeColours();

  BottleneckModel model_;
  LevelUnits units_;
  QString note_;
  NumberField* width_;
  QLabel *unit_, *problem_, *colours_, *summary_, *frame_;
  QCheckBox *map_, *only_;
  QTableView* table_;
  QPushButton* copy_;
};

}  // namespace footfall::ui
