// Scenes with coordinates as files by others have them: floats that matrices of floats placed, at any angle.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string_view>

namespace footfall::samples {

struct SceneSize {
  std::uint64_t triangles = 0, vertices = 0;
};

/// Writes at least so many triangles as OBJ, whole objects. The same bytes for the same numbers on every machine:
/// nothing is computed but sums and products of floats. `random` is a seed.
using SceneWriter = SceneSize (*)(std::ostream& out, std::uint64_t triangles, std::uint64_t random);

struct SceneKind {
  std::string_view name;
  std::string_view description;
  SceneWriter write;
};

/// Blocks of the city, the whole turned by one angle and each block by a little more.
SceneSize writeTown(std::ostream& out, std::uint64_t triangles, std::uint64_t random);
/// Desks at all angles with screens, cups and keyboards, chairs, and shelves with books.
SceneSize writeOffice(std::ostream& out, std::uint64_t triangles, std::uint64_t random);
/// Ground under trees and bushes of single leaves, each a floor no larger than a hand.
SceneSize writeFoliage(std::ostream& out, std::uint64_t triangles, std::uint64_t random);
/// Blocks of the city whose vertices are off by the last bits of floats, each by its own.
SceneSize writeNoise(std::ostream& out, std::uint64_t triangles, std::uint64_t random);
/// Platforms with ramps of 45 degrees at all angles, half of which are steeper by rounding.
SceneSize writeRamps(std::ostream& out, std::uint64_t triangles, std::uint64_t random);
/// Bowls of round steps whose risers lean outwards or hang over.
SceneSize writeStands(std::ostream& out, std::uint64_t triangles, std::uint64_t random);

inline constexpr std::array kScenes{
    SceneKind{"town", "Town: blocks of a city, turned.", writeTown},
    SceneKind{"office", "Office: furniture at all angles, down to the keys.", writeOffice},
    SceneKind{"foliage", "Foliage: trees and bushes of single leaves.", writeFoliage},
    SceneKind{"noise", "Noise: a city whose coordinates are off by their last bits.", writeNoise},
    SceneKind{"ramps", "Ramps of 45 degrees, turned.", writeRamps},
    SceneKind{"stands", "Stands: bowls of steps whose risers lean.", writeStands},
};

}  // namespace footfall::samples
