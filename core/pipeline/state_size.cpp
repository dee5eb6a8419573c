// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/state_size.hpp"

#include <vector>

#include "core/assembly/assembly_memory.hpp"
#include "core/filters/radius/radius_memory.hpp"
#include "core/filters/simplification/simplifier.hpp"
#include "core/filters/steps/step_memory.hpp"
#include "core/mesh/mesh_topology.hpp"

namespace footfall::detail {
namespace {

template <typename Element>
std::size_t bytesOf(const std::vector<Element>& list) {
  return list.capacity() * sizeof(Element);
}

std::size_t bytesOf(const WalkableMesh& mesh) {
  return bytesOf(mesh.vertices) + bytesOf(mesh.triangles) + bytesOf(mesh.layers);
}

std::size_t bytesOf(const Adjacency& topology) { return bytesOf(topology.sides) + bytesOf(topology.first); }

// Faces keep their points, and about two triangles and one line a point.
std::size_t bytesOf(const AssemblyMemory& memory) {
  constexpr std::size_t kPerPoint =
      sizeof(PlanPoint) + sizeof(ApproximatePoint) + sizeof(PlanLine) + 2 * sizeof(FaceMesh::Facet);
  const JoinMemory& join = memory.join;
  std::size_t large = 0;
  for (const auto& [face, kept] : memory.large) large += sizeof(LargeFace) + bytesOf(kept->points);
  return large + bytesOf(memory.meshes) + bytesOf(memory.candidates) + bytesOf(join.entries) + bytesOf(join.vertexOf) +
         bytesOf(join.between) + bytesOf(join.equal) + join.vertexOf.size() * kPerPoint;
}

std::size_t bytesOf(const SimplifierMemory& memory) {
  return bytesOf(memory.neighbors) + bytesOf(memory.candidates) + bytesOf(memory.groupOf) + bytesOf(memory.triangles) +
         bytesOf(memory.alive);
}

// A cut face has about as many points in its cuts as in its mesh.
std::size_t cutsOf(const WalkableState& state) {
  constexpr std::size_t kPerFace = sizeof(std::shared_ptr<const FaceCuts>) + 1;
  constexpr std::size_t kPerPoint = sizeof(PlanPoint) + sizeof(PlanLine) + sizeof(CutSegment) + 1;
  const std::size_t points = state.memory ? state.memory->join.vertexOf.size() : 0;
  return state.walkable.size() * kPerFace + points * kPerPoint;
}

}  // namespace

void addParts(const WalkableState& state, std::vector<StatePart>& parts) {
  parts.push_back({&state, bytesOf(state.walkable) + bytesOf(state.removed)});
  const auto add = [&](const auto& part, auto size) {
    if (part) parts.push_back({part.get(), size(*part)});
  };
  const auto own = [](const auto& part) { return bytesOf(part); };
  add(state.mesh, own);
  add(state.dropped, own);
  add(state.topology, own);
  add(state.memory, own);
  add(state.simplifierMemory, own);
  add(state.stepMemory, own);
  add(state.radiusMemory, own);
  if (state.radiusMemory) addParts(*state.radiusMemory->simplified, parts);
  add(state.overlaps, own);
  add(state.cuts, [&](const CutTable&) { return cutsOf(state); });
}

std::size_t sizeOf(const NavigationMesh& mesh) {
  return bytesOf(mesh.vertices) + bytesOf(mesh.triangles) + bytesOf(mesh.layers) + bytesOf(mesh.sourceTriangles) +
         bytesOf(mesh.obstacleEdges) + bytesOf(mesh.connections);
}

}  // namespace footfall::detail
