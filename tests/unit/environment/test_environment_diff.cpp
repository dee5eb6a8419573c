// A file that was saved anew as an edit of what was there before: the same triangles, and the bytes of a fresh run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QtTest>
#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "core/environment/environment_diff.hpp"
#include "core/io/import.hpp"
#include "footfall/errors.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using Row = std::tuple<std::array<double, 9>, std::string, int>;

/// Each triangle with part and role, sorted.
std::vector<Row> content(const Environment& environment) {
  std::vector<Row> rows;
  for (std::size_t t = 0; t < environment.triangles.size(); ++t) {
    std::array<double, 9> numbers{};
    Triangle f = environment.triangles[t];
    const auto key = [&](std::uint32_t v) {
      const Vec3& p = environment.vertices[v];
      return std::array{p.x, p.y, p.z};
    };
    std::rotate(f.begin(), std::min_element(f.begin(), f.end(), [&](auto a, auto b) { return key(a) < key(b); }),
                f.end());
    for (std::size_t k = 0; k < 3; ++k) std::copy_n(key(f[k]).begin(), 3, numbers.begin() + 3 * k);
    rows.emplace_back(numbers, environment.partOf.empty() ? "" : environment.parts[environment.partOf[t]].mesh,
                      environment.obstacleOnly.empty() ? 0 : environment.obstacleOnly[t]);
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

std::vector<std::array<double, 3>> places(const Environment& environment) {
  std::vector<std::array<double, 3>> result;
  for (const Vec3& p : environment.vertices) result.push_back({p.x + 0.0, p.y + 0.0, p.z + 0.0});
  std::sort(result.begin(), result.end());
  return result;
}

/// The maps of an edit say what they must.
bool isEditOf(const Environment& edited, const Environment& base) {
  const EnvironmentEdit& edit = *edited.edit;
  if (!std::is_sorted(edit.keptVertices.begin(), edit.keptVertices.end())) return false;
  if (!std::is_sorted(edit.keptTriangles.begin(), edit.keptTriangles.end())) return false;
  for (std::size_t v = 0; v < edit.keptVertices.size(); ++v)
    if (!(edited.vertices[v] == base.vertices[edit.keptVertices[v]])) return false;
  return true;
}

/// The same environment in another order, as another program might save it.
std::shared_ptr<Environment> savedAnew(const Environment& environment, int seed) {
  std::vector<std::uint32_t> order(environment.triangles.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
  std::mt19937 random(static_cast<unsigned>(seed));
  std::shuffle(order.begin(), order.end(), random);
  return shuffled(environment, order, static_cast<std::uint32_t>(seed % 3));
}

const std::array<std::string, 5> kPipelines{
    "SlopeFilter 45\nVerticalClearanceFilter 2\n", defaultFilters(45, 1),
    "VerticalClearanceFilter 1\nVerticalClearanceFilter 2\nRoundingFilter\nSlopeFilter 30\n",
    "GridStrategy 2 3\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\nSimplificationFilter\n",
    "SlopeFilter 60\nAreaFilter 1\nVerticalClearanceFilter 1.5\nLayerSubdivisionFilter\n"};

/// Runs the edit with its cache, and the version itself from scratch.
bool sameBytes(const std::shared_ptr<const Environment>& edited, const std::shared_ptr<const Environment>& version,
               const std::string& pipeline, ResultCache& cache) {
  const RunResult live = run(edited, pipeline, &cache), fresh = run(version, pipeline, nullptr);
  return exported(live) == exported(fresh) && live.summary.area == fresh.summary.area &&
         live.summary.rejected == fresh.summary.rejected && live.steps[0].note == fresh.steps[0].note;
}

}  // namespace

class TestEnvironmentDiff : public QObject {
  Q_OBJECT
 private slots:
  void whatDiffers() {
    const std::shared_ptr<const Environment> before =
        Soup().floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, 1).floor(0, 0, 4, 4, 2).environment();
    const auto changed = Soup().floor(0, 0, 4, 4, 2).floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, 1).wall(0, 0, 1, 1, 0, 1);
    const std::shared_ptr<const Environment> now = changed.environment();
    const auto edited = diffEnvironments(before, now);
    QVERIFY(edited != now && edited->edit->base.lock() == before);
    QCOMPARE(edited->edit->keptTriangles.size(), std::size_t{6});
    QVERIFY(content(*edited) == content(*now) && places(*edited) == places(*now) && isEditOf(*edited, *before));
  }

  void noEditWhereItDoesNotPay() {
    const std::shared_ptr<const Environment> before = Soup().floor(0, 0, 4, 4, 0).environment();
    const std::shared_ptr<const Environment> other = Soup().floor(0, 0, 5, 5, 0).environment();
    const std::shared_ptr<const Environment> bothSides = Soup().floor(0, 0, 4, 4, 0).environment(true);
    QVERIFY(diffEnvironments(before, other) == other);
    QVERIFY(diffEnvironments(before, bothSides) == bothSides);
    QVERIFY(diffEnvironments(before, before) == before);
    QVERIFY(diffEnvironments(nullptr, other) == other);
  }

  // Copies are counted; a triangle that faces the other way is another one.
  void copiesAndWinding() {
    const std::shared_ptr<const Environment> before =
        Soup().floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, 3).floor(0, 0, 4, 4, 5).environment();
    const std::shared_ptr<const Environment> once =
        Soup().floor(0, 0, 4, 4, 5).floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, 3).environment();
    QCOMPARE(diffEnvironments(before, once)->edit->keptTriangles.size(), std::size_t{6});
    const std::shared_ptr<const Environment> turned =
        Soup().floor(0, 0, 4, 4, 5).floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, 3).ceiling(0, 0, 4, 4, 0).environment();
    const auto edited = diffEnvironments(before, turned);
    QCOMPARE(edited->edit->keptTriangles.size(), std::size_t{6});
    QVERIFY(content(*edited) == content(*turned));
  }

  // One version welds what the other repeats, and has vertices that nothing uses.
  void otherVertices() {
    auto before = Soup().floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, 1).environment();
    auto now = std::make_shared<Environment>();
    now->vertices = {{9, 9, 9}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}};
    now->triangles = {{5, 6, 7}, {5, 7, 8}, {1, 2, 3}, {1, 3, 4}};
    for (const auto& [from, to] : {std::pair{before, now}, std::pair{now, before}}) {
      const auto edited = diffEnvironments(from, to);
      QVERIFY(edited->edit && edited->edit->keptTriangles.size() == 4);
      QVERIFY(content(*edited) == content(*to) && places(*edited) == places(*to) && isEditOf(*edited, *from));
      for (const std::string& pipeline : kPipelines) {
        ResultCache cache;
        QVERIFY(agrees(from, pipeline, cache));
        QVERIFY(sameBytes(edited, to, pipeline, cache));
      }
    }
  }

  void randomVersions() {
    QVERIFY(check("versions of random buildings", 250, [] {
      const auto parts = *buildingParts(12);
      const bool bothSides = *below(4) == 0;
      std::shared_ptr<const Environment> shown = buildingOf(parts).environment(bothSides);
      const std::string pipeline = kPipelines[static_cast<std::size_t>(*below(static_cast<int>(kPipelines.size())))];
      ResultCache cache;
      RC_ASSERT(agrees(shown, pipeline, cache));
      for (int i = 0; i < 3; ++i) {
        auto changed = parts;
        if (!changed.empty() && *below(3) > 0)
          changed.erase(changed.begin() + *below(static_cast<int>(changed.size())));
        const auto added = *buildingParts(2);
        changed.insert(changed.end(), added.begin(), added.end());
        const auto version = savedAnew(*buildingOf(changed).environment(bothSides), *below(1000));
        if (*below(2) == 0)
          for (std::size_t t = 0; t < version->triangles.size(); ++t)
            version->obstacleOnly.push_back(static_cast<std::uint8_t>(t % 3 == 0));
        shown = diffEnvironments(shown, version);
        RC_ASSERT(content(*shown) == content(*version));
        RC_ASSERT(sameBytes(shown, version, pipeline, cache));
      }
    }));
  }

  // So much changes that obstacles above a floor are looked up again.
  void manyTriangles() {
    const auto level = importEnvironment(std::string(FOOTFALL_SOURCE_DIR) + "/samples/house/house.obj");
    const auto grown = [&](int crates, double shift) {
      auto result = std::make_shared<Environment>(*level);
      std::mt19937 random(5);
      for (int i = 0; i < crates; ++i) {
        const Vec3 at = level->vertices[random() % level->vertices.size()];
        const TriangleSoup crate =
            soupFor(Soup().box({at.x + shift, at.y, at.z + 0.25}, {at.x + shift + 0.5, at.y + 0.25, at.z + 0.5}));
        const auto first = static_cast<std::uint32_t>(result->vertices.size());
        result->vertices.insert(result->vertices.end(), crate.vertices.begin(), crate.vertices.end());
        for (const Triangle& t : crate.triangles)
          result->triangles.push_back({first + t[0], first + t[1], first + t[2]});
        if (!result->partOf.empty()) result->partOf.resize(result->triangles.size(), 0);
      }
      return result;
    };
    ResultCache cache;
    std::shared_ptr<const Environment> shown = grown(400, 0);
    QVERIFY(agrees(shown, defaultFilters(45, 2), cache));
    for (const int crates : {420, 300, 399}) {
      const auto version = grown(crates, 0);
      shown = diffEnvironments(shown, version);
      QVERIFY(shown->edit);
      QVERIFY(sameBytes(shown, version, defaultFilters(45, 2), cache));
    }
  }

  void cancelling() {
    RunContext context;
    context.cancel();
    const std::shared_ptr<const Environment> before = Soup().floor(0, 0, 4, 4, 0).environment();
    const std::shared_ptr<const Environment> now = Soup().floor(0, 0, 4, 4, 0).environment();
    QVERIFY_EXCEPTION_THROWN(diffEnvironments(before, now, &context), Cancelled);
  }
};

QTEST_GUILESS_MAIN(TestEnvironmentDiff)
#include "test_environment_diff.moc"
