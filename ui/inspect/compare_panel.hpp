// The panel "Compare": lists the regions that appeared and disappeared.
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

/// The colours of the difference in view, legend and panel: regions that only this result has, and regions that only
/// the other one has.
QColor appearedColour();
QColor wentColour();

/// Formats areas and places of the level.
struct CompareWriter {
  std::function<QString(double)> area;
  std::function<QString(const Vec3&)> place;
};

/// Shows a comparison and emits signals for the user's actions; computes nothing.
class ComparePanel : public QWidget {
  Q_OBJECT

 public:
  enum Choice { Nothing, LastEdit, SavedResult };
  static constexpr int kMostRows = 1000;

  explicit ComparePanel(QWidget* parent = nullptr);

  /// Sets what the result is compared with; `file` is the name of the saved result.
  void setChoice(Choice choice, const QString& file);
  /// Shows the reason why there is no difference.
  void showNote(const QString& note);
  void showDifference(const SurfaceDifference& difference, const CompareWriter& write);
  /// A further line below the summary.
  void addLine(const QString& line);
  /// Whether another difference is being computed.
  void setWaiting(bool waiting);

  [[nodiscard]] QCheckBox* distanceBox() const { return distance_; }
  [[nodiscard]] QComboBox* choiceBox() const { return choice_; }
  [[nodiscard]] QTableWidget* table() const { return table_; }
  [[nodiscard]] QString summary() const { return summary_->text(); }

 signals:
  void chosen(int choice);
  void distanceToggled(bool on);
  /// Emitted when a row is clicked, or Return is pressed on it; `region` is an index into SurfaceDifference::regions.
  void frameRequested(int region);

 private:
  QComboBox* choice_;
  QCheckBox* distance_;
  QLabel* summary_;
  QTableWidget* table_;
};

/// A text such as "appeared: 12.5 m²"; it shows an empty difference as exactly none.
QString appearedText(const SurfaceDifference& difference, const CompareWriter& write);
QString wentText(const SurfaceDifference& difference, const CompareWriter& write);

}  // namespace footfall::ui
