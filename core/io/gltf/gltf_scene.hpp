// The node tree of a glTF 2.0 file: the places of its meshes and their names.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/environment/part_names.hpp"
#include "core/io/affine.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// Thrown for an invalid file; says what is wrong.
struct BadGltf {
  Text what;
};
[[noreturn]] inline void failGltf(Text what) { throw BadGltf{std::move(what)}; }

/// An element of one of the file's top-level arrays, `name`. Throws BadGltf where there is none.
const nlohmann::json& gltfItem(const nlohmann::json& file, const char* name, std::uint64_t number);
/// A member that is a number of at least 0; `missing` where it is absent. Throws BadGltf for anything else.
std::uint64_t gltfNumber(const nlohmann::json& object, const char* name, std::optional<std::uint64_t> missing = {});
/// A member that is an array; an empty one where it is absent.
const nlohmann::json& gltfArray(const nlohmann::json& object, const char* name);
/// A member that is an object; an empty one where it is absent.
const nlohmann::json& gltfObject(const nlohmann::json& object, const char* name);
/// A member that is a text; empty where it is absent.
std::string gltfText(const nlohmann::json& object, const char* name);

struct GltfScene {
  std::vector<Affine> worlds;      ///< transform of each node of the file to the world
  std::vector<std::size_t> nodes;  ///< nodes of the scene that the file displays, depth first
};

/// Transforms of all nodes, multiplied in doubles. Throws BadGltf for a node with two parents, or that is its own
/// ancestor.
GltfScene gltfScene(const nlohmann::json& file);

/// The transform of a translation, a rotation (a quaternion of any length but 0) and a scale.
Affine gltfTransform(const std::array<double, 3>& translation, std::array<double, 4> rotation,
                     const std::array<double, 3>& scale);

/// The part of a primitive: named by the node, else by its mesh, and by the material.
std::uint32_t gltfPart(const nlohmann::json& file, const nlohmann::json& node, const nlohmann::json& primitive,
                       PartList& parts);

}  // namespace footfall::detail
