// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

namespace footfall::reference {
namespace {

Segment2 planEdge(const Piece& piece, std::size_t k) {
  return {planOf(piece.corners[k]), planOf(piece.corners[(k + 1) % 3])};
}

Linear planeOf(const Piece& piece) { return *planeThrough(piece.corners); }

std::size_t find(std::vector<std::size_t>& parents, std::size_t i) {
  while (parents[i] != i) i = parents[i];
  return i;
}

double lengthOf(const std::array<Point3, 2>& edge) {
  const Rational dx = edge[1].x - edge[0].x, dy = edge[1].y - edge[0].y, dz = edge[1].z - edge[0].z;
  return std::sqrt(Rational(dx * dx + dy * dy + dz * dz).get_d());
}

const Region* regionOf(const WalkableArea& area, std::uint32_t source) {
  for (const Region& region : area.regions)
    if (std::find(region.floors.begin(), region.floors.end(), source) != region.floors.end()) return &region;
  return nullptr;
}

bool contains(const Polygon& outer, const Polygon& inner) {
  for (std::size_t k = 0; k < outer.size(); ++k) {
    for (const Point2& p : inner)
      if (turn(outer[k], outer[(k + 1) % outer.size()], p) < 0) return false;
  }
  return true;
}

}  // namespace

std::string toText(const Point3& p) { return "(" + p.x.get_str() + " " + p.y.get_str() + " " + p.z.get_str() + ")"; }

std::string toText(const Piece& piece) {
  return toText(piece.corners[0]) + " " + toText(piece.corners[1]) + " " + toText(piece.corners[2]) +
         " of input triangle " + std::to_string(piece.source);
}

std::vector<Piece> toPieces(const std::vector<ExactTriangle>& triangles) {
  std::vector<Piece> pieces;
  const auto number = [](const std::string& text) {
    Rational value(text);
    value.canonicalize();
    return value;
  };
  for (const ExactTriangle& t : triangles) {
    Piece piece;
    for (std::size_t k = 0; k < 3; ++k) {
      piece.corners[k] = {number(t.corners[k][0]), number(t.corners[k][1]), number(t.corners[k][2])};
      piece.plan.push_back(planOf(piece.corners[k]));
    }
    piece.source = t.sourceTriangle;
    piece.obstacleEdge = t.obstacleEdge;
    piece.layer = t.layer;
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

EdgeMap findEdges(const std::vector<Piece>& pieces) {
  EdgeMap edges;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<Point3, 2> edge{pieces[i].corners[k], pieces[i].corners[(k + 1) % 3]};
      if (edge[1] < edge[0]) std::swap(edge[0], edge[1]);
      edges[edge].push_back({i, k});
    }
  }
  return edges;
}

std::vector<std::size_t> connectedParts(const std::vector<Piece>& pieces) {
  std::vector<std::size_t> parents(pieces.size());
  std::iota(parents.begin(), parents.end(), 0);
  for (const auto& [edge, uses] : findEdges(pieces)) {
    if (uses.size() != 2 || pieces[uses[0].piece].obstacleEdge[uses[0].edge]) continue;
    const std::size_t a = find(parents, uses[0].piece), b = find(parents, uses[1].piece);
    parents[std::max(a, b)] = std::min(a, b);
  }
  std::map<std::size_t, std::size_t> numbers;
  std::vector<std::size_t> parts;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    parts.push_back(numbers.try_emplace(find(parents, i), numbers.size()).first->second);
  return parts;
}

std::string findSetDifference(const Environment& environment, const WalkableArea& area,
                              const std::vector<Piece>& pieces) {
  std::map<const Region*, std::vector<const Piece*>> byRegion;
  for (const Piece& piece : pieces) {
    if (turn(piece.plan[0], piece.plan[1], piece.plan[2]) <= 0) return "does not face up: " + toText(piece);
    const Region* region = regionOf(area, piece.source);
    if (region == nullptr) return "its source is no floor: " + toText(piece);
    if (!(planeOf(piece) == region->plane)) return "not in the plane of its source: " + toText(piece);
    if (!contains(planTriangle(cornersOf(environment, piece.source)), piece.plan))
      return "not inside its source: " + toText(piece);
    Rational walkable = 0;
    for (const Polygon& cell : region->cells) walkable += twiceCommonArea(cell, piece.plan);
    if (walkable != twiceArea(piece.plan)) return "walkable where it should not be: " + toText(piece);
    for (const Piece* other : byRegion[region])
      if (twiceCommonArea(other->plan, piece.plan) != 0)
        return "walkable twice: " + toText(piece) + " and " + toText(*other);
    byRegion[region].push_back(&piece);
  }
  for (const Region& region : area.regions) {
    Rational sum = 0;
    for (const Piece* piece : byRegion[&region]) sum += twiceArea(piece->plan);
    if (const Rational expected = twiceArea(region); sum != expected)
      return "twice the plan area in the plane of input triangle " + std::to_string(region.floors[0]) + " is " +
             sum.get_str() + " instead of " + expected.get_str();
  }
  return {};
}

std::string findConformityError(const std::vector<Piece>& pieces) {
  for (const auto& [edge, uses] : findEdges(pieces)) {
    const std::string where = toText(edge[0]) + " - " + toText(edge[1]);
    if (uses.size() > 2) return "edge with " + std::to_string(uses.size()) + " triangles: " + where;
    if (uses.size() == 2 &&
        pieces[uses[0].piece].obstacleEdge[uses[0].edge] != pieces[uses[1].piece].obstacleEdge[uses[1].edge])
      return "obstacle edge on one side only: " + where;
  }
  std::vector<PlanBox> boxes;
  for (const Piece& piece : pieces) boxes.push_back(boxOf(piece.plan));
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Piece &p = pieces[i], &q = pieces[j];
      if (!mayTouch(boxes[i], boxes[j])) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 0; l < 3; ++l) {
          const Segment2 edge = planEdge(p, k), other = planEdge(q, l);
          if ((edge.from == other.to && edge.to == other.from) || (edge.from == other.from && edge.to == other.to))
            continue;
          const auto common = commonPart(edge, other);
          if (!common) continue;
          const Linear f = planeOf(p), g = planeOf(q);
          if (f.at(common->from) == g.at(common->from) && f.at(common->to) == g.at(common->to))
            return "T-joint between " + toText(p) + " and " + toText(q);
        }
      }
    }
  }
  return {};
}

namespace {

std::string findWallError(const WalkableArea& area, const std::vector<Piece>& pieces) {
  for (const auto& [edge, uses] : findEdges(pieces)) {
    if (uses.size() != 2) continue;
    const Region* region = regionOf(area, pieces[uses[0].piece].source);
    const Segment2 segment{planOf(edge[0]), planOf(edge[1])};
    const auto open = uncoveredParts(segment, region->traces);
    const bool blocked = open.empty();
    const bool whole = open.size() == 1 && open[0].from == segment.from && open[0].to == segment.to;
    const std::string where = toText(edge[0]) + " - " + toText(edge[1]);
    if (!blocked && !whole) return "a wall ends inside the edge " + where;
    if (blocked != pieces[uses[0].piece].obstacleEdge[uses[0].edge])
      return std::string(blocked ? "no obstacle edge where a wall stands: " : "obstacle edge without a wall: ") + where;
  }
  for (const Piece& piece : pieces)
    for (const Segment2& trace : regionOf(area, piece.source)->traces)
      if (passesThrough(trace, piece.plan)) return "a wall cuts through " + toText(piece);
  return {};
}

std::string findPartError(const WalkableArea& area, const std::vector<Piece>& pieces) {
  const auto meetings = findMeetings(area);
  const auto expected = connectedParts(area, meetings);
  const auto found = connectedParts(pieces);
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::size_t cell = 0;
    for (const Region& region : area.regions) {
      const bool mine = regionOf(area, pieces[i].source) == &region;
      for (const Polygon& polygon : region.cells) {
        if (mine && twiceCommonArea(polygon, pieces[i].plan) != 0) pairs.emplace(expected[cell], found[i]);
        ++cell;
      }
    }
  }
  // Both sets are equal, so every part takes part: one to one exactly when all three counts are the same.
  const std::size_t wanted = countParts(expected), got = countParts(found);
  if (pairs.size() == wanted && wanted == got) return {};
  return std::to_string(got) + " connected parts instead of " + std::to_string(wanted) + " (" +
         std::to_string(pairs.size()) + " pairs overlap)";
}

}  // namespace

std::string findDifference(const Environment& environment, const WalkableArea& area, const std::vector<Piece>& pieces) {
  if (std::string error = findSetDifference(environment, area, pieces); !error.empty()) return error;
  if (std::string error = findConformityError(pieces); !error.empty()) return error;
  if (std::string error = findWallError(area, pieces); !error.empty()) return error;
  return findPartError(area, pieces);
}

double obstacleLength(const std::vector<Piece>& pieces) {
  double sum = 0;
  for (const auto& [edge, uses] : findEdges(pieces))
    if (uses.size() == 2 && pieces[uses[0].piece].obstacleEdge[uses[0].edge]) sum += lengthOf(edge);
  return sum;
}

double blockedLength(const std::vector<Meeting>& meetings) {
  double sum = 0;
  for (const Meeting& m : meetings) sum += m.blockedLength;
  return sum;
}

}  // namespace footfall::reference
