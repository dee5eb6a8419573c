// The panel "Why?": the explanation of a place, with links to the filters and triangles involved.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <memory>

#include "footfall/inspect.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/level_units.hpp"

namespace footfall::ui {

/// Shows an explanation and emits signals for the user's actions; computes nothing.
class WhyPanel : public QWidget {
  Q_OBJECT

 public:
  explicit WhyPanel(QWidget* parent = nullptr);

  void show(const std::shared_ptr<const Inspector>& inspector, const PlaceExplanation& told, const LevelUnits& units);
  /// Shows how to use the tool.
  void clear();
  /// Shows that a new explanation is being computed; the present one may be out of date.
  void setWaiting(bool waiting);

  [[nodiscard]] QString headline() const { return headline_->text(); }
  [[nodiscard]] QString reason() const { return reason_->text(); }
  [[nodiscard]] QPushButton* obstacleButton() const { return frameObstacle_; }
  [[nodiscard]] QPushButton* placeButton() const { return framePlace_; }
  [[nodiscard]] QPushButton* filterButton() const { return showFilter_; }

 signals:
  void framePlaceRequested();
  void frameObstacleRequested();
  void showFilterRequested();

 private:
  QWidget* makeEmptyPage();
  QWidget* makeAnswerPage();
  QLabel* addFigure(class QGridLayout* grid, const QString& name, const QString& objectName);

  QStackedWidget* pages_;
  QLabel* swatch_ = nullptr;
  QLabel* headline_ = nullptr;
  QLabel* reason_ = nullptr;
  QLabel* place_ = nullptr;
  QLabel* frame_ = nullptr;
  QLabel* triangle_ = nullptr;
  QLabel* slope_ = nullptr;
  QLabel* headroom_ = nullptr;
  QLabel* borders_ = nullptr;
  QPushButton* framePlace_ = nullptr;
  QPushButton* frameObstacle_ = nullptr;
  QPushButton* showFilter_ = nullptr;
};

}  // namespace footfall::ui
