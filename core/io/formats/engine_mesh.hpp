// A navigation mesh as engines take it: metres, floats, and what leads from place to place beside common edges.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "footfall/io.hpp"

namespace footfall::detail {

/// Two edges of the border, as vertex numbers with the walkable area on the left, between which an agent steps, both
/// ways. The end of one lies at the start of the other.
struct EngineLink {
  std::array<std::uint32_t, 2> from, to;
};

/// A way that cannot be said by common edges: from one place inside a triangle to one inside another.
struct EngineJump {
  Vec3 from, to;
  bool isBothWays = false;
  bool isDrop = false;
};

/// Z up still; whoever writes it turns it. All coordinates are numbers that a float holds.
struct EngineMesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;    ///< counter-clockwise from above
  std::vector<std::uint32_t> layers;  ///< of each triangle; empty without layers
  std::vector<EngineLink> links;
  std::vector<EngineJump> jumps;
  double largestError = 0;  ///< in metres, by which rounding moved a coordinate
};

/// How far inside a triangle the ends of jumps lie that are on its border, in metres; less where the triangle is small.
/// So each of them belongs to one polygon only.
inline constexpr double kInset = 0.005;

/// `place` on the border of a triangle, moved towards the triangle's middle by at most kInset, rounded to floats.
Vec3 insetPlace(const EngineMesh& mesh, const Triangle& triangle, const Vec3& place);

/// Rounds the mesh in metres times `options.scale`. Of a drop there is a jump for each begun metre of its width. What
/// `options` leave out (layers, steps, drops) is not there. Throws InputError for what no float holds (checkScale()).
EngineMesh engineMesh(const NavigationMesh& mesh, const ExportOptions& options);

/// Cuts all triangles where coordinate `axis` (0: x, 1: y) is `place`, which no vertex has: common edges get common
/// vertices. Links are cut into two, as far as both parts have their other edge on the same side.
void cutAlong(EngineMesh& mesh, int axis, double place);

}  // namespace footfall::detail
