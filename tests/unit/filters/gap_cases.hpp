// Slits between floors, and what the suites of gaps read off a mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/mesh/gap_bridges.hpp"
#include "core/mesh/surface_topology.hpp"
#include "footfall/inspect.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"

namespace footfall::test {

inline std::string numbers(double step, double gap) {
  return QString("%1 %2").arg(step, 0, 'g', 17).arg(gap, 0, 'g', 17).toStdString();
}
inline std::string gaps(double height, double step, double gap) {
  return minimalPipeline(height) + "\nStepFilter " + numbers(step, gap) + "\n";
}

inline NavigationMesh linked(const Soup& soup, double height, double step, double gap, const std::string& more = "") {
  return navigationMesh(runFilters(soup.environment(), gaps(height, step, gap) + more));
}

inline std::size_t gapCount(const NavigationMesh& mesh) {
  return static_cast<std::size_t>(std::ranges::count(mesh.links, StepKind::Gap, &StepLink::kind));
}
inline double gapLength(const NavigationMesh& mesh) {
  double length = 0;
  for (const StepLink& link : mesh.links)
    if (link.kind == StepKind::Gap)
      length += std::hypot(mesh.vertices[link.from[0]].x - mesh.vertices[link.from[1]].x,
                           mesh.vertices[link.from[0]].y - mesh.vertices[link.from[1]].y);
  return length;
}
inline std::uint32_t pathParts(const NavigationMesh& mesh) {
  return makeSurfaceTopology(withBridges(mesh)).componentCount;
}
inline std::size_t parts(const NavigationMesh& mesh) { return findComponents(mesh).list.size(); }

/// Two floors of 4 by 4, the second one `width` behind the first and `rise` above it.
inline Soup slit(double width, double rise = 0) {
  return Soup().floor(0, 0, 4, 4, 0).floor(4 + width, 0, 8 + width, 4, rise);
}

}  // namespace footfall::test
