// Walkable places and straight ways over the ground.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "handles.hpp"

using namespace footfall;
using namespace footfall::c;

namespace {

footfall_place placeOf(const SurfacePlace& place) {
  return {{place.position.x, place.position.y, place.position.z}, place.triangle, place.distance};
}

footfall_place placeOf(const std::optional<SurfacePlace>& place) {
  return place ? placeOf(*place) : footfall_place{{0, 0, 0}, FOOTFALL_NONE, 0};
}

footfall_ray rayOf(const GroundRay& ray) {
  footfall_ray result{
      placeOf(ray.start), placeOf(ray.end), ray.reached ? 1 : 0, ray.planLength, {FOOTFALL_NONE, FOOTFALL_NONE}};
  if (ray.border) std::copy(ray.border->begin(), ray.border->end(), result.border);
  return result;
}

}  // namespace

footfall_status footfall_place_at(const footfall_path_finder* finder, const double point[3], footfall_place* place) {
  return guarded(__func__, [&] {
    given(finder, "finder");
    given(place, "place");
    *place = placeOf(finder->finder.locate(placeFrom(point, "point"), placeReach(finder->pipeline)));
  });
}

footfall_status footfall_nearest_place(const footfall_path_finder* finder, const double point[3],
                                       footfall_place* place) {
  return guarded(__func__, [&] {
    given(finder, "finder");
    given(place, "place");
    *place = placeOf(nearestPlace(finder->finder, placeFrom(point, "point")));
  });
}

footfall_status footfall_random_places(const footfall_path_finder* finder, size_t count, uint64_t seed,
                                       footfall_place* places) {
  return guarded(__func__, [&] {
    given(finder, "finder");
    given(places, "places");
    const std::vector<SurfacePlace> found = randomPlaces(finder->finder, count, seed);
    for (std::size_t i = 0; i < found.size(); ++i) places[i] = placeOf(found[i]);
  });
}

footfall_status footfall_cast_ray(const footfall_path_finder* finder, const double from[3], const double to[3],
                                  footfall_context* context, footfall_ray* ray) {
  return guarded(__func__, [&] {
    given(finder, "finder");
    given(ray, "ray");
    const auto found = castRay(finder->finder, placeFrom(from, "from"), placeFrom(to, "to"),
                               placeReach(finder->pipeline), contextOf(context));
    const footfall_place none = placeOf(std::nullopt);
    *ray = found ? rayOf(*found) : footfall_ray{none, none, 0, 0, {FOOTFALL_NONE, FOOTFALL_NONE}};
  });
}

footfall_status footfall_cast_ray_from(const footfall_path_finder* finder, const footfall_place* start,
                                       const double to[3], footfall_context* context, footfall_ray* ray) {
  return guarded(__func__, [&] {
    given(finder, "finder");
    given(start, "start");
    given(ray, "ray");
    const SurfacePlace place{placeFrom(start->position, "start"), start->triangle, start->distance};
    *ray = rayOf(castRayFrom(finder->finder, place, placeFrom(to, "to"), contextOf(context)));
  });
}
