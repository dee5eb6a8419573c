// Splitting polygons whose vertices are in a sink.
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

/// All vertices so far; polygons look up their corners here.
struct PackerVertices {
  const MeshSink& sink;
};

/// Overloads of the functions for a list of vertices. They compare the places of corners, and which corners are the
/// same.
bool triangulatePolygon(std::span<const std::uint32_t> corners, const PackerVertices& vertices,
                        std::vector<Triangle>& triangles, const Poll& poll = {});
SkippedPolygon skippedPolygon(std::span<const std::uint32_t> corners, const PackerVertices& vertices);

}  // namespace footfall::detail
