// The parts of an environment as a tree: meshes, and under them their materials.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/environment/part_rules.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

/// A mesh with one material is one row; so is a material without a mesh. Rows of meshes with several materials stand
/// for all of them. The check box leaves parts out or includes them; a part that was an obstacle only is included as
/// one again.
class PartModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  enum Column { Name, Triangles, Role, kColumns };
  static constexpr int kSortRole = Qt::UserRole;

  explicit PartModel(QObject* parent = nullptr);

  /// The environment as its file gave it; null: none.
  void setEnvironment(std::shared_ptr<const Environment> environment);
  void setRules(const std::vector<PartRule>& rules);

  /// The parts of a row.
  [[nodiscard]] std::vector<std::uint32_t> partsOf(const QModelIndex& index) const;
  /// The row of a part.
  [[nodiscard]] QModelIndex indexOf(std::uint32_t part) const;
  /// The role of a part that no rule of the document names.
  [[nodiscard]] PartRole usualRoleOf(std::uint32_t part) const;
  [[nodiscard]] PartRole roleOf(std::uint32_t part) const { return roles_[part]; }
  [[nodiscard]] const std::vector<PartRole>& roles() const { return roles_; }
  [[nodiscard]] const EnvironmentPart& part(std::uint32_t part) const { return parts_[part]; }
  [[nodiscard]] std::uint64_t trianglesOf(std::uint32_t part) const { return counts_[part]; }
  [[nodiscard]] std::size_t partCount() const { return parts_.size(); }
  static QString roleText(PartRole role);

  [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  [[nodiscard]] QModelIndex parent(const QModelIndex& child) const override;
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Requests roles; the document then calls setRules().
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 signals:
  void inclusionAsked(const std::vector<std::uint32_t>& parts, bool include);

 private:
  struct Mesh {
    std::vector<std::uint32_t> parts;
    std::uint64_t triangles = 0;
  };
  [[nodiscard]] const Mesh* meshAt(const QModelIndex& index) const;
  [[nodiscard]] bool isMaterial(const QModelIndex& index) const;
  [[nodiscard]] QString nameOf(const QModelIndex& index) const;
  [[nodiscard]] std::uint64_t countOf(const QModelIndex& index) const;
  [[nodiscard]] QString rolesText(const std::vector<std::uint32_t>& parts) const;
  [[nodiscard]] Qt::CheckState included(const std::vector<std::uint32_t>& parts) const;

  std::shared_ptr<const Environment> environment_;
  std::vector<EnvironmentPart> parts_;
  std::vector<std::uint64_t> counts_;
  std::vector<PartRole> roles_;
  std::vector<Mesh> meshes_;
  std::vector<std::array<int, 2>> places_;  ///< for each part, its mesh and its place in it
};

}  // namespace footfall::ui
