// A city of any size: streets, blocks of houses of one to five storeys with stairs and furniture, footbridges over
// streets, an underpass below every fourth row of blocks with stairs down to it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <iosfwd>

#include "mesh.hpp"

namespace footfall::samples {

struct CitySize {
  std::uint64_t tiles = 0, triangles = 0, vertices = 0;
};

/// One block with the streets south and west of it, in the frame of the city: tile (0, 0) begins at the origin. The
/// same for the same numbers.
Mesh makeCityTile(int column, int row);

/// Writes whole tiles as OBJ, square shell by square shell, until there are at least so many triangles: a smaller city
/// is the beginning of a larger one. Holds one tile at a time. Numbers of vertices of more than 2^31 - 1 are not read
/// by many programs.
CitySize writeCity(std::ostream& out, std::uint64_t triangles);

}  // namespace footfall::samples
