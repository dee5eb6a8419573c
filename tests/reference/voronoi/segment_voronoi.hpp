// Nearest segments by CGAL's Segment_Delaunay_graph_2 with an exact traits class: a reference that shares nothing with
// the clearance field.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>

namespace footfall::reference {

using PlanSegment = std::array<std::array<double, 2>, 2>;

class SegmentVoronoi {
 public:
  /// Segments that do not cross and may share ends.
  explicit SegmentVoronoi(std::span<const PlanSegment> segments);
  ~SegmentVoronoi();
  SegmentVoronoi(const SegmentVoronoi&) = delete;
  SegmentVoronoi& operator=(const SegmentVoronoi&) = delete;

  /// The distance to the nearest segment or end, which is chosen exactly.
  [[nodiscard]] double distance(double x, double y) const;

 private:
  struct Inside;
  std::unique_ptr<const Inside> inside_;
};

}  // namespace footfall::reference
