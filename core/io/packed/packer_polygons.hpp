// Splitting polygons whose vertices a sink has.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "core/environment/skipped_polygons.hpp"
#include "core/io/packed/mesh_sink.hpp"
#include "core/io/polygon_triangulation.hpp"

namespace footfall::detail {

/// All vertices so far, where polygons look for their corners.
struct PackerVertices {
  const MeshSink& sink;
};

/// As the functions of these names for a list of vertices: they go by the places of corners, and by which are the same.
bool triangulatePolygon(std::span<const std::uint32_t> corners, const PackerVertices& vertices,
                        std::vector<Triangle>& triangles, const Poll& poll = {});
SkippedPolygon skippedPolygon(std::span<const std::uint32_t> corners, const PackerVertices& vertices);

}  // namespace footfall::detail
