// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/edge_region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace footfall::detail {

EdgeFrame::EdgeFrame(const Vec3& begin, const Vec3& end, double largest)
    : begin_(begin), end_(end), margin_(std::ldexp(largest, -40)) {
  const double dx = end.x - begin.x, dy = end.y - begin.y;
  length_ = std::hypot(dx, dy);
  const double ux = dx / length_, uy = dy / length_, slope = (end.z - begin.z) / length_;
  along_ = {ux / length_, uy / length_, 0, 0};
  outwards_ = {uy, -ux, 0, 0};
  above_ = {-slope * ux, -slope * uy, 1, 0};
}

Vec3 EdgeFrame::at(double along) const {
  if (along <= 0) return begin_;
  if (along >= 1) return end_;
  return {begin_.x + along * (end_.x - begin_.x), begin_.y + along * (end_.y - begin_.y),
          begin_.z + along * (end_.z - begin_.z)};
}

std::vector<LinearFunction> EdgeFrame::widened(std::vector<LinearFunction> halfSpaces) const {
  for (LinearFunction& inside : halfSpaces) {
    const double size = std::sqrt(inside.x * inside.x + inside.y * inside.y + inside.z * inside.z);
    inside = inside + margin_ * std::max(size, std::numeric_limits<double>::min());
  }
  return halfSpaces;
}

// The method is that of Sutherland and Hodgman, "Reentrant polygon clipping" (1974). Most triangles are outside of one
// half-space altogether.
std::optional<EdgePiece> EdgeFrame::shadow(const std::array<Vec3, 3>& triangle,
                                           const std::vector<LinearFunction>& halfSpaces) const {
  const std::array<Vec3, 3> corners{local(triangle[0]), local(triangle[1]), local(triangle[2])};
  for (const LinearFunction& inside : halfSpaces)
    if (inside.at(corners[0]) < 0 && inside.at(corners[1]) < 0 && inside.at(corners[2]) < 0) return std::nullopt;
  std::vector<Vec3> polygon(corners.begin(), corners.end()), rest;
  for (const LinearFunction& inside : halfSpaces) {
    rest.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 &p = polygon[i], &q = polygon[i + 1 == polygon.size() ? 0 : i + 1];
      const double atP = inside.at(p), atQ = inside.at(q);
      if (atP >= 0) rest.push_back(p);
      if ((atP >= 0) == (atQ >= 0)) continue;
      const double t = atP / (atP - atQ);
      rest.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)});
    }
    polygon.swap(rest);
    if (polygon.empty()) return std::nullopt;
  }
  EdgePiece piece{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Vec3& p : polygon) {
    const double along = along_.at(p);
    piece.begin = std::min(piece.begin, along);
    piece.end = std::max(piece.end, along);
  }
  piece.begin -= margin_ / length_;
  piece.end += margin_ / length_;
  return piece;
}

}  // namespace footfall::detail
