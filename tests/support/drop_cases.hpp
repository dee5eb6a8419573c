// Levels with ledges, and their drops.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "footfall/navigation_mesh.hpp"
#include "tests/support/soup.hpp"

namespace footfall::test {

/// A line of a pipeline.
std::string drops(double depth, double reach = 0.3);

/// The product of the minimal pipeline and `filters`.
NavigationMesh dropped(const Soup& soup, const std::string& filters, double clearance = 2);

/// The length of all drops, in the plan.
double lengthOf(const NavigationMesh& mesh);

/// True when a way leads from one place to the other, over drops as well.
bool reaches(const NavigationMesh& mesh, const Vec3& from, const Vec3& to);

/// A platform of 2 by 2 in the middle of a floor of 8 by 8, with upright sides.
Soup platform(double height);

/// A ledge of 2 by 4 beside a lower floor that begins `gap` away.
Soup ledge(double height, double gap);

}  // namespace footfall::test
