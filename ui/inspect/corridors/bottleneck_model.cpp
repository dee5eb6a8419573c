// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/corridors/bottleneck_model.hpp"

#include <QBrush>
#include <QGuiApplication>
#include <QPalette>
#include <QPixmap>
#include <utility>

#include "ui/inspect/corridors/corridor_colours.hpp"

namespace footfall::ui {

void BottleneckModel::setShown(std::shared_ptr<const ShownCorridors> shown) {
  if (shown == shown_) return;
  beginResetModel();
  shown_ = std::move(shown);
  list();
  endResetModel();
}

void BottleneckModel::setOnlyWays(bool only) {
  if (only == onlyWays_) return;
  beginResetModel();
  onlyWays_ = only;
  list();
  endResetModel();
}

void BottleneckModel::list() {
  rows_.clear();
  if (!shown_) return;
  const CorridorMap& map = shown_->map;
  for (const std::size_t i : shown_->list.listed)
    if (!onlyWays_ || map.bottlenecks[i].isOnlyWay) rows_.push_back(i);
}

void BottleneckModel::setUnits(const LevelUnits& units) {
  if (units == units_) return;
  beginResetModel();
  units_ = units;
  endResetModel();
}

void BottleneckModel::setAgentWidth(double width) {
  if (width == agentWidth_) return;
  agentWidth_ = width;
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

const Bottleneck* BottleneckModel::bottleneckOf(int row) const {
  if (row < 0 || row >= rowCount()) return nullptr;
  return &shown_->map.bottlenecks[rows_[static_cast<std::size_t>(row)]];
}

int BottleneckModel::tooNarrow() const {
  int count = 0;
  for (const Bottleneck* b = bottleneckOf(0); b && b->width < agentWidth_; b = bottleneckOf(count)) ++count;
  return count;
}

QString BottleneckModel::toText() const {
  QStringList lines;
  QStringList titles;
  for (int column = 0; column < kColumns; ++column)
    titles << headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
  lines << titles.join(QLatin1Char('\t'));
  for (int row = 0; row < rowCount(); ++row) {
    QStringList fields;
    for (int column = 0; column < kColumns; ++column) fields << textOf(*bottleneckOf(row), column);
    lines << fields.join(QLatin1Char('\t'));
  }
  return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

int BottleneckModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int BottleneckModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QString BottleneckModel::sidesOf(const Bottleneck& b) const {
  if (b.isOnlyWay) return tr("%1 | %2, the only way").arg(units_.area(b.sides[0].area), units_.area(b.sides[1].area));
  const auto widest = [&](std::size_t side) {
    return units_.length(shown_->map.vertices[b.sides.at(side).widest].width);
  };
  return tr("up to %1 | %2 wide").arg(widest(0), widest(1));
}

QString BottleneckModel::textOf(const Bottleneck& bottleneck, int column) const {
  switch (column) {
    case Width:
      return units_.lengthNumber(bottleneck.width);
    case Agent:
      return bottleneck.width < agentWidth_ ? tr("too narrow") : tr("fits");
    case Sides:
      return sidesOf(bottleneck);
    default:
      return units_.placeNumbers(bottleneck.place);
  }
}

QVariant BottleneckModel::data(const QModelIndex& index, int role) const {
  const Bottleneck* bottleneck = bottleneckOf(index.row());
  if (!bottleneck) return {};
  const bool isTooNarrow = bottleneck->width < agentWidth_;
  switch (role) {
    case Qt::DisplayRole:
      return textOf(*bottleneck, index.column());
    case Qt::TextAlignmentRole:
      return index.column() == Width ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    case Qt::ForegroundRole:
      return isTooNarrow ? QVariant(QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text)) : QVariant();
    case Qt::DecorationRole: {
      if (index.column() != Agent) return {};
      QPixmap swatch(12, 12);
      swatch.fill(colourOfWidth(bottleneck->width, agentWidth_));
      return swatch;
    }
    case Qt::ToolTipRole:  // columns may be narrower than their texts
      return tr("Sides: %1").arg(sidesOf(*bottleneck)) + QLatin1Char('\n') + units_.place(bottleneck->place);
    default:
      return {};
  }
}

QVariant BottleneckModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::ToolTipRole && section == Sides)
    return tr(
        "The widest place on either side that is reached without going through anything as narrow. Where there is "
        "no other way: the walkable areas on both sides");
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case Width:
      return tr("Width (%1)").arg(units_.name());
    case Agent:
      return tr("Agent");
    case Sides:
      return tr("Sides");
    case Place:
      return tr("Place (%1)").arg(units_.name());
    default:
      return {};
  }
}

}  // namespace footfall::ui
