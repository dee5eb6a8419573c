// Files: environments in, navigation meshes out and back in.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "footfall/environment.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall {

/// Reads OBJ at double precision, and everything else that Assimp reads through Assimp (floats), node transforms
/// applied, polygons triangulated. The environment is turned to Z up and keeps the file's units. Buildings (IFC) come
/// through a converter where it is installed (docs/how-to/buildings.md), with Environment::usualRoles applied. A folder
/// is all meshes directly in it as one environment, each file a part. Throws InputError with one line that says file,
/// place and what to do: missing, a directory, no permission, empty, truncated, not a mesh, no triangles, NaN or
/// infinite coordinates, indices out of range. Throws Cancelled when `context` (may be null) was cancelled while
/// reading. Any thread may call it.
Environment load(const std::string& path, const ImportOptions& options = {}, RunContext* context = nullptr);

/// File name extensions that load() reads, lower case, without the dot ("obj", "gltf", ...).
std::vector<std::string> importableExtensions();

/// The content and the frame of an export. By default, an OBJ lies exactly on the file that it came from.
struct ExportOptions {
  bool layers = true;         ///< false: one group "walkable"
  bool connections = true;    ///< the lines; what is connected stays so by its indices
  bool obstacleEdges = true;  ///< the lines; what is apart stays so by its indices
  bool steps = true;          ///< the faces; both borders are there without them
  std::optional<UpAxis> up;   ///< empty: that of NavigationMesh::frame
  /// Coordinates are multiplied with it; finite and above 0. They are rounded once more then, unless it is a power of
  /// two: triangles much smaller than their coordinates can collapse.
  double scale = 1;
  bool drops = true;  ///< the lines from upper to lower
  int godot = 4;      ///< for a .tres: the version of Godot that reads it, 3 or 4
  /// glTF: all triangles in one mesh whose node is "walkable-navmesh", which Godot imports as a navigation region.
  bool navmeshNode = false;
  /// Polygons (.wkt, .geojson): write this connected part alone, from 0 on, largest first; empty: all.
  std::optional<std::uint32_t> part = std::nullopt;
  /// .geojson: the coordinate system that the environment is in already, "EPSG:25832"; nothing is moved.
  std::string coordinateSystem = {};
};

/// The agent that a mesh was computed for, in the environment's units and degrees; empty: no filter states it.
struct AgentNumbers {
  std::optional<double> maxSlope, height;
  double step = 0, gap = 0;  ///< height that it climbs, and width that it steps over in the plan
  double radius = 0;
};

/// Comment lines at the top of an export; makeExportHeader() (footfall/report.hpp) makes those of a pipeline.
struct ExportHeader {
  std::string pipeline = {};  ///< formatPipeline(), one filter a line
  std::string agent = {};     ///< e.g. "slope 45 degrees, height 2"
  std::string note = {};      ///< anything else, such as that coordinates are scaled
  /// The numbers for formats that have fields for them (Detour, Godot, glTF's extras).
  AgentNumbers numbers = {};
};

/// Something else to be seen beside the walkable area, such as an obstacle that was placed: a group of its own,
/// "placed_NAME", behind everything.
struct ExportExtra {
  std::string name;
  TriangleSoup soup;
};

/// Writes a mesh as OBJ (a name that ends in .obj, or has no ending), as glTF (.gltf: one JSON file) or binary (.glb),
/// as a tile set of Detour (.bin), as a NavigationMesh of Godot (.tres), or as polygons with holes: well-known text
/// (.wkt: "level-0.wkt", "level-1.wkt" and so on where there are several layers, and "level-links.wkt") or GeoJSON;
/// docs/reference/formats.md says what each of them keeps. OBJ is in the frame and units of the file that its
/// environment came from, polygons in metres and Z up, all others in metres and Y up. Files are written beside their
/// targets and renamed when all of them are whole, so that a failure or a kill leaves earlier files as they were; the
/// same mesh gives the same bytes. Each layer is a group (OBJ) or mesh (glTF) "layer_0", "layer_1" and so on, or one
/// "walkable"; connections and obstacle edges are lines in "connections" and "obstacle_edges". Steps are faces in
/// "steps", over the vertices of both borders: who reads them has the full connectivity; who does not has the surface
/// alone. Drops are pairs of lines in "drops", from where an agent drops to where it lands, with vertices of their own.
///
/// Returns the largest distance, in metres, by which rounding moved a coordinate: 0 for OBJ and polygons; all others
/// have floats. Throws InputError for another ending, a scale that is out of range or makes coordinates infinite,
/// coordinates that no float holds, a mesh that the format cannot hold (Detour: too many polygons; extras), a part that
/// is not there, a Detour file where the library was built without Detour; RunError for a read-only target, a full
/// disk, a missing folder, a directory. Throws Cancelled when `context` (may be null) was cancelled; then nothing is
/// written. Any thread may call it.
double save(const NavigationMesh& mesh, const std::string& path, const ExportOptions& options = {},
            const ExportHeader& header = {}, std::span<const ExportExtra> extras = {}, RunContext* context = nullptr);

struct NavigationMeshFile {
  std::string path;
  NavigationMesh mesh;  ///< Z up; without sourceTriangles
  /// Names of the layers, by their number; one "walkable" or "all" where the file has no layers.
  std::vector<std::string> layerNames;
  bool isExport = false;  ///< has the comments that Footfall writes at the top
  UpAxis up = UpAxis::Y;  ///< the file's up axis
  std::optional<UpAxis> statedUp;
  std::optional<double> metresPerUnit;
  SkippedElements skipped;
};

/// Reads a navigation mesh from OBJ, at double precision: an export with all that it holds, or any other surface. Faces
/// in groups "layer_N" get layer N, `l` elements in the groups "connections", "obstacle_edges" and "drops" become
/// those; anything else is one surface without layers. The up axis is `up` where given, else the one that an export
/// states, else `usualUp`. A file that is not Z up is turned as load() does, which is exact.
///
/// Throws InputError with one line: what load() refuses; no triangles, unless the file is an export that says so; an
/// export that does not hold what its own comments count, because it was cut off; coordinates above 1e100, whose areas
/// and distances no double would hold. Throws Cancelled when `context` (may be null) was cancelled.
NavigationMeshFile readNavigationMesh(const std::string& path, std::optional<UpAxis> up = std::nullopt,
                                      UpAxis usualUp = UpAxis::Y, RunContext* context = nullptr);

}  // namespace footfall
