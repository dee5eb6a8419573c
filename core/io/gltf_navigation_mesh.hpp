// Reading back the navigation mesh of a glTF that Footfall wrote (gltf_export.hpp).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each layer has vertices of its own there, and so have connections, obstacle edges and links. What belongs together is
// found by the places, as floats: an edge of a triangle, in its direction, is one of its layer.
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

/// Everything in the frame of the format: metres, Y up.
struct GltfNavigationMesh {
  NavigationMesh mesh;  ///< without links and drops
  std::vector<std::string> layerNames;
  /// A link's border and the one across, in their own directions, by vertices of the mesh.
  using LinkEdges = std::array<std::uint32_t, 4>;
  std::vector<LinkEdges> steps, gaps;
  std::vector<DropLine> drops;
  std::size_t statedSteps = 0, statedGaps = 0;
};

/// Empty where the text is no glTF of Footfall's. Throws InputError for one that is damaged, and what `poll` throws.
std::optional<GltfNavigationMesh> readGltfNavigationMesh(const std::string& path, std::string_view text,
                                                         Poll poll = {});

}  // namespace footfall::detail
