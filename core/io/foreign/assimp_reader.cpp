// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/foreign/assimp_reader.hpp"

#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string_view>

#include "core/base/counted_text.hpp"
#include "core/environment/part_names.hpp"
#include "core/environment/skipped_polygons.hpp"
#include "core/io/collada_asset.hpp"
#include "core/io/foreign/assimp_scene.hpp"
#include "core/io/input_file.hpp"
#include "core/io/polygon_triangulation.hpp"
#include "core/io/truncation_check.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::detail {
namespace {

/// Undoes the turn from Z up to Y up that Assimp gives the root of a 3DS file.
constexpr Affine kYUpToZUp{{{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}}};

class SceneReader {
 public:
  SceneReader(const std::string& path, const aiScene& scene, Environment& environment, RunContext* context)
      : path_(path), scene_(scene), environment_(environment), context_(context), parts_(environment.parts) {}

  void read(const Affine& rootTransform) {
    visitMeshes(scene_, rootTransform, [this](const aiNode& node, unsigned number, const Affine& world) {
      if (number >= scene_.mNumMeshes) {
        failInput(path_, 0, Text(FOOTFALL_TEXT("node '%1' refers to a mesh that does not exist"), node.mName.C_Str()),
                  FOOTFALL_TEXT("export the file again"));
      }
      const aiMesh& shape = *scene_.mMeshes[number];
      mesh(shape, world);
      if (environment_.partOf.size() < environment_.triangles.size())
        environment_.partOf.resize(environment_.triangles.size(), partOfMesh(scene_, node, shape, parts_));
    });
    dropUnnamedPart(environment_);
  }

 private:
  void poll(std::size_t work = 1) {
    work_ += work;
    if (work_ < 4096) return;
    work_ = 0;
    if (context_ != nullptr) context_->checkCancelled();
  }

  void mesh(const aiMesh& mesh, const Affine& world) {
    const std::size_t first = environment_.vertices.size();
    if (first + mesh.mNumVertices > std::numeric_limits<std::uint32_t>::max()) {
      failInput(path_, 0, FOOTFALL_TEXT("more than 4294967295 vertices"), FOOTFALL_TEXT("split the file"));
    }
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      poll();
      const Vec3 p = world * mesh.mVertices[i];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        failInput(path_, 0,
                  Text(FOOTFALL_TEXT("vertex %1 of mesh '%2' has a coordinate that is not finite or too large"), i,
                       mesh.mName.C_Str()),
                  FOOTFALL_TEXT("correct it or export the file again"));
      }
      environment_.vertices.push_back(p);
    }
    const bool mirrored = determinant(world) < 0;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      poll(1 + 8 * std::size_t{mesh.mFaces[i].mNumIndices});
      face(mesh, i, static_cast<std::uint32_t>(first), mirrored);
    }
  }

  void face(const aiMesh& mesh, unsigned number, std::uint32_t first, bool mirrored) {
    const aiFace& face = mesh.mFaces[number];
    corners_.clear();
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      if (face.mIndices[i] >= mesh.mNumVertices) {
        failInput(path_, 0,
                  Text(FOOTFALL_TEXT("vertex index %1 in mesh '%2' is out of range: it has %3"), face.mIndices[i],
                       mesh.mName.C_Str(),
                       countedText(mesh.mNumVertices, FOOTFALL_TEXT("1 vertex"), FOOTFALL_TEXT("%1 vertices"))),
                  FOOTFALL_TEXT("export the file again"));
      }
      corners_.push_back(first + face.mIndices[i]);
    }
    if (corners_.size() <= 2) {
      ++(corners_.size() == 2 ? environment_.skipped.lines : environment_.skipped.points);
      return;
    }
    if (mirrored) std::reverse(corners_.begin() + 1, corners_.end());
    const auto poll = [this] {
      if (context_ != nullptr) context_->checkCancelled();
    };
    if (triangulatePolygon(corners_, environment_.vertices, environment_.triangles, poll)) return;
    SkippedPolygon skipped = skippedPolygon(corners_, environment_.vertices);
    skipped.face = std::uint64_t{number} + 1;
    skipped.mesh = cleanName(mesh.mName.C_Str());
    addSkipped(environment_.skipped, std::move(skipped));
  }

  const std::string& path_;
  const aiScene& scene_;
  Environment& environment_;
  RunContext* context_;
  PartList parts_;
  std::vector<std::uint32_t> corners_;
  std::size_t work_ = 0;  ///< since the last call of the context
};

UpAxis axisOf(char letter, bool downwards) {
  const std::array<char, 2> name{'-', letter};
  const std::string_view whole(name.data(), name.size());
  return upAxisFrom(whole.substr(downwards ? 0 : 1)).value_or(UpAxis::Y);
}

/// FBX states which axis is up (0, 1, 2), its direction, and how many centimetres a unit has.
FileFrame fbxFrame(const aiMetadata* metadata) {
  FileFrame frame;
  if (metadata == nullptr) return frame;
  std::int32_t axis = 1, sign = 1;
  metadata->Get("UpAxisSign", sign);
  if (metadata->Get("UpAxis", axis)) frame.up = axisOf(axis == 0 ? 'X' : axis == 2 ? 'Z' : 'Y', sign < 0);
  double centimetres = 0;
  float narrow = 0;
  if (!metadata->Get("UnitScaleFactor", centimetres) && metadata->Get("UnitScaleFactor", narrow)) {
    // Converts to the double that the file's text meant: 2.54, not the nearest float.
    char text[32];
    std::from_chars(text, std::to_chars(text, text + sizeof text, narrow).ptr, centimetres);
  }
  if (std::isfinite(centimetres) && centimetres > 0) frame.metresPerUnit = centimetres / 100;
  return frame;
}

/// Assimp multiplies the root's transform of a Collada scene by the unit to make metres, but coordinates must stay in
/// the file's unit. Assimp's unit may differ from the nearest float.
Affine colladaRoot(const aiMatrix4x4& root, const ColladaAsset& asset) {
  const double unit = asset.metresPerUnit.value_or(1);
  Affine undone = toAffine(root);
  double difference = 0;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column) {
      if (column < 3) undone[row][column] /= unit;
      difference = std::max(difference, std::abs(undone[row][column] - kIdentity[row][column]));
    }
  return difference < 1e-6 ? kIdentity : undone;
}

/// Opens the files that a file names, and rejects FIFOs and devices among them.
class RegularFiles : public Assimp::DefaultIOSystem {
 public:
  bool Exists(const char* name) const override {
    std::error_code error;
    return std::filesystem::is_regular_file(name, error);
  }
  Assimp::IOStream* Open(const char* name, const char* mode) override {
    if (!Exists(name)) return nullptr;
    return lowerExtension(name) == "dae" ? openCollada(name) : DefaultIOSystem::Open(name, mode);
  }

 private:
  /// Removes blanks before the first number of an element, because Assimp 5.2.5 does not read that number otherwise.
  static Assimp::IOStream* openCollada(const char* name) {
    std::string text = readInputFile(name, nullptr);
    std::size_t kept = 0;
    bool isFirst = false;  // only blanks since the last '>'
    for (std::size_t i = 0; i < text.size(); ++i) {
      const bool isBlank = kBlanks.find(text[i]) != std::string_view::npos;
      if (isFirst && isBlank) {
        const std::size_t next = std::min(text.find_first_not_of(kBlanks, i), text.size() - 1);
        if (kNumberStarts.find(text[next]) != std::string_view::npos) i = next;
      }
      isFirst = text[i] == '>';
      text[kept++] = text[i];
    }
    auto* bytes = new std::uint8_t[kept];
    std::copy_n(text.begin(), kept, bytes);
    return new Assimp::MemoryIOStream(bytes, kept, true);
  }
  static constexpr std::string_view kBlanks = " \t\r\n", kNumberStarts = "0123456789+-.";
};

/// The first few bytes of a file, in lower case.
std::string lowerStart(const std::string& path) {
  std::string start(5, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  std::transform(start.begin(), start.end(), start.begin(), [](unsigned char c) { return std::tolower(c); });
  return start;
}

}  // namespace

FileFrame readWithAssimp(const std::string& path, Environment& environment, RunContext* context) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });

  // Assimp uses the content where the name suggests another format.
  const std::string start = lowerStart(path);
  if (extension == ".ply" || start.starts_with("ply")) rejectTruncatedPly(path, readInputFile(path, context));
  if (extension == ".stl" || start.starts_with("solid")) rejectTruncatedStl(path, readInputFile(path, context));
  if (start.starts_with("gltf")) rejectTruncatedGlb(path);

  Assimp::Importer importer;
  importer.SetIOHandler(new RegularFiles);  // the importer owns it
  // Assimp makes up a mesh for a skeleton without this setting, but a skeleton alone is not an environment.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  // Axes are turned by our own code, so that the export can turn them back.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, extension == ".dae");

  const aiScene* scene = nullptr;
  std::string problem;
  try {
    scene = importer.ReadFile(path, 0);
    problem = importer.GetErrorString();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (context != nullptr) context->checkCancelled();
  if (problem.find("bad_alloc") != std::string::npos) throw std::bad_alloc();  // Assimp reports it as text
  if (scene == nullptr || scene->mRootNode == nullptr) {
    const Text reason = problem.empty() ? Text(FOOTFALL_TEXT("unknown content")) : Text(problem);
    failInput(path, 0, Text(FOOTFALL_TEXT("cannot be read (%1)"), reason),
              FOOTFALL_TEXT("check that the file is complete and of the format that its extension says"));
  }

  FileFrame frame;
  Affine root = toAffine(scene->mRootNode->mTransformation);
  if (extension == ".fbx") {
    frame = fbxFrame(scene->mMetaData);
  } else if (extension == ".3ds") {
    root = kYUpToZUp * root;
  } else if (extension == ".dae") {
    const ColladaAsset asset = readColladaAsset(readInputFile(path, context));
    frame.up = axisOf(asset.upAxis, false);
    frame.metresPerUnit = asset.metresPerUnit;
    root = colladaRoot(scene->mRootNode->mTransformation, asset);
  } else if (extension == ".gltf" || extension == ".glb" || extension == ".ifc") {
    frame = gltfFrame();  // Assimp turns an IFC file's own unit and axis into these
  }
  SceneReader(path, *scene, environment, context).read(root);
  frame.areFloats = true;
  return frame;
}

}  // namespace footfall::detail
