// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/part_model.hpp"

#include <QFont>
#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "core/environment/part_names.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

constexpr quintptr kTopLevel = ~quintptr{0};  // other values are the row of the mesh

}  // namespace

PartModel::PartModel(QObject* parent) : QAbstractItemModel(parent) {}

void PartModel::setEnvironment(std::shared_ptr<const Environment> environment) {
  beginResetModel();
  environment_ = std::move(environment);
  parts_.clear();
  counts_.clear();
  meshes_.clear();
  places_.clear();
  if (environment_) {
    parts_ = environment_->parts;
    counts_ = countPartTriangles(*environment_);
    if (parts_.empty()) {
      parts_.emplace_back();
      counts_ = {environment_->triangles.size()};
    }
  }
  std::map<std::string, std::size_t> known;
  for (std::uint32_t p = 0; p < parts_.size(); ++p) {
    const auto [entry, isNew] = known.try_emplace(parts_[p].mesh, meshes_.size());
    const bool alone = isNew || parts_[p].mesh.empty();
    if (alone) meshes_.emplace_back();
    const std::size_t row = alone ? meshes_.size() - 1 : entry->second;
    Mesh& mesh = meshes_[row];
    places_.push_back({static_cast<int>(row), static_cast<int>(mesh.parts.size())});
    mesh.parts.push_back(p);
    mesh.triangles += counts_[p];
  }
  roles_.clear();
  for (std::uint32_t part = 0; part < partCount(); ++part) roles_.push_back(usualRoleOf(part));
  endResetModel();
}

PartRole PartModel::usualRoleOf(std::uint32_t part) const {
  return environment_ ? usualRole(*environment_, part) : PartRole::Floor;
}

void PartModel::setRules(const std::vector<PartRule>& rules) {
  if (!environment_) return;
  std::vector<PartRole> roles = rolesOf(*environment_, rules);
  if (roles == roles_) return;
  roles_ = std::move(roles);
  const int last = static_cast<int>(meshes_.size()) - 1;
  emit dataChanged(index(0, 0), index(last, kColumns - 1));
  for (int row = 0; row <= last; ++row) {
    const QModelIndex mesh = index(row, 0);
    if (const int rows = rowCount(mesh); rows > 0)
      emit dataChanged(index(0, 0, mesh), index(rows - 1, kColumns - 1, mesh));
  }
}

const PartModel::Mesh* PartModel::meshAt(const QModelIndex& index) const {
  if (!index.isValid()) return nullptr;
  return &meshes_[isMaterial(index) ? static_cast<std::size_t>(index.internalId())
                                    : static_cast<std::size_t>(index.row())];
}

bool PartModel::isMaterial(const QModelIndex& index) const { return index.internalId() != kTopLevel; }

std::vector<std::uint32_t> PartModel::partsOf(const QModelIndex& index) const {
  const Mesh* mesh = meshAt(index);
  if (mesh == nullptr) return {};
  if (isMaterial(index)) return {mesh->parts[static_cast<std::size_t>(index.row())]};
  return mesh->parts;
}

QModelIndex PartModel::indexOf(std::uint32_t part) const {
  const auto [mesh, place] = places_[part];
  const QModelIndex row = index(mesh, 0);
  return meshes_[static_cast<std::size_t>(mesh)].parts.size() == 1 ? row : index(place, 0, row);
}

QString PartModel::nameOf(const QModelIndex& index) const {
  const std::vector<std::uint32_t> parts = partsOf(index);
  const EnvironmentPart& first = parts_[parts.front()];
  const QString mesh = QString::fromStdString(first.mesh), material = QString::fromStdString(first.material);
  if (isMaterial(index)) return material.isEmpty() ? tr("(no material)") : material;
  if (mesh.isEmpty()) return material.isEmpty() ? tr("(unnamed)") : material;
  if (parts.size() > 1 || material.isEmpty() || material == mesh) return mesh;
  return tr("%1 · %2", "mesh and its only material").arg(mesh, material);
}

std::uint64_t PartModel::countOf(const QModelIndex& index) const {
  const Mesh* mesh = meshAt(index);
  return isMaterial(index) ? counts_[mesh->parts[static_cast<std::size_t>(index.row())]] : mesh->triangles;
}

QString PartModel::roleText(PartRole role) {
  switch (role) {
    case PartRole::ObstacleOnly:
      return tr("obstacle only");
    case PartRole::Ignored:
      return tr("ignored");
    case PartRole::Floor:
      break;
  }
  return tr("as usual");
}

QString PartModel::rolesText(const std::vector<std::uint32_t>& parts) const {
  const PartRole first = roles_[parts.front()];
  const bool same = std::ranges::all_of(parts, [&](std::uint32_t part) { return roles_[part] == first; });
  return same ? roleText(first) : tr("mixed");
}

Qt::CheckState PartModel::included(const std::vector<std::uint32_t>& parts) const {
  const auto ignored =
      std::ranges::count_if(parts, [&](std::uint32_t part) { return roles_[part] == PartRole::Ignored; });
  if (ignored == 0) return Qt::Checked;
  return ignored == static_cast<std::ptrdiff_t>(parts.size()) ? Qt::Unchecked : Qt::PartiallyChecked;
}

QModelIndex PartModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) : kTopLevel);
}

QModelIndex PartModel::parent(const QModelIndex& child) const {
  if (!child.isValid() || !isMaterial(child)) return {};
  return createIndex(static_cast<int>(child.internalId()), 0, kTopLevel);
}

int PartModel::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return static_cast<int>(meshes_.size());
  if (isMaterial(parent) || parent.column() != 0) return 0;
  const std::size_t parts = meshes_[static_cast<std::size_t>(parent.row())].parts.size();
  return parts > 1 ? static_cast<int>(parts) : 0;
}

int PartModel::columnCount(const QModelIndex&) const { return kColumns; }

QVariant PartModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const std::vector<std::uint32_t> parts = partsOf(index);
  switch (role) {
    case Qt::DisplayRole:
    case kSortRole:
      if (index.column() == Name) return nameOf(index);
      if (index.column() == Role) return rolesText(parts);
      if (role == kSortRole) return static_cast<qulonglong>(countOf(index));
      return countText(countOf(index));
    case Qt::CheckStateRole:
      return index.column() == Name ? QVariant(included(parts)) : QVariant();
    case Qt::TextAlignmentRole:
      return index.column() == Triangles ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    case Qt::FontRole: {
      QFont font;
      font.setStrikeOut(index.column() == Name && included(parts) == Qt::Unchecked);
      font.setItalic(index.column() == Role && rolesText(parts) != roleText(PartRole::Floor));
      return font;
    }
    case Qt::ToolTipRole: {
      const EnvironmentPart& part = parts_[parts.front()];
      const QString mesh = QString::fromStdString(part.mesh), material = QString::fromStdString(part.material);
      if (parts.size() > 1) return tr("Mesh: %1\n%2 materials").arg(mesh).arg(parts.size());
      return tr("Mesh: %1\nMaterial: %2")
          .arg(mesh.isEmpty() ? tr("(no name)") : mesh, material.isEmpty() ? tr("(no name)") : material);
    }
    case Qt::AccessibleTextRole:
      if (index.column() != Name) return {};
      return tr("%1, %2, triangles: %3").arg(nameOf(index), rolesText(parts)).arg(countOf(index));
    default:
      return {};
  }
}

QVariant PartModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole && section == Triangles) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  return section == Name ? tr("Mesh, material") : section == Triangles ? tr("Triangles") : tr("Role");
}

Qt::ItemFlags PartModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractItemModel::flags(index);
  if (index.isValid() && index.column() == Name) flags |= Qt::ItemIsUserCheckable;
  return flags;
}

bool PartModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || role != Qt::CheckStateRole) return false;
  emit inclusionAsked(partsOf(index), value.toInt() != Qt::Unchecked);
  return true;
}

}  // namespace footfall::ui
