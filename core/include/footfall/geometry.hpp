// Points and triangles, as every part of Footfall has them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace footfall {

/// A point or a vector in double precision. Of environments and results: Z up, the environment's units.
struct Vec3 {
  double x = 0, y = 0, z = 0;
  bool operator==(const Vec3&) const = default;
};

/// The axis of a file that points up, along it or against it.
enum class UpAxis { Y, Z, X, NegativeY, NegativeZ, NegativeX };

/// Numbers of three vertices, counter-clockwise seen from the front.
using Triangle = std::array<std::uint32_t, 3>;

/// Vertices and the triangles over them, in any order and not necessarily connected.
struct TriangleSoup {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

/// A storey of a building.
struct Storey {
  std::string name;
  double height = 0;  ///< height of its floor, in the environment's units, along Z
  bool operator==(const Storey&) const = default;
};

/// The file that coordinates came from, so that results can be written to lie exactly on it.
struct SourceFrame {
  std::string source = {};           ///< path as given by the user; empty when there was no file
  UpAxis up = UpAxis::Z;             ///< the file's up axis; inside, Z is up
  double metresPerUnit = 1;          ///< metres in one unit of the file and of everything that was made of it
  std::vector<Storey> storeys = {};  ///< ascending by height; empty if the file has none
};

}  // namespace footfall
