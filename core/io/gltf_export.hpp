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

/// Writes a mesh and a node for each layer ("layer_0", ...; "walkable" without layers) with the colours of the editor,
/// seen from both sides; connections and obstacle edges as line primitives ("connections", "obstacle_edges"); extras as
/// "placed_NAME". `asset.extras` has the content of an OBJ's comments and the agent's numbers. Extras of nodes have the
/// layer and area of surfaces, and the layers and heights of steps, gaps and drops. With ExportOptions::navmeshNode all
/// layers are one mesh.
///
/// Coordinates follow the format: Y up, metres (the scale of the mesh's file is applied, then that of `options`), and
/// floats, which have 24 bits. At 1 km from the origin, neighbouring floats are 0.06 mm apart, at 500 km (map
/// coordinates) 3 cm. The mesh is not moved to the origin to hide this, because the result would no longer lie on its
/// source; `largestError` has the largest shift. Triangles that rounding makes degenerate stay in the file. Vertices
/// are shared by index within a layer exactly where an agent can cross. Layers are meshes of their own, and the
/// connections show where agents cross between them. OBJ has all of this in doubles, for programs that compute further.
///
/// Throws InputError (checkScale(); coordinates that no float holds), RunError for a .glb of more than 4 GB, and what
/// `poll` throws.
GltfFile formatGltf(GltfKind kind, const NavigationMesh& mesh, const ExportHeader& header,
                    const ExportOptions& options = {}, std::span<const ExportExtra> extras = {}, Poll poll = {});

}  // namespace footfall::detail
