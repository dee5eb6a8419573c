// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/formats/save.hpp"

#include "core/io/export.hpp"
#include "core/io/formats/detour_export.hpp"
#include "core/io/formats/godot_export.hpp"
#include "core/io/gltf_export.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {

ExportBytes formatExport(ExportFormat format, const NavigationMesh& mesh, const ExportHeader& header,
                         const ExportOptions& options, std::span<const ExportExtra> extras) {
  const FormatDescriptor& descriptor = descriptorOf(format);
  if (!extras.empty() && !descriptor.hasExtras)
    throw InputError(FOOTFALL_TEXT("a file that ends in %1 cannot hold placed obstacles; leave them out, or export as "
                                   ".obj or .glb"),
                     descriptor.ending);
  switch (format) {
    case ExportFormat::Obj:
      break;
    case ExportFormat::Gltf:
    case ExportFormat::Glb: {
      GltfFile file =
          formatGltf(format == ExportFormat::Gltf ? GltfKind::Text : GltfKind::Binary, mesh, header, options, extras);
      return {std::move(file.bytes), file.largestError};
    }
    case ExportFormat::Detour: {
      DetourFile file = formatDetour(mesh, header, options);
      return {std::move(file.bytes), file.largestError};
    }
    case ExportFormat::Godot: {
      GodotFile file = formatGodot(mesh, header, options);
      return {std::move(file.text), file.largestError};
    }
  }
  return {formatObj(mesh, header, options, extras), 0};
}

}  // namespace footfall::detail

namespace footfall {

double save(const NavigationMesh& mesh, const std::string& path, const ExportOptions& options,
            const ExportHeader& header, std::span<const ExportExtra> extras) {
  using namespace detail;
  const ExportBytes file = formatExport(exportFormatOf(path), mesh, header, options, extras);
  writeFileSafely(path, file.bytes);
  return file.largestError;
}

}  // namespace footfall
