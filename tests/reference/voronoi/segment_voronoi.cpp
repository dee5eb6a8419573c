// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/voronoi/segment_voronoi.hpp"

#include <CGAL/Gmpq.h>
#include <CGAL/Segment_Delaunay_graph_2.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>

namespace footfall::reference {
namespace {

using DoubleKernel = CGAL::Simple_cartesian<double>;
using ExactKernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Traits = CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<
    DoubleKernel, CGAL::Field_with_sqrt_tag, ExactKernel, CGAL::Integral_domain_without_division_tag>;
using Graph = CGAL::Segment_Delaunay_graph_2<Traits>;

double distanceTo(const Graph::Site_2& site, double x, double y) {
  if (site.is_point()) return std::hypot(site.point().x() - x, site.point().y() - y);
  const auto a = site.source(), b = site.target();
  const double dx = b.x() - a.x(), dy = b.y() - a.y();
  const double t = std::clamp(((x - a.x()) * dx + (y - a.y()) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(a.x() + t * dx - x, a.y() + t * dy - y);
}

}  // namespace

struct SegmentVoronoi::Inside {
  Graph graph;
};

SegmentVoronoi::SegmentVoronoi(std::span<const PlanSegment> segments) {
  auto inside = std::make_unique<Inside>();
  for (const auto& [a, b] : segments) inside->graph.insert(Traits::Point_2(a[0], a[1]), Traits::Point_2(b[0], b[1]));
  inside_ = std::move(inside);
}

SegmentVoronoi::~SegmentVoronoi() = default;

double SegmentVoronoi::distance(double x, double y) const {
  const auto vertex = inside_->graph.nearest_neighbor(Traits::Point_2(x, y));
  return distanceTo(vertex->site(), x, y);
}

}  // namespace footfall::reference
