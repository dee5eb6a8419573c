// What the view shows while a run is under way: the last result, changed where the run has already said something.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ui/render_geometry.hpp"

namespace footfall {

/// A finished result and how the view shows it: content.walkable holds the mesh alone.
struct ShownResult {
  std::shared_ptr<const NavigationMesh> mesh;
  ViewContent content;
};

/// No two triangles lie on the same face of the environment, as before anything is cut out of floors.
bool holdsWholeFaces(const NavigationMesh& mesh);

/// A filter has taken away or brought back whole faces (SlopeFilter does): the result without what lies on faces that
/// are in `before` only, drawn in the filter's style where it has one, and with the faces that are in `after` only.
/// Empty when nothing changes.
std::optional<ViewContent> withChangedFaces(const ShownResult& shown, const NavigationMesh& before,
                                            const NavigationMesh& after, const RemovalStyle* style, const Vec3& centre);

/// The result with pieces in place of whatever lies on the same faces. `faces` are the pieces' source triangles.
ViewContent withPieces(const ShownResult& shown, const std::vector<std::shared_ptr<const MeshGeometry>>& pieces,
                       const std::vector<std::uint32_t>& faces);

}  // namespace footfall
