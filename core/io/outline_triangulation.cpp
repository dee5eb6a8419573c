// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/outline_triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <optional>
#include <tuple>

#include "core/base/hilbert_curve.hpp"

namespace footfall::detail {
namespace {

/// How the outline winds around a face of the triangulation.
struct FaceWinding {
  std::array<int, 3> across{};  ///< change of the winding number on entering the face over edge i
  std::optional<int> number;    ///< winding number of the face; empty: not known yet
};

// The kernel constructs no points here: there are no intersections, and circles are only compared with points.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<FaceWinding, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;

/// Bits of a number that look random and are the same on every machine (Steele, Lea and Flood 2014).
std::uint64_t scrambled(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31);
}

/// One corner for each place, in a biased randomized insertion order: rounds double in size and run along a curve.
std::vector<std::size_t> insertionOrder(std::span<const Vec3> corners, std::span<const std::size_t> places) {
  Vec3 low = corners[places[0]], high = low;
  for (const std::size_t i : places) {
    low = {std::min(low.x, corners[i].x), std::min(low.y, corners[i].y), 0};
    high = {std::max(high.x, corners[i].x), std::max(high.y, corners[i].y), 0};
  }
  const double width = std::max(high.x / 2 - low.x / 2, high.y / 2 - low.y / 2);
  const auto stepOf = [width](double v, double least) {
    return width > 0 ? static_cast<std::uint32_t>(std::clamp((v / 2 - least / 2) / width * 65535, 0.0, 65535.0)) : 0U;
  };
  // Half of all corners go to the last round, a quarter to the round before it, and so on.
  std::vector<std::tuple<int, std::uint64_t, std::size_t>> order;
  order.reserve(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Vec3& p = corners[places[k]];
    const int round = -std::min(std::countr_zero(scrambled(k)), 24);
    order.emplace_back(round, hilbertIndex(stepOf(p.x, low.x), stepOf(p.y, low.y)), k);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> result;
  result.reserve(order.size());
  for (const auto& entry : order) result.push_back(places[std::get<2>(entry)]);
  return result;
}

class OutlineTriangulation {
 public:
  OutlineTriangulation(std::span<const Vec3> corners, Poll poll)
      : corners_(corners), poll_(poll), vertexAt_(corners.size()), uses_(corners.size(), 0) {}

  std::vector<std::array<std::size_t, 3>> inside() {
    if (!insertCorners() || triangulation_.dimension() < 2) return {};
    try {
      insertEdges();
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      return {};
    }
    for (std::size_t i = 0; i < corners_.size(); ++i) countWinding(i);
    if (!coversOnce()) return {};
    return triangles();
  }

 private:
  /// Returns false where corners lie above each other.
  bool insertCorners() {
    const auto before = [this](std::size_t i, std::size_t j) {
      return std::tie(corners_[i].x, corners_[i].y) < std::tie(corners_[j].x, corners_[j].y);
    };
    std::vector<std::size_t> sorted(corners_.size()), first(corners_.size()), places;
    std::iota(sorted.begin(), sorted.end(), std::size_t{0});
    std::stable_sort(sorted.begin(), sorted.end(), before);
    for (const std::size_t i : sorted) {
      if (places.empty() || before(places.back(), i)) places.push_back(i);
      first[i] = places.back();
      if (corners_[i].z != corners_[first[i]].z) return false;
      ++uses_[first[i]];
    }
    Face near;
    for (const std::size_t i : insertionOrder(corners_, places)) {
      poll_();
      vertexAt_[i] = triangulation_.insert({corners_[i].x, corners_[i].y}, near);
      vertexAt_[i]->info() = i;
      near = vertexAt_[i]->face();
    }
    for (std::size_t i = 0; i < corners_.size(); ++i) vertexAt_[i] = vertexAt_[first[i]];
    return true;
  }

  /// The ends of the edge behind corner i. The end at which fewer edges meet comes first, because searches begin there.
  [[nodiscard]] std::array<Vertex, 2> endsOf(std::size_t i) const {
    const Vertex a = vertexAt_[i], b = vertexAt_[i + 1 == corners_.size() ? 0 : i + 1];
    return uses_[a->info()] <= uses_[b->info()] ? std::array{a, b} : std::array{b, a};
  }

  void insertEdges() {
    std::vector<std::size_t> order(corners_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [](std::size_t i, std::size_t j) { return scrambled(i) < scrambled(j); });
    for (const std::size_t i : order) {
      poll_();
      const auto [a, b] = endsOf(i);
      if (a != b) triangulation_.insert_constraint(a, b);
    }
  }

  /// Counts the winding along the edge behind corner i, which may have been split where it runs through other corners.
  void countWinding(std::size_t i) {
    auto [from, to] = endsOf(i);
    const int direction = from == vertexAt_[i] ? 1 : -1;
    while (from != to) {
      poll_();
      Vertex next;
      Face face;  // lies on one side of the edge, which is its edge k
      int k = 0;
      triangulation_.includes_edge(from, to, next, face, k);
      const bool isLeft = face->vertex(Triangulation::ccw(k)) == from;
      const Face other = face->neighbor(k);
      face->info().across[static_cast<std::size_t>(k)] += isLeft ? direction : -direction;
      other->info().across[static_cast<std::size_t>(other->index(face))] += isLeft ? -direction : direction;
      from = next;
    }
  }

  /// Numbers the faces from the outside inwards. Returns false where the outline winds around a place more than once,
  /// or in opposite directions around two places.
  bool coversOnce() {
    int once = 0;
    std::vector<Face> open{triangulation_.infinite_face()};
    open.back()->info().number = 0;
    while (!open.empty()) {
      poll_();
      const Face face = open.back();
      open.pop_back();
      for (int k = 0; k < 3; ++k) {
        const Face other = face->neighbor(k);
        if (other->info().number) continue;
        const int number = *face->info().number + other->info().across[static_cast<std::size_t>(other->index(face))];
        if (number != 0 && once == 0) once = number > 0 ? 1 : -1;
        if (number != 0 && number != once) return false;
        other->info().number = number;
        open.push_back(other);
      }
    }
    return true;
  }

  [[nodiscard]] std::vector<std::array<std::size_t, 3>> triangles() const {
    std::vector<std::array<std::size_t, 3>> found;
    for (const Face face : triangulation_.finite_face_handles()) {
      const int number = face->info().number.value_or(0);
      if (number == 0) continue;
      std::array<std::size_t, 3> t{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
      if (number < 0) std::swap(t[1], t[2]);
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      found.push_back(t);
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  std::span<const Vec3> corners_;
  Poll poll_;
  Triangulation triangulation_;
  std::vector<Vertex> vertexAt_;
  std::vector<std::size_t> uses_;  ///< number of corners at a place, by its first corner
};

}  // namespace

std::vector<std::array<std::size_t, 3>> triangulateOutline(std::span<const Vec3> corners, Poll poll) {
  if (corners.size() < 3) return {};
  return OutlineTriangulation(corners, poll).inside();
}

}  // namespace footfall::detail
