// Decoders of compressed glTF, as far as the build has them (meshoptimizer, Draco).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace footfall::detail {

/// EXT_meshopt_compression: how a buffer view is packed.
struct MeshoptView {
  std::string mode, filter;
  std::uint64_t count = 0, stride = 0;
};
/// Throws BadGltf for bytes that are not in order, and where the build has no meshoptimizer.
std::string decodeMeshopt(std::string_view bytes, const MeshoptView& view);

/// KHR_draco_mesh_compression: a mesh of triangles.
struct DracoMesh {
  std::vector<std::uint32_t> corners;
  /// Of each attribute that was asked for: its numbers for all vertices, four for each.
  std::vector<std::vector<std::array<double, 4>>> attributes;
};
/// `attributes`: their unique numbers. Throws BadGltf as decodeMeshopt().
DracoMesh decodeDraco(std::string_view bytes, const std::vector<std::uint32_t>& attributes);

}  // namespace footfall::detail
