// A navigation mesh for game engines: metres, floats, and the links between places that share no edge.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "footfall/io.hpp"

namespace footfall::detail {

/// Two edges of the border that an agent steps between in both directions, as vertex numbers with the walkable area on
/// the left. The end of one lies at the start of the other.
struct EngineLink {
  std::array<std::uint32_t, 2> from, to;
};

/// A way that common edges cannot express: from a place inside one triangle to a place inside another.
struct EngineJump {
  Vec3 from, to;
  bool isDrop;  ///< one way; all others lead back
};

/// The mesh in Z up; each writer turns it. Floats hold all coordinates exactly.
struct EngineMesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;    ///< counter-clockwise from above
  std::vector<std::uint32_t> layers;  ///< layer of each triangle; empty without layers
  std::vector<EngineLink> links;
  std::vector<EngineJump> jumps;
  double largestError = 0;  ///< the largest distance, in metres, by which rounding moved a coordinate
};

/// The distance, in metres, by which ends of jumps on a triangle's border are moved inside; less where the triangle is
/// small. Each end thus belongs to one polygon only.
inline constexpr double kInset = 0.005;

/// `place` on the border of a triangle, moved towards the triangle's middle by at most kInset, rounded to floats.
Vec3 insetPlace(const EngineMesh& mesh, const Triangle& triangle, const Vec3& place);

/// Rounds the mesh in metres times `options.scale`. A drop has a jump for each begun metre of its width. Layers, steps
/// and drops that `options` leave out are missing. Throws InputError for coordinates that no float holds
/// (checkScale()).
EngineMesh engineMesh(const NavigationMesh& mesh, const ExportOptions& options);

/// Cuts all triangles where coordinate `axis` (0: x, 1: y) equals `place`, which no vertex has; common edges get common
/// vertices. Links are cut in two where both parts have their other edge on the same side.
void cutAlong(EngineMesh& mesh, int axis, double place);

}  // namespace footfall::detail
