// What all readers of Assimp's scenes need: transforms in doubles, the walk over the nodes, and names of parts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <assimp/material.h>
#include <assimp/scene.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "core/environment/part_names.hpp"

namespace footfall::detail {

/// The upper three rows of an affine transform.
using Affine = std::array<std::array<double, 4>, 3>;

inline constexpr Affine kIdentity{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

inline Affine toAffine(const aiMatrix4x4& m) {
  return {{{m.a1, m.a2, m.a3, m.a4}, {m.b1, m.b2, m.b3, m.b4}, {m.c1, m.c2, m.c3, m.c4}}};
}

inline Affine operator*(const Affine& a, const Affine& b) {
  Affine product;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      product[row][column] = a[row][0] * b[0][column] + a[row][1] * b[1][column] + a[row][2] * b[2][column] +
                             (column == 3 ? a[row][3] : 0.0);
    }
  }
  return product;
}

inline Vec3 operator*(const Affine& m, const aiVector3D& p) {
  const double x = p.x, y = p.y, z = p.z;
  return {m[0][0] * x + m[0][1] * y + m[0][2] * z + m[0][3], m[1][0] * x + m[1][1] * y + m[1][2] * z + m[1][3],
          m[2][0] * x + m[2][1] * y + m[2][2] * z + m[2][3]};
}

inline double determinant(const Affine& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Calls visit(node, number of a mesh, transform to the world) for all meshes of all nodes, depth first, with a stack
/// of our own: a file may nest its nodes deeper than the call stack is.
template <class Visit>
void visitMeshes(const aiScene& scene, const Affine& rootTransform, const Visit& visit) {
  std::vector<std::pair<const aiNode*, Affine>> stack{{scene.mRootNode, rootTransform}};
  while (!stack.empty()) {
    const auto [node, world] = stack.back();
    stack.pop_back();
    for (unsigned i = 0; i < node->mNumMeshes; ++i) visit(*node, node->mMeshes[i], world);
    for (unsigned i = node->mNumChildren; i-- > 0;) {
      const aiNode* child = node->mChildren[i];
      stack.emplace_back(child, world * toAffine(child->mTransformation));
    }
  }
}

/// The part of a mesh, named by the node, which is what users see as an object in their editors, else by the mesh. What
/// Assimp makes up where a file has no names is none.
inline std::uint32_t partOfMesh(const aiScene& scene, const aiNode& node, const aiMesh& mesh, PartList& parts) {
  const auto given = [](const aiString& name) {
    const std::string_view text(name.C_Str());
    const bool isMadeUp = text.starts_with('<') && text.ends_with('>');
    return isMadeUp ? std::string_view() : text;
  };
  std::string_view meshName = given(node.mName);
  if (meshName.empty()) meshName = given(mesh.mName);
  aiString material;
  if (mesh.mMaterialIndex < scene.mNumMaterials) scene.mMaterials[mesh.mMaterialIndex]->Get(AI_MATKEY_NAME, material);
  const std::string_view materialName = given(material);
  return parts.numberOf(meshName, materialName == AI_DEFAULT_MATERIAL_NAME ? std::string_view() : materialName);
}

}  // namespace footfall::detail
