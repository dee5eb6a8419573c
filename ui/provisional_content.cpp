// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/provisional_content.hpp"

namespace footfall {
namespace {

/// Faces of the environment, by index.
class FaceSet {
 public:
  explicit FaceSet(const std::vector<std::uint32_t>& faces) {
    for (const std::uint32_t face : faces) {
      if (face >= has_.size()) has_.resize(face + 1);
      repeats_ = repeats_ || has_[face];
      has_[face] = true;
    }
  }
  [[nodiscard]] bool contains(std::uint32_t face) const { return face < has_.size() && has_[face]; }
  [[nodiscard]] bool repeats() const { return repeats_; }

 private:
  std::vector<bool> has_;
  bool repeats_ = false;
};

// The triangles of a mesh on faces that are not in `faces`.
NavigationMesh without(const NavigationMesh& mesh, const FaceSet& faces) {
  NavigationMesh rest;
  rest.vertices = mesh.vertices;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!faces.contains(mesh.sourceTriangles[t])) rest.triangles.push_back(mesh.triangles[t]);
  }
  return rest;
}

// The lines stay all: for the moment that this is shown, one too many is less noticed than none.
ViewContent shownWithout(const ShownResult& shown, const FaceSet& faces) {
  ViewContent content = shown.content;
  const std::vector<SurfaceVertex>& surface = shown.content.walkable.front()->surface;
  auto kept = std::make_shared<MeshGeometry>(*shown.content.walkable.front());
  kept->surface.clear();
  for (std::size_t t = 0; t < shown.mesh->triangles.size(); ++t) {
    if (faces.contains(shown.mesh->sourceTriangles[t])) continue;
    kept->surface.insert(kept->surface.end(), surface.begin() + static_cast<std::ptrdiff_t>(3 * t),
                         surface.begin() + static_cast<std::ptrdiff_t>(3 * t + 3));
  }
  content.walkable.front() = std::move(kept);
  return content;
}

}  // namespace

bool holdsWholeFaces(const NavigationMesh& mesh) { return !FaceSet(mesh.sourceTriangles).repeats(); }

std::optional<ViewContent> withChangedFaces(const ShownResult& shown, const NavigationMesh& before,
                                            const NavigationMesh& after, const RemovalStyle* style,
                                            const Vec3& centre) {
  const FaceSet old(before.sourceTriangles);
  const FaceSet now(after.sourceTriangles);
  const NavigationMesh gone = without(before, now);
  const NavigationMesh added = without(after, old);
  if (gone.triangles.empty() && added.triangles.empty()) return std::nullopt;
  std::vector<std::uint32_t> goneFaces;
  for (const std::uint32_t face : before.sourceTriangles) {
    if (!now.contains(face)) goneFaces.push_back(face);
  }
  ViewContent content = shownWithout(shown, FaceSet(goneFaces));
  if (style) content.removed.push_back({style, makeMeshGeometry(gone, centre, style->paint)});
  content.walkable.push_back(makeMeshGeometry(added, centre));
  return content;
}

ViewContent withPieces(const ShownResult& shown, const std::vector<std::shared_ptr<const MeshGeometry>>& pieces,
                       const std::vector<std::uint32_t>& faces) {
  ViewContent content = shownWithout(shown, FaceSet(faces));
  content.walkable.insert(content.walkable.end(), pieces.begin(), pieces.end());
  return content;
}

}  // namespace footfall
