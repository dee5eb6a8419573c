// The repairs of the rounding experiment: each geometry case of thesis 4.4.2 is counted, and none is left.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>
#include <random>

#include "core/base/vector.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/partitioning/strategies.hpp"
#include "footfall/filter_type.hpp"
#include "tests/bench/rounding_experiment/cut_repair.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::bench;

namespace {

SourceMesh meshOf(const TriangleSoup& soup) { return makeSourceMesh(SoupView(soup), false); }

/// One large triangle as the source, and pieces with the given corners as what rounding made of its parts.
RoundedCut piecesOf(const SourceMesh& mesh, const std::vector<Vec3>& cutPoints,
                    const std::vector<std::array<Index, 3>>& corners) {
  RoundedCut cut;
  cut.vertices = mesh.vertices;
  cut.vertices.insert(cut.vertices.end(), cutPoints.begin(), cutPoints.end());
  for (const auto& c : corners) cut.triangles.push_back({c, 0, 0});
  return cut;
}

SourceMesh largeTriangle() { return meshOf({{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}, {{0, 1, 2}}}); }

bool allTurnAsTheirSources(const SourceMesh& mesh, const RoundedCut& cut) {
  for (const CutTriangle& t : cut.triangles) {
    const std::array<Vec3, 3> c{cut.vertices[t.corners[0]], cut.vertices[t.corners[1]], cut.vertices[t.corners[2]]};
    if (mesh.degenerate[t.source] == 0 && turnOf(mesh, t.source, c) <= 0) return false;
  }
  return true;
}

double areaOfAll(const RoundedCut& cut) {
  double area = 0;
  for (const CutTriangle& t : cut.triangles)
    area += areaOf(cut.vertices[t.corners[0]], cut.vertices[t.corners[1]], cut.vertices[t.corners[2]]);
  return area;
}

}  // namespace

class TestCutRepair : public QObject {
  Q_OBJECT

 private slots:
  // Vertices are sorted: 0 is (0, 0), 1 is (0, 8), 2 is (8, 0). Cut points are from 3 on.
  void edgesAndPointsClose() {
    const SourceMesh mesh = largeTriangle();
    RoundedCut cut = piecesOf(mesh, {{2, 2, 0}, {2, 2, 0}, {2, 2, 0}}, {{3, 4, 5}, {0, 3, 4}, {0, 2, 3}});
    repairCut(mesh, cut);
    QCOMPARE(cut.triangles.size(), std::size_t{1});
    QVERIFY(allTurnAsTheirSources(mesh, cut));
  }

  void collinearTrianglesGo() {
    const SourceMesh mesh = largeTriangle();
    RoundedCut cut = piecesOf(mesh, {{4, 0, 0}}, {{0, 3, 2}, {0, 2, 1}});
    repairCut(mesh, cut);
    QCOMPARE(cut.triangles.size(), std::size_t{1});
    QVERIFY(allTurnAsTheirSources(mesh, cut));
  }

  void flippedTrianglesCollapseToTheNearerEnd() {
    const SourceMesh mesh = largeTriangle();
    // The point (5, -1e-15) fell beyond the edge from (0, 0) to (8, 0), from which it was to be above.
    RoundedCut cut = piecesOf(mesh, {{5, -1e-15, 0}}, {{0, 2, 3}, {0, 3, 1}, {3, 2, 1}});
    repairCut(mesh, cut);
    QVERIFY(allTurnAsTheirSources(mesh, cut));
    QCOMPARE(areaOfAll(cut), 32.0);  // the corner (8, 0) stands for the point
  }

  void sourceVerticesNeverMove() {
    const SourceMesh mesh = largeTriangle();
    RoundedCut cut = piecesOf(mesh, {{1e-16, 8, 0}, {0, 9, 0}}, {{0, 3, 1}, {0, 2, 4}});
    repairCut(mesh, cut);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) QCOMPARE(cut.vertices[v], mesh.vertices[v]);
  }

  // Thin triangles in every direction, cut at places that no double holds.
  void nothingBrokenIsLeftOfRandomCuts() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0.0, 1.0);
    TriangleSoup soup;
    for (std::uint32_t i = 0; i < 200; ++i) {
      const Vec3 a{1000 * place(random), 1000 * place(random), 10 * place(random)};
      const Vec3 b = a + Vec3{place(random), place(random), place(random)};
      const Vec3 c = a + 0.5 * (b - a) + Vec3{1e-13 * place(random), 0, 1e-12 * place(random)};
      soup.vertices.insert(soup.vertices.end(), {a, b, c});
      soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const SourceMesh mesh = meshOf(soup);
    const std::vector<char> floors(mesh.triangles.size(), 1), removed(mesh.triangles.size(), 0);
    const Partition partition = makePartition(FilterType::GridStrategy, {4000, 8}, {mesh, floors, removed, 2, 1});
    const CutEnvironment cut = cutEnvironment(mesh, partition, {}, false);
    RoundedCut rounded = roundCut(cut);
    const double before = areaOfAll(rounded);
    const CutCases cases = countCases(mesh, partition, cut, rounded);
    QVERIFY(cases.exact + cases.edge + cases.point + cases.collinear + cases.flipped + cases.moved <=
            rounded.triangles.size());
    QVERIFY(cases.collinear + cases.flipped + cases.edge > 0);  // else the test is of no use
    repairCut(mesh, rounded);
    QVERIFY(allTurnAsTheirSources(mesh, rounded));
    QVERIFY(std::fabs(areaOfAll(rounded) - before) < 1e-9);
  }
};

QTEST_APPLESS_MAIN(TestCutRepair)
#include "test_cut_repair.moc"
