// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/geometry/coarse_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "core/base/vector.hpp"
#include "ui/view/geometry/floor_shares.hpp"

namespace footfall::ui {
namespace {

using Point = std::array<float, 3>;

template <typename Corner>
double triangleArea(const Corner& a, const Corner& b, const Corner& c) {
  const std::array<double, 3> u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const std::array<double, 3> v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  const auto [x, y, z] = detail::cross(u, v);
  return std::hypot(x, y, z) / 2;
}

}  // namespace

std::vector<SurfaceVertex> coarsened(const std::vector<SurfaceVertex>& surface, std::vector<std::uint32_t>& kept) {
  kept.clear();
  std::vector<SurfaceVertex> coarse;
  if (surface.size() / 3 <= kCoarseAbove) return coarse;
  Point lower = surface.front().position;
  double area = 0;
  for (std::size_t v = 0; v + 2 < surface.size(); v += 3) {
    area += triangleArea(surface[v].position, surface[v + 1].position, surface[v + 2].position);
    for (std::size_t axis = 0; axis < 3; ++axis) lower[axis] = std::min(lower[axis], surface[v].position[axis]);
  }
  // A surface of this area has two triangles for each grid cube that it passes through.
  const double side = std::sqrt(2 * area / static_cast<double>(kCoarseAim));
  if (!(side > 0)) return coarse;
  std::unordered_map<std::uint64_t, std::uint32_t> cubes;  // the first corner in each cube
  cubes.reserve(kCoarseAim);
  const auto cornerOf = [&](std::uint32_t vertex) {
    std::uint64_t key = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double steps = std::floor((surface[vertex].position[axis] - lower[axis]) / side);
      key = key << 21U | static_cast<std::uint64_t>(std::clamp(steps, 0.0, 2097151.0));
    }
    return cubes.try_emplace(key, vertex).first->second;
  };
  std::unordered_set<std::uint64_t> known;
  known.reserve(2 * kCoarseAim);
  for (std::size_t v = 0; v + 2 < surface.size(); v += 3) {
    const auto first = static_cast<std::uint32_t>(v);
    const std::array<std::uint32_t, 3> corners{cornerOf(first), cornerOf(first + 1), cornerOf(first + 2)};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    std::array<std::uint64_t, 3> sorted{corners[0], corners[1], corners[2]};
    std::ranges::sort(sorted);
    // One of two triangles at the same place suffices. The sums of two different triangles may agree by chance, which
    // costs one triangle of a picture.
    if (!known.insert(sorted[0] * 0x9E3779B97F4A7C15ULL ^ sorted[1] * 0xC2B2AE3D27D4EB4FULL ^ sorted[2]).second)
      continue;
    for (std::size_t k = 0; k < 3; ++k) {
      coarse.push_back(surface[v + k]);
      coarse.back().position = surface[corners[k]].position;
    }
    kept.push_back(first / 3);
  }
  return coarse;
}

namespace {

// The area of each triangle of the environment that the mesh covers.
std::vector<double> areasOf(const std::vector<FloorShare>& shares, std::size_t triangles) {
  std::vector<double> areas(triangles);
  for (const FloorShare& share : shares) areas[share.floor] += share.area;
  return areas;
}

}  // namespace

std::shared_ptr<const FloorStates> makeFloorStates(const Environment& environment, const NavigationMesh& result,
                                                   const std::vector<FloorShare>& shares,
                                                   const std::vector<const NavigationMesh*>& before) {
  const std::size_t triangles = environment.triangles.size();
  if (triangles <= kCoarseAbove) return nullptr;
  std::vector<double> half(triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto corner = [&](std::size_t k) {
      const Vec3& p = environment.vertices[environment.triangles[t][k]];
      return std::array<double, 3>{p.x, p.y, p.z};
    };
    half[t] = triangleArea(corner(0), corner(1), corner(2)) / 2;
  }
  auto states = std::make_shared<FloorStates>(triangles, kFloorAsItIs);
  // The mesh of a later filter lies within the earlier ones.
  for (std::size_t k = 0; k < before.size(); ++k) {
    const std::vector<double> areas = areasOf(floorsUnder(*before[k], environment), triangles);
    for (std::size_t t = 0; t < triangles; ++t) {
      if (areas[t] > 0 && areas[t] >= half[t]) (*states)[t] = kFirstRemoval - static_cast<std::int32_t>(k);
    }
  }
  const std::vector<double> areas = areasOf(shares, triangles);
  for (const auto& [piece, floor, area] : shares) {
    if (areas[floor] >= half[floor])
      (*states)[floor] = result.layers.empty() ? 0 : static_cast<std::int32_t>(result.layers[piece]);
  }
  return states;
}

std::vector<SurfaceVertex> paintedCoarse(const CoarseSurface& coarse, const ViewContent& content, CoarsePaints paints) {
  const bool vivid = paints == CoarsePaints::Vivid;
  std::vector<SurfaceVertex> painted = coarse.surface;
  const FloorStates& states = *content.floorStates;
  const bool layered = content.environmentLayers != nullptr;
  for (std::size_t i = 0; i < coarse.triangles.size(); ++i) {
    if (painted[3 * i].colour[3] != 0 || coarse.triangles[i] >= states.size()) continue;  // no floor
    const std::int32_t state = states[coarse.triangles[i]];
    if (state == kFloorAsItIs) continue;
    Paint paint;
    if (state <= kFirstRemoval) {
      const auto removal = static_cast<std::size_t>(kFirstRemoval - state);
      if (removal >= content.removed.size() || paints == CoarsePaints::WalkableOnly) continue;
      paint = vivid ? content.removed[removal].style->vivid : content.removed[removal].style->paint;
    } else if (vivid) {
      paint = paleWalkablePaint();
    } else {
      paint = layered ? layerPaint(static_cast<std::uint32_t>(state)) : walkablePaint();
    }
    for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) setPaint(painted[k], paint);
  }
  return painted;
}

}  // namespace footfall::ui
