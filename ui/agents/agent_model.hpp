// A document's agents and what is known of their results, as a table.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <vector>

#include "ui/agents/agent_results.hpp"
#include "ui/base/level_units.hpp"
#include "ui/document/agent_rules.hpp"

namespace footfall::ui {

class AgentModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Name, Height, MaxSlope, Step, Radius, Area, Layers, ComponentCount, Connections, State, kColumns };

  AgentModel(Document& document, RunController& controller, AgentResults& results, QObject* parent = nullptr);

  void setUnits(const LevelUnits& units);
  /// 0: no agent.
  [[nodiscard]] int agentAt(int row) const;
  /// -1: not there.
  [[nodiscard]] int rowOf(int agent) const;
  /// The size that a column shows; nothing for other columns.
  [[nodiscard]] static std::optional<AgentSize> sizeIn(int column);
  /// Titles and all rows, as the table shows them.
  [[nodiscard]] std::vector<QStringList> rows() const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// A value out of range is refused, and failed() says why.
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

 signals:
  void failed(const QString& message);

 private:
  void follow();
  [[nodiscard]] QString lengthHelp(double length) const;
  [[nodiscard]] QString textIn(const NamedAgent& agent, int column) const;

  Document& document_;
  RunController& controller_;
  AgentResults& results_;
  LevelUnits units_;
  std::vector<int> ids_;
};

/// Columns as wide as their widest cell.
QString tableText(const std::vector<QStringList>& rows);
/// RFC 4180: quotes where they are needed.
QString tableCsv(const std::vector<QStringList>& rows);

}  // namespace footfall::ui
