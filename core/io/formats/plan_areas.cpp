// SPDX-License-Identifier: GPL-3.0-or-later
#include "footfall/plan_areas.hpp"

#include "core/base/poll.hpp"
#include "core/io/formats/plan_polygons.hpp"

namespace footfall {
using namespace detail;

std::vector<PlanArea> planAreas(const NavigationMesh& mesh, std::optional<std::uint32_t> part,
                                const RunContext* context) {
  const Poll poll(context);
  const PlanPolygons polygons = makePlanPolygons(mesh, poll);
  ExportOptions options;
  options.part = part;
  checkPolygonOptions(mesh, polygons, options);
  const auto placesOf = [&mesh](const PlanRing& ring) {
    std::vector<Vec3> places;
    for (const std::uint32_t vertex : ring) places.push_back(mesh.vertices[vertex]);
    return places;
  };
  std::vector<PlanArea> areas;
  for (const PlanPolygon& polygon : polygons.polygons) {
    if (part && polygon.part != *part) continue;
    PlanArea area{polygon.layer, polygon.part, placesOf(polygon.outline.outer), {}, polygon.area};
    for (const PlanRing& hole : polygon.outline.holes) area.holes.push_back(placesOf(hole));
    areas.push_back(std::move(area));
  }
  return areas;
}

}  // namespace footfall
