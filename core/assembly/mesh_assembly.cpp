// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assembly/mesh_assembly.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/assembly/mesh_joiner.hpp"
#include "core/base/background_release.hpp"
#include "core/base/parallel.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {
namespace {

// Faces that one task triangulates, and that one part for display shows.
constexpr std::size_t kFacesPerTask = 32;
// Few faces are spread over so many tasks at least: they may be giants.
constexpr std::size_t kLeastTasks = 16;
// Faces with at least this many segments begin early.
constexpr std::size_t kSegmentsOfGiants = 128;
constexpr std::size_t kMeshesFreedPerTask = 2048;
constexpr std::size_t kCopiesPerTask = 512;
constexpr std::size_t kFacesListedPerTask = 2048;

// All floors that are not covered, in their order.
std::vector<FaceToJoin> facesToJoin(const WalkableState& state, const FaceMeshes& meshes, RunContext& context) {
  const SourceMesh& mesh = state.kernel->mesh();
  const std::size_t count = mesh.triangles.size();
  std::vector<std::vector<FaceToJoin>> parts((count + kFacesListedPerTask - 1) / kFacesListedPerTask);
  parallelFor(parts.size(), [&](std::size_t task) {
    context.checkCancelled();
    std::vector<FaceToJoin>& part = parts[task];
    for (std::size_t t = task * kFacesListedPerTask; t < std::min((task + 1) * kFacesListedPerTask, count); ++t) {
      if (state.walkable[t] == 0 || (state.cuts && state.cuts->isRemoved(t))) continue;
      const auto face = static_cast<Index>(t);
      if (meshes[t]) {
        part.push_back({face, 0, meshes[t].get()});
        continue;
      }
      std::uint8_t walls = state.cuts ? (*state.cuts)[t].edgeWalls : std::uint8_t{0};
      const auto& f = mesh.triangles[t];
      for (int k = 0; k < 3 && !mesh.obstacleEdges.empty(); ++k)
        if (mesh.hasObstacleEdge(f[k], f[(k + 1) % 3])) walls |= static_cast<std::uint8_t>(1 << k);
      part.push_back({face, walls, nullptr});
    }
  });
  std::size_t total = 0;
  for (const auto& part : parts) total += part.size();
  std::vector<FaceToJoin> joined;
  joined.reserve(total);
  for (const auto& part : parts) joined.insert(joined.end(), part.begin(), part.end());
  return joined;
}

}  // namespace

std::shared_ptr<const NavigationMesh> previewOfFaces(const PlanKernel& kernel, const CutTable& cuts,
                                                     const FaceMeshes& meshes, std::span<const Index> faces,
                                                     const RunContext& context) {
  const SourceMesh& source = kernel.mesh();
  const int scale = -source.grid.scaleExponent();
  auto part = std::make_shared<NavigationMesh>();
  part->vertices.reserve(3 * faces.size());
  part->triangles.reserve(faces.size());
  part->sourceTriangles.reserve(faces.size());
  std::uint32_t polls = 0;
  for (const Index face : faces) {
    if ((++polls & 1023) == 0) context.checkCancelled();
    if (cuts.isRemoved(face)) continue;
    const auto base = static_cast<std::uint32_t>(part->vertices.size());
    const auto addTriangle = [&](const std::array<Index, 3>& corners) {
      part->triangles.push_back({base + static_cast<std::uint32_t>(corners[0]),
                                 base + static_cast<std::uint32_t>(corners[1]),
                                 base + static_cast<std::uint32_t>(corners[2])});
      part->sourceTriangles.push_back(source.inputTriangles[face]);
    };
    if (!meshes[face]) {
      for (const Index v : source.triangles[face]) part->vertices.push_back(source.vertices[v]);
      addTriangle({0, 1, 2});
      continue;
    }
    const Vec3& origin = source.vertices[source.triangles[face][0]];
    const auto& n = source.normals[face];
    for (const ApproximatePoint& p : meshes[face]->approximate) {
      const double z = -(n[0].value * p.x + n[1].value * p.y) / n[2].value;
      part->vertices.push_back(
          {origin.x + std::ldexp(p.x, scale), origin.y + std::ldexp(p.y, scale), origin.z + std::ldexp(z, scale)});
    }
    for (const FaceMesh::Facet& c : meshes[face]->facets) addTriangle(c.corners);
  }
  return part;
}

std::shared_ptr<const WalkableMesh> assembleMesh(const WalkableState& state, RunContext& context,
                                                 ExactFallbacks& fallbacks) {
  const auto meshes = std::make_shared<FaceMeshes>(state.walkable.size());
  meshFaces(state, nullptr, {}, *meshes, context, fallbacks);
  return joinFaces(state, nullptr, {}, meshes, nullptr, context, fallbacks);
}

void meshFaces(const WalkableState& state, const EarlierResult* earlier, const std::vector<Index>& changed,
               FaceMeshes& meshes, RunContext& context, ExactFallbacks& fallbacks) {
  if (!state.cuts) return;
  const PlanKernel& kernel = *state.kernel;
  const auto count = static_cast<Index>(kernel.mesh().triangles.size());
  // Only faces with segments need a triangulation; giants first, so that no thread is left with one at the end.
  std::vector<Index> faces, giants, known;
  std::vector<char> isChanged(earlier != nullptr ? count : 0, 0);
  if (earlier != nullptr)
    for (const Index t : changed) isChanged[t] = 1;
  for (Index t = 0; t < count; ++t) {
    if ((t & 4095) == 0) context.checkCancelled();
    if (state.walkable[t] == 0 || !state.cuts->shared(t) || state.cuts->isRemoved(t) || meshes[t]) continue;
    if (earlier != nullptr && isChanged[t] == 0)
      known.push_back(t);
    else if (const std::size_t segments = (*state.cuts)[t].segments.size(); segments > 0)
      (segments < kSegmentsOfGiants ? faces : giants).push_back(t);
  }
  std::stable_sort(giants.begin(), giants.end(), [&](Index a, Index b) {
    return (*state.cuts)[a].segments.size() > (*state.cuts)[b].segments.size();
  });
  faces.insert(faces.begin(), giants.begin(), giants.end());

  PerThread<CopyMemory> copies(makeCopyMemory);
  parallelRanges(known.size(), kCopiesPerTask, [&](const auto& range) {
    const CopyMemory& ownCopies = copies.local();
    for (std::size_t i = range.begin(); i != range.end(); ++i)
      meshes[known[i]] = earlier->mesh(earlier->faceBefore(known[i]), ownCopies);
  });

  PerThread<std::unique_ptr<FaceMesher>> meshers;
  // Faces differ as much as their segments do: a giant alone can be nearly all of the work.
  std::size_t total = 1;
  for (const Index t : faces) total += (*state.cuts)[t].segments.size();
  std::atomic<std::size_t> done{0};
  const auto advance = [&](std::size_t segments) {
    constexpr std::size_t kParts = 256;
    const std::size_t before = done.fetch_add(segments, std::memory_order_relaxed), now = before + segments;
    if (before * kParts / total != now * kParts / total)
      context.progress(0.5 + 0.4 * static_cast<double>(now) / static_cast<double>(total));
  };
  // Threads take the next face that is left, so a giant at the front keeps one thread while the others go on.
  const std::size_t tasks =
      std::max((faces.size() + kFacesPerTask - 1) / kFacesPerTask, std::min(faces.size(), kLeastTasks));
  const std::size_t facesPerTask = tasks == 0 ? 0 : (faces.size() + tasks - 1) / tasks;
  std::atomic<std::size_t> nextFace{0};
  parallelFor(tasks, [&](std::size_t) {
    auto& mesher = meshers.local();
    if (!mesher) mesher = std::make_unique<FaceMesher>(kernel, context, advance);
    const CopyMemory& ownCopies = copies.local();
    std::vector<Index> mine;
    for (std::size_t k = 0; k < facesPerTask; ++k) {
      const std::size_t i = nextFace.fetch_add(1, std::memory_order_relaxed);
      if (i >= faces.size()) break;
      context.checkCancelled();
      meshes[faces[i]] = keptIn(ownCopies, mesher->mesh(faces[i], &(*state.cuts)[faces[i]]));
      mine.push_back(faces[i]);
    }
    if (context.wantsParts()) context.part(previewOfFaces(kernel, *state.cuts, meshes, mine, context));
  });
  for (const auto& mesher : meshers) fallbacks += mesher->fallbacks();
}

std::shared_ptr<const WalkableMesh> joinFaces(const WalkableState& state, const EarlierResult* earlier,
                                              const std::vector<Index>& changed,
                                              const std::shared_ptr<FaceMeshes>& ownedMeshes, AssemblyMemory* memory,
                                              RunContext& context, ExactFallbacks& fallbacks) {
  const PlanKernel& kernel = *state.kernel;
  FaceMeshes& meshes = *ownedMeshes;
  ReleaseOnException large(state.walkable.size() >= kLargeRelease);
  large.hold(ownedMeshes);
  const auto ownedJoiner = std::make_shared<MeshJoiner>(kernel);
  large.hold(ownedJoiner);
  MeshJoiner& joiner = *ownedJoiner;
  joiner.addFaces(facesToJoin(state, meshes, context), context);
  if (memory != nullptr) {
    memory->meshes = std::move(meshes);
  } else {
    parallelRanges(meshes.size(), kMeshesFreedPerTask, [&](const auto& range) {
      for (std::size_t t = range.begin(); t != range.end(); ++t) meshes[t] = nullptr;
    });
  }
  if (earlier != nullptr) joiner.reuse(*earlier, changed);
  auto mesh = std::make_shared<WalkableMesh>(joiner.join(context));
  fallbacks += joiner.fallbacks();
  if (memory != nullptr) {
    memory->join = joiner.takeMemory();
  }
  return mesh;
}

std::shared_ptr<const WalkableState> withMesh(const std::shared_ptr<const WalkableState>& state, RunContext& context,
                                              ExactFallbacks& fallbacks) {
  if (state->mesh) return state;
  auto result = std::make_shared<WalkableState>(*state);
  result->mesh = assembleMesh(*state, context, fallbacks);
  return result;
}

}  // namespace footfall::detail
