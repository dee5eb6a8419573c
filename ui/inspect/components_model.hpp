// The components of the walkable area as a table.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <optional>

#include "footfall/inspect.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/level_units.hpp"

namespace footfall::ui {

/// Sorted by area, the largest first. Rows are made when they are displayed, so that the number of components is
/// unlimited.
class ComponentsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Rank, Area, Triangles, Layers, Centre, kColumns };

  using QAbstractTableModel::QAbstractTableModel;

  /// Null: no components.
  void setInspector(std::shared_ptr<const Inspector> inspector);
  void setUnits(const LevelUnits& units);
  /// Leaves out all components of this area or more; empty: none.
  void setSmallerThan(std::optional<double> area);

  [[nodiscard]] const std::shared_ptr<const Inspector>& inspector() const { return inspector_; }
  /// The component of a row, as an index into Components::list.
  [[nodiscard]] std::uint32_t componentOf(int row) const { return static_cast<std::uint32_t>(row) + first_; }
  /// The row of a component; -1 where it is left out.
  [[nodiscard]] int rowOf(std::uint32_t component) const;
  [[nodiscard]] double shownArea() const { return shownArea_; }
  /// The titles and all shown rows, with tabs and line ends.
  [[nodiscard]] QString toText() const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void findFirst();
  [[nodiscard]] QString textOf(std::uint32_t component, int column) const;

  std::shared_ptr<const Inspector> inspector_;
  std::optional<double> smallerThan_;
  LevelUnits units_;
  std::uint32_t first_ = 0;  ///< the first component that is shown; all later ones are shown too
  double shownArea_ = 0;
};

}  // namespace footfall::ui
