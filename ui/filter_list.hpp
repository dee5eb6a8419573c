// The pipeline as a list of rows that can be added to, dragged and edited.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <vector>

#include "ui/filter_row.hpp"
#include "ui/run_controller.hpp"

namespace footfall {

/// Shows a document's filters with the states of a controller's steps; edits go to the document.
class FilterList : public QWidget {
  Q_OBJECT

 public:
  FilterList(Document& document, const RunController& controller, QWidget* parent = nullptr);

  [[nodiscard]] const std::vector<FilterRow*>& rows() const { return rows_; }
  [[nodiscard]] QToolButton* addButton() const { return add_; }
  /// New filters take their defaults in this scale.
  void setMetresPerUnit(double metresPerUnit) { metresPerUnit_ = metresPerUnit; }

 signals:
  /// Somebody wants to see the cells of a strategy.
  void previewRequested(int id);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fillAddMenu();
  void showFilters();
  void showStatuses();
  /// Wrapped notes need more height than their smallest: the scroll area must not squeeze rows.
  void giveRowsTheirHeight();
  FilterRow* makeRow(const FilterEntry& entry);
  void beginDrag(FilterRow* row);
  void moveDrag(const QPoint& globalPosition);
  void endDrag(bool drop);
  bool moveByKey(FilterRow* row, int direction);
  /// The gap between rows nearest to a height: 0 before the first row.
  [[nodiscard]] std::size_t gapAt(int y) const;

  Document& document_;
  const RunController& controller_;
  double metresPerUnit_ = 1;
  QToolButton* add_;
  QScrollArea* scroll_;
  QWidget* content_;
  QVBoxLayout* layout_;
  QFrame* dropLine_;
  QLabel* empty_;
  std::vector<FilterRow*> rows_;
  FilterRow* dragged_ = nullptr;
  std::size_t dropGap_ = 0;
};

}  // namespace footfall
