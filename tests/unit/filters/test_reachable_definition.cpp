// ReachableFilter: against the definition on random soups, and what must not matter.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "footfall/errors.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/filters/reached_areas.hpp"

using namespace footfall;
using namespace footfall::test;
using reference::FloorPiece;
using reference::Point2;
using reference::Point3;
using reference::Rational;

class TestReachableDefinition : public QObject {
  Q_OBJECT

 private slots:
  void numbersOfAllSizes() {
    const double huge = 1e300, tiny = 1e-300;
    const Soup soup = Soup().floor(0, 0, 4, 4, 0).floor(4, 0, 8, 4, 0).wall(4, 0, 4, 4, 0, 3);
    const auto meant = [&](Vec3 seed) { return areaOf(soup, "VerticalClearanceFilter 2\n" + seedsText({seed})); };
    QCOMPARE(meant({tiny, tiny, tiny}), 16.0);
    QCOMPARE(meant({std::nextafter(4.0, 0.0), 1, 0}), 16.0);
    QCOMPARE(meant({4, tiny, 0}), 32.0);
    QVERIFY(!errorOf(soup, "VerticalClearanceFilter 2\n" + seedsText({{-tiny, 1, 0}})).empty());
    QVERIFY(!errorOf(soup, "VerticalClearanceFilter 2\n" + seedsText({{1, -5e-324, 0}})).empty());
    QVERIFY(!errorOf(soup, "VerticalClearanceFilter 2\n" + seedsText({{huge, 1, 0}})).empty());
    QVERIFY(!errorOf(soup, "VerticalClearanceFilter 2\n" + seedsText({{1, 1, huge}})).empty());
    QVERIFY(!errorOf(soup, "VerticalClearanceFilter 2\n" + seedsText({{1, 1, -tiny}})).empty());
    // Coordinates so large that a seed's become too small beside them.
    const Soup large = soup.mapped([](const Vec3& p) { return Vec3{p.x * 1e100, p.y * 1e100, p.z * 1e100}; });
    QVERIFY(areaOf(large, "ReachableFilter 1e-300 1e-300 0\n") > 1e201);
    QVERIFY(!errorOf(large, "ReachableFilter -1e-300 1 0\n").empty());
  }

  void agreesWithTheDefinitionOfTheArea() {
    int kept = 0, refused = 0, parted = 0;
    for (int i = 0; i < rounds(250); ++i) {
      const fuzz::PipelineCase one = fuzz::makePipelineCase(seed() + 900 + static_cast<std::uint64_t>(i));
      if (one.soup.size() > 24) continue;
      const auto environment = one.soup.environment(one.bothSides);
      std::mt19937_64 random(seed() + static_cast<std::uint64_t>(i));
      const reference::WalkableArea expected = reference::computeWalkableArea(*environment, {one.slope, one.clearance});
      const std::vector<FloorPiece> pieces = reference::piecesOf(expected);
      const std::vector<std::size_t> parts = reference::connectedParts(expected, reference::findMeetings(expected));
      for (int repeat = 0; repeat < 4; ++repeat) {
        std::vector<Vec3> seeds;
        std::vector<Point3> exact;
        for (int s = 0; s <= repeat / 2; ++s) {
          seeds.push_back(seedFor(*environment, one.clearance > 1e20 ? 1 : one.clearance, random));
          exact.push_back(reference::toPoint(seeds.back()));
        }
        const auto reached = reference::partsReached(pieces, parts, exact, Rational(one.clearance));
        std::optional<Rational> found;
        const StatePtr before = [&]() -> StatePtr {
          try {
            return runFilters(environment, minimalPipeline(one.clearance, one.slope));
          } catch (const InputError&) {
            return nullptr;  // too small a height beside the coordinates
          }
        }();
        if (!before) break;
        try {
          found = twicePlanArea(*runFilters(before, seedsText(seeds)));
        } catch (const InputError&) {
        }
        const QString where = QString("case %1.%2 (%3): %4%5")
                                  .arg(i)
                                  .arg(repeat)
                                  .arg(QString::fromStdString(one.kind))
                                  .arg(QString::fromStdString(minimalPipeline(one.clearance, one.slope)))
                                  .arg(QString::fromStdString(seedsText(seeds)));
        QVERIFY2(found.has_value() == reached.has_value(), qPrintable(where));
        (found ? kept : refused)++;
        if (!found) continue;
        Rational sum;
        for (std::size_t p = 0; p < pieces.size(); ++p)
          if (std::ranges::binary_search(*reached, parts[p])) sum += reference::twiceArea(pieces[p].outline);
        parted += static_cast<int>(sum != reference::twiceArea(expected));
        QVERIFY2(*found == sum, qPrintable(where));
      }
    }
    qInfo("%d kept, %d of them a part; %d refused", kept, parted, refused);
    QVERIFY(kept > 100 && parted > 40 && refused > 40);
  }

  void agreesWithTheDefinitionOverSteps() {
    int kept = 0, linked = 0;
    for (int i = 0; i < rounds(250); ++i) {
      const fuzz::PipelineCase one = fuzz::makePipelineCase(seed() + 40000 + static_cast<std::uint64_t>(i));
      if (one.soup.size() > 30 || one.clearance > 1e20) continue;
      const auto environment = one.soup.environment(one.bothSides);
      std::mt19937_64 random(seed() + static_cast<std::uint64_t>(i));
      std::string filters = minimalPipeline(one.clearance, one.slope) + "StepFilter ";
      appendNumber(filters, one.clearance * 0.75);
      filters += i % 2 == 0 ? "\nSimplificationFilter\n" : "\n";
      StatePtr before;
      try {
        before = runFilters(environment, filters);
      } catch (const InputError&) {
        continue;
      }
      const Walked walked = walkedOf(*before);
      const std::vector<std::size_t> parts = reference::partsOf(walked.pieces.size(), walked.crossings);
      linked += static_cast<int>(!before->mesh->links.empty());
      for (int repeat = 0; repeat < 3; ++repeat) {
        std::vector<Vec3> seeds;
        std::vector<Point3> exact;
        for (int s = 0; s <= repeat / 2; ++s) {
          seeds.push_back(seedFor(*environment, one.clearance, random));
          exact.push_back(reference::toPoint(seeds.back()));
        }
        const auto reached = reference::partsReached(walked.pieces, parts, exact, Rational(one.clearance));
        StatePtr after;
        try {
          after = runFilters(before, seedsText(seeds));
        } catch (const InputError&) {
        }
        const QString where = QString("case %1.%2: %3%4%5")
                                  .arg(i)
                                  .arg(repeat)
                                  .arg(QString::fromStdString(toText(*environment)))
                                  .arg(QString::fromStdString(filters))
                                  .arg(QString::fromStdString(seedsText(seeds)));
        QVERIFY2((after != nullptr) == reached.has_value(), qPrintable(where));
        if (!after) continue;
        ++kept;
        std::vector<MeshTriangle> expected;
        for (std::size_t t = 0; t < parts.size(); ++t)
          if (std::ranges::binary_search(*reached, parts[t])) expected.push_back(before->mesh->triangles[t]);
        QVERIFY2(std::ranges::equal(after->mesh->triangles, expected,
                                    [](const MeshTriangle& a, const MeshTriangle& b) {
                                      return a.corners == b.corners && a.face == b.face &&
                                             a.obstacleEdges == b.obstacleEdges;
                                    }),
                 qPrintable(where));
        // A link is left exactly where its sides are, and both are or none.
        std::set<std::array<Index, 2>> sides;
        for (const MeshTriangle& t : expected)
          for (int k = 0; k < 3; ++k) sides.insert({t.corners[k], t.corners[next(k)]});
        std::vector<MeshLink> links;
        for (const MeshLink& link : before->mesh->links) {
          QCOMPARE(sides.contains(link.from), sides.contains(link.to));
          if (sides.contains(link.from)) links.push_back(link);
        }
        QVERIFY2(after->mesh->links == links, qPrintable(where));
      }
    }
    qInfo("%d kept, %d cases with links", kept, linked);
    QVERIFY(kept > 100 && linked > 20);
  }

  void moreSeedsNeverRemoveAndOrderChangesNothing() {
    std::mt19937_64 random(seed());
    int grown = 0;
    for (int i = 0; i < rounds(90); ++i) {
      const fuzz::PipelineCase one = fuzz::makePipelineCase(seed() + 7000 + static_cast<std::uint64_t>(i));
      if (one.clearance < 1e-6 || one.clearance > 1e20) continue;
      const auto environment = one.soup.environment(one.bothSides);
      std::string filters = minimalPipeline(one.clearance, one.slope);
      if (i % 2 == 0) {
        filters += "StepFilter ";
        appendNumber(filters, one.clearance);
        filters += '\n';
      }
      std::vector<Vec3> seeds;
      Rational before;
      for (int tries = 0; tries < 6; ++tries) {
        seeds.push_back(seedFor(*environment, one.clearance, random));
        StatePtr state;
        try {
          state = runFilters(environment, filters + seedsText(seeds));
        } catch (const InputError&) {
          seeds.pop_back();
          continue;
        }
        const Rational area = twicePlanArea(*state);
        QVERIFY(area >= before);
        grown += static_cast<int>(seeds.size() > 1 && area > before);
        before = area;
        // Again behind itself, with the seeds in another order, and for a shuffled soup on other threads.
        const std::string text = filters + seedsText(seeds) + "SimplificationFilter\nLayerSubdivisionFilter\n";
        const NavigationMesh mesh = navigationMesh(runFilters(environment, text));
        std::vector<Vec3> others(seeds.rbegin(), seeds.rend());
        others.push_back(seeds.front());
        const std::string same =
            filters + seedsText(others) + seedsText(seeds) + "SimplificationFilter\nLayerSubdivisionFilter\n";
        std::vector<std::uint32_t> order(environment->triangles.size());
        for (std::uint32_t t = 0; t < order.size(); ++t) order[t] = t;
        std::shuffle(order.begin(), order.end(), random);
        NavigationMesh other;
        runWithThreads(1 + i % 3, [&] { other = navigationMesh(runFilters(shuffled(*environment, order, 1), same)); });
        QVERIFY(other.triangles == mesh.triangles && other.vertices == mesh.vertices && other.layers == mesh.layers);
        QVERIFY(std::equal(other.links.begin(), other.links.end(), mesh.links.begin(), mesh.links.end(),
                           [](const StepLink& a, const StepLink& b) { return a.from == b.from && a.to == b.to; }));
      }
    }
    qInfo("%d grew", grown);
    QVERIFY(grown > 10);
  }

  void blocksAndEditsGiveTheSame() {
    Soup level = Soup().floor(0, 0, 12, 6, 0).floor(12, 0, 14, 6, 0.25).floor(20, 0, 24, 6, 0).floor(0, 0, 6, 6, 4);
    level.wall(6, 0, 6, 5, 0, 3);
    const auto pipelineOf = [](const std::string& block, const std::string& end, const std::string& seeds) {
      return block + "SlopeFilter 45\nVerticalClearanceFilter 2\n" + end + "StepFilter 0.3\n" + seeds +
             "AreaFilter 0.1\nSimplificationFilter\nLayerSubdivisionFilter\n";
    };
    const std::string one = seedsText({{1, 1, 0}}), two = seedsText({{1, 1, 0}, {21, 1, 1}});
    const std::string pipeline = pipelineOf("", "", one);
    ResultCache cache;
    EditableEnvironment edited(level.environment());
    QVERIFY(agrees(edited.environment(), pipeline, cache));
    const auto crate = [](double x, double y, double z) {
      return soupFor(Soup().box({x, y, z}, {x + 2, y + 2, z + 1}));
    };
    const ObstacleId id = edited.add(crate(2, 2, 0));
    for (int i = 0; i < 12; ++i) {
      // The crate is in the gap of the wall, where it divides the rooms, and off it.
      edited.replace(id, crate(i % 4 == 1 ? 5 : 1.5 + 0.375 * i, i % 4 == 1 ? 4.5 : 2 + 0.25 * (i % 3), 0));
      const auto environment = edited.environment();
      QVERIFY2(agrees(environment, pipeline, cache), qPrintable(QString::number(i)));
      QVERIFY2(agrees(environment, pipelineOf("", "", i % 2 == 0 ? two : one), cache), qPrintable(QString::number(i)));
      const std::string bytes = exported(run(environment, pipeline, nullptr, 1));
      for (const char* strategy :
           {"GridStrategy 3 2", "RecursiveStrategy 4 3", "HeightAwareStrategy 4 3", "AutoStrategy"}) {
        const RunResult parallel =
            run(environment, pipelineOf(std::string(strategy) + "\n", "Collapse\n", one), nullptr, 3);
        QCOMPARE(exported(parallel), bytes);
      }
    }
    edited.remove(id);
    QVERIFY(agrees(edited.environment(), pipeline, cache));
  }

  void theLastGoodResultStays() {
    // The cache has the steps before a seed that is wrong, and nothing of it.
    const auto environment = Soup().floor(0, 0, 4, 4, 0).floor(5, 0, 6, 4, 0).environment();
    ResultCache cache;
    const std::string clearance = "VerticalClearanceFilter 2\n";
    const RunResult good = run(environment, clearance + "ReachableFilter 1 1 0\n", &cache);
    QVERIFY_EXCEPTION_THROWN(run(environment, clearance + "ReachableFilter 1 1 0 9 9 9\n", &cache), InputError);
    const RunResult again = run(environment, clearance + "ReachableFilter 1 1 0\n", &cache);
    QCOMPARE(exported(again), exported(good));
    QVERIFY(again.steps.back().fromCache);
    QVERIFY(agrees(environment, clearance + "ReachableFilter 5.5 1 0\n", cache));
  }
};

QTEST_GUILESS_MAIN(TestReachableDefinition)
#include "test_reachable_definition.moc"
