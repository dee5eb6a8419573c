// The path finder of an edited result, made of the one before, answers as one that is made anew, to the last byte.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/io/import.hpp"
#include "core/navigation/path_ground.hpp"
#include "footfall/edit.hpp"
#include "footfall/path.hpp"
#include "tests/support/changed_level.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using Random = std::mt19937;
using MeshPtr = std::shared_ptr<const NavigationMesh>;

bool isSame(const SurfaceTopology& a, const SurfaceTopology& b) {
  return a.neighbours == b.neighbours && a.fans == b.fans && a.fanVertices == b.fanVertices && a.isOpen == b.isOpen &&
         a.components == b.components && a.componentCount == b.componentCount;
}

bool isSame(const std::optional<SurfacePlace>& a, const std::optional<SurfacePlace>& b) {
  if (!a || !b) return !a && !b;
  return a->position == b->position && a->triangle == b->triangle && a->distance == b->distance;
}

bool isSame(const PathResult& a, const PathResult& b) {
  return a.status == b.status && isSame(a.start, b.start) && isSame(a.end, b.end) && isSame(a.target, b.target) &&
         a.points == b.points && a.triangles == b.triangles && a.bends == b.bends && a.steps == b.steps &&
         a.gaps == b.gaps && a.drops == b.drops && a.leadsBack == b.leadsBack && a.planLength == b.planLength &&
         a.length == b.length && a.layers == b.layers && a.expanded == b.expanded;
}

Vec3 anyPlace(const NavigationMesh& mesh, Random& random) {
  const Triangle& f = mesh.triangles[random() % mesh.triangles.size()];
  const Vec3 &a = mesh.vertices[f[0]], &b = mesh.vertices[f[1]], &c = mesh.vertices[f[2]];
  if (random() % 4 == 0) return a;
  return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, a.z};
}

/// True when both finders have the same data and give the same paths between some random places.
bool agrees(const PathFinder& followed, Random& random, int pairs) {
  const NavigationMesh& mesh = followed.mesh();
  const PathFinder anew(std::make_shared<NavigationMesh>(mesh));
  if (!isSame(followed.inside()->topology, anew.inside()->topology)) return false;
  for (int i = 0; i < pairs && !mesh.triangles.empty(); ++i) {
    const Vec3 from = anyPlace(mesh, random), to = anyPlace(mesh, random);
    if (!isSame(followed.find(from, to), anew.find(from, to))) return false;
    if (!isSame(followed.locate({from.x, from.y, to.z}), anew.locate({from.x, from.y, to.z}))) return false;
  }
  return true;
}

TriangleSoup boxAt(const Vec3& foot, double width, double height) {
  TriangleSoup soup;
  for (const double z : {0.0, height})
    for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
      soup.vertices.push_back({foot.x + x * width, foot.y + y * width, foot.z + z});
  soup.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t next = (i + 1) % 4;
    soup.triangles.push_back({i, next, 4 + next});
    soup.triangles.push_back({i, 4 + next, 4 + i});
  }
  return soup;
}

/// The mesh as an edit might leave it: some triangles are gone, some came, all are numbered anew; now and then in
/// another order, or with a triangle twice.
MeshPtr changed(const NavigationMesh& mesh, Random& random) {
  auto result = std::make_shared<NavigationMesh>();
  std::vector<Triangle> triangles;
  const std::size_t first = mesh.triangles.empty() ? 0 : random() % mesh.triangles.size(), count = random() % 5;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (t < first || t >= first + count) triangles.push_back(mesh.triangles[t]);
  std::vector<Vec3> vertices = mesh.vertices;
  for (std::size_t i = random() % 4; i > 0; --i) {
    Triangle added;
    for (std::uint32_t& corner : added) {
      corner = static_cast<std::uint32_t>(random() % (vertices.size() + 1));
      if (corner < vertices.size()) continue;
      vertices.push_back({static_cast<double>(random() % 6), static_cast<double>(random() % 6), 0});
    }
    triangles.insert(triangles.begin() + static_cast<std::ptrdiff_t>(random() % (triangles.size() + 1)), added);
  }
  if (random() % 8 == 0 && !triangles.empty()) triangles.push_back(triangles[random() % triangles.size()]);
  if (random() % 4 == 0)
    std::rotate(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(triangles.size() / 2),
                triangles.end());
  std::vector<std::uint32_t> numbers(vertices.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  if (random() % 2 == 0) std::shuffle(numbers.begin(), numbers.end(), random);
  result->vertices.resize(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) result->vertices[numbers[v]] = vertices[v];
  for (Triangle& triangle : triangles)
    for (std::uint32_t& corner : triangle) corner = numbers[corner];
  result->triangles = std::move(triangles);
  return result;
}

/// Moves a box through a level and compares the finder after each edit.
bool followsBox(const std::shared_ptr<const Environment>& level, const std::string& pipeline, int edits) {
  ResultCache cache;
  const RunResult first = run(level, pipeline, &cache);
  if (first.mesh->triangles.empty()) return false;
  Random random(1);
  auto finder = std::make_unique<const PathFinder>(first.mesh);
  EditableEnvironment editable(level);
  const ObstacleId box = editable.add(boxAt(anyPlace(*first.mesh, random), 0.8, 1));
  for (int i = 0; i < edits; ++i) {
    const RunResult now = run(editable.environment(), pipeline, &cache);
    auto next = std::make_unique<const PathFinder>(now.mesh, *finder);
    finder = std::move(next);
    if (!agrees(*finder, random, 20)) return false;
    editable.replace(box, boxAt(anyPlace(*first.mesh, random), 0.3 + 0.3 * (i % 4), 0.2 + i % 3));
  }
  return true;
}

}  // namespace

class TestEditedPaths : public QObject {
  Q_OBJECT

 private slots:
  // Parts come, move and go, with steps and gaps between them, with layers and without.
  void randomBuildings() {
    QVERIFY(check("finders of edited buildings", 100, [] {
      const auto level = buildingOf(*buildingParts(14)).environment(*below(4) == 0);
      const std::array<std::string, 4> pipelines{
          defaultFilters(45, 1), "SlopeFilter 60\nVerticalClearanceFilter 1\nStepFilter 1 1\n",
          "SlopeFilter 60\nVerticalClearanceFilter 1.5\nStepFilter 0.5 0.5\nLayerSubdivisionFilter\n",
          "VerticalClearanceFilter 1\nStepFilter 1 0\nLayerSubdivisionFilter\nDropFilter 5\n"};
      const std::string pipeline = pipelines[static_cast<std::size_t>(*below(static_cast<int>(pipelines.size())))];
      Random random(static_cast<unsigned>(*below(1000)));
      EditableEnvironment editable(level);
      ResultCache cache;
      auto finder = std::make_unique<const PathFinder>(run(level, pipeline, &cache).mesh);
      std::vector<ObstacleId> obstacles;
      for (int i = 0; i < 6; ++i) {
        const TriangleSoup soup = soupFor(buildingOf(*buildingParts(2)));
        const int choice = *below(4);
        if (obstacles.empty() || choice < 2)
          obstacles.push_back(editable.add(soup));
        else if (choice == 2)
          editable.replace(obstacles.back(), soup);
        else {
          editable.remove(obstacles.back());
          obstacles.pop_back();
        }
        const RunResult now = run(editable.environment(), pipeline, &cache);
        auto next = std::make_unique<const PathFinder>(now.mesh, *finder);
        finder = std::move(next);
        RC_ASSERT(agrees(*finder, random, 10));
      }
    }));
  }

  // Meshes that no run makes: edges with three triangles, triangles that face down, that have a corner twice, or that
  // are there twice.
  void anyMeshes() {
    Random random(static_cast<unsigned>(seed()));
    for (int round = 0; round < rounds(300); ++round) {
      auto grid = std::make_shared<NavigationMesh>();
      const std::uint32_t size = 3 + static_cast<std::uint32_t>(random() % 4);
      for (std::uint32_t y = 0; y <= size; ++y)
        for (std::uint32_t x = 0; x <= size; ++x)
          grid->vertices.push_back({static_cast<double>(x), static_cast<double>(y), 0});
      for (std::uint32_t y = 0; y < size; ++y)
        for (std::uint32_t x = 0; x < size; ++x) {
          if (random() % 8 == 0) continue;
          const std::uint32_t a = y * (size + 1) + x, b = a + 1, c = a + size + 1, d = c + 1;
          grid->triangles.insert(grid->triangles.end(), {{a, b, d}, {a, d, c}});
        }
      MeshPtr mesh = grid;
      auto finder = std::make_unique<const PathFinder>(mesh);
      for (int edit = 0; edit < 8; ++edit) {
        mesh = changed(*mesh, random);
        auto next = std::make_unique<const PathFinder>(mesh, *finder);
        finder = std::move(next);
        QVERIFY2(agrees(*finder, random, 5), qPrintable(QString("round %1, edit %2").arg(round).arg(edit)));
      }
    }
  }

  void levels() {
    const auto villa =
        importEnvironment(std::string(FOOTFALL_SOURCE_DIR) + "/samples/villa/villa.obj", ImportOptions());
    QVERIFY(followsBox(villa, formatPipeline(defaultPipeline(*villa)), 6));
    // Off the grid, nothing has round numbers.
    LevelChange turned;
    turned.degrees = 17;
    const auto other = changedLevel(*villa, turned, GridChoice::Off);
    QVERIFY(followsBox(other, formatPipeline(defaultPipeline(*other)), 4));
  }

  // Most of the triangles are found again and not looked at as new ones.
  void mostIsTakenOver() {
    const auto villa =
        importEnvironment(std::string(FOOTFALL_SOURCE_DIR) + "/samples/villa/villa.obj", ImportOptions());
    const std::string pipeline = formatPipeline(defaultPipeline(*villa));
    ResultCache cache;
    const RunResult before = run(villa, pipeline, &cache);
    EditableEnvironment editable(villa);
    Random random(3);
    editable.add(boxAt(anyPlace(*before.mesh, random), 0.8, 1));
    const RunResult now = run(editable.environment(), pipeline, &cache);
    const SurfaceRelation relation = relateSurfaces(*before.mesh, *now.mesh);
    QVERIFY(relation.related > 0.95 * static_cast<double>(now.mesh->triangles.size()));
    QVERIFY(relation.related < now.mesh->triangles.size());
  }

  void otherLevels() {
    const auto floor = run(Soup().floor(0, 0, 4, 4, 0).environment(), "VerticalClearanceFilter 2\n", nullptr).mesh;
    const auto nothing = std::make_shared<const NavigationMesh>();
    Random random(1);
    const PathFinder first(floor), none(nothing, first), again(floor, none);
    QCOMPARE(none.find({1, 1, 0}, {2, 2, 0}).status, PathStatus::NothingWalkable);
    QVERIFY(agrees(again, random, 5));
    std::unique_ptr<const PathFinder> same;
    {
      const PathFinder gone(std::make_shared<NavigationMesh>(*floor));
      same = std::make_unique<const PathFinder>(floor, gone);
    }
    QVERIFY(agrees(*same, random, 5));  // the one before is gone
  }
};

QTEST_APPLESS_MAIN(TestEditedPaths)
#include "test_edited_paths.moc"
