// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/gltf_export.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <vector>

#include "core/base/palette.hpp"
#include "core/base/vector.hpp"
#include "core/io/base64.hpp"
#include "footfall/errors.hpp"
#include "footfall/version.hpp"

namespace footfall::detail {
namespace {

using Json = nlohmann::ordered_json;

// The palette is used darker from the seventh layer on, then lighter.
Rgb layerColour(std::size_t layer) {
  Rgb colour = kLayerColours[layer % kLayerColours.size()];
  const std::size_t round = layer / kLayerColours.size() % 3;
  for (int& part : colour) part = round == 0 ? part : round == 1 ? part * 7 / 10 : part + (255 - part) * 4 / 10;
  return colour;
}
constexpr Rgb kObstacleEdges = kVermilion;
constexpr Rgb kConnections{255, 255, 255};
constexpr Rgb kSteps = kSkyBlue;
constexpr Rgb kGaps = kOrange;
constexpr Rgb kDrops = kReddishPurple;
constexpr Rgb kPlaced{150, 150, 150};

/// Converts an sRGB colour to the linear values of glTF.
float linear(int part) {
  const double x = part / 255.0;
  return static_cast<float>(x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4));
}

// The numbers of glTF for component types, buffer targets and primitive modes.
constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kVertexBuffer = 34962, kIndexBuffer = 34963;
constexpr int kLines = 1, kTriangles = 4;

void appendWord(std::string& bytes, std::uint32_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xFF);
}

/// Builds the lists of a glTF and the one buffer of numbers that they refer to. Each mesh has a node and a material of
/// its name, all under one root.
class GltfMaker {
 public:
  GltfMaker(double scale, Poll poll) : scale_(scale), poll_(poll) {}

  /// Adds a mesh of the elements (two or three corners each) over the vertices that they use, in the order of their
  /// first use.
  template <class Elements>
  void add(const std::string& name, const Rgb& colour, const std::vector<Vec3>& vertices, const Elements& elements,
           Json extras = {}) {
    constexpr std::size_t kCorners = std::tuple_size_v<typename Elements::value_type>;
    if (elements.empty()) return;
    const std::size_t number = meshes_.size();
    Json primitive;
    primitive["mode"] = kCorners == 3 ? kTriangles : kLines;
    primitive["material"] = number;
    primitive["indices"] = accessors_.size() + 1;
    primitive["attributes"]["POSITION"] = accessors_.size();
    meshes_.push_back({{"name", name}, {"primitives", Json::array({std::move(primitive)})}});
    nodes_.push_back({{"name", name}, {"mesh", number}});
    if (!extras.empty()) nodes_.back()["extras"] = std::move(extras);
    addMaterial(name, colour);

    std::vector<std::uint32_t> used, indices;
    std::unordered_map<std::uint32_t, std::uint32_t> numberOf;
    indices.reserve(kCorners * elements.size());
    for (const auto& element : elements) {
      if (indices.size() % kNumbersPerPoll == 0) poll_();
      for (const std::uint32_t v : element) {
        const auto [place, isNew] = numberOf.try_emplace(v, static_cast<std::uint32_t>(used.size()));
        if (isNew) used.push_back(v);
        indices.push_back(place->second);
      }
    }
    addPositions(used, vertices);
    addIndices(indices, used.size());
  }

  /// The file without `asset`; it refers to numbers().
  [[nodiscard]] Json finish() const {
    Json json;
    json["asset"]["version"] = "2.0";
    if (!meshes_.empty()) {
      json["accessors"] = accessors_;
      json["buffers"] = Json::array({Json::object({{"byteLength", numbers_.size()}})});
      json["bufferViews"] = views_;
      json["materials"] = materials_;
      json["meshes"] = meshes_;
      Json root{{"name", "walkable area"}, {"children", Json::array()}};
      json["nodes"] = Json::array();
      for (std::size_t i = 0; i < nodes_.size(); ++i) root["children"].push_back(i + 1);
      json["nodes"].push_back(std::move(root));
      for (const Json& node : nodes_) json["nodes"].push_back(node);
      json["scenes"] = Json::array({Json::object({{"nodes", Json::array({0})}})});
      json["scene"] = 0;
    } else {
      json["scene"] = 0;
      json["scenes"] = Json::array({Json::object({{"name", "walkable area"}})});
    }
    return json;
  }

  [[nodiscard]] const std::string& numbers() const { return numbers_; }
  [[nodiscard]] double largestError() const { return largestError_; }

 private:
  /// Adds an accessor for the numbers that were appended since `start`.
  void addAccessor(std::size_t start, int kind, int target, std::size_t count, const char* type, Json max, Json min) {
    accessors_.push_back({{"bufferView", views_.size()},
                          {"byteOffset", 0},
                          {"componentType", kind},
                          {"count", count},
                          {"type", type},
                          {"max", std::move(max)},
                          {"min", std::move(min)}});
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", start}, {"byteLength", numbers_.size() - start}, {"target", target}});
  }

  void addPositions(const std::vector<std::uint32_t>& used, const std::vector<Vec3>& vertices) {
    const std::size_t start = numbers_.size();
    std::array<float, 3> low{}, high{};
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (i % kNumbersPerPoll == 0) poll_();
      const std::array<float, 3> rounded = roundedPlace(vertices[used[i]]);
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = i == 0 ? rounded[k] : std::min(low[k], rounded[k]);
        high[k] = i == 0 ? rounded[k] : std::max(high[k], rounded[k]);
        appendWord(numbers_, std::bit_cast<std::uint32_t>(rounded[k]));
      }
    }
    addAccessor(start, kFloat, kVertexBuffer, used.size(), "VEC3", high, low);
  }

  void addIndices(const std::vector<std::uint32_t>& indices, std::size_t vertexCount) {
    const std::size_t start = numbers_.size();
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (i % kNumbersPerPoll == 0) poll_();
      appendWord(numbers_, indices[i]);
    }
    addAccessor(start, kUnsignedInt, kIndexBuffer, indices.size(), "SCALAR", Json::array({vertexCount - 1}),
                Json::array({0}));
  }

  /// A place in metres, Y up.
  std::array<float, 3> roundedPlace(const Vec3& p) {
    const std::array<double, 3> turned{p.x * scale_, p.z * scale_, -p.y * scale_};
    std::array<float, 3> rounded;
    for (std::size_t k = 0; k < 3; ++k) {
      rounded[k] = static_cast<float>(turned[k] + 0.0);  // avoids -0
      if (!std::isfinite(rounded[k]))
        throw InputError(FOOTFALL_TEXT(
            "a coordinate is larger than a float of glTF can be; export as OBJ, or with a smaller scale"));
      largestError_ = std::max(largestError_, std::fabs(static_cast<double>(rounded[k]) - turned[k]));
    }
    return rounded;
  }

  void addMaterial(const std::string& name, const Rgb& colour) {
    Json look;
    if (colour != kConnections)  // white is the default of the format
      look["baseColorFactor"] = {linear(colour[0]), linear(colour[1]), linear(colour[2]), 1.0};
    look["metallicFactor"] = 0.0;
    materials_.push_back({{"name", name}, {"pbrMetallicRoughness", std::move(look)}, {"doubleSided", true}});
  }

  static constexpr std::size_t kNumbersPerPoll = 6 * 4096;  // per line or triangle

  double scale_;
  Poll poll_;
  double largestError_ = 0;
  std::string numbers_;
  Json accessors_ = Json::array(), views_ = Json::array(), materials_ = Json::array(), meshes_ = Json::array();
  std::vector<Json> nodes_;
};

/// Figures that other programs would have to compute from the triangles; areas are in square metres.
Json surfaceExtras(const NavigationMesh& mesh, const std::vector<Triangle>& triangles, double scale) {
  double area = 0;
  for (const Triangle& t : triangles) area += areaOf(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
  return {{"area", area * scale * scale}, {"triangles", triangles.size()}};
}

void addLayers(GltfMaker& maker, const NavigationMesh& mesh, const ExportOptions& options, double scale) {
  if (mesh.layers.empty() || !options.layers || options.navmeshNode) {
    // Godot makes a navigation region of a mesh with this name.
    maker.add(options.navmeshNode ? "walkable-navmesh" : "walkable", layerColour(0), mesh.vertices, mesh.triangles,
              surfaceExtras(mesh, mesh.triangles, scale));
    return;
  }
  std::vector<std::vector<Triangle>> layers(mesh.layerCount);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) layers.at(mesh.layers[i]).push_back(mesh.triangles[i]);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    Json extras{{"layer", i}};
    extras.update(surfaceExtras(mesh, layers[i], scale));
    maker.add("layer_" + std::to_string(i), layerColour(i), mesh.vertices, layers[i], std::move(extras));
  }
}

/// Lists with one number for each link of a kind: its layers and its size in metres. `faces` counts the triangles of
/// each link.
Json stepExtras(const NavigationMesh& mesh, StepKind kind, double scale) {
  Json extras{{"faces", Json::array()}, {"heights", Json::array()}};
  if (kind == StepKind::Gap) extras["widths"] = Json::array();
  for (const StepLink& link : mesh.links) {
    if (link.kind != kind) continue;
    extras["faces"].push_back((link.from[1] != link.to[0] ? 1 : 0) + (link.from[0] != link.to[1] ? 1 : 0));
    extras["heights"].push_back(link.height * scale);
    if (kind == StepKind::Gap) extras["widths"].push_back(link.width * scale);
    if (mesh.layers.empty()) continue;
    extras["layers"].push_back({mesh.layers[link.fromTriangle], mesh.layers[link.toTriangle]});
  }
  return extras;
}

/// The same lists for drops, which are two lines each.
Json dropExtras(const NavigationMesh& mesh, double scale) {
  Json extras{{"depths", Json::array()}};
  for (const DropLink& drop : mesh.drops) {
    extras["depths"].push_back(drop.depth * scale);
    if (!mesh.layers.empty())
      extras["layers"].push_back({mesh.layers[drop.fromTriangle], mesh.layers[drop.toTriangle]});
  }
  return extras;
}

/// Two triangles for each link, or one where both borders end in one vertex. Links with equally high borders have no
/// area.
std::vector<Triangle> stepTriangles(const std::vector<StepLink>& links, StepKind kind) {
  std::vector<Triangle> triangles;
  for (const StepLink& link : links) {
    if (link.kind != kind) continue;
    if (link.from[1] != link.to[0]) triangles.push_back({link.from[0], link.from[1], link.to[0]});
    if (link.from[0] != link.to[1]) triangles.push_back({link.from[0], link.to[0], link.to[1]});
  }
  return triangles;
}

/// Adds two lines for each drop, from its start to its landing.
void addDrops(GltfMaker& maker, const NavigationMesh& mesh, double scale) {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 2>> lines;
  for (const DropLink& drop : mesh.drops)
    for (const std::size_t end : {0, 1}) {
      const auto number = static_cast<std::uint32_t>(vertices.size());
      vertices.insert(vertices.end(), {drop.start[end], drop.landing[end]});
      lines.push_back({number, number + 1});
    }
  maker.add("drops", kDrops, vertices, lines, dropExtras(mesh, scale));
}

/// A GLB is a header of 12 bytes, a chunk of JSON and a chunk of numbers. A chunk is its size, its kind and its bytes,
/// in words of 4 bytes.
std::string putTogether(Json json, const std::string& numbers, GltfKind kind, Poll poll) {
  poll();
  if (kind == GltfKind::Text) {
    if (!numbers.empty()) json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + toBase64(numbers);
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
  }
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::size_t size = 20 + text.size() + (numbers.empty() ? 0 : 8 + numbers.size());
  if (size > std::numeric_limits<std::uint32_t>::max())
    throw RunError(FOOTFALL_TEXT("the result needs %1 bytes, more than a .glb can hold; export as .obj or .gltf"),
                   size);
  std::string glb = "glTF";
  glb.reserve(size);
  appendWord(glb, 2);
  appendWord(glb, static_cast<std::uint32_t>(size));
  appendWord(glb, static_cast<std::uint32_t>(text.size()));
  glb += "JSON" + text;
  if (numbers.empty()) return glb;
  appendWord(glb, static_cast<std::uint32_t>(numbers.size()));
  glb.append("BIN\0", 4);
  return glb + numbers;
}

Json extrasOf(const SourceFrame& frame, const ExportHeader& header, double scale) {
  Json extras;
  extras["source"] = std::filesystem::path(frame.source).filename().string();
  extras["pipeline"] = header.pipeline;
  extras["agent"] = header.agent;
  extras["metres_per_unit_of_source"] = frame.metresPerUnit;
  extras["scale"] = scale;
  // Values are in metres and degrees; null where a size was not given.
  const AgentNumbers& agent = header.numbers;
  const double metres = frame.metresPerUnit * scale;
  Json numbers;
  numbers["max_slope"] = agent.maxSlope ? Json(*agent.maxSlope) : Json();
  numbers["height"] = agent.height ? Json(*agent.height * metres) : Json();
  numbers["step"] = agent.step * metres;
  numbers["gap"] = agent.gap * metres;
  numbers["radius"] = agent.radius * metres;
  extras["agent_numbers"] = std::move(numbers);
  return extras;
}

}  // namespace

GltfFile formatGltf(GltfKind kind, const NavigationMesh& mesh, const ExportHeader& header, const ExportOptions& options,
                    std::span<const ExportExtra> extras, Poll poll) {
  checkScale(options, mesh);
  const double scale = mesh.frame.metresPerUnit * options.scale;
  GltfMaker maker(scale, poll);
  addLayers(maker, mesh, options, scale);
  if (options.connections) maker.add("connections", kConnections, mesh.vertices, mesh.connections);
  if (options.obstacleEdges) maker.add("obstacle_edges", kObstacleEdges, mesh.vertices, mesh.obstacleEdges);
  if (options.steps) {
    maker.add("steps", kSteps, mesh.vertices, stepTriangles(mesh.links, StepKind::Step),
              stepExtras(mesh, StepKind::Step, scale));
    maker.add("gaps", kGaps, mesh.vertices, stepTriangles(mesh.links, StepKind::Gap),
              stepExtras(mesh, StepKind::Gap, scale));
  }
  if (options.drops) addDrops(maker, mesh, scale);
  for (const ExportExtra& extra : extras)
    maker.add("placed_" + extra.name, kPlaced, extra.soup.vertices, extra.soup.triangles);

  Json json = maker.finish();
  json["asset"]["generator"] = "Footfall " FOOTFALL_VERSION;
  json["asset"]["extras"] = extrasOf(mesh.frame, header, options.scale);
  return {putTogether(std::move(json), maker.numbers(), kind, poll), maker.largestError()};
}

}  // namespace footfall::detail
