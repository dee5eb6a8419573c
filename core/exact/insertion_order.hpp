// An order of points on one face that depends on nothing but the points: along a Hilbert curve, so that each lies near
// its predecessor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/exact/face_geometry.hpp"

namespace footfall::detail {

/// The places of points along the curve through the geometry's face.
class CurvePlaces {
 public:
  explicit CurvePlaces(const FaceGeometry& geometry);
  [[nodiscard]] std::uint64_t of(const ApproximatePoint& point) const;

 private:
  double left_ = 0, bottom_ = 0, scale_ = 0;
};

/// Sorts points of the geometry, whose face has an area in the plan. Where rounded places are too close to be
/// ordered, what the points were made of decides.
void sortAlongCurve(const FaceGeometry& geometry, std::vector<Index>& points);

}  // namespace footfall::detail
