// Reading back the navigation mesh of a glTF that Footfall wrote (gltf_export.hpp).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each layer has vertices of its own in such a file, and so have connections, obstacle edges and links. The reader
// matches them by their places, as floats: an edge of a triangle, in its direction, belongs to one layer only.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/poll.hpp"
#include "core/io/drop_reading.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// A navigation mesh in the frame of the format: metres, Y up.
struct GltfNavigationMesh {
  NavigationMesh mesh;  ///< it has no links and drops
  std::vector<std::string> layerNames;
  /// The border of a link and the border across, each in its own direction, as vertices of the mesh.
  using LinkEdges = std::array<std::uint32_t, 4>;
  std::vector<LinkEdges> steps, gaps;
  std::vector<DropLine> drops;
  std::size_t statedSteps = 0, statedGaps = 0;
};

/// Empty where the text is not a glTF that Footfall wrote. Throws InputError for a damaged one, and what `poll` throws.
std::optional<GltfNavigationMesh> readGltfNavigationMesh(const std::string& path, std::string_view text,
                                                         Poll poll = {});

}  // namespace footfall::detail
