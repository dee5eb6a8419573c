// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/changed_level.hpp"

#include <cmath>
#include <numbers>

#include "core/environment/coordinate_grid.hpp"

namespace footfall::test {
using namespace detail;

std::shared_ptr<const Environment> changedLevel(const Environment& level, const LevelChange& change, GridChoice grid) {
  auto result = std::make_shared<Environment>(level);
  const double radians = change.degrees * std::numbers::pi / 180, c = std::cos(radians), s = std::sin(radians);
  GridExtent extent;
  for (Vec3& p : result->vertices) {
    p = {change.scale * (c * p.x - s * p.y) + change.offset, change.scale * (s * p.x + c * p.y) + change.offset,
         change.scale * p.z};
    extent.includeVertex(p);
  }
  for (const Triangle& triangle : result->triangles)
    for (const std::uint32_t corner : triangle) extent.include(result->vertices[corner]);
  result->metresPerUnit = level.metresPerUnit / change.scale;
  result->grid = {};
  ImportOptions options;
  options.grid = grid;
  putOnGrid(*result, chosenGridStep(options, true, extent, result->metresPerUnit), {});
  return result;
}

}  // namespace footfall::test
