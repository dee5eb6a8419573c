// The panel "Compare": what appeared and what went, with the regions to go to.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QTableWidget>
#include <QWidget>
#include <functional>

#include "core/compare/surface_difference.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

/// The colours of the difference in view, legend and panel: what only this result has, and what only the other one has.
QColor appearedColour();
QColor wentColour();

/// How areas and places of the level are written.
struct CompareWriter {
  std::function<QString(double)> area;
  std::function<QString(const Vec3&)> place;
};

/// Shows a comparison and emits signals for what the user asks; computes nothing.
class ComparePanel : public QWidget {
  Q_OBJECT

 public:
  enum Choice { Nothing, LastEdit, SavedResult };
  static constexpr int kMostRows = 1000;

  explicit ComparePanel(QWidget* parent = nullptr);

  /// What it compares with; `file` is the name of the saved result.
  void setChoice(Choice choice, const QString& file);
  /// Says why there is no difference to show.
  void showNote(const QString& note);
  void showDifference(const SurfaceDifference& difference, const CompareWriter& write);
  /// Whether another difference is being computed.
  void setWaiting(bool waiting);

  [[nodiscard]] QCheckBox* distanceBox() const { return distance_; }
  [[nodiscard]] QComboBox* choiceBox() const { return choice_; }
  [[nodiscard]] QTableWidget* table() const { return table_; }
  [[nodiscard]] QString summary() const { return summary_->text(); }

 signals:
  void chosen(int choice);
  void distanceToggled(bool on);
  /// A row was clicked, or Return was pressed on it: a place in SurfaceDifference::regions.
  void frameRequested(int region);

 private:
  QComboBox* choice_;
  QCheckBox* distance_;
  QLabel* summary_;
  QTableWidget* table_;
};

/// "appeared: 12.5 m²"; nothing is exactly none.
QString appearedText(const SurfaceDifference& difference, const CompareWriter& write);
QString wentText(const SurfaceDifference& difference, const CompareWriter& write);

}  // namespace footfall::ui
