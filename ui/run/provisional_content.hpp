// The content of the view during a run: the last result with the changes that the run has already computed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ui/run/run_event_buffer.hpp"
#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

/// A finished result and its content in the view: content.walkable holds the mesh alone.
struct ShownResult {
  std::shared_ptr<const NavigationMesh> mesh;
  ViewContent content;
};

/// The surfaces to draw over the last result (ViewContent::changes) when one of its filters gives `after` instead of
/// `before`: triangles that only `before` has, in the filter's paint, and over them those that only `after` has.
/// Triangles are equal when their corners are, so the cost of filters that only remove triangles is that of their
/// changes.
std::vector<std::shared_ptr<const NavigationMeshGeometry>> changedTriangles(const NavigationMesh& before,
                                                                            const NavigationMesh& after,
                                                                            const Paint& removed, const Vec3& centre);

/// The result in which pieces, each with its geometry, replace everything on the same faces; pieces of cells replace
/// everything on faces inside their cell.
ViewContent withPieces(const ShownResult& shown, const std::vector<RunEventBuffer::Part>& pieces,
                       const Environment& environment);

}  // namespace footfall::ui
