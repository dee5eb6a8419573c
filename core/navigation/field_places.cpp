// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/field_places.hpp"

#include <algorithm>
#include <limits>

namespace footfall::detail {

Vec3 FieldPlaces::onFace(std::uint32_t face, FieldVector p) const {
  const FieldSurface& surface = field_.surface();
  const FieldVector a = surface.corner(face, 0), b = surface.corner(face, 1), c = surface.corner(face, 2);
  const double area = cross(b - a, c - a);
  const auto height = [&](int i) { return bridged_.vertices[bridged_.triangles[face][i]].z; };
  const double u = cross(p - a, c - a) / area, v = cross(b - a, p - a) / area;
  const double z = height(0) + u * (height(1) - height(0)) + v * (height(2) - height(0));
  const double low = std::min({height(0), height(1), height(2)}), high = std::max({height(0), height(1), height(2)});
  return {p.x + surface.origin.x, p.y + surface.origin.y, std::clamp(z, low, high)};
}

std::uint32_t FieldPlaces::underFace(std::uint32_t face) const {
  for (const auto& link : bridged_.links) {
    if (face < mesh_.triangles.size()) break;
    if (link.toTriangle == face) return link.fromTriangle;
    if (link.fromTriangle == face) return link.toTriangle;
  }
  if (face < mesh_.triangles.size()) return face;
  for (const std::uint32_t other : field_.surface().topology.neighbours[face])
    if (other < mesh_.triangles.size()) return other;
  return 0;
}

Vec3 FieldPlaces::onBorder(std::uint32_t feature, FieldVector p) const {
  const FieldFeature& f = field_.features()[feature];
  const Triangle& triangle = bridged_.triangles[f.face];
  const Vec3& begin = bridged_.vertices[triangle[f.side]];
  if (f.isCorner()) return begin;
  const Vec3& end = bridged_.vertices[triangle[(f.side + 1) % 3]];
  const FieldVector q = f.nearestTo(p) + field_.surface().origin;
  const double share = f.length > 0 ? std::clamp(dot(p - f.place, f.along) / f.length, 0.0, 1.0) : 0;
  if (share == 0) return begin;
  if (share == 1) return end;
  return {q.x, q.y, begin.z + share * (end.z - begin.z)};
}

std::uint32_t FieldPlaces::faceAt(std::span<const std::uint32_t> faces, FieldVector p) const {
  std::uint32_t best = faces.front();
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t face : faces) {
    double outside = 0;
    for (int i = 0; i < 3; ++i) {
      const FieldVector a = field_.surface().corner(face, i), way = field_.surface().corner(face, i + 1) - a;
      outside = std::max(outside, cross(p - a, way) / lengthOf(way));
    }
    if (outside >= least) continue;
    least = outside;
    best = face;
  }
  return best;
}

}  // namespace footfall::detail
