// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/source_mesh.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/base/lexicographic_order.hpp"
#include "core/base/main_direction.hpp"
#include "core/base/numbered_table.hpp"
#include "core/base/parallel.hpp"
#include "core/base/sorted_list.hpp"
#include "core/base/vector.hpp"
#include "core/exact/plan_places.hpp"
#include "core/exact/source_predicates.hpp"

namespace footfall::detail {
namespace {

// One task has this many vertices or triangles, with one check for cancelling.
constexpr std::size_t kPerTask = 1024;

// Calls body(i) for 0 <= i < count, in parallel where there are many.
template <class Body>
void forEach(std::size_t count, Poll poll, const Body& body) {
  forRanges(count, kPerTask, [&](std::size_t first, std::size_t last) {
    poll();
    for (std::size_t i = first; i < last; ++i) body(i);
  });
}

// The same in the order of i, on this thread.
template <class Body>
void forEachInOrder(std::size_t count, Poll poll, const Body& body) {
  for (std::size_t begin = 0; begin < count; begin += kPerTask) {
    poll();
    for (std::size_t i = begin; i < std::min(count, begin + kPerTask); ++i) body(i);
  }
}

using Place = std::pair<double, double>;

double coordinate(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

}  // namespace

void classifyTriangle(SourceMesh& mesh, Index t, const SignRule& sign) {
  const auto& [ia, ib, ic] = mesh.triangles[t];
  const Vec3 &a = mesh.scaled[ia], &b = mesh.scaled[ib], &c = mesh.scaled[ic];
  std::int8_t& turn = mesh.facing.own()[t];
  std::array<ErrorDouble, 3>& n = mesh.normals.own()[t];
  if (mesh.grid.hasExactOrientations()) {  // and so is each component of a normal
    const Vec3 normal = cross(b - a, c - a);
    n = {normal.x, normal.y, normal.z};
  } else {
    using E = ErrorDouble;
    const std::array<E, 3> u{E(b.x) - E(a.x), E(b.y) - E(a.y), E(b.z) - E(a.z)};
    const std::array<E, 3> v{E(c.x) - E(a.x), E(c.y) - E(a.y), E(c.z) - E(a.z)};
    n = cross(u, v);
  }
  const Vec3 &ra = mesh.vertices[ia], &rb = mesh.vertices[ib], &rc = mesh.vertices[ic];
  const MaybeSign facingSign = sign(n[2]);
  turn = static_cast<std::int8_t>(facingSign ? *facingSign : facing(ra, rb, rc));
  if (turn != 0) return;
  n[2] = 0;
  const MaybeSign x = sign(n[0]), y = sign(n[1]);
  if (x.value_or(0) != 0 || y.value_or(0) != 0) return;
  const bool isFlat = (x == 0 && y == 0) || isDegenerate(ra, rb, rc);
  mesh.degenerate.own()[t] = static_cast<char>(isFlat);
  if (isFlat) n = {};
}

std::array<Index, 3> turnedTriangle(const SourceMesh& mesh, const Triangle& t, bool bothSides) {
  std::array<Index, 3> f{mesh.welded[t[0]], mesh.welded[t[1]], mesh.welded[t[2]]};
  if (bothSides && facing(mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]) < 0) std::swap(f[1], f[2]);
  std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
  return f;
}

namespace {

// Sorts and welds the used vertices; returns for each input vertex its new index.
std::vector<Index> weldVertices(std::span<const Vec3> vertices, SourceMesh& mesh, Poll poll) {
  const std::vector<std::uint32_t> order = lexicographicOrder(
      vertices.size(), [&](std::size_t i, int axis) { return coordinate(vertices[i], axis); }, poll);
  std::vector<Index> welded(vertices.size());
  mesh.vertices.reserve(vertices.size());
  mesh.planIds.reserve(vertices.size());
  forEachInOrder(order.size(), poll, [&](std::size_t i) {
    const Vec3 v = withoutNegativeZeros(vertices[order[i]]);
    if (mesh.vertices.empty() || !(mesh.vertices.back() == v)) {
      const auto index = static_cast<Index>(mesh.vertices.size());
      const bool samePlan = index > 0 && mesh.vertices.back().x == v.x && mesh.vertices.back().y == v.y;
      mesh.planIds.push_back(samePlan ? mesh.planIds.back() : index);
      mesh.vertices.push_back(v);
    }
    welded[order[i]] = static_cast<Index>(mesh.vertices.size()) - 1;
  });
  return welded;
}

}  // namespace

void chooseGrid(SourceMesh& mesh, Poll poll) {
  forEachInOrder(mesh.vertices.size(), poll, [&](std::size_t i) {
    const Vec3& v = mesh.vertices[i];
    mesh.grid.include(v.x);
    mesh.grid.include(v.y);
    mesh.grid.include(v.z);
  });
  const int scale = mesh.grid.scaleExponent();
  mesh.scaled.resize(mesh.vertices.size());
  const PowerOfTwo toScale(scale);
  forEach(mesh.vertices.size(), poll, [&](std::size_t i) {
    const Vec3& v = mesh.vertices[i];
    mesh.scaled[i] = {toScale(v.x), toScale(v.y), toScale(v.z)};
  });
}

namespace {

// The order of triangles by their vertices, then by number. By counting for the first vertex, which few share.
std::vector<std::uint32_t> orderOf(const std::vector<std::array<Index, 3>>& triangles, std::size_t vertexCount,
                                   Poll poll) {
  std::vector<std::uint32_t> ends(vertexCount, 0), order(triangles.size());
  forEachInOrder(triangles.size(), poll, [&](std::size_t i) { ++ends[triangles[i][0]]; });
  std::uint32_t before = 0;
  for (std::uint32_t& end : ends) before += std::exchange(end, before);
  forEachInOrder(triangles.size(), poll,
                 [&](std::size_t i) { order[ends[triangles[i][0]]++] = static_cast<std::uint32_t>(i); });
  forEach(vertexCount, poll, [&](std::size_t v) {
    const std::span<std::uint32_t> fan(order.data() + (v == 0 ? 0 : ends[v - 1]), order.data() + ends[v]);
    if (fan.size() > kPerTask) {
      const std::vector<std::uint32_t> within = lexicographicOrder(
          fan.size(), [&](std::size_t i, int axis) { return axis == 2 ? 0.0 : triangles[fan[i]][axis + 1]; }, poll);
      std::vector<std::uint32_t> sorted(fan.size());
      for (std::size_t i = 0; i < fan.size(); ++i) sorted[i] = fan[within[i]];
      std::copy(sorted.begin(), sorted.end(), fan.begin());
      return;
    }
    std::sort(fan.begin(), fan.end(), [&](std::uint32_t a, std::uint32_t b) {
      return triangles[a] != triangles[b] ? triangles[a] < triangles[b] : a < b;
    });
  });
  return order;
}

// Turns the triangles of the soup to start at their smallest vertex, and sorts them; returns the order.
std::vector<std::uint32_t> sortTriangles(const SoupView& soup, bool bothSides, SourceMesh& mesh, Poll poll) {
  const std::size_t count = soup.triangles.size();
  std::vector<std::array<Index, 3>> turned(count);
  forEach(count, poll, [&](std::size_t i) { turned[i] = turnedTriangle(mesh, soup.triangles[i], bothSides); });
  const std::vector<std::uint32_t> order = orderOf(turned, mesh.vertices.size(), poll);
  auto* const triangles = mesh.triangles.own();
  std::uint32_t* const inputTriangles = mesh.inputTriangles.own();
  forEach(count, poll, [&](std::size_t i) {
    triangles[i] = turned[order[i]];
    inputTriangles[i] = soup.inputTriangles.empty() ? order[i] : soup.inputTriangles[order[i]];
  });
  return order;
}

void makeRoom(SourceMesh& mesh, std::size_t triangles) {
  mesh.normals = decltype(mesh.normals)(triangles);
  mesh.facing = decltype(mesh.facing)(triangles);
  mesh.degenerate = decltype(mesh.degenerate)(triangles);
  mesh.triangles = decltype(mesh.triangles)(triangles);
  mesh.inputTriangles = decltype(mesh.inputTriangles)(triangles);
}

void classify(SourceMesh& mesh, Poll poll) {
  const SignRule sign = mesh.grid.signRule(mesh.grid.scaleExponent());
  forEach(mesh.triangles.size(), poll, [&](std::size_t t) { classifyTriangle(mesh, static_cast<Index>(t), sign); });
}

}  // namespace

Box boxOf(const SourceMesh& mesh, Index t) {
  const auto& f = mesh.triangles[t];
  const Vec3 &a = mesh.vertices[f[0]], &b = mesh.vertices[f[1]], &c = mesh.vertices[f[2]];
  return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
          {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}};
}

namespace {

/// The frame of the tree, from a sample of the edges; none where most of them follow the axes.
std::optional<TreeTurn> findTurn(const SourceMesh& mesh) {
  constexpr std::size_t kTriangles = MainDirection::kEnough / 3;
  MainDirection direction;
  const std::size_t count = mesh.triangles.size(), step = std::max<std::size_t>(count / kTriangles, 1);
  for (std::size_t t = 0; t < count; t += step)
    for (int k = 0; k < 3; ++k) {
      const Vec3 &a = mesh.scaled[mesh.triangles[t][k]], &b = mesh.scaled[mesh.triangles[t][next(k)]];
      direction.add(b.x - a.x, b.y - a.y);
    }
  const auto found = direction.find();
  return found ? std::optional(TreeTurn((*found)[0], (*found)[1])) : std::nullopt;
}

}  // namespace

void buildTree(SourceMesh& mesh, Poll poll) {
  if (mesh.vertices.empty()) return;
  const Vec3& corner = mesh.vertices.front();
  Box bounds{{corner.x, corner.y, corner.z}, {mesh.vertices.back().x, corner.y, corner.z}};
  forEachInOrder(mesh.vertices.size(), poll, [&](std::size_t i) {
    const Vec3& v = mesh.vertices[i];
    bounds.lower[1] = std::min(bounds.lower[1], v.y);
    bounds.upper[1] = std::max(bounds.upper[1], v.y);
    bounds.lower[2] = std::min(bounds.lower[2], v.z);
    bounds.upper[2] = std::max(bounds.upper[2], v.z);
  });
  std::vector<std::int32_t> ids;
  ids.reserve(mesh.triangles.size());
  forEachInOrder(mesh.triangles.size(), poll, [&](std::size_t t) {
    if (mesh.degenerate[t] == 0) ids.push_back(static_cast<std::int32_t>(t));
  });
  if (const auto turn = findTurn(mesh)) {
    const auto turnedBox = [&](std::size_t i) {
      const auto& [a, b, c] = mesh.triangles[ids[i]];
      return turn->around(std::array{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, boxOf(mesh, ids[i]));
    };
    mesh.tree.build(turn->around(bounds), ids, turnedBox, turn, poll);
    return;
  }
  mesh.tree.build(
      bounds, ids, [&](std::size_t i) { return boxOf(mesh, ids[i]); }, std::nullopt, poll);
}

bool SourceMesh::hasObstacleEdge(Index a, Index b) const {
  return !obstacleEdges.empty() &&
         std::binary_search(obstacleEdges.begin(), obstacleEdges.end(), std::make_pair(std::min(a, b), std::max(a, b)));
}

SourceMesh makeSourceMesh(const SoupView& soup, bool bothSides, std::vector<std::uint32_t>* order, Poll poll) {
  SourceMesh mesh;
  mesh.grid = soup.grid;
  // One thread sorts for long, another has the time to clear memory.
  parallelInvoke([&] { mesh.welded = SharedArray(weldVertices(soup.vertices, mesh, poll)); },
                 [&] { makeRoom(mesh, soup.triangles.size()); });
  std::vector<std::uint32_t> sorted;
  parallelInvoke([&] { sorted = sortTriangles(soup, bothSides, mesh, poll); }, [&] { chooseGrid(mesh, poll); });
  if (order != nullptr) *order = std::move(sorted);
  for (const auto& [u, v] : soup.obstacleEdges) {
    const Index a = mesh.welded[u], b = mesh.welded[v];
    if (a != b) mesh.obstacleEdges.emplace_back(std::min(a, b), std::max(a, b));
  }
  sortOnce(mesh.obstacleEdges);
  classify(mesh, poll);
  buildTree(mesh, poll);
  poll();
  return mesh;
}

std::vector<Index> addPlanPlaces(SourceMesh& mesh, std::span<const Vec3> scaled) {
  return addPlanPlaces(mesh, scaled, {});
}

namespace {

using PlaceKey = std::array<std::uint64_t, 2>;

// -0 equals 0.
PlaceKey keyOf(const Vec3& p) {
  return {std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0)};
}

/// One bit for each hash of a place in the plan. Most places that are added are no vertices, and a bisection for each
/// would read all over the memory.
class PlaceBits {
 public:
  PlaceBits(std::span<const Vec3> vertices, const Poll& poll)
      : bits_(std::bit_ceil(vertices.size() / 4 + 1)) {  // 16 to 32 bits for a vertex, of which one is set
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (v % kPerTask == 0) poll();
      const std::uint64_t hash = hashOf(vertices[v]);
      bits_[wordOf(hash)] |= bitOf(hash);
    }
  }
  /// False only where no vertex has these coordinates.
  [[nodiscard]] bool mayHave(const Vec3& p) const {
    const std::uint64_t hash = hashOf(p);
    return (bits_[wordOf(hash)] & bitOf(hash)) != 0;
  }

 private:
  static std::uint64_t hashOf(const Vec3& p) { return NumberedTable<PlaceKey>::hashOf(keyOf(p)); }
  [[nodiscard]] std::size_t wordOf(std::uint64_t hash) const { return hash >> 22 & (bits_.size() - 1); }
  static std::uint64_t bitOf(std::uint64_t hash) { return std::uint64_t{1} << (hash >> 16 & 63); }

  std::vector<std::uint64_t> bits_;
};

}  // namespace

std::vector<Index> addPlanPlaces(SourceMesh& mesh, std::span<const Vec3> scaled, const Poll& poll) {
  const PowerOfTwo inUnits(-mesh.grid.scaleExponent());
  const auto sorted = static_cast<std::ptrdiff_t>(mesh.vertices.size() - mesh.planPlaces);
  const PlaceBits vertexBits({mesh.vertices.data(), static_cast<std::size_t>(sorted)}, poll);
  NumberedTable<PlaceKey> known;
  known.reserve(mesh.planPlaces + scaled.size());
  std::vector<Index> idOf;  // vertex at each known place
  for (std::size_t v = mesh.vertices.size() - mesh.planPlaces; v < mesh.vertices.size(); ++v)
    if (known.insert(keyOf(mesh.vertices[v])).second) idOf.push_back(static_cast<Index>(v));
  std::vector<Index> ids;
  ids.reserve(scaled.size());
  mesh.vertices.reserve(mesh.vertices.size() + scaled.size());
  mesh.scaled.reserve(mesh.scaled.size() + scaled.size());
  mesh.planIds.reserve(mesh.planIds.size() + scaled.size());
  for (const Vec3& given : scaled) {
    if (ids.size() % kPerTask == 0) poll();
    const Vec3 p = withoutNegativeZeros({inUnits(given.x), inUnits(given.y), inUnits(given.z)});
    const auto next = static_cast<Index>(mesh.vertices.size());
    const auto [number, isNew] = known.insert(keyOf(p));
    if (isNew && !vertexBits.mayHave(p)) {
      idOf.push_back(next);
    } else if (isNew) {
      const auto last = mesh.vertices.begin() + sorted;
      const auto first = std::lower_bound(mesh.vertices.begin(), last, p, [](const Vec3& a, const Vec3& b) {
        return Place{a.x, a.y} < Place{b.x, b.y};
      });
      const bool isVertex = first != last && first->x == p.x && first->y == p.y;
      idOf.push_back(isVertex ? static_cast<Index>(first - mesh.vertices.begin()) : next);
    }
    ids.push_back(idOf[number]);
    if (idOf[number] != next) continue;
    mesh.vertices.push_back(p);
    mesh.scaled.push_back(withoutNegativeZeros(given));
    mesh.planIds.push_back(next);
    ++mesh.planPlaces;
    mesh.grid.include(p.x);
    mesh.grid.include(p.y);
    mesh.grid.include(p.z);
  }
  return ids;
}

}  // namespace footfall::detail
