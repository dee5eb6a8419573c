// The difference of two surfaces as sets of points in space, exactly.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/compare/comparison_cover.hpp"
#include "core/compare/comparison_surface.hpp"
#include "footfall/compare.hpp"

namespace footfall::detail::comparison {

/// A plane in which one set has area that the other has not.
struct DifferentPlane {
  /// a x + b y + c z = d, in units of the grid; `axis` is the one that it is seen along (0, 1, 2), with a factor that
  /// is not 0. Its pieces have the next two coordinates after `axis` as x and y.
  std::array<double, 4> numbers{};
  std::size_t axis = 2;
  /// Numbers of positions by the points of the pieces.
  std::vector<std::uint32_t> positions;
  std::vector<CoverPiece> borders;
};

/// The parts in one set only, as planes with borders, and as triangles that are alone in their plane.
struct DifferenceBorders {
  std::vector<DifferentPlane> planes;
  std::array<std::vector<std::uint32_t>, 2> triangles;  ///< triangles of the surfaces, rising
};

/// Surfaces have common area only where triangles lie in exactly one plane, so each plane is looked at by itself.
/// `borders` (may be null) receives where the differences are.
SetDifference subtractSets(const ComparedSurfaces& surfaces, RunContext& context, DifferenceBorders* borders = nullptr);

}  // namespace footfall::detail::comparison
