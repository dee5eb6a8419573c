// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/face_triangulation.hpp"

#include <algorithm>
#include <climits>
#include <numeric>
#include <stdexcept>

#include "core/base/geometry.hpp"
#include "core/exact/filtered_turn.hpp"
#include "core/exact/shape.hpp"

namespace footfall::detail {
namespace {

int cornerOf(const FaceTriangulation::Cell& cell, Index vertex) {
  return cell.corners[0] == vertex ? 0 : cell.corners[1] == vertex ? 1 : 2;
}

int neighborSlot(const FaceTriangulation::Cell& cell, Index neighbor) {
  return cell.neighbors[0] == neighbor ? 0 : cell.neighbors[1] == neighbor ? 1 : 2;
}

/// The corners of the first cell; FaceGeometry: those of the face are the points 0, 1, 2. In which order edges are
/// tried follows from it, and so do the triangles of results.
constexpr std::array<Index, 3> kFirstCorners{1, 2, 0};

[[noreturn]] void fail(const char* what) {
  throw std::logic_error(std::string("the triangulation of a floor triangle is inconsistent: ") + what);
}

}  // namespace

void FaceTriangulation::poll() {
  if ((++polls_ & 127) == 0) poll_();  // on a wide grid a step can take a tenth of a millisecond
}

void FaceTriangulation::growTables() {
  const std::size_t count = geometry_.pointCount();
  if (cellOf_.size() < count) {
    cellOf_.resize(count, -1);
    representative_.resize(count, -1);
    sideStamp_.resize(count, -1);
    sideValue_.resize(count, 0);
  }
}

void FaceTriangulation::start() {
  cells_.clear();
  cellOf_.clear();
  representative_.clear();
  sideStamp_.clear();
  sideValue_.clear();
  stamp_ = 0;
  hint_ = 0;
  random_ = 1;
  growTables();
  Cell cell;
  for (int k = 0; k < 3; ++k) {
    cell.corners[k] = kFirstCorners[k];
    cell.lines[k] = kFirstCorners[k];  // the face's edge from that corner
    cellOf_[k] = 0;
    representative_[k] = k;
  }
  cells_.push_back(cell);
}

void FaceTriangulation::markEdgeWall(int k) { cells_[0].walls[cornerOf(cells_[0], k)] = 1; }

void FaceTriangulation::replaceNeighbor(Index cell, Index from, Index to) {
  if (cell < 0) return;
  cells_[cell].neighbors[neighborSlot(cells_[cell], from)] = to;
}

void FaceTriangulation::copyEdge(Cell& to, int i, const Cell& from, int j) {
  to.neighbors[i] = from.neighbors[j];
  to.lines[i] = from.lines[j];
  to.windings[i] = from.windings[j];
  to.walls[i] = from.walls[j];
}

void FaceTriangulation::splitCell(Index cell, Index point) {
  const Cell old = cells_[cell];
  const std::array<Index, 3> ids{cell, static_cast<Index>(cells_.size()), static_cast<Index>(cells_.size()) + 1};
  cells_.resize(cells_.size() + 2);
  for (int i = 0; i < 3; ++i) {
    Cell part;
    part.corners = {old.corners[i], old.corners[next(i)], point};
    copyEdge(part, 0, old, i);
    part.neighbors[1] = ids[next(i)];
    part.neighbors[2] = ids[previous(i)];
    cells_[ids[i]] = part;
    if (i > 0) replaceNeighbor(old.neighbors[i], cell, ids[i]);
    cellOf_[part.corners[0]] = ids[i];
    stack_.push_back({ids[i], point});
  }
  cellOf_[point] = cell;
}

// Splits a cell at a point on its edge k into two; returns the second, which holds the edge's end.
Index FaceTriangulation::splitHalf(Index cell, int k, Index point) {
  const Cell old = cells_[cell];
  const auto second = static_cast<Index>(cells_.size());
  const Index a = old.corners[k], b = old.corners[next(k)], c = old.corners[previous(k)];
  Cell x, y;
  x.corners = {a, point, c};
  copyEdge(x, 0, old, k);
  x.neighbors[1] = second;
  copyEdge(x, 2, old, previous(k));
  y.corners = {point, b, c};
  copyEdge(y, 0, old, k);
  copyEdge(y, 1, old, next(k));
  y.neighbors[2] = cell;
  cells_[cell] = x;
  cells_.push_back(y);
  replaceNeighbor(old.neighbors[next(k)], cell, second);
  cellOf_[c] = cell;
  cellOf_[a] = cell;
  cellOf_[b] = second;
  cellOf_[point] = cell;
  stack_.push_back({cell, point});
  stack_.push_back({second, point});
  return second;
}

void FaceTriangulation::splitEdge(Index cell, int k, Index point) {
  const Index other = cells_[cell].neighbors[k];
  const int j = other >= 0 ? neighborSlot(cells_[other], cell) : 0;
  const Index cellEnd = splitHalf(cell, k, point);
  if (other < 0) return;
  const Index otherEnd = splitHalf(other, j, point);
  // both halves were split from their own start, which is the other one's end
  cells_[cell].neighbors[0] = otherEnd;
  cells_[otherEnd].neighbors[0] = cell;
  cells_[cellEnd].neighbors[0] = other;
  cells_[other].neighbors[0] = cellEnd;
}

void FaceTriangulation::flip(Index cell, int k) {
  const Cell x = cells_[cell];
  const Index other = x.neighbors[k];
  const Cell y = cells_[other];
  const int j = neighborSlot(y, cell);
  const Index a = x.corners[k], b = x.corners[next(k)], c = x.corners[previous(k)], d = y.corners[previous(j)];
  Cell p, q;
  p.corners = {a, d, c};
  copyEdge(p, 0, y, next(j));
  p.neighbors[1] = other;
  copyEdge(p, 2, x, previous(k));
  q.corners = {d, b, c};
  copyEdge(q, 0, y, previous(j));
  copyEdge(q, 1, x, next(k));
  q.neighbors[2] = cell;
  cells_[cell] = p;
  cells_[other] = q;
  replaceNeighbor(p.neighbors[0], other, cell);
  replaceNeighbor(q.neighbors[1], cell, other);
  cellOf_[c] = cell;
  cellOf_[a] = cell;
  cellOf_[d] = cell;
  cellOf_[b] = other;
}

// Flips an unconstrained edge when the opposite vertex seems to lie well inside the circumcircle (by rounded
// coordinates) and the four corners are strictly convex (exactly).
bool FaceTriangulation::flipIfBetter(Index cell, int k) {
  const Cell& x = cells_[cell];
  const Index other = x.neighbors[k];
  if (other < 0 || x.lines[k] >= 0) return false;
  const Index a = x.corners[k], b = x.corners[next(k)], c = x.corners[previous(k)];
  const Index d = cells_[other].corners[previous(neighborSlot(cells_[other], cell))];
  const ApproximatePoint& pd = geometry_.approximate(d);
  const auto relative = [&](Index v) {
    const ApproximatePoint& p = geometry_.approximate(v);
    return std::array<double, 2>{p.x - pd.x, p.y - pd.y};
  };
  const std::array<double, 2> pa = relative(a), pb = relative(b), pc = relative(c);
  if (!isWellInsideCircle(pa, pb, pc)) return false;
  // The same coordinates mostly tell for certain.
  const double slack = geometry_.kernel().sign().slack;
  const auto error = [&](Index v) { return geometry_.approximate(v).error + pd.error; };
  const double errorA = error(a), errorB = error(b), errorC = error(c);
  if (filteredTurn(pc, errorC, pa, errorA, slack) != 1 && geometry_.orientation(c, a, d) <= 0) return false;
  if (filteredTurn(pb, errorB, pc, errorC, slack) != 1 && geometry_.orientation(c, d, b) <= 0) return false;
  flip(cell, k);
  return true;
}

void FaceTriangulation::legalize() {
  constexpr int kMostFlips = 500;
  int flips = 0;
  while (!stack_.empty()) {
    const auto [cell, point] = stack_.back();
    stack_.pop_back();
    if (flips >= kMostFlips) continue;
    const Cell& c = cells_[cell];
    const int corner = cornerOf(c, point), k = next(corner);
    if (c.corners[corner] != point) continue;
    const Index other = c.neighbors[k];
    if (flipIfBetter(cell, k)) {
      ++flips;
      stack_.push_back({cell, point});
      stack_.push_back({other, point});
    }
  }
}

// The cell that holds the point in its closure. zeros: 0 inside, 1 on edge k, 2 on corner k.
Index FaceTriangulation::locate(Index point, int& zeros, int& k) {
  Index current = hint_, last = -1;
  for (;;) {
    poll();
    random_ = random_ * 1664525U + 1013904223U;
    const int first = static_cast<int>((random_ >> 16) % 3);
    std::array<int, 2> zero{};
    zeros = 0;
    bool moved = false;
    for (int i = 0; i < 3; ++i) {
      const int edge = (first + i) % 3;
      const Cell& c = cells_[current];
      if (last >= 0 && c.neighbors[edge] == last) continue;
      const int s = geometry_.orientation(c.corners[edge], c.corners[next(edge)], point);
      if (s < 0) {
        if (c.neighbors[edge] < 0) fail("a point outside the face");
        last = current;
        current = c.neighbors[edge];
        moved = true;
        break;
      }
      if (s == 0 && zeros < 2) zero[zeros++] = edge;
    }
    if (moved) continue;
    if (zeros == 1) k = zero[0];
    if (zeros == 2) k = next(zero[0]) == zero[1] ? zero[1] : zero[0];  // where the second of both begins
    return current;
  }
}

Index FaceTriangulation::insertPoint(Index point) {
  if (static_cast<std::size_t>(point) >= representative_.size()) growTables();
  if (representative_[point] >= 0) return representative_[point];
  int zeros = 0, k = 0;
  const Index cell = locate(point, zeros, k);
  if (zeros == 2) {
    const Index vertex = cells_[cell].corners[k];
    representative_[point] = vertex;
    geometry_.addBorder(vertex, geometry_.border(point));
    return vertex;
  }
  representative_[point] = point;
  if (zeros == 0)
    splitCell(cell, point);
  else
    splitEdge(cell, k, point);
  legalize();
  hint_ = cellOf_[point];
  return point;
}

// The cell in which the edge runs from a to b, and its number there. Else a cell at a: at the border of the face the
// one whose last edge at a has no cell on its other side.
bool FaceTriangulation::findEdge(Index a, Index b, Index& cell, int& k) const {
  const Index start = cellOf_[a];
  // around a one way until the start or the border, then the other way
  for (const bool forward : {false, true}) {
    for (Index at = start;;) {
      cell = at;
      const Cell& c = cells_[cell];
      const int i = cornerOf(c, a);
      if (c.corners[next(i)] == b) {
        k = i;
        return true;
      }
      at = c.neighbors[forward ? previous(i) : i];
      if (at == start) return false;
      if (at < 0) break;
    }
  }
  return false;
}

bool FaceTriangulation::markEdge(Index a, Index b, Index line, int winding, bool wall) {
  Index cell = -1;
  int k = 0;
  const auto mark = [&](int sign) {
    Cell& c = cells_[cell];
    if (c.lines[k] < 0) c.lines[k] = line;
    c.windings[k] += sign * winding;
    c.walls[k] |= static_cast<std::uint8_t>(wall);
  };
  int sign = 0;
  if (findEdge(a, b, cell, k)) {
    sign = 1;
  } else {  // an edge of the face may run the other way only, in the last cell round a
    const int i = cornerOf(cells_[cell], a);
    if (cells_[cell].corners[previous(i)] != b) return false;
    k = previous(i);
    sign = -1;
  }
  mark(sign);
  const Index other = cells_[cell].neighbors[k];
  if (other < 0) return true;
  k = neighborSlot(cells_[other], cell);
  cell = other;
  mark(-sign);
  return true;
}

int FaceTriangulation::sideOfSegment(Index line, int direction, Index vertex) {
  if (sideStamp_[vertex] != stamp_) {
    sideStamp_[vertex] = stamp_;
    sideValue_[vertex] = static_cast<std::int8_t>(geometry_.side(line, vertex) * direction);
  }
  return sideValue_[vertex];
}

void FaceTriangulation::insertSegment(Index u, Index v, Index line, int direction, int winding, bool wall) {
  if (u == v) return;
  ++stamp_;
  sideStamp_[u] = sideStamp_[v] = stamp_;
  sideValue_[u] = sideValue_[v] = 0;
  while (u != v) {
    poll();
    if (markEdge(u, v, line, winding, wall)) return;  // as most are, no side needs to be asked
    const Index w = advance(u, line, direction);
    markEdge(u, w, line, winding, wall);
    u = w;
  }
}

Index FaceTriangulation::advance(Index u, Index line, int direction) {
  // Look around u for the edge along the segment, or for the cell that it enters.
  const Index start = cellOf_[u];
  Index entered = -1;
  for (const bool forward : {true, false}) {
    Index cell = start;
    do {
      const Cell& c = cells_[cell];
      const int i = cornerOf(c, u);
      const Index a = c.corners[next(i)], b = c.corners[previous(i)];
      const int sideA = sideOfSegment(line, direction, a), sideB = sideOfSegment(line, direction, b);
      if (sideA == 0 && sideB > 0) return a;
      if (sideB == 0 && sideA < 0) return b;
      if (sideA < 0 && sideB > 0) {
        entered = cell;
        break;
      }
      cell = c.neighbors[forward ? previous(i) : i];
    } while (cell >= 0 && cell != start);
    if (entered >= 0 || cell == start) break;
  }
  if (entered < 0) fail("a segment that leaves the face");

  crossed_.clear();
  Index cell = entered;
  int k = next(cornerOf(cells_[cell], u));  // opposite u
  Index target = -1;
  while (target < 0) {
    poll();
    const Cell& c = cells_[cell];
    const Index a = c.corners[k], b = c.corners[next(k)];
    if (c.lines[k] >= 0) {
      const Index p = geometry_.crossing(line, c.lines[k]);
      growTables();
      if (representative_[p] >= 0) fail("a crossing that is a vertex elsewhere");
      representative_[p] = p;
      geometry_.addBorder(p, geometry_.border(a) & geometry_.border(b));
      splitEdge(cell, k, p);
      stack_.clear();
      sideStamp_[p] = stamp_;
      sideValue_[p] = 0;
      target = p;
      break;
    }
    crossed_.push_back({a, b});
    const Index other = c.neighbors[k];
    if (other < 0) fail("a segment that leaves the face");
    const int j = neighborSlot(cells_[other], cell);
    const Index apex = cells_[other].corners[previous(j)];
    const int s = sideOfSegment(line, direction, apex);
    if (s == 0) {
      target = apex;
      break;
    }
    cell = other;
    k = s > 0 ? next(j) : previous(j);
  }
  flipAway(line, direction);
  return target;
}

void FaceTriangulation::flipAway(Index line, int direction) {
  for (std::size_t head = 0; head < crossed_.size(); ++head) {
    poll();
    Edge e = crossed_[head];
    Index cell = -1;
    int k = 0;
    if (!findEdge(e[0], e[1], cell, k)) {
      std::swap(e[0], e[1]);
      if (!findEdge(e[0], e[1], cell, k)) fail("a lost edge");
    }
    const Index other = cells_[cell].neighbors[k];
    const Index r = cells_[cell].corners[previous(k)];
    const Index d = cells_[other].corners[previous(neighborSlot(cells_[other], cell))];
    if (geometry_.orientation(r, e[0], d) > 0 && geometry_.orientation(r, d, e[1]) > 0) {
      flip(cell, k);
      if (sideOfSegment(line, direction, r) * sideOfSegment(line, direction, d) < 0) crossed_.push_back({r, d});
    } else {
      crossed_.push_back(e);
    }
  }
}

void FaceTriangulation::dropConstraints() {
  for (Cell& c : cells_)
    for (int k = 0; k < 3; ++k)
      if (c.neighbors[k] >= 0 && c.lines[k] >= 0 && c.windings[k] == 0 && c.walls[k] == 0) c.lines[k] = -1;
}

void FaceTriangulation::improve(const std::vector<char>& isWanted) {
  std::size_t left = cells_.size() * 20;
  unsettled_.clear();
  for (std::size_t i = 0; i < cells_.size(); ++i)
    if (isWanted[i] != 0) unsettled_.push_back(static_cast<Index>(i));
  isUnsettled_ = isWanted;
  while (!unsettled_.empty() && left > 0) {
    poll();
    const Index cell = unsettled_.back();
    unsettled_.pop_back();
    isUnsettled_[cell] = 0;
    for (int k = 0; k < 3; ++k) {
      const Index other = cells_[cell].neighbors[k];
      if (!flipIfBetter(cell, k)) continue;
      --left;
      for (const Index changed : {cell, other}) {
        const auto enqueue = [&](Index c) {
          if (c >= 0 && isUnsettled_[c] == 0 && isWanted[c] != 0) {
            isUnsettled_[c] = 1;
            unsettled_.push_back(c);
          }
        };
        enqueue(changed);
        for (const Index near : cells_[changed].neighbors) enqueue(near);
      }
      break;
    }
  }
}

Index FaceTriangulation::startCell() const {
  // Round corner 0, away from the face's last edge.
  Index cell = cellOf_[0];
  for (;;) {
    const int k = cornerOf(cells_[cell], 0);
    const Index before = cells_[cell].neighbors[k];
    if (before < 0) return cell;
    cell = before;
  }
}

std::vector<int> FaceTriangulation::windingNumbers(int start) const {
  std::vector<int> winding(cells_.size(), INT_MIN);
  std::vector<Index> queue;
  const auto reach = [&](Index cell, int value) {
    if (winding[cell] == INT_MIN) {
      winding[cell] = value;
      queue.push_back(cell);
    } else if (winding[cell] != value) {
      fail("regions that do not close");
    }
  };
  queue.reserve(cells_.size());
  reach(startCell(), start);
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const Cell& c = cells_[queue[head]];
    const int value = winding[queue[head]];
    for (int k = 0; k < 3; ++k)
      if (c.neighbors[k] >= 0) reach(c.neighbors[k], value - c.windings[k]);
  }
  return winding;
}

}  // namespace footfall::detail
