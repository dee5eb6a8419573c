// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/formats/format_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <vector>

#include "core/base/counted_text.hpp"
#include "core/io/formats/detour_tiles.hpp"
#include "core/io/formats/geojson_export.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

constexpr std::array kFormats{
    FormatDescriptor{
        .format = ExportFormat::Obj,
        .ending = ".obj",
        .name = FOOTFALL_TEXT("Wavefront OBJ: exact, in the file's frame"),
        .keeps = FOOTFALL_TEXT("everything, in doubles; footfall compare and other tools read it back"),
        .loses = FOOTFALL_TEXT("nothing"),
        .hasFrame = true,
    },
    FormatDescriptor{
        .format = ExportFormat::Gltf,
        .ending = ".gltf",
        .name = FOOTFALL_TEXT("glTF, text: metres, Y up"),
        .keeps = FOOTFALL_TEXT("everything, in metres; agent, areas and links as extras"),
        .loses = FOOTFALL_TEXT("digits beyond the seventh"),
        .hasNavmeshNode = true,
        .layersAs = FOOTFALL_TEXT("A mesh for each layer"),
    },
    FormatDescriptor{
        .format = ExportFormat::Glb,
        .ending = ".glb",
        .name = FOOTFALL_TEXT("glTF, binary: metres, Y up"),
        .keeps = FOOTFALL_TEXT("everything, in metres; agent, areas and links as extras"),
        .loses = FOOTFALL_TEXT("digits beyond the seventh"),
        .hasNavmeshNode = true,
        .layersAs = FOOTFALL_TEXT("A mesh for each layer"),
    },
    FormatDescriptor{
        .format = ExportFormat::Detour,
        .ending = ".bin",
        .name = FOOTFALL_TEXT("Detour: tile set, metres, Y up"),
        .keeps =
            FOOTFALL_TEXT("convex polygons with their connections, heights, steps, drops, the agent; layers as areas"),
        .loses = FOOTFALL_TEXT("digits beyond the seventh; more than 58 layers; placed obstacles"),
        .hasLines = false,
        .hasExtras = false,
        .layersAs = FOOTFALL_TEXT("Layers as areas"),
        .stepsAs = FOOTFALL_TEXT("Steps that can be crossed"),
    },
    FormatDescriptor{
        .format = ExportFormat::Godot,
        .ending = ".tres",
        .name = FOOTFALL_TEXT("Godot: NavigationMesh, metres, Y up"),
        .keeps = FOOTFALL_TEXT("convex polygons, steps as polygons, the agent"),
        .loses = FOOTFALL_TEXT(
            "digits beyond the seventh, drops, layers, placed obstacles; what is smaller than a cell of Godot's map"),
        .hasLayers = false,
        .hasLines = false,
        .hasDrops = false,
        .hasExtras = false,
        .hasGodotVersion = true,
        .stepsAs = FOOTFALL_TEXT("Steps as polygons"),
    },
    FormatDescriptor{
        .format = ExportFormat::Wkt,
        .ending = ".wkt",
        .name = FOOTFALL_TEXT("Well-known text: polygons with holes, metres"),
        .keeps =
            FOOTFALL_TEXT("polygons with holes, a file for each layer, in doubles; connections, steps, gaps, drops "
                          "and thin walls as lines in another file"),
        .loses = FOOTFALL_TEXT("heights, triangles, what links lead to, the agent, placed obstacles"),
        .hasExtras = false,
        .hasParts = true,
        .hasFilesBeside = true,
        .layersAs = FOOTFALL_TEXT("A file for each layer"),
        .stepsAs = FOOTFALL_TEXT("Steps as lines"),
    },
    FormatDescriptor{
        .format = ExportFormat::GeoJson,
        .ending = ".geojson",
        .name = FOOTFALL_TEXT("GeoJSON: polygons with holes, metres"),
        .keeps =
            FOOTFALL_TEXT("polygons with holes and heights, layer, part and area of each, in doubles; connections, "
                          "steps, gaps, drops and thin walls as lines"),
        .loses = FOOTFALL_TEXT("triangles, the agent, placed obstacles"),
        .hasExtras = false,
        .hasParts = true,
        .hasCoordinateSystem = true,
        .layersAs = FOOTFALL_TEXT("The layer of each polygon"),
        .stepsAs = FOOTFALL_TEXT("Steps as lines"),
    },
};

/// Joins phrases: "3 drops, 2 obstacle edges".
Text listed(const std::vector<Text>& parts) {
  Text list = parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i) list = Text(Pattern{"%1, %2"}, list, parts[i]);
  return list;
}

}  // namespace

std::span<const FormatDescriptor> exportFormats() { return kFormats; }

const FormatDescriptor& descriptorOf(ExportFormat format) {
  return *std::find_if(kFormats.begin(), kFormats.end(), [&](const auto& d) { return d.format == format; });
}

std::string exportEndings() {
  std::string endings;
  for (std::size_t i = 0; i < kFormats.size(); ++i) {
    if (i > 0) endings += i + 1 < kFormats.size() ? ", " : " or ";
    endings += kFormats[i].ending;
  }
  return endings;
}

ExportFormat exportFormatOf(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending.empty()) return ExportFormat::Obj;
  for (const FormatDescriptor& format : kFormats)
    if (ending == format.ending) return format.format;
  throw InputError(FOOTFALL_TEXT("%1: cannot be written in the format \"%2\"; give a name that ends in %3"), path,
                   ending.substr(1), exportEndings());
}

void checkOptions(ExportFormat format, const ExportOptions& options) {
  const FormatDescriptor& descriptor = descriptorOf(format);
  const ExportOptions usual;
  const auto check = [&](bool isAsked, bool isKnown, Pattern option) {
    if (isAsked && !isKnown)
      throw InputError(FOOTFALL_TEXT("a file that ends in %1 has no choice of %2; leave that out"), descriptor.ending,
                       Text(option));
  };
  check(options.up.has_value(), descriptor.hasFrame, FOOTFALL_TEXT("an up axis"));
  check(options.godot != usual.godot, descriptor.hasGodotVersion, FOOTFALL_TEXT("a version of Godot"));
  check(options.navmeshNode, descriptor.hasNavmeshNode, FOOTFALL_TEXT("a node for Godot"));
  check(options.part.has_value(), descriptor.hasParts, FOOTFALL_TEXT("a connected part"));
  check(!options.coordinateSystem.empty(), descriptor.hasCoordinateSystem, FOOTFALL_TEXT("a coordinate system"));
  if (!options.coordinateSystem.empty()) checkCoordinateSystem(options.coordinateSystem);
}

Text lossesOf(ExportFormat format, const NavigationMesh& mesh, const ExportOptions& options) {
  const FormatDescriptor& descriptor = descriptorOf(format);
  std::vector<Text> lost;
  const auto add = [&](std::size_t count, bool isAsked, bool isKept, Pattern one, Pattern many) {
    if (count > 0 && isAsked && !isKept) lost.push_back(countedText(count, one, many));
  };
  // A single layer is no loss, because it holds everything.
  add(mesh.layerCount > 1 ? mesh.layerCount : 0, options.layers, descriptor.hasLayers, FOOTFALL_TEXT("1 layer"),
      FOOTFALL_TEXT("%1 layers"));
  add(mesh.drops.size(), options.drops, descriptor.hasDrops, FOOTFALL_TEXT("1 drop"), FOOTFALL_TEXT("%1 drops"));
  constexpr std::uint32_t kAreas = kLastArea - kFirstLayerArea;
  add(format == ExportFormat::Detour && mesh.layerCount > kAreas + 1 ? mesh.layerCount - kAreas : 0, options.layers,
      false, FOOTFALL_TEXT("the area of 1 layer"), FOOTFALL_TEXT("the areas of %1 layers"));
  return lost.empty() ? Text() : listed(lost);
}

}  // namespace footfall::detail
