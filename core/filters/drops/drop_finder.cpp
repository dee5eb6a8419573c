// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/drops/drop_finder.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/base/vector.hpp"
#include "core/filters/rounding/rounded_mesh.hpp"
#include "core/mesh/mesh_topology.hpp"

namespace footfall::detail {
namespace {

constexpr Index kBordersPerTask = 16;

std::array<double, 3> asArray(const Vec3& p) { return {p.x, p.y, p.z}; }

MeshDrop makeDrop(const std::array<Index, 2>& edge, Index triangle, const EdgePiece& piece) {
  MeshDrop drop;
  drop.edge = edge;
  drop.triangle = triangle;
  drop.stretch = {std::max(piece.begin, 0.0), std::min(piece.end, 1.0)};
  return drop;
}

/// A linear function along an edge, by its values at 0 and 1.
struct Linear {
  double begin = 0, end = 0;
  [[nodiscard]] double at(double s) const { return begin + s * (end - begin); }
};

/// Cuts off where a linear function is below 0.
void restrict(EdgePiece& piece, const Linear& f) {
  const double first = f.at(piece.begin), last = f.at(piece.end);
  if (first >= 0 && last >= 0) return;
  if (first < 0 && last < 0) {
    piece.end = piece.begin;
    return;
  }
  const double zero = piece.begin + first / (first - last) * (piece.end - piece.begin);
  (first < 0 ? piece.begin : piece.end) = zero;
}

/// A triangle in which one may land straight below an edge.
struct Landing {
  std::array<SignAlong, 3> inside;
  SignAlong below, deep;  ///< over the border, and over it lowered by the depth
};

}  // namespace

DropFinder::DropFinder(const WalkableState& state, const DropLevels& levels, RunContext& context)
    : state_(state), kernel_(*state.kernel), mesh_(*state.mesh), levels_(levels), context_(context) {
  std::vector<char> exact;
  places_ = roundVertices(kernel_, mesh_.vertices, exact, context);
  const int scale = kernel_.mesh().grid.scaleExponent();
  for (Vec3& p : places_) p = {std::ldexp(p.x, scale), std::ldexp(p.y, scale), std::ldexp(p.z, scale)};
  findBorders();
  buildTrees();
}

void DropFinder::findBorders() {
  const auto topology = topologyOf(state_, context_);
  const TriangleCorners corners(mesh_.triangles);
  std::set<std::array<Index, 2>> linked;
  for (const MeshLink& link : mesh_.links) {
    linked.insert(link.from);
    linked.insert(link.to);
  }
  for (Index e = 0; e < topology->edgeCount(); ++e) {
    const auto sides = topology->sidesOf(e);
    if (sides.size() > 1 && !isObstacle(mesh_.triangles, sides)) continue;
    for (const Index side : sides) {
      const Index from = corners.beginOf(side), to = corners.endOf(side);
      borders_.push_back({from, to, side / 3, linked.contains({from, to})});
    }
  }
}

DropFinder::Tree::Bounds DropFinder::boundsOf(Index a, Index b) const {
  const std::array p = asArray(places_[a]), q = asArray(places_[b]);
  Tree::Bounds bounds;
  for (int k = 0; k < 3; ++k) {
    const double margin = std::max(std::fabs(p[k]), std::fabs(q[k])) * 0x1p-40;
    bounds.lower[k] = std::min(p[k], q[k]) - margin;
    bounds.upper[k] = std::max(p[k], q[k]) + margin;
  }
  return bounds;
}

void DropFinder::buildTrees() {
  std::vector<Index> all(borders_.size());
  std::iota(all.begin(), all.end(), 0);
  borderTree_.build(
      all, [&](Index i) { return boundsOf(borders_[i].from, borders_[i].to); }, context_);
  all.resize(mesh_.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  triangleTree_.build(
      all,
      [&](Index t) {
        const auto& c = mesh_.triangles[t].corners;
        Tree::Bounds bounds = boundsOf(c[0], c[1]);
        const Tree::Bounds other = boundsOf(c[2], c[2]);
        for (int k = 0; k < 3; ++k) {
          bounds.lower[k] = std::min(bounds.lower[k], other.lower[k]);
          bounds.upper[k] = std::max(bounds.upper[k], other.upper[k]);
        }
        return bounds;
      },
      context_);
}

BorderEdge DropFinder::edgeOf(const Border& border) const {
  return {mesh_.vertices[border.from], mesh_.vertices[border.to], mesh_.triangles[border.triangle].face};
}

std::vector<MeshDrop> DropFinder::find(double reach) {
  const double scaledReach = std::ldexp(reach, kernel_.mesh().grid.scaleExponent());
  PerThread<Worker> workers([&] {
    return Worker{BorderKinds(kernel_, state_.removed, levels_.step, levels_.height), {}};
  });
  const auto count = static_cast<Index>(borders_.size());
  parallelRanges(count, kBordersPerTask, [&](const auto& range) {
    Worker& worker = workers.local();
    for (Index i = range.begin(); i != range.end(); ++i) {
      context_.checkCancelled();
      if (!borders_[i].isLinked) tryBorder(borders_[i], scaledReach, worker);
    }
  });
  std::vector<MeshDrop> drops;
  for (Worker& worker : workers) {
    fallbacks_ += worker.kinds.signs().fallbacks;
    drops.insert(drops.end(), worker.drops.begin(), worker.drops.end());
  }
  std::sort(drops.begin(), drops.end());
  return drops;
}

void DropFinder::tryBorder(const Border& border, double reach, Worker& worker) const {
  const Vec3 &begin = places_[border.from], &end = places_[border.to];
  if (begin.x == end.x && begin.y == end.y) return;
  BorderKinds& kinds = worker.kinds;
  kinds.turnTo(edgeOf(border), begin, end);
  const std::vector<EdgePiece> ledges = kinds.ledges();
  if (ledges.empty()) return;
  dropStraight(border, ledges, worker);
  if (!(reach > 0)) return;
  Tree::Bounds query = boundsOf(border.from, border.to);
  query.lower[2] -= kinds.heightOf(levels_.depth);
  for (const int axis : {0, 1}) {
    const double out = reach * (axis == 0 ? kinds.frame().outwards().x : kinds.frame().outwards().y);
    (out < 0 ? query.lower : query.upper)[axis] += out;
  }
  borderTree_.visitOverlapping(query, [&](Index other) {
    context_.checkCancelled();
    if (&borders_[other] != &border) dropAcross(border, borders_[other], ledges, reach, worker);
  });
}

bool DropFinder::isLevel(Index face) const {
  const SourceMesh& source = kernel_.mesh();
  const auto& f = source.triangles[face];
  return source.vertices[f[0]].z == source.vertices[f[1]].z && source.vertices[f[0]].z == source.vertices[f[2]].z;
}

double DropFinder::heightAt(Index face, const Vec3& place) const {
  const SourceMesh& source = kernel_.mesh();
  const auto& f = source.triangles[face];
  if (isLevel(face)) return source.scaled[f[0]].z;
  const auto exact = [](const Vec3& p) { return std::array<mpq_class, 3>{p.x, p.y, p.z}; };
  const auto a = exact(source.scaled[f[0]]);
  const auto n = cross(exact(source.scaled[f[1]]) - a, exact(source.scaled[f[2]]) - a);
  const auto d = exact(place) - a;
  return nearestDouble(a[2] - (n[0] * d[0] + n[1] * d[1]) / n[2]);
}

void DropFinder::dropStraight(const Border& border, const std::vector<EdgePiece>& ledges, Worker& worker) const {
  BorderKinds& kinds = worker.kinds;
  EdgeSigns& signs = kinds.signs();
  const BorderEdge& edge = kinds.edge();
  const auto landingIn = [&](Index t, Landing& landing) {
    const MeshTriangle& m = mesh_.triangles[t];
    if (t == border.triangle || m.face == edge.face) return false;
    for (int k = 0; k < 3; ++k) {
      const Index u = m.corners[k], v = m.corners[next(k)];
      const SignAlong& inside = landing.inside[k] = signs.leftOf(edge, mesh_.vertices[u], mesh_.vertices[v], {u, v});
      if (inside.begin > 0 || inside.end > 0) continue;
      if (!inside.isZero() || signs.orientation(edge, mesh_.vertices[m.corners[previous(k)]]) >= 0) return false;
    }
    landing.below = signs.height(edge, m.face, edge.face, 0);
    landing.deep = signs.height(edge, m.face, edge.face, -levels_.depth);
    return std::min(landing.below.begin, landing.below.end) < 0 && std::max(landing.deep.begin, landing.deep.end) >= 0;
  };
  Tree::Bounds query = boundsOf(border.from, border.to);
  query.lower[2] -= kinds.heightOf(levels_.depth);
  bool hasLookedBelow = false;
  triangleTree_.visitOverlapping(query, [&](Index t) {
    context_.checkCancelled();
    Landing landing;
    if (!landingIn(t, landing)) return;
    const MeshTriangle& m = mesh_.triangles[t];
    const Index face = m.face;
    for (int k = 0; k < 3; ++k)
      signs.locate(edge, mesh_.vertices[m.corners[k]], mesh_.vertices[m.corners[next(k)]], landing.inside[k]);
    signs.locate(edge, landing.below);
    signs.locate(edge, landing.deep);
    EdgePieces pieces;
    for (const SignAlong& sign : landing.inside) pieces.add(sign);
    pieces.add(landing.below);
    pieces.add(landing.deep);
    const EdgeExtent extent = kinds.extentOf({places_[m.corners[0]], places_[m.corners[1]], places_[m.corners[2]]});
    // Obstacles over the landing, below the head of an agent at the start.
    if (!std::exchange(hasLookedBelow, true)) kinds.lookBelow(kinds.heightOf(levels_.depth));
    std::vector<std::pair<const CoverAlong*, SignAlong>> over;
    for (std::size_t i = 0; i < kinds.covers().size(); ++i) {
      const CoverAlong& c = kinds.covers()[i];
      if (!c.isOutside || c.triangle == face || (c.underHeight.begin >= 0 && c.underHeight.end >= 0)) continue;
      if (!kinds.mayBeOver(c.extent, extent)) continue;
      SignAlong above = signs.height(edge, c.triangle, face, 0);
      if (above.begin <= 0 && above.end <= 0) continue;
      signs.locate(edge, above);
      kinds.locate(i);
      over.emplace_back(&c, above);
      for (const SignAlong& sign : c.inside) pieces.add(sign);
      pieces.add(above);
      pieces.add(c.underHeight);
    }
    const std::vector<EdgePiece> free = pieces.where([&](const EdgePiece& piece) {
      return std::all_of(landing.inside.begin(), landing.inside.end(),
                         [&](const SignAlong& s) { return s.on(piece) >= 0; }) &&
             landing.below.on(piece) < 0 && landing.deep.on(piece) >= 0 &&
             std::none_of(over.begin(), over.end(), [&](const auto& c) {
               return c.second.on(piece) > 0 && c.first->underHeight.on(piece) < 0 && c.first->covers(piece);
             });
    });
    for (const EdgePiece& piece : common(free, ledges)) {
      MeshDrop drop = makeDrop({border.from, border.to}, t, piece);
      for (int end = 0; end < 2; ++end) {
        const Vec3 start = kinds.frame().at(drop.stretch[end]);
        drop.start[end] = asArray(start);
        drop.landing[end] = {start.x, start.y, heightAt(face, start)};
      }
      if (drop.start[0] != drop.start[1]) worker.drops.push_back(drop);
    }
  });
}

// Along the edge, `other` is where outwards() is `across`, and above() is `rise`.
void DropFinder::dropAcross(const Border& border, const Border& other, const std::vector<EdgePiece>& ledges,
                            double reach, Worker& worker) const {
  BorderKinds& kinds = worker.kinds;
  const EdgeFrame& frame = kinds.frame();
  const double margin = frame.margin(), height = kinds.heightOf(levels_.height);
  const Vec3 first = frame.local(places_[other.from]), last = frame.local(places_[other.to]);
  const double from = frame.along().at(first), to = frame.along().at(last);
  // An agent that lands walks on away from the edge: seen from above, the other border runs against it.
  if (!((from - to) * frame.length() > margin)) return;
  const auto linear = [&](const LinearFunction& f) {
    const double atFrom = f.at(first), slope = (f.at(last) - atFrom) / (to - from);
    return Linear{atFrom - from * slope, atFrom + (1 - from) * slope};
  };
  const Linear across = linear(frame.outwards()), rise = linear(frame.above());
  EdgePiece piece{std::max(0.0, to + margin / frame.length()), std::min(1.0, from - margin / frame.length())};
  if (piece.isEmpty()) return;
  restrict(piece, {across.begin - margin, across.end - margin});
  restrict(piece, {reach - margin - across.begin, reach - margin - across.end});
  const Index face = mesh_.triangles[other.triangle].face;
  if (isLevel(kinds.edge().face) && isLevel(face)) {
    if (kinds.signs().height(kinds.edge(), face, kinds.edge().face, 0).begin >= 0 ||
        kinds.signs().height(kinds.edge(), face, kinds.edge().face, -levels_.depth).begin < 0)
      return;
  } else {
    const double depth = kinds.heightOf(levels_.depth);
    restrict(piece, {-margin - rise.begin, -margin - rise.end});
    restrict(piece, {depth - margin + rise.begin, depth - margin + rise.end});
  }
  if (piece.isEmpty()) return;

  const auto along = [&](const Linear& f) {
    const double change = f.end - f.begin;
    return LinearFunction{frame.along().x * change, frame.along().y * change, 0, f.begin};
  };
  // The functions are in units of length, so that the margin has its meaning.
  const LinearFunction behindBegin{frame.along().x * frame.length(), frame.along().y * frame.length(), 0,
                                   -piece.begin * frame.length()};
  const LinearFunction beforeEnd = LinearFunction{} - behindBegin + (piece.end - piece.begin) * frame.length();
  const LinearFunction before = along(across) - frame.outwards();
  const LinearFunction belowHead = LinearFunction{} - frame.above() + height;
  const std::vector<LinearFunction> way = frame.widened(
      {behindBegin, beforeEnd, frame.outwards(), before, frame.above() + -kinds.heightOf(levels_.step), belowHead});
  // No obstacle is lower than the height over the landing, except the landing's own surroundings.
  const std::vector<LinearFunction> fall = frame.widened({behindBegin, beforeEnd, before, LinearFunction{} - before,
                                                          frame.above() - along(rise) + -height / 2, belowHead});
  const BorderEdge end = edgeOf(other);
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto range = std::minmax({asArray(places_[border.from])[axis], asArray(places_[border.to])[axis],
                                    asArray(places_[other.from])[axis], asArray(places_[other.to])[axis]});
    box.lower[axis] = range.first;
    box.upper[axis] = range.second;
  }
  box.upper[2] += height;
  std::vector<EdgePiece> blocked;
  kinds.visitNear(box, [&](Index t) {
    if (kinds.isKnownBeside(t, levels_.height, -1)) return;
    const auto& f = kernel_.mesh().triangles[t];
    const auto all = [&](const BorderEdge& edge, int side) {
      return std::all_of(f.begin(), f.end(), [&](Index v) { return side * kinds.signs().orientation(edge, v) >= 0; });
    };
    const std::array corners = kinds.cornersOf(t);
    if (!all(kinds.edge(), 1) && !kinds.isKnownBeside(t, levels_.step, 1))
      if (const auto shadow = frame.shadow(corners, way)) blocked.push_back(*shadow);
    if (!all(end, -1))
      if (const auto shadow = frame.shadow(corners, fall)) blocked.push_back(*shadow);
  });
  for (const EdgePiece& free : without(common(ledges, {piece}), std::move(blocked))) {
    if (!((free.end - free.begin) * frame.length() > margin)) continue;
    MeshDrop drop = makeDrop({border.from, border.to}, other.triangle, free);
    for (int side = 0; side < 2; ++side) {
      drop.start[side] = asArray(frame.at(drop.stretch[side]));
      const double t = std::clamp((drop.stretch[side] - from) / (to - from), 0.0, 1.0);
      const Vec3 &a = places_[other.from], &b = places_[other.to];
      drop.landing[side] = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
    }
    worker.drops.push_back(drop);
  }
}

}  // namespace footfall::detail
