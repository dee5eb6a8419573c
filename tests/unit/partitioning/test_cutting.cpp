// Cutting along cells: corners, edges and heights that meet borders, and half-open cells.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <cmath>

#include "core/partitioning/convex_triangulation.hpp"
#include "tests/unit/partitioning/checked_cuts.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

class TestCutting : public QObject {
  Q_OBJECT

 private slots:
  void oneCell() {
    const SourceMesh mesh = meshOf(test::Soup().floor(0, 0, 4, 4, 0).wall(1, 1, 3, 3, 0, 2));
    const CutEnvironment cut = cutEnvironment(mesh, Cells().partition(), {}, false);
    QCOMPARE(cut.vertices.size(), mesh.vertices.size());
    QCOMPARE(cut.triangles.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      QVERIFY(cut.triangles[t] == (CutTriangle{mesh.triangles[t], static_cast<Index>(t), 0}));
  }

  void cornerOnDiagonal() {
    // a cell corner in the middle of the quad: the diagonal gets one vertex there
    const SourceMesh mesh = meshOf(test::Soup().floor(0, 0, 4, 4, 0));
    Cells cells;
    const Index right = cells.divide(0, 0, 2);
    cells.divide(0, 1, 2);
    cells.divide(right, 1, 2);
    const CutEnvironment cut = cutEnvironment(mesh, cells.partition(), {}, false);
    QCOMPARE(Check(mesh, cells.partition(), cut).run({}), std::string());
    QCOMPARE(cut.vertices.size(), std::size_t{4 + 5});
    QCOMPARE(cut.triangles.size(), std::size_t{8});
  }

  void throughVertices() {
    // borders through vertices and along edges make no new vertex
    const SourceMesh mesh = meshOf(test::Soup().floor(0, 0, 2, 2, 0).floor(2, 0, 4, 2, 0).wall(2, 0, 2, 2, 0, 3));
    Cells cells;
    const Index right = cells.divide(0, 0, 2);
    const CutEnvironment cut = cutEnvironment(mesh, cells.partition(), {}, false);
    QCOMPARE(Check(mesh, cells.partition(), cut).run({}), std::string());
    QCOMPARE(cut.vertices.size(), mesh.vertices.size());
    QCOMPARE(cut.triangles.size(), std::size_t{6});
    for (const CutTriangle& t : cut.triangles)
      if (mesh.facing[t.source] == 0) QCOMPARE(t.cell, right);
  }

  void unevenCells() {
    // figure 13: cells cut deeper give their border vertices to neighbours, of the same triangle and of others
    const SourceMesh mesh = meshOf(test::Soup().triangle({0, 0, 0}, {8, 0, 0}, {0, 8, 0}).floor(-8, 0, 0, 8, 0));
    Cells cells;
    const Index right = cells.divide(0, 0, 2);
    cells.divide(right, 1, 1);
    cells.divide(0, 0, 0);  // along the edge that both share
    const Index middle = 2 + 1;
    cells.divide(middle, 1, 3);
    const CutEnvironment cut = cutEnvironment(mesh, cells.partition(), {}, false);
    QCOMPARE(Check(mesh, cells.partition(), cut).run({}), std::string());
    const auto has = [&](const Vec3& p) {
      return std::count_if(cut.places.begin(), cut.places.end(),
                           [&](const Vec3& q) { return p.x == q.x && p.y == q.y && p.z == q.z; });
    };
    QCOMPARE(has({2, 1, 0}), 1);
    QCOMPARE(has({2, 3, 0}), 1);
    QCOMPARE(has({0, 3, 0}), 1);
    std::map<Index, int> cornersAt;
    for (const CutTriangle& t : cut.triangles)
      for (const Index v : t.corners)
        if (cut.places[v].x == 0 && cut.places[v].y == 3) ++cornersAt[t.cell];
    QCOMPARE(cornersAt.size(), std::size_t{3});  // both cells of the triangle, and the quad's, which is cut nowhere
  }

  void heights() {
    // floors of different heights go to cells that are cut differently, and still meet
    test::Soup soup = test::Soup().floor(0, 0, 4, 4, 0).quad({4, 0, 0}, {8, 0, 2}, {8, 4, 2}, {4, 4, 0});
    soup.floor(8, 0, 12, 4, 2);
    const SourceMesh mesh = meshOf(soup);
    Cells cells;
    const Index upper = cells.divide(0, 2, 1);
    cells.divide(upper, 1, 3);
    cells.divide(0, 1, 1);
    const CutEnvironment cut = cutEnvironment(mesh, cells.partition(), {}, false);
    QCOMPARE(Check(mesh, cells.partition(), cut).run({}), std::string());
  }

  void oneNameAtACorner() {
    // the diagonal passes through (2, 2), where one triangle is cut in x only and the other in y only
    const SourceMesh mesh =
        meshOf(test::Soup().triangle({0, 0, 1}, {4, 0, 0}, {4, 4, 1}).triangle({0, 0, 1}, {4, 4, 1}, {0, 4, 1}));
    Cells cells;
    const Index upper = cells.divide(0, 2, 1);
    cells.divide(0, 0, 2);
    cells.divide(upper, 1, 2);
    const CutEnvironment cut = cutEnvironment(mesh, cells.partition(), {}, false);
    QCOMPARE(Check(mesh, cells.partition(), cut).run({}), std::string());
    QCOMPARE(cut.vertices.size(), std::size_t{4 + 3});
    QCOMPARE(cut.triangles.size(), std::size_t{6});
  }

  void wallsTakeHeightFromEdges() {
    const SourceMesh mesh = meshOf(test::Soup().quad({0, 0, 0}, {4, 4, 1}, {4, 4, 5}, {0, 0, 3}));
    Cells cells;
    const Index right = cells.divide(0, 0, 1);
    cells.divide(0, 1, 1);  // misses: the wall is below already
    cells.divide(right, 1, 3);
    const CutEnvironment cut = cutEnvironment(mesh, cells.partition(), {}, false);
    QCOMPARE(Check(mesh, cells.partition(), cut).run({}), std::string());
    const auto has = [&](const Vec3& p) {
      return std::any_of(cut.places.begin(), cut.places.end(),
                         [&](const Vec3& q) { return p.x == q.x && p.y == q.y && p.z == q.z; });
    };
    QVERIFY(has({1, 1, 0.25}) && has({1, 1, 3.5}) && has({3, 3, 0.75}) && has({3, 3, 4.5}));
  }

  void closedByRounding() {
    // a corner cut off a hair from the vertex: the cut points come together with it
    const double c = std::nextafter(1.0, 2.0);
    const SourceMesh mesh = meshOf(test::Soup().triangle({1, 1e9, 0}, {3, 1e9 - 1, 0}, {3, 1e9 + 1, 0}));
    Cells cells;
    cells.divide(0, 0, c);
    const CutEnvironment exact = cutEnvironment(mesh, cells.partition(), {}, false);
    QCOMPARE(Check(mesh, cells.partition(), exact).run({}), std::string());
    QCOMPARE(exact.triangles.size(), std::size_t{3});
    const CutEnvironment rounded = cutEnvironment(mesh, cells.partition(), {}, true);
    QCOMPARE(rounded.closedTriangles, std::uint64_t{2});
    QCOMPARE(rounded.triangles.size(), std::size_t{1});
  }

  void convexTriangulation() {
    // all ways to put up to three points on the sides of a triangle, a square and a pentagon
    const std::vector<std::vector<Vec3>> shapes{{{0, 0, 0}, {12, 0, 0}, {0, 12, 0}},
                                                {{0, 0, 0}, {12, 0, 0}, {12, 12, 0}, {0, 12, 0}},
                                                {{0, 0, 0}, {12, 0, 0}, {24, 12, 0}, {12, 24, 0}, {0, 12, 0}}};
    for (const auto& shape : shapes) {
      const auto ways = static_cast<int>(std::pow(4, shape.size()));
      for (int way = 0; way < ways; ++way) {
        std::vector<Vec3> places;
        std::vector<char> isCorner;
        int rest = way;
        for (std::size_t k = 0; k < shape.size(); ++k, rest /= 4) {
          const Vec3 &p = shape[k], &q = shape[(k + 1) % shape.size()];
          for (int i = 0; i <= rest % 4; ++i) {
            places.push_back({p.x + (q.x - p.x) * i / 4, p.y + (q.y - p.y) * i / 4, 0});
            isCorner.push_back(static_cast<char>(i == 0));
          }
        }
        ConvexTriangulation triangulation(places);
        triangulation.start();
        for (std::size_t i = 0; i < places.size(); ++i)
          isCorner[i] != 0 ? triangulation.addCorner(static_cast<Index>(i))
                           : triangulation.addPoint(static_cast<Index>(i));
        double area = 0;
        std::size_t count = 0;
        triangulation.finish([&](const std::array<Index, 3>& t) {
          const Vec3 &a = places[t[0]], &b = places[t[1]], &c = places[t[2]];
          const double own = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
          QVERIFY(own > 0);
          area += own;
          ++count;
        });
        QCOMPARE(count, places.size() - 2);
        double whole = 0;
        for (std::size_t k = 1; k + 1 < shape.size(); ++k)
          whole += shape[k].x * shape[k + 1].y - shape[k].y * shape[k + 1].x;
        QCOMPARE(area, whole);
      }
    }
  }
};

QTEST_APPLESS_MAIN(TestCutting)
#include "test_cutting.moc"
