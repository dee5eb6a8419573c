// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inspect/place_cover.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/vector.hpp"
#include "core/filters/filter_traits.hpp"
#include "footfall/filter.hpp"

namespace footfall::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

ExactPoint exactPlace(const PlanKernel& kernel, const MeshVertex& v) {
  return v.source >= 0 ? exactPoint(kernel.mesh().vertices[v.source]) : kernel.exactPosition(v.point, v.face);
}

/// The range in which a mesh's rounded coordinates may hold the place.
struct Window {
  std::array<double, 2> x, y;

  Window(const GenericPlace& place, int scaleExponent) {
    // get_d() cuts digits off, and scaling may lose some more where a number becomes tiny.
    const auto around = [&](const mpq_class& value) {
      const double cut = std::ldexp(value.get_d(), scaleExponent);
      return std::array{std::nextafter(std::nextafter(cut, -kInfinity), -kInfinity),
                        std::nextafter(std::nextafter(cut, kInfinity), kInfinity)};
    };
    x = around(place.x());
    y = around(place.y());
  }

  [[nodiscard]] bool mayHold(const WalkableMesh& mesh, const MeshTriangle& t) const {
    const MeshVertex &a = mesh.vertices[t.corners[0]], &b = mesh.vertices[t.corners[1]],
                     &c = mesh.vertices[t.corners[2]];
    const double error = std::max({a.error, b.error, c.error});
    return std::min({a.x, b.x, c.x}) - error <= x[1] && std::max({a.x, b.x, c.x}) + error >= x[0] &&
           std::min({a.y, b.y, c.y}) - error <= y[1] && std::max({a.y, b.y, c.y}) + error >= y[0];
  }
};

/// The distance by which a step may move what it does not remove.
double reachOf(const PipelineStep& step, const SourceMesh& before) {
  const Reach reach = step.filter->traits->reach(step.values);
  if (reach.ofDiagonal == 0) return reach.length;
  Vec3 low = before.vertices.front(), high = low;
  for (const Vec3& v : before.vertices) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  return reach.length + reach.ofDiagonal * std::hypot(high.x - low.x, high.y - low.y, high.z - low.z);
}

/// True when the plane of a triangle is at most `reach` from a point `height` above it.
bool isWithin(const std::array<ExactPoint, 3>& corners, const mpq_class& height, double reach) {
  const auto& [a, b, c] = corners;
  const auto [nx, ny, nz] = cross(b - a, c - a);
  const mpq_class limit(reach);
  return height * height * nz * nz <= limit * limit * (nx * nx + ny * ny + nz * nz);
}

}  // namespace

PlaceFollower::PlaceFollower(const SourceMesh& mesh, Index face, GenericPlace place)
    : place_(std::move(place)), mesh_(&mesh), face_(face) {}

std::optional<PlaceCover> PlaceFollower::begin(const WalkableState& state) {
  const GenericNumber height = this->height();
  std::optional<PlaceCover> cover;
  for (const ColumnFace& other : facesAt(*mesh_, place_)) {
    if ((other.height - height).sign() != 0) continue;
    inputs_.insert(mesh_->inputTriangles[other.face]);
    if (state.walkable[other.face] != 0 && (!cover || other.face == face_)) cover = PlaceCover{other.face, -1};
  }
  if (cover) face_ = cover->face;
  return cover;
}

bool PlaceFollower::isInPlane(Index face) const {
  if (face == face_) return true;
  const auto height = place_.heightOf(cornersOf(*mesh_, face));
  return height && (*height - this->height()).sign() == 0;
}

std::vector<PlaceCover> PlaceFollower::coversOf(const WalkableState& state) const {
  std::vector<PlaceCover> covers;
  const SourceMesh& source = state.kernel->mesh();
  if (!state.mesh) {
    for (const ColumnFace& floor : facesAt(source, place_))
      if (state.walkable[floor.face] != 0 && state.removed[floor.face] == 0) covers.push_back({floor.face, -1});
    return covers;
  }
  const Window window(place_, source.grid.scaleExponent());
  const WalkableMesh& mesh = *state.mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const MeshTriangle& triangle = mesh.triangles[t];
    if (!window.mayHold(mesh, triangle)) continue;
    std::array<ExactPoint, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = exactPlace(*state.kernel, mesh.vertices[triangle.corners[k]]);
    if (place_.isInside(corners)) covers.push_back({triangle.face, static_cast<Index>(t)});
  }
  return covers;
}

std::optional<PlaceCover> PlaceFollower::follow(const WalkableState& state, const PipelineStep& step) {
  const std::vector<PlaceCover> covers = coversOf(state);
  const SourceMesh& source = state.kernel->mesh();
  if (&source == mesh_) {
    const auto found =
        std::find_if(covers.begin(), covers.end(), [&](const PlaceCover& cover) { return isInPlane(cover.face); });
    return found == covers.end() ? std::nullopt : std::optional(*found);
  }
  const mpq_class before = height().value;
  const double reach = reachOf(step, *mesh_);
  std::optional<PlaceCover> nearest;
  mpq_class least;
  for (const PlaceCover& cover : covers) {
    const auto corners = cornersOf(source, cover.face);
    const mpq_class distance = abs(place_.heightOf(corners)->value - before);
    if (inputs_.count(source.inputTriangles[cover.face]) == 0 && !isWithin(corners, distance, reach)) continue;
    if (nearest && distance >= least) continue;
    nearest = cover;
    least = distance;
  }
  if (nearest) {
    mesh_ = &source;
    face_ = nearest->face;
  }
  return nearest;
}

}  // namespace footfall::detail
