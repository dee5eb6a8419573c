// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/formats/save.hpp"

#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/io/export.hpp"
#include "core/io/formats/detour_export.hpp"
#include "core/io/formats/geojson_export.hpp"
#include "core/io/formats/godot_export.hpp"
#include "core/io/formats/wkt_export.hpp"
#include "core/io/gltf_export.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {

void checkReplaced(const std::string& path) {
  std::string_view expected;
  switch (exportFormatOf(path)) {
    case ExportFormat::Detour:
      expected = "TESM";  // MSET, lowest byte first
      break;
    case ExportFormat::Godot:
      expected = "[gd_resource type=\"NavigationMesh\"";
      break;
    default:
      return;
  }
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored) || std::filesystem::file_size(path, ignored) == 0) return;
  std::ifstream file(path, std::ios::binary);
  if (!file) return;
  std::string start(expected.size(), '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  if (start != expected)
    throw InputError(FOOTFALL_TEXT("%1: already exists and is not a navigation mesh; choose another name"), path);
}

ExportFiles formatExport(ExportFormat format, const std::string& path, const NavigationMesh& mesh,
                         const ExportHeader& header, const ExportOptions& options, std::span<const ExportExtra> extras,
                         Poll poll) {
  const FormatDescriptor& descriptor = descriptorOf(format);
  checkOptions(format, options);
  if (!extras.empty() && !descriptor.hasExtras)
    throw InputError(FOOTFALL_TEXT("a file that ends in %1 cannot hold placed obstacles; leave them out, or export as "
                                   ".obj or .glb"),
                     descriptor.ending);
  const auto single = [&path](std::string&& bytes, double largestError) {
    ExportFiles made;
    made.files.push_back({path, std::move(bytes)});
    made.largestError = largestError;
    return made;
  };
  switch (format) {
    case ExportFormat::Obj:
      break;
    case ExportFormat::Gltf:
    case ExportFormat::Glb: {
      const GltfKind kind = format == ExportFormat::Gltf ? GltfKind::Text : GltfKind::Binary;
      GltfFile file = formatGltf(kind, mesh, header, options, extras, poll);
      return single(std::move(file.bytes), file.largestError);
    }
    case ExportFormat::Detour: {
      DetourFile file = formatDetour(mesh, header, options, {}, poll);
      return single(std::move(file.bytes), file.largestError);
    }
    case ExportFormat::Godot: {
      GodotFile file = formatGodot(mesh, header, options, poll);
      return single(std::move(file.text), file.largestError);
    }
    case ExportFormat::Wkt:
      return {makeWktFiles(mesh, path, options, poll), 0};
    case ExportFormat::GeoJson:
      return single(formatGeoJson(mesh, options, poll), 0);
  }
  return single(formatObj(mesh, header, options, extras, poll), 0);
}

}  // namespace footfall::detail

namespace footfall {

double save(const NavigationMesh& mesh, const std::string& path, const ExportOptions& options,
            const ExportHeader& header, std::span<const ExportExtra> extras, RunContext* context) {
  using namespace detail;
  checkReplaced(path);
  const Poll poll(context);
  const ExportFiles made = formatExport(exportFormatOf(path), path, mesh, header, options, extras, poll);
  writeFilesSafely(made.files, poll);
  return made.largestError;
}

}  // namespace footfall
