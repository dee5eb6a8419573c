// The level that follows the document's obstacles: one edit of the last level with results, and the same result as a
// run from nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <random>
#include <string>

#include "core/environment/part_rules.hpp"
#include "core/io/export.hpp"
#include "core/io/import.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/edit.hpp"
#include "tests/editor/editor_driver.hpp"
#include "ui/level/level_composer.hpp"
#include "ui/view/geometry/obstacle_geometry.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline =
    "DuplicationFilter 0\nDegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 0.5\n"
    "SimplificationFilter\nLayerSubdivisionFilter\n";

std::shared_ptr<const Environment> house() {
  return importEnvironment(std::string(FOOTFALL_SOURCE_DIR) + "/samples/house/house.obj");
}

RunResult runOn(const std::shared_ptr<const Environment>& level, ResultCache* cache) {
  RunContext context;
  return runPipeline(level, parsePipeline(kPipeline, "test"), context, cache, 2);
}

std::string exported(const std::shared_ptr<const Environment>& level, ResultCache* cache) {
  return formatObj(*runOn(level, cache).mesh, {});
}

PlacedObstacle box(std::uint32_t id, const Vec3& base, const Vec3& size = {1, 1, 1}, double turn = 0) {
  return {id, PlacedObstacle::Shape::Box, "Box " + std::to_string(id), base, size, turn};
}

/// Composes the level from nothing, without edits.
std::shared_ptr<const Environment> fromNothing(const Environment& loaded,
                                               const std::vector<PlacedObstacle>& obstacles) {
  auto level = std::make_shared<Environment>(loaded);
  level->edit = nullptr;
  for (const PlacedObstacle& obstacle : obstacles) {
    const TriangleSoup soup = solidSoupOf(obstacle, 0.4 / loaded.metresPerUnit);
    const auto first = static_cast<std::uint32_t>(level->vertices.size());
    level->vertices.insert(level->vertices.end(), soup.vertices.begin(), soup.vertices.end());
    for (const Triangle& t : soup.triangles) level->triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  if (!level->partOf.empty()) {
    level->parts.emplace_back();
    level->partOf.resize(level->triangles.size(), static_cast<std::uint32_t>(level->parts.size() - 1));
  }
  if (!level->obstacleOnly.empty()) level->obstacleOnly.resize(level->triangles.size(), 0);
  return level;
}

void setObstacles(Document& document, std::vector<PlacedObstacle> obstacles) {
  DocumentState next = document.state();
  next.obstacles = std::move(obstacles);
  document.edit(std::move(next), QStringLiteral("edit"));
}

/// Checks the composer's numbers of obstacle triangles, and that its geometry has the numbers of the level.
void checkNumbers(const LevelComposer& composer, const std::vector<PlacedObstacle>& obstacles) {
  const Environment& level = *composer.level();
  std::size_t count = composer.base()->triangles.size();
  for (const PlacedObstacle& obstacle : obstacles) {
    const LevelComposer::Triangles triangles = composer.trianglesOf(obstacle.id);
    QVERIFY(triangles.count >= soupOf(obstacle).triangles.size());
    count += triangles.count;
    QCOMPARE(composer.obstacleOf(triangles.first), std::optional(obstacle.id));
    QCOMPARE(composer.obstacleOf(triangles.first + triangles.count - 1), std::optional(obstacle.id));
    for (std::uint32_t t = triangles.first; t < triangles.first + triangles.count; ++t)
      for (const std::uint32_t v : level.triangles[t])
        QVERIFY(level.vertices[v].z >= obstacle.base.z && level.vertices[v].z <= obstacle.base.z + obstacle.size.z);
  }
  QCOMPARE(level.triangles.size(), count);
  QCOMPARE(composer.obstacleOf(0), std::nullopt);
  const auto geometry =
      withObstacles(makeEnvironmentGeometry(*composer.base()), level, composer.base()->triangles.size());
  QCOMPARE(geometry->surface.size(), 3 * level.triangles.size());
}

}  // namespace

class TestLevelComposer : public QObject {
  Q_OBJECT

 private slots:
  void followsTheDocument() {
    Document document;
    LevelComposer composer(document);
    int edits = 0;
    connect(&composer, &LevelComposer::edited, this, [&] { ++edits; });
    setObstacles(document, {box(1, {0, 0, 0})});
    QVERIFY(!composer.level());
    const auto loaded = house();
    composer.setLoaded(loaded);
    QCOMPARE(edits, 0);
    QCOMPARE(composer.level()->triangles.size(), loaded->triangles.size() + 16);  // 12, and two faces inside
    setObstacles(document, {box(1, {0, 0, 0}), box(2, {3, 0, 0})});
    QCOMPARE(edits, 1);
    // A new name is no new level, and neither is the same obstacle again.
    PlacedObstacle renamed = box(2, {3, 0, 0});
    renamed.name = "crate";
    setObstacles(document, {box(1, {0, 0, 0}), renamed});
    setObstacles(document, {renamed, box(1, {0, 0, 0})});
    QCOMPARE(edits, 1);
    setObstacles(document, {});
    QCOMPARE(edits, 2);
    QCOMPARE(composer.level()->triangles.size(), loaded->triangles.size());
    composer.setLoaded(nullptr);
    QVERIFY(!composer.level());
  }

  // A drag: whatever was overtaken, a level is an edit of the last one with results.
  void editsBuildOnResults() {
    Document document;
    LevelComposer composer(document);
    composer.setLoaded(house());
    const auto start = composer.level();
    composer.setComputed(start);
    for (int i = 1; i <= 4; ++i) {
      setObstacles(document, {box(1, {0.1 * i, 0, 0})});
      QCOMPARE(composer.level()->edit->base.lock(), start);
      QCOMPARE(composer.level()->edit->keptTriangles.size(), start->triangles.size());
    }
    const auto moved = composer.level();
    composer.setComputed(moved);
    setObstacles(document, {box(1, {0.5, 0, 0})});
    QCOMPARE(composer.level()->edit->base.lock(), moved);
    // Back where the results are: no edit at all.
    setObstacles(document, {box(1, {0.4, 0, 0})});
    QCOMPARE(composer.level(), moved);
    // Results of unknown levels change nothing.
    composer.setComputed(start);
    setObstacles(document, {box(1, {0.6, 0, 0})});
    QCOMPARE(composer.level()->edit->base.lock(), moved);
  }

  void aBrokenObstacleIsLeftOut() {
    Document document;
    LevelComposer composer(document);
    QStringList problems;
    connect(&composer, &LevelComposer::failed, this, [&](const QString& message) { problems << message; });
    const auto loaded = house();
    composer.setLoaded(loaded);
    setObstacles(document, {box(1, {0, 0, 0}, {1, 0, 1}), box(2, {0, 0, 0})});
    QCOMPARE(problems.size(), 1);
    QVERIFY2(problems[0].contains("Box 1") && problems[0].contains("above 0"), qPrintable(problems[0]));
    QCOMPARE(composer.level()->triangles.size(), loaded->triangles.size() + 16);
    QCOMPARE(composer.trianglesOf(1).count, 0U);
  }

  // The bytes are equal over random edits, undo and redo, and runs that end or do not.
  void sameAsFromNothing() {
    std::mt19937 random(5);
    const auto below = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
    const auto loaded = house();
    Vec3 lower = loaded->vertices[0], upper = lower;
    for (const Vec3& v : loaded->vertices) {
      lower = {std::min(lower.x, v.x), std::min(lower.y, v.y), std::min(lower.z, v.z)};
      upper = {std::max(upper.x, v.x), std::max(upper.y, v.y), std::max(upper.z, v.z)};
    }
    Document document;
    LevelComposer composer(document);
    composer.setLoaded(loaded);
    ResultCache cache;
    (void)runOn(composer.level(), &cache);
    composer.setComputed(composer.level());
    std::uint32_t nextId = 1;
    for (int i = 0; i < 60; ++i) {
      std::vector<PlacedObstacle> obstacles = document.state().obstacles;
      const auto any = [&](PlacedObstacle o) {
        const auto within = [&](double a, double b) { return a + (b - a) * below(200) / 200.0; };
        o.shape = static_cast<PlacedObstacle::Shape>(below(3));
        o.base = {within(lower.x, upper.x), within(lower.y, upper.y),
                  below(2) == 0 ? lower.z : within(lower.z, upper.z)};
        o.size = {0.25 * (1 + below(8)), 0.25 * (1 + below(8)), 0.25 * (1 + below(12))};
        o.turn = below(2) == 0 ? 90 * below(4) : below(360);
        return o;
      };
      const int choice = below(8);
      if (choice == 0 && document.undoStack()->canUndo()) {
        for (int n = below(4); n >= 0; --n) document.undoStack()->undo();
      } else if (choice == 1 && document.undoStack()->canRedo()) {
        document.undoStack()->redo();
      } else if (choice == 2 && !obstacles.empty()) {
        obstacles.erase(obstacles.begin() + below(static_cast<int>(obstacles.size())));
        setObstacles(document, obstacles);
      } else if (choice <= 4 && !obstacles.empty()) {
        PlacedObstacle& o = obstacles[static_cast<std::size_t>(below(static_cast<int>(obstacles.size())))];
        o = any(o);
        setObstacles(document, obstacles);
      } else {
        obstacles.push_back(any(box(nextId++, {})));
        setObstacles(document, obstacles);
      }
      checkNumbers(composer, document.state().obstacles);
      if (below(3) == 0) continue;  // overtaken before it began
      const std::string live = exported(composer.level(), &cache);
      QVERIFY(live == exported(fromNothing(*loaded, document.state().obstacles), nullptr));
      if (below(4) != 0) composer.setComputed(composer.level());
    }
  }

  // Parts are ignored and come back while obstacles stand in the level.
  void rolesOfPartsAndObstacles() {
    auto loaded = std::make_shared<Environment>(*house());
    loaded->parts = {{"ground", ""}, {"rest", ""}};
    loaded->partOf.assign(loaded->triangles.size(), 0);
    for (std::size_t t = 0; t < loaded->triangles.size(); t += 3) loaded->partOf[t] = 1;
    Document document;
    LevelComposer composer(document);
    composer.setLoaded(loaded, makeEnvironmentGeometry(*loaded));
    ResultCache cache;
    const auto agrees = [&] {
      const auto level = composer.level();
      const auto base = applyPartRules(loaded, document.state().partRules);
      checkNumbers(composer, document.state().obstacles);
      const bool same = exported(level, &cache) == exported(fromNothing(*base, document.state().obstacles), nullptr);
      composer.setComputed(level);
      composer.parts().setComputed();
      return same;
    };
    setObstacles(document, {box(1, {0, 0, 0}), box(2, {2, 1, 0}, {1, 2, 1}, 30)});
    QVERIFY(agrees());
    const auto setRole = [&](PartRole role) {
      DocumentState next = document.state();
      next.partRules = {{"rest", "", role}};
      document.edit(std::move(next), QStringLiteral("role"));
    };
    for (const PartRole role : {PartRole::Ignored, PartRole::ObstacleOnly, PartRole::Ignored, PartRole::Floor}) {
      setRole(role);
      QTRY_VERIFY(!composer.busy());
      QVERIFY(agrees());
      std::vector<PlacedObstacle> moved = document.state().obstacles;
      moved[0].base.x += 0.25;
      setObstacles(document, moved);
      QVERIFY(agrees());
    }
    for (int i = 0; i < 5; ++i) {
      document.undoStack()->undo();
      QTRY_VERIFY(!composer.busy());
      QVERIFY(agrees());
    }
  }

  // The scene of a level is that of one that was made at once, whatever was in between.
  void geometryIsTheSame() {
    const auto loaded = house();
    const auto base = makeEnvironmentGeometry(*loaded);
    const auto level = fromNothing(*loaded, {box(1, {0, 0, 0}), box(2, {500, 3, 1}, {2, 2, 2}, 30)});
    const auto joined = withObstacles(base, *level, loaded->triangles.size());
    const auto whole = makeEnvironmentGeometry(*level, base->centre);
    QCOMPARE(joined->surface.size(), whole->surface.size());
    for (std::size_t i = 0; i < joined->surface.size(); ++i)
      QVERIFY(joined->surface[i].position == whole->surface[i].position);
    QCOMPARE(joined->lower, whole->lower);
    QCOMPARE(joined->upper, whole->upper);
    QCOMPARE(withObstacles(base, *loaded, loaded->triangles.size()), base);
  }
};

FOOTFALL_EDITOR_SUITE(TestLevelComposer)
#include "test_level_composer.moc"
