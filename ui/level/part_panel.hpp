// The panel of meshes and materials: parts that are left out, and parts that are obstacles only.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTreeView>
#include <QWidget>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ui/document/document.hpp"
#include "ui/level/part_model.hpp"

namespace footfall::ui {

/// Edits the document's part rules; every edit is one entry of the undo stack, however many parts it changes.
class PartPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PartPanel(Document& document, QWidget* parent = nullptr);

  /// Shows an environment as its file gave it; null: none. Rows of the same name stay selected and expanded.
  void setEnvironment(const std::shared_ptr<const Environment>& environment);
  /// Sets the role of the selected rows as one edit.
  void setRole(PartRole role);

  [[nodiscard]] std::vector<std::uint32_t> selectedParts() const;
  [[nodiscard]] QTreeView* tree() const { return tree_; }
  [[nodiscard]] QLineEdit* filterField() const { return filter_; }
  [[nodiscard]] PartModel* model() const { return model_; }
  /// The row of a part as the tree shows it; invalid when the filter hides it.
  [[nodiscard]] QModelIndex rowOf(std::uint32_t part) const;

 signals:
  void selectionChanged(const std::vector<std::uint32_t>& parts);
  /// Emitted when the view should move to parts.
  void activated(const std::vector<std::uint32_t>& parts);

 private:
  void createWidgets();
  void createActions();
  /// Calls a function that resets the tree; rows of the same name stay selected and expanded.
  void keepingSelection(const std::function<void()>& change);
  void apply(const std::vector<std::uint32_t>& parts, const std::vector<PartRole>& roles, const QString& text);
  void include(const std::vector<std::uint32_t>& parts, bool on);
  void showFigures();
  [[nodiscard]] QString nameOf(const std::vector<std::uint32_t>& parts) const;

  Document& document_;
  PartModel* model_;
  QSortFilterProxyModel* proxy_;
  QTreeView* tree_;
  QLineEdit* filter_;
  QLabel *figures_, *empty_;
  std::vector<QAction*> roleActions_;
  std::map<std::pair<std::string, std::string>, PartRole> before_;  ///< roles of parts that boxes left out
  bool restoring_ = false;
};

}  // namespace footfall::ui
