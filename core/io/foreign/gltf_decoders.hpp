// Decoders of compressed glTF, where the build has their libraries (meshoptimizer, Draco).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace footfall::detail {

/// The parameters of EXT_meshopt_compression for a buffer view.
struct MeshoptView {
  std::string mode, filter;
  std::uint64_t count = 0, stride = 0;
};
/// Throws BadGltf for invalid bytes, and where the build has no meshoptimizer.
std::string decodeMeshopt(std::string_view bytes, const MeshoptView& view);

/// KHR_draco_mesh_compression: a mesh of triangles.
struct DracoMesh {
  std::vector<std::uint32_t> corners;
  /// The numbers of each requested attribute for all vertices, four for each vertex.
  std::vector<std::vector<std::array<double, 4>>> attributes;
};
/// `attributes` are unique ids of the mesh's attributes. Throws BadGltf as decodeMeshopt() does.
DracoMesh decodeDraco(std::string_view bytes, const std::vector<std::uint32_t>& attributes);

}  // namespace footfall::detail
