// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/face_triangulation.hpp"

#include <climits>
#include <stdexcept>

#include "core/base/index_and_box.hpp"
#include "core/exact/shape.hpp"

namespace footfall::detail {
namespace {

/// The corners of the first facet; FaceGeometry: those of the face are the points 0, 1, 2. In which order edges are
/// tried follows from it, and so do the triangles of results.
constexpr std::array<Index, 3> kFirstCorners{1, 2, 0};

[[noreturn]] void fail(const char* what) {
  throw std::logic_error(std::string("the triangulation of a floor triangle is inconsistent: ") + what);
}

void copyEdge(FaceTriangulation::Edges& to, int i, const FaceTriangulation::Edges& from, int j) {
  to.lines[i] = from.lines[j];
  to.windings[i] = from.windings[j];
  to.walls[i] = from.walls[j];
}

}  // namespace

void FaceTriangulation::poll() {
  if ((++polls_ & 127) == 0) poll_();  // A step on a wide grid can take a tenth of a millisecond.
}

void FaceTriangulation::growTables() {
  const std::size_t count = geometry_.pointCount();
  if (representative_.size() >= count) return;
  facets_.growVertices(count);
  representative_.resize(count, -1);
  sideStamp_.resize(count, -1);
  sideValue_.resize(count, 0);
}

void FaceTriangulation::start(std::span<const Index> points, unsigned edgeWalls) {
  facets_.start(kFirstCorners);
  inserter_.start();
  representative_.clear();
  sideStamp_.clear();
  sideValue_.clear();
  stamp_ = 0;
  growTables();
  for (Index k = 0; k < 3; ++k) representative_[k] = k;
  for (const Index p : points)
    if (representative_[p] < 0) representative_[p] = inserter_.insert(p);
  makeEdges(edgeWalls);
}

// Only the face's own edges are constrained yet: there facets have the numbers of those for neighbors.
void FaceTriangulation::makeEdges(unsigned edgeWalls) {
  edges_.assign(facets_.size(), {});
  isTouched_.assign(facets_.size(), inserter_.isDelaunay() ? 0 : 1);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Facet& c = facets()[i];
    if ((c.neighbors[0] | c.neighbors[1] | c.neighbors[2]) >= 0) continue;  // none is negative
    for (int k = 0; k < 3; ++k) {
      if (c.neighbors[k] >= 0) continue;
      edges_[i].lines[k] = ~c.neighbors[k];
      edges_[i].walls[k] = static_cast<std::uint8_t>(edgeWalls >> ~c.neighbors[k] & 1U);
    }
  }
}

void FaceTriangulation::splitEdge(Index facet, int k, Index point) {
  const Index other = facets_[facet].neighbors[k];
  const int j = other >= 0 ? neighborSlot(facets_[other], facet) : 0;
  facets_.splitEdge(facet, k, point);
  const auto splitHalf = [&](Index half, int edge) {
    const Edges old = edges_[half];
    Edges x, y;
    copyEdge(x, 0, old, edge);
    copyEdge(x, 2, old, previous(edge));
    copyEdge(y, 0, old, edge);
    copyEdge(y, 1, old, next(edge));
    edges_[half] = x;
    edges_.push_back(y);
  };
  const std::size_t added = edges_.size();
  splitHalf(facet, k);
  if (other >= 0) splitHalf(other, j);
  isTouched_.resize(edges_.size());
  touch(facet);
  if (other >= 0) touch(other);
  for (std::size_t i = added; i < edges_.size(); ++i) touch(static_cast<Index>(i));
}

void FaceTriangulation::touch(Index facet) {
  isTouched_[facet] = 1;
  for (const Index near : facets_[facet].neighbors)
    if (near >= 0) isTouched_[near] = 1;
}

void FaceTriangulation::flip(Index facet, int k) {
  const Index other = facets_[facet].neighbors[k];
  const int j = neighborSlot(facets_[other], facet);
  facets_.flip(facet, k);
  const Edges x = edges_[facet], y = edges_[other];
  Edges p, q;
  copyEdge(p, 0, y, next(j));
  copyEdge(p, 2, x, previous(k));
  copyEdge(q, 0, y, previous(j));
  copyEdge(q, 1, x, next(k));
  edges_[facet] = p;
  edges_[other] = q;
  touch(facet);
  touch(other);
}

// Flips an unconstrained edge when the opposite vertex seems to lie well inside the circumcircle (by rounded
// coordinates) and the four corners are strictly convex (exactly).
bool FaceTriangulation::flipIfBetter(Index facet, int k) {
  const Facet& x = facets_[facet];
  const Index other = x.neighbors[k];
  if (edges_[facet].lines[k] >= 0) return false;
  const Index a = x.corners[k], b = x.corners[next(k)], c = x.corners[previous(k)];
  const Index d = facets_[other].corners[previous(neighborSlot(facets_[other], facet))];
  const ApproximatePoint& pd = geometry_.approximate(d);
  const auto relative = [&](Index v) {
    const ApproximatePoint& p = geometry_.approximate(v);
    return std::array<double, 2>{p.x - pd.x, p.y - pd.y};
  };
  const std::array<double, 2> pa = relative(a), pb = relative(b), pc = relative(c);
  if (!isWellInsideCircle(pa, pb, pc)) return false;
  if (geometry_.orientation(c, a, d) <= 0 || geometry_.orientation(c, d, b) <= 0) return false;
  flip(facet, k);
  return true;
}

// The place where the edge runs from a to b; an edge of the face may run from b to a only. False where there is none.
// Walks around both ends take turns, so the time is bounded by the smaller degree: over all edges of a planar graph the
// smaller degrees add up to a multiple of their number, even where one vertex has an edge to every other one.
bool FaceTriangulation::findEdge(Index a, Index b, Place& place) const {
  // Around one vertex one way until the start or the border, then the other way.
  struct Walk {
    Index around, target, start, at;
    bool isForward = false;
  };
  std::array<Walk, 2> walks{Walk{a, b, facets_.facetOf(a), facets_.facetOf(a)},
                            Walk{b, a, facets_.facetOf(b), facets_.facetOf(b)}};
  for (;;) {
    for (Walk& walk : walks) {
      const Facet& c = facets_[walk.at];
      const int i = cornerOf(c, walk.around), before = previous(i);
      const bool isOut = c.corners[next(i)] == walk.target;
      if (isOut || c.corners[before] == walk.target) {
        place = {walk.at, isOut ? i : before};
        const Index beyond = c.neighbors[place.k];
        if (c.corners[place.k] != a && beyond >= 0) place = {beyond, neighborSlot(facets_[beyond], walk.at)};
        return true;
      }
      walk.at = c.neighbors[walk.isForward ? before : i];
      if (walk.at == walk.start) return false;
      if (walk.at >= 0) continue;
      if (walk.isForward) return false;
      walk.isForward = true;
      walk.at = facets_[walk.start].neighbors[previous(cornerOf(facets_[walk.start], walk.around))];
      if (walk.at < 0) return false;
    }
  }
}

void FaceTriangulation::mark(const Segment& segment, Place place, int sign) {
  const auto markOne = [&](Index facet, int k, int winding) {
    Edges& e = edges_[facet];
    if (e.lines[k] < 0) e.lines[k] = segment.line;
    e.windings[k] += winding;
    e.walls[k] |= static_cast<std::uint8_t>(segment.wall);
  };
  markOne(place.facet, place.k, sign * segment.winding);
  const Index other = facets_[place.facet].neighbors[place.k];
  if (other >= 0) markOne(other, neighborSlot(facets_[other], place.facet), -sign * segment.winding);
}

bool FaceTriangulation::markEdge(const Segment& segment, Index a, Index b) {
  Place place;
  if (!findEdge(a, b, place)) return false;
  mark(segment, place, facets_[place.facet].corners[place.k] == a ? 1 : -1);
  return true;
}

// The rounded places of its ends usually decide.
int FaceTriangulation::sideOfSegment(const Segment& segment, Index vertex) {
  const ApproximatePoint &p = geometry_.approximate(segment.from), &q = geometry_.approximate(segment.to),
                         &r = geometry_.approximate(vertex);
  const double turn = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  if (turn > geometry_.certainTurn()) return 1;
  if (turn < -geometry_.certainTurn()) return -1;
  if (sideStamp_[vertex] != stamp_) {
    sideStamp_[vertex] = stamp_;
    sideValue_[vertex] = static_cast<std::int8_t>(geometry_.sideNearby(segment.line, vertex) * segment.direction);
  }
  return sideValue_[vertex];
}

void FaceTriangulation::insertSegment(Index u, Index v, Index line, int direction, int winding, bool wall) {
  if (u == v) return;
  const Segment segment{u, v, line, direction, winding, wall};
  ++stamp_;
  sideStamp_[u] = sideStamp_[v] = stamp_;
  sideValue_[u] = sideValue_[v] = 0;
  while (u != v) {
    poll();
    if (markEdge(segment, u, v)) return;  // True of most; no side needs to be computed.
    u = advance(segment, u);
  }
}

// Looks around u for the edge along the segment, or for the facet that it enters.
Index FaceTriangulation::advance(const Segment& segment, Index u) {
  const Index start = facets_.facetOf(u);
  for (const bool forward : {true, false}) {
    Index facet = start;
    do {
      const Facet& c = facets_[facet];
      const int i = cornerOf(c, u);
      const Index a = c.corners[next(i)], b = c.corners[previous(i)];
      const int sideA = sideOfSegment(segment, a), sideB = sideOfSegment(segment, b);
      if (sideA == 0 && sideB > 0) {
        mark(segment, {facet, i}, 1);
        return a;
      }
      if (sideB == 0 && sideA < 0) {
        mark(segment, {facet, previous(i)}, -1);
        return b;
      }
      if (sideA < 0 && sideB > 0) {
        const Index w = cross(segment, u, facet);
        markEdge(segment, u, w);
        return w;
      }
      facet = c.neighbors[forward ? previous(i) : i];
    } while (facet >= 0 && facet != start);
    if (facet == start) break;
  }
  fail("a segment that leaves the face");
}

Index FaceTriangulation::splitAtCrossing(const Segment& segment, Index facet, int k) {
  const Index a = facets_[facet].corners[k], b = facets_[facet].corners[next(k)];
  const Index p = geometry_.crossing(segment.line, edges_[facet].lines[k]);
  growTables();
  if (representative_[p] >= 0) fail("a crossing that is a vertex elsewhere");
  representative_[p] = p;
  geometry_.addBorder(p, geometry_.border(a) & geometry_.border(b));
  splitEdge(facet, k, p);
  sideStamp_[p] = stamp_;
  sideValue_[p] = 0;
  return p;
}

Index FaceTriangulation::cross(const Segment& segment, Index u, Index facet) {
  crossed_.clear();
  int k = next(cornerOf(facets_[facet], u));  // opposite u
  Index target = -1;
  while (target < 0) {
    poll();
    if (edges_[facet].lines[k] >= 0) {
      target = splitAtCrossing(segment, facet, k);
      break;
    }
    const Facet& c = facets_[facet];
    crossed_.push_back({{c.corners[k], c.corners[next(k)]}});
    const Index other = c.neighbors[k];
    if (other < 0) fail("a segment that leaves the face");
    const int j = neighborSlot(facets_[other], facet);
    const Index apex = facets_[other].corners[previous(j)];
    const int s = sideOfSegment(segment, apex);
    if (s == 0) target = apex;
    facet = other;
    k = s > 0 ? next(j) : previous(j);
  }
  flipAway(segment);
  return target;
}

// Edges are looked at in turns until each is flipped away. One that could not be flipped is looked at again only when a
// facet beside it has changed: among points that are nearly on one line most edges are blocked for many turns. An edge
// is found from a facet that had it, or was beside one that had it, when it was last looked at. Flips move it to a
// neighbor; only rarely must it be looked for around its ends.
void FaceTriangulation::flipAway(const Segment& segment) {
  const auto findNear = [&](const Edge& e, Index near) {
    const auto edgeIn = [&](Index facet) {
      const auto& corners = facets_[facet].corners;
      for (int k = 0; k < 3; ++k)
        if ((corners[k] == e[0] && corners[next(k)] == e[1]) || (corners[k] == e[1] && corners[next(k)] == e[0]))
          return k;
      return -1;
    };
    Place place;
    if (near >= 0) {
      const std::array<Index, 3> neighbors = facets_[near].neighbors;
      for (const Index facet : {near, neighbors[0], neighbors[1], neighbors[2]}) {
        const int k = facet < 0 ? -1 : edgeIn(facet);
        if (k < 0) continue;
        const Index beyond = facets_[facet].neighbors[k];
        if (facets_[facet].corners[k] == e[0]) return Place{facet, k};
        return Place{beyond, neighborSlot(facets_[beyond], facet)};
      }
    }
    if (!findEdge(e[0], e[1], place)) fail("a lost edge");
    return place;
  };
  Index beside = -1;  // each of them is beside the one before
  for (Crossed& crossed : crossed_) beside = crossed.facet = findNear(crossed.edge, beside).facet;
  flips_.resize(facets_.size(), 0);
  while (!crossed_.empty()) {
    std::size_t kept = 0;
    bool isChanged = false;
    for (std::size_t i = 0; i < crossed_.size(); ++i) {
      poll();
      Crossed at = crossed_[i];
      if (at.isBlocked && flips_[at.facet] + flips_[at.other] == at.flips) {
        crossed_[kept++] = at;
        continue;
      }
      isChanged = true;
      const Edge e = at.edge;
      const Place place = findNear(e, at.facet);
      at.facet = place.facet;
      at.other = facets_[place.facet].neighbors[place.k];
      const Index r = facets_[place.facet].corners[previous(place.k)];
      const Index d = facets_[at.other].corners[previous(neighborSlot(facets_[at.other], place.facet))];
      at.isBlocked = geometry_.orientation(r, e[0], d) <= 0 || geometry_.orientation(r, d, e[1]) <= 0;
      if (!at.isBlocked) {
        flip(place.facet, place.k);
        ++flips_[at.facet];
        ++flips_[at.other];
        if (sideOfSegment(segment, r) * sideOfSegment(segment, d) >= 0) continue;
        at.edge = {r, d};
      }
      at.flips = flips_[at.facet] + flips_[at.other];
      crossed_[kept++] = at;
    }
    if (!isChanged) fail("edges that cannot be flipped");
    crossed_.resize(kept);
  }
}

void FaceTriangulation::dropConstraints() {
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    Edges& e = edges_[i];
    for (int k = 0; k < 3; ++k)
      if (e.lines[k] >= 0 && e.windings[k] == 0 && e.walls[k] == 0 && facets()[i].neighbors[k] >= 0) e.lines[k] = -1;
  }
}

void FaceTriangulation::improve(const std::vector<char>& isWanted) {
  std::size_t left = facets_.size() * 20;
  unsettled_.clear();
  for (std::size_t i = 0; i < facets_.size(); ++i)
    if (isWanted[i] != 0) unsettled_.push_back(static_cast<Index>(i));
  isUnsettled_ = isWanted;
  while (!unsettled_.empty() && left > 0) {
    poll();
    const Index facet = unsettled_.back();
    unsettled_.pop_back();
    isUnsettled_[facet] = 0;
    if (isTouched_[facet] == 0) continue;
    for (int k = 0; k < 3; ++k) {
      const Index other = facets_[facet].neighbors[k];
      if (!flipIfBetter(facet, k)) continue;
      --left;
      for (const Index changed : {facet, other}) {
        const auto enqueue = [&](Index c) {
          if (c >= 0 && isUnsettled_[c] == 0 && isWanted[c] != 0) {
            isUnsettled_[c] = 1;
            unsettled_.push_back(c);
          }
        };
        enqueue(changed);
        for (const Index near : facets_[changed].neighbors) enqueue(near);
      }
      break;
    }
  }
}

Index FaceTriangulation::startFacet() const {
  // Walk round corner 0, away from the face's last edge.
  Index facet = facets_.facetOf(0);
  for (;;) {
    const int k = cornerOf(facets_[facet], 0);
    const Index before = facets_[facet].neighbors[k];
    if (before < 0) return facet;
    facet = before;
  }
}

std::vector<int> FaceTriangulation::windingNumbers(int start) const {
  std::vector<int> winding(facets_.size(), INT_MIN);
  std::vector<Index> queue;
  const auto reach = [&](Index facet, int value) {
    if (winding[facet] == INT_MIN) {
      winding[facet] = value;
      queue.push_back(facet);
    } else if (winding[facet] != value) {
      fail("regions that do not close");
    }
  };
  queue.reserve(facets_.size());
  reach(startFacet(), start);
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const Facet& c = facets_[queue[head]];
    const Edges& e = edges_[queue[head]];
    const int value = winding[queue[head]];
    for (int k = 0; k < 3; ++k)
      if (c.neighbors[k] >= 0) reach(c.neighbors[k], value - e.windings[k]);
  }
  return winding;
}

}  // namespace footfall::detail
