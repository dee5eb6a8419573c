// Environments from files and arrays, and levels whose obstacles are moved about.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "handles.hpp"

namespace footfall::c {

TriangleSoup soupOf(footfall_points vertices, footfall_triangles triangles) {
  if (vertices.count > 0) given(vertices.data, "the array of vertices");
  if (triangles.count > 0) given(triangles.data, "the array of triangles");
  TriangleSoup soup;
  soup.vertices.reserve(vertices.count);
  for (std::size_t i = 0; i < vertices.count; ++i) {
    const double* p = vertices.data + 3 * i;
    soup.vertices.push_back({p[0], p[1], p[2]});
  }
  soup.triangles.reserve(triangles.count);
  for (std::size_t i = 0; i < triangles.count; ++i) {
    const std::uint32_t* t = triangles.data + 3 * i;
    soup.triangles.push_back({t[0], t[1], t[2]});
  }
  return soup;
}

std::optional<UpAxis> upAxisOf(footfall_up_axis up) {
  switch (up) {
    case FOOTFALL_UP_GUESSED:
      return std::nullopt;
    case FOOTFALL_UP_X:
      return UpAxis::X;
    case FOOTFALL_UP_Y:
      return UpAxis::Y;
    case FOOTFALL_UP_Z:
      return UpAxis::Z;
    case FOOTFALL_UP_NEGATIVE_X:
      return UpAxis::NegativeX;
    case FOOTFALL_UP_NEGATIVE_Y:
      return UpAxis::NegativeY;
    case FOOTFALL_UP_NEGATIVE_Z:
      return UpAxis::NegativeZ;
  }
  throw InputError(Pattern{"there is no up axis %1"}, static_cast<int>(up));
}

GridChoice gridChoiceOf(footfall_grid grid) {
  switch (grid) {
    case FOOTFALL_GRID_AUTO:
      return GridChoice::Auto;
    case FOOTFALL_GRID_ON:
      return GridChoice::On;
    case FOOTFALL_GRID_OFF:
      return GridChoice::Off;
    case FOOTFALL_GRID_STEP:
      return GridChoice::Step;
  }
  throw InputError(Pattern{"there is no grid %1"}, static_cast<int>(grid));
}

}  // namespace footfall::c

using namespace footfall;
using namespace footfall::c;

footfall_status footfall_load(const char* path, const footfall_import_options* options, footfall_context* context,
                              footfall_environment** environment) {
  return guarded(__func__, [&] {
    given(path, "path");
    given(environment, "environment");
    ImportOptions import;
    if (options != nullptr) {
      import.up = upAxisOf(options->up);
      if (options->metres_per_unit != 0) import.metresPerUnit = options->metres_per_unit;
      import.bothSides = options->both_sides != 0;
      import.grid = gridChoiceOf(options->grid);
      import.gridStep = options->grid_step;
      import.limitReaders = options->no_limits == 0;
    }
    *environment =
        new footfall_environment{std::make_shared<const Environment>(load(path, import, contextOf(context)))};
  });
}

footfall_status footfall_make_environment(footfall_points vertices, footfall_triangles triangles,
                                          double metres_per_unit, footfall_environment** environment) {
  return guarded(__func__, [&] {
    given(environment, "environment");
    TriangleSoup soup = soupOf(vertices, triangles);
    auto made = std::make_shared<Environment>();
    made->vertices = std::move(soup.vertices);
    made->triangles = std::move(soup.triangles);
    made->metresPerUnit = metres_per_unit;
    made->upGuessed = made->scaleGuessed = false;
    checkEnvironment(*made);
    *environment = new footfall_environment{std::move(made)};
  });
}

footfall_points footfall_environment_vertices(const footfall_environment* environment) {
  return environment == nullptr ? footfall_points{} : spanOf(environment->environment->vertices);
}

footfall_triangles footfall_environment_triangles(const footfall_environment* environment) {
  return environment == nullptr ? footfall_triangles{} : spanOf(environment->environment->triangles);
}

double footfall_environment_metres_per_unit(const footfall_environment* environment) {
  return environment == nullptr ? 0 : environment->environment->metresPerUnit;
}

void footfall_free_environment(footfall_environment* environment) { delete environment; }

footfall_status footfall_make_level(const footfall_environment* environment, footfall_level** level) {
  return guarded(__func__, [&] {
    given(environment, "environment");
    given(level, "level");
    *level = new footfall_level{EditableEnvironment(environment->environment)};
  });
}

footfall_status footfall_add_obstacle(footfall_level* level, footfall_points vertices, footfall_triangles triangles,
                                      uint32_t* obstacle) {
  return guarded(__func__, [&] {
    given(level, "level");
    given(obstacle, "obstacle");
    *obstacle = level->level.add(soupOf(vertices, triangles));
  });
}

footfall_status footfall_replace_obstacle(footfall_level* level, uint32_t obstacle, footfall_points vertices,
                                          footfall_triangles triangles) {
  return guarded(__func__, [&] { given(level, "level").level.replace(obstacle, soupOf(vertices, triangles)); });
}

footfall_status footfall_remove_obstacle(footfall_level* level, uint32_t obstacle) {
  return guarded(__func__, [&] { given(level, "level").level.remove(obstacle); });
}

footfall_status footfall_level_environment(const footfall_level* level, footfall_environment** environment) {
  return guarded(__func__, [&] {
    given(level, "level");
    given(environment, "environment");
    *environment = new footfall_environment{level->level.environment()};
  });
}

void footfall_free_level(footfall_level* level) { delete level; }
