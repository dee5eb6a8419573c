// Every predicate of the exact core against a slow reference of its own in rational numbers, on degenerate soups of all
// sizes of grids.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmpxx.h>

#include <QtTest>
#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "core/exact/face_geometry.hpp"
#include "core/exact/source_predicates.hpp"
#include "tests/support/exact_turn.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

using Random = std::mt19937_64;
using Rational3 = std::array<mpq_class, 3>;

int turnOf(const Rational3& a, const Rational3& b, const Rational3& c) {
  return test::exactTurn(a[0], a[1], b[0], b[1], c[0], c[1]);
}
int compare(const mpq_class& a, const mpq_class& b) { return (a > b ? 1 : 0) - (a < b ? 1 : 0); }

int integer(Random& random, int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }

/// Coordinates of a soup: what grid they make.
enum class Numbers { Tiny, Decimal, Turned, Map, WidestFixed, BeyondFixed, Huge, Extreme, Subnormal };

/// Coordinates of Numbers::WidestFixed are below two to this.
constexpr int kWidestTop = 3;

double randomCoordinate(Random& random, Numbers numbers) {
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
std::vector<Vec3> randomPoints(Random& random, Numbers numbers, int count) {
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
std::shared_ptr<const SourceMesh> randomMesh(Random& random, Numbers numbers, int triangles) {
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

Rational3 rational(const Vec3& p) { return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}; }

mpq_class orientation(const Rational3& a, const Rational3& b, const Rational3& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// What the points and lines of the family are, straight from their definition and in the environment's coordinates.
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
BorderCoordinates randomBorders(Random& random, Numbers numbers, const PlanKernel& kernel, FaceGeometry& geometry) {
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

bool identical(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

}  // namespace

class TestExactPredicates : public QObject {
  Q_OBJECT

 private slots:
  void singleTriangles_data() {
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
  void singleTriangles() {
    QFETCH(int, numbers);
    Random random(test::seed() + static_cast<std::uint64_t>(numbers));
    for (int i = 0; i < test::rounds(10'000); ++i) {
      const std::vector<Vec3> points = randomPoints(random, Numbers(numbers), 5);
      const Vec3 &a = points[2], &b = points[3], &c = points[4];
      const Rational3 p = rational(a), q = rational(b), r = rational(c);
      const auto component = [&](int j, int k) -> mpq_class {
        return (q[j] - p[j]) * (r[k] - p[k]) - (q[k] - p[k]) * (r[j] - p[j]);
      };
      const Rational3 n{component(1, 2), component(2, 0), component(0, 1)};
      QCOMPARE(isDegenerate(a, b, c), n[0] == 0 && n[1] == 0 && n[2] == 0);
      QCOMPARE(facing(a, b, c), sgn(n[2]));
      const mpq_class flat = n[0] * n[0] + n[1] * n[1], up = n[2] * n[2];
      QCOMPARE(isWithinSlope(a, b, c, 30), sgn(n[2]) > 0 && up >= 3 * flat);
      QCOMPARE(isWithinSlope(a, b, c, 45), sgn(n[2]) > 0 && up >= flat);
      QCOMPARE(isWithinSlope(a, b, c, 60), sgn(n[2]) > 0 && 3 * up >= flat);
    }
  }

  void family_data() { singleTriangles_data(); }
  void family() {
    QFETCH(int, numbers);
    Random random(test::seed() + 100 + static_cast<std::uint64_t>(numbers));
    for (int i = 0; i < test::rounds(Numbers(numbers) == Numbers::Extreme ? 3 : 9); ++i) {
      const auto mesh = randomMesh(random, Numbers(numbers), 7);
      double height = integer(random, 0, 1) == 0 ? 2 : 1.1;
      if (Numbers(numbers) == Numbers::Huge) height = std::ldexp(3, 200);
      if (Numbers(numbers) == Numbers::Extreme) height = std::ldexp(3, 900);
      if (Numbers(numbers) == Numbers::Subnormal) height = std::ldexp(3, -1072);
      const PlanKernel kernel(mesh, {height});
      if (Numbers(numbers) == Numbers::WidestFixed) QVERIFY(kernel.fitsFixedIntegers());
      if (Numbers(numbers) == Numbers::Extreme) QVERIFY(!kernel.fitsFixedIntegers());
      FaceGeometry geometry(kernel);
      for (Index face = 0; face < static_cast<Index>(mesh->triangles.size()); ++face)
        if (mesh->facing[face] > 0) checkFace(random, kernel, geometry, face);
      const PlanKernel withBorders(mesh, {height}, randomBorders(random, Numbers(numbers), kernel, geometry));
      if (Numbers(numbers) == Numbers::WidestFixed) QVERIFY(withBorders.fitsFixedIntegers());
      FaceGeometry divided(withBorders);
      for (Index face = 0; face < static_cast<Index>(mesh->triangles.size()); ++face)
        if (mesh->facing[face] > 0) checkFace(random, withBorders, divided, face);
    }
  }

  void borders_data() { singleTriangles_data(); }
  void borders() {
    // what does not meet them does not notice them
    QFETCH(int, numbers);
    Random random(test::seed() + 200 + static_cast<std::uint64_t>(numbers));
    for (int i = 0; i < test::rounds(Numbers(numbers) == Numbers::Extreme ? 2 : 12); ++i) {
      const auto mesh = randomMesh(random, Numbers(numbers), 7);
      const PlanKernel without(mesh, {1.1});
      FaceGeometry plain(without);
      BorderCoordinates borders = randomBorders(random, Numbers(numbers), without, plain);
      const auto addBorder = [&](double c) {
        for (auto& b : borders)
          if (std::find(b.begin(), b.end(), c) == b.end()) b.insert(std::upper_bound(b.begin(), b.end(), c), c);
      };
      if (i % 4 == 1) addBorder(1e300);
      if (i % 4 == 2) addBorder(1e-300);
      if (i % 4 == 3) addBorder(5e-324);
      const PlanKernel with(mesh, {1.1}, borders);
      QVERIFY(with.borders() == borders);
      for (const int axis : {0, 1})
        for (std::size_t b = 0; b < borders[axis].size(); ++b)
          QCOMPARE(with.borderOf(axis, borders[axis][b]), std::optional(static_cast<Index>(b)));
      QVERIFY(!with.borderOf(0, -1.5e300));
      QVERIFY(identical(with.sign().slack, without.sign().slack) && with.sign().zeroValid == without.sign().zeroValid);
      FaceGeometry divided(with);
      for (Index face = 0; face < static_cast<Index>(mesh->triangles.size()); ++face)
        if (mesh->facing[face] > 0) compareFaces(random, plain, divided, face);
      QCOMPARE(divided.fallbacks.total(), plain.fallbacks.total());
    }
  }

  void borderCrossings() {
    // canonical forms: a vertex where a border passes through it, else lines in order, and a face only with a trace
    TriangleSoup soup;
    soup.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {3, 1, 1}, {1, 3, -1}};
    soup.triangles = {{0, 1, 2}, {3, 4, 5}};
    const auto mesh = std::make_shared<SourceMesh>(makeSourceMesh(soup, false));
    const PlanKernel kernel(mesh, {}, {std::vector<double>{-0.0, 2}, {1.5}});
    QVERIFY(!std::signbit(kernel.borders()[0][0]));
    FaceGeometry geometry(kernel);
    const Index face = mesh->vertices[mesh->triangles[0][0]].z == 0 ? 0 : 1;
    geometry.start(face);
    const Index origin = geometry.line({PlanLine::Border, 0, 0}), x = geometry.line({PlanLine::Border, 0, 1}),
                y = geometry.line({PlanLine::Border, 1, 0}), trace = geometry.line({PlanLine::Trace, 1 - face, 0});
    const auto is = [&](Index p, double px, double py) {
      const auto place = kernel.exactPosition(geometry[p], face);
      return place[0] == px && place[1] == py;
    };
    for (int k = 0; k < 3; ++k) {
      const auto& f = mesh->triangles[face];
      const Vec3 &a = mesh->vertices[f[k]], &b = mesh->vertices[f[(k + 1) % 3]];
      if (a.x == b.x) continue;  // parallel
      const Index corner = geometry.crossing(origin, k);
      QCOMPARE(Index(geometry[corner].kind()), Index(PlanPoint::Source));
      const Index inner = geometry.crossing(k, x);
      QCOMPARE(inner, geometry.crossing(x, k));
      QVERIFY(geometry[inner].firstLine() == geometry.lineAt(k));
      QVERIFY(geometry[inner].secondLine() == (PlanLine{PlanLine::Border, 0, 1}));
      QCOMPARE(geometry[inner].face(), -1);
      QVERIFY(is(inner, 2, a.y == b.y ? 0 : 2));
    }
    const Index both = geometry.crossing(y, x);
    QCOMPARE(both, geometry.crossing(x, y));
    QVERIFY(geometry[both] == PlanPoint::crossing({PlanLine::Border, 0, 1}, {PlanLine::Border, 1, 0}, -1));
    QVERIFY(is(both, 2, 1.5));
    const Index onTrace = geometry.crossing(y, trace);
    QCOMPARE(onTrace, geometry.crossing(trace, y));
    QCOMPARE(geometry[onTrace].face(), face);
    QVERIFY(is(onTrace, 2, 1.5));
    QCOMPARE(geometry.side(x, onTrace), 0);
    QCOMPARE(geometry.side(y, onTrace), 0);
    QCOMPARE(geometry.compare(onTrace, both, 0), 0);
    QCOMPARE(geometry.compare(onTrace, both, 1), 0);
  }

  void widestGridIsReached() {
    // the suite means what it says: integers on the stack are met up to their limit
    Random random(test::seed());
    int widest = 0;
    for (int i = 0; i < 20; ++i) widest = std::max(widest, randomMesh(random, Numbers::WidestFixed, 7)->grid.width());
    QCOMPARE(widest, kWidestFixedGrid);
  }

 private:
  static void compareFaces(Random& random, FaceGeometry& plain, FaceGeometry& divided, Index face) {
    const SourceMesh& mesh = plain.kernel().mesh();
    const Reference reference(plain.kernel());
    const auto number = [&](std::size_t count) { return integer(random, 0, static_cast<int>(count) - 1); };
    plain.start(face);
    divided.start(face);
    // on the side of the borders only, in between: the others must not notice
    const auto triangles = static_cast<int>(mesh.triangles.size());
    for (int i = 0; i < 20; ++i) {
      const Index o = integer(random, 0, triangles - 1);
      const auto& f = mesh.triangles[o];
      for (int k = 0; k < 3; ++k)
        if (mesh.planIds[f[k]] != mesh.planIds[f[(k + 1) % 3]]) {
          QCOMPARE(divided.edgeLine(mesh.planIds[f[k]], mesh.planIds[f[(k + 1) % 3]]),
                   plain.edgeLine(mesh.planIds[f[k]], mesh.planIds[f[(k + 1) % 3]]));
        }
      const PlanLine trace{PlanLine::Trace, o, integer(random, 0, 1)};
      if (o == face || mesh.facing[o] == 0) continue;
      const auto c = plain.kernel().exactCoefficients(trace, face, plain.origin());
      if (c[0] != 0 || c[1] != 0) QCOMPARE(divided.line(trace), plain.line(trace));
    }
    for (int i = 0; i < 40; ++i) {
      const Index l = number(plain.lineCount()), m = number(plain.lineCount());
      if (reference.parallel(plain.lineAt(l), plain.lineAt(m), face)) continue;
      const Index p = plain.crossing(l, m);
      QCOMPARE(divided.crossing(l, m), p);
      QVERIFY(divided[p] == plain[p]);
      const ApproximatePoint &a = plain.approximate(p), &b = divided.approximate(p);
      QVERIFY(identical(a.x, b.x) && identical(a.y, b.y) && identical(a.error, b.error));
      bool exactA = false, exactB = false;
      const Vec3 roundedA = plain.kernel().roundedPosition(plain[p], face, &exactA);
      const Vec3 roundedB = divided.kernel().roundedPosition(plain[p], face, &exactB);
      QVERIFY(identical(roundedA.x, roundedB.x) && identical(roundedA.y, roundedB.y) &&
              identical(roundedA.z, roundedB.z) && exactA == exactB);
      const Index q = number(plain.pointCount()), r = number(plain.pointCount());
      QCOMPARE(divided.orientation(p, q, r), plain.orientation(p, q, r));
      QCOMPARE(divided.compare(p, q, 0), plain.compare(p, q, 0));
      QCOMPARE(divided.side(l, q), plain.side(l, q));
    }
  }

  static void checkFace(Random& random, const PlanKernel& kernel, FaceGeometry& geometry, Index face) {
    const SourceMesh& mesh = kernel.mesh();
    const Reference reference(kernel);
    const auto triangles = static_cast<Index>(mesh.triangles.size());
    ExactFallbacks count;
    geometry.start(face);
    std::vector<Index> lines{0, 1, 2}, points{0, 1, 2};
    for (Index o = 0; o < triangles; ++o) {
      if (mesh.degenerate[o] != 0) continue;
      const auto& f = mesh.triangles[o];
      for (int k = 0; k < 3; ++k) {
        const Index u = f[k], v = f[(k + 1) % 3];
        points.push_back(geometry.point(PlanPoint::source(mesh.planIds[u])));
        if (mesh.planIds[u] == mesh.planIds[v]) continue;
        lines.push_back(geometry.edgeLine(mesh.planIds[u], mesh.planIds[v]));
        for (const Index level : {0, 1}) {
          const int a = kernel.heightSign(face, u, level, count), b = kernel.heightSign(face, v, level, count);
          if (o != face && a != b && a * b <= 0)
            points.push_back(geometry.point(PlanPoint::edgePlane(u, v, face, level)));
        }
      }
      if (o == face || mesh.facing[o] == 0) continue;
      for (const Index level : {0, 1}) {
        const PlanLine trace{PlanLine::Trace, o, level};
        if (!reference.parallel(trace, trace, face)) continue;
        if (reference.lineAt(trace, face, 1, 0) != reference.lineAt(trace, face, 0, 0) ||
            reference.lineAt(trace, face, 0, 1) != reference.lineAt(trace, face, 0, 0))
          lines.push_back(geometry.line(trace));
      }
    }
    for (const int axis : {0, 1})
      for (std::size_t b = 0; b < kernel.borders()[axis].size(); ++b)
        lines.push_back(geometry.line({PlanLine::Border, axis, static_cast<Index>(b)}));
    const auto any = [&](const std::vector<Index>& of) {
      return of[integer(random, 0, static_cast<int>(of.size()) - 1)];
    };
    const bool hasBorders = !kernel.borders()[0].empty();
    for (int i = 0; i < (hasBorders ? 50 : 25); ++i) {
      const Index l = any(lines), m = i % 5 == 1 && hasBorders ? lines.back() : any(lines);
      if (!reference.parallel(geometry.lineAt(l), geometry.lineAt(m), face)) points.push_back(geometry.crossing(l, m));
    }
    std::vector<Rational3> places;
    for (const Index p : points) places.push_back(reference.point(geometry[p]));

    for (std::size_t i = 0; i < points.size(); ++i) checkPoint(kernel, geometry, points[i], places[i], reference);
    for (int i = 0; i < 60; ++i) {
      const auto pick = [&] {
        return static_cast<std::size_t>(integer(random, 0, static_cast<int>(points.size()) - 1));
      };
      const std::size_t a = pick(), b = pick(), c = pick();
      const PlanPoint &p = geometry[points[a]], &q = geometry[points[b]], &r = geometry[points[c]];
      const int turn = turnOf(places[a], places[b], places[c]);
      QCOMPARE(geometry.orientation(points[a], points[b], points[c]), turn);
      QCOMPARE(kernel.orientation(p, q, r, geometry.origin(), count), turn);
      QVERIFY(turn == 0 || !kernel.areKnownCollinear(p, q, r));
      for (const int axis : {0, 1}) {
        const int order = compare(places[a][axis], places[b][axis]);
        QCOMPARE(geometry.compare(points[a], points[b], axis), order);
        QCOMPARE(kernel.compare(p, q, axis, geometry.origin(), count), order);
      }
      const Index l = any(lines);
      const int side = sgn(reference.lineAt(geometry.lineAt(l), face, places[a][0], places[a][1]));
      QCOMPARE(geometry.side(l, points[a]), side);
      QCOMPARE(kernel.side(geometry.lineAt(l), face, p, geometry.origin(), count), side);
      QVERIFY(side == 0 || !kernel.isKnownOn(geometry.lineAt(l), face, p));
      if (geometry.lineAt(l).kind == PlanLine::Border) {
        const auto known = kernel.knownSide(geometry.lineAt(l), p);
        QVERIFY(!known || *known == side);
        QVERIFY(p.kind() != PlanPoint::Source || known);
      }
      const Index other = integer(random, 0, triangles - 1);
      if (mesh.facing[other] != 0)
        QCOMPARE(kernel.compareHeight(p, face, other, count),
                 sgn(reference.planeHeight(face, places[a][0], places[a][1]) -
                     reference.planeHeight(other, places[a][0], places[a][1])));
      const auto vertex = [&] { return integer(random, 0, static_cast<int>(mesh.vertices.size()) - 1); };
      const Index u = vertex(), v = vertex(), w = vertex();
      QCOMPARE(kernel.orientation(u, v, w, count),
               turnOf(reference.vertex(u), reference.vertex(v), reference.vertex(w)));
      const Rational3 place = reference.vertex(u);
      for (const Index level : {-1, 0, 1})
        QCOMPARE(kernel.heightSign(face, u, level, count),
                 sgn(place[2] - reference.planeHeight(face, place[0], place[1]) - reference.level(level)));
    }
    for (int k = 0; k < 3; ++k) {
      const auto& f = mesh.triangles[face];
      const Rational3 a = reference.vertex(f[k]), b = reference.vertex(f[(k + 1) % 3]);
      for (std::size_t i = 0; i < points.size(); ++i)
        QCOMPARE(geometry.sideOfEdge(k, points[i]), turnOf(a, b, places[i]));
    }
  }

  static void checkPoint(const PlanKernel& kernel, const FaceGeometry& geometry, Index point, const Rational3& place,
                         const Reference& reference) {
    const SourceMesh& mesh = kernel.mesh();
    const Index face = geometry.face();
    const PlanPoint& p = geometry[point];
    for (const int axis : {0, 1})
      if (const auto known = kernel.knownCoordinate(p, axis)) QVERIFY(mpq_class(*known) == place[axis]);
    if (p.kind() == PlanPoint::Crossing) {
      QVERIFY(kernel.isKnownOn(p.firstLine(), p.face(), p) && kernel.isKnownOn(p.secondLine(), p.face(), p));
      for (const PlanLine& line : {p.firstLine(), p.secondLine()})
        if (line.kind == PlanLine::Border) {
          const auto known = kernel.knownCoordinate(p, line.a);
          QVERIFY(known && mpq_class(*known) == place[line.a]);
        }
    }
    // the rounded coordinates, relative to the face's first corner and scaled, enclose the exact ones
    const ApproximatePoint& approximate = geometry.approximate(point);
    const Rational3 origin = reference.vertex(geometry.origin());
    const int scale = mesh.grid.scaleExponent();
    for (const int axis : {0, 1}) {
      mpq_class exact = place[axis] - origin[axis];
      if (scale >= 0)
        exact *= mpz_class(1) << static_cast<mp_bitcnt_t>(scale);
      else
        exact /= mpz_class(1) << static_cast<mp_bitcnt_t>(-scale);
      const double value = axis == 0 ? approximate.x : approximate.y;
      if (std::isfinite(approximate.error)) QVERIFY(abs(exact - mpq_class(value)) <= mpq_class(approximate.error));
    }
    const Rational3 lifted{place[0], place[1], reference.planeHeight(face, place[0], place[1])};
    const Rational3 position = kernel.exactPosition(p, face);
    QVERIFY(position == lifted);
    bool exact = false;
    const Vec3 rounded = kernel.roundedPosition(p, face, &exact);
    // QCOMPARE would let doubles differ
    QVERIFY(rounded.x == nearestDouble(lifted[0]));
    QVERIFY(rounded.y == nearestDouble(lifted[1]));
    QVERIFY(rounded.z == nearestDouble(lifted[2]));
    if (std::isfinite(rounded.x) && std::isfinite(rounded.y) && std::isfinite(rounded.z))
      QCOMPARE(exact, rational(rounded) == lifted);
  }
};

QTEST_APPLESS_MAIN(TestExactPredicates)
#include "test_exact_predicates.moc"
