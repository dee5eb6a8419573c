// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/gltf/gltf_scene.hpp"

#include <array>
#include <cmath>

namespace footfall::detail {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kNone = ~std::size_t{0};

template <std::size_t Count>
std::array<double, Count> numbersOf(const Json& node, const char* name, const std::array<double, Count>& missing) {
  const auto found = node.find(name);
  if (found == node.end()) return missing;
  if (!found->is_array() || found->size() != Count) failGltf(FOOTFALL_TEXT("the transform of a node is invalid"));
  std::array<double, Count> numbers{};
  for (std::size_t i = 0; i < Count; ++i) {
    if (!(*found)[i].is_number()) failGltf(FOOTFALL_TEXT("the transform of a node is invalid"));
    numbers[i] = (*found)[i].template get<double>();
  }
  return numbers;
}

Affine transformOf(const Json& node) {
  if (node.contains("matrix")) {
    const auto m = numbersOf<16>(node, "matrix", {});  // column by column
    return {{{m[0], m[4], m[8], m[12]}, {m[1], m[5], m[9], m[13]}, {m[2], m[6], m[10], m[14]}}};
  }
  return gltfTransform(numbersOf<3>(node, "translation", {0, 0, 0}), numbersOf<4>(node, "rotation", {0, 0, 0, 1}),
                       numbersOf<3>(node, "scale", {1, 1, 1}));
}

/// The number of each node's parent, or kNone.
std::vector<std::size_t> parentsOf(const Json& nodes) {
  std::vector<std::size_t> parents(nodes.size(), kNone);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const Json& child : gltfArray(nodes[i], "children")) {
      const std::uint64_t number = child.is_number_unsigned() ? child.get<std::uint64_t>() : kNone;
      if (number >= nodes.size()) failGltf(FOOTFALL_TEXT("a node refers to a child that does not exist"));
      if (parents[number] != kNone) failGltf(Text(FOOTFALL_TEXT("node %1 is the child of more than one node"), number));
      parents[number] = i;
    }
  return parents;
}

/// The roots of the scene that the file displays, or all nodes without a parent.
std::vector<std::size_t> rootsOf(const Json& file, const std::vector<std::size_t>& parents) {
  std::vector<std::size_t> roots;
  const Json& scenes = gltfArray(file, "scenes");
  if (!scenes.empty()) {
    for (const Json& root : gltfArray(gltfItem(file, "scenes", gltfNumber(file, "scene", 0)), "nodes")) {
      const std::uint64_t number = root.is_number_unsigned() ? root.get<std::uint64_t>() : kNone;
      if (number >= parents.size()) failGltf(FOOTFALL_TEXT("the scene refers to a node that does not exist"));
      roots.push_back(number);
    }
    return roots;
  }
  for (std::size_t i = 0; i < parents.size(); ++i)
    if (parents[i] == kNone) roots.push_back(i);
  return roots;
}

/// Calls visit(node) for `roots` and all nodes below them, depth first, with a stack on the heap.
template <class Visit>
void visitDepthFirst(const Json& nodes, const std::vector<std::size_t>& roots, const Visit& visit) {
  std::vector<std::size_t> stack(roots.rbegin(), roots.rend());
  std::vector<bool> seen(nodes.size(), false);
  while (!stack.empty()) {
    const std::size_t node = stack.back();
    stack.pop_back();
    if (seen[node]) failGltf(Text(FOOTFALL_TEXT("node %1 appears twice in the scene"), node));
    seen[node] = true;
    visit(node);
    const Json& children = gltfArray(nodes[node], "children");
    for (std::size_t i = children.size(); i-- > 0;) stack.push_back(children[i].get<std::size_t>());
  }
}

}  // namespace

const Json& gltfItem(const Json& file, const char* name, std::uint64_t number) {
  const Json& all = gltfArray(file, name);
  if (number >= all.size() || !all[number].is_object())
    failGltf(Text(FOOTFALL_TEXT("number %1 of its %2 is not there"), number, name));
  return all[number];
}

std::uint64_t gltfNumber(const Json& object, const char* name, std::optional<std::uint64_t> missing) {
  const auto found = object.find(name);
  if (found == object.end()) {
    if (missing) return *missing;
    failGltf(Text(FOOTFALL_TEXT("'%1' is missing"), name));
  }
  if (found->is_number_unsigned()) return found->get<std::uint64_t>();
  // Some exporters write integers with a point.
  const double value = found->is_number_float() ? found->get<double>() : -1;
  if (!(value >= 0 && value < 1e15 && value == std::floor(value)))
    failGltf(Text(FOOTFALL_TEXT("'%1' is no number that can stand there"), name));
  return static_cast<std::uint64_t>(value);
}

const Json& gltfArray(const Json& object, const char* name) {
  static const Json kEmpty = Json::array();
  const auto found = object.find(name);
  if (found == object.end()) return kEmpty;
  if (!found->is_array()) failGltf(Text(FOOTFALL_TEXT("'%1' is not a list"), name));
  return *found;
}

const Json& gltfObject(const Json& object, const char* name) {
  static const Json kEmpty = Json::object();
  const auto found = object.find(name);
  if (found == object.end()) return kEmpty;
  if (!found->is_object()) failGltf(Text(FOOTFALL_TEXT("'%1' is not an object"), name));
  return *found;
}

std::string gltfText(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

Affine gltfTransform(const std::array<double, 3>& translation, std::array<double, 4> rotation,
                     const std::array<double, 3>& scale) {
  const double x = rotation[0], y = rotation[1], z = rotation[2], w = rotation[3];
  const double length = x * x + y * y + z * z + w * w, s = length > 0 ? 2 / length : 0;
  const Affine turned{{{1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w), 0},
                       {s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w), 0},
                       {s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y), 0}}};
  Affine all = turned;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) all[row][column] *= scale[column];
    all[row][3] = translation[row];
  }
  return all;
}

GltfScene gltfScene(const Json& file) {
  const Json& nodes = gltfArray(file, "nodes");
  for (const Json& node : nodes)
    if (!node.is_object()) failGltf(FOOTFALL_TEXT("a node is not an object"));
  const std::vector<std::size_t> parents = parentsOf(nodes);
  GltfScene scene;
  scene.worlds.assign(nodes.size(), kIdentity);
  std::vector<std::size_t> tops;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (parents[i] == kNone) tops.push_back(i);
  visitDepthFirst(nodes, tops, [&](std::size_t node) {
    const Affine own = transformOf(nodes[node]);
    scene.worlds[node] = parents[node] == kNone ? own : scene.worlds[parents[node]] * own;
  });
  visitDepthFirst(nodes, rootsOf(file, parents), [&](std::size_t node) { scene.nodes.push_back(node); });
  return scene;
}

std::uint32_t gltfPart(const Json& file, const Json& node, const Json& primitive, PartList& parts) {
  std::string name = gltfText(node, "name");
  if (name.empty()) name = gltfText(gltfItem(file, "meshes", gltfNumber(node, "mesh")), "name");
  std::string material;
  if (primitive.contains("material"))
    material = gltfText(gltfItem(file, "materials", gltfNumber(primitive, "material")), "name");
  return parts.numberOf(name, material);
}

}  // namespace footfall::detail
