// Shared by all readers of Assimp's scenes: transforms in doubles, the walk over the nodes, and names of parts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <assimp/material.h>
#include <assimp/scene.h>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "core/environment/part_names.hpp"
#include "core/io/affine.hpp"

namespace footfall::detail {

inline Affine toAffine(const aiMatrix4x4& m) {
  return {{{m.a1, m.a2, m.a3, m.a4}, {m.b1, m.b2, m.b3, m.b4}, {m.c1, m.c2, m.c3, m.c4}}};
}

inline Vec3 operator*(const Affine& m, const aiVector3D& p) { return m * Vec3{p.x, p.y, p.z}; }

/// Calls visit(node, number of a mesh, transform to the world) for all meshes of all nodes, depth first. The stack is
/// on the heap, because a file may nest its nodes deeper than the call stack.
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

/// The part of a mesh. It has the node's name, which users see as an object in their editors, else the mesh's name.
/// Names that Assimp makes up are ignored.
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
