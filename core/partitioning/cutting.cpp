// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/partitioning/cutting.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>

#include "core/base/parallel.hpp"
#include "core/base/parallel_sort.hpp"
#include "core/partitioning/convex_triangulation.hpp"
#include "core/partitioning/triangle_cutter.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kTrianglesPerTask = 4096;
constexpr std::size_t kCutTrianglesPerTask = 128;
constexpr std::size_t kPlacesPerTask = 2048;
constexpr std::size_t kSortedByThreads = 10'000;

constexpr Index kLeftOut = std::numeric_limits<Index>::min();

/// Calls body(task, first, last) for ranges of equal length, whatever the threads.
template <class Body>
void forTasks(std::size_t count, std::size_t size, const Body& body) {
  forRanges((count + size - 1) / size, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t task = first; task < last; ++task) body(task, task * size, std::min(count, (task + 1) * size));
  });
}

template <class T, class Before>
void sortBy(std::vector<T>& items, const Before& isBefore) {
  if (items.size() < kSortedByThreads)
    std::sort(items.begin(), items.end(), isBefore);
  else
    parallelSort(items.begin(), items.end(), isBefore);
}

/// The points that cuts put on source edges, each edge's together and in order from its smaller vertex on.
class EdgePoints {
 public:
  EdgePoints(std::vector<CutVertex> points, const CutGeometry& geometry) : points_(std::move(points)) {
    const auto isBefore = [&](const CutVertex& p, const CutVertex& q) {
      if (p.a != q.a || p.b != q.b) return std::tie(p.a, p.b) < std::tie(q.a, q.b);
      return p.borders != q.borders && geometry.isBefore(p, q);
    };
    sortBy(points_, isBefore);
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    const std::size_t vertices = geometry.mesh().vertices.size();
    first_.assign(vertices + 1, static_cast<Index>(points_.size()));
    Index a = 0;
    for (Index i = 0; i < static_cast<Index>(points_.size()); ++i)
      while (a <= points_[i].a) first_[a++] = i;
  }

  [[nodiscard]] const std::vector<CutVertex>& points() const { return points_; }
  /// Number of the first point, and of the one behind the last, of an edge (u < v).
  [[nodiscard]] std::pair<Index, Index> range(Index u, Index v) const {
    if (first_[u] == first_[u + 1]) return {0, 0};
    const auto begin = points_.begin() + first_[u], end = points_.begin() + first_[u + 1];
    const auto low = std::lower_bound(begin, end, v, [](const CutVertex& p, Index b) { return p.b < b; });
    const auto high = std::upper_bound(low, end, v, [](Index b, const CutVertex& p) { return b < p.b; });
    return {static_cast<Index>(low - points_.begin()), static_cast<Index>(high - points_.begin())};
  }

 private:
  std::vector<CutVertex> points_;
  std::vector<Index> first_;  ///< first point of the edges from each vertex on
};

class Cutting {
 public:
  Cutting(const SourceMesh& mesh, const Partition& partition, std::span<const char> included, Poll poll)
      : mesh_(mesh), geometry_(mesh, partition), cutter_(geometry_, partition), included_(included), poll_(poll) {}

  CutEnvironment run() {
    findCells();
    cutAll();
    collectPoints();
    CutEnvironment result;
    placeVertices(result);
    joinPieces(result);
    return result;
  }

 private:
  /// A triangle that may have a part in several cells.
  struct Divided {
    Index triangle = -1;
    Index node = -1;
    std::size_t firstPiece = 0, pieceCount = 0;  ///< range in the pieces of its task
    std::size_t firstInside = 0, insideCount = 0;
    Index firstInsideVertex = -1;
  };
  /// The findings of a task, for triangles in order.
  struct Share {
    CutPieces pieces;
    std::vector<CutVertex> edgePoints;
    std::vector<CutVertex> inside;  ///< inner vertices of each triangle, distinct and by borders
  };

  void findCells() {
    const std::size_t count = mesh_.triangles.size();
    child_.resize(count);
    forTasks(count, kTrianglesPerTask, [&](std::size_t, std::size_t first, std::size_t last) {
      poll_();
      for (std::size_t t = first; t < last; ++t)
        child_[t] = !included_.empty() && included_[t] == 0 ? kLeftOut : cutter_.descend(static_cast<Index>(t));
    });
    for (std::size_t t = 0; t < count; ++t)
      if (child_[t] >= 0) {
        divided_.push_back({static_cast<Index>(t), child_[t]});
        child_[t] = static_cast<Index>(divided_.size()) - 1;
      }
  }

  void cutAll() {
    shares_.resize((divided_.size() + kCutTrianglesPerTask - 1) / kCutTrianglesPerTask);
    forTasks(divided_.size(), kCutTrianglesPerTask, [&](std::size_t task, std::size_t first, std::size_t last) {
      poll_();
      Share& share = shares_[task];
      for (std::size_t i = first; i < last; ++i) cutOne(divided_[i], share);
    });
  }

  void cutOne(Divided& d, Share& share) const {
    d.firstPiece = share.pieces.pieces.size();
    d.firstInside = share.inside.size();
    const std::size_t firstCorner = share.pieces.corners.size();
    cutter_.cut(d.triangle, d.node, share.pieces);
    for (std::size_t k = firstCorner; k < share.pieces.corners.size(); ++k) {
      const CutVertex& vertex = share.pieces.corners[k].vertex;
      if (vertex.kind == CutVertex::OnEdge) share.edgePoints.push_back(vertex);
      if (vertex.kind == CutVertex::Inside) share.inside.push_back(vertex);
    }
    const auto begin = share.inside.begin() + static_cast<std::ptrdiff_t>(d.firstInside);
    std::sort(begin, share.inside.end());
    share.inside.erase(std::unique(begin, share.inside.end()), share.inside.end());
    d.pieceCount = share.pieces.pieces.size() - d.firstPiece;
    d.insideCount = share.inside.size() - d.firstInside;
  }

  void collectPoints() {
    poll_();
    std::vector<CutVertex> points;
    for (const Share& share : shares_) points.insert(points.end(), share.edgePoints.begin(), share.edgePoints.end());
    edgePoints_.emplace(std::move(points), geometry_);
    auto vertex = static_cast<Index>(mesh_.vertices.size() + edgePoints_->points().size());
    for (Divided& d : divided_) {
      d.firstInsideVertex = vertex;
      vertex += static_cast<Index>(d.insideCount);
    }
  }

  void placeVertices(CutEnvironment& result) const {
    const std::size_t sources = mesh_.vertices.size();
    result.vertices.reserve(sources + edgePoints_->points().size());
    for (std::size_t v = 0; v < sources; ++v) result.vertices.push_back({CutVertex::Source, static_cast<Index>(v)});
    result.vertices.insert(result.vertices.end(), edgePoints_->points().begin(), edgePoints_->points().end());
    for (const Share& share : shares_)
      result.vertices.insert(result.vertices.end(), share.inside.begin(), share.inside.end());
    result.places = mesh_.vertices;
    result.places.resize(result.vertices.size());
    forTasks(result.vertices.size() - sources, kPlacesPerTask, [&](std::size_t, std::size_t first, std::size_t last) {
      poll_();
      for (std::size_t i = sources + first; i < sources + last; ++i)
        result.places[i] = geometry_.roundedPlace(result.vertices[i]);
    });
  }

  // A triangle in one cell can still have points on its edges: those of a neighbour that is cut there.
  void joinPieces(CutEnvironment& result) const {
    const std::size_t count = mesh_.triangles.size();
    std::vector<std::vector<CutTriangle>> parts((count + kTrianglesPerTask - 1) / kTrianglesPerTask);
    forTasks(count, kTrianglesPerTask, [&](std::size_t task, std::size_t first, std::size_t last) {
      poll_();
      ConvexTriangulation triangulation(result.places);
      parts[task].reserve(last - first);
      for (std::size_t t = first; t < last; ++t) {
        if (child_[t] == kLeftOut) continue;
        const auto triangle = static_cast<Index>(t);
        if (child_[t] >= 0)
          joinDivided(static_cast<std::size_t>(child_[t]), triangulation, parts[task]);
        else
          joinWhole(triangle, -1 - child_[t], triangulation, parts[task]);
      }
    });
    std::size_t total = 0;
    for (const auto& part : parts) total += part.size();
    result.triangles.reserve(total);
    for (const auto& part : parts) result.triangles.insert(result.triangles.end(), part.begin(), part.end());
  }

  void joinWhole(Index triangle, Index cell, ConvexTriangulation& triangulation, std::vector<CutTriangle>& out) const {
    const auto& f = mesh_.triangles[triangle];
    std::array<std::pair<Index, Index>, 3> ranges;
    bool hasPoints = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index u = f[k], v = f[k == 2 ? 0 : k + 1];
      ranges[k] = edgePoints_->range(std::min(u, v), std::max(u, v));
      hasPoints = hasPoints || ranges[k].first != ranges[k].second;
    }
    if (!hasPoints || mesh_.degenerate[triangle] != 0) {
      out.push_back({f, triangle, cell});
      return;
    }
    triangulation.start();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [first, last] = ranges[k];
      triangulation.addCorner(f[k]);
      addEdgePoints(first, last, f[k] < f[k == 2 ? 0 : k + 1], triangulation);
    }
    emit(triangle, cell, triangulation, out);
  }

  void joinDivided(std::size_t number, ConvexTriangulation& triangulation, std::vector<CutTriangle>& out) const {
    const Divided& d = divided_[number];
    const Share& share = shares_[number / kCutTrianglesPerTask];
    const auto& f = mesh_.triangles[d.triangle];
    std::array<std::pair<Index, Index>, 3> ranges;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index u = f[k], v = f[k == 2 ? 0 : k + 1];
      ranges[k] = edgePoints_->range(std::min(u, v), std::max(u, v));
    }
    const std::span<const CutVertex> inside(share.inside.data() + d.firstInside, d.insideCount);
    const auto numberOf = [&](const CutVertex& vertex) -> Index {
      if (vertex.kind == CutVertex::Source) return vertex.a;
      if (vertex.kind == CutVertex::Inside)
        return d.firstInsideVertex +
               static_cast<Index>(std::lower_bound(inside.begin(), inside.end(), vertex) - inside.begin());
      const auto& points = edgePoints_->points();
      for (const auto& [first, last] : ranges)
        if (first != last && points[first].a == vertex.a && points[first].b == vertex.b)
          return pointVertex(
              static_cast<Index>(std::find(points.begin() + first, points.begin() + last, vertex) - points.begin()));
      return -1;  // never: every point on an edge is in its range
    };
    for (std::size_t i = d.firstPiece; i < d.firstPiece + d.pieceCount; ++i) {
      const CutPieces::Piece& piece = share.pieces.pieces[i];
      const std::span<const PieceCorner> corners(share.pieces.corners.data() + piece.first, piece.count);
      triangulation.start();
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto& [vertex, side] = corners[k];
        const CutVertex& next = corners[k + 1 == corners.size() ? 0 : k + 1].vertex;
        triangulation.addCorner(numberOf(vertex));
        if (side.axis == PieceSide::kEdge) {
          const auto edge = static_cast<std::size_t>(side.number);
          const bool rises = f[edge] < f[edge == 2 ? 0 : edge + 1];
          addPointsBetween(numberOf(vertex), numberOf(next), ranges[edge], rises, triangulation);
        } else if (!inside.empty()) {
          addInsideBetween(vertex, next, side, inside, d.firstInsideVertex, triangulation);
        }
      }
      emit(d.triangle, piece.cell, triangulation, out);
    }
  }

  [[nodiscard]] Index pointVertex(Index point) const { return static_cast<Index>(mesh_.vertices.size()) + point; }

  void addEdgePoints(Index first, Index last, bool rises, ConvexTriangulation& triangulation) const {
    if (rises)
      for (Index i = first; i < last; ++i) triangulation.addPoint(pointVertex(i));
    else
      for (Index i = last; i-- > first;) triangulation.addPoint(pointVertex(i));
  }

  // The points between two vertices of one edge, given by number: its ends or points of its range.
  void addPointsBetween(Index from, Index to, std::pair<Index, Index> range, bool rises,
                        ConvexTriangulation& triangulation) const {
    if (!rises) std::swap(from, to);
    const Index start = pointVertex(0);
    const Index first = from < start ? range.first : from - start + 1;
    const Index last = to < start ? range.second : to - start;
    addEdgePoints(first, last, rises, triangulation);
  }

  // The side of a border that lies across a deeper cut (figure 13).
  void addInsideBetween(const CutVertex& from, const CutVertex& to, const PieceSide& side,
                        std::span<const CutVertex> inside, Index firstVertex,
                        ConvexTriangulation& triangulation) const {
    const int along = 1 - side.axis;
    // -1 or 1: between the two, which rise or fall from there
    const auto direction = [&](std::size_t i) {
      if (inside[i].borders[static_cast<std::size_t>(side.axis)] != side.number) return 0;
      const Index number = inside[i].borders[static_cast<std::size_t>(along)];
      const int start = geometry_.side(from, along, number);
      return start * geometry_.side(to, along, number) < 0 ? start : 0;
    };
    // Places on one border are in the order of the other border, which is the order of their coordinates.
    bool falls = false;
    for (std::size_t i = 0; i < inside.size() && !falls; ++i) {
      const int d = direction(i);
      if (d < 0) triangulation.addPoint(firstVertex + static_cast<Index>(i));
      falls = d > 0;
    }
    for (std::size_t i = inside.size(); falls && i-- > 0;)
      if (direction(i) > 0) triangulation.addPoint(firstVertex + static_cast<Index>(i));
  }

  void emit(Index triangle, Index cell, ConvexTriangulation& triangulation, std::vector<CutTriangle>& out) const {
    triangulation.finish([&](const std::array<Index, 3>& corners) { out.push_back({corners, triangle, cell}); });
  }

  const SourceMesh& mesh_;
  CutGeometry geometry_;
  TriangleCutter cutter_;
  std::span<const char> included_;
  Poll poll_;

  /// One entry per triangle: -1 - its cell, or its number among the divided ones, or kLeftOut.
  std::vector<Index> child_;
  std::vector<Divided> divided_;
  std::vector<Share> shares_;  ///< kCutTrianglesPerTask divided triangles each
  std::optional<EdgePoints> edgePoints_;
};

bool isSamePlace(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

// Vertices in one place become the first of them, and triangles that lose a corner by that go.
void weldRounded(CutEnvironment& cut, std::size_t sources, Poll poll) {
  poll();
  std::vector<Index> order(cut.places.size() - sources);
  std::iota(order.begin(), order.end(), static_cast<Index>(sources));
  sortBy(order, [&](Index a, Index b) {
    const Vec3 &p = cut.places[a], &q = cut.places[b];
    return isBefore(p, q) || (!isBefore(q, p) && a < b);
  });
  poll();
  std::vector<Index> becomes(order.size());
  Index first = -1;
  for (const Index v : order) {
    const auto begin = cut.places.begin(), end = begin + static_cast<std::ptrdiff_t>(sources);
    const auto it =
        std::lower_bound(begin, end, cut.places[v], [](const Vec3& a, const Vec3& b) { return isBefore(a, b); });
    if (it != end && isSamePlace(*it, cut.places[v]))
      becomes[v - sources] = static_cast<Index>(it - begin);
    else
      becomes[v - sources] = first >= 0 && isSamePlace(cut.places[first], cut.places[v]) ? first : v;
    if (becomes[v - sources] == v) first = v;
  }
  // degenerate source triangles may repeat a corner: those stay
  std::size_t kept = 0;
  for (CutTriangle t : cut.triangles) {
    bool moves = false;
    for (Index& v : t.corners)
      if (v >= static_cast<Index>(sources) && becomes[v - sources] != v) {
        v = becomes[v - sources];
        moves = true;
      }
    const auto& [a, b, c] = t.corners;
    if (!moves || (a != b && b != c && c != a)) cut.triangles[kept++] = t;
  }
  cut.closedTriangles = cut.triangles.size() - kept;
  cut.triangles.resize(kept);
}

}  // namespace

CutEnvironment cutEnvironment(const SourceMesh& mesh, const Partition& partition, std::span<const char> included,
                              bool round, Poll poll) {
  CutEnvironment result = Cutting(mesh, partition, included, poll).run();
  if (round) weldRounded(result, mesh.vertices.size(), poll);
  return result;
}

}  // namespace footfall::detail
