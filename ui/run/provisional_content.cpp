// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/provisional_content.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <unordered_set>

namespace footfall::ui {
namespace {

/// A set of faces of the environment, by index.
class FaceSet {
 public:
  void add(const std::vector<std::uint32_t>& faces) {
    for (const std::uint32_t face : faces) {
      if (face >= has_.size()) has_.resize(face + 1);
      has_[face] = true;
    }
  }
  [[nodiscard]] bool contains(std::uint32_t face) const { return face < has_.size() && has_[face]; }

 private:
  std::vector<bool> has_;
};

using Corners = std::array<Vec3, 3>;

struct CornersHash {
  std::size_t operator()(const Corners& corners) const {
    std::uint64_t h = 0;
    for (const Vec3& p : corners) {
      for (const double d : {p.x, p.y, p.z}) h = (h ^ std::bit_cast<std::uint64_t>(d + 0.0)) * 0x9E3779B97F4A7C15ULL;
      h ^= h >> 29U;
    }
    return static_cast<std::size_t>(h);
  }
};

Corners cornersOf(const NavigationMesh& mesh, std::size_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

// The triangles of a mesh that another mesh does not have.
NavigationMesh without(const NavigationMesh& mesh, const NavigationMesh& other) {
  std::unordered_set<Corners, CornersHash> known;
  known.reserve(other.triangles.size());
  for (std::size_t t = 0; t < other.triangles.size(); ++t) known.insert(cornersOf(other, t));
  NavigationMesh rest;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners corners = cornersOf(mesh, t);
    if (known.contains(corners)) continue;
    const auto base = static_cast<std::uint32_t>(rest.vertices.size());
    rest.vertices.insert(rest.vertices.end(), corners.begin(), corners.end());
    rest.triangles.push_back({base, base + 1, base + 2});
  }
  return rest;
}

// All lines stay, because a surplus line is less noticeable than a missing one during the short time that this is
// shown.
ViewContent shownWithout(const ShownResult& shown, const FaceSet& faces) {
  ViewContent content = shown.content;
  const std::vector<SurfaceVertex>& surface = shown.content.walkable.front()->surface;
  auto kept = std::make_shared<NavigationMeshGeometry>(*shown.content.walkable.front());
  const std::vector<std::uint32_t>& layers = shown.content.walkable.front()->surfaceLayers;
  kept->surface.clear();
  kept->sources.clear();
  kept->surfaceLayers.clear();
  for (std::size_t t = 0; t < shown.mesh->triangles.size(); ++t) {
    if (faces.contains(shown.mesh->sourceTriangles[t])) continue;
    kept->surface.insert(kept->surface.end(), surface.begin() + static_cast<std::ptrdiff_t>(3 * t),
                         surface.begin() + static_cast<std::ptrdiff_t>(3 * t + 3));
    kept->sources.push_back(shown.mesh->sourceTriangles[t]);
    if (!layers.empty()) kept->surfaceLayers.push_back(layers[t]);
  }
  content.walkable.front() = std::move(kept);
  return content;
}

// The faces inside a cell. A cell has only its part of a floor that a border cuts; the rest must stay visible until its
// own cells are done.
std::vector<std::uint32_t> facesInside(const CellBounds& cell, const std::vector<std::uint32_t>& faces,
                                       const Environment& environment) {
  std::vector<std::uint32_t> inside;
  for (const std::uint32_t face : faces) {
    if (face >= environment.triangles.size()) continue;  // a face of a later generation
    const Triangle& corners = environment.triangles[face];
    const bool whole = std::ranges::all_of(corners, [&](std::uint32_t corner) {
      const Vec3& p = environment.vertices[corner];
      return p.x >= cell.lower[0] && p.x <= cell.upper[0] && p.y >= cell.lower[1] && p.y <= cell.upper[1];
    });
    if (whole) inside.push_back(face);
  }
  return inside;
}

}  // namespace

std::vector<std::shared_ptr<const NavigationMeshGeometry>> changedTriangles(const NavigationMesh& before,
                                                                            const NavigationMesh& after,
                                                                            const Paint& removed, const Vec3& centre) {
  std::vector<std::shared_ptr<const NavigationMeshGeometry>> changes;
  const NavigationMesh gone = without(before, after);
  if (!gone.triangles.empty()) changes.push_back(makeMeshGeometry(gone, centre, removed));
  const NavigationMesh come = without(after, before);
  if (!come.triangles.empty()) changes.push_back(makeMeshGeometry(come, centre, walkablePaint()));
  return changes;
}

ViewContent withPieces(const ShownResult& shown, const std::vector<RunEventBuffer::Part>& pieces,
                       const Environment& environment) {
  FaceSet faces;
  for (const RunEventBuffer::Part& piece : pieces) {
    faces.add(piece.cell ? facesInside(*piece.cell, piece.mesh->sourceTriangles, environment)
                         : piece.mesh->sourceTriangles);
  }
  ViewContent content = shownWithout(shown, faces);
  for (const RunEventBuffer::Part& piece : pieces) content.walkable.push_back(piece.geometry);
  return content;
}

}  // namespace footfall::ui
