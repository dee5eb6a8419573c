// Writing the navigation mesh as glTF 2.0.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "core/io/export.hpp"

namespace footfall::detail {

enum class GltfKind {
  Text,   ///< .gltf: one JSON file with its numbers inside as base64
  Binary  ///< .glb
};

struct GltfFile {
  std::string bytes;
  /// The largest distance, in metres, by which rounding to floats moved a coordinate.
  double largestError = 0;
};

/// A mesh and a node for each layer ("layer_0", ...; "walkable" without layers) with the colours of the editor, seen
/// from both sides; connections and obstacle edges as line primitives ("connections", "obstacle_edges"); extras as
/// "placed_NAME". `asset.extras` says what the comments of an OBJ say, and the agent's numbers; extras of nodes have
/// layer and area of surfaces, layers and heights of steps, gaps and drops. With ExportOptions::navmeshNode all layers
/// are one mesh.
///
/// Coordinates are as the format demands: Y up, metres (the scale of the mesh's file is applied, then that of
/// `options`), and floats, which have 24 bits: at 1 km from the origin they are 0.06 mm apart, at 500 km (map
/// coordinates) 3 cm. Nothing is moved to the origin to hide that, as the result would no longer lie on its source:
/// `largestError` says how far. Triangles that become degenerate by it stay in the file. Vertices are shared by index
/// within a layer exactly where an agent can cross; between layers, which are meshes of their own, the connections say
/// it. For programs that go on computing, OBJ has it all, in doubles.
///
/// Throws InputError (checkScale(); coordinates that no float holds), RunError for a .glb of more than 4 GB, and what
/// `poll` throws.
GltfFile formatGltf(GltfKind kind, const NavigationMesh& mesh, const ExportHeader& header,
                    const ExportOptions& options = {}, std::span<const ExportExtra> extras = {}, Poll poll = {});

}  // namespace footfall::detail
