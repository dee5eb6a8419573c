// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/formats/plan_polygons.hpp"

#include <algorithm>
#include <utility>

#include "core/base/vector.hpp"
#include "core/io/export.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {

PlanPolygons makePlanPolygons(const NavigationMesh& mesh, Poll poll) {
  PlanPolygons made;
  made.parts = numberParts(mesh, poll);
  made.layerCount = mesh.layers.empty() ? 1 : std::max(1U, mesh.layerCount);
  std::vector<std::vector<std::uint32_t>> layers(made.layerCount);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    layers.at(mesh.layers.empty() ? 0 : mesh.layers[t]).push_back(static_cast<std::uint32_t>(t));
  for (std::uint32_t layer = 0; layer < made.layerCount; ++layer) {
    PlanOutline outline = outlineInPlan(mesh, layers[layer], EdgeRule::SamePlace, poll, made.parts.ofTriangle);
    made.barriers.insert(made.barriers.end(), outline.barriers.begin(), outline.barriers.end());
    for (PlanPart& part : outline.parts) {
      double area = 0;
      for (const std::uint32_t t : part.triangles) {
        const Triangle& corners = mesh.triangles[t];
        area += areaOf(mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]);
      }
      const std::uint32_t number = made.parts.ofTriangle[part.triangles.front()];
      made.polygons.push_back({layer, number, std::move(part), area});
    }
  }
  return made;
}

void checkPolygonOptions(const NavigationMesh& mesh, const PlanPolygons& polygons, const ExportOptions& options) {
  checkScale(options, mesh);
  const std::size_t count = polygons.parts.areas.size();
  if (options.part && *options.part >= count)
    throw InputError(FOOTFALL_TEXT("there is no connected part %1, the last is %2; choose another one"),
                     std::size_t{*options.part} + 1, count);
}

}  // namespace footfall::detail
