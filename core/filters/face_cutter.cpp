// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/face_cutter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <type_traits>

#include "core/base/disjoint_sets.hpp"
#include "core/base/index_and_box.hpp"
#include "core/base/sorted_list.hpp"
#include "core/exact/insertion_order.hpp"

namespace footfall::detail {
namespace {

/// The position of polygons of the plan to one another, as far as doubles are certain.
enum class PlanRelation : std::uint8_t { Unknown, Apart, Inside };

/// The side of the line from a to b on which q lies: left (1), right (-1), or not certain (0).
int certainSide(const Vec3& a, const Vec3& b, const Vec3& q) {
  constexpr double kRounding = 0x1p-50;  // rounding of two differences, their product, and the difference of two
                                         // products
  const double left = (b.x - a.x) * (q.y - a.y), right = (b.y - a.y) * (q.x - a.x);
  const double bound = (std::fabs(left) + std::fabs(right)) * kRounding + std::numeric_limits<double>::min();
  return left - right > bound ? 1 : left - right < -bound ? -1 : 0;
}

// The position of a triangle to a convex polygon: in it or beside it; both counter-clockwise.
PlanRelation relate(const std::array<Vec3, 3>& triangle, std::span<const Index> polygon,
                    const std::vector<Vec3>& places) {
  bool isInside = true;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = places[polygon[i]], &b = places[polygon[(i + 1) % polygon.size()]];
    int least = 1, most = -1;
    for (const Vec3& q : triangle) {
      const int side = certainSide(a, b, q);
      least = std::min(least, side);
      most = std::max(most, side);
    }
    if (most < 0) return PlanRelation::Apart;
    isInside = isInside && least > 0;
  }
  if (isInside) return PlanRelation::Inside;
  for (int k = 0; k < 3; ++k)
    if (std::all_of(polygon.begin(), polygon.end(),
                    [&](Index p) { return certainSide(triangle[k], triangle[next(k)], places[p]) < 0; }))
      return PlanRelation::Apart;
  return PlanRelation::Unknown;
}

}  // namespace

FaceCuts FaceCutter::cut(Index face, std::span<const std::span<const Index>> polygons) {
  FaceCuts cuts;
  std::array<Vec3, 3> corners;
  for (int k = 0; k < 3; ++k) corners[k] = mesh_.scaled[mesh_.triangles[face][k]];
  unsure_.clear();
  for (const std::span<const Index> polygon : polygons) {
    const PlanRelation relation = relate(corners, polygon, mesh_.scaled);
    cuts.removed = relation == PlanRelation::Inside;
    if (cuts.removed) return cuts;
    if (relation == PlanRelation::Unknown) unsure_.push_back(polygon);
  }
  begin(face);
  cuts.edgeWalls = edgeWalls_;
  if (unsure_.empty()) return cuts;
  startGeometry();
  for (const std::span<const Index> polygon : unsure_) {
    if ((++polls_ & 255) == 0) poll_();
    if (addPolygon(polygon)) continue;
    cuts = {};
    cuts.removed = true;
    return cuts;
  }
  collect(cuts);
  return cuts;
}

void FaceCutter::begin(Index face) {
  face_ = face;
  started_ = false;
  segments_.clear();
  pieces_.clear();
  cellBorders_.clear();
  edgeWalls_ = 0;
  startWinding_ = 0;
  const auto& f = mesh_.triangles[face];
  for (int k = 0; k < 3; ++k)
    if (mesh_.hasObstacleEdge(f[k], f[next(k)])) edgeWalls_ |= static_cast<std::uint8_t>(1 << k);
}

void FaceCutter::startGeometry() {
  if (started_) return;
  started_ = true;
  geometry_.start(face_);
  sideLines_.clear();
  for (const CellSide& side : sides_) sideLines_.push_back(geometry_.line(side.border));
}

bool FaceCutter::isWhole(const Polygon& polygon) {
  return polygon.size == 3 && std::all_of(polygon.corners.begin(), polygon.corners.begin() + 3,
                                          [](const Corner& c) { return c.point < 3; });  // points 0, 1, 2
}

void FaceCutter::addOutline(const Polygon& polygon) {
  for (int i = 0; i < polygon.size; ++i) {
    const Corner &c = polygon.corners[i], &d = polygon.corners[(i + 1) % polygon.size];
    if (const std::uint8_t edges = geometry_.border(c.point) & geometry_.border(d.point); edges != 0) {
      // The face's edge 2 ends where its edge 0 starts.
      if ((edges & 1) != 0 && geometry_.sideOfEdge(2, c.point) == 0) ++startWinding_;
      continue;
    }
    addSegment(c.point, d.point, c.line, c.direction, 1, false, c.cut, d.cut);
  }
}

bool FaceCutter::addPolygon(std::span<const Index> planIds) {
  Polygon polygon;
  std::array<std::array<std::int8_t, kMostCorners>, 3> sides{};
  const auto& f = mesh_.triangles[face_];
  for (std::size_t i = 0; i < planIds.size(); ++i) {
    const Index a = planIds[i], b = planIds[(i + 1) % planIds.size()];
    const Index point = geometry_.sourcePoint(a);
    polygon.push({point, geometry_.edgeLine(a, b), a < b ? 1 : -1});
    polygon.corners[i].corner = static_cast<std::int8_t>(i);
    for (int k = 0; k < 3; ++k) {
      const int certain = certainSide(mesh_.scaled[f[k]], mesh_.scaled[f[next(k)]], mesh_.scaled[a]);
      sides[k][i] = static_cast<std::int8_t>(certain != 0 ? certain : geometry_.sideOfEdge(k, point));
    }
  }
  for (int k = 0; k < 3 && polygon.size > 0; ++k) clipToEdge(polygon, k, sides[k]);
  if (polygon.size < 3) return true;
  if (isWhole(polygon)) return false;
  addOutline(polygon);
  return true;
}

void FaceCutter::clipToEdge(Polygon& polygon, int k, std::span<const std::int8_t> sides) {
  const auto mask = static_cast<std::uint8_t>(1 << k);
  std::array<int, kMostCorners> signs{};
  for (int i = 0; i < polygon.size; ++i) {
    const Corner& c = polygon.corners[i];
    if (sides.empty() || c.corner < 0) {
      signs[i] = geometry_.sideOfEdge(k, c.point);
    } else {
      signs[i] = sides[c.corner];
      if (signs[i] == 0) geometry_.addBorder(c.point, mask);
    }
  }
  Corner made;
  made.line = k;  // FaceGeometry: the face's edges are the lines 0, 1, 2
  made.direction = geometry_.edgeDirection(k);
  keepPositive(polygon, signs, made, [&](const Corner& c, const Corner& d) {
    const Index point = geometry_.crossing(c.line, k);
    geometry_.addBorder(point, mask | (geometry_.border(c.point) & geometry_.border(d.point)));
    return point;
  });
}

std::uint8_t FaceCutter::cellBorders(Index point) const {
  return static_cast<std::size_t>(point) < cellBorders_.size() ? cellBorders_[point] : std::uint8_t{0};
}

void FaceCutter::addSegment(Index from, Index to, Index line, int direction, int winding, bool wall, bool cutFrom,
                            bool cutTo) {
  if (from == to || (!sides_.empty() && geometry_.lineAt(line).kind == PlanLine::Border)) return;  // or a seam
  CutSegment s{from, to, line, static_cast<std::int8_t>(direction), winding, wall};
  const auto turn = [&s] {
    std::swap(s.from, s.to);
    s.direction = static_cast<std::int8_t>(-s.direction);
    s.winding = -s.winding;
  };
  if (cutFrom || cutTo) {
    if (cutFrom) s.from = -1;
    if (cutTo) s.to = -1;
    if (direction < 0) turn();
    pieces_.push_back({obstacle_, s});
    return;
  }
  if (s.from > s.to) turn();
  segments_.push_back(s);
}

template <class Cuts>
void FaceCutter::addAllCuts(const Cuts& cuts, std::vector<Index>& points, std::vector<Index>& lines) {
  startGeometry();
  points.clear();
  lines.clear();
  for (std::size_t i = 0; i < cuts.points.size(); ++i) {
    points.push_back(geometry_.point(cuts.points[i]));
    geometry_.addBorder(points.back(), cuts.borders[i]);
  }
  for (const PlanLine& l : cuts.lines) lines.push_back(geometry_.line(l));
  for (const CutSegment& s : cuts.segments)
    addSegment(points[s.from], points[s.to], lines[s.line], s.direction, s.winding, s.wall);
  startWinding_ += cuts.startWinding;
}

bool FaceCutter::precedes(Index line, Index other) const {
  const PlanLine l = geometry_.lineAt(line), m = geometry_.lineAt(other);
  return std::tie(l.kind, l.a, l.b) < std::tie(m.kind, m.a, m.b);
}

// Two obstacles that share an edge and lie on either side of it in the plan cover it: their windings cancel.
// What lies on a cell's border may meet its opposite in another cell, so it is kept there.
void FaceCutter::cancelSegments() {
  sortSegments();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < segments_.size();) {
    CutSegment sum = segments_[i];
    std::size_t j = i + 1;
    for (; j < segments_.size() && segments_[j].from == sum.from && segments_[j].to == sum.to; ++j) {
      if (segments_[j].line != sum.line && precedes(segments_[j].line, sum.line)) {
        sum.line = segments_[j].line;
        sum.direction = segments_[j].direction;
      }
      sum.winding += segments_[j].winding;
      sum.wall = sum.wall || segments_[j].wall;
    }
    if (sum.winding != 0 || sum.wall || (cellBorders(sum.from) & cellBorders(sum.to)) != 0) segments_[kept++] = sum;
    i = j;
  }
  segments_.resize(kept);
}

OpenGrid::Outline FaceCutter::outlineOf(const FaceTriangulation::Facet& facet) const {
  const auto& [a, b, c] = facet.corners;
  return {geometry_.approximate(a), geometry_.approximate(b), geometry_.approximate(c)};
}

std::vector<char> FaceCutter::findOpen(const OpenGrid* openSquares) const {
  const auto& facets = triangulation_.facets();
  const std::vector<int> winding = triangulation_.windingNumbers(startWinding_);
  std::vector<char> isOpen(facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i) isOpen[i] = static_cast<char>(winding[i] == 0);
  if (openSquares == nullptr) return isOpen;
  DisjointSets parts(facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i)
    for (const Index other : facets[i].neighbors)
      if (other >= 0 && isOpen[i] != 0 && isOpen[other] != 0) parts.unite(static_cast<Index>(i), other);
  std::vector<char> isReached(facets.size(), 0);
  for (std::size_t i = 0; i < facets.size(); ++i)
    if (isOpen[i] != 0 && openSquares->mayReach(outlineOf(facets[i]))) isReached[parts.find(static_cast<Index>(i))] = 1;
  for (std::size_t i = 0; i < facets.size(); ++i)
    isOpen[i] = static_cast<char>(isOpen[i] != 0 && isReached[parts.find(static_cast<Index>(i))] != 0);
  return isOpen;
}

void FaceCutter::keepOutline(OpenGrid& grid, const OpenGrid* openSquares) {
  cancelSegments();
  std::vector<Index> points;
  points.reserve(2 * segments_.size());
  for (const CutSegment& s : segments_) points.insert(points.end(), {s.from, s.to});
  sortOnce(points);
  sortAlongCurve(geometry_, points);
  triangulation_.start(points);
  for (const CutSegment& s : segments_)
    triangulation_.insertSegment(triangulation_.vertexAt(s.from), triangulation_.vertexAt(s.to), s.line, s.direction,
                                 s.winding, s.wall);

  const auto& facets = triangulation_.facets();
  const std::vector<char> open = findOpen(openSquares);
  startWinding_ = open[triangulation_.startFacet()] != 0 ? 0 : 1;
  segments_.clear();
  grid.close();
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if ((++polls_ & 255) == 0) poll_();
    const FaceTriangulation::Facet& c = facets[i];
    const FaceTriangulation::Edges& edges = triangulation_.edges()[i];
    const bool isOpen = open[i] != 0;
    if (isOpen) grid.open(outlineOf(c));
    for (int k = 0; k < 3; ++k) {
      const Index other = c.neighbors[k];
      const bool isOpenBeyond = other >= 0 && open[other] != 0;
      bool isWall = edges.walls[k] != 0;
      if (isOpen) {  // The wall belongs to the open facet with the larger number, or to the one beside a covered facet.
        if (!isWall || (other >= 0 && !isOpenBeyond) || other > static_cast<Index>(i)) continue;
      } else {
        if (!isOpenBeyond) continue;
      }
      addSegment(c.corners[k], c.corners[next(k)], edges.lines[k],
                 geometry_.side(edges.lines[k], c.corners[previous(k)]), isOpen ? 0 : 1, isWall);
    }
  }
}

// Sorts by their ends. Giants have tens of thousands of segments: those are counted into place, by one end and then the
// other.
void FaceCutter::sortSegments() {
  constexpr std::size_t kFewSegments = 256;
  if (segments_.size() < kFewSegments) {
    std::sort(segments_.begin(), segments_.end(), [](const CutSegment& a, const CutSegment& b) {
      return a.from != b.from ? a.from < b.from : a.to < b.to;
    });
    return;
  }
  sorted_.resize(segments_.size());
  for (const auto end : {&CutSegment::to, &CutSegment::from}) {
    poll_();
    counts_.assign(geometry_.pointCount() + 1, 0);
    for (const CutSegment& s : segments_) ++counts_[s.*end + 1];
    std::partial_sum(counts_.begin(), counts_.end(), counts_.begin());
    for (const CutSegment& s : segments_) sorted_[counts_[s.*end]++] = s;
    segments_.swap(sorted_);
  }
}

// Sorts by an order that depends only on what they are: points along a curve, segments by their points, lines as they
// come.
template <class Cuts>
void FaceCutter::collectAll(Cuts& cuts) {
  if (segments_.empty() && pieces_.empty()) return;
  const std::size_t lineSlots = geometry_.pointCount();
  numbers_.assign(lineSlots + geometry_.lineCount(), -1);
  std::vector<Index>& order = order_;
  order.clear();
  const auto need = [&](Index point) {
    if (numbers_[point] >= 0) return;
    numbers_[point] = 0;
    order.push_back(point);
  };
  for (const CutSegment& s : segments_) {
    need(s.from);
    need(s.to);
  }
  constexpr bool kIsShare = std::is_same_v<Cuts, FaceShare>;
  if constexpr (kIsShare) {
    for (const FaceShare::Piece& piece : pieces_)
      for (const Index end : {piece.segment.from, piece.segment.to})
        if (end >= 0) need(end);
  } else {
    sortAlongCurve(geometry_, order);
  }
  cuts.points.reserve(order.size());
  cuts.borders.reserve(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    numbers_[order[i]] = static_cast<Index>(i);
    cuts.points.push_back(geometry_[order[i]]);
    cuts.borders.push_back(geometry_.border(order[i]));
  }
  for (CutSegment& s : segments_) {
    s.from = numbers_[s.from];
    s.to = numbers_[s.to];
    if (s.from < s.to) continue;
    std::swap(s.from, s.to);
    s.direction = static_cast<std::int8_t>(-s.direction);
    s.winding = -s.winding;
  }
  if (!kIsShare) sortSegments();
  const auto numberLine = [&](Index& line) {
    Index& number = numbers_[lineSlots + line];
    if (number < 0) {
      number = static_cast<Index>(cuts.lines.size());
      cuts.lines.push_back(geometry_.lineAt(line));
    }
    line = number;
  };
  for (CutSegment& s : segments_) numberLine(s.line);
  cuts.segments.assign(segments_.begin(), segments_.end());
  if constexpr (kIsShare) {
    for (FaceShare::Piece& piece : pieces_) {
      for (Index* end : {&piece.segment.from, &piece.segment.to})
        if (*end >= 0) *end = numbers_[*end];
      numberLine(piece.segment.line);
    }
    cuts.pieces = std::move(pieces_);
    pieces_.clear();
  }
}

std::vector<ApproximatePoint> FaceCutter::placesOfPoints() const {
  std::vector<ApproximatePoint> places;
  places.reserve(order_.size());
  for (const Index p : order_) places.push_back(geometry_.approximate(p));
  return places;
}

void FaceCutter::addCuts(const FaceCuts& cuts, std::vector<Index>& points, std::vector<Index>& lines) {
  addAllCuts(cuts, points, lines);
}

void FaceCutter::addCuts(const FaceShare& cuts, std::vector<Index>& points, std::vector<Index>& lines) {
  addAllCuts(cuts, points, lines);
}

void FaceCutter::collect(FaceCuts& cuts) {
  cancelSegments();
  cuts.removed = segments_.empty() && startWinding_ != 0;
  cuts.edgeWalls = cuts.removed ? std::uint8_t{0} : edgeWalls_;
  if (cuts.removed) return;
  cuts.startWinding = startWinding_;
  collectAll(cuts);
}

void FaceCutter::collect(FaceShare& cuts) {
  cancelSegments();
  cuts.edgeWalls = edgeWalls_;
  cuts.startWinding = startWinding_;
  collectAll(cuts);
}

}  // namespace footfall::detail
