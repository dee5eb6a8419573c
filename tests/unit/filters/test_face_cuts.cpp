// Obstacles are cut out of a floor along lines that divide something, and along no others.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <string>

#include "core/assembly/walkable_state.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using namespace footfall::test;

namespace {

/// The cuts of the floor from 0 to 40 at height 0, two triangles.
struct FloorCuts {
  std::size_t segments = 0, faces = 0, removed = 0;
};

FloorCuts cutsAt0(const StatePtr& state) {
  FloorCuts result;
  const auto& mesh = state->kernel->mesh();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (state->walkable[t] == 0 || mesh.vertices[mesh.triangles[t][0]].z != 0) continue;
    ++result.faces;
    result.removed += state->cuts->isRemoved(t) ? 1 : 0;
    result.segments += (*state->cuts)[t].segments.size();
  }
  return result;
}

/// Squares of 2, `count` in a row and in a column, that face up or down.
void addSquares(Soup& soup, double low, int count, double z, bool up) {
  for (int y = 0; y < count; ++y)
    for (int x = 0; x < count; ++x) {
      const double a = low + 2 * x, b = low + 2 * y;
      up ? soup.floor(a, b, a + 2, b + 2, z) : soup.ceiling(a, b, a + 2, b + 2, z);
    }
}

std::string outlineOfManyLeft(bool up) {
  Soup soup;
  soup.floor(0, 0, 40, 40, 0);
  addSquares(soup, 10, 8, 1, up);
  const StatePtr state = runFilters(soup.environment(), minimalPipeline(2));
  const FloorCuts cuts = cutsAt0(state);
  if (cuts.faces != 2 || cuts.removed != 0) return "another floor";
  if (cuts.segments != 32) return std::to_string(cuts.segments) + " segments";
  const double left = 1600 - 256 + (up ? 256 : 0);
  if (planArea(navigationMesh(state)) != left) return "another area";
  return {};
}

}  // namespace

class TestFaceCuts : public QObject {
  Q_OBJECT

 private slots:
  // 32 edges round a slab of 128 triangles. Two of its corners lie on the edge between the two triangles of the floor.
  void onlyTheOutlineOfASlabIsCut() {
    for (const bool up : {true, false}) {
      const std::string error = outlineOfManyLeft(up);
      QVERIFY2(error.empty(), error.c_str());
    }
  }

  // The second slab ends where the first one does, the third one does not.
  void slabsOverEachOther() {
    Soup soup;
    soup.floor(0, 0, 40, 40, 0);
    addSquares(soup, 10, 8, 1, false);
    addSquares(soup, 10, 8, 0.5, true);
    addSquares(soup, 14, 4, 0.75, false);
    const StatePtr state = runFilters(soup.environment(), minimalPipeline(2));
    const FloorCuts cuts = cutsAt0(state);
    QCOMPARE(cuts.segments, std::size_t{32 + 16});
    const NavigationMesh mesh = navigationMesh(state);
    QCOMPARE(findMeshError(mesh), std::string());
    double left = 0;
    for (const Triangle& t : mesh.triangles) {
      const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
      if (a.z == 0) left += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    }
    QCOMPARE(left, 1600.0 - 256);
  }

  // None of many covers a triangle of the floor alone.
  void whatManyCoverNeedsNoCuts() {
    Soup soup;
    soup.floor(0, 0, 40, 40, 0);
    addSquares(soup, 0, 20, 1, false);
    const StatePtr state = runFilters(soup.environment(), minimalPipeline(2));
    const FloorCuts cuts = cutsAt0(state);
    QCOMPARE(cuts.faces, std::size_t{2});
    QCOMPARE(cuts.removed, std::size_t{2});
    QCOMPARE(cuts.segments, std::size_t{0});
    QVERIFY(navigationMesh(state).triangles.empty());
  }

  // Leaves one square open at each place: the winding number of the rest is known from any start.
  void oneSquareLeftOpen() {
    for (int open = 0; open < 16; ++open) {
      Soup soup;
      soup.floor(0, 0, 40, 40, 0);
      for (int i = 0; i < 16; ++i)
        if (i != open) soup.ceiling(i % 4 * 10, i / 4 * 10, i % 4 * 10 + 10, i / 4 * 10 + 10, 1);
      const NavigationMesh mesh = navigationMesh(runFilters(soup.environment(), minimalPipeline(2)));
      QCOMPARE(findMeshError(mesh), std::string());
      QCOMPARE(planArea(mesh), 100.0);
      for (const Vec3& v : mesh.vertices) {
        QVERIFY(v.x >= open % 4 * 10 && v.x <= open % 4 * 10 + 10);
        QVERIFY(v.y >= open / 4 * 10 && v.y <= open / 4 * 10 + 10);
      }
    }
  }
};

QTEST_GUILESS_MAIN(TestFaceCuts)
#include "test_face_cuts.moc"
