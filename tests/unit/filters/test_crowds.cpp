// Obstacles many deep above a floor: what they take is the same set, whatever is left out of the work.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <random>

#include "core/assembly/walkable_state.hpp"
#include "core/filters/clearance/covered_obstacles.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/pipeline.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

constexpr int kExtent = 40;

struct Crowd {
  Soup soup;
  std::vector<char> covered = std::vector<char>(kExtent * kExtent, 0);  ///< unit squares of the floor
};

/// Slabs with whole corners over a floor; `height(i)` is that of slab i. Each has two walls under it.
template <class Height>
Crowd crowdOf(int count, std::uint32_t seed, const Height& height) {
  std::mt19937 random(seed);
  Crowd crowd;
  crowd.soup.floor(0, 0, kExtent, kExtent, 0);
  for (int i = 0; i < count; ++i) {
    const int width = 4 + static_cast<int>(random() % 12), depth = 4 + static_cast<int>(random() % 12);
    const int x = static_cast<int>(random() % (kExtent - 16)), y = static_cast<int>(random() % (kExtent - 16));
    const double z = height(i);
    crowd.soup.floor(x, y, x + width, y + depth, z);
    crowd.soup.wall(x, y, x + width, y + depth, 0, z);
    for (int row = y; row < y + depth; ++row)
      for (int column = x; column < x + width; ++column) crowd.covered[row * kExtent + column] = 1;
  }
  return crowd;
}

/// What is left of the floor at height 0, in unit squares by their middles.
std::vector<char> floorLeft(const NavigationMesh& mesh) {
  std::vector<char> left(kExtent * kExtent, 0);
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    if (a.z != 0 || b.z != 0 || c.z != 0) continue;
    for (int y = 0; y < kExtent; ++y)
      for (int x = 0; x < kExtent; ++x) {
        const double px = x + 0.51, py = y + 0.493;
        const auto side = [&](const Vec3& p, const Vec3& q) {
          return (q.x - p.x) * (py - p.y) - (q.y - p.y) * (px - p.x);
        };
        if (side(a, b) > 0 && side(b, c) > 0 && side(c, a) > 0) left[y * kExtent + x] = 1;
      }
  }
  return left;
}

double floorArea(const NavigationMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    if (a.z == 0 && b.z == 0 && c.z == 0) sum += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  }
  return sum;
}

NavigationMesh run(const Environment& environment, const std::string& filters, int threads) {
  RunContext context;
  return *runPipeline(std::make_shared<Environment>(environment), parsePipeline(filters, "test"), context, nullptr,
                      threads)
              .mesh;
}

bool same(const NavigationMesh& a, const NavigationMesh& b) {
  return a.vertices == b.vertices && a.triangles == b.triangles && a.obstacleEdges == b.obstacleEdges;
}

}  // namespace

class TestCrowds : public QObject {
  Q_OBJECT
 private slots:
  void crowdsTakeWhatTheirMembersTake_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<bool>("level");
    for (const int count : {20, 150, 600}) {
      QTest::addRow("%d at one height", count) << count << true;
      QTest::addRow("%d at different heights", count) << count << false;
    }
  }
  void crowdsTakeWhatTheirMembersTake() {
    QFETCH(int, count);
    QFETCH(bool, level);
    for (const std::uint32_t seed : {1U, 2U}) {
      const Crowd crowd = crowdOf(count, seed, [&](int i) { return level ? 0.5 : 0.25 + i / 1024.0; });
      const auto environment = crowd.soup.environment();
      const std::string filters = "SlopeFilter 45\nVerticalClearanceFilter 2\n";
      const NavigationMesh mesh = run(*environment, filters, 2);
      QCOMPARE(findMeshError(mesh), std::string());
      std::vector<char> expected;
      for (const char covered : crowd.covered) expected.push_back(static_cast<char>(covered == 0));
      QCOMPARE(floorLeft(mesh), expected);
      // Every border lies on whole numbers, so areas are exact.
      QCOMPARE(floorArea(mesh), static_cast<double>(std::accumulate(expected.begin(), expected.end(), 0)));
      // At one height nothing is walkable twice, and slabs above the floor keep what no other slab has.
      if (level) QCOMPARE(planArea(mesh), static_cast<double>(kExtent * kExtent));

      // The same bytes on one thread, in cells, and in another order.
      QVERIFY(same(run(*environment, filters, 1), mesh));
      QVERIFY(same(run(*environment, "GridStrategy 3 2\n" + filters + "Collapse\n", 2), mesh));
      std::vector<std::uint32_t> order(environment->triangles.size());
      std::iota(order.begin(), order.end(), 0U);
      std::shuffle(order.begin(), order.end(), std::mt19937(seed));
      QVERIFY(same(run(*shuffled(*environment, order, 1), filters, 2), mesh));
    }
  }

  // The work is in two triangles of the floor; listeners still hear of it while it lasts.
  void oneFloorTellsItsProgress() {
    Soup soup;
    soup.floor(0, 0, 200, 200, 0);
    for (int i = 0; i < 3000; ++i) soup.floor(3 * (i % 60), 3 * (i / 60), 3 * (i % 60) + 2, 3 * (i / 60) + 2, 1);
    std::atomic<int> between{0};
    RunContext context([&](const RunEvent& event) {
      if (event.kind == RunEvent::Kind::Progress && event.fraction > 0.55 && event.fraction < 0.85) ++between;
    });
    runPipeline(soup.environment(), parsePipeline("VerticalClearanceFilter 2\n", "test"), context, nullptr, 1);
    QVERIFY2(between >= 20, qPrintable(QString::number(between)));
  }

  // Most of a deep crowd is left out; what covers, and what reaches out of the crowd, is not.
  void mostOfACrowdIsCovered() {
    const Crowd crowd = crowdOf(2000, 1, [](int i) { return 0.25 + i / 4096.0; });
    const StatePtr state = runFilters(crowd.soup.environment(), "SlopeFilter 45\n");
    const auto kernel = std::make_shared<PlanKernel>(state->kernel->sharedMesh(), std::vector<double>{2.0});
    const SourceMesh& mesh = kernel->mesh();
    Index floor = -1;
    for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t)
      if (mesh.facing[t] > 0 && mesh.vertices[mesh.triangles[t][0]].z == 0) floor = t;
    ClearanceCandidates search(
        *kernel, [](Index) { return true; }, 1, [] {});
    const auto candidates = search.find(floor);
    Crowding crowding(mesh, floor);
    for (const ClearanceCandidate& c : candidates) crowding.add(c.obstacle);
    QVERIFY(crowding.isCrowd());
    const std::vector<char> covered = findCovered(*kernel, floor, candidates, [] {});
    const auto leftOut = std::accumulate(covered.begin(), covered.end(), 0);
    QVERIFY2(leftOut > static_cast<int>(candidates.size()) / 2 && leftOut < static_cast<int>(candidates.size()),
             qPrintable(QString("%1 of %2").arg(leftOut).arg(candidates.size())));
  }
};

QTEST_GUILESS_MAIN(TestCrowds)
#include "test_crowds.moc"
