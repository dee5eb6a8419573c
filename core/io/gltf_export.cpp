// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/gltf_export.hpp"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Exporter.hpp>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/io/base64.hpp"
#include "footfall/errors.hpp"

#ifndef FOOTFALL_VERSION
#define FOOTFALL_VERSION "unknown"
#endif

namespace footfall::detail {
namespace {

using Json = nlohmann::ordered_json;
using Colour = std::array<int, 3>;

// The layers' colours in the editor (Okabe and Ito 2008); from the seventh on darker, then lighter.
Colour layerColour(std::size_t layer) {
  constexpr std::array<Colour, 6> kColours{
      {{0, 158, 115}, {86, 180, 233}, {240, 228, 66}, {0, 114, 178}, {204, 121, 167}, {230, 159, 0}}};
  Colour colour = kColours[layer % kColours.size()];
  const std::size_t round = layer / kColours.size() % 3;
  for (int& part : colour) part = round == 0 ? part : round == 1 ? part * 7 / 10 : part + (255 - part) * 4 / 10;
  return colour;
}
constexpr Colour kObstacleEdges{213, 94, 0};
constexpr Colour kConnections{255, 255, 255};
constexpr Colour kPlaced{150, 150, 150};

/// What glTF means by a colour is linear, what everybody else writes is sRGB.
float linear(int part) {
  const double x = part / 255.0;
  return static_cast<float>(x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4));
}

class SceneMaker {
 public:
  explicit SceneMaker(double scale) : scale_(scale) {}

  /// Adds a mesh of the elements (two or three corners each) over the vertices that they use, in ascending order.
  template <class Elements>
  void add(const std::string& name, const Colour& colour, const std::vector<Vec3>& vertices, const Elements& elements) {
    constexpr unsigned kCorners = std::tuple_size_v<typename Elements::value_type>;
    if (elements.empty()) return;
    std::vector<std::uint32_t> used;
    used.reserve(kCorners * elements.size());
    for (const auto& element : elements) used.insert(used.end(), element.begin(), element.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());

    auto mesh = std::make_unique<aiMesh>();
    mesh->mName = name;
    mesh->mPrimitiveTypes = kCorners == 3 ? aiPrimitiveType_TRIANGLE : aiPrimitiveType_LINE;
    mesh->mMaterialIndex = static_cast<unsigned>(materials_.size());
    mesh->mNumVertices = static_cast<unsigned>(used.size());
    mesh->mVertices = new aiVector3D[used.size()];
    // Assimp joins what is nearer than 1e-5, but vertices on the two sides of an obstacle edge, or of a narrow gap,
    // shall stay two. So each gets a texture coordinate of its own, which dropTextureCoordinates() leaves out again.
    mesh->mNumUVComponents[0] = 2;
    mesh->mTextureCoords[0] = new aiVector3D[used.size()];
    for (std::size_t i = 0; i < used.size(); ++i) {
      mesh->mVertices[i] = vertex(vertices[used[i]]);
      mesh->mTextureCoords[0][i] = {static_cast<float>(i & 0xFFFF), static_cast<float>(i >> 16), 0};
    }
    mesh->mNumFaces = static_cast<unsigned>(elements.size());
    mesh->mFaces = new aiFace[elements.size()];
    for (std::size_t i = 0; i < elements.size(); ++i) {
      aiFace& face = mesh->mFaces[i];
      face.mNumIndices = kCorners;
      face.mIndices = new unsigned[kCorners];
      for (unsigned k = 0; k < kCorners; ++k)
        face.mIndices[k] =
            static_cast<unsigned>(std::lower_bound(used.begin(), used.end(), elements[i][k]) - used.begin());
    }
    meshes_.push_back(std::move(mesh));
    addMaterial(name, colour);
  }

  std::unique_ptr<aiScene> finish() {
    auto scene = std::make_unique<aiScene>();
    scene->mFlags = AI_SCENE_FLAGS_NON_VERBOSE_FORMAT;  // vertices are shared, and shall stay so
    scene->mRootNode = new aiNode("walkable area");
    const auto count = static_cast<unsigned>(meshes_.size());
    scene->mRootNode->mNumChildren = count;
    scene->mRootNode->mChildren = new aiNode*[count];
    scene->mNumMeshes = scene->mNumMaterials = count;
    scene->mMeshes = new aiMesh*[count];
    scene->mMaterials = new aiMaterial*[count];
    for (unsigned i = 0; i < count; ++i) {
      auto* node = new aiNode(meshes_[i]->mName.C_Str());
      node->mParent = scene->mRootNode;
      node->mNumMeshes = 1;
      node->mMeshes = new unsigned[1]{i};
      scene->mRootNode->mChildren[i] = node;
      scene->mMeshes[i] = meshes_[i].release();
      scene->mMaterials[i] = materials_[i].release();
    }
    return scene;
  }

  [[nodiscard]] double largestError() const { return largestError_; }

 private:
  aiVector3D vertex(const Vec3& p) {
    const std::array<double, 3> turned{p.x * scale_, p.z * scale_, -p.y * scale_};
    std::array<float, 3> rounded;
    for (std::size_t k = 0; k < 3; ++k) {
      rounded[k] = static_cast<float>(turned[k] + 0.0);  // no -0
      if (!std::isfinite(rounded[k]))
        throw InputError(FOOTFALL_TEXT(
            "a coordinate is larger than a float of glTF can be; export as OBJ, or with a smaller scale"));
      largestError_ = std::max(largestError_, std::fabs(static_cast<double>(rounded[k]) - turned[k]));
    }
    return {rounded[0], rounded[1], rounded[2]};
  }

  void addMaterial(const std::string& name, const Colour& colour) {
    auto material = std::make_unique<aiMaterial>();
    const aiString text(name);
    material->AddProperty(&text, AI_MATKEY_NAME);
    const aiColor4D base(linear(colour[0]), linear(colour[1]), linear(colour[2]), 1);
    material->AddProperty(&base, 1, AI_MATKEY_BASE_COLOR);
    const float rough = 1, metallic = 0;
    material->AddProperty(&rough, 1, AI_MATKEY_ROUGHNESS_FACTOR);
    material->AddProperty(&metallic, 1, AI_MATKEY_METALLIC_FACTOR);
    const int bothSides = 1;
    material->AddProperty(&bothSides, 1, AI_MATKEY_TWOSIDED);
    materials_.push_back(std::move(material));
  }

  double scale_;
  double largestError_ = 0;
  std::vector<std::unique_ptr<aiMesh>> meshes_;
  std::vector<std::unique_ptr<aiMaterial>> materials_;
};

void addLayers(SceneMaker& maker, const NavigationMesh& mesh, bool byLayers) {
  if (mesh.layers.empty() || !byLayers) {
    maker.add("walkable", layerColour(0), mesh.vertices, mesh.triangles);
    return;
  }
  std::vector<std::vector<Triangle>> layers(mesh.layerCount);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) layers.at(mesh.layers[i]).push_back(mesh.triangles[i]);
  for (std::size_t i = 0; i < layers.size(); ++i)
    maker.add("layer_" + std::to_string(i), layerColour(i), mesh.vertices, layers[i]);
}

constexpr Pattern kTooShort = FOOTFALL_TEXT("glTF: Assimp wrote less than it said; export as OBJ");

/// A GLB is a header of 12 bytes, a chunk of JSON and one of numbers; a chunk is its size, its kind and its bytes.
struct Chunks {
  Json json;
  std::string numbers;
};

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::array<unsigned char, 4> b{};
  if (at + 4 > bytes.size()) throw RunError(kTooShort);
  std::memcpy(b.data(), bytes.data() + at, 4);
  return b[0] | b[1] << 8U | b[2] << 16U | std::uint32_t{b[3]} << 24U;
}

void appendWord(std::string& bytes, std::size_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xFF);
}

Chunks takeApart(const std::string& glb) {
  const std::size_t size = word(glb, 12);
  if (20 + size > glb.size()) throw RunError(kTooShort);
  Chunks chunks;
  chunks.json = Json::parse(glb.begin() + 20, glb.begin() + 20 + static_cast<std::ptrdiff_t>(size));
  if (20 + size < glb.size()) chunks.numbers = glb.substr(28 + size, word(glb, 20 + size));
  return chunks;
}

/// Leaves out the texture coordinates, with their numbers: keeps what positions and indices refer to, in this order.
void dropTextureCoordinates(Chunks& chunks) {
  Json& json = chunks.json;
  Json accessors = Json::array(), views = Json::array();
  std::string numbers;
  const auto keep = [&](Json& reference) {
    Json accessor = json.at("accessors").at(reference.get<std::size_t>());
    Json view = json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    const auto offset = view.value("byteOffset", std::size_t{0}), length = view.at("byteLength").get<std::size_t>();
    if (offset + length > chunks.numbers.size()) throw RunError(kTooShort);
    numbers.resize((numbers.size() + 3) / 4 * 4, '\0');
    view["byteOffset"] = numbers.size();
    numbers.append(chunks.numbers, offset, length);
    accessor["bufferView"] = views.size();
    views.push_back(std::move(view));
    reference = accessors.size();
    accessors.push_back(std::move(accessor));
  };
  for (Json& mesh : json.at("meshes"))
    for (Json& primitive : mesh.at("primitives")) {
      Json& attributes = primitive.at("attributes");
      attributes.erase("TEXCOORD_0");
      for (auto& attribute : attributes.items()) keep(attribute.value());
      keep(primitive.at("indices"));
    }
  json["accessors"] = std::move(accessors);
  json["bufferViews"] = std::move(views);
  json["buffers"] = Json::array({Json::object({{"byteLength", numbers.size()}})});
  chunks.numbers = std::move(numbers);
}

std::string putTogether(Chunks chunks, GltfKind kind) {
  Json& json = chunks.json;
  if (kind == GltfKind::Text) {
    if (!chunks.numbers.empty())
      json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + toBase64(chunks.numbers);
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
  }
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  chunks.numbers.resize((chunks.numbers.size() + 3) / 4 * 4, '\0');
  std::string glb = "glTF";
  appendWord(glb, 2);
  appendWord(glb, 20 + text.size() + (chunks.numbers.empty() ? 0 : 8 + chunks.numbers.size()));
  appendWord(glb, text.size());
  glb += "JSON" + text;
  if (chunks.numbers.empty()) return glb;
  appendWord(glb, chunks.numbers.size());
  glb.append("BIN\0", 4);
  return glb + chunks.numbers;
}

/// Assimp's part: meshes, nodes, materials and their numbers.
std::string exportScene(const aiScene& scene) {
  Assimp::Exporter exporter;
  const aiExportDataBlob* blob = exporter.ExportToBlob(&scene, "glb2", 0);
  if (blob == nullptr || blob->size < 20) throw RunError(Pattern{"glTF: %1"}, exporter.GetErrorString());
  return {static_cast<const char*>(blob->data), blob->size};
}

Json extrasOf(const Environment& environment, const ExportHeader& header, double scale) {
  Json extras;
  extras["source"] = std::filesystem::path(environment.source).filename().string();
  extras["pipeline"] = header.pipeline;
  extras["agent"] = header.agent;
  extras["metres_per_unit_of_source"] = environment.metresPerUnit;
  extras["scale"] = scale;
  return extras;
}

}  // namespace

GltfFile formatGltf(GltfKind kind, const NavigationMesh& mesh, const Environment& environment,
                    const ExportHeader& header, const ExportOptions& options, std::span<const ExportExtra> extras) {
  checkScale(options, mesh);
  SceneMaker maker(environment.metresPerUnit * options.scale);
  addLayers(maker, mesh, options.layers);
  if (options.connections) maker.add("connections", kConnections, mesh.vertices, mesh.connections);
  if (options.obstacleEdges) maker.add("obstacle_edges", kObstacleEdges, mesh.vertices, mesh.obstacleEdges);
  for (const ExportExtra& extra : extras)
    maker.add("placed_" + extra.name, kPlaced, extra.soup.vertices, extra.soup.triangles);

  const std::unique_ptr<aiScene> scene = maker.finish();
  Chunks chunks;
  if (scene->mNumMeshes > 0) {
    chunks = takeApart(exportScene(*scene));
    dropTextureCoordinates(chunks);
  } else {  // Assimp refuses scenes without meshes; an empty result is one all the same
    chunks.json["asset"]["version"] = "2.0";
    chunks.json["scene"] = 0;
    chunks.json["scenes"] = Json::array({Json::object({{"name", "walkable area"}})});
  }
  chunks.json["asset"]["generator"] = "Footfall " FOOTFALL_VERSION " (Assimp)";
  chunks.json["asset"]["extras"] = extrasOf(environment, header, options.scale);
  return {putTogether(std::move(chunks), kind), maker.largestError()};
}

ExportFormat exportFormatOf(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending.empty() || ending == ".obj") return ExportFormat::Obj;
  if (ending == ".gltf") return ExportFormat::Gltf;
  if (ending == ".glb") return ExportFormat::Glb;
  throw InputError(
      FOOTFALL_TEXT("%1: cannot be written in the format \"%2\"; give a name that ends in .obj, .gltf or .glb"), path,
      ending.substr(1));
}

double writeExport(const std::string& path, const NavigationMesh& mesh, const Environment& environment,
                   const ExportHeader& header, const ExportOptions& options, std::span<const ExportExtra> extras) {
  const ExportFormat format = exportFormatOf(path);
  if (format == ExportFormat::Obj) {
    writeObj(path, mesh, environment, header, options, extras);
    return 0;
  }
  const GltfFile file = formatGltf(format == ExportFormat::Gltf ? GltfKind::Text : GltfKind::Binary, mesh, environment,
                                   header, options, extras);
  writeFileSafely(path, file.bytes);
  return file.largestError;
}

}  // namespace footfall::detail
