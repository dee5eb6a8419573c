// Divides the triangles of a result over the pages of its plan.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/report/floor_plan.hpp"

namespace footfall::detail {

/// An edge over which one gets to another page.
struct PlanPassage {
  std::array<std::uint32_t, 2> edge{};  ///< vertices
  std::size_t page = 0;                 ///< the other one
};

struct PlanPage {
  std::string name;                      ///< "layer 0", "storey 1"
  std::vector<std::uint32_t> triangles;  ///< ascending
  std::vector<PlanPassage> passages;
};

/// Pages in the order of their layers, or storeys from below; none is empty.
std::vector<PlanPage> makePlanPages(const NavigationMesh& mesh, PlanPages pages, double agentHeight, double agentStep,
                                    Poll poll = {});

}  // namespace footfall::detail
