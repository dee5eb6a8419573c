// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/palette.hpp"
#include "core/navigation/corridor_places.hpp"
#include "footfall/corridor_map.hpp"
#include "footfall/errors.hpp"
#include "footfall/version.hpp"

namespace footfall {
using namespace detail;
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

// Numbers of glTF 2.0.
constexpr int kFloat = 5126, kLines = 1, kArrayBuffer = 34962;
constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

/// Metres: passages up to the first are in the first colour, and so on.
constexpr double kNarrow = 0.8, kWide = 2;

double linear(int value) {
  const double share = value / 255.0;
  return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

/// Vermilion up to kNarrow, blue from kWide on, and a mixture between.
std::array<float, 3> colourOf(double width) {
  const double share = std::clamp((width - kNarrow) / (kWide - kNarrow), 0.0, 1.0);
  std::array<float, 3> colour{};
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] = static_cast<float>(linear(kVermilion[i]) * (1 - share) + linear(kBlue[i]) * share);
  return colour;
}

/// Pieces of lines in metres, Y up, each end with a colour.
class GltfLines {
 public:
  explicit GltfLines(double metresPerUnit) : metres_(metresPerUnit) {}

  void add(const Vec3& p, double width) {
    places_.push_back(
        {static_cast<float>(p.x * metres_), static_cast<float>(p.z * metres_), static_cast<float>(-p.y * metres_)});
    colours_.push_back(colourOf(width * metres_));
  }
  [[nodiscard]] const std::vector<std::array<float, 3>>& places() const { return places_; }
  [[nodiscard]] const std::vector<std::array<float, 3>>& colours() const { return colours_; }

 private:
  double metres_;
  std::vector<std::array<float, 3>> places_, colours_;
};

/// The document and the bytes of a file, to which meshes of lines are added.
class GltfWriter {
 public:
  void add(const char* name, const GltfLines& lines) {
    if (lines.places().empty()) return;
    const std::size_t place = addNumbers(lines.places(), true), colour = addNumbers(lines.colours(), false);
    json_["meshes"].push_back(
        {{"name", name},
         {"primitives",
          {{{"attributes", {{"POSITION", place}, {"COLOR_0", colour}}}, {"mode", kLines}, {"material", 0}}}}});
    json_["nodes"].push_back({{"name", name}, {"mesh", json_["meshes"].size() - 1}});
    json_["scenes"][0]["nodes"].push_back(json_["nodes"].size() - 1);
  }

  [[nodiscard]] std::string write() {
    if (!bytes_.empty()) json_["buffers"] = {{{"byteLength", bytes_.size()}}};
    std::string text = json_.dump();
    text.append((4 - text.size() % 4) % 4, ' ');
    const std::size_t size = 12 + 8 + text.size() + (bytes_.empty() ? 0 : 8 + bytes_.size());
    if (size > std::numeric_limits<std::uint32_t>::max())
      throw InputError(FOOTFALL_TEXT("the corridor map is too large for glTF, which ends at 4 GB; write it as .json"));
    std::string file;
    const auto append = [&file](std::uint32_t value) {
      file.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    append(kMagic);
    append(kVersion);
    append(static_cast<std::uint32_t>(size));
    append(static_cast<std::uint32_t>(text.size()));
    append(kJsonChunk);
    file += text;
    if (bytes_.empty()) return file;
    append(static_cast<std::uint32_t>(bytes_.size()));
    append(kBinaryChunk);
    return file + bytes_;
  }

 private:
  std::size_t addNumbers(const std::vector<std::array<float, 3>>& numbers, bool hasBounds) {
    const std::size_t length = numbers.size() * sizeof numbers[0];
    json_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", length}, {"target", kArrayBuffer}});
    bytes_.append(reinterpret_cast<const char*>(numbers.data()), length);
    nlohmann::ordered_json accessor{{"bufferView", json_["bufferViews"].size() - 1},
                                    {"componentType", kFloat},
                                    {"count", numbers.size()},
                                    {"type", "VEC3"}};
    if (hasBounds) {
      std::array<float, 3> least = numbers[0], most = numbers[0];
      for (const auto& n : numbers)
        for (std::size_t i = 0; i < 3; ++i) {
          least[i] = std::min(least[i], n[i]);
          most[i] = std::max(most[i], n[i]);
        }
      accessor["min"] = least;
      accessor["max"] = most;
    }
    json_["accessors"].push_back(accessor);
    return json_["accessors"].size() - 1;
  }

  nlohmann::ordered_json json_{{"asset", {{"version", "2.0"}, {"generator", std::string("footfall ") + version()}}},
                               {"extensionsUsed", {"KHR_materials_unlit"}},
                               {"scene", 0},
                               {"scenes", {{{"nodes", nlohmann::ordered_json::array()}}}},
                               {"materials",
                                {{{"name", "widths"},
                                  {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 1}}, {"metallicFactor", 0}}},
                                  {"extensions", {{"KHR_materials_unlit", nlohmann::ordered_json::object()}}}}}}};
  std::string bytes_;
};

}  // namespace

std::string formatCorridorsGlb(const CorridorMap& map) {
  GltfLines corridors(map.frame.metresPerUnit), bottlenecks(map.frame.metresPerUnit);
  for (const CorridorEdge& edge : map.edges) {
    const std::vector<Vec3> places = placesAlong(map, edge);
    const double first = map.vertices[edge.from].width, last = map.vertices[edge.to].width;
    const auto widthAt = [&](std::size_t i) {
      const double share = static_cast<double>(i) / static_cast<double>(places.size() - 1);
      return first + share * (last - first);
    };
    for (std::size_t i = 1; i < places.size(); ++i) {
      corridors.add(places[i - 1], widthAt(i - 1));
      corridors.add(places[i], widthAt(i));
    }
  }
  for (const Bottleneck& b : map.bottlenecks)
    for (const Vec3& end : {b.left, b.right}) bottlenecks.add(end, b.width);
  GltfWriter writer;
  writer.add("corridors", corridors);
  writer.add("bottlenecks", bottlenecks);
  return writer.write();
}

}  // namespace footfall
