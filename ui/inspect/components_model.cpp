// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/components_model.hpp"

#include <QStringList>
#include <algorithm>
#include <utility>

#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kMostLayers = 6;  // number of layers that are named one by one

QString layersText(const std::vector<std::uint32_t>& layers) {
  QStringList texts;
  for (std::size_t i = 0; i < std::min(layers.size(), kMostLayers); ++i) texts << QString::number(layers[i]);
  if (layers.size() > kMostLayers) texts << QStringLiteral("…");
  return texts.join(QStringLiteral(", "));
}

}  // namespace

void ComponentsModel::setInspector(std::shared_ptr<const Inspector> inspector) {
  beginResetModel();
  inspector_ = std::move(inspector);
  findFirst();
  endResetModel();
}

void ComponentsModel::setUnits(const LevelUnits& units) {
  units_ = units;
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
  emit headerDataChanged(Qt::Horizontal, 0, kColumns - 1);
}

void ComponentsModel::setSmallerThan(std::optional<double> area) {
  if (area == smallerThan_) return;
  beginResetModel();
  smallerThan_ = area;
  findFirst();
  endResetModel();
}

// Components are sorted by area.
void ComponentsModel::findFirst() {
  first_ = 0;
  shownArea_ = 0;
  if (!inspector_) return;
  const std::vector<Component>& list = inspector_->components().list;
  if (smallerThan_)
    first_ = static_cast<std::uint32_t>(
        std::partition_point(list.begin(), list.end(), [&](const Component& c) { return c.area >= *smallerThan_; }) -
        list.begin());
  for (std::size_t i = first_; i < list.size(); ++i) shownArea_ += list[i].area;
}

int ComponentsModel::rowOf(std::uint32_t component) const {
  if (component < first_ || !inspector_ || component >= inspector_->components().list.size()) return -1;
  return static_cast<int>(component - first_);
}

int ComponentsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !inspector_ ? 0 : static_cast<int>(inspector_->components().list.size() - first_);
}

int ComponentsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QString ComponentsModel::textOf(std::uint32_t component, int column) const {
  const Component& c = inspector_->components().list[component];
  switch (column) {
    case Rank:
      return countText(component + 1);
    case Area:
      return shortText(c.area * units_.factor(Unit::Area));
    case Triangles:
      return countText(c.triangles);
    case Layers:
      return layersText(c.layers);
    case Centre:
      return units_.placeNumbers(c.centre);
    default:
      return {};
  }
}

QVariant ComponentsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  if (role == Qt::DisplayRole) return textOf(componentOf(index.row()), index.column());
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>((index.column() < Layers ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  return {};
}

QVariant ComponentsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::DisplayRole) {
    switch (section) {
      case Rank:
        return tr("Rank");
      case Area:
        return tr("Area (%1)").arg(units_.areaName());
      case Triangles:
        return tr("Triangles");
      case Layers:
        return tr("Layers");
      case Centre:
        return tr("Centre (%1)").arg(units_.name());
      default:
        return {};
    }
  }
  if (role == Qt::ToolTipRole && section == Centre) return tr("Centre of mass. %1").arg(units_.frameText());
  if (role == Qt::ToolTipRole && section == Area) return tr("Of the surface; the largest is the first");
  return {};
}

QString ComponentsModel::toText() const {
  QString text;
  for (int column = 0; column < kColumns; ++column)
    text += (column > 0 ? QStringLiteral("\t") : QString()) +
            headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
  text += QLatin1Char('\n');
  for (int row = 0; row < rowCount(); ++row) {
    for (int column = 0; column < kColumns; ++column)
      text += (column > 0 ? QStringLiteral("\t") : QString()) + textOf(componentOf(row), column);
    text += QLatin1Char('\n');
  }
  return text;
}

}  // namespace footfall::ui
