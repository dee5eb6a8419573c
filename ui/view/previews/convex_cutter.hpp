// Convex polygons that straight lines cut.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "footfall/geometry.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

/// A convex polygon in the plan, with heights.
class ConvexPolygon {
 public:
  void clear() { corners_.clear(); }
  void add(const Vec3& corner) { corners_.push_back(corner); }
  [[nodiscard]] std::size_t size() const { return corners_.size(); }
  [[nodiscard]] const Vec3& operator[](std::size_t i) const { return corners_[i]; }
  [[nodiscard]] const Vec3& behind(std::size_t i) const { return corners_[i + 1 < corners_.size() ? i + 1 : 0]; }

 private:
  std::vector<Vec3> corners_;
};

/// Cuts a polygon, with memory for the next one.
class ConvexCutter {
 public:
  [[nodiscard]] ConvexPolygon& polygon() { return polygons_[now_]; }
  /// Keeps the part where `distance`, which is linear, is at least 0.
  template <class Distance>
  void cut(const Distance& distance) {
    const ConvexPolygon& polygon = polygons_[now_];
    ConvexPolygon& kept = polygons_[1 - now_];
    now_ = 1 - now_;
    kept.clear();
    if (polygon.size() == 0) return;
    double da = distance(polygon[0]);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 &a = polygon[i], &b = polygon.behind(i);
      const double db = distance(b);
      if (da >= 0) kept.add(a);
      if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
        const double t = da / (da - db);
        kept.add({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)});
      }
      da = db;
    }
  }

 private:
  std::array<ConvexPolygon, 2> polygons_;
  int now_ = 0;
};

}  // namespace footfall::ui
