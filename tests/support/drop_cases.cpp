// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/drop_cases.hpp"

#include <memory>

#include "core/base/number_text.hpp"
#include "footfall/path.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/support/run_filters.hpp"

namespace footfall::test {

std::string drops(double depth, double reach) {
  std::string text = "DropFilter ";
  detail::appendNumber(text, depth);
  text += ' ';
  detail::appendNumber(text, reach);
  return text + '\n';
}

NavigationMesh dropped(const Soup& soup, const std::string& filters, double clearance) {
  return navigationMesh(runFilters(soup.environment(), minimalPipeline(clearance) + "\n" + filters));
}

double lengthOf(const NavigationMesh& mesh) {
  double sum = 0;
  for (const DropLink& drop : mesh.drops) sum += drop.width;
  return sum;
}

bool reaches(const NavigationMesh& mesh, const Vec3& from, const Vec3& to) {
  return PathFinder(std::make_shared<const NavigationMesh>(mesh)).find(from, to).reached();
}

Soup platform(double height) { return Soup().floor(0, 0, 8, 8, 0).box({3, 3, 0}, {5, 5, height}); }

Soup ledge(double height, double gap) { return Soup().floor(-2, 0, 0, 4, height).floor(gap, 0, 4, 4, 0); }

}  // namespace footfall::test
