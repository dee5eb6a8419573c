// Cells at random, and everything that cutting along them promises, in rational numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "core/exact/plan_kernel.hpp"
#include "core/partitioning/cutting.hpp"
#include "core/partitioning/strategies.hpp"
#include "tests/support/soup_generators.hpp"

namespace footfall::test {
using namespace detail;

using Random = std::mt19937_64;
using Rational3 = std::array<mpq_class, 3>;

inline int integer(Random& random, int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }

inline SourceMesh meshOf(const Soup& soup, const std::vector<std::uint32_t>& order = {}) {
  const auto environment = soup.environment();
  const auto mixed = order.empty() ? environment : shuffled(*environment, order, 1);
  return makeSourceMesh(SoupView(mixed->vertices, mixed->triangles), false);
}

inline double coordinateOf(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// A partition by hand: divide(cell, axis, coordinate) makes two cells of one.
class Cells {
 public:
  Cells() { partition_.cells.emplace_back(); }
  /// `cell` keeps what is below; returns the number of the new cell above. Not a cut where it would miss the cell.
  Index divide(Index cell, int axis, double c) {
    const CellBounds bounds = partition_.cells[cell].bounds;
    if (!(bounds.lower[axis] < c && c < bounds.upper[axis])) return -1;
    const auto above = static_cast<Index>(partition_.cells.size());
    const auto node = static_cast<Index>(partition_.nodes.size());
    for (auto& n : partition_.nodes)
      for (Index* child : {&n.below, &n.above})
        if (*child == -1 - cell) *child = node;
    partition_.nodes.push_back({axis, c, -1 - cell, -1 - above});
    partition_.cells.push_back(partition_.cells[cell]);
    partition_.cells[cell].bounds.upper[axis] = partition_.cells[above].bounds.lower[axis] = c;
    if (axis != 2) {
      auto& borders = partition_.borders[axis];
      const auto it = std::lower_bound(borders.begin(), borders.end(), c);
      if (it == borders.end() || *it != c) borders.insert(it, c);
    }
    return above;
  }
  [[nodiscard]] const Partition& partition() const { return partition_; }

 private:
  Partition partition_;
};

/// Cuts through vertices, half way between, anywhere near, and often the same coordinate in several cells.
inline Partition randomPartition(Random& random, const SourceMesh& mesh, int cuts) {
  Cells cells;
  std::array<std::vector<double>, 3> used;
  const auto vertex = [&](int axis) {
    return coordinateOf(mesh.vertices[integer(random, 0, static_cast<int>(mesh.vertices.size()) - 1)], axis);
  };
  for (int i = 0; i < cuts; ++i) {
    const int axis = integer(random, 0, 5) == 0 ? 2 : integer(random, 0, 1);
    double c = vertex(axis);
    const int kind = integer(random, 0, 9);
    if (kind <= 3) c = c / 2 + vertex(axis) / 2;
    if (kind == 4) c = c + (vertex(axis) - c) / 3;
    if (kind == 5) c = std::nextafter(c, vertex(axis));
    if (kind >= 8 && !used[axis].empty()) c = used[axis][random() % used[axis].size()];
    used[axis].push_back(c);
    const auto count = static_cast<int>(cells.partition().cells.size());
    cells.divide(integer(random, 0, count - 1), axis, c);
  }
  return cells.partition();
}

inline Rational3 cross(const Rational3& a, const Rational3& b, const Rational3& c) {
  Rational3 n;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    n[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
  }
  return n;
}

/// Everything that a cut promises, exactly; an empty text, or what is wrong.
class Check {
 public:
  Check(const SourceMesh& mesh, const Partition& partition, const CutEnvironment& cut)
      : mesh_(mesh), partition_(partition), geometry_(mesh, partition), cut_(cut) {
    for (const CutVertex& v : cut.vertices) places_.push_back(geometry_.exactPlace(v));
  }

  std::string run(std::span<const char> included) {
    if (!vertices()) return "vertex";
    std::vector<std::vector<const CutTriangle*>> of(mesh_.triangles.size());
    Index last = -1;
    for (const CutTriangle& t : cut_.triangles) {
      if (t.source < last) return "order";
      last = t.source;
      of[t.source].push_back(&t);
    }
    for (std::size_t t = 0; t < of.size(); ++t) {
      if (!included.empty() && included[t] == 0) {
        if (!of[t].empty()) return "not included";
        continue;
      }
      const auto wrong =
          mesh_.degenerate[t] != 0 ? degenerate(static_cast<Index>(t), of[t]) : triangle(static_cast<Index>(t), of[t]);
      if (!wrong.empty()) return wrong + " of triangle " + std::to_string(t);
    }
    return {};
  }

 private:
  bool vertices() const {
    if (cut_.places.size() != cut_.vertices.size() || cut_.vertices.size() < mesh_.vertices.size()) return false;
    std::set<CutVertex> distinct(cut_.vertices.begin(), cut_.vertices.end());
    if (distinct.size() != cut_.vertices.size()) return false;
    std::set<std::pair<std::array<Index, 2>, Rational3>> onEdges;
    for (std::size_t i = 0; i < cut_.vertices.size(); ++i) {
      const CutVertex& v = cut_.vertices[i];
      if ((v.kind == CutVertex::Source) != (i < mesh_.vertices.size())) return false;
      if (v.kind == CutVertex::Source && v.a != static_cast<Index>(i)) return false;
      for (const int axis : {0, 1})
        if (v.borders[axis] >= 0 && places_[i][axis] != mpq_class(partition_.borders[axis][v.borders[axis]]))
          return false;
      for (const int axis : {0, 1, 2})
        if (coordinateOf(cut_.places[i], axis) != nearestDouble(places_[i][axis])) return false;
      // one vertex at each place of an edge
      if (v.kind == CutVertex::OnEdge && !onEdges.insert({{v.a, v.b}, places_[i]}).second) return false;
    }
    return true;
  }

  std::string degenerate(Index t, const std::vector<const CutTriangle*>& pieces) const {
    if (pieces.size() != 1 || pieces[0]->corners != mesh_.triangles[t]) return "degenerate";
    const CellBounds& b = partition_.cells[pieces[0]->cell].bounds;
    const Vec3& p = mesh_.vertices[mesh_.triangles[t][0]];
    for (const int axis : {0, 1, 2})
      if (!(b.lower[axis] <= coordinateOf(p, axis) && coordinateOf(p, axis) < b.upper[axis]))
        return "degenerate's cell";
    return {};
  }

  std::string triangle(Index t, const std::vector<const CutTriangle*>& pieces) {
    const auto& f = mesh_.triangles[t];
    const Rational3 whole = cross(places_[f[0]], places_[f[1]], places_[f[2]]);
    Rational3 sum{0, 0, 0};
    std::set<std::pair<Index, Index>> sides;
    std::set<Rational3> distinct;
    std::set<Index> used;
    for (const CutTriangle* piece : pieces) {
      const auto& c = piece->corners;
      const Rational3 n = cross(places_[c[0]], places_[c[1]], places_[c[2]]);
      mpq_class dot = 0;
      for (int k = 0; k < 3; ++k) {
        dot += n[k] * whole[k];
        sum[k] += n[k];
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        if (n[i] * whole[j] != n[j] * whole[i]) return "another plane";
        if (!sides.insert({c[k], c[i]}).second) return "two pieces on one side of an edge";
        used.insert(c[k]);
      }
      if (sgn(dot) <= 0) return "degenerate or reversed piece";
      if (auto wrong = cell(t, *piece); !wrong.empty()) return wrong;
    }
    for (const Index v : used) distinct.insert(places_[v]);
    if (distinct.size() != used.size()) return "two vertices in one place";
    if (sum != whole) return "area";
    // each side has another piece behind it, or lies on the triangle's own edges, which all triangles divide alike
    std::array<std::set<std::pair<Index, Index>>, 3> onEdges;
    for (const auto& [p, q] : sides) {
      if (sides.count({q, p}) != 0) continue;
      int edge = -1;
      for (int k = 0; k < 3; ++k) {
        const Rational3 &u = places_[f[k]], &v = places_[f[(k + 1) % 3]];
        const Rational3 zero{0, 0, 0};
        if (cross(u, v, places_[p]) == zero && cross(u, v, places_[q]) == zero) edge = k;
      }
      if (edge < 0) return "a side without a neighbour";
      onEdges[edge].insert({std::min(p, q), std::max(p, q)});
    }
    for (int k = 0; k < 3; ++k) {
      const std::pair edge{std::min(f[k], f[(k + 1) % 3]), std::max(f[k], f[(k + 1) % 3])};
      const auto [it, isNew] = divisions_.try_emplace(edge, onEdges[k]);
      if (it->second != onEdges[k]) return "an edge divided otherwise than by its neighbour";
    }
    return {};
  }

  std::string cell(Index t, const CutTriangle& piece) const {
    const CellBounds& b = partition_.cells[piece.cell].bounds;
    for (const int axis : {0, 1}) {
      mpq_class low = places_[piece.corners[0]][axis], high = low;
      for (const Index v : piece.corners) {
        low = std::min(low, places_[v][axis]);
        high = std::max(high, places_[v][axis]);
      }
      if (std::isfinite(b.lower[axis]) && low < mpq_class(b.lower[axis])) return "below its cell";
      if (std::isfinite(b.upper[axis]) && (high > mpq_class(b.upper[axis]) || low >= mpq_class(b.upper[axis])))
        return "above its cell";
    }
    const auto& f = mesh_.triangles[t];
    const double z = std::min({mesh_.vertices[f[0]].z, mesh_.vertices[f[1]].z, mesh_.vertices[f[2]].z});
    if (!(b.lower[2] <= z && z < b.upper[2])) return "height of its cell";
    return {};
  }

  const SourceMesh& mesh_;
  const Partition& partition_;
  CutGeometry geometry_;
  const CutEnvironment& cut_;
  std::vector<Rational3> places_;
  std::map<std::pair<Index, Index>, std::set<std::pair<Index, Index>>> divisions_;
};

/// Cuts a soup in several ways and checks the cuts; returns the error, or an empty text.
inline std::string checkSoup(const Soup& soup, std::uint64_t seed, int cuts) {
  if (soup.size() == 0) return {};
  Random random(seed);
  const SourceMesh mesh = meshOf(soup);
  const Partition partition = randomPartition(random, mesh, cuts);
  const CutEnvironment cut = cutEnvironment(mesh, partition, {}, false);
  if (auto wrong = Check(mesh, partition, cut).run({}); !wrong.empty()) return wrong;
  if (cut.closedTriangles != 0) return "closed without rounding";

  std::vector<std::uint32_t> order(soup.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
  std::shuffle(order.begin(), order.end(), random);
  const CutEnvironment shuffled = cutEnvironment(meshOf(soup, order), partition, {}, false);
  // The start of a triangle with a repeated corner depends on where it started.
  const bool repeats = std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                                   [](const auto& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; });
  if (!repeats && (shuffled.vertices != cut.vertices || shuffled.triangles != cut.triangles))
    return "depends on the order";

  std::vector<char> included(mesh.triangles.size());
  for (char& c : included) c = static_cast<char>(integer(random, 0, 2) != 0);
  const CutEnvironment some = cutEnvironment(mesh, partition, included, false);
  if (auto wrong = Check(mesh, partition, some).run(included); !wrong.empty()) return "some: " + wrong;

  const CutEnvironment rounded = cutEnvironment(mesh, partition, {}, true);
  if (rounded.triangles.size() + rounded.closedTriangles != cut.triangles.size()) return "count of closed triangles";
  for (const CutTriangle& t : rounded.triangles) {
    if (mesh.degenerate[t.source] != 0) continue;
    for (int k = 0; k < 3; ++k) {
      const Vec3 &p = rounded.places[t.corners[k]], &q = rounded.places[t.corners[(k + 1) % 3]];
      if (p.x == q.x && p.y == q.y && p.z == q.z) return "repeated vertex after rounding";
    }
  }
  return {};
}

inline Soup scaled(const Soup& soup, double factor, double shift) {
  return soup.mapped([=](const Vec3& p) { return Vec3{p.x * factor + shift, p.y * factor - shift, p.z * factor}; });
}

}  // namespace footfall::test
