// Degenerate soups of all sizes of grids, and what the family of points and lines is by its definition.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <QtTest>
#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "core/exact/face_geometry.hpp"
#include "tests/support/exact_turn.hpp"

namespace footfall::test {
using namespace detail;

using Random = std::mt19937_64;
using Rational3 = std::array<mpq_class, 3>;

inline int turnOf(const Rational3& a, const Rational3& b, const Rational3& c) {
  return exactTurn(a[0], a[1], b[0], b[1], c[0], c[1]);
}
inline int compare(const mpq_class& a, const mpq_class& b) { return (a > b ? 1 : 0) - (a < b ? 1 : 0); }

inline int integer(Random& random, int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }

/// Coordinates of a soup: what grid they make.
enum class Numbers { Tiny, Decimal, Turned, Map, WidestFixed, BeyondFixed, Huge, Extreme, Subnormal };

/// A row for each of them.
inline void addNumbers() {
  QTest::addColumn<int>("numbers");
  QTest::newRow("small integers") << int(Numbers::Tiny);
  QTest::newRow("decimals") << int(Numbers::Decimal);
  QTest::newRow("turned") << int(Numbers::Turned);
  QTest::newRow("map coordinates with noise") << int(Numbers::Map);
  QTest::newRow("widest grid of fixed integers") << int(Numbers::WidestFixed);
  QTest::newRow("just wider") << int(Numbers::BeyondFixed);
  QTest::newRow("huge and tiny") << int(Numbers::Huge);
  QTest::newRow("extreme") << int(Numbers::Extreme);
  QTest::newRow("subnormal") << int(Numbers::Subnormal);
}

/// Coordinates of Numbers::WidestFixed are below two to this.
constexpr int kWidestTop = 3;

inline double randomCoordinate(Random& random, Numbers numbers) {
  const double small = integer(random, -4, 4);
  switch (numbers) {
    case Numbers::Tiny:
      return small;
    case Numbers::Decimal:
      return integer(random, -300, 300) / 10.0;
    case Numbers::Turned:  // 53 bits and more, planes and lines kept only nearly
      return small * 0.8660254037844386 + integer(random, -4, 4) * 0.5;
    case Numbers::Map:
      return integer(random, 0, 3) == 0 ? small * 1e-9 : small / 10 + 122000.123;
    case Numbers::WidestFixed:
      return integer(random, 0, 2) == 0 ? std::ldexp(small, kWidestTop - kWidestFixedGrid)
                                        : (small < 0 ? -1 : 1) * (8 - std::ldexp(integer(random, 1, 3), -50));
    case Numbers::BeyondFixed:
      return integer(random, 0, 2) == 0 ? small * std::ldexp(1, -200) : small;
    case Numbers::Huge:
      return std::ldexp(small, integer(random, 0, 1) == 0 ? -300 : 200);
    case Numbers::Extreme:  // wider than even single triangles can have on the stack
      return std::ldexp(small, integer(random, 0, 1) == 0 ? -1060 : 900);
    case Numbers::Subnormal:
      return std::ldexp(small, integer(random, -1074, -1070));
  }
  return 0;
}

/// Points that often repeat a coordinate of an earlier one, or continue the line of two or the plane of three.
inline std::vector<Vec3> randomPoints(Random& random, Numbers numbers, int count) {
  std::vector<Vec3> points;
  const auto earlier = [&]() -> const Vec3& { return points[integer(random, 0, static_cast<int>(points.size()) - 1)]; };
  while (static_cast<int>(points.size()) < count) {
    Vec3 p{randomCoordinate(random, numbers), randomCoordinate(random, numbers), randomCoordinate(random, numbers)};
    if (points.size() >= 3) {
      const int kind = integer(random, 0, 9);
      if (kind == 0) p.x = earlier().x;
      if (kind <= 1) p.y = earlier().y;
      if (kind <= 2) p.z = earlier().z;
      const Vec3 a = earlier(), b = earlier(), c = earlier();
      if (kind == 3) p = {a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2, a.z + (b.z - a.z) / 2};
      if (kind == 4) p = {a.x + (b.x - c.x), a.y + (b.y - c.y), a.z + (b.z - c.z)};
      if (kind == 5) p = {a.x, a.y, p.z};
      if (kind == 6) p = {std::nextafter(a.x, b.x), a.y, a.z};
    }
    Grid grid;
    for (const double x : {p.x, p.y, p.z}) grid.include(x);
    if (numbers == Numbers::WidestFixed && (grid.low < kWidestTop - kWidestFixedGrid || grid.top > kWidestTop))
      continue;
    points.push_back(p);
  }
  return points;
}

/// A soup with at least one triangle that faces up.
inline std::shared_ptr<const SourceMesh> randomMesh(Random& random, Numbers numbers, int triangles) {
  for (;;) {
    TriangleSoup soup;
    soup.vertices = randomPoints(random, numbers, 2 * triangles);
    for (int i = 0; i < triangles; ++i) {
      std::array<std::uint32_t, 3> t{};
      for (auto& v : t) v = static_cast<std::uint32_t>(integer(random, 0, 2 * triangles - 1));
      soup.triangles.push_back(t);
    }
    auto mesh = std::make_shared<SourceMesh>(makeSourceMesh(soup, true));
    for (const auto f : mesh->facing)
      if (f > 0) return mesh;
  }
}

inline Rational3 rational(const Vec3& p) { return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}; }

inline mpq_class orientation(const Rational3& a, const Rational3& b, const Rational3& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The points and lines of the family, straight from their definition and in the environment's coordinates.
class Reference {
 public:
  explicit Reference(const PlanKernel& kernel)
      : mesh_(kernel.mesh()), heights_(kernel.heights()), borders_(kernel.borders()) {}

  [[nodiscard]] Rational3 vertex(Index v) const { return rational(mesh_.vertices[v]); }
  [[nodiscard]] Rational3 normal(Index t) const {
    const auto& f = mesh_.triangles[t];
    const Rational3 a = vertex(f[0]), b = vertex(f[1]), c = vertex(f[2]);
    Rational3 n;
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      n[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
    }
    return n;
  }
  [[nodiscard]] mpq_class level(Index level) const {
    return level == 0  ? mpq_class(0)
           : level > 0 ? mpq_class(heights_[level - 1])
                       : mpq_class(-mpq_class(heights_[-level - 1]));
  }
  /// Height of a triangle's plane at a place.
  [[nodiscard]] mpq_class planeHeight(Index t, const mpq_class& x, const mpq_class& y) const {
    const Rational3 n = normal(t), a = vertex(mesh_.triangles[t][0]);
    return a[2] - (n[0] * (x - a[0]) + n[1] * (y - a[1])) / n[2];
  }
  /// A line at a place: positive on its left, where the obstacle is above floor + level, or above a border.
  [[nodiscard]] mpq_class lineAt(const PlanLine& line, Index face, const mpq_class& x, const mpq_class& y) const {
    if (line.kind == PlanLine::Edge) return orientation(vertex(line.a), vertex(line.b), {x, y, 0});
    if (line.kind == PlanLine::Border) return (line.a == 0 ? x : y) - mpq_class(borders_[line.a][line.b]);
    return planeHeight(line.a, x, y) - planeHeight(face, x, y) - level(line.b);
  }
  [[nodiscard]] bool parallel(const PlanLine& l, const PlanLine& m, Index face) const {
    const auto [a, b] = slope(l, face);
    const auto [c, d] = slope(m, face);
    return a * d == b * c;
  }
  /// Place in the plan.
  [[nodiscard]] Rational3 point(const PlanPoint& p) const {
    if (p.kind() == PlanPoint::Source) return vertex(p.planId());
    if (p.kind() == PlanPoint::EdgePlane) {
      const Rational3 a = vertex(p.edgeBegin()), b = vertex(p.edgeEnd());
      const mpq_class ha = a[2] - planeHeight(p.triangle(), a[0], a[1]) - level(p.level());
      const mpq_class hb = b[2] - planeHeight(p.triangle(), b[0], b[1]) - level(p.level());
      const mpq_class t = ha / (ha - hb);
      return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), 0};
    }
    const auto [a, b] = slope(p.firstLine(), p.face());
    const auto [c, d] = slope(p.secondLine(), p.face());
    const mpq_class l = lineAt(p.firstLine(), p.face(), 0, 0), m = lineAt(p.secondLine(), p.face(), 0, 0),
                    w = a * d - b * c;
    return {(b * m - d * l) / w, (c * l - a * m) / w, 0};
  }

 private:
  [[nodiscard]] std::pair<mpq_class, mpq_class> slope(const PlanLine& l, Index face) const {
    const mpq_class at = lineAt(l, face, 0, 0);
    return {lineAt(l, face, 1, 0) - at, lineAt(l, face, 0, 1) - at};
  }
  const SourceMesh& mesh_;
  const std::vector<double>& heights_;
  const BorderCoordinates& borders_;
};

/// Borders that pass through vertices and through crossings of lines of the family, or just beside; or anywhere,
/// in the numbers of any soup.
inline BorderCoordinates randomBorders(Random& random, Numbers numbers, const PlanKernel& kernel,
                                       FaceGeometry& geometry) {
  const SourceMesh& mesh = kernel.mesh();
  const Reference reference(kernel);
  BorderCoordinates borders;
  const auto number = [&](std::size_t count) { return integer(random, 0, static_cast<int>(count) - 1); };
  for (const int axis : {0, 1}) {
    const auto vertex = [&] {
      const Vec3& v = mesh.vertices[number(mesh.vertices.size())];
      return axis == 0 ? v.x : v.y;
    };
    for (int i = 0; i < 4; ++i) borders[axis].push_back(vertex());
    borders[axis].push_back(std::nextafter(vertex(), vertex()));
    borders[axis].push_back(vertex() / 2 + vertex() / 2);
    borders[axis].push_back(randomCoordinate(random, numbers));
    // now and then wider than the grid, finer than doubles can follow, or far away
    if (integer(random, 0, 2) == 0) borders[axis].push_back(randomCoordinate(random, Numbers(integer(random, 0, 8))));
    if (integer(random, 0, 4) == 0) borders[axis].push_back(std::ldexp(integer(random, -3, 3), -1074));
    // through traces' crossings that doubles hold
    for (int i = 0; i < 30; ++i) {
      const auto face = static_cast<Index>(number(mesh.triangles.size()));
      const auto other = static_cast<Index>(number(mesh.triangles.size()));
      if (mesh.facing[face] <= 0 || mesh.facing[other] == 0 || face == other) continue;
      geometry.start(face);
      const PlanLine trace{PlanLine::Trace, other, integer(random, 0, 1)};
      const int edge = integer(random, 0, 2);
      if (reference.parallel(trace, geometry.lineAt(edge), face)) continue;
      const mpq_class c = reference.point(geometry[geometry.crossing(geometry.line(trace), edge)])[axis];
      if (std::isfinite(nearestDouble(c)) && mpq_class(nearestDouble(c)) == c)
        borders[axis].push_back(nearestDouble(c));
    }
    auto& b = borders[axis];
    std::erase_if(b, [&](double c) {
      Grid grid;
      grid.include(c);
      return !std::isfinite(c) || (numbers == Numbers::WidestFixed && !grid.empty() &&
                                   (grid.low < kWidestTop - kWidestFixedGrid || grid.top > kWidestTop));
    });
    std::sort(b.begin(), b.end());
    b.erase(std::unique(b.begin(), b.end()), b.end());
  }
  return borders;
}

inline bool identical(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

}  // namespace footfall::test
