// The sample environments. Each is the same mesh on every machine.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "mesh.hpp"

namespace footfall::samples {

Mesh makeHouse();
Mesh makeVilla();
Mesh makeDocks();
Mesh makeArena();
Mesh makeTower();
Mesh makeRooms();

struct Sample {
  std::string_view name;
  std::string_view description;  ///< one line, the first comment of its file
  Mesh (*make)();
};

inline constexpr std::array<Sample, 6> kSamples{{
    {"house", "House: garden, ramps, overhangs and groups that do not touch each other.", makeHouse},
    {"villa", "Villa: coarse terrain with mesh errors, three storeys with furniture, trees, fences.", makeVilla},
    {"docks", "Docks: water and quay as giant triangles, ships, warehouses and very many obstacles.", makeDocks},
    {"arena", "Arena: oval stands, a ring road on pillars, many ramps, obstacles crowded in one place.", makeArena},
    {"tower", "Tower: 26 stacked boxes, so that everything lies above everything.", makeTower},
    {"rooms", "Rooms: the user guide's level: a doorway that is too low, a crate, a gallery.", makeRooms},
}};

}  // namespace footfall::samples
