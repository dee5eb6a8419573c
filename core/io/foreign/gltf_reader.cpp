// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/foreign/gltf_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "core/base/counted_text.hpp"
#include "core/environment/part_names.hpp"
#include "core/environment/skipped_polygons.hpp"
#include "core/io/foreign/gltf_buffers.hpp"
#include "core/io/foreign/gltf_decoders.hpp"
#include "core/io/gltf/gltf_scene.hpp"
#include "core/io/input_file.hpp"

namespace footfall::detail {
namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kTriangles = 4, kStrip = 5, kFan = 6;

/// The part of a primitive that does not depend on its node.
struct Shape {
  std::vector<Vec3> places;
  std::vector<Triangle> triangles;
  std::uint64_t lines = 0, points = 0;
  /// Four joints and their weights for each vertex and each set; empty without a skin.
  std::vector<GltfNumbers> joints, weights;
};

Affine matrixAt(const GltfNumbers& numbers, std::size_t element) {
  Affine m;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column) m[row][column] = numbers.at(element, column * 4 + row);
  return m;
}

/// Makes triangles of corners; strips and fans have three corners for each triangle, lines and points none.
void makeTriangles(std::uint64_t mode, const std::vector<std::uint32_t>& corners, Shape& shape) {
  const std::size_t count = corners.size();
  if (mode == kTriangles) {
    for (std::size_t i = 0; i + 2 < count; i += 3)
      shape.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  } else if (mode == kStrip) {
    for (std::size_t i = 0; i + 2 < count; ++i)
      shape.triangles.push_back({corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
  } else if (mode == kFan) {
    for (std::size_t i = 1; i + 1 < count; ++i) shape.triangles.push_back({corners[i], corners[i + 1], corners[0]});
  } else if (mode == 0) {
    shape.points = count;
  } else if (mode <= 3) {
    shape.lines = mode == 1 ? count / 2 : mode == 2 ? count : count > 0 ? count - 1 : 0;
  } else {
    failGltf(Text(FOOTFALL_TEXT("a mesh has the unknown mode %1"), mode));
  }
}

class GltfReader {
 public:
  GltfReader(const std::string& path, Environment& environment)
      : path_(path), file_(path), json_(file_.json()), environment_(environment), parts_(environment.parts) {}

  void read() {
    noteExtensions();
    scene_ = gltfScene(json_);
    for (const std::size_t number : scene_.nodes) {
      const Json& node = gltfItem(json_, "nodes", number);
      if (!node.contains("mesh")) continue;
      const std::vector<Affine> worlds = instancesOf(node, scene_.worlds[number]);
      const Json& mesh = gltfItem(json_, "meshes", gltfNumber(node, "mesh"));
      for (const Json& primitive : gltfArray(mesh, "primitives")) {
        if (!primitive.is_object()) failGltf(FOOTFALL_TEXT("a primitive of a mesh is not an object"));
        const std::optional<Shape> shape = shapeOf(primitive, weightsOf(node, mesh));
        if (!shape) continue;
        const std::string name = gltfText(mesh, "name");
        if (node.contains("skin")) {
          add(skinned(*shape, gltfNumber(node, "skin")), kIdentity, node, primitive, name);
        } else {
          for (const Affine& world : worlds) add(*shape, world, node, primitive, name);
        }
      }
    }
    dropUnnamedPart(environment_);
  }

 private:
  /// Notes required extensions that are not supported and may concern geometry.
  void noteExtensions() {
    static const std::set<std::string, std::less<>> kRead = {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                                                             "KHR_mesh_quantization", "EXT_mesh_gpu_instancing",
                                                             "KHR_lights_punctual"};
    for (const Json& required : gltfArray(json_, "extensionsRequired")) {
      if (!required.is_string()) continue;
      const auto name = required.get<std::string>();
      const bool isLook = name.find("material") != std::string::npos || name.find("texture") != std::string::npos;
      if (!isLook && !kRead.contains(name))
        environment_.notes.emplace_back(
            Text(FOOTFALL_TEXT("The file needs the glTF extension %1, which is not read: something may be missing"),
                 cleanName(name)));
    }
  }

  /// The transform of the node, or of each of its instances.
  std::vector<Affine> instancesOf(const Json& node, const Affine& world) {
    const Json& extensions = gltfObject(node, "extensions");
    const auto found = extensions.find("EXT_mesh_gpu_instancing");
    if (found == extensions.end()) return {world};
    const Json& attributes = gltfObject(*found, "attributes");
    GltfNumbers translation, rotation, scale;
    const auto take = [&](const char* name, std::size_t width, GltfNumbers& numbers) {
      if (!attributes.contains(name)) return std::size_t{0};
      numbers = file_.numbers(gltfNumber(attributes, name));
      if (numbers.width != width) failGltf(FOOTFALL_TEXT("the instances of a mesh are invalid"));
      return numbers.size();
    };
    const std::size_t count =
        std::max({take("TRANSLATION", 3, translation), take("ROTATION", 4, rotation), take("SCALE", 3, scale)});
    std::vector<Affine> worlds;
    for (std::size_t i = 0; i < count; ++i) {
      std::array<double, 3> t{}, s{1, 1, 1};
      std::array<double, 4> r{0, 0, 0, 1};
      for (std::size_t k = 0; k < 3; ++k) {
        if (i < translation.size()) t[k] = translation.at(i, k);
        if (i < scale.size()) s[k] = scale.at(i, k);
      }
      for (std::size_t k = 0; k < 4; ++k)
        if (i < rotation.size()) r[k] = rotation.at(i, k);
      worlds.push_back(world * gltfTransform(t, r, s));
    }
    return worlds;
  }

  /// The weights of morph targets; a node's own weights override those of its mesh.
  static std::vector<double> weightsOf(const Json& node, const Json& mesh) {
    std::vector<double> weights;
    for (const Json& weight : gltfArray(node.contains("weights") ? node : mesh, "weights"))
      weights.push_back(weight.is_number() ? weight.get<double>() : 0);
    return weights;
  }

  /// Empty where the primitive has no positions.
  std::optional<Shape> shapeOf(const Json& primitive, const std::vector<double>& weights) {
    const Json& attributes = gltfObject(primitive, "attributes");
    if (!attributes.contains("POSITION")) return std::nullopt;
    Shape shape;
    std::vector<std::uint32_t> corners;
    const Json& extensions = gltfObject(primitive, "extensions");
    const auto packed = extensions.find("KHR_draco_mesh_compression");
    if (packed != extensions.end()) {
      unpack(*packed, shape, corners);
    } else {
      takePlaces(attributes, shape);
      if (primitive.contains("indices")) {
        corners = file_.indices(gltfNumber(primitive, "indices"));
      } else {
        for (std::size_t i = 0; i < shape.places.size(); ++i) corners.push_back(static_cast<std::uint32_t>(i));
      }
    }
    morph(primitive, weights, shape);
    // Draco has already converted strips to triangles.
    makeTriangles(packed != extensions.end() ? kTriangles : gltfNumber(primitive, "mode", kTriangles), corners, shape);
    return shape;
  }

  void takePlaces(const Json& attributes, Shape& shape) {
    const GltfNumbers places = file_.numbers(gltfNumber(attributes, "POSITION"));
    if (places.width != 3) failGltf(FOOTFALL_TEXT("positions do not have three numbers each"));
    if (places.size() > std::numeric_limits<std::uint32_t>::max()) failTooMany();
    shape.places.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      shape.places[i] = {places.at(i, 0), places.at(i, 1), places.at(i, 2)};
    for (int set = 0;; ++set) {
      const std::string joints = "JOINTS_" + std::to_string(set), weights = "WEIGHTS_" + std::to_string(set);
      if (!attributes.contains(joints) || !attributes.contains(weights)) return;
      shape.joints.push_back(file_.numbers(gltfNumber(attributes, joints.c_str())));
      shape.weights.push_back(file_.numbers(gltfNumber(attributes, weights.c_str())));
      for (const GltfNumbers& numbers : {shape.joints.back(), shape.weights.back()})
        if (numbers.width != 4 || numbers.size() < shape.places.size())
          failGltf(FOOTFALL_TEXT("the weights of a skin are invalid"));
    }
  }

  void unpack(const Json& packed, Shape& shape, std::vector<std::uint32_t>& corners) {
    const Json& attributes = gltfObject(packed, "attributes");
    std::vector<std::uint32_t> numbers{static_cast<std::uint32_t>(gltfNumber(attributes, "POSITION"))};
    const bool hasSkin = attributes.contains("JOINTS_0") && attributes.contains("WEIGHTS_0");
    if (hasSkin)
      for (const char* name : {"JOINTS_0", "WEIGHTS_0"})
        numbers.push_back(static_cast<std::uint32_t>(gltfNumber(attributes, name)));
    DracoMesh mesh = decodeDraco(file_.view(gltfNumber(packed, "bufferView")), numbers);
    corners = std::move(mesh.corners);
    for (const std::array<double, 4>& place : mesh.attributes[0])
      shape.places.push_back({place[0], place[1], place[2]});
    if (!hasSkin) return;
    const auto flat = [](const std::vector<std::array<double, 4>>& values) {
      GltfNumbers all{4, {}};
      for (const std::array<double, 4>& value : values) all.values.insert(all.values.end(), value.begin(), value.end());
      return all;
    };
    shape.joints.push_back(flat(mesh.attributes[1]));
    shape.weights.push_back(flat(mesh.attributes[2]));
  }

  void morph(const Json& primitive, const std::vector<double>& weights, Shape& shape) {
    const Json& targets = gltfArray(primitive, "targets");
    for (std::size_t t = 0; t < std::min(targets.size(), weights.size()); ++t) {
      if (weights[t] == 0 || !targets[t].is_object() || !targets[t].contains("POSITION")) continue;
      const GltfNumbers moves = file_.numbers(gltfNumber(targets[t], "POSITION"));
      if (moves.width != 3 || moves.size() < shape.places.size()) failGltf(FOOTFALL_TEXT("a morph target is invalid"));
      for (std::size_t i = 0; i < shape.places.size(); ++i) {
        shape.places[i].x += weights[t] * moves.at(i, 0);
        shape.places[i].y += weights[t] * moves.at(i, 1);
        shape.places[i].z += weights[t] * moves.at(i, 2);
      }
    }
  }

  /// Places a skinned shape in the world by its joints, as they stand in the file. The transform of its node has no
  /// effect then.
  Shape skinned(const Shape& shape, std::uint64_t number) {
    const Json& skin = gltfItem(json_, "skins", number);
    GltfNumbers bind;
    if (skin.contains("inverseBindMatrices")) bind = file_.numbers(gltfNumber(skin, "inverseBindMatrices"));
    if (bind.width != 0 && bind.width != 16) failGltf(FOOTFALL_TEXT("a skin is invalid"));
    std::vector<Affine> joints;
    for (const Json& joint : gltfArray(skin, "joints")) {
      const std::uint64_t node = joint.is_number_unsigned() ? joint.get<std::uint64_t>() : scene_.worlds.size();
      if (node >= scene_.worlds.size()) failGltf(FOOTFALL_TEXT("a skin refers to a node that does not exist"));
      const Affine& world = scene_.worlds[node];
      joints.push_back(joints.size() < bind.size() ? world * matrixAt(bind, joints.size()) : world);
    }
    Shape placed;
    placed.triangles = shape.triangles;
    placed.lines = shape.lines;
    placed.points = shape.points;
    for (std::size_t i = 0; i < shape.places.size(); ++i) placed.places.push_back(skinnedPlace(shape, i, joints));
    return placed;
  }

  static Vec3 skinnedPlace(const Shape& shape, std::size_t vertex, const std::vector<Affine>& joints) {
    Vec3 sum{0, 0, 0};
    double total = 0;
    for (std::size_t set = 0; set < shape.joints.size(); ++set)
      for (std::size_t k = 0; k < 4; ++k) {
        const double weight = shape.weights[set].at(vertex, k), joint = shape.joints[set].at(vertex, k);
        if (weight == 0) continue;
        if (!(joint >= 0 && joint < static_cast<double>(joints.size())))
          failGltf(FOOTFALL_TEXT("the weights of a skin are invalid"));
        const Vec3 p = joints[static_cast<std::size_t>(joint)] * shape.places[vertex];
        sum = {sum.x + weight * p.x, sum.y + weight * p.y, sum.z + weight * p.z};
        total += weight;
      }
    if (total == 0) return joints.empty() ? shape.places[vertex] : joints[0] * shape.places[vertex];
    return {sum.x / total, sum.y / total, sum.z / total};
  }

  [[noreturn]] void failTooMany() const {
    failInput(path_, 0, FOOTFALL_TEXT("more than 4294967295 vertices"), FOOTFALL_TEXT("split the file"));
  }

  void add(const Shape& shape, const Affine& world, const Json& node, const Json& primitive, const std::string& name) {
    const std::size_t first = environment_.vertices.size();
    if (first + shape.places.size() > std::numeric_limits<std::uint32_t>::max()) failTooMany();
    for (std::size_t i = 0; i < shape.places.size(); ++i) {
      const Vec3 p = world * shape.places[i];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        failInput(
            path_, 0,
            Text(FOOTFALL_TEXT("vertex %1 of mesh '%2' has a coordinate that is not finite or too large"), i, name),
            FOOTFALL_TEXT("correct it or export the file again"));
      environment_.vertices.push_back(p);
    }
    environment_.skipped.lines += shape.lines;
    environment_.skipped.points += shape.points;
    const bool mirrored = determinant(world) < 0;
    std::optional<std::uint32_t> part;
    std::uint64_t face = 0;
    for (Triangle corners : shape.triangles) {
      ++face;
      for (std::uint32_t& corner : corners) {
        if (corner >= shape.places.size()) failIndex(corner, shape.places.size(), name);
        corner += static_cast<std::uint32_t>(first);
      }
      if (mirrored) std::swap(corners[1], corners[2]);
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
        SkippedPolygon skipped = skippedPolygon(corners, environment_.vertices);
        skipped.face = face;
        skipped.mesh = cleanName(name);
        addSkipped(environment_.skipped, std::move(skipped));
        continue;
      }
      if (!part) part = gltfPart(json_, node, primitive, parts_);
      environment_.triangles.push_back(corners);
      environment_.partOf.push_back(*part);
    }
  }

  [[noreturn]] void failIndex(std::uint32_t index, std::size_t count, const std::string& name) const {
    failInput(path_, 0,
              Text(FOOTFALL_TEXT("vertex index %1 in mesh '%2' is out of range: it has %3"), index, name,
                   countedText(count, FOOTFALL_TEXT("1 vertex"), FOOTFALL_TEXT("%1 vertices"))),
              FOOTFALL_TEXT("export the file again"));
  }

  const std::string& path_;
  GltfBuffers file_;
  const Json& json_;
  Environment& environment_;
  PartList parts_;
  GltfScene scene_;
};

}  // namespace

bool isGltf2(const std::string& path) {
  std::string start(4096, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  if (start.starts_with("glTF")) return start.size() < 8 || start[4] != 1;
  std::string_view text = start;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{' && lowerExtension(path) == "gltf";
}

FileFrame readGltf(const std::string& path, Environment& environment) {
  try {
    GltfReader(path, environment).read();
  } catch (const BadGltf& bad) {
    failInput(path, 0, Text(FOOTFALL_TEXT("cannot be read (%1)"), bad.what),
              FOOTFALL_TEXT("check that the file is complete and of the format that its extension says"));
  }
  return gltfFrame();
}

}  // namespace footfall::detail
