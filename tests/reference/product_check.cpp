// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/product_check.hpp"

#include <algorithm>
#include <cmath>

#include "tests/support/run_filters.hpp"

namespace footfall::reference {

std::string checkProduct(const Environment& environment, double slope, double clearance, Rounding rounding) {
  const StatePtr state =
      test::runFilters(std::make_shared<Environment>(environment), test::minimalPipeline(clearance, slope));
  const auto pieces = toPieces(exactWalkableTriangles(*state));
  const auto area = computeWalkableArea(environment, {slope, clearance});
  if (auto error = findDifference(environment, area, pieces); !error.empty()) return error;
  const NavigationMesh mesh = test::navigationMesh(state);
  if (const auto error = test::findMeshError(mesh); !error.empty()) return "rounded: " + error;
  // Rounding moves a vertex by half a unit in the last place, its repairs by a few.
  double largest = 0;
  for (const Vec3& v : environment.vertices)
    largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  const double bound = 64 * 0x1p-52 * largest * largest * static_cast<double>(1 + pieces.size());
  const auto differ = [](const std::string& what, double got, double expected) {
    return "rounded: " + what + " " + std::to_string(got) + " instead of " + std::to_string(expected);
  };
  const double planArea = twiceArea(area).get_d() / 2;
  if (!(std::fabs(test::planArea(mesh) - planArea) <= bound))
    return differ("plan area", test::planArea(mesh), planArea);
  if (rounding == Rounding::MayClose) return {};
  const auto meetings = findMeetings(area);
  const auto parts = static_cast<double>(countParts(connectedParts(area, meetings)));
  const auto partsFound = static_cast<double>(test::countParts(mesh));
  if (partsFound != parts) return differ("parts", partsFound, parts);
  const double length = test::obstacleLength(mesh), expected = blockedLength(meetings);
  if (!(std::fabs(length - expected) <= 1e-9 * (1 + largest))) return differ("obstacle edges", length, expected);
  return {};
}

}  // namespace footfall::reference
