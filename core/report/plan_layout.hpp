// The place of a plan on its paper, and its scale.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/report/floor_plan.hpp"
#include "core/report/plan_walls.hpp"

namespace footfall::detail {

/// A rectangle of the plan, in the environment's units.
struct PlanWindow {
  PlanPlace lower{}, upper{};
};

struct PlanLayout {
  double width = 0, height = 0;  ///< size of the paper, millimetres
  SheetRectangle window;         ///< area for the drawing
  double scale = 100;            ///< 1:100
  double unit = 1;               ///< millimetres on the paper for one unit of the environment
  PlanPlace middle{};            ///< place in the middle of the window

  [[nodiscard]] SheetPoint at(double x, double y) const {
    return {(window.lower.x + window.upper.x) / 2 + (x - middle[0]) * unit,
            (window.lower.y + window.upper.y) / 2 + (y - middle[1]) * unit};
  }
  [[nodiscard]] SheetPoint at(const PlanPlace& p) const { return at(p[0], p[1]); }
};

/// Lays a plan out by its PlanOptions. Throws InputError when the scale does not fit the paper.
PlanLayout layOutPlan(const PlanWindow& box, double metresPerUnit, const PlanOptions& options);

/// "1:100"
std::string scaleText(double scale);

}  // namespace footfall::detail
