// The pipeline of an agent in metres, and from a file to a file in three lines.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "footfall/footfall.hpp"
#include "footfall/inspect.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/soup.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::test;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Environment withScale(double metresPerUnit) {
  Environment level;
  level.metresPerUnit = metresPerUnit;
  return level;
}

std::string steps(double metresPerUnit, const Agent& agent) {
  const std::string text = formatPipeline(pipelineFor(withScale(metresPerUnit), agent));
  const std::size_t from = text.find("SlopeFilter"), to = text.find("SimplificationFilter");
  return text.substr(from, to - from);
}

std::string sampleFile(const std::string& name) { return FOOTFALL_SOURCE_DIR "/samples/" + name + "/" + name + ".obj"; }

/// The triangles of an export that stand for steps: two for a step, one where both borders have a vertex in common.
std::size_t facesOf(const std::vector<StepLink>& links) {
  std::size_t count = 0;
  for (const StepLink& link : links)
    count += link.from[0] == link.to[1] || link.from[1] == link.to[0] ? std::size_t{1} : std::size_t{2};
  return count;
}

/// Two floors of 4 x 4, one above the other with so much between them.
Environment twoStoreys(double height) { return *Soup().floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, height).environment(); }

}  // namespace

class TestWalkableArea : public QObject {
  Q_OBJECT
 private slots:
  void theDefaultAgentHasTheDefaultPipeline() {
    for (const double metresPerUnit : {1.0, 0.01, 0.0254, 0.3048, 1000.0, 1e-6})
      QVERIFY(pipelineFor(withScale(metresPerUnit)) == defaultPipeline(withScale(metresPerUnit)));
  }

  void metresBecomeUnits() {
    const Agent child{.maxSlope = 30, .height = 1.2, .minimumArea = 0.5, .step = 0.25};
    QCOMPARE(steps(1, child),
             std::string("SlopeFilter 30\nVerticalClearanceFilter 1.2\nStepFilter 0.25\nAreaFilter 0.5\n"));
    QCOMPARE(steps(0.01, child),
             std::string("SlopeFilter 30\nVerticalClearanceFilter 120\nStepFilter 25 5\nAreaFilter 5000\n"));
    QCOMPARE(steps(0.5, child),
             std::string("SlopeFilter 30\nVerticalClearanceFilter 2.4\nStepFilter 0.5 0.1\nAreaFilter 2\n"));
  }

  void withoutAStepThereIsNoFilterForIt() {
    for (const double metresPerUnit : {1.0, 0.3048}) {
      Pipeline expected = defaultPipeline(withScale(metresPerUnit));
      QCOMPARE(std::erase_if(expected.steps, [](const PipelineStep& s) { return s.filter->type == FilterType::Step; }),
               std::size_t{1});
      QVERIFY(pipelineFor(withScale(metresPerUnit), {.step = 0}) == expected);
    }
  }

  void theRadiusCounts() {
    QCOMPARE(steps(0.5, {.maxSlope = 30, .height = 1.2, .minimumArea = 0.5, .step = 0.25, .radius = 0.3}),
             std::string(
                 "SlopeFilter 30\nVerticalClearanceFilter 2.4\nStepFilter 0.5 0.1\nRadiusFilter 0.6\nAreaFilter 2\n"));
    const auto message = [](double radius) {
      return messageOf([&] { (void)pipelineFor(withScale(1), {.radius = radius}); });
    };
    for (const double radius : {-0.1, kNaN, kInfinity}) QVERIFY(message(radius).starts_with("agent: radius"));
    const Environment level = *Soup().floor(0, 0, 4, 4, 0).environment();
    const auto areaFor = [&](const Agent& agent) { return findComponents(walkableArea(level, agent)).totalArea(); };
    QVERIFY(areaFor({}) == 16 && areaFor({.radius = 1}) < 4 && areaFor({.radius = 1}) > 3.9999);
  }

  void theDropCounts() {
    const auto dropStep = [](double metresPerUnit, const Agent& agent) {
      return formatStep(pipelineFor(withScale(metresPerUnit), agent).steps.back());
    };
    QVERIFY(pipelineFor(withScale(1), {.drop = 0}) == defaultPipeline(withScale(1)));
    QCOMPARE(dropStep(0.5, {.drop = 3}), std::string("DropFilter 6 0.6"));
    // The reach goes over both margins, if that is farther than the default.
    QCOMPARE(dropStep(1, {.radius = 0.125, .drop = 3}), std::string("DropFilter 3"));
    QCOMPARE(dropStep(1, {.radius = 0.5, .drop = 3}), std::string("DropFilter 3 1.05"));
    for (const double drop : {-0.1, kNaN, kInfinity}) {
      const std::string message = messageOf([&] { (void)pipelineFor(withScale(1), {.drop = drop}); });
      QVERIFY2(message.starts_with("agent: drop"), message.c_str());
    }
    const Environment level = *Soup().floor(0, 0, 4, 4, 1).floor(4, 0, 8, 4, 0).environment();
    const auto dropsOf = [&](const Agent& agent) { return walkableArea(level, agent).drops.size(); };
    QCOMPARE(dropsOf({}), std::size_t{0});
    QCOMPARE(dropsOf({.drop = 0.9}), std::size_t{0});
    QVERIFY(dropsOf({.drop = 1}) > 0);
    QVERIFY(dropsOf({.radius = 0.25, .drop = 1}) > 0);
  }

  // Two halves of a floor, one 0.25 m higher: a step of exactly that is climbed.
  void theStepCounts() {
    const Environment level = *Soup().floor(0, 0, 4, 4, 0).floor(4, 0, 8, 4, 0.25).environment();
    QCOMPARE(walkableArea(level).links.size(), std::size_t{1});
    QCOMPARE(walkableArea(level, {.step = 0.25}).links.size(), std::size_t{1});
    QCOMPARE(walkableArea(level, {.step = 0.24}).links.size(), std::size_t{0});
    QCOMPARE(walkableArea(level, {.step = 0}).links.size(), std::size_t{0});
  }

  void agentsOutOfRange() {
    const auto message = [](const Agent& agent) { return messageOf([&] { (void)pipelineFor(withScale(1), agent); }); };
    for (const double slope : {0.0, 90.0, -1.0, kNaN, kInfinity})
      QVERIFY2(message({.maxSlope = slope}).starts_with("agent: max_slope"), message({.maxSlope = slope}).c_str());
    for (const double height : {0.0, -2.0, kNaN, kInfinity})
      QVERIFY(message({.height = height}).starts_with("agent: height"));
    for (const double area : {-1.0, kNaN, kInfinity})
      QVERIFY(message({.minimumArea = area}).starts_with("agent: minimum_area"));
    QCOMPARE(message({.minimumArea = 0}), std::string("no error"));
    for (const double step : {-0.1, kNaN, kInfinity}) QVERIFY(message({.step = step}).starts_with("agent: step"));
    QCOMPARE(message({.step = 0}), std::string("no error"));
    // The gap is checked although an agent that lifts no feet steps over none.
    for (const double gap : {-1.0, kNaN, kInfinity})
      for (const double step : {0.0, 0.4}) QVERIFY(message({.step = step, .gap = gap}).starts_with("agent: gap"));
    // The value is in range in metres, and above all doubles in units.
    QVERIFY(messageOf([] { (void)pipelineFor(withScale(1e-200), {.height = 1e200}); }).starts_with("agent, in the"));
  }

  void theHeightCounts() {
    const Environment level = twoStoreys(2);
    QCOMPARE(walkableArea(level).triangles.size(), std::size_t{4});
    QCOMPARE(walkableArea(level, {.height = 2.5}).triangles.size(), std::size_t{2});
    Environment inFeet = level;  // 2 ft are 0.61 m
    inFeet.metresPerUnit = 0.3048;
    QCOMPARE(walkableArea(inFeet).triangles.size(), std::size_t{2});
    QCOMPARE(walkableArea(inFeet, {.height = 0.6}).triangles.size(), std::size_t{4});
  }

  void isWhatTheRunGives() {
    const auto level = std::make_shared<const Environment>(load(sampleFile("house")));
    RunContext context;
    const NavigationMesh expected = *runPipeline(level, defaultPipeline(*level), context).mesh;
    for (const int threads : {0, 1, 3}) {
      const NavigationMesh mesh = walkableArea(*level, {}, nullptr, threads);
      QVERIFY(mesh.vertices == expected.vertices && mesh.triangles == expected.triangles);
      QVERIFY(mesh.layers == expected.layers && mesh.connections == expected.connections);
      QVERIFY(mesh.frame.up == level->up && mesh.frame.source == level->source);
    }
  }

  void threeLines() {
    const TemporaryFolder folder;
    for (const char* name : {"level.obj", "level.glb"}) {
      const Environment level = load(sampleFile("house"));
      const NavigationMesh mesh = walkableArea(level, {.maxSlope = 45, .height = 2, .step = 0.4});
      const double error = save(mesh, folder.path(name));
      ImportOptions asTheFileHasThem;  // the grid splits edges
      asTheFileHasThem.grid = GridChoice::Off;
      const Environment back = load(folder.path(name), asTheFileHasThem);
      QCOMPARE(back.triangles.size(), mesh.triangles.size() + facesOf(mesh.links));
      QCOMPARE(back.up, level.up);
      // The frame is that of the source: the box around it is that of the mesh.
      for (std::size_t v = 0; v < back.vertices.size(); ++v) {
        const Vec3& p = back.vertices[v];
        const auto near = [&](const Vec3& q) { return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z) <= 3 * error; };
        QVERIFY(std::ranges::any_of(mesh.vertices, near));
      }
    }
  }

  void cancelledOrInProgress() {
    const Environment level = twoStoreys(3);
    int begun = 0;
    RunContext context([&](const RunEvent& event) { begun += event.kind == RunEvent::Kind::StepStarted ? 1 : 0; });
    (void)walkableArea(level, {}, &context, 1);
    QCOMPARE(begun, 8);
    context.cancel();
    QVERIFY_EXCEPTION_THROWN((void)walkableArea(level, {}, &context), Cancelled);
    QVERIFY_EXCEPTION_THROWN((void)load(sampleFile("villa"), {}, &context), Cancelled);
  }

  void severalThreadsAtOnce() {
    const Environment level = twoStoreys(3);
    const NavigationMesh expected = walkableArea(level);
    std::vector<std::thread> threads;
    std::atomic<int> equal{0};
    for (int i = 0; i < 4; ++i)
      threads.emplace_back([&] { equal += walkableArea(level).vertices == expected.vertices ? 1 : 0; });
    for (std::thread& thread : threads) thread.join();
    QCOMPARE(equal.load(), 4);
  }

  void environmentsThatAreNotInOrder() {
    const Environment good = twoStoreys(3);
    const auto message = [&](const std::function<void(Environment&)>& spoil) {
      Environment level = good;
      spoil(level);
      return messageOf([&] { (void)walkableArea(level); });
    };
    const auto expect = [&](const char* words, const std::function<void(Environment&)>& spoil) {
      const std::string text = message(spoil);
      QVERIFY2(text.find(words) != std::string::npos, text.c_str());
    };
    expect("no error", [](Environment&) {});
    expect("no triangles", [](Environment& level) { level.triangles.clear(); });
    expect("triangle 1 names vertex 77", [](Environment& level) { level.triangles[1][2] = 77; });
    expect("vertex 2 ", [](Environment& level) { level.vertices[2].y = kNaN; });
    expect("vertex 0 ", [](Environment& level) { level.vertices[0].z = -kInfinity; });
    for (const double scale : {0.0, -1.0, kNaN, kInfinity})
      expect("metresPerUnit", [scale](Environment& level) { level.metresPerUnit = scale; });
    expect("the length of partOf is 1, and the number of triangles is 4",
           [](Environment& level) { level.partOf = {0}; });
    expect("partOf names part 0 of 0", [](Environment& level) { level.partOf.assign(level.triangles.size(), 0); });
    expect("the length of obstacleOnly is 9", [](Environment& level) { level.obstacleOnly.assign(9, 1); });
  }

  void versions() {
    QCOMPARE(version(), FOOTFALL_VERSION);
    QCOMPARE(QString(FOOTFALL_VERSION),
             QString("%1.%2.%3").arg(FOOTFALL_VERSION_MAJOR).arg(FOOTFALL_VERSION_MINOR).arg(FOOTFALL_VERSION_PATCH));
  }
};

QTEST_GUILESS_MAIN(TestWalkableArea)
#include "test_walkable_area.moc"
