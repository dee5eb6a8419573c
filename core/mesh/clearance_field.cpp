// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/clearance_field.hpp"

#include <algorithm>

#include "core/mesh/field_spread.hpp"
#include "core/mesh/gap_bridges.hpp"

namespace footfall::detail {
namespace {

bool hasGaps(const NavigationMesh& mesh) {
  return std::any_of(mesh.links.begin(), mesh.links.end(),
                     [](const StepLink& link) { return link.kind == StepKind::Gap; });
}

/// Returns whether the way from `p` to `q`, inside the face and beyond its side, crosses the side within the window.
bool crossesWithin(const FieldEdge& edge, const FieldWindow& window, FieldVector p, FieldVector q, double tolerance) {
  const double sign = window.into == 0 ? 1 : -1;
  const double inside = std::max(0.0, sign * cross(edge.along, p - edge.begin));
  const double outside = std::max(0.0, -sign * cross(edge.along, q - edge.begin));
  const double a = dot(p - edge.begin, edge.along), b = dot(q - edge.begin, edge.along);
  const double across = inside + outside;
  if (across <= tolerance) return std::max(a, b) >= window.lo - tolerance && std::min(a, b) <= window.hi + tolerance;
  const double s = (a * outside + b * inside) / across, error = tolerance * (1 + (std::fabs(b - a) / across));
  return s >= window.lo - error && s <= window.hi + error;
}

}  // namespace

ClearanceField::ClearanceField(const NavigationMesh& mesh, const FieldOptions& options, Poll poll)
    : surface_(hasGaps(mesh) ? makeFieldSurface(withBridges(mesh), poll) : makeFieldSurface(mesh, poll)) {
  FieldSpread(*this, options, poll).run();
}

ClearanceField::Nearest ClearanceField::at(std::uint32_t face, FieldVector p) const {
  Nearest nearest;
  if (!surface_.takesPart(face)) return nearest;
  double least = std::numeric_limits<double>::infinity();
  const auto take = [&](std::uint32_t feature, FieldVector q) {
    const double squared = dot(q - p, q - p);
    if (squared > least || (squared == least && feature > nearest.feature)) return;
    least = squared;
    nearest.feature = feature;
    nearest.border = q;
  };
  for (int side = 0; side < 3; ++side) {
    const std::uint32_t half = surface_.halves[face][side], edge = half >> 1;
    if (edgeFeatures_[edge] != FieldEdge::kNone) take(edgeFeatures_[edge], features_[edgeFeatures_[edge]].nearestTo(p));
    const std::uint32_t corner = fanFeatures_[surface_.topology.fans[face][side]];
    if (corner != FieldEdge::kNone) take(corner, features_[corner].place);
    for (const FieldWindow& window : windowsOf(edge)) {
      if (window.into != (half & 1)) continue;
      const FieldFeature& feature = features_[window.feature];
      // Beyond its ends, an edge has corners that are features of their own, or it is not the nearest.
      const double along = dot(p - feature.place, feature.along), over = 4 * tolerance();
      if (!feature.isCorner() && (along < -over || along > feature.length + over)) continue;
      const FieldVector q = feature.nearestTo(p);
      if (dot(q - p, q - p) <= least && crossesWithin(surface_.edges[edge], window, p, q, 4 * tolerance()))
        take(window.feature, q);
    }
  }
  nearest.distance = std::sqrt(least);
  return nearest;
}

}  // namespace footfall::detail
