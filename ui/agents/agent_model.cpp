// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/agents/agent_model.hpp"

#include <QFont>
#include <algorithm>

#include "ui/agents/agent_edits.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

Unit unitOf(AgentSize size) { return parameterOf(size).unit; }

}  // namespace

AgentModel::AgentModel(Document& document, RunController& controller, AgentResults& results, QObject* parent)
    : QAbstractTableModel(parent), document_(document), controller_(controller), results_(results) {
  connect(&document_, &Document::agentsChanged, this, &AgentModel::follow);
  connect(&results_, &AgentResults::changed, this, &AgentModel::follow);
  connect(&controller_, &RunController::statusChanged, this, &AgentModel::follow);
  follow();
}

// The model is reset only where rows were added or removed, because a reset would end editing in the table.
void AgentModel::follow() {
  std::vector<int> ids;
  for (const NamedAgent& agent : document_.state().agents) ids.push_back(agent.id);
  if (ids != ids_) {
    beginResetModel();
    ids_ = std::move(ids);
    endResetModel();
  } else if (!ids_.empty()) {
    emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
  }
}

void AgentModel::setUnits(const LevelUnits& units) {
  units_ = units;
  follow();
  emit headerDataChanged(Qt::Horizontal, 0, kColumns - 1);
}

int AgentModel::agentAt(int row) const {
  return row >= 0 && row < static_cast<int>(ids_.size()) ? ids_[static_cast<std::size_t>(row)] : 0;
}

int AgentModel::rowOf(int agent) const {
  const auto found = std::ranges::find(ids_, agent);
  return found == ids_.end() ? -1 : static_cast<int>(found - ids_.begin());
}

std::optional<AgentSize> AgentModel::sizeIn(int column) {
  if (column == Height) return AgentSize::Height;
  if (column == MaxSlope) return AgentSize::MaxSlope;
  if (column == Step) return AgentSize::Step;
  if (column == Gap) return AgentSize::Gap;
  if (column == Radius) return AgentSize::Radius;
  if (column == Drop) return AgentSize::Drop;
  return std::nullopt;
}

int AgentModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(ids_.size());
}

int AgentModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int{kColumns}; }

QString AgentModel::textIn(const NamedAgent& agent, int column) const {
  if (column == Name) return QString::fromStdString(agent.name);
  if (const auto size = sizeIn(column)) return numberText(units_.shown(sizeOf(agent, *size), unitOf(*size)));
  if (column == State) {
    const bool active = agent.id == document_.state().agent;
    if (active && controller_.busy()) return tr("running");
    if (active && controller_.upToDate()) return tr("shown");
    return results_.ready(agent.id) ? tr("ready") : tr("not computed");
  }
  const auto figures = results_.figures(agent.id);
  if (!figures) return QStringLiteral("–");
  switch (column) {
    case Area:
      return units_.areaNumber(figures->area);
    case Layers:
      return figures->layers == 0 ? QStringLiteral("–") : countText(figures->layers);
    case ComponentCount:
      return countText(figures->components);
    default:
      return countText(figures->connections);
  }
}

// A length in the file's units, where the table shows other units.
QString AgentModel::lengthHelp(double length) const {
  return units_.factor() == 1 ? QString() : tr("%1 units of the file").arg(shortText(length));
}

QVariant AgentModel::data(const QModelIndex& index, int role) const {
  const auto& agents = document_.state().agents;
  const auto agent = std::ranges::find(agents, agentAt(index.row()), &NamedAgent::id);
  if (!index.isValid() || agent == agents.end()) return {};
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return textIn(*agent, index.column());
    case Qt::TextAlignmentRole:
      return QVariant(index.column() == Name || index.column() == State ? Qt::AlignLeft | Qt::AlignVCenter
                                                                        : Qt::AlignRight | Qt::AlignVCenter);
    case Qt::FontRole: {
      QFont font;
      font.setBold(agent->id == document_.state().agent);
      return font;
    }
    case Qt::ToolTipRole:
      if (index.column() == Height) return lengthHelp(agent->height);
      if (index.column() == Step) return lengthHelp(agent->step);
      if (index.column() == Gap) return lengthHelp(agent->gap);
      if (index.column() == Radius) return lengthHelp(agent->radius);
      if (index.column() == Drop) return lengthHelp(agent->drop);
      if (index.column() == Name && index.row() < 9) return tr("Alt+%1").arg(index.row() + 1);
      return {};
    default:
      return {};
  }
}

QVariant AgentModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant();
  if (role == Qt::DisplayRole) {
    switch (section) {
      case Name:
        return tr("Agent");
      case Height:
        return tr("Height (%1)").arg(units_.name());
      case MaxSlope:
        return tr("Slope (°)");
      case Step:
        return tr("Step (%1)").arg(units_.name());
      case Gap:
        return tr("Gap (%1)").arg(units_.name());
      case Radius:
        return tr("Radius (%1)").arg(units_.name());
      case Drop:
        return tr("Drop (%1)").arg(units_.name());
      case Area:
        return tr("Area (%1)").arg(units_.areaName());
      case Layers:
        return tr("Layers");
      case ComponentCount:
        return tr("Components");
      case Connections:
        return tr("Connections");
      default:
        return tr("Result");
    }
  }
  if (role != Qt::ToolTipRole) return {};
  switch (section) {
    case Height:
      return tr("The free height that the agent needs: the clearance of the filters");
    case MaxSlope:
      return tr("The steepest ground that the agent can walk on");
    case Step:
      return tr(
          "The highest step that the agent climbs, such as a stair or a kerb: the step of the filters. 0 means no "
          "filter for steps");
    case Gap:
      return tr("The widest gap that the agent steps over, seen from above: the gap of the filters for steps");
    case Radius:
      return tr(
          "The distance that the agent's middle keeps from walls and ledges: the radius of the filters. 0 means no "
          "filter for it");
    case Drop:
      return tr(
          "The deepest drop that the agent takes from a ledge, one way: the depth of the filters. 0 means no filter "
          "for drops");
    case ComponentCount:
      return tr("Parts of the walkable area that an agent cannot leave");
    case Connections:
      return tr("Edges on which two layers meet");
    case State:
      return tr("Ready: switching to the agent shows its result at once");
    default:
      return {};
  }
}

Qt::ItemFlags AgentModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return index.column() == Name || sizeIn(index.column()) ? flags | Qt::ItemIsEditable : flags;
}

bool AgentModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const int agent = agentAt(index.row());
  if (role != Qt::EditRole || agent == 0) return false;
  if (index.column() == Name) {
    renameAgent(document_, agent, value.toString());
    return true;
  }
  const auto size = sizeIn(index.column());
  if (!size) return false;
  const auto number = parseNumber(value.toString());
  const double stored = number ? units_.stored(*number, unitOf(*size)) : 0;
  const QString wrong = number
                            ? coreText(checkValue(parameterOf(*size), stored))
                            : tr("'%1' is not a number; write for example %2").arg(value.toString(), numberText(1.8));
  if (!wrong.isEmpty()) {
    emit failed(tr("agent: %1").arg(wrong));
    return false;
  }
  resizeAgent(document_, agent, *size, stored);
  return true;
}

std::vector<QStringList> AgentModel::rows() const {
  std::vector<QStringList> rows(1);
  for (int column = 0; column < State; ++column)
    rows[0] << headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
  for (int row = 0; row < rowCount(); ++row) {
    QStringList& fields = rows.emplace_back();
    for (int column = 0; column < State; ++column) fields << index(row, column).data().toString();
  }
  return rows;
}

QString tableText(const std::vector<QStringList>& rows) {
  std::vector<qsizetype> widths(static_cast<std::size_t>(rows.empty() ? 0 : rows[0].size()), 0);
  for (const QStringList& row : rows) {
    for (std::size_t i = 0; i < widths.size(); ++i)
      widths[i] = std::max(widths[i], row[static_cast<qsizetype>(i)].size());
  }
  QString text;
  for (const QStringList& row : rows) {
    QStringList fields;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const QString& field = row[static_cast<qsizetype>(i)];
      fields << (i == 0 ? field.leftJustified(widths[i]) : field.rightJustified(widths[i]));
    }
    text += fields.join(QStringLiteral("  ")) + QLatin1Char('\n');
  }
  return text;
}

QString tableCsv(const std::vector<QStringList>& rows) {
  QString text;
  for (const QStringList& row : rows) {
    QStringList fields;
    for (QString field : row) {
      if (field.contains(QLatin1Char(',')) || field.contains(QLatin1Char('"')) || field.contains(QLatin1Char('\n')))
        field = QLatin1Char('"') + field.replace(QLatin1Char('"'), QLatin1String("\"\"")) + QLatin1Char('"');
      fields << field;
    }
    text += fields.join(QLatin1Char(',')) + QStringLiteral("\r\n");
  }
  return text;
}

}  // namespace footfall::ui
