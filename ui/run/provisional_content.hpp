// What the view shows while a run is under way: the last result, changed where the run has already said something.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ui/run/run_event_buffer.hpp"
#include "ui/view/render_geometry.hpp"

namespace footfall::ui {

/// A finished result and how the view shows it: content.walkable holds the mesh alone.
struct ShownResult {
  std::shared_ptr<const NavigationMesh> mesh;
  ViewContent content;
};

/// What to draw over the last result (ViewContent::changes) when one of its filters leaves `after` where it left
/// `before`: triangles that are in `before` only, in the filter's paint, and over them those that are in `after` only.
/// Triangles are the same when their corners are, so filters that only take away or leave cost what they change.
std::vector<std::shared_ptr<const NavigationMeshGeometry>> changedTriangles(const NavigationMesh& before,
                                                                            const NavigationMesh& after,
                                                                            const Paint& removed, const Vec3& centre);

/// The result with pieces, each with its geometry, in place of whatever lies on the same faces; pieces of cells in
/// place of what lies on faces inside their cell.
ViewContent withPieces(const ShownResult& shown, const std::vector<RunEventBuffer::Part>& pieces,
                       const Environment& environment);

}  // namespace footfall::ui
