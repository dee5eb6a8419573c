// StepFilter: against the definition on random soups, and the cases that people have in mind.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <filesystem>
#include <map>
#include <random>

#include "core/assembly/walkable_state.hpp"
#include "core/filters/apply_filter.hpp"
#include "core/mesh/surface_topology.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/io.hpp"
#include "footfall/path.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "tests/reference/steps.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::test;
using reference::BorderEdge3;
using reference::Point2;
using reference::Rational;

namespace {

std::string steps(double height, double step) {
  return minimalPipeline(height) + "\nStepFilter " + QString::number(step, 'g', 17).toStdString() + "\n";
}

NavigationMesh linked(const Soup& soup, double height, double step, const std::string& more = "") {
  return navigationMesh(runFilters(soup.environment(), steps(height, step) + more));
}

std::uint32_t components(const NavigationMesh& mesh) { return makeSurfaceTopology(mesh).componentCount; }

/// Treads of one unit, each `rise` above the one before, with risers between them.
Soup stairs(int count, double rise) {
  Soup soup;
  for (int i = 0; i < count; ++i) {
    soup.floor(i, 0, i + 1, 2, i * rise);
    if (i > 0) soup.wall(i, 0, i, 2, (i - 1) * rise, i * rise);
  }
  return soup;
}

/// Checks at several places of every pair of borders with a common stretch in the plan that they are linked exactly
/// where the definition says so. A later, larger clearance replaces the first one. Returns the number of checked pairs
/// plus one.
std::size_t checkAgainstDefinition(const Environment& environment, double height, double step, double later = 0) {
  auto shared = std::make_shared<Environment>(environment);
  const std::string more = QString("VerticalClearanceFilter %1\n").arg(later, 0, 'g', 17).toStdString();
  const StatePtr state = runFilters(shared, steps(height, step) + (later > 0 ? more : std::string()));
  height = std::max(height, later);
  const WalkableMesh& mesh = *state->mesh;
  const auto topology = topologyOf(*state);
  const TriangleCorners corners(mesh.triangles);
  std::vector<reference::Point3> places;
  for (const MeshVertex& v : mesh.vertices) {
    const auto p = state->kernel->exactPosition(v.point, v.face);
    places.push_back({p[0], p[1], p[2]});
  }
  std::vector<std::array<Index, 2>> borders;
  for (Index e = 0; e < topology->edgeCount(); ++e) {
    const auto sides = topology->sidesOf(e);
    if (sides.size() > 1 && !isObstacle(mesh.triangles, sides)) continue;
    for (const Index side : sides) borders.push_back({corners.beginOf(side), corners.endOf(side)});
  }
  std::map<std::array<std::array<Index, 2>, 2>, int> links;
  for (const MeshLink& link : mesh.links) {
    ++links[{link.from, link.to}];
    ++links[{link.to, link.from}];
  }
  const Rational exactStep(step), exactHeight(height);
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < borders.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const BorderEdge3 a{places[borders[i][0]], places[borders[i][1]]},
          b{places[borders[j][0]], places[borders[j][1]]};
      const auto stretch = reference::sharedStretch(a, b);
      if (!stretch) continue;
      ++pairs;
      const bool isLinked = links.contains({borders[i], borders[j]});
      for (const int place : {1, 37, 61, 96}) {  // percent; odd ones, as single points do not count
        const Rational s(place * 1000 + 13, 101000);
        const Point2 p{stretch->from.x + s * (stretch->to.x - stretch->from.x),
                       stretch->from.y + s * (stretch->to.y - stretch->from.y)};
        const bool expected = reference::canStepAt(environment, a, b, p, exactStep, exactHeight);
        if (expected != isLinked) {
          qWarning("%s: %s at %g %g", toText(environment).c_str(), expected ? "not linked" : "linked", p.x.get_d(),
                   p.y.get_d());
          return 0;
        }
      }
    }
  return pairs + 1;
}

}  // namespace

class TestStepFilter : public QObject {
  Q_OBJECT

 private slots:
  void stairsAreOnePart() {
    const Soup soup = stairs(9, 0.25);
    QCOMPARE(components(linked(soup, 2, 0.25)), 1U);      // exactly the maximum is climbed
    QCOMPARE(components(linked(soup, 2, 0.249999)), 9U);  // a little less is not
    const NavigationMesh mesh = linked(soup, 2, 0.25);
    QCOMPARE(mesh.links.size(), std::size_t{8});
    for (const StepLink& link : mesh.links) {
      QCOMPARE(link.height, 0.25);
      for (const int end : {0, 1}) {
        QCOMPARE(mesh.vertices[link.from[end]].x, mesh.vertices[link.to[1 - end]].x);
        QCOMPARE(mesh.vertices[link.from[end]].y, mesh.vertices[link.to[1 - end]].y);
      }
    }
    QCOMPARE(findMeshError(mesh), std::string());
  }

  // A ramp that leaves a floor at exactly the step is linked at a point, which does not count. The step of a grid that
  // the limit includes makes no interval of it. Borders that are one step apart along all of their length, but for
  // rounding, are linked as before.
  void gridLinksNoRampThatBeginsAtTheLimit() {
    const auto linksOn = [](const Soup& soup, double grid, double gap) {
      const auto environment = std::make_shared<Environment>(*soup.environment());
      environment->grid.step = grid;
      return navigationMesh(runFilters(environment, minimalPipeline(2) + "\nStepFilter 0.5 " + std::to_string(gap)))
          .links.size();
    };
    constexpr double kGrid = 0x1p-12;
    for (const double apart : {0.0, 0.0625}) {
      const double gap = apart > 0 ? 0.125 : 0;
      Soup begins, parallel, crosses;
      begins.floor(0, -2 - apart, 4, -apart, 0).ramp(0, 0, 4, 2, 0.5, 2.5);
      QCOMPARE(linksOn(begins, 0, gap), std::size_t{0});
      QCOMPARE(linksOn(begins, kGrid, gap), std::size_t{0});
      // A rise that is lower than the limit for a while is linked so far.
      crosses.floor(0, -2 - apart, 4, -apart, 0).ramp(0, 0, 4, 2, 0.25, 2.25);
      QVERIFY(linksOn(crosses, kGrid, gap) >= 1);
      parallel.ramp(0, -2 - apart, 4, -apart, 0, 2).ramp(0, 0, 4, 2, 0.5, 2.5 + 3 * kGrid);
      QVERIFY(linksOn(parallel, kGrid, gap) >= 1);
    }
  }

  void areaFilterKeepsStairs() {
    const Soup soup = stairs(9, 0.25);
    QCOMPARE(area(linked(soup, 2, 0.25, "AreaFilter 4\n")), 18.0);  // treads have 2 each
    QCOMPARE(area(linked(soup, 2, 0.2, "AreaFilter 4\n")), 0.0);
  }

  void lowWallsAreSteppedOver() {
    const auto wall = [](double height) { return Soup().floor(0, 0, 4, 4, 0).wall(2, -1, 2, 5, 0, height); };
    QCOMPARE(components(linked(wall(0.4), 2, 0.4)), 1U);
    QCOMPARE(components(linked(wall(0.41), 2, 0.4)), 2U);
    QCOMPARE(components(linked(wall(1e-300), 2, 0.4)), 1U);
  }

  void whatHangsOverAStepBlocksIt() {
    const auto lintel = [](double z) { return stairs(2, 0.25).wall(1, -1, 1, 3, z, 3); };
    QCOMPARE(components(linked(lintel(2.25), 2, 0.25)), 1U);  // the clearance above the higher tread
    QCOMPARE(components(linked(lintel(2.24), 2, 0.25)), 2U);
    QCOMPARE(components(linked(lintel(0.25), 2, 0.25)), 2U);
  }

  void onlyTheFreePartIsLinked() {
    // A wall over the middle of the edge that grows from nothing to 1: passable up to 0.4 of its length.
    Soup soup = stairs(2, 0).triangle({1, 0, 0}, {1, 2, 0}, {1, 2, 1});
    const NavigationMesh mesh = linked(soup, 2, 0.5);
    double length = 0;
    for (const StepLink& link : mesh.links)
      length += std::fabs(mesh.vertices[link.from[0]].y - mesh.vertices[link.from[1]].y);
    QCOMPARE(length, 1.0);
  }

  void pathsClimbStairs() {
    const auto mesh =
        std::make_shared<const NavigationMesh>(linked(stairs(9, 0.25), 2, 0.25, "SimplificationFilter\n"));
    const PathResult path = PathFinder(mesh).find({0.5, 0.5, 0}, {8.5, 1.5, 2});
    QVERIFY(path.reached());
    QCOMPARE(path.steps.size(), std::size_t{8});
    QCOMPARE(path.climb, 2.0);
    QCOMPARE(path.descent, 0.0);
    QCOMPARE(path.planLength, std::hypot(8.0, 1.0));
    const PathResult back = PathFinder(mesh).find({8.5, 1.5, 2}, {0.5, 0.5, 0});
    QVERIFY(back.reached());
    QCOMPARE(back.descent, 2.0);
  }

  void exportsAreReadBack() {
    const QTemporaryDir folder;
    const NavigationMesh mesh = linked(stairs(5, 0.25), 2, 0.25, "LayerSubdivisionFilter\n");
    const std::string path = folder.filePath("a.obj").toStdString();
    save(mesh, path);
    const NavigationMesh read = readNavigationMesh(path).mesh;
    QCOMPARE(read.triangles, mesh.triangles);
    QCOMPARE(read.layers, mesh.layers);
    QCOMPARE(read.links.size(), mesh.links.size());
    for (std::size_t i = 0; i < read.links.size(); ++i) {
      QCOMPARE(read.links[i].from, mesh.links[i].from);
      QCOMPARE(read.links[i].to, mesh.links[i].to);
      QCOMPARE(read.links[i].fromTriangle, mesh.links[i].fromTriangle);
      QCOMPARE(read.links[i].height, mesh.links[i].height);
    }
    ExportOptions without;
    without.steps = false;
    save(mesh, path, without);
    QVERIFY(readNavigationMesh(path).mesh.links.empty());
  }

  void aLinkThatEndsInOneVertexIsATriangle() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.obj").toStdString();
    // The lower floor lies beside a ramp: its border leaves the ramp's where they are equally high.
    const Soup soup = Soup().floor(0, 0, 4, 2, 0).quad({0, 2, 0}, {4, 2, 0.25}, {4, 4, 0.25}, {0, 4, 0});
    const NavigationMesh mesh = linked(soup, 2, 0.5);
    QCOMPARE(mesh.links.size(), std::size_t{1});
    const StepLink& link = mesh.links[0];
    QVERIFY(link.from[0] == link.to[1] || link.from[1] == link.to[0]);
    save(mesh, path);
    QFile file(QString::fromStdString(path));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(file.readAll());
    const QStringList face = text.section("g steps\n", 1).section('\n', 0, 0).split(' ');
    QCOMPARE(face.size(), 4);  // "f" and three corners
    const NavigationMesh read = readNavigationMesh(path).mesh;
    QCOMPARE(read.links.size(), std::size_t{1});
    QCOMPARE(read.links[0].from, link.from);
    QCOMPARE(read.links[0].to, link.to);
    QCOMPARE(read.links[0].height, 0.25);
  }

  void pipelinesThatCannotBe_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("expected");
    QTest::newRow("no clearance") << "SlopeFilter 45\nStepFilter 0.4\n"
                                  << "p:2:1: StepFilter needs VerticalClearanceFilter before it";
    QTest::newRow("zero") << "VerticalClearanceFilter 2\nStepFilter 0\n"
                          << "p:2:12: ";
    QTest::newRow("negative") << "VerticalClearanceFilter 2\nStepFilter -1\n"
                              << "p:2:12: ";
    QTest::newRow("nan") << "VerticalClearanceFilter 2\nStepFilter nan\n"
                         << "p:2:12: ";
  }
  void pipelinesThatCannotBe() {
    QFETCH(QString, text);
    QFETCH(QString, expected);
    try {
      parsePipeline(text.toStdString(), "p");
      QFAIL("it was accepted");
    } catch (const InputError& error) {
      QVERIFY2(QString(error.what()).startsWith(expected), error.what());
    }
  }

  void agreesWithTheDefinition() {
    std::size_t pairs = 0;
    const int count = rounds(400);
    for (int i = 0; i < count; ++i) {
      const fuzz::PipelineCase one = fuzz::makePipelineCase(seed() + static_cast<std::uint64_t>(i));
      if (one.soup.size() > 40) continue;
      const double step = one.clearance * (i % 3 == 0 ? 0.25 : i % 3 == 1 ? 0.5 : 1);
      try {
        const std::size_t looked = checkAgainstDefinition(*one.soup.environment(one.bothSides), one.clearance, step);
        QVERIFY2(looked > 0, qPrintable(QString("case %1 (%2), clearance %3, step %4")
                                            .arg(i)
                                            .arg(QString::fromStdString(one.kind))
                                            .arg(one.clearance)
                                            .arg(step)));
        pairs += looked - 1;
      } catch (const InputError&) {  // too small a height beside the coordinates
      }
    }
    qInfo("%zu pairs of borders", pairs);
    QVERIFY(pairs > static_cast<std::size_t>(count) / 2);
  }

  void aLaterClearanceAgreesWithTheDefinition() {
    std::size_t pairs = 0;
    const int count = rounds(60);
    for (int i = 0; i < count; ++i) {
      const fuzz::PipelineCase one = fuzz::makePipelineCase(seed() + 12000 + static_cast<std::uint64_t>(i));
      if (one.soup.size() > 24) continue;
      const double step = one.clearance * (i % 3 == 0 ? 0.25 : i % 3 == 1 ? 0.5 : 1);
      const double later = one.clearance * (i % 2 == 0 ? 1.5 : 0.75);
      try {
        const std::size_t looked =
            checkAgainstDefinition(*one.soup.environment(one.bothSides), one.clearance, step, later);
        QVERIFY2(looked > 0, qPrintable(QString("case %1 (%2), clearance %3 and %4, step %5")
                                            .arg(i)
                                            .arg(QString::fromStdString(one.kind))
                                            .arg(one.clearance)
                                            .arg(later)
                                            .arg(step)));
        pairs += looked - 1;
      } catch (const InputError&) {  // too small a height beside the coordinates
      }
    }
    qInfo("%zu pairs of borders", pairs);
    QVERIFY(pairs > 100);
  }

  void stairsOfAllKindsAgree() {
    const double e = 0x1p-52;
    const std::vector<Soup> soups = {
        stairs(5, 0.25),
        Soup(stairs(3, 0.25)).add(stairs(3, 0.5).mapped([](const Vec3& p) {
          return Vec3{p.y, -p.x, p.z};
        })),
        stairs(4, 0.25).mapped([](const Vec3& p) {
          return Vec3{p.x - p.y, p.x + p.y, p.z + p.x / 8};
        }),                                                                         // slanted
        Soup().floor(0, 0, 2, 2, 0).ramp(2, 0, 4, 2, 0, 1).floor(2, 2, 4, 4, 0.5),  // beside a ramp
        Soup().floor(0, 0, 4, 2, 0).floor(0, 2, 4, 4, e),                           // noise
        stairs(3, 0.25).ceiling(0, 0, 3, 2, 2.25),
        stairs(3, 0.25).box({0.9, 0.5, 0.3}, {1.1, 1.0, 0.6}),              // a bar across a step
        stairs(2, 0.25).triangle({1, 0, 0.25}, {1, 1, 0.25}, {1, 0.5, 3}),  // a pointed railing on its edge
        Soup().floor(0, 0, 2, 2, 0).floor(2, 0, 3, 1, 0.25).floor(2, 1, 3, 2, -0.25),
    };
    for (std::size_t i = 0; i < soups.size(); ++i)
      for (const double step : {0.125, 0.25, 0.5, 3.0})
        QVERIFY2(checkAgainstDefinition(*soups[i].environment(), 2, step) > 0,
                 qPrintable(QString("soup %1, step %2").arg(i).arg(step)));
  }

  void liveEditsGiveTheSame() {
    Soup level = stairs(6, 0.25).add(stairs(6, 0.25).mapped([](const Vec3& p) { return Vec3{p.x, p.y + 2, p.z}; }));
    level.floor(6, 0, 12, 4, 1.25).floor(-6, 0, 0, 4, 0);
    const std::string pipeline = steps(2, 0.3) + "AreaFilter 1\nSimplificationFilter\nLayerSubdivisionFilter\n";
    ResultCache cache;
    EditableEnvironment edited(level.environment());
    QVERIFY(agrees(edited.environment(), pipeline, cache));
    const auto crate = [](double x, double y, double z) {
      return soupFor(Soup().box({x, y, z}, {x + 0.75, y + 0.75, z + 0.25}));
    };
    const ObstacleId id = edited.add(crate(1.5, 1, 0.25));
    QVERIFY(agrees(edited.environment(), pipeline, cache));
    for (int i = 0; i < 12; ++i) {
      edited.replace(id, crate(0.375 * i, 0.5 + 0.25 * (i % 5), 0.25 * (i / 3)));
      QVERIFY2(agrees(edited.environment(), pipeline, cache), qPrintable(QString::number(i)));
    }
    for (const double step : {0.3, 0.2, 0.25})  // other parameters on the same level
      QVERIFY(agrees(edited.environment(), steps(2, step) + "AreaFilter 1\nSimplificationFilter\n", cache));
    edited.remove(id);
    QVERIFY(agrees(edited.environment(), pipeline, cache));
  }

  void moreStepNeverPartsAndOrderChangesNothing() {
    std::mt19937 random(5);
    for (int i = 0; i < rounds(60); ++i) {
      const fuzz::PipelineCase one = fuzz::makePipelineCase(seed() + 5000 + static_cast<std::uint64_t>(i));
      if (one.clearance < 1e-6) continue;
      const auto environment = one.soup.environment(one.bothSides);
      std::uint32_t before = 0xFFFFFFFF;
      double height = 0;
      for (const double step : {0.2, 0.6, 1.3}) {
        const std::string text = steps(one.clearance, step * one.clearance) + "SimplificationFilter\n";
        const NavigationMesh mesh = navigationMesh(runFilters(environment, text));
        QCOMPARE(findMeshError(mesh), std::string());
        const std::uint32_t count = components(mesh);
        QVERIFY(count <= before);
        before = count;
        height = step * one.clearance;
        std::vector<std::uint32_t> order(environment->triangles.size());
        for (std::uint32_t t = 0; t < order.size(); ++t) order[t] = t;
        std::shuffle(order.begin(), order.end(), random);
        NavigationMesh other;
        runWithThreads(1 + i % 3, [&] { other = navigationMesh(runFilters(shuffled(*environment, order, 1), text)); });
        QCOMPARE(other.vertices.size(), mesh.vertices.size());
        QVERIFY(other.triangles == mesh.triangles && other.vertices == mesh.vertices);
        QVERIFY(std::equal(other.links.begin(), other.links.end(), mesh.links.begin(), mesh.links.end(),
                           [](const StepLink& a, const StepLink& b) { return a.from == b.from && a.to == b.to; }));
      }
      QVERIFY(height > 0);
    }
  }

  // Overlapping walls in one line end at thousands of places and stand hundreds deep. Each stretch is known to be
  // blocked by the first wall that blocks it; where agents step over all of them, each end is a vertex of both floors.
  void wallsInOneLine_data() {
    QTest::addColumn<double>("least");
    QTest::addColumn<double>("most");
    QTest::newRow("too high") << 0.45 << 0.9;
    QTest::newRow("low") << 0.05 << 0.2;
  }
  void wallsInOneLine() {
    QFETCH(double, least);
    QFETCH(double, most);
    const bool isHigh = least > 0.4;
    std::vector<std::size_t> tests;
    for (const int count : {100, 400}) {
      std::mt19937 random(1);
      const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() % 99991) / 99991;
      };
      Soup soup;
      soup.floor(0, -5, 100, 0, 0).floor(0, 0, 100, 5, 0.2);
      for (int i = 0; i < count; ++i) {
        const double x = number(0, 50);
        soup.wall(x, 0, x + 50, 0, 0, number(least, most));
      }
      const Soup turned = soup.mapped([](const Vec3& p) { return Vec3{p.x - p.y, p.x + p.y, p.z}; });
      const StatePtr state = runFilters(turned.environment(), minimalPipeline(2));
      RunContext context;
      const FilterOutcome outcome = applyFilter(filterDescriptor(FilterType::Step), {0.4, 0}, state, context);
      const auto links = static_cast<int>(outcome.state->mesh->links.size());
      QVERIFY2(isHigh ? links < 4 : links >= 2 * count, qPrintable(QString::number(links)));
      tests.push_back(outcome.fallbacks.total());
    }
    // Doubles cannot decide whether a wall stands in the line.
    QVERIFY2(tests[1] < 6 * tests[0], qPrintable(QString("%1, then %2").arg(tests[0]).arg(tests[1])));
  }
};

QTEST_GUILESS_MAIN(TestStepFilter)
#include "test_step_filter.moc"
