// One page of a floor plan: what is drawn in its window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/mesh/plan_outline.hpp"
#include "core/report/plan_corridors.hpp"
#include "core/report/plan_doors.hpp"
#include "core/report/plan_layout.hpp"
#include "core/report/plan_pages.hpp"
#include "core/report/plan_stairs.hpp"

namespace footfall::detail {

/// The content of a page, for the texts around it.
struct PlanContents {
  bool walls = false, doors = false, obstacleEdges = false, steps = false, gaps = false, drops = false,
       passages = false, corridors = false, bottlenecks = false;
  double area = 0;  ///< area of the drawn floors; the square of the environment's unit
};

struct PlanStyle {
  Rgb walkable, border, wall, wallLine, obstacleEdge, step, gap, drop, passage, text, door, corridor, bottleneck;
};
PlanStyle planStyle(PlanColours colours);

struct PlanSubject {
  const Environment& environment;
  const NavigationMesh& mesh;
  const NumberedParts& parts;
  const std::vector<PlanFlight>& flights;
  const std::vector<PlanPage>& pages;
  const std::vector<PlanDoor>& doors;
  const PlanCorridors* corridors;  ///< null: none are drawn
  WallCut cut;
};

/// Draws page `page` into `drawing`, from below to above: walls, walkable area, what is on it, words.
PlanContents drawPlanPage(const PlanSubject& subject, std::size_t page, const PlanLayout& layout,
                          const PlanStyle& style, std::vector<SheetShape>& drawing, Poll poll);

/// A door in plan: its opening from jamb to jamb, and the leaf as a line in the middle, because files do not say to
/// which side it swings. `corners` as in PlanDoor.
void addDoor(std::vector<SheetShape>& drawing, const std::array<SheetPoint, 4>& corners, const Rgb& colour);

/// An arrow from `from` to `to` with a head of `size` millimetres.
void addArrow(std::vector<SheetShape>& drawing, const std::vector<SheetPoint>& way, double size,
              const SheetStroke& stroke);

/// "12.3 m²"
std::string areaText(double squareMetres);

}  // namespace footfall::detail
