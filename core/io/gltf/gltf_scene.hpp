// The tree of nodes of a glTF 2.0 file: which meshes stand where, and what they are called.
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

/// What is wrong with a file.
struct BadGltf {
  Text what;
};
[[noreturn]] inline void failGltf(Text what) { throw BadGltf{std::move(what)}; }

/// The element of an array of the file, `name` being one of those at its top. Throws BadGltf where there is none.
const nlohmann::json& gltfItem(const nlohmann::json& file, const char* name, std::uint64_t number);
/// A member that is a number from 0 on; `missing` where it is not there. Throws BadGltf for anything else.
std::uint64_t gltfNumber(const nlohmann::json& object, const char* name, std::optional<std::uint64_t> missing = {});
/// A member that is an array; an empty one where it is not there.
const nlohmann::json& gltfArray(const nlohmann::json& object, const char* name);
/// A member that is an object; an empty one where it is not there.
const nlohmann::json& gltfObject(const nlohmann::json& object, const char* name);
/// A member that is a text; empty where it is not.
std::string gltfText(const nlohmann::json& object, const char* name);

struct GltfScene {
  std::vector<Affine> worlds;      ///< of each node of the file, from it to the world
  std::vector<std::size_t> nodes;  ///< those of the scene that is to be shown, depth first
};

/// Transforms of all nodes, multiplied in doubles. Throws BadGltf for a node with two parents, or that is its own.
GltfScene gltfScene(const nlohmann::json& file);

/// Translation, rotation (a quaternion of any length but 0) and scale.
Affine gltfTransform(const std::array<double, 3>& translation, std::array<double, 4> rotation,
                     const std::array<double, 3>& scale);

/// The part of a primitive: named by the node, else by its mesh, and by the material.
std::uint32_t gltfPart(const nlohmann::json& file, const nlohmann::json& node, const nlohmann::json& primitive,
                       PartList& parts);

}  // namespace footfall::detail
