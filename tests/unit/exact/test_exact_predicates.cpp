// Every predicate of the exact core against a slow reference of its own in rational numbers, on degenerate soups.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <bit>
#include <cmath>

#include "core/exact/source_predicates.hpp"
#include "tests/support/exact_turn.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/exact/predicate_soups.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

class TestExactPredicates : public QObject {
  Q_OBJECT

 private slots:
  void singleTriangles_data() { addNumbers(); }
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

  void family_data() { addNumbers(); }

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

  void widestGridIsReached() {
    // the test reaches its purpose: integers on the stack are used up to their limit
    Random random(test::seed());
    int widest = 0;
    for (int i = 0; i < 20; ++i) widest = std::max(widest, randomMesh(random, Numbers::WidestFixed, 7)->grid.width());
    QCOMPARE(widest, kWidestFixedGrid);
  }

 private:
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
