// A comparison as a table and as JSON (docs/how-to/compare.md explains both).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "footfall/compare.hpp"
#include "footfall/io.hpp"

namespace footfall::detail {

struct ComparisonTimes {
  double loadMs = 0;
  double compareMs = 0;
};

/// A comparison as a table for people.
std::string formatComparison(const std::array<NavigationMeshFile, 2>& files, const MeshComparison& comparison,
                             const ComparisonTimes& times);

/// One JSON object; keys are stable.
std::string formatComparisonJson(const std::array<NavigationMeshFile, 2>& files, const MeshComparison& comparison,
                                 const ComparisonTimes& times);

/// Half a sentence about two meshes that are not equal: by how much they differ when heights may differ by a rounding.
/// All numbers are bounds from above.
std::string howDifferent(const MeshComparison& comparison);

}  // namespace footfall::detail
