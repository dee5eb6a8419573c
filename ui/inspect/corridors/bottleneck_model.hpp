// The bottlenecks of the corridor map as a table.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <cstddef>
#include <memory>
#include <vector>

#include "ui/base/text/level_units.hpp"
#include "ui/inspect/corridors/corridor_watch.hpp"

namespace footfall::ui {

/// Narrowest first, by the rule of usualBottlenecks(). Rows are made when they are displayed, so that their number is
/// unlimited.
class BottleneckModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Width, Agent, Sides, Place, kColumns };

  using QAbstractTableModel::QAbstractTableModel;

  /// Null: no bottlenecks.
  void setShown(std::shared_ptr<const ShownCorridors> shown);
  void setUnits(const LevelUnits& units);
  /// Sets the width of an agent, in the file's units. Rows of narrower bottlenecks are grey, and say so.
  void setAgentWidth(double width);

  /// Leaves out bottlenecks that have a way around.
  void setOnlyWays(bool only);

  [[nodiscard]] const std::shared_ptr<const ShownCorridors>& shown() const { return shown_; }
  /// The bottleneck of a row, or null.
  [[nodiscard]] const Bottleneck* bottleneckOf(int row) const;
  [[nodiscard]] double agentWidth() const { return agentWidth_; }
  [[nodiscard]] int tooNarrow() const;
  /// The titles and all rows, with tabs and line ends.
  [[nodiscard]] QString toText() const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void list();
  [[nodiscard]] QString textOf(const Bottleneck& bottleneck, int column) const;
  [[nodiscard]] QString sidesOf(const Bottleneck& bottleneck) const;

  std::shared_ptr<const ShownCorridors> shown_;
  LevelUnits units_;
  double agentWidth_ = 0;
  bool onlyWays_ = false;
  std::vector<std::size_t> rows_;  ///< the bottlenecks of the map that are listed
};

}  // namespace footfall::ui
