// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/geometry/obstacle_geometry.hpp"

#include <algorithm>
#include <cstdint>

#include "footfall/errors.hpp"

namespace footfall::ui {

std::shared_ptr<const EnvironmentGeometry> withObstacles(const std::shared_ptr<const EnvironmentGeometry>& base,
                                                         const Environment& level, std::size_t first) {
  if (level.triangles.size() <= first) return base;
  Environment obstacles;
  obstacles.bothSides = level.bothSides;
  for (std::size_t t = first; t < level.triangles.size(); ++t) {
    const auto corner = static_cast<std::uint32_t>(obstacles.vertices.size());
    for (const std::uint32_t v : level.triangles[t]) obstacles.vertices.push_back(level.vertices[v]);
    obstacles.triangles.push_back({corner, corner + 1, corner + 2});
  }
  const auto added = makeEnvironmentGeometry(obstacles, base->centre, false);
  auto geometry = std::make_shared<EnvironmentGeometry>();
  geometry->centre = base->centre;
  const Vec3 &a = base->lower, &b = added->lower, &c = base->upper, &d = added->upper;
  geometry->lower = {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
  geometry->upper = {std::max(c.x, d.x), std::max(c.y, d.y), std::max(c.z, d.z)};
  const auto join = [&](const auto member) {
    const auto &known = (*base).*member, &more = (*added).*member;
    auto& all = (*geometry).*member;
    all.reserve(known.size() + more.size());
    all.insert(all.end(), known.begin(), known.end());
    all.insert(all.end(), more.begin(), more.end());
  };
  join(&EnvironmentGeometry::surface);
  join(&EnvironmentGeometry::extremes);
  join(&EnvironmentGeometry::detailExtremes);
  join(&EnvironmentGeometry::creases);
  geometry->creaseTriangles = base->creaseTriangles;
  for (const auto& [a, b] : added->creaseTriangles) {
    const auto shifted = [first](std::uint32_t t) { return t == kNoLayer ? t : t + static_cast<std::uint32_t>(first); };
    geometry->creaseTriangles.push_back({shifted(a), shifted(b)});
  }
  geometry->floors = base->floors;  // an obstacle is no storey
  geometry->bothSides = base->bothSides;
  geometry->covered = base->covered;
  return geometry;
}

ObstacleShape shapeOf(const PlacedObstacle& obstacle) {
  TriangleSoup soup;
  try {
    soup = soupOf(obstacle);
  } catch (const InputError&) {
    return {};
  }
  ObstacleShape shape;
  for (const Triangle& t : soup.triangles)
    shape.triangles.push_back({soup.vertices[t[0]], soup.vertices[t[1]], soup.vertices[t[2]]});
  const auto edge = [&](std::size_t from, std::size_t to) {
    shape.edges.push_back({soup.vertices[from], soup.vertices[to]});
  };
  if (obstacle.shape == PlacedObstacle::Shape::Ramp) {
    for (std::size_t i = 0; i < 4; ++i) edge(i, (i + 1) % 4);
    for (const auto& [from, to] :
         {std::array{0, 4}, std::array{3, 5}, std::array{4, 5}, std::array{1, 4}, std::array{2, 5}})
      edge(static_cast<std::size_t>(from), static_cast<std::size_t>(to));
    return shape;
  }
  const std::size_t sides = soup.vertices.size() / 2;
  const std::size_t uprights = obstacle.shape == PlacedObstacle::Shape::Box ? 1 : sides / 4;
  for (std::size_t i = 0; i < sides; ++i) {
    edge(i, (i + 1) % sides);
    edge(sides + i, sides + (i + 1) % sides);
    if (i % uprights == 0) edge(i, sides + i);
  }
  return shape;
}

}  // namespace footfall::ui
