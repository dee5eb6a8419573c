// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/clearance/crowding.hpp"

#include <algorithm>

namespace footfall::detail {
namespace {

double planArea(const Box& a, const Box& b) {
  double area = 1;
  for (const std::size_t axis : {0, 1})
    area *= std::max(0.0, std::min(a.upper[axis], b.upper[axis]) - std::max(a.lower[axis], b.lower[axis]));
  return area;
}

}  // namespace

Crowding::Crowding(const SourceMesh& mesh, Index face)
    : mesh_(mesh), box_(boxOf(mesh, face)), faceArea_(planArea(box_, box_)) {}

double Crowding::commonArea(Index obstacle) const { return planArea(box_, boxOf(mesh_, obstacle)); }

void Crowding::add(Index obstacle) {
  if (mesh_.facing[obstacle] == 0 || faceArea_ == 0) return;
  depth_ += static_cast<std::uint64_t>(std::min(commonArea(obstacle) / faceArea_, 1.0) * kWhole);
  ++count_;
}

}  // namespace footfall::detail
