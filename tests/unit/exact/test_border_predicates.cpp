// Predicates at the borders of cells: what does not meet them does not notice them, and crossings have one name.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <bit>
#include <cmath>

#include "tests/support/soup_generators.hpp"
#include "tests/unit/exact/predicate_soups.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

class TestBorderPredicates : public QObject {
  Q_OBJECT

 private slots:
  void borders_data() { addNumbers(); }

  void borders() {
    // Parts that do not meet the borders do not change.
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

 private:
  static void compareFaces(Random& random, FaceGeometry& plain, FaceGeometry& divided, Index face) {
    const SourceMesh& mesh = plain.kernel().mesh();
    const Reference reference(plain.kernel());
    const auto number = [&](std::size_t count) { return integer(random, 0, static_cast<int>(count) - 1); };
    plain.start(face);
    divided.start(face);
    // These triangles lie between the borders, on one side only; the others must not change.
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
};

QTEST_APPLESS_MAIN(TestBorderPredicates)
#include "test_border_predicates.moc"
