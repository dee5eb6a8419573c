// Obstacles many deep above a floor: what they take is the same set, whatever is left out of the work.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <utility>

#include "core/assembly/walkable_state.hpp"
#include "core/base/process_usage.hpp"
#include "core/filters/clearance/clearance_clipper.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/pipeline.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/unit/filters/floor_runs.hpp"

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

/// The remainder of the floor at height 0, in unit squares by their middles.
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

/// The height of a triangle in space over a place; none beside it and where it stands upright.
std::optional<double> heightAt(const Vec3& a, const Vec3& b, const Vec3& c, double x, double y) {
  const double whole = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (whole == 0) return std::nullopt;
  const double v = ((x - a.x) * (c.y - a.y) - (y - a.y) * (c.x - a.x)) / whole;
  const double w = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / whole;
  if (v < 0 || w < 0 || v + w > 1) return std::nullopt;
  return a.z + v * (b.z - a.z) + w * (c.z - a.z);
}

bool isFloorOf50(const std::array<Vec3, 3>& t) {
  const auto& [a, b, c] = t;
  const double nx = (b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y);
  const double ny = (b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z);
  const double nz = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return nz > 0 && std::hypot(nx, ny) <= std::tan(std::acos(-1.0) * 50 / 180) * nz;
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
      // No place is walkable twice at one height, and slabs above the floor keep the area that no other slab has.
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

  // The work is in two triangles of the floor; listeners still get its progress while it lasts.
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

  // The search of a crowd above one floor reports progress and polls for cancelling all the time.
  void crowdsTellTheirProgress() {
    const Crowd crowd = crowdOf(6000, 1, [](int i) { return 0.25 + i / 4096.0; });
    const auto environment = crowd.soup.environment();
    int early = 0;
    double last = 0;
    bool rises = true;
    RunContext context([&](const RunEvent& event) {
      if (event.kind != RunEvent::Kind::Progress) return;
      early += event.fraction > 0 && event.fraction < 0.125 ? 1 : 0;
      rises = rises && event.fraction >= last;
      last = event.fraction;
    });
    runPipeline(environment, parsePipeline("VerticalClearanceFilter 2\n", "test"), context, nullptr, 1);
    QVERIFY2(early >= 4 && rises, qPrintable(QString::number(early)));

    const StatePtr state = runFilters(environment, "SlopeFilter 45\n");
    const PlanKernel kernel(state->kernel->sharedMesh(), {2.0});
    const SourceMesh& mesh = kernel.mesh();
    double before = processCpuMs(), longest = 0;
    const auto poll = [&] {
      const double now = processCpuMs();
      longest = std::max(longest, now - std::exchange(before, now));
    };
    ClearanceClipper clipper(
        kernel, [](Index) { return true; }, 1, poll);
    for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t)
      if (mesh.facing[t] > 0 && mesh.vertices[mesh.triangles[t][0]].z == 0) clipper.clip(t, nullptr);
    poll();
    QVERIFY2(longest < 20, qPrintable(QString::number(longest)));
  }

  // Triangles in any position on a coarse grid, which pierce floors, the clearance and each other: at random places
  // what is walkable is what nothing stands over.
  void crowdsThatPierce() {
    constexpr double kClearance = 2, kTooNear = 1e-7;
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
      std::mt19937 random(seed);
      const auto number = [&](int end) { return static_cast<double>(random() % static_cast<unsigned>(end)); };
      Soup soup;
      soup.floor(0, 0, 20, 20, 0);
      for (int i = 0; i < 300; ++i) {
        const auto corner = [&] {
          const double x = number(21), y = number(21), z = number(4);
          return Vec3{x, y, z};
        };
        const Vec3 a = corner(), b = corner(), c = corner();
        soup.triangle(a, b, c);
      }
      const auto environment = soup.environment();
      const NavigationMesh mesh = run(*environment, "SlopeFilter 50\nVerticalClearanceFilter 2\n", 2);
      QCOMPARE(findMeshError(mesh), std::string());
      int places = 0;
      for (int i = 0; i < 400; ++i) {
        const double x = 0.0031 + number(1999) / 100, y = 0.0047 + number(1999) / 100;
        std::vector<double> under, expected, found;
        for (const auto& t : soup.triangles())
          if (const auto z = heightAt(t[0], t[1], t[2], x, y)) under.push_back(*z);
        bool isClear = true;
        for (const auto& t : soup.triangles()) {
          const auto z = heightAt(t[0], t[1], t[2], x, y);
          if (!z || !isFloorOf50(t)) continue;
          bool isFree = true;
          int equal = 0;
          for (const double other : under) {
            isFree = isFree && (other <= *z + kTooNear || other >= *z + kClearance - kTooNear);
            equal += std::fabs(other - *z) < kTooNear ? 1 : 0;
            isClear = isClear && std::fabs(other - *z - kClearance) > kTooNear;
          }
          isClear = isClear && equal == 1;
          if (isFree) expected.push_back(*z);
        }
        if (!isClear) continue;  // The place is too near a border for doubles.
        for (const Triangle& t : mesh.triangles)
          if (const auto z = heightAt(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]], x, y))
            found.push_back(*z);
        std::sort(expected.begin(), expected.end());
        std::sort(found.begin(), found.end());
        QCOMPARE(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k) QVERIFY(std::fabs(found[k] - expected[k]) < 1e-9);
        places += static_cast<int>(found.size());
      }
      QVERIFY2(places > 20, qPrintable(QString::number(places)));

      QVERIFY(same(run(*environment, "SlopeFilter 50\nVerticalClearanceFilter 2\n", 1), mesh));
      std::vector<std::uint32_t> order(environment->triangles.size());
      std::iota(order.begin(), order.end(), 0U);
      std::shuffle(order.begin(), order.end(), std::mt19937(seed));
      QVERIFY(same(run(*shuffled(*environment, order, 1), "SlopeFilter 50\nVerticalClearanceFilter 2\n", 2), mesh));
    }
  }

  // The remaining outlines of a crowd are about the visible ones: outlines that cross where others cover the floor grow
  // as the square of the depth.
  void outlinesOfACrowdAreFew() {
    std::vector<std::size_t> counts;
    for (const int count : {500, 2000}) {
      const Crowd crowd = crowdOf(count, 1, [&](int i) { return 0.25 + i / 4096.0; });
      const StatePtr state = runFilters(crowd.soup.environment(), minimalPipeline(2));
      std::size_t most = 0;
      for (std::size_t t = 0; t < state->walkable.size(); ++t)
        most = std::max(most, state->cuts->isRemoved(t) ? 0 : (*state->cuts)[t].segments.size());
      counts.push_back(most);
    }
    QVERIFY2(counts[0] > 0 && counts[1] < counts[0] + 100,
             qPrintable(QString("%1, then %2").arg(counts[0]).arg(counts[1])));
  }

  // Each of many slabs in one plane has hundreds before it. The number that the remaining ones depend on does not grow
  // with the depth.
  void slabsInOnePlaneNeedFewOthers() {
    std::vector<double> found;
    for (const int count : {1000, 4000}) {
      std::mt19937 random(1);
      const auto place = [&] { return static_cast<double>(random() % 99991) / 99991 * kExtent; };
      Soup soup;
      for (int i = 0; i < count; ++i) {
        const double x = place(), y = place();
        soup.floor(x, y, x + 8, y + 8, 0);
      }
      const StatePtr state = runFilters(soup.environment(), "SlopeFilter 45\n");
      const PlanKernel kernel(state->kernel->sharedMesh(), {2.0});
      ClearanceCandidates search(
          kernel, [](Index) { return true; }, 1, [] {});
      std::size_t sum = 0, faces = 0;
      for (Index t = 0; t < static_cast<Index>(kernel.mesh().triangles.size()); ++t) {
        const std::size_t candidates = search.find(t).size();
        if (!search.areCrowd() || search.areKnownToCover()) continue;
        sum += candidates;
        ++faces;
      }
      QVERIFY(faces > 100);
      found.push_back(static_cast<double>(sum) / static_cast<double>(faces));
    }
    QVERIFY2(found[1] < 1.5 * found[0], qPrintable(QString("%1, then %2").arg(found[0]).arg(found[1])));
  }

  // A floor under a closed roof of many small parts, each of which covers little, is found to be covered as a whole,
  // and without looking at all that stands above it; with one part missing it is not.
  // Each is compared with one other: with all others this would take half an hour.
  void equalTriangles() {
    Soup soup;
    for (int i = 0; i < 40000; ++i) soup.triangle({0, 0, 0}, {10, 0, 0}, {0, 10, 0});
    soup.floor(1, 1, 2, 2, 1);
    const auto mesh = navigationMesh(runFilters(soup.environment(), minimalPipeline(2)));
    QCOMPARE(area(mesh), 50.0);
  }

  void roofsOfManyParts_data() {
    QTest::addColumn<bool>("isClosed");
    QTest::newRow("closed") << true;
    QTest::newRow("with a hole") << false;
  }
  void roofsOfManyParts() {
    QFETCH(bool, isClosed);
    Soup soup;
    soup.floor(0, 0, 16, 16, 0);
    for (int depth = 0; depth < 80; ++depth)
      for (int x = -1; x < 16; x += 2)
        for (int y = -1; y < 16; y += 2)
          if (isClosed || x != 5 || y != 9) {
            const double left = x - 0.25 + (depth % 16) / 16.0;  // so that diagonals differ
            soup.floor(left, y - 0.25, left + 2.5, y + 2.25, 0.5 + depth / 1024.0);
          }
    const StatePtr state = runFilters(soup.environment(), minimalPipeline(2));
    const SourceMesh& mesh = state->kernel->mesh();
    for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t)
      if (mesh.vertices[mesh.triangles[t][0]].z == 0) {
        ClearanceCandidates search(
            *state->kernel, [](Index) { return true; }, 1, [] {});
        const std::size_t found = search.find(t).size();
        QVERIFY(search.areCrowd());
        if (isClosed) QVERIFY(search.areKnownToCover() && state->cuts->isRemoved(t) && found < 2000);
      }
    const double left = isClosed ? 0 : 1.5 * (1.5 - 15 / 16.0);
    QCOMPARE(floorArea(navigationMesh(state)), left);
  }
};

QTEST_GUILESS_MAIN(TestCrowds)
#include "test_crowds.moc"
