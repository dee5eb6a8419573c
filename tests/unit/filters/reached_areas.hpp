// Areas that are reached from seeds, as the filter and as the reference have them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "core/assembly/walkable_state.hpp"
#include "core/base/number_text.hpp"
#include "footfall/errors.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "tests/reference/reach.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

namespace footfall::test {
using reference::FloorPiece;
using reference::Point2;
using reference::Point3;
using reference::Rational;

inline std::string seedsText(const std::vector<Vec3>& seeds) {
  std::string text = "ReachableFilter";
  for (const Vec3& s : seeds)
    for (const double number : {s.x, s.y, s.z}) {
      text += ' ';
      appendNumber(text, number);
    }
  return text + "\n";
}

inline double areaOf(const Soup& soup, const std::string& filters) {
  return area(*run(soup.environment(), filters, nullptr).mesh);
}

/// The message of a run; empty when it is done.
inline std::string errorOf(const Soup& soup, const std::string& filters) {
  try {
    runFilters(soup.environment(), filters);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

inline Rational twicePlanArea(const WalkableState& state) {
  Rational sum;
  for (const MeshTriangle& t : state.mesh->triangles) {
    std::array<Point2, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const MeshVertex& v = state.mesh->vertices[t.corners[k]];
      const auto place = state.kernel->exactPosition(v.point, v.face);
      p[k] = {place[0], place[1]};
    }
    sum += reference::twiceArea(p[0], p[1], p[2]);
  }
  return sum;
}

/// The triangles of a state's mesh, and which of them one can walk between: over an edge that both have and no obstacle
/// stands on, or over a link.
struct Walked {
  std::vector<FloorPiece> pieces;
  std::vector<std::array<std::size_t, 2>> crossings;
};

inline Walked walkedOf(const WalkableState& state) {
  const WalkableMesh& mesh = *state.mesh;
  Walked walked;
  struct Side {
    std::size_t piece;
    bool isBlocked;
  };
  std::map<std::array<Index, 2>, std::vector<Side>> sides;
  const auto key = [](Index a, Index b) { return std::array{std::min(a, b), std::max(a, b)}; };
  std::map<std::array<Index, 2>, std::size_t> directed;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const MeshTriangle& triangle = mesh.triangles[t];
    std::array<Point3, 3> corners;
    for (int k = 0; k < 3; ++k) {
      const MeshVertex& v = mesh.vertices[triangle.corners[k]];
      const auto place = state.kernel->exactPosition(v.point, v.face);
      corners[k] = {place[0], place[1], place[2]};
      const Index from = triangle.corners[k], to = triangle.corners[next(k)];
      sides[key(from, to)].push_back({t, (triangle.obstacleEdges >> k & 1) != 0});
      directed[{from, to}] = t;
    }
    walked.pieces.push_back({reference::planTriangle(corners), *reference::planeThrough(corners)});
  }
  for (const auto& [edge, here] : sides)
    if (std::ranges::none_of(here, &Side::isBlocked))
      for (const Side& side : here) walked.crossings.push_back({here[0].piece, side.piece});
  for (const MeshLink& link : mesh.links) walked.crossings.push_back({directed.at(link.from), directed.at(link.to)});
  return walked;
}

/// A place worth a seed: corners, middles of edges and of triangles, and anywhere; at the floor, a little and exactly
/// the clearance above it, and lower or higher than that.
inline Vec3 seedFor(const Environment& environment, double clearance, std::mt19937_64& random) {
  const auto below = [&](int count) { return static_cast<int>(random() % static_cast<std::uint64_t>(count)); };
  const Triangle& t = environment.triangles[random() % environment.triangles.size()];
  const Vec3 &a = environment.vertices[t[0]], &b = environment.vertices[t[1]], &c = environment.vertices[t[2]];
  const auto between = [&](double u, double v) {
    return Vec3{a.x + u * (b.x - a.x) + v * (c.x - a.x), a.y + u * (b.y - a.y) + v * (c.y - a.y),
                a.z + u * (b.z - a.z) + v * (c.z - a.z)};
  };
  Vec3 place = below(3) == 0 ? a : below(3) == 0 ? between(0.5, 0) : between(0.25, below(2) * 0.5);
  place.z += clearance * std::array{0.0, 0.0, 0x1p-10, 0.5, 1.0, 1.0, 1.5, -0.25}[static_cast<std::size_t>(below(8))];
  return place;
}

}  // namespace footfall::test
