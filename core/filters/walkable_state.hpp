// The state between filters: which source triangles are floors, what obstacles cut out of them, and the mesh of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/environment/environment.hpp"
#include "core/exact/plan_kernel.hpp"
#include "core/filters/face_cuts.hpp"

namespace footfall {

/// A vertex is a plan point lifted to the plane of a face; its rounded place serves filters and display.
struct MeshVertex {
  PlanPoint point;
  Index face = -1;    ///< a source triangle whose plane holds the vertex
  Index source = -1;  ///< the source vertex that it is, or -1 for a constructed one
  /// Scaled coordinates (SourceMesh::scaled), each within `error` of the exact ones.
  double x = 0, y = 0, z = 0;
  double error = 0;
};

struct MeshTriangle {
  std::array<Index, 3> corners{};  ///< counter-clockwise from above
  Index face = -1;                 ///< a source triangle in whose plane it lies
  std::uint8_t obstacleEdges = 0;  ///< bit k: an obstacle stands on the edge from corner k to k + 1
};

/// The walkable area, conforming: triangles that meet share whole edges, by vertex index. Both sides of an obstacle
/// edge still have the same vertices here; they are told apart by the flag and split when the product is made.
struct WalkableMesh {
  std::vector<MeshVertex> vertices;
  std::vector<MeshTriangle> triangles;
  std::vector<std::uint32_t> layers;  ///< one for each triangle, or empty
  std::uint32_t layerCount = 0;
};

struct AssemblyMemory;    // core/filters/assembly_memory.hpp
struct SimplifierMemory;  // core/filters/simplifier.hpp

struct MeshTopology;  // core/filters/mesh_topology.hpp

struct WalkableState {
  std::shared_ptr<const Environment> environment;
  std::shared_ptr<const PlanKernel> kernel;
  /// For each source triangle: it takes part as a floor (its cuts say which part of it).
  std::vector<char> walkable;
  /// For each source triangle: taken out of the environment altogether (DegeneracyFilter).
  std::vector<char> removed;
  /// For each source triangle, or empty before the first clearance filter.
  std::shared_ptr<const CutTable> cuts;
  /// The mesh of walkable parts; null until a filter needed it.
  std::shared_ptr<const WalkableMesh> mesh;
  /// The edges of `topologyOwner`, when a filter found them; of use while that is still `mesh` (topologyOf()).
  std::shared_ptr<const MeshTopology> topology;
  std::weak_ptr<const WalkableMesh> topologyOwner;
  /// The mesh's triangles may span several coplanar source triangles (SimplificationFilter).
  bool simplified = false;
  /// Pieces that AreaFilter took away since the cuts were made: obstacles still, but no floor any more.
  std::shared_ptr<const WalkableMesh> dropped;
  /// How the mesh of the last clearance filter came about, for later runs to take over; null when nobody asked for it.
  std::shared_ptr<const AssemblyMemory> memory;
  /// The same of the last SimplificationFilter.
  std::shared_ptr<const SimplifierMemory> simplifierMemory;
  /// Pairs of triangles that the last LayerSubdivisionFilter found above one another; null when nobody asked for it.
  std::shared_ptr<const std::vector<std::array<Index, 2>>> overlaps;
};

}  // namespace footfall
