// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/border_splits.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "core/base/index_and_box.hpp"
#include "core/exact/plan_predicates.hpp"
#include "core/mesh/lifted_vertex.hpp"
#include "core/mesh/triangle_split.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPolled = 1 << 16;
constexpr std::size_t kSplitsPolled = 1024;

}  // namespace

BoxTree<3>::Bounds BorderSplits::boundsOf(const MeshVertex& a, const MeshVertex& b) {
  BoxTree<3>::Bounds bounds;
  const auto set = [&](int k, double p, double q) {
    const double margin = std::max(a.error, b.error) + std::max(std::fabs(p), std::fabs(q)) * 0x1p-50;
    bounds.lower[k] = std::min(p, q) - margin;
    bounds.upper[k] = std::max(p, q) + margin;
  };
  set(0, a.x, b.x);
  set(1, a.y, b.y);
  set(2, a.z, b.z);
  return bounds;
}

int BorderSplits::axisBetween(const MeshVertex& a, const MeshVertex& b, MeshGeometry& geometry) {
  const int likely = std::fabs(a.x - b.x) >= std::fabs(a.y - b.y) ? 0 : 1;
  if (geometry.compare(a, b, likely) != 0) return likely;
  return geometry.compare(a, b, 1 - likely) != 0 ? 1 - likely : -1;
}

BorderSplits::BorderSplits(const WalkableState& state, RunContext& context, const std::vector<char>* faces)
    : state_(state),
      kernel_(state.kernel),
      mesh_(*state.mesh),
      topology_(topologyOf(state, context)),
      geometry_(std::in_place, *kernel_, mesh_.vertices) {
  findBorders(faces, context);
  buildTree(context);
}

void BorderSplits::findBorders(const std::vector<char>* faces, Poll poll) {
  const TriangleCorners corners(mesh_.triangles);
  const auto isBorder = [&](std::span<const Index> sides) {
    return sides.size() <= 1 || isObstacle(mesh_.triangles, sides);
  };
  std::vector<Index> edges;
  std::size_t count = 0;
  for (Index e = 0; e < topology_->edgeCount(); ++e) {
    if (static_cast<std::size_t>(e) % kPolled == 0) poll();
    const auto sides = topology_->sidesOf(e);
    if (!isBorder(sides)) continue;
    edges.push_back(e);
    count += sides.size();
  }
  borders_.reserve(count);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i % kPolled == 0) poll();
    const Index e = edges[i];
    for (const Index side : topology_->sidesOf(e)) {
      const Index face = mesh_.triangles[side / 3].face;
      if (faces != nullptr && (*faces)[face] == 0) continue;
      borders_.push_back({side, e, corners.beginOf(side), corners.endOf(side), face});
    }
  }
}

void BorderSplits::buildTree(RunContext& context) {
  std::vector<Index> all(borders_.size());
  std::iota(all.begin(), all.end(), 0);
  tree_.build(
      all, [&](Index i) { return boundsOf(vertex(borders_[i].from), vertex(borders_[i].to)); }, context);
}

void BorderSplits::replaceKernel(std::shared_ptr<const PlanKernel> kernel) {
  fallbacks_ += geometry_->fallbacks;
  geometry_.reset();
  kernel_ = std::move(kernel);
  geometry_.emplace(*kernel_, mesh_.vertices);
}

std::vector<KnownLine> BorderSplits::ownLinesOf(const MeshBorder& border, MeshGeometry& geometry) const {
  const SourceMesh& source = kernel_->mesh();
  const PlanPoint &a = vertex(border.from).point, &b = vertex(border.to).point;
  std::vector<KnownLine> lines;
  const auto edgeLine = [&](Index u, Index v) {
    return PlanLine{PlanLine::Edge, std::min(source.planIds[u], source.planIds[v]),
                    std::max(source.planIds[u], source.planIds[v])};
  };
  const auto tryLine = [&](const PlanLine& line, Index face) {
    const Index origin = source.triangles[border.face][0];
    const auto isOn = [&](const PlanPoint& p) { return kernel_->side(line, face, p, origin, geometry.fallbacks) == 0; };
    if (isOn(a) && isOn(b)) lines.push_back({line, face});
  };
  if (a.kind() == PlanPoint::Source && b.kind() == PlanPoint::Source) {
    lines.push_back({edgeLine(a.planId(), b.planId()), -1});
    return lines;
  }
  for (const PlanPoint* p : {&a, &b}) {
    if (p->kind() == PlanPoint::EdgePlane) tryLine(edgeLine(p->edgeBegin(), p->edgeEnd()), -1);
    if (p->kind() != PlanPoint::Crossing) continue;
    for (const PlanLine& line : {p->firstLine(), p->secondLine()})
      tryLine(line, line.kind == PlanLine::Trace ? p->face() : -1);
  }
  const auto& f = source.triangles[border.face];
  for (int k = 0; k < 3; ++k) tryLine(edgeLine(f[k], f[next(k)]), -1);
  return lines;
}

std::vector<KnownLine> BorderSplits::linesOf(const MeshBorder& border, MeshGeometry& geometry) const {
  std::vector<KnownLine> lines = ownLinesOf(border, geometry);
  if (!lines.empty() || !state_.cuts) return lines;
  const PlanPoint &a = vertex(border.from).point, &b = vertex(border.to).point;
  const Index origin = kernel_->mesh().triangles[border.face][0];
  // Giant floors have hundreds of lines, nearly all of them far away.
  const Homogeneous<ErrorDouble> place = kernel_->homogeneous(a, origin);
  for (const PlanLine& line : (*state_.cuts)[border.face].lines) {
    const Index face = line.kind == PlanLine::Trace ? border.face : -1;
    const MaybeSign sign = kernel_->sign()(lineAtPoint<ErrorDouble>(kernel_->coefficients(line, face, origin), place));
    if (sign && *sign != 0) continue;
    const auto isOn = [&](const PlanPoint& p) { return kernel_->side(line, face, p, origin, geometry.fallbacks) == 0; };
    if (isOn(a) && isOn(b)) lines.push_back({line, face});
  }
  return lines;
}

bool BorderSplits::insert(Index edge, const MeshVertex& place) {
  const Index side = topology_->sidesOf(edge)[0];
  const TriangleCorners corners(mesh_.triangles);
  const MeshVertex &from = vertex(corners.beginOf(side)), &to = vertex(corners.endOf(side));
  const auto [found, isNew] = lines_.try_emplace(edge);
  Line& line = found->second;
  if (isNew) {
    line.axis = axisBetween(from, to, *geometry_);
    line.direction = geometry_->compare(to, from, line.axis);
  }
  if (order(line, place, from) <= 0 || order(line, place, to) >= 0) return false;
  std::vector<MeshVertex>& places = line.places;
  const auto at = std::lower_bound(places.begin(), places.end(), place,
                                   [&](const MeshVertex& s, const MeshVertex& p) { return order(line, s, p) < 0; });
  if (at != places.end() && order(line, place, *at) == 0) return false;
  places.insert(at, place);
  return true;
}

const std::vector<MeshVertex>& BorderSplits::of(Index edge) const {
  static const std::vector<MeshVertex> kNone;
  const auto found = lines_.find(edge);
  return found == lines_.end() ? kNone : found->second.places;
}

std::vector<MeshVertex> BorderSplits::between(Index edge, const MeshVertex& a, const MeshVertex& b) {
  const auto found = lines_.find(edge);
  if (found == lines_.end()) return {};
  const Line& line = found->second;
  const bool isAscending = order(line, a, b) < 0;
  const MeshVertex &low = isAscending ? a : b, &high = isAscending ? b : a;
  const auto first = std::upper_bound(line.places.begin(), line.places.end(), low,
                                      [&](const MeshVertex& p, const MeshVertex& s) { return order(line, p, s) < 0; });
  const auto last = std::lower_bound(first, line.places.end(), high,
                                     [&](const MeshVertex& s, const MeshVertex& p) { return order(line, s, p) < 0; });
  return {first, last};
}

bool BorderSplits::isForward(const MeshBorder& border) const {
  return border.from == beginOf(topology_->sidesOf(border.edge)[0]);
}

const MeshVertex& BorderSplits::chainVertex(const MeshBorder& border, std::size_t i) const {
  const std::vector<MeshVertex>& inside = of(border.edge);
  if (i == 0) return vertex(border.from);
  if (i == inside.size() + 1) return vertex(border.to);
  return inside[isForward(border) ? i - 1 : inside.size() - i];
}

Index BorderSplits::chainNumber(const MeshBorder& border, std::size_t i) const {
  const auto found = lines_.find(border.edge);
  const std::size_t count = found == lines_.end() ? 0 : found->second.places.size();
  if (i == 0) return border.from;
  if (i == count + 1) return border.to;
  return found->second.first + static_cast<Index>(isForward(border) ? i - 1 : count - i);
}

std::shared_ptr<WalkableMesh> BorderSplits::makeMesh(Poll poll) {
  auto result = std::make_shared<WalkableMesh>();
  result->layerCount = mesh_.layerCount;
  std::vector<Index> edges;
  std::size_t count = mesh_.vertices.size();
  for (const auto& [edge, line] : lines_) {
    if (!line.places.empty()) edges.push_back(edge);
    count += line.places.size();
  }
  std::sort(edges.begin(), edges.end());
  result->vertices.reserve(count);
  for (std::size_t first = 0; first < mesh_.vertices.size(); first += kPolled) {
    poll();
    const auto begin = mesh_.vertices.begin() + static_cast<std::ptrdiff_t>(first);
    result->vertices.insert(result->vertices.end(), begin,
                            begin + static_cast<std::ptrdiff_t>(std::min(kPolled, mesh_.vertices.size() - first)));
  }
  // New vertices of each edge, first in the direction of its first side, then in the other direction.
  std::vector<std::array<std::vector<Index>, 2>> inside(edges.size());
  std::vector<EdgeVertices> on;  // edges of split triangles
  std::vector<Index> slotOf(mesh_.triangles.size(), -1);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i % kSplitsPolled == 0) poll();
    const auto sides = topology_->sidesOf(edges[i]);
    auto& [forward, backward] = inside[i];
    Line& line = lines_.find(edges[i])->second;
    line.first = static_cast<Index>(result->vertices.size());
    for (const MeshVertex& place : line.places) {
      forward.push_back(static_cast<Index>(result->vertices.size()));
      result->vertices.push_back(liftedVertex(*kernel_, mesh_.triangles[sides[0] / 3].face, place.point));
    }
    backward.assign(forward.rbegin(), forward.rend());
    for (const Index side : sides) {
      Index& slot = slotOf[side / 3];
      if (slot < 0) {
        slot = static_cast<Index>(on.size());
        on.emplace_back();
      }
      on[slot][side % 3] = beginOf(side) == beginOf(sides[0]) ? &forward : &backward;
    }
  }
  result->triangles.reserve(mesh_.triangles.size() + 2 * edges.size());
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (t % kPolled == 0) poll();
    if (slotOf[t] < 0)
      result->triangles.push_back(mesh_.triangles[t]);
    else
      splitTriangle(mesh_.triangles[t], on[slotOf[t]], result->triangles);
    if (!mesh_.layers.empty()) result->layers.resize(result->triangles.size(), mesh_.layers[t]);
  }
  fallbacks_ += geometry_->fallbacks;
  geometry_->fallbacks = {};
  return result;
}

}  // namespace footfall::detail
