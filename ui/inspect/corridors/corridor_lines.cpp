// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/corridors/corridor_lines.hpp"

#include <algorithm>
#include <cmath>

namespace footfall::ui {
namespace {

constexpr std::size_t kPieces = 6;  // of an edge whose width or direction changes along it, unless there are many

Vec3 placeBetween(const Vec3& a, const Vec3& b, double part) {
  return {std::lerp(a.x, b.x, part), std::lerp(a.y, b.y, part), std::lerp(a.z, b.z, part)};
}

double planDistance(const Vec3& a, const Vec3& b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// The place of a parabola that is nearest to `foot`, a place of its straight border; `ends` are those of the border.
Vec3 onParabola(const Vec3& corner, const std::array<Vec3, 2>& ends, const Vec3& foot, double z) {
  const double dx = ends[1].x - ends[0].x, dy = ends[1].y - ends[0].y, length = std::hypot(dx, dy);
  const double vx = corner.x - foot.x, vy = corner.y - foot.y;
  const double nx = -dy / length, ny = dx / length;
  const double across = vx * nx + vy * ny;
  if (!(length > 0) || across == 0) return {foot.x, foot.y, z};
  const double away = (vx * vx + vy * vy) / (2 * across);
  return {foot.x + away * nx, foot.y + away * ny, z};
}

/// The places that divide an edge into pieces, with the width at each.
void addPlaces(const CorridorMap& map, const CorridorEdge& edge, std::size_t pieces, std::vector<CorridorLine>& lines) {
  const CorridorVertex &from = map.vertices[edge.from], &to = map.vertices[edge.to];
  const bool isParabola = edge.shape == CorridorShape::Parabola;
  const bool isCornerLeft = edge.left[0] == edge.left[1];
  Vec3 before = from.place;
  double widthBefore = from.width;
  for (std::size_t i = 1; i <= pieces; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(pieces);
    Vec3 place = to.place;
    double width = to.width;
    if (i < pieces) {
      const Vec3 left = placeBetween(edge.left[0], edge.left[1], part);
      const Vec3 right = placeBetween(edge.right[0], edge.right[1], part);
      place = placeBetween(from.place, to.place, part);
      if (isParabola)
        place =
            isCornerLeft ? onParabola(left, edge.right, right, place.z) : onParabola(right, edge.left, left, place.z);
      width = 2 * std::min(planDistance(place, left), planDistance(place, right));
    }
    lines.push_back({{before, place}, std::min(widthBefore, width)});
    before = place;
    widthBefore = width;
  }
}

bool isEven(const CorridorMap& map, const CorridorEdge& edge) {
  const double a = map.vertices[edge.from].width, b = map.vertices[edge.to].width;
  return edge.shape == CorridorShape::Straight && std::abs(a - b) <= 1e-3 * std::max(a, b) &&
         edge.width >= (1 - 1e-3) * std::min(a, b);
}

}  // namespace

CorridorLines makeCorridorLines(const CorridorMap& map, double least, std::size_t most) {
  std::vector<std::size_t> drawn;
  for (std::size_t e = 0; e < map.edges.size(); ++e) {
    const CorridorEdge& edge = map.edges[e];
    if (std::max(map.vertices[edge.from].width, map.vertices[edge.to].width) > least) drawn.push_back(e);
  }
  std::ranges::stable_sort(drawn, {}, [&](std::size_t e) { return map.edges[e].width; });
  CorridorLines result;
  const std::size_t whole = std::min(drawn.size(), most);
  result.leftOut = drawn.size() - whole;
  drawn.resize(whole);
  const std::size_t pieces = whole == 0 ? 1 : std::clamp<std::size_t>(most / whole, 1, kPieces);
  for (const std::size_t e : drawn) addPlaces(map, map.edges[e], isEven(map, map.edges[e]) ? 1 : pieces, result.lines);
  std::ranges::stable_sort(result.lines, {}, &CorridorLine::width);
  return result;
}

}  // namespace footfall::ui
