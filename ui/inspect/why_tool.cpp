// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/why_tool.hpp"

#include <array>
#include <utility>
#include <vector>

#include "ui/inspect/why_text.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {

bool WhyTool::keyPressed(const QKeyEvent& event) {
  if (event.key() != Qt::Key_Return && event.key() != Qt::Key_Enter) return false;
  asked_(mouse_);
  return true;
}

QString WhyTool::hint() const { return tr("Why? Click a place (or press Return over it); Esc ends."); }

std::array<Vec3, 3> cornersOf(const Environment& environment, std::uint32_t triangle) {
  const Triangle& t = environment.triangles[triangle];
  return {environment.vertices[t[0]], environment.vertices[t[1]], environment.vertices[t[2]]};
}

std::vector<std::uint32_t> obstaclesOf(const PlaceExplanation& told) {
  std::vector<std::uint32_t> obstacles = told.walls;
  if (told.obstacle)
    obstacles.push_back(told.obstacle->triangle);
  else if (told.above)
    obstacles.push_back(told.above->triangle);
  return obstacles;
}

ViewOverlay whyOverlay(const Inspector& inspector, const PlaceExplanation& told, const LevelUnits& units) {
  const Environment& environment = inspector.environment();
  ViewOverlay overlay;
  const auto highlight = [&](const std::vector<std::uint32_t>& triangles, const QColor& colour, int alpha) {
    ViewOverlay::Surface surface;
    surface.colour = colour;
    surface.colour.setAlpha(alpha);
    ViewOverlay::Lines outline{{}, colour, 2.5F, outlineColour()};
    for (const std::uint32_t t : triangles) {
      const auto corners = cornersOf(environment, t);
      surface.triangles.push_back(corners);
      for (std::size_t k = 0; k < 3; ++k) outline.segments.push_back({corners[k], corners[(k + 1) % 3]});
    }
    overlay.surfaces.push_back(std::move(surface));
    overlay.lines.push_back(std::move(outline));
  };
  highlight({told.place.triangle}, selectedCellColour(), 70);
  // An obstacle far above a walkable place is described, but does not block anybody.
  const bool inTheWay = told.verdict == PlaceVerdict::TooLow || !told.walls.empty();
  if (inTheWay) highlight(obstaclesOf(told), obstacleEdgeColour(), 110);
  const Vec3& place = told.place.point;
  const auto& above = told.obstacle ? told.obstacle : told.above;
  if (above) {
    const Vec3 top{place.x, place.y, place.z + above->height};
    overlay.lines.push_back(
        {{{place, top}}, inTheWay ? obstacleEdgeColour() : hoveredCellColour(), 2.5F, outlineColour()});
    const Vec3 middle{place.x, place.y, place.z + above->height / 2};
    overlay.labels.push_back({middle, units.length(above->height)});
  }
  overlay.marks.push_back({place, selectedCellColour(), 11});
  overlay.throughWalls = true;
  return overlay;
}

}  // namespace footfall::ui
