// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/environment/skipped_polygons.hpp"
#include "core/io/gltf/gltf_scene.hpp"
#include "core/io/input_file.hpp"
#include "core/io/packed/packer_polygons.hpp"
#include "core/io/packed/streams.hpp"

namespace footfall::detail {
namespace {

using Json = nlohmann::json;

constexpr std::uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBinary = 0x004E4942;
constexpr std::uint64_t kLongestJson = std::uint64_t{64} << 20;
constexpr std::uint64_t kAtOnce = 16384;  // elements of an accessor

/// Thrown for an invalid file, and for one with features that this reader does not support.
struct NotPlain {};

void need(bool condition) {
  if (!condition) throw NotPlain{};
}

/// The place of numbers in the file: their start and their distance.
struct Accessor {
  std::uint64_t offset = 0, stride = 0, count = 0, size = 0;
};

struct Primitive {
  Accessor positions, indices;
};

class GlbFile {
 public:
  explicit GlbFile(const std::string& path) : file_(path) {
    std::array<std::uint32_t, 5> start{};
    need(file_.read(0, reinterpret_cast<char*>(start.data()), sizeof start) == sizeof start);
    need(start[0] == kMagic && start[1] == 2 && start[2] == file_.size() && start[4] == kJson);
    need(start[3] <= kLongestJson && start[3] <= file_.size() - sizeof start);
    std::string text(start[3], '\0');
    need(file_.read(sizeof start, text.data(), text.size()) == text.size());
    json_ = Json::parse(text, nullptr, false);
    need(json_.is_object());
    std::array<std::uint32_t, 2> chunk{};
    const std::uint64_t at = sizeof start + text.size();
    need(file_.read(at, reinterpret_cast<char*>(chunk.data()), sizeof chunk) == sizeof chunk);
    binaryOffset_ = at + sizeof chunk;
    binarySize_ = chunk[0];
    need(chunk[1] == kBinary && binaryOffset_ + binarySize_ == file_.size());
  }

  [[nodiscard]] const Json& json() const { return json_; }

  /// The primitives of each mesh, in the order of the file.
  [[nodiscard]] std::vector<std::vector<Primitive>> primitives() const {
    need(json_.value("extensionsRequired", Json::array()).empty() && !json_.contains("skins"));
    const Json& buffers = json_.at("buffers");
    need(buffers.size() == 1 && !buffers[0].contains("uri"));
    need(buffers[0].at("byteLength").get<std::uint64_t>() <= binarySize_);
    std::vector<std::vector<Primitive>> result;
    for (const Json& mesh : json_.at("meshes")) {
      std::vector<Primitive>& all = result.emplace_back();
      for (const Json& primitive : mesh.at("primitives")) {
        need(primitive.value("mode", 4) == 4 && !primitive.contains("extensions") && !primitive.contains("targets"));
        const Json& attributes = primitive.at("attributes");
        all.push_back({accessor(attributes.at("POSITION"), "VEC3"), accessor(primitive.at("indices"), "SCALAR")});
      }
    }
    return result;
  }

  /// Calls take(bytes of one element, its number) for all elements.
  template <class Take>
  void forEach(const Accessor& accessor, RunContext* context, const Take& take) const {
    std::string bytes;
    for (std::uint64_t first = 0; first < accessor.count; first += kAtOnce) {
      if (context != nullptr) {
        context->checkCancelled();
        context->progress(0.5 * static_cast<double>(accessor.offset + first * accessor.stride) /
                          static_cast<double>(file_.size()));
      }
      const std::uint64_t count = std::min(kAtOnce, accessor.count - first);
      bytes.resize(static_cast<std::size_t>((count - 1) * accessor.stride + accessor.size));
      need(file_.read(accessor.offset + first * accessor.stride, bytes.data(), bytes.size()) == bytes.size());
      for (std::uint64_t i = 0; i < count; ++i) take(bytes.data() + i * accessor.stride, first + i);
    }
  }

 private:
  [[nodiscard]] Accessor accessor(const Json& number, const char* type) const {
    const Json& json = json_.at("accessors").at(number.get<std::size_t>());
    need(json.at("type") == type && !json.contains("sparse") && !json.value("normalized", false));
    const Json& view = json_.at("bufferViews").at(json.at("bufferView").get<std::size_t>());
    need(view.at("buffer") == 0 && !view.contains("extensions"));
    Accessor result;
    const auto component = json.at("componentType").get<int>();
    if (type == std::string_view("VEC3")) {
      need(component == 5126);
      result.size = 3 * sizeof(float);
    } else {
      need(component == 5121 || component == 5123 || component == 5125);
      result.size = component == 5121 ? 1 : component == 5123 ? 2 : 4;
    }
    result.count = json.at("count").get<std::uint64_t>();
    result.stride = view.value("byteStride", result.size);
    const auto within = json.value("byteOffset", std::uint64_t{0}), start = view.value("byteOffset", std::uint64_t{0});
    const auto length = view.at("byteLength").get<std::uint64_t>();
    need(result.count > 0 && result.count < 0xffffffffU && result.stride >= result.size && result.stride < 256);
    need(start <= binarySize_ && length <= binarySize_ - start && within <= length);
    need((result.count - 1) * result.stride + result.size <= length - within);
    result.offset = binaryOffset_ + start + within;
    return result;
  }

  InputFile file_;
  Json json_;
  std::uint64_t binaryOffset_ = 0, binarySize_ = 0;
};

class GlbStream {
 public:
  GlbStream(const GlbFile& file, Environment& head, EnvironmentPacker& packer, RunContext* context)
      : file_(file), head_(head), packer_(packer), context_(context), parts_(head.parts) {}

  void read() {
    const std::vector<std::vector<Primitive>> primitives = file_.primitives();
    const GltfScene scene = gltfScene(file_.json());
    for (const std::size_t number : scene.nodes) {
      const Json& node = file_.json().at("nodes").at(number);
      if (!node.contains("mesh")) continue;
      need(!node.contains("extensions"));  // rejects instances
      const std::uint64_t mesh = gltfNumber(node, "mesh");
      need(mesh < primitives.size());
      for (std::size_t i = 0; i < primitives[mesh].size(); ++i)
        add(node, file_.json().at("meshes").at(mesh), i, primitives[mesh][i], scene.worlds[number]);
    }
    dropUnnamedPart(head_);
  }

 private:
  void add(const Json& node, const Json& mesh, std::size_t which, const Primitive& primitive, const Affine& world) {
    const std::uint64_t first = packer_.vertexCount();
    need(first + primitive.positions.count < 0xffffffffU);
    file_.forEach(primitive.positions, context_, [&](const char* bytes, std::uint64_t /*number*/) {
      std::array<float, 3> place{};
      std::memcpy(place.data(), bytes, sizeof place);
      const Vec3 p = world * Vec3{place[0], place[1], place[2]};
      need(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
      packer_.addVertex(p);
    });
    const bool mirrored = determinant(world) < 0;
    std::optional<std::uint32_t> part;
    Triangle corners{};
    file_.forEach(primitive.indices, context_, [&](const char* bytes, std::uint64_t number) {
      std::uint32_t index = 0;
      std::memcpy(&index, bytes, static_cast<std::size_t>(primitive.indices.size));
      need(index < primitive.positions.count);
      corners[number % 3] = static_cast<std::uint32_t>(first) + index;
      if (number % 3 != 2) return;
      if (mirrored) std::swap(corners[1], corners[2]);
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
        return skip(corners, number / 3, mesh);
      if (!part) part = gltfPart(file_.json(), node, mesh.at("primitives").at(which), parts_);
      packer_.addFace(corners, *part);
    });
  }

  void skip(const Triangle& corners, std::uint64_t face, const Json& mesh) {
    SkippedPolygon skipped = skippedPolygon(corners, PackerVertices{packer_});
    skipped.face = face + 1;
    skipped.mesh = cleanName(gltfText(mesh, "name"));
    addSkipped(head_.skipped, std::move(skipped));
  }

  const GlbFile& file_;
  Environment& head_;
  EnvironmentPacker& packer_;
  RunContext* context_;
  PartList parts_;
};

}  // namespace

bool streamGlb(const std::string& path, Environment& head, EnvironmentPacker& packer, RunContext* context) {
  try {
    const GlbFile file(path);
    packer.areFloats = true;
    GlbStream(file, head, packer, context).read();
    return true;
  } catch (const NotPlain&) {
    return false;
  } catch (const BadGltf&) {
    return false;
  } catch (const Json::exception&) {
    return false;
  }
}

}  // namespace footfall::detail
