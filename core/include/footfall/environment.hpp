// The loaded environment: a polygon soup in double precision, with Z up.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "footfall/geometry.hpp"
#include "footfall/text.hpp"

namespace footfall {

/// The coordinates that import() rounds to a grid, and the choice of the grid (docs/explanation/coordinates.md).
enum class GridChoice : std::uint8_t {
  Auto,  ///< files of floats and of placed meshes (glTF, FBX, DAE, 3DS, binary STL, PLY in floats), to the usual step
  On,    ///< all files, to the usual step
  Off,   ///< no file
  Step   ///< all files, to ImportOptions::gridStep
};

/// The user's statements about a file; empty ones are guessed from the format and reported.
struct ImportOptions {
  std::optional<UpAxis> up;
  /// Metres per unit of the file. Coordinates are never multiplied with it: it turns metres into the environment's
  /// units in the default pipeline and in what is shown, and it bounds the usual step of the grid.
  std::optional<double> metresPerUnit;
  /// Treat both sides of every triangle as its upper side, for soups with unreliable winding.
  bool bothSides = false;
  GridChoice grid = GridChoice::Auto;
  /// The step for GridChoice::Step, in units of the file, above 0; the largest power of two that is not above it is
  /// used.
  double gridStep = 0;
  /// The step that an earlier reading of the file used, a power of two in units of the file, or 0. It is used in place
  /// of the usual step while the usual one is at most four times smaller or larger, so that a file that is saved again
  /// and read again keeps its vertices.
  double keptGridStep = 0;
  /// The process that reads other formats than OBJ, PLY and STL ends where it takes far more time or memory than files
  /// of that size need (docs/reference/formats.md).
  bool limitReaders = true;
};

/// The grid on which import put the coordinates of an environment, and what that changed.
struct CoordinateGrid {
  /// The step in units of the environment, a power of two: all coordinates are multiples of it. 0: there is no grid,
  /// and coordinates are those of the file.
  double step = 0;
  std::uint32_t bits = 0;            ///< of the largest coordinate, counted in steps
  double largestMovement = 0;        ///< the largest distance between a vertex of the file and its place on the grid
  std::uint64_t weldedVertices = 0;  ///< distinct places that became one with another, nearer than two steps
  std::uint64_t degenerateTriangles = 0;  ///< triangles that have an area in the file and none on the grid
  std::uint64_t splitTriangles = 0;       ///< triangles that got vertices of others on their edges, nearer than a step
  bool operator==(const CoordinateGrid&) const = default;
};

enum class SkipReason : std::uint8_t {
  TooFewCorners,    ///< one or two corners
  RepeatedCorners,  ///< three corners or more, but fewer than three distinct vertices
  FreeForm          ///< a curved surface, which is not read
};

/// A polygon of the file that import left out (core/environment/skipped_polygons.hpp has it in words).
struct SkippedPolygon {
  SkipReason reason = SkipReason::TooFewCorners;
  std::size_t cornerCount = 0;  ///< number of corners in the file; 0 when the file does not say
  std::uint64_t line = 0;       ///< line of the file, from 1; 0 when the format has no lines
  std::uint64_t face = 0;       ///< if there is no line: its number in the mesh, from 1
  std::string mesh;             ///< if there is no line: the mesh's name, which may be empty
  /// The distinct corners, two at most: where the polygon is. Empty where it has none.
  std::vector<Vec3> corners;
  bool operator==(const SkippedPolygon&) const = default;
};

/// The elements that import left out, for the user to see.
struct SkippedElements {
  static constexpr std::size_t kMostListed = 1000;
  std::uint64_t points = 0;    ///< point elements
  std::uint64_t lines = 0;     ///< line elements
  std::uint64_t polygons = 0;  ///< faces with fewer than three distinct corners, and curved surfaces
  /// The first of the polygons in the order of the file, kMostListed at most.
  std::vector<SkippedPolygon> listed;
};

/// One mesh with one material, as the file names them; either may be empty.
struct EnvironmentPart {
  std::string mesh, material;
  bool operator==(const EnvironmentPart&) const = default;
};

/// The use of a part's triangles. 'Obstacle only' and 'never walkable' are one role: triangles that are no floor remain
/// obstacles.
enum class PartRole : std::uint8_t {
  Floor,         ///< the usual role: walkable where the filters allow it, and an obstacle
  ObstacleOnly,  ///< an obstacle, never walkable
  Ignored        ///< not there at all
};

struct EnvironmentEdit;  // footfall/edit.hpp

/// A triangle soup, from load() or filled by a program (checkEnvironment()). Coordinates are the file's own doubles, or
/// lie on a grid near them (CoordinateGrid); a file whose up axis is another is turned to Z up (a Y-up file by (x, y,
/// z) -> (x, -z, y)), which is exact and is undone on export.
struct Environment {
  std::string source;  ///< path as given by the user, for messages and export comments
  std::string origin;  ///< for a packed environment: the name of the file that was packed, for export comments
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;  ///< counter-clockwise seen from the front; indices into `vertices`
  UpAxis up = UpAxis::Z;            ///< the file's up axis
  bool upGuessed = true;
  double metresPerUnit = 1;  ///< metres in one unit, above 0; turns the metres of an Agent into units, and never moves
                             ///< a coordinate
  bool scaleGuessed = true;
  bool bothSides = false;  ///< both sides of every triangle are its upper side
  SkippedElements skipped;
  std::vector<EnvironmentPart> parts;  ///< sorted by their first triangles
  std::vector<std::uint32_t> partOf;   ///< part of each triangle; empty when the file divides nothing into parts
  /// The role of each part by its kind in the file (of an IFC file: doors are open, furniture is an obstacle); empty
  /// where the file has no kinds. load() has applied them.
  std::vector<PartRole> usualRoles;
  std::vector<std::uint8_t> obstacleOnly;  ///< 1: never walkable, but an obstacle; one a triangle, or empty
  /// The edit by which it was made from another environment; else null.
  std::shared_ptr<const EnvironmentEdit> edit;
  std::vector<Storey> storeys;  ///< storeys of a building, ascending by height; empty where the file has none
  std::vector<Text> notes;      ///< notes for the user about reading the file, a sentence each
  CoordinateGrid grid;          ///< limits of filters include its step (docs/explanation/coordinates.md)

  [[nodiscard]] SourceFrame frame() const { return {origin.empty() ? source : origin, up, metresPerUnit, storeys}; }
};

/// Throws InputError when an environment that a program filled itself is not in order: no triangles, a vertex number
/// out of range, a coordinate or scale that is not finite, lists whose lengths do not fit. load() gives none of these.
void checkEnvironment(const Environment& environment);

}  // namespace footfall
