// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/clearance/clearance_clipper.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "core/base/index_and_box.hpp"
#include "core/base/poll.hpp"
#include "core/base/sorted_list.hpp"
#include "core/filters/clearance/crowding.hpp"

namespace footfall::detail {

ClearanceClipper::ClearanceClipper(const PlanKernel& kernel, std::function<bool(Index)> isFloor, Index level, Poll poll)
    : FaceCutter(kernel, poll), level_(level), candidates_(kernel, std::move(isFloor), level, poll) {}

const FaceCuts& ClearanceClipper::clip(Index face, const FaceCuts* earlier) {
  begin(face);
  if (earlier != nullptr) {
    if (earlier->removed) return *earlier;
    edgeWalls_ |= earlier->edgeWalls;
    std::vector<Index> points, lines;
    if (!earlier->segments.empty()) addCuts(*earlier, points, lines);
  }
  return cut(candidates_.find(face));
}

const FaceCuts& ClearanceClipper::clip(Index face, const std::vector<Index>& known, double knownHeight) {
  begin(face);
  return cut(candidates_.find(face, known, knownHeight));
}

FaceShare ClearanceClipper::clipShare(Index face, std::span<const CellSide> sides) {
  begin(face);
  sides_ = sides;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}};
  for (const auto& [border, keep] : sides) {
    const double coordinate = geometry_.kernel().borderCoordinate(border);
    (keep > 0 ? box.lower : box.upper)[border.a] = coordinate;
  }
  FaceShare share;
  const auto within = candidates_.findWithin(face, box);
  share.removed = candidates_.areKnownToCover() || !clipAll(within);
  if (!share.removed) collect(share);
  share.edgeWalls = edgeWalls_;
  share.dependsOnFloors = candidates_.dependsOnFloors();
  share.candidates = candidates();
  sides_ = {};
  return share;
}

std::vector<Index> candidatesOf(std::span<const FaceShare> shares) {
  std::vector<Index> found;
  for (const FaceShare& share : shares) found.insert(found.end(), share.candidates.begin(), share.candidates.end());
  sortOnce(found);
  return found;
}

FaceCuts ClearanceClipper::joinShares(Index face, std::span<const FaceShare> shares) {
  begin(face);
  FaceCuts cuts;
  int startWinding = 0;
  for (const FaceShare& share : shares) {
    startWinding += share.startWinding;
    cuts.removed = cuts.removed || share.removed;
    cuts.dependsOnFloors = cuts.dependsOnFloors || share.dependsOnFloors;
    edgeWalls_ |= share.edgeWalls;
  }
  // clip() does the same, and finds all of them together.
  if (!cuts.removed && startWinding != 0) {
    candidates_.findAmong(face, candidatesOf(shares));
    cuts.removed = candidates_.areKnownToCover();
    if (cuts.removed) cuts.dependsOnFloors = candidates_.dependsOnFloors();
  }
  if (cuts.removed) return cuts;
  std::vector<FaceShare::Piece> pieces;
  std::vector<Index> points, lines;
  for (const FaceShare& share : shares) {
    poll_();
    if (share.segments.empty() && share.pieces.empty()) {
      startWinding_ += share.startWinding;
      continue;
    }
    addCuts(share, points, lines);
    for (FaceShare::Piece piece : share.pieces) {
      CutSegment& s = piece.segment;
      if (s.from >= 0) s.from = points[s.from];
      if (s.to >= 0) s.to = points[s.to];
      s.line = lines[s.line];
      pieces.push_back(piece);
    }
  }
  const auto isSame = [](const FaceShare::Piece& x, const FaceShare::Piece& y) {
    return x.obstacle == y.obstacle && x.segment.line == y.segment.line;
  };
  std::sort(pieces.begin(), pieces.end(), [](const FaceShare::Piece& x, const FaceShare::Piece& y) {
    return x.obstacle != y.obstacle ? x.obstacle < y.obstacle : x.segment.line < y.segment.line;
  });
  for (std::size_t i = 0, j = 0; i < pieces.size(); i = j) {
    CutSegment whole = pieces[i].segment;
    for (j = i; j < pieces.size() && isSame(pieces[i], pieces[j]); ++j) {
      if (pieces[j].segment.from >= 0) whole.from = pieces[j].segment.from;
      if (pieces[j].segment.to >= 0) whole.to = pieces[j].segment.to;
    }
    if (whole.from < 0 || whole.to < 0) throw std::logic_error("a segment lost an end between two cells");
    addSegment(whole.from, whole.to, whole.line, 1, whole.winding, whole.wall);
  }
  collect(cuts);
  return cuts;
}

std::vector<Index> ClearanceClipper::candidates() const {
  std::vector<Index> result;
  result.reserve(candidates_.found().size());
  for (const ClearanceCandidate& c : candidates_.found()) result.push_back(c.obstacle);
  return result;
}

ExactFallbacks ClearanceClipper::fallbacks() const {
  ExactFallbacks sum = geometry_.fallbacks;
  sum += candidates_.fallbacks;
  return sum;
}

bool ClearanceClipper::clipAll(std::span<const ClearanceCandidate> candidates) {
  edges_.clear();
  if (!std::all_of(candidates.begin(), candidates.end(), [this](const ClearanceCandidate& c) { return clipOne(c); }))
    return false;
  clipEdges();
  return true;
}

bool ClearanceClipper::clipOne(const ClearanceCandidate& candidate) {
  if ((++polls_ & 255) == 0) poll_();
  const bool isWall = mesh_.facing[candidate.obstacle] == 0;
  if (isWall && isWallOfEdge(candidate)) return true;
  startGeometry();
  obstacle_ = candidate.obstacle;
  if (!isWall && candidate.takesAll()) {
    if (candidate.coversFace()) return false;
    if (sides_.empty()) {  // the shares of a face need the pieces of each obstacle
      addWholeArea(candidate);
      return true;
    }
  }
  if (!isWall) return !addArea(candidate);
  addWall(candidate);
  return true;
}

const FaceCuts& ClearanceClipper::cut(std::span<const ClearanceCandidate> candidates) {
  FaceCuts& cuts = cuts_;
  cuts.clear();
  cuts.removed =
      candidates_.areKnownToCover() || !(candidates_.areCrowd() ? clipCrowd(candidates) : clipAll(candidates));
  if (!cuts.removed) collect(cuts);
  cuts.dependsOnFloors = candidates_.dependsOnFloors();
  return cuts;
}

namespace {

/// Numbers of candidates: those that cover much before those that cover less, by sixteenths of powers of two; walls
/// come last.
std::vector<std::size_t> largestFirst(const SourceMesh& mesh, Index face,
                                      std::span<const ClearanceCandidate> candidates, const Poll& poll) {
  const Crowding crowding(mesh, face);
  std::map<std::uint64_t, std::vector<std::size_t>, std::greater<>> byArea;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if ((i & 1023) == 0) poll();
    const Index obstacle = candidates[i].obstacle;
    const double area = mesh.facing[obstacle] == 0 ? 0 : crowding.commonArea(obstacle);
    byArea[std::bit_cast<std::uint64_t>(area) >> 48U].push_back(i);
  }
  std::vector<std::size_t> order;
  for (const auto& [area, some] : byArea) order.insert(order.end(), some.begin(), some.end());
  return order;
}

}  // namespace

// Outlines of a crowd cross each other inside what is taken away anyway, as the square of its depth. So obstacles are
// left out that a grid proves to lie where others stay, and of the rest never more are cut at once than a share of what
// has been kept: of those only the outline goes on. In a crowd with floors in the face's own plane a search leaves out
// what only lies where others stay: what nothing then covers, and reaches no open square, is known to be covered.
bool ClearanceClipper::clipCrowd(std::span<const ClearanceCandidate> candidates) {
  constexpr std::size_t kAtOnce = 8;
  startGeometry();
  const OpenGrid* openSquares = candidates_.openSquares();
  OpenGrid grid = openSquares != nullptr ? *openSquares : OpenGrid(geometry_.kernel(), face_);
  std::vector<std::size_t> order = largestFirst(mesh_, face_, candidates, poll_), kept;
  for (const bool whole : {true, false})
    for (const std::size_t i : order) {
      if ((++polls_ & 255) == 0) poll_();
      const ClearanceCandidate& candidate = candidates[i];
      const bool isWall = mesh_.facing[candidate.obstacle] == 0;
      if ((!isWall && candidate.takesAll()) != whole) continue;
      const OpenGrid::Outline outline = outlineInPlan(geometry_.kernel(), candidate.obstacle, geometry_.origin());
      if (!(isWall && isWallOfEdge(candidate)) && !grid.mayReach(outline)) continue;
      kept.push_back(i);
      if (whole && openSquares == nullptr) grid.cover(outline);
    }
  if (grid.isClosed()) return false;

  bool isReduced = false;
  std::size_t added = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const ClearanceCandidate& candidate = candidates[kept[i]];
    if (crowdProgress && i % 64 == 0) crowdProgress(static_cast<double>(i) / static_cast<double>(kept.size()));
    if (isReduced && !grid.mayReach(outlineInPlan(geometry_.kernel(), candidate.obstacle, geometry_.origin())))
      continue;
    edges_.clear();
    if (!clipOne(candidate)) return false;
    clipEdges();
    if (++added < std::max(kAtOnce, segmentCount() / 16) || kept.size() - i <= kAtOnce) continue;
    keepOutline(grid);
    if (grid.isClosed()) return false;
    isReduced = true;
    added = 0;
  }
  if (openSquares == nullptr) return true;
  keepOutline(grid, openSquares);
  return !grid.isClosed();
}

// An edge that two obstacles share, lying on either side of it, is not needed: most edges vanish before anything is
// computed of them.
void ClearanceClipper::addWholeArea(const ClearanceCandidate& candidate) {
  if (candidate.coversStart()) ++startWinding_;
  const auto& o = mesh_.triangles[candidate.obstacle];
  const bool up = mesh_.facing[candidate.obstacle] > 0;
  for (int k = 0; k < 3; ++k) {
    const auto isOutside = [&](const ClearanceCandidate::Signs& sides) { return sides[k] <= 0 && sides[next(k)] <= 0; };
    if (std::any_of(candidate.sides.begin(), candidate.sides.end(), isOutside)) continue;
    auto from = static_cast<std::int8_t>(k), to = static_cast<std::int8_t>(next(k));
    int winding = up ? 1 : -1;
    if (mesh_.planIds[o[from]] > mesh_.planIds[o[to]]) {
      std::swap(from, to);
      winding = -winding;
    }
    const auto low = static_cast<std::uint64_t>(mesh_.planIds[o[from]]);
    edges_.push_back({low << 32U | static_cast<std::uint64_t>(mesh_.planIds[o[to]]), winding, from, to, &candidate});
  }
}

void ClearanceClipper::clipEdges() {
  std::sort(edges_.begin(), edges_.end(), [](const PlanEdge& x, const PlanEdge& y) { return x.ends < y.ends; });
  for (std::size_t i = 0, j = 0; i < edges_.size(); i = j) {
    const PlanEdge& edge = edges_[i];
    int winding = 0;
    for (j = i; j < edges_.size() && edges_[j].ends == edge.ends; ++j) winding += edges_[j].winding;
    if (winding == 0) continue;
    if ((++polls_ & 255) == 0) poll_();
    const auto& o = mesh_.triangles[edge.candidate->obstacle];
    const Index a = mesh_.planIds[o[edge.from]], b = mesh_.planIds[o[edge.to]];
    const Index line = geometry_.edgeLine(a, b);
    Place first{geometry_.sourcePoint(a), edge.from, edge.from};
    Place last{geometry_.sourcePoint(b), edge.to, edge.to};
    if (!clipToFace(line, first, last, *edge.candidate) || first.point == last.point ||
        (geometry_.border(first.point) & geometry_.border(last.point)) != 0)
      continue;
    addSegment(first.point, last.point, line, 1, winding, false);
  }
}

bool ClearanceClipper::addArea(const ClearanceCandidate& candidate) {
  const Index obstacle = candidate.obstacle;
  const auto& o = mesh_.triangles[obstacle];
  const auto& plan = mesh_.planIds;
  const bool up = mesh_.facing[obstacle] > 0;
  Polygon polygon;
  for (int j = 0; j < 3; ++j) {  // counter-clockwise in the plan
    const int i = up ? j : 2 - j;
    const int i2 = up ? next(i) : previous(i);
    const Index a = plan[o[i]], b = plan[o[i2]];
    polygon.push({geometry_.sourcePoint(a), geometry_.edgeLine(a, b), a < b ? 1 : -1, candidate.floor[i],
                  candidate.ceiling[i], false, static_cast<std::int8_t>(i)});
  }
  if (!candidate.coplanar) {
    clipToLevel(polygon, obstacle, false);
    if (polygon.size > 0) clipToLevel(polygon, obstacle, true);
  }
  for (int k = 0; k < 3 && polygon.size > 0; ++k) {
    const auto& s = candidate.sides[k];
    if (s[0] >= 0 && s[1] >= 0 && s[2] >= 0) {
      // inside already; only remember what lies on the edge
      const int zeros = (s[0] == 0) + (s[1] == 0) + (s[2] == 0);
      for (int i = 0; i < polygon.size; ++i) {
        const Index p = polygon.corners[i].point;
        if (zeros >= 2) {
          geometry_.sideOfEdge(k, p);
        } else if (zeros == 1 && geometry_[p].kind() == PlanPoint::Source) {
          for (int j = 0; j < 3; ++j)
            if (s[j] == 0 && geometry_[p].planId() == plan[o[j]])
              geometry_.addBorder(p, static_cast<std::uint8_t>(1 << k));
        }
      }
      continue;
    }
    clipToEdge(polygon, k, s);
  }
  if (polygon.size < 3) return false;
  if (isWhole(polygon)) return true;
  for (std::size_t side = 0; side < sides_.size() && polygon.size > 0; ++side)
    if (!isInside(side, obstacle)) clipToSide(polygon, side);
  addOutline(polygon);
  return false;
}

// Keeps what is above the floor, or below the clearance.
void ClearanceClipper::clipToLevel(Polygon& polygon, Index obstacle, bool ceiling) {
  const int keep = ceiling ? -1 : 1;
  const auto value = [&](const Corner& c) { return (ceiling ? c.ceiling : c.floor) * keep; };
  bool needed = false, any = false;
  for (int i = 0; i < polygon.size; ++i) {
    needed = needed || value(polygon.corners[i]) < 0;
    any = any || value(polygon.corners[i]) > 0;
  }
  if (!any) polygon.size = 0;
  if (!any || !needed) return;

  const Index level = ceiling ? level_ : 0;
  const Index trace = geometry_.line({PlanLine::Trace, obstacle, level});
  const auto& o = mesh_.triangles[obstacle];
  const auto crossingOf = [&](Index line) {
    const PlanLine l = geometry_.lineAt(line);
    for (int j = 0; j < 3; ++j) {
      const Index u = o[j], v = o[next(j)];
      const Index a = mesh_.planIds[u], b = mesh_.planIds[v];
      if (std::min(a, b) == l.a && std::max(a, b) == l.b)
        return geometry_.point(PlanPoint::edgePlane(u, v, face_, level));
    }
    return geometry_.crossing(line, trace);
  };
  Polygon result;
  for (int i = 0; i < polygon.size; ++i) {
    const Corner& c = polygon.corners[i];
    const int a = value(c), b = value(polygon.corners[(i + 1) % polygon.size]);
    if (a == 0 && b < 0)
      result.push({c.point, trace, keep, c.floor, c.ceiling, false, c.corner});
    else if (a >= 0)
      result.push(c);
    if (a * b < 0) {
      Corner cut{crossingOf(c.line), c.line, c.direction, ceiling ? 1 : 0, ceiling ? 0 : -1};
      if (a > 0) {
        cut.line = trace;
        cut.direction = keep;
      }
      result.push(cut);
    }
  }
  polygon = result;
}

int ClearanceClipper::sideOfCell(std::size_t side, Index point) {
  const int s = geometry_.side(sideLines_[side], point) * sides_[side].keep;
  if (s == 0) {
    if (cellBorders_.size() <= static_cast<std::size_t>(point)) cellBorders_.resize(geometry_.pointCount(), 0);
    cellBorders_[point] |= static_cast<std::uint8_t>(1U << side);
  }
  return s;
}

bool ClearanceClipper::isInside(std::size_t side, Index triangle) const {
  const auto& [border, keep] = sides_[side];
  const double coordinate = geometry_.kernel().borderCoordinate(border);
  for (const Index v : mesh_.triangles[triangle]) {
    const double c = border.a == 0 ? mesh_.vertices[v].x : mesh_.vertices[v].y;
    if (keep > 0 ? c <= coordinate : c >= coordinate) return false;
  }
  return true;
}

void ClearanceClipper::clipToSide(Polygon& polygon, std::size_t side) {
  std::array<int, kMostCorners> signs{};
  for (int i = 0; i < polygon.size; ++i) signs[i] = sideOfCell(side, polygon.corners[i].point);
  Corner made;
  made.line = sideLines_[side];
  made.direction = 1;
  made.cut = true;
  keepPositive(polygon, signs, made, [&](const Corner& c, const Corner& d) {
    const Index point = geometry_.crossing(c.line, sideLines_[side]);
    geometry_.addBorder(point, geometry_.border(c.point) & geometry_.border(d.point));
    return point;
  });
}

int ClearanceClipper::sideOfEdge(int k, const Place& place, const ClearanceCandidate& candidate) {
  if (place.from < 0) return geometry_.sideOfEdge(k, place.point);
  const int a = candidate.sides[k][place.from], b = candidate.sides[k][place.to];
  if (a * b < 0) return geometry_.sideOfEdge(k, place.point);
  if (a == 0 && b == 0) geometry_.addBorder(place.point, static_cast<std::uint8_t>(1 << k));
  return a != 0 ? a : b;
}

bool ClearanceClipper::clipToFace(Index line, Place& first, Place& last, const ClearanceCandidate& candidate) {
  for (int k = 0; k < 3; ++k) {
    const int a = sideOfEdge(k, first, candidate), b = sideOfEdge(k, last, candidate);
    if (a <= 0 && b <= 0 && !(a == 0 && b == 0)) return false;
    if (a * b >= 0) continue;
    const Index p = geometry_.crossing(line, k);
    // The same as in keepPositive(): when both ends lie on another edge, so does the part between them.
    const int both = geometry_.border(first.point) & geometry_.border(last.point);
    geometry_.addBorder(p, static_cast<std::uint8_t>(1 << k | both));
    (a < 0 ? first : last) = {p, -1, -1};
  }
  return true;
}

}  // namespace footfall::detail
