// Floors that obstacles cover together are known to be covered before anything is cut.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/filters/clearance/clearance_candidates.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/pipeline.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/unit/filters/floor_runs.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

constexpr int kExtent = 24;
constexpr int kTile = 4;

/// Boxes with whole corners over a floor of tiles, and the unit squares under them.
struct Boxes {
  Soup soup;
  std::vector<std::array<int, 4>> rectangles;  ///< lower and upper corner of each
  std::vector<char> covered = std::vector<char>(kExtent * kExtent, 0);
};

Boxes boxesOver(std::uint32_t seed, bool isTurned) {
  std::mt19937 random(seed);
  const auto number = [&](int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); };
  Boxes boxes;
  for (int y = 0; y < kExtent; y += kTile)
    for (int x = 0; x < kExtent; x += kTile) boxes.soup.floor(x, y, x + kTile, y + kTile, 0);
  for (int i = 0; i < 12; ++i) {
    const int x = number(kExtent - 8), y = number(kExtent - 8);
    const int right = x + 4 + number(5), top = y + 4 + number(5);
    const double z = 0.25 + number(8) / 8.0;
    boxes.soup.box({static_cast<double>(x), static_cast<double>(y), z},
                   {static_cast<double>(right), static_cast<double>(top), z + 0.125 + number(16) / 8.0});
    boxes.rectangles.push_back({x, y, right, top});
    for (int row = y; row < top; ++row)
      for (int column = x; column < right; ++column) boxes.covered[row * kExtent + column] = 1;
  }
  // Turned corners are whole numbers, too.
  if (isTurned)
    boxes.soup = boxes.soup.mapped([](const Vec3& p) { return Vec3{3 * p.x - 4 * p.y, 4 * p.x + 3 * p.y, p.z}; });
  return boxes;
}

}  // namespace

class TestClosedCover : public QObject {
  Q_OBJECT

 private slots:
  void boxesTakeWhatLiesUnderThem_data();
  void boxesTakeWhatLiesUnderThem();
  void floorsUnderOneBoxAreKnown();
  void seamsMustHaveBothSides();
};

void TestClosedCover::boxesTakeWhatLiesUnderThem_data() {
  QTest::addColumn<bool>("isTurned");
  QTest::newRow("along the axes") << false;
  QTest::newRow("turned") << true;
}

void TestClosedCover::boxesTakeWhatLiesUnderThem() {
  QFETCH(bool, isTurned);
  const std::string filters = "SlopeFilter 45\nVerticalClearanceFilter 2\n";
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const Boxes boxes = boxesOver(seed, isTurned);
    const auto environment = boxes.soup.environment();
    const NavigationMesh mesh = run(*environment, filters, 2);
    QCOMPARE(findMeshError(mesh), std::string());
    // Turning makes areas 25 times as large.
    const auto open = static_cast<double>(std::count(boxes.covered.begin(), boxes.covered.end(), 0));
    QVERIFY(std::abs(floorArea(mesh) - (isTurned ? 25 * open : open)) < 1e-9 * kExtent * kExtent * 25);

    QVERIFY(same(run(*environment, "GridStrategy 3 2\n" + filters + "Collapse\n", 2), mesh));
    std::vector<std::uint32_t> order(environment->triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    QVERIFY(same(run(*shuffled(*environment, order, 1), filters, 2), mesh));
  }
}

// A floor that is known to be covered is covered, and that includes everything under a single box.
void TestClosedCover::floorsUnderOneBoxAreKnown() {
  int known = 0, together = 0;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const Boxes boxes = boxesOver(seed, false);
    const StatePtr state = runFilters(boxes.soup.environment(), "SlopeFilter 45\n");
    const PlanKernel kernel(state->kernel->sharedMesh(), {2.0});
    const SourceMesh& mesh = kernel.mesh();
    ClearanceCandidates search(kernel, [](Index) { return true; }, 1, {});
    for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
      const Vec3 &a = mesh.vertices[mesh.triangles[t][0]], &b = mesh.vertices[mesh.triangles[t][1]],
                 &c = mesh.vertices[mesh.triangles[t][2]];
      if (mesh.facing[t] <= 0 || a.z != 0 || b.z != 0 || c.z != 0) continue;
      const double left = std::min({a.x, b.x, c.x}), low = std::min({a.y, b.y, c.y});
      const double right = std::max({a.x, b.x, c.x}), top = std::max({a.y, b.y, c.y});
      const bool isUnderOne = std::any_of(boxes.rectangles.begin(), boxes.rectangles.end(), [&](const auto& r) {
        return r[0] <= left && r[1] <= low && r[2] >= right && r[3] >= top;
      });
      // The middles of quarters of unit squares lie in the triangle or beside it, but not on its diagonal.
      bool isCovered = true;
      for (int row = static_cast<int>(low); row < static_cast<int>(top); ++row)
        for (int column = static_cast<int>(left); column < static_cast<int>(right); ++column) {
          if (boxes.covered[row * kExtent + column] != 0) continue;
          for (const auto& [dx, dy] : {std::array{0.5, 0.125}, std::array{0.5, 0.875}}) {
            const auto side = [x = column + dx, y = row + dy](const Vec3& p, const Vec3& q) {
              return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
            };
            isCovered = isCovered && (side(a, b) < 0 || side(b, c) < 0 || side(c, a) < 0);
          }
        }
      const auto candidates = search.find(t);
      if (isUnderOne) QVERIFY(search.areKnownToCover());
      if (!search.areKnownToCover()) continue;
      QVERIFY(isCovered);
      ++known;
      if (std::none_of(candidates.begin(), candidates.end(),
                       [](const ClearanceCandidate& one) { return one.coversFace(); }))
        ++together;
    }
  }
  QVERIFY2(together >= 20, qPrintable(QString("%1 of %2").arg(together).arg(known)));
}

// A crack between two obstacles leaves something of a floor, however narrow it is, and one beside the floor does not
// matter.
void TestClosedCover::seamsMustHaveBothSides() {
  const auto isKnown = [](const Soup& soup) {
    const StatePtr state = runFilters(soup.environment(), "SlopeFilter 45\n");
    const PlanKernel kernel(state->kernel->sharedMesh(), {2.0});
    ClearanceCandidates search(kernel, [](Index) { return true; }, 1, {});
    for (Index t = 0; t < static_cast<Index>(kernel.mesh().triangles.size()); ++t)
      if (kernel.mesh().facing[t] > 0 && kernel.mesh().vertices[kernel.mesh().triangles[t][0]].z == 0) {
        search.find(t);
        return search.areKnownToCover();
      }
    return false;
  };
  Soup floor;
  floor.triangle({1, 1, 0}, {3, 1, 0}, {1, 3, 0});
  Soup closed = floor, cracked = floor, oneSided = floor, above = floor, touched = floor;
  closed.ceiling(0, 0, 4, 4, 1);
  QVERIFY(isKnown(closed));
  // The second triangle begins a little beside the diagonal of the first.
  cracked.triangle({0, 0, 1}, {4, 0, 1}, {4, 4, 1}).triangle({0, 0x1p-40, 1}, {4, 4 + 0x1p-40, 1}, {0, 8, 1});
  QVERIFY(!isKnown(cracked));
  // Both triangles lie on the same side of their common edge.
  oneSided.triangle({0, 0, 1}, {4, 0, 1}, {4, 4, 1}).triangle({0, 0, 1}, {4, -2, 1}, {4, 4, 1});
  QVERIFY(!isKnown(oneSided));
  // One of the two is not within the clearance.
  above.triangle({0, 0, 1}, {4, 0, 1}, {4, 4, 1}).triangle({0, 0, 1}, {4, 4, 1}, {0, 8, 3});
  QVERIFY(!isKnown(above));
  // The floor ends where the obstacles do.
  touched.triangle({1, 1, 1}, {3, 1, 1}, {2, 2, 1}).triangle({1, 1, 1.5}, {2, 2, 1}, {1, 3, 1});
  QVERIFY(isKnown(touched));
}

QTEST_GUILESS_MAIN(TestClosedCover)
#include "test_closed_cover.moc"
