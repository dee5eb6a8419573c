// The Explicit Corridor Map of a walkable area, and its bottlenecks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "footfall/geometry.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/run_context.hpp"

namespace footfall {

/// A place where an edge of the map ends, or where its nearest borders change. Lengths are in the environment's units,
/// in the plan.
struct CorridorVertex {
  Vec3 place;
  double width = 0;            ///< twice the distance to the nearest border
  std::uint32_t triangle = 0;  ///< of the mesh, under it; over a gap, one beside it
};

enum class CorridorShape : std::uint32_t {
  Straight,  ///< between two corners, or between two straight borders
  Parabola   ///< about a corner, whose place is the same all along; the other side's border is straight
};

/// A piece of the medial axis with the same border on its left, and the same one on its right.
struct CorridorEdge {
  std::uint32_t from = 0, to = 0;  ///< vertices
  CorridorShape shape = CorridorShape::Straight;
  std::array<Vec3, 2> left{}, right{};  ///< the nearest places of the borders, at its start and at its end
  double length = 0;
  Vec3 narrowest;                        ///< where it is narrowest; an end, or between both
  double width = 0;                      ///< there
  double area = 0;                       ///< in the plan, of all that is nearer to its borders here than elsewhere
  std::vector<std::uint32_t> triangles;  ///< of the mesh, under it, in its order
};

/// The area on one side of a bottleneck.
struct BottleneckSide {
  /// The widest vertex that is reached on this side without going through anything narrower, or through a bottleneck
  /// that is as narrow and comes earlier in the list; an agent that fits through the bottleneck gets there.
  std::uint32_t widest = 0;
  double area = 0;  ///< in the plan, of all that is on this side, where the bottleneck is the only way; else 0
};

/// A place where the map is narrower than on either side.
struct Bottleneck {
  Vec3 place;
  double width = 0;
  Vec3 left, right;        ///< the places of the border that make it, as one goes from the first to the second side
  std::uint32_t edge = 0;  ///< of the map, on which it lies
  bool isOnlyWay = false;  ///< between its sides
  std::array<BottleneckSide, 2> sides{};  ///< at the edge's start, and at its end
};

/// Bottlenecks with a smaller prominence are bends of one passage, and are not worth a line in a list.
inline constexpr double kUsualProminence = 0.05;

/// The medial axis of a walkable area as a graph, over its layers, steps and gaps (van Toll, Cook and Geraerts).
struct CorridorMap {
  bool isFull = false;
  std::vector<CorridorVertex> vertices;
  std::vector<CorridorEdge> edges;
  std::vector<Bottleneck> bottlenecks;  ///< narrowest first
  SourceFrame frame;
};

struct CorridorOptions {
  /// Keeps the pieces that lead into convex corners. They have no passage behind them.
  bool full = false;
};

/// The map of a mesh, which has neither a bottleneck nor an edge where the mesh is empty. Vertices and edges are in an
/// order that depends on the mesh alone. Places, widths and areas are doubles, off by 2^-36 of the mesh's extent and
/// what formulas lose where borders are nearly parallel. Throws Cancelled.
CorridorMap makeCorridorMap(const NavigationMesh& mesh, const CorridorOptions& options = {},
                            const RunContext* context = nullptr);

/// How much wider the way gets on the less wide side of a bottleneck, over the bottleneck's width: 0.05 for 5 %. The
/// narrowest place of a passage whose borders are rough has a large one, the others next to it have small ones.
double prominence(const CorridorMap& map, const Bottleneck& bottleneck);

/// The map as JSON (docs/reference/corridors.schema.json), in the frame and the units of its file.
std::string formatCorridorsJson(const CorridorMap& map);

/// Reads what formatCorridorsJson() wrote: the same map. `name` is for messages. Throws InputError.
CorridorMap parseCorridorsJson(const std::string& text, const std::string& name);

/// The map as GeoJSON: edges as lines, bottlenecks as lines from border to border; X and Y in metres, Z up.
std::string formatCorridorsGeoJson(const CorridorMap& map);

/// The map as binary glTF 2.0: a mesh of lines for the edges and one for the bottlenecks, from border to border, in
/// metres with Y up. Colours go from vermilion (0.8 m or less) to blue (2 m or more). Throws InputError above 4 GB.
std::string formatCorridorsGlb(const CorridorMap& map);

/// A way on the map for an agent with a body.
struct CorridorPath {
  std::vector<std::uint32_t> vertices;  ///< from the start's to the end's; empty where there is no way
  std::vector<std::uint32_t> edges;     ///< between them
  double length = 0;
  double width = 0;  ///< where it is narrowest
};

/// The shortest way along the map from one vertex to another that is nowhere narrower than `width`.
CorridorPath shortestCorridor(const CorridorMap& map, std::uint32_t from, std::uint32_t to, double width);

/// The way along the map whose narrowest place is widest, and the shortest one of those.
CorridorPath widestCorridor(const CorridorMap& map, std::uint32_t from, std::uint32_t to);

/// The vertex that is nearest to a place, in space; `map` must have vertices.
std::uint32_t nearestVertex(const CorridorMap& map, const Vec3& place);

}  // namespace footfall
