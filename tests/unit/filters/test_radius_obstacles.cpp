// RadiusFilter leaves obstacles out of its result where no later filter reads them, which changes no product.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/filters/filter_traits.hpp"
#include "core/pipeline/block_structure.hpp"
#include "core/pipeline/result_cache.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/io.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "footfall/up_axis.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using EnvironmentPtr = std::shared_ptr<const Environment>;

const std::string kBefore = minimalPipeline(2) + "\nStepFilter 0.4 0.05\n";

/// The filters that may follow a RadiusFilter without its obstacles, each with usual values.
const std::vector<std::string> kReadNone{
    "SlopeFilter 30 0",       "AreaFilter 1",   "SimplificationFilter", "SimplificationFilter true 0.05",
    "LayerSubdivisionFilter", "RoundingFilter", "RadiusFilter 0.2",     "ReachableFilter"};

EnvironmentPtr sample(const std::string& name) {
  return std::make_shared<const Environment>(load(FOOTFALL_SOURCE_DIR "/samples/" + name + "/" + name + ".obj"));
}

EnvironmentPtr crates(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 11), size(0.2, 2), height(0, 3);
  Soup level = Soup().floor(0, 0, 12, 12, 0).floor(3, 3, 9, 9, 2.5);
  for (int i = 0; i < 12; ++i) {
    const double x = place(random), y = place(random), z = height(random);
    level.box({x, y, z}, {x + size(random), y + size(random), z + size(random)});
  }
  return level.environment();
}

/// All filters with obstacles: the states that runFilters() makes keep them.
NavigationMesh withObstacles(const EnvironmentPtr& level, const std::string& filters) {
  return navigationMesh(runFilters(level, filters));
}

/// A seed for ReachableFilter, a little above the middle of a triangle.
std::string seedOver(const NavigationMesh& mesh, std::size_t triangle, UpAxis up) {
  Vec3 middle{0, 0, 0.1};
  for (const std::uint32_t v : mesh.triangles[triangle]) {
    middle.x += mesh.vertices[v].x / 3;
    middle.y += mesh.vertices[v].y / 3;
    middle.z += mesh.vertices[v].z / 3;
  }
  const Vec3 place = inFileFrame(middle, up);
  std::ostringstream text;
  text << std::setprecision(17) << ' ' << place.x << ' ' << place.y << ' ' << place.z;
  return text.str();
}

NavigationMesh asRun(const EnvironmentPtr& level, const std::string& filters, ResultCache* cache = nullptr) {
  RunContext context;
  return *runPipeline(level, parsePipeline(filters, "pipeline"), context, cache).mesh;
}

/// True when both have the same floors. Obstacles at the corner of a margin may change how places are numbered, and by
/// that which diagonal divides four corners on a circle.
bool hasEqualFloors(const NavigationMesh& a, const NavigationMesh& b) {
  const auto isSame = [](const Vec3& p, const Vec3& q) { return p.x == q.x && p.y == q.y && p.z == q.z; };
  return std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(), isSame) &&
         a.sourceTriangles == b.sourceTriangles && a.obstacleEdges == b.obstacleEdges &&
         a.links.size() == b.links.size() && std::fabs(area(a) - area(b)) <= 1e-12 * area(b);
}

bool isEqual(const NavigationMesh& a, const NavigationMesh& b) {
  return hasEqualFloors(a, b) && a.triangles == b.triangles && a.layers == b.layers && a.drops.size() == b.drops.size();
}

std::vector<const PipelineStep*> stepsOf(const Pipeline& pipeline) {
  std::vector<const PipelineStep*> steps;
  for (const PipelineStep& step : pipeline.steps) steps.push_back(&step);
  return steps;
}

}  // namespace

class TestRadiusObstacles : public QObject {
  Q_OBJECT

 private slots:
  void noFilterThatReadsNoObstaclesMissesThem() {
    std::vector<EnvironmentPtr> levels{sample("house"), sample("villa")};
    for (unsigned i = 0; i < 6; ++i) levels.push_back(crates(static_cast<unsigned>(seed()) + i));
    for (const EnvironmentPtr& level : levels) {
      const NavigationMesh floors = withObstacles(level, kBefore + "RadiusFilter 0.3\n");
      QVERIFY(!floors.triangles.empty());
      for (std::string filter : kReadNone) {
        if (filter == "ReachableFilter") filter += seedOver(floors, 0, level->up);
        const std::string filters = kBefore + "RadiusFilter 0.3\n" + filter + "\n";
        const NavigationMesh run = asRun(level, filters), expected = withObstacles(level, filters);
        QVERIFY2(filter.starts_with("Radius") ? hasEqualFloors(run, expected) : isEqual(run, expected), filter.c_str());
      }
      const std::string many =
          kBefore + "RadiusFilter 0.3\nAreaFilter 1\nSimplificationFilter\nLayerSubdivisionFilter\n";
      QVERIFY(isEqual(asRun(level, many), withObstacles(level, many)));
    }
  }

  // kReadNone has every filter that says so.
  void theListIsComplete() {
    for (const FilterDescriptor& filter : filterDescriptors()) {
      std::vector<double> values;
      for (const ParameterDescriptor& parameter : filter.parameters) values.push_back(parameter.defaultValue);
      if (filter.traits->readsObstacles(values)) continue;
      const auto isOf = [&](const std::string& line) { return line.substr(0, line.find(' ')) == filter.name; };
      QVERIFY2(std::any_of(kReadNone.begin(), kReadNone.end(), isOf), std::string(filter.name).c_str());
    }
  }

  void filtersThatReadObstaclesHaveThem() {
    const EnvironmentPtr level = sample("house");
    for (const std::string after : {"VerticalClearanceFilter 2.2", "RadiusFilter 0.3 0.2", "StepFilter 0.3",
                                    "DropFilter 1.5 0.63", "DuplicationFilter 0.01", "DegeneracyFilter"}) {
      const std::string filters = kBefore + "RadiusFilter 0.2\n" + after + "\n";
      QVERIFY2(isEqual(asRun(level, filters), withObstacles(level, filters)), after.c_str());
    }
    // The test sees a difference: without obstacles a clearance removes nothing.
    RunContext context;
    Recall without;
    without.needsObstacles = false;
    const StatePtr before = runFilters(level, kBefore);
    const StatePtr floors =
        applyFilter(filterDescriptor(FilterType::Radius), {0.2, 0.2, 0.01}, before, context, without).state;
    QVERIFY(floors->kernel->mesh().triangles.size() <
            runFilters(before, "RadiusFilter 0.2\n")->kernel->mesh().triangles.size());
    QVERIFY(area(navigationMesh(runFilters(floors, "VerticalClearanceFilter 2.2\n"))) >
            area(withObstacles(level, kBefore + "RadiusFilter 0.2\nVerticalClearanceFilter 2.2\n")));
  }

  // A result without obstacles is not taken for one with them.
  void cachesTellThemApart() {
    const std::string radius = kBefore + "RadiusFilter 0.3\n", more = radius + "DropFilter 1.5 0.63\n";
    const Pipeline less = parsePipeline(radius, "pipeline"), all = parsePipeline(more, "pipeline");
    const std::size_t count = less.steps.size();
    QVERIFY(prefixKey(stepsOf(less), count) != prefixKey(stepsOf(all), count));
    QCOMPARE(prefixKey(stepsOf(less), count - 1), prefixKey(stepsOf(all), count - 1));
    const EnvironmentPtr level = sample("house");
    ResultCache cache;
    for (const std::string& filters : {radius, more, radius + "AreaFilter 1\n", more})
      QVERIFY(isEqual(asRun(level, filters, &cache), withObstacles(level, filters)));
  }
};

QTEST_APPLESS_MAIN(TestRadiusObstacles)
#include "test_radius_obstacles.moc"
