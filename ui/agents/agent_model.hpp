// A table model of a document's agents and the known figures of their results.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <vector>

#include "ui/agents/agent_results.hpp"
#include "ui/base/text/level_units.hpp"
#include "ui/document/agent_rules.hpp"

namespace footfall::ui {

class AgentModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column {
    Name,
    Height,
    MaxSlope,
    Step,
    Gap,
    Radius,
    Drop,
    Area,
    Layers,
    ComponentCount,
    Connections,
    State,
    kColumns
  };

  AgentModel(Document& document, RunController& controller, AgentResults& results, QObject* parent = nullptr);

  void setUnits(const LevelUnits& units);
  /// The agent's id; 0: no agent.
  [[nodiscard]] int agentAt(int row) const;
  /// The row of an agent; -1: not there.
  [[nodiscard]] int rowOf(int agent) const;
  /// The size that a column shows; empty for other columns.
  [[nodiscard]] static std::optional<AgentSize> sizeIn(int column);
  /// The titles and all rows, as the table shows them.
  [[nodiscard]] std::vector<QStringList> rows() const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Refuses a value out of range; failed() is emitted with the reason.
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

/// Plain text with columns as wide as their widest entry.
QString tableText(const std::vector<QStringList>& rows);
/// CSV by RFC 4180, with quotes where they are needed.
QString tableCsv(const std::vector<QStringList>& rows);

}  // namespace footfall::ui
