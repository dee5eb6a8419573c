// Filters that look at one triangle at a time: keepFaces() before and behind a mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "core/filters/face_filter.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

/// Keeps faces whose corners are all at least this high.
FaceTest isAbove(const StatePtr& state, double height) {
  return [kernel = state->kernel, height](Index face, ExactFallbacks& count) {
    ++count.height;
    const SourceMesh& mesh = kernel->mesh();
    return std::ranges::all_of(mesh.triangles[face], [&](Index v) { return mesh.vertices[v].z >= height; });
  };
}

}  // namespace

class TestFaceFilter : public QObject {
  Q_OBJECT

 private slots:
  // Stairs of three treads, 0.25 apart, each of 4 by 1.
  void init() {
    stairs_ = Soup()
                  .floor(0, 0, 4, 1, 0)
                  .floor(0, 1, 4, 2, 0.25)
                  .floor(0, 2, 4, 3, 0.5)
                  .wall(0, 1, 4, 1, 0, 0.25)
                  .wall(0, 2, 4, 2, 0.25, 0.5)
                  .environment();
  }

  void beforeAMesh() {
    const StatePtr state = runFilters(stairs_, "SlopeFilter 45");
    QVERIFY(!state->mesh);
    const FilterOutcome outcome = keepFaces(state, isAbove(state, 0.25), context_);
    QVERIFY(!outcome.state->mesh);
    QCOMPARE(summarize(*outcome.state).area, 8.0);
    QCOMPARE(outcome.fallbacks.height, std::uint64_t{6});  // one for each floor, none for walls
    QCOMPARE(summarize(*state).area, 12.0);                // the state before is as it was
  }

  void behindAMesh() {
    const StatePtr state = runFilters(stairs_, "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.25 0");
    QCOMPARE(summarize(*state).links, std::uint64_t{2});
    const FilterOutcome outcome = keepFaces(state, isAbove(state, 0.25), context_);
    const StateSummary summary = summarize(*outcome.state);
    QCOMPARE(summary.area, 8.0);
    QCOMPARE(summary.links, std::uint64_t{1});  // the other one has lost a border
    // The same product as that of the test before the clearance.
    const StatePtr early = keepFaces(runFilters(stairs_, "SlopeFilter 45"), isAbove(state, 0.25), context_).state;
    const NavigationMesh product = navigationMesh(outcome.state);
    QCOMPARE(findMeshError(product), std::string());
    QCOMPARE(area(product), area(navigationMesh(runFilters(early, "VerticalClearanceFilter 2"))));
  }

  void layersStayWithTheirTriangles() {
    const StatePtr state = runFilters(stairs_, "VerticalClearanceFilter 2\nLayerSubdivisionFilter");
    const StatePtr kept = keepFaces(state, isAbove(state, 0.5), context_).state;
    QCOMPARE(kept->mesh->layers.size(), kept->mesh->triangles.size());
    QVERIFY(!kept->mesh->triangles.empty());
  }

  void cancels() {
    const StatePtr state = runFilters(stairs_, "SlopeFilter 45");
    RunContext context;
    context.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, keepFaces(state, isAbove(state, 0), context));
  }

 private:
  std::shared_ptr<const Environment> stairs_;
  RunContext context_;
};

QTEST_APPLESS_MAIN(TestFaceFilter)
#include "test_face_filter.moc"
