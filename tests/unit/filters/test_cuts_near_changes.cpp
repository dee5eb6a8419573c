// Floors under many obstacles are cut anew only near what an edit changed, and have the cuts that all of it would give.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "core/assembly/assembly_memory.hpp"
#include "core/assembly/walkable_state.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/edit.hpp"
#include "footfall/pipeline.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 60\nVerticalClearanceFilter 2\n";
constexpr int kSize = 32;

StatePtr cutState(const std::shared_ptr<const Environment>& environment, ResultCache& cache) {
  RunContext context;
  return stepStates(environment, parsePipeline(kPipeline, "test"), context, cache, 2).back();
}

bool isSame(const CutSegment& a, const CutSegment& b) {
  return a.from == b.from && a.to == b.to && a.line == b.line && a.direction == b.direction && a.winding == b.winding &&
         a.wall == b.wall;
}

bool isSame(const FaceCuts& a, const FaceCuts& b) {
  return a.removed == b.removed && a.edgeWalls == b.edgeWalls && a.startWinding == b.startWinding &&
         a.dependsOnFloors == b.dependsOnFloors && a.points == b.points && a.borders == b.borders &&
         a.lines == b.lines &&
         std::equal(a.segments.begin(), a.segments.end(), b.segments.begin(), b.segments.end(),
                    [](const CutSegment& x, const CutSegment& y) { return isSame(x, y); });
}

bool isSame(const ApproximatePoint& a, const ApproximatePoint& b) {
  return a.x == b.x && a.y == b.y && a.error == b.error;
}

bool isSame(const LargeFace& a, const LargeFace& b) {
  return a.depths == b.depths && a.areas == b.areas &&
         std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                    [](const ApproximatePoint& x, const ApproximatePoint& y) { return isSame(x, y); });
}

std::vector<Index> standing(const StatePtr& state, std::size_t face) {
  const auto& found = state->memory->candidates[face];
  return found ? std::vector<Index>(found->begin(), found->end()) : std::vector<Index>();
}

/// The number of floors with many obstacles over them; -1: not all is the same.
int compare(const StatePtr& edited, const StatePtr& fresh) {
  for (std::size_t t = 0; t < fresh->walkable.size(); ++t) {
    if (!isSame((*edited->cuts)[t], (*fresh->cuts)[t])) return -1;
    // Obstacles above covered floors are not kept completely.
    if (!fresh->cuts->isRemoved(t) && standing(edited, t) != standing(fresh, t)) return -1;
  }
  if (edited->memory->large.size() != fresh->memory->large.size()) return -1;
  for (const auto& [face, large] : fresh->memory->large) {
    const auto found = edited->memory->large.find(face);
    if (found == edited->memory->large.end() || !isSame(*found->second, *large)) return -1;
  }
  return static_cast<int>(fresh->memory->large.size());
}

/// Obstacles with corners on a coarse grid, so that they share edges, meet in points and lie on the floor's edges;
/// many stand upright.
class Obstacles {
 public:
  explicit Obstacles(unsigned seed) : random_(seed) {}

  /// Adds within a square of the given size.
  void add(Soup& soup, int count, int x, int y, int size) {
    for (int i = 0; i < count; ++i) {
      const int left = x + below(size), bottom = y + below(size);
      const auto corner = [&] {
        const double cx = left + below(3), cy = bottom + below(3), cz = (below(9) - 2) * 0.5;
        return Vec3{cx, cy, cz};
      };
      const Vec3 a = corner(), b = corner();
      Vec3 c = corner();
      if (below(3) == 0) c = {a.x, a.y, a.z + 1};
      if (a.z != 0 || b.z != 0 || c.z != 0) soup.triangle(a, b, c);
    }
  }

  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }

 private:
  std::mt19937 random_;
};

}  // namespace

class TestCutsNearChanges : public QObject {
  Q_OBJECT

 private slots:
  void obstaclesMoveAboutOnGiants() {
    for (unsigned seed = 0; seed < 12; ++seed) {
      Obstacles obstacles(seed);
      Soup soup;
      // The second one is steep, so that ceilings are cut as well.
      soup.triangle({0, 0, 0}, {kSize, 0, 0}, {kSize, kSize, 0});
      soup.triangle({0, 0, 0}, {kSize, kSize, 0}, {0, kSize, seed % 2 == 0 ? 0.0 : 2.0});
      obstacles.add(soup, 1600, -1, -1, kSize);
      EditableEnvironment editable(soup.environment());
      ResultCache cache, first;
      QCOMPARE(compare(cutState(editable.environment(), cache), cutState(editable.environment(), first)), 2);
      std::vector<ObstacleId> added;
      for (int i = 0; i < 12; ++i) {
        Soup moving;
        const int size = 1 + obstacles.below(4);
        // Some in the corners, where edges of the floors begin and windings are counted from.
        const int x = i % 4 == 0 ? -1 : obstacles.below(kSize), y = i % 4 == 0 ? -1 : obstacles.below(kSize);
        obstacles.add(moving, 1 + obstacles.below(12), x, y, size);
        if (moving.environment()->triangles.empty()) continue;
        if (added.empty() || i % 3 == 0)
          added.push_back(editable.add(soupFor(moving)));
        else
          editable.replace(added[static_cast<std::size_t>(obstacles.below(static_cast<int>(added.size())))],
                           soupFor(moving));
        ResultCache none;
        QCOMPARE(compare(cutState(editable.environment(), cache), cutState(editable.environment(), none)), 2);
      }
      for (const ObstacleId id : added) {
        editable.remove(id);
        ResultCache none;
        QCOMPARE(compare(cutState(editable.environment(), cache), cutState(editable.environment(), none)), 2);
      }
    }
  }

  // Whether depths are known depends on the number of areas; many walls have exactly that number.
  void depthsAreKnownOfEnoughAreas() {
    Obstacles random(3);
    Soup soup;
    soup.triangle({0, 0, 0}, {kSize, 0, 0}, {kSize, kSize, 0});
    const auto addSlab = [&](Soup& to) {
      const double x = 8 + random.below(kSize - 10), y = random.below(6);
      to.triangle({x, y, 1}, {x + 1, y, 1}, {x, y + 1, 1});
    };
    for (int i = 0; i < 200; ++i) {
      const double x = 8 + i % 20, y = 0.5 + 0.25 * static_cast<int>(i / 20);
      soup.triangle({x, y, 0}, {x + 0.5, y, 0}, {x, y, 1});
    }
    for (int i = 0; i < 60; ++i) addSlab(soup);
    EditableEnvironment editable(soup.environment());
    ResultCache cache;
    cutState(editable.environment(), cache);
    Soup first;
    addSlab(first);
    const ObstacleId id = editable.add(soupFor(first));
    int known = 0;
    for (int i = 0; i < 60; ++i) {
      Soup next;
      for (int k = 3 + random.below(4); k > 0; --k) addSlab(next);
      editable.replace(id, soupFor(next));
      ResultCache none;
      const int floors = compare(cutState(editable.environment(), cache), cutState(editable.environment(), none));
      QVERIFY2(floors >= 0, qPrintable(QString::number(i)));
      known += floors;
    }
    QVERIFY(known > 10 && known < 60);
  }

  // Added obstacles cover a giant, make it a crowd's floor, or stand on the whole of an edge; removed ones restore it.
  void giantsThatAreCoveredAndFreed() {
    Obstacles obstacles(7);
    Soup soup;
    soup.floor(0, 0, kSize, kSize, 0);
    obstacles.add(soup, 1500, -1, -1, kSize);
    EditableEnvironment editable(soup.environment());
    ResultCache cache;
    cutState(editable.environment(), cache);
    Soup lid, wall, crowd, plane;
    lid.floor(-1, -1, kSize + 1, kSize + 1, 1);
    wall.triangle({0, 0, 0}, {kSize, 0, 0}, {kSize, 0, 1}).triangle({0, 0, 0}, {kSize, 0, 1}, {0, 0, 1});
    for (int i = 0; i < 60; ++i) crowd.floor(1, 1, kSize - 1 - i * 0.25, kSize - 1, 0.5 + i / 64.0);
    plane.floor(3, 3, 5, 5, 0);
    const ObstacleId id = editable.add(soupFor(Soup().box({1, 1, 0}, {2, 2, 1})));
    for (const Soup* shape : {&lid, &wall, &crowd, &plane, &wall}) {
      editable.replace(id, soupFor(*shape));
      ResultCache none;
      QVERIFY(compare(cutState(editable.environment(), cache), cutState(editable.environment(), none)) >= 0);
    }
    editable.remove(id);
    ResultCache none;
    QCOMPARE(compare(cutState(editable.environment(), cache), cutState(editable.environment(), none)), 2);
  }
};

QTEST_GUILESS_MAIN(TestCutsNearChanges)
#include "test_cuts_near_changes.moc"
