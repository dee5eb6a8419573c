// The exact predicates against rational arithmetic, on random and on degenerate input.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmpxx.h>

#include <QtTest>
#include <cmath>
#include <functional>
#include <random>

#include "core/exact/error_double.hpp"
#include "core/exact/face_triangulation.hpp"
#include "core/exact/plan_kernel.hpp"
#include "core/exact/shape.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/filters/clearance/three_signs.hpp"
#include "tests/support/exact_turn.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

using Random = std::mt19937_64;

int rounds() {
  const int factor = qEnvironmentVariableIntValue("FOOTFALL_TEST_ROUNDS");
  return factor > 0 ? factor : 1;
}

/// The form of a random soup's coordinates.
enum class Numbers { Tiny, Decimal, Mixed, Huge };

double randomCoordinate(Random& random, Numbers grid) {
  const auto integer = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  switch (grid) {
    case Numbers::Tiny:
      return integer(-3, 3);
    case Numbers::Decimal:
      return integer(-3000, 3000) / 100.0;
    case Numbers::Mixed:
      return integer(0, 3) == 0 ? integer(-2, 2) * 1e-9 : integer(-20, 20) / 10.0 + 122000.123;
    case Numbers::Huge:
      return std::ldexp(integer(-5, 5), integer(0, 1) == 0 ? -300 : 200);
  }
  return 0;
}

Vec3 randomPoint(Random& random, Numbers grid) {
  return {randomCoordinate(random, grid), randomCoordinate(random, grid), randomCoordinate(random, grid)};
}

using Rational3 = std::array<mpq_class, 3>;
Rational3 rational(const Vec3& p) { return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}; }

Rational3 rationalNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Rational3 p = rational(a), q = rational(b), r = rational(c);
  Rational3 u, v;
  for (int k = 0; k < 3; ++k) {
    u[k] = q[k] - p[k];
    v[k] = r[k] - p[k];
  }
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

mpq_class orientation(const Rational3& a, const Rational3& b, const Rational3& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
int turnOf(const Rational3& a, const Rational3& b, const Rational3& c) {
  return test::exactTurn(a[0], a[1], b[0], b[1], c[0], c[1]);
}
int compare(const mpq_class& a, const mpq_class& b) { return (a > b ? 1 : 0) - (a < b ? 1 : 0); }

/// A soup with at least one triangle that faces up.
std::shared_ptr<const SourceMesh> randomMesh(Random& random, Numbers grid, int triangles) {
  for (;;) {
    TriangleSoup soup;
    for (int i = 0; i < 3 * triangles; ++i) soup.vertices.push_back(randomPoint(random, grid));
    for (int i = 0; i < triangles; ++i) {
      std::array<std::uint32_t, 3> t{};
      for (auto& v : t) v = std::uniform_int_distribution<std::uint32_t>(0, 3 * triangles - 1)(random);
      soup.triangles.push_back(t);
    }
    auto mesh = std::make_shared<SourceMesh>(makeSourceMesh(soup, true));
    for (const auto f : mesh->facing)
      if (f > 0) return mesh;
  }
}

}  // namespace

class TestExact : public QObject {
  Q_OBJECT

 private slots:
  void errorDoubleEnclosesTheTruth() {
    Random random(1);
    std::uniform_int_distribution<int> operation(0, 3);
    for (int i = 0; i < 20000 * rounds(); ++i) {
      ErrorDouble x(randomCoordinate(random, Numbers::Decimal));
      mpq_class truth(x.value);
      for (int k = 0; k < 6; ++k) {
        const double y = randomCoordinate(random, k % 2 == 0 ? Numbers::Decimal : Numbers::Mixed);
        switch (operation(random)) {
          case 0:
            x = x + ErrorDouble(y);
            truth += mpq_class(y);
            break;
          case 1:
            x = x - ErrorDouble(y);
            truth -= mpq_class(y);
            break;
          case 2:
            x = x * ErrorDouble(y);
            truth *= mpq_class(y);
            break;
          default:
            if (y == 0) break;
            x = x / ErrorDouble(y);
            truth /= mpq_class(y);
        }
      }
      QVERIFY(abs(truth - mpq_class(x.value)) <= mpq_class(x.error));
      if (const MaybeSign sign = SignRule{}(x)) QCOMPARE(*sign, sgn(truth));
    }
  }

  void sourcePredicates_data() {
    QTest::addColumn<int>("grid");
    QTest::newRow("small integers") << int(Numbers::Tiny);
    QTest::newRow("decimals") << int(Numbers::Decimal);
    QTest::newRow("map coordinates with noise") << int(Numbers::Mixed);
    QTest::newRow("huge and tiny") << int(Numbers::Huge);
  }
  void sourcePredicates() {
    QFETCH(int, grid);
    Random random(2);
    for (int i = 0; i < 20000 * rounds(); ++i) {
      const Vec3 a = randomPoint(random, Numbers(grid)), b = randomPoint(random, Numbers(grid));
      Vec3 c = randomPoint(random, Numbers(grid));
      if (i % 4 == 0) c = {2 * b.x - a.x, 2 * b.y - a.y, 2 * b.z - a.z};  // often exactly collinear
      const Rational3 n = rationalNormal(a, b, c);
      QCOMPARE(isDegenerate(a, b, c), n[0] == 0 && n[1] == 0 && n[2] == 0);
      QCOMPARE(facing(a, b, c), sgn(n[2]));
      const mpq_class flat = n[0] * n[0] + n[1] * n[1], up = n[2] * n[2];
      QCOMPARE(isWithinSlope(a, b, c, 45), sgn(n[2]) > 0 && up >= flat);
      QCOMPARE(isWithinSlope(a, b, c, 30), sgn(n[2]) > 0 && up >= 3 * flat);
      QCOMPARE(isWithinSlope(a, b, c, 60), sgn(n[2]) > 0 && 3 * up >= flat);
    }
  }

  void slopeLimits() {
    // a ramp of exactly 45 degrees, and one that is steeper by the smallest step of a double
    QVERIFY(isWithinSlope({0, 0, 0}, {1, 0, 1}, {0, 1, 0}, 45));
    QVERIFY(!isWithinSlope({0, 0, 0}, {1, 0, std::nextafter(1.0, 2.0)}, {0, 1, 0}, 45));
    QVERIFY(isWithinSlope({0, 0, 0}, {1, 0, std::nextafter(1.0, 0.0)}, {0, 1, 0}, 45));
    // just beside 45 degrees the limit is irrational, and decided all the same
    QVERIFY(!isWithinSlope({0, 0, 0}, {1, 0, 1}, {0, 1, 0}, std::nextafter(45.0, 0.0)));
    QVERIFY(isWithinSlope({0, 0, 0}, {1, 0, 1}, {0, 1, 0}, std::nextafter(45.0, 90.0)));
    // tan 37 degrees lies between these two neighbours
    const double tangent = std::tan(37 * M_PI / 180);
    QVERIFY(isWithinSlope({0, 0, 0}, {1, 0, tangent * (1 - 1e-14)}, {0, 1, 0}, 37));
    QVERIFY(!isWithinSlope({0, 0, 0}, {1, 0, tangent * (1 + 1e-14)}, {0, 1, 0}, 37));
  }

  void kernel_data() { sourcePredicates_data(); }
  void kernel() {
    QFETCH(int, grid);
    Random random(3 + grid);
    for (int i = 0; i < 300 * rounds(); ++i) {
      const auto mesh = randomMesh(random, Numbers(grid), 6);
      const double height = Numbers(grid) == Numbers::Huge ? std::ldexp(3, 200) : i % 2 == 0 ? 2 : 1.1;
      const PlanKernel kernel(mesh, {height});
      FaceGeometry geometry(kernel);
      ExactFallbacks count;
      const auto triangles = static_cast<Index>(mesh->triangles.size());
      for (Index face = 0; face < triangles; ++face) {
        if (mesh->facing[face] <= 0) continue;
        geometry.start(face);
        checkHeights(kernel, face, height);
        // lines of the family, and all their crossings
        std::vector<Index> lines, points{0, 1, 2};
        for (Index o = 0; o < triangles; ++o) {
          if (o == face || mesh->degenerate[o] != 0) continue;
          const auto& f = mesh->triangles[o];
          for (int k = 0; k < 3; ++k)
            if (mesh->planIds[f[k]] != mesh->planIds[f[(k + 1) % 3]])
              lines.push_back(geometry.edgeLine(mesh->planIds[f[k]], mesh->planIds[f[(k + 1) % 3]]));
          if (mesh->facing[o] == 0) continue;
          for (const Index level : {0, 1}) {
            const auto c = kernel.exactCoefficients({PlanLine::Trace, o, level}, face, geometry.origin());
            if (c[0] != 0 || c[1] != 0) lines.push_back(geometry.line({PlanLine::Trace, o, level}));
          }
        }
        for (std::size_t a = 0; a < lines.size() && points.size() < 40; ++a)
          for (std::size_t b = 0; b < a && points.size() < 40; ++b) {
            const auto l = kernel.exactCoefficients(geometry.lineAt(lines[a]), face, geometry.origin());
            const auto m = kernel.exactCoefficients(geometry.lineAt(lines[b]), face, geometry.origin());
            const mpz_class parallel = l[0] * m[1] - l[1] * m[0];
            if (parallel == 0) continue;
            const Index p = geometry.crossing(lines[a], lines[b]);
            QCOMPARE(geometry.side(lines[a], p), 0);
            QCOMPARE(geometry.side(lines[b], p), 0);
            points.push_back(p);
          }
        std::vector<Rational3> places;
        for (const Index p : points) places.push_back(kernel.exactPosition(geometry[p], face));
        std::uniform_int_distribution<std::size_t> pick(0, points.size() - 1);
        for (int n = 0; n < 40; ++n) {
          const std::size_t a = pick(random), b = pick(random), c = pick(random);
          const int expected = turnOf(places[a], places[b], places[c]);
          QCOMPARE(geometry.orientation(points[a], points[b], points[c]), expected);
          QCOMPARE(kernel.orientation(geometry[points[a]], geometry[points[b]], geometry[points[c]], geometry.origin(),
                                      count),
                   expected);
          QCOMPARE(geometry.compare(points[a], points[b], 0), compare(places[a][0], places[b][0]));
          QCOMPARE(geometry.compare(points[a], points[b], 1), compare(places[a][1], places[b][1]));
        }
        for (std::size_t i2 = 0; i2 < points.size(); ++i2) {
          const Vec3 rounded = kernel.roundedPosition(geometry[points[i2]], face);
          // QCOMPARE would let doubles differ
          QVERIFY(rounded.x == nearestDouble(places[i2][0]));
          QVERIFY(rounded.y == nearestDouble(places[i2][1]));
          QVERIFY(rounded.z == nearestDouble(places[i2][2]));
        }
      }
    }
  }

  // Tests where doubles are enough, and just beyond: nearly collinear corners of the largest coordinates of a grid.
  void orientationsOnGridsOfAnyWidth_data() {
    QTest::addColumn<int>("width");
    for (int width = 20; width <= 34; ++width) QTest::addRow("%d bits", width) << width;
  }
  void orientationsOnGridsOfAnyWidth() {
    QFETCH(int, width);
    Random random(width);
    const double largest = std::ldexp(1.0, width) - 1;
    const auto near = [&](double x) { return x - std::uniform_int_distribution<int>(0, 3)(random); };
    QVERIFY(Grid().hasExactOrientations());
    for (int i = 0; i < 2000 * rounds(); ++i) {
      TriangleSoup soup;
      soup.vertices = {{3 - near(largest), 3 - near(largest), near(7)},
                       {near(largest), near(largest), near(largest)},
                       {near(0) + std::floor(largest / 3), near(0) + std::floor(largest / 3), 3 - near(largest)},
                       {largest, 0, 1}};
      soup.triangles = {{0, 1, 2}, {0, 3, 1}};
      const auto mesh = std::make_shared<SourceMesh>(makeSourceMesh(soup, false));
      QCOMPARE(mesh->grid.width(), width);
      QCOMPARE(mesh->grid.hasExactOrientations(), width <= 25);
      const PlanKernel kernel(mesh, {2.0});
      ExactFallbacks count;
      for (Index t = 0; t < 2; ++t) {
        const auto& [a, b, c] = mesh->triangles[t];
        const Rational3 n = rationalNormal(mesh->vertices[a], mesh->vertices[b], mesh->vertices[c]);
        QCOMPARE(kernel.orientation(a, b, c, count), sgn(n[2]));
        QCOMPARE(int(mesh->facing[t]), sgn(n[2]));
        if (width <= 25) {
          const PlanEdges edges(mesh->scaled[a], mesh->scaled[b], mesh->scaled[c]);
          const std::array<Index, 4> corners{a, b, c, a};
          for (Index v = 0; v < static_cast<Index>(mesh->vertices.size()); ++v) {
            const Vec3& p = mesh->scaled[v];
            for (int k = 0; k < 3; ++k)
              for (const auto side : edges.sidesOf(k, PlanCorners(p, p, p)).each())
                QCOMPARE(int(side), kernel.orientation(corners[k], corners[k + 1], v, count));
          }
        }
        const mpq_class scale(std::ldexp(1.0, 2 * mesh->grid.scaleExponent()));
        for (int k = 0; k < 3; ++k) {
          const ErrorDouble component = mesh->normals[t][k];
          QVERIFY(abs(mpq_class(component.value) - n[k] * scale) <= mpq_class(component.error));
        }
      }
    }
  }

  void triangulation() {
    // Random segments between points of the family: the facets must tile the face, all the right way round, and no edge
    // may be left that is better flipped.
    Random random(5);
    for (int i = 0; i < 150 * rounds(); ++i) {
      const auto mesh = randomMesh(random, i % 2 == 0 ? Numbers::Tiny : Numbers::Decimal, 8);
      const PlanKernel kernel(mesh, {1.5});
      FaceGeometry geometry(kernel);
      FaceTriangulation triangulation(geometry, Poll());
      for (Index face = 0; face < static_cast<Index>(mesh->triangles.size()); ++face) {
        if (mesh->facing[face] <= 0) continue;
        geometry.start(face);
        std::vector<std::array<Index, 3>> segments;  // segments: from, to, line
        for (Index o = 0; o < static_cast<Index>(mesh->triangles.size()); ++o) {
          const auto& f = mesh->triangles[o];
          for (int k = 0; k < 3; ++k) addClipped(geometry, segments, f[k], f[(k + 1) % 3]);
        }
        std::vector<Index> points;
        for (const auto& s : segments) points.insert(points.end(), {s[0], s[1]});
        triangulation.start(points);
        for (const auto& s : segments)
          triangulation.insertSegment(triangulation.vertexAt(s[0]), triangulation.vertexAt(s[1]), s[2], 1, 0, true);
        triangulation.dropConstraints();
        triangulation.improve(std::vector<char>(triangulation.facets().size(), 1));
        mpq_class sum = 0;
        for (const auto& facet : triangulation.facets()) {
          Rational3 p[3];
          for (int k = 0; k < 3; ++k) p[k] = kernel.exactPosition(geometry[facet.corners[k]], face);
          const mpq_class area = orientation(p[0], p[1], p[2]);
          QVERIFY(area > 0);
          sum += area;
        }
        Rational3 p[3];
        for (int k = 0; k < 3; ++k) p[k] = rational(mesh->vertices[mesh->triangles[face][k]]);
        QVERIFY(sum == orientation(p[0], p[1], p[2]));
        QVERIFY(isDelaunay(geometry, triangulation));
      }
    }
  }

  void scaleAndShuffleDoNotMatter() {
    Random random(7);
    TriangleSoup soup;
    for (int i = 0; i < 30; ++i) soup.vertices.push_back(randomPoint(random, Numbers::Tiny));
    for (std::uint32_t i = 0; i < 10; ++i) soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    const SourceMesh mesh = makeSourceMesh(soup, false);
    std::reverse(soup.triangles.begin(), soup.triangles.end());
    for (auto& t : soup.triangles) std::rotate(t.begin(), t.begin() + 1, t.end());
    const SourceMesh other = makeSourceMesh(soup, false);
    QVERIFY(mesh.triangles == other.triangles);
    QVERIFY(mesh.vertices == other.vertices);
  }

 private:
  static void checkHeights(const PlanKernel& kernel, Index face, double height) {
    const SourceMesh& mesh = kernel.mesh();
    ExactFallbacks count;
    const auto& f = mesh.triangles[face];
    const Rational3 n = rationalNormal(mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]);
    const Rational3 base = rational(mesh.vertices[f[0]]);
    for (Index v = 0; v < static_cast<Index>(mesh.vertices.size()); ++v) {
      const Rational3 p = rational(mesh.vertices[v]);
      const mpq_class above = (n[0] * (p[0] - base[0]) + n[1] * (p[1] - base[1]) + n[2] * (p[2] - base[2])) / n[2];
      QCOMPARE(kernel.heightSign(face, v, 0, count), sgn(above));
      QCOMPARE(kernel.heightSign(face, v, 1, count), sgn(above - mpq_class(height)));
    }
  }

  static bool isDelaunay(const FaceGeometry& geometry, const FaceTriangulation& triangulation) {
    const auto& facets = triangulation.facets();
    for (std::size_t i = 0; i < facets.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        if (triangulation.edges()[i].lines[k] >= 0) continue;
        const TriangleFacet& other = facets[facets[i].neighbors[k]];
        const Index beyond = other.corners[previous(neighborSlot(other, static_cast<Index>(i)))];
        const ApproximatePoint& zero = geometry.approximate(beyond);
        std::array<std::array<double, 2>, 3> corners;
        for (int j = 0; j < 3; ++j) {
          const ApproximatePoint& p = geometry.approximate(facets[i].corners[j]);
          corners[j] = {p.x - zero.x, p.y - zero.y};
        }
        if (isWellInsideCircle(corners[0], corners[1], corners[2])) return false;
      }
    }
    return true;
  }

  // The part of a source edge that lies inside the face.
  static void addClipped(FaceGeometry& geometry, std::vector<std::array<Index, 3>>& segments, Index u, Index v) {
    const auto& planIds = geometry.kernel().mesh().planIds;
    const Index a = planIds[u], b = planIds[v];
    if (a == b) return;
    const Index line = geometry.edgeLine(a, b);
    Index from = geometry.point(PlanPoint::source(std::min(a, b)));
    Index to = geometry.point(PlanPoint::source(std::max(a, b)));
    for (int k = 0; k < 3; ++k) {
      const int s = geometry.sideOfEdge(k, from), t = geometry.sideOfEdge(k, to);
      if (s <= 0 && t <= 0 && !(s == 0 && t == 0)) return;
      if (s * t >= 0) continue;
      (s < 0 ? from : to) = geometry.crossing(line, k);
    }
    if (from != to) segments.push_back({from, to, line});
  }
};

QTEST_APPLESS_MAIN(TestExact)
#include "test_exact.moc"
