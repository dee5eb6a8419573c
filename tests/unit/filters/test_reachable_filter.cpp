// ReachableFilter: places where regions meet, reports, and wrong input.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>

#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/inspect.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/report.hpp"
#include "footfall/run.hpp"
#include "footfall/up_axis.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/unit/filters/reached_areas.hpp"

using namespace footfall;
using namespace footfall::test;
using reference::FloorPiece;
using reference::Point2;
using reference::Point3;
using reference::Rational;

class TestReachableFilter : public QObject {
  Q_OBJECT

 private slots:
  void roofsAndIslandsGo() {
    const Soup soup = Soup().floor(0, 0, 4, 4, 0).floor(6, 0, 8, 4, 0).floor(0, 0, 4, 4, 3);
    const std::string clearance = minimalPipeline(2);
    QCOMPARE(areaOf(soup, clearance), 40.0);
    QCOMPARE(areaOf(soup, clearance + "ReachableFilter 1 1 0.5\n"), 16.0);
    QCOMPARE(areaOf(soup, clearance + "ReachableFilter 7 1 0\n"), 8.0);
    QCOMPARE(areaOf(soup, clearance + "ReachableFilter 1 1 3 7 1 0.25\n"), 24.0);
    QCOMPARE(areaOf(soup, clearance + "ReachableFilter 1 1 2\n"), 16.0);
  }

  void stepsAreWalked() {
    const Soup soup = Soup().floor(0, 0, 2, 2, 0).floor(2, 0, 4, 2, 0.25).floor(4, 0, 6, 2, 1);
    const std::string clearance = minimalPipeline(2), seed = "ReachableFilter 1 1 0\n";
    QCOMPARE(areaOf(soup, clearance + seed), 4.0);
    QCOMPARE(areaOf(soup, clearance + "StepFilter 0.3\n" + seed), 8.0);
    QCOMPARE(areaOf(soup, clearance + seed + "StepFilter 0.3\n"), 4.0);  // The seeds come before links exist.
    QCOMPARE(areaOf(soup, clearance + "StepFilter 1\n" + seed), 12.0);
    const NavigationMesh mesh = navigationMesh(runFilters(soup.environment(), clearance + "StepFilter 0.3\n" + seed));
    QCOMPARE(mesh.links.size(), std::size_t{1});  // the one that is left with both of its sides
    for (const char* behind : {"AreaFilter 5\n", "SimplificationFilter\n", "LayerSubdivisionFilter\n",
                               "SlopeFilter 45\n", "SimplificationFilter\nReachableFilter 3 1 1\nAreaFilter 1\n"})
      QCOMPARE(areaOf(soup, clearance + "StepFilter 0.3\n" + seed + behind), 8.0);
  }

  void linkedFloorsStayFloorsBehindASimplification() {
    // Rounded floors have no cuts, and simplified triangles span several of them.
    const Soup soup = Soup().floor(0, 0, 2, 2, 0).floor(2, 0, 4, 2, 0.25).floor(6, 0, 8, 2, 0).ceiling(7, -1, 9, 3, 1);
    for (const char* filter : {"ReachableFilter 1 1 0\n", "AreaFilter 5\n"}) {
      const std::string before = "VerticalClearanceFilter 2\nRoundingFilter\nStepFilter 0.3\n";
      const RunResult plain = run(soup.environment(), before + filter, nullptr);
      const RunResult simplified = run(soup.environment(), before + "SimplificationFilter\n" + filter, nullptr);
      for (const RunResult& result : {plain, simplified}) {
        QCOMPARE(result.summary.area, 8.0);
        QCOMPARE(result.summary.links, std::uint64_t{1});
      }
      QVERIFY(plain.summary.rejected > 2);
      QCOMPARE(simplified.summary.rejected, plain.summary.rejected);
    }
  }

  void wherePlacesMeetAllCount() {
    // Two squares with a wall between them, and a third that only touches the second's corner.
    const Soup soup = Soup().floor(0, 0, 2, 2, 0).floor(2, 0, 4, 2, 0).wall(2, 0, 2, 2, 0, 3).floor(4, 2, 6, 4, 0);
    const auto areaAt = [&](const char* seed) {
      return areaOf(soup, minimalPipeline(2) + "ReachableFilter " + seed + "\n");
    };
    QCOMPARE(areaAt("1 1 0"), 4.0);
    QCOMPARE(areaAt("2 1 0"), 8.0);    // The seed is on the obstacle edge: both sides count.
    QCOMPARE(areaAt("2 2 0"), 8.0);    // its end
    QCOMPARE(areaAt("4 2 0.5"), 8.0);  // a corner of both
    QCOMPARE(areaAt("0 0 1"), 4.0);    // a corner of one
    QCOMPARE(areaAt("1.9999999999999998 1 0"), 4.0);
    QCOMPARE(areaAt("2.0000000000000004 1 0"), 4.0);
  }

  void theHighestPlaceCounts() {
    const Soup soup = Soup().floor(0, 0, 4, 4, 0).floor(2, 0, 5, 4, 3).ramp(8, 0, 10, 1, 0, 1);
    const auto areaAt = [&](const char* seed) {
      return areaOf(soup, minimalPipeline(2) + "ReachableFilter " + seed + "\n");
    };
    QCOMPARE(areaAt("3 1 3"), 12.0);
    QCOMPARE(areaAt("3 1 5"), 12.0);  // exactly the clearance above it
    QCOMPARE(areaAt("2 1 3"), 12.0);  // The seed is on the upper one's edge: the lower one is not meant.
    QCOMPARE(areaAt("3 1 2"), 16.0);  // The seed is under the upper one.
    QCOMPARE(areaAt("1.9999999999999998 1 2"), 16.0);
    QCOMPARE(areaAt("9 0.25 0.5"), std::hypot(2, 1));  // exactly on a slanted floor
    QVERIFY(errorOf(soup, minimalPipeline(2) + "ReachableFilter 9 0.25 0.49999999999999994\n")
                .find("no walkable place under it") != std::string::npos);
    QVERIFY(errorOf(soup, minimalPipeline(2) + "ReachableFilter 3 1 2.9999999999999996\n")
                .find("more than the clearance of 2") != std::string::npos);
  }

  void theLargestClearanceCounts() {
    const Soup soup = Soup().floor(0, 0, 4, 4, 0);
    const std::string seed = "ReachableFilter 1 1 50\n";
    QCOMPARE(areaOf(soup, seed), 16.0);  // The distance has no limit without a clearance.
    QCOMPARE(areaOf(soup, "VerticalClearanceFilter 50\n" + seed), 16.0);
    QCOMPARE(areaOf(soup, "VerticalClearanceFilter 50\nVerticalClearanceFilter 2\n" + seed), 16.0);
    QCOMPARE(areaOf(soup, "VerticalClearanceFilter 2\nVerticalClearanceFilter 50\n" + seed), 16.0);
    QCOMPARE(areaOf(soup, "VerticalClearanceFilter 50\nRoundingFilter\n" + seed), 16.0);
    QCOMPARE(areaOf(soup, "GridStrategy 2 2\nVerticalClearanceFilter 50\nCollapse\n" + seed), 16.0);
    // The level is flat: any clearance gives the same area, and yet it counts as it was given.
    QVERIFY(!errorOf(soup, "VerticalClearanceFilter 49\n" + seed).empty());
    QVERIFY(!errorOf(soup, "VerticalClearanceFilter 49.99999999999999\n" + seed).empty());
  }

  void itStandsAnywhere_data() {
    QTest::addColumn<QString>("filters");
    for (const char* filters :
         {"R", "R\nVerticalClearanceFilter 2", "SimplificationFilter\nR\nVerticalClearanceFilter 2",
          "VerticalClearanceFilter 2\nR\nVerticalClearanceFilter 3", "VerticalClearanceFilter 2\nRoundingFilter\nR",
          "VerticalClearanceFilter 2\nR\nRoundingFilter\nVerticalClearanceFilter 2",
          "VerticalClearanceFilter 2\nSimplificationFilter\nR\nVerticalClearanceFilter 2",
          "VerticalClearanceFilter 2\nLayerSubdivisionFilter\nR", "R\nDuplicationFilter 0.01\nDegeneracyFilter",
          "VerticalClearanceFilter 2\nR\nSimplificationFilter true 0.000001\nAreaFilter 1",
          "R\nGridStrategy 2 2\nVerticalClearanceFilter 2\nCollapse\nR",
          "VerticalClearanceFilter 2\nRoundingFilter\nStepFilter 0.1\nSimplificationFilter\nR\nAreaFilter 1"})
      QTest::newRow(filters) << QString(filters);
  }

  void itStandsAnywhere() {
    QFETCH(QString, filters);
    // A house whose roof and table cannot be reached; they stay obstacles.
    const Soup soup = Soup().floor(0, 0, 4, 4, 0).floor(0, 4, 4, 6, 0).floor(0, 0, 4, 4, 4).floor(1, 1, 2, 2, 1);
    const bool hasClearance = filters.contains("Clearance");
    filters += '\n';
    filters.replace("R\n", "ReachableFilter 3 5 0.5\n");
    const RunResult result = run(soup.environment(), filters.toStdString(), nullptr);
    QCOMPARE(area(*result.mesh), hasClearance ? 23.0 : 24.0);
    QCOMPARE(findMeshError(*result.mesh), std::string());
    QCOMPARE(result.summary.area, hasClearance ? 23.0 : 24.0);
  }

  void seedsAreInTheFilesFrame() {
    const Soup soup = Soup().floor(0, 0, 4, 4, 0).floor(6, 0, 8, 4, 5);
    for (const UpAxis up : kUpAxes) {
      const auto environment = soup.environment();
      environment->up = up;
      environment->metresPerUnit = 0.01;  // never touches coordinates
      const Vec3 seed = inFileFrame({7, 3, 5.5}, up);
      QCOMPARE(area(navigationMesh(runFilters(environment, minimalPipeline(2) + seedsText({seed})))), 8.0);
      try {
        runFilters(environment, minimalPipeline(2) + seedsText({seed, inFileFrame({5, 3, 5.5}, up)}));
        QFAIL("it was accepted");
      } catch (const InputError& error) {
        const Vec3 wrong = inFileFrame({5, 3, 5.5}, up);
        std::string text = "seed 2 at";
        for (const double number : {wrong.x, wrong.y, wrong.z}) {
          text += ' ';
          appendNumber(text, number);
        }
        QVERIFY2(std::string(error.what()).starts_with(text + " has no walkable place"), error.what());
      }
    }
  }

  void messagesOfPipelines_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("expected");
    QTest::newRow("two") << "ReachableFilter 1 2\n"
                         << "p:1:17: ReachableFilter takes \"ReachableFilter x y z [x y z ...]\"; values given: 2";
    QTest::newRow("four") << "SlopeFilter 45\n  ReachableFilter 1 2 3 4 # four\n"
                          << "p:2:25: ReachableFilter takes ";
    QTest::newRow("one more") << "ReachableFilter 1 2 3 4 5 6  7\n"
                              << "p:1:30: ReachableFilter takes ";
    QTest::newRow("none") << "ReachableFilter\n"
                          << "p:1:1: ReachableFilter has no seed";
    QTest::newRow("no number") << "ReachableFilter 1 2 3 4 five 6\n"
                               << "p:1:25: \"five\" is no value for y; give a number (";
    QTest::newRow("nan") << "ReachableFilter 1 2 nan\n"
                         << "p:1:21: z is not a finite number";
    QTest::newRow("infinite") << "ReachableFilter 1 2 3 inf 5 6\n"
                              << "p:1:23: x is not a finite number";
    QTest::newRow("too large") << "ReachableFilter 1 2 1e999\n"
                               << "p:1:21: ";
    QTest::newRow("in a block") << "GridStrategy 2 2\nReachableFilter 1 2 3\nCollapse\n"
                                << "p:2:1: ReachableFilter needs all cells";
  }

  void messagesOfPipelines() {
    QFETCH(QString, text);
    QFETCH(QString, expected);
    try {
      parsePipeline(text.toStdString(), "p");
      QFAIL("it was accepted");
    } catch (const InputError& error) {
      QVERIFY2(QString(error.what()).startsWith(expected), error.what());
    }
  }

  void runsSayWhichSeed() {
    const auto environment = Soup().floor(0, 0, 4, 4, 0).environment();
    const auto messageOf = [&](const Pipeline& pipeline) -> std::string {
      RunContext context;
      try {
        runPipeline(environment, pipeline, context);
      } catch (const InputError& error) {
        return error.what();
      }
      return {};
    };
    const Pipeline text = parsePipeline("VerticalClearanceFilter 2\n  ReachableFilter 1 1 0  5 5 0.5 1 1 9\n", "p");
    QCOMPARE(
        messageOf(text),
        "line 2, ReachableFilter: column 26: seed 2 at 5 5 0.5 has no walkable place under it; move it over one, or "
        "remove it");
    Pipeline made;
    made.steps.push_back(parsePipeline("VerticalClearanceFilter 2\n", "p").steps[0]);
    made.steps.push_back({&filterDescriptor(FilterType::Reachable), {1, 1, 9}});
    made.steps[0].line = 0;
    QCOMPARE(messageOf(made),
             "step 2 (Reachable), ReachableFilter: seed 1 at 1 1 9 is 9 above the next walkable place, more than the "
             "clearance of 2; move it nearer to a walkable place, or remove it");
    made.steps[1].values.pop_back();
    QVERIFY(messageOf(made).find("values given: 2; give a multiple of 3") != std::string::npos);
    made.steps[1].values.clear();
    QVERIFY(messageOf(made).find("ReachableFilter has no seed; give") != std::string::npos);
    made.steps[1].enabled = false;
    QCOMPARE(messageOf(made), std::string());
  }

  void textsAndDefaults() {
    const std::string text = "ReachableFilter 1.5 -2 3 4e-10 5 6\n";
    QCOMPARE(formatPipeline(parsePipeline(text, "p")), text);
    QCOMPARE(formatPipeline(parsePipeline("ReachableFilter -0 0 0\n", "p")), std::string("ReachableFilter 0 0 0\n"));
    QCOMPARE(formatPipeline(parsePipeline("#off ReachableFilter\n", "p")), std::string("#off ReachableFilter\n"));
    const FilterDescriptor& filter = filterDescriptor(FilterType::Reachable);
    QVERIFY(defaultStep(filter, 1).values.empty());
    QVERIFY(filter.takes(0) && filter.takes(3) && filter.takes(3000) && !filter.takes(2) && !filter.takes(4));
    QCOMPARE(filter.parameterOf(7).name, std::string_view("y"));
    QVERIFY(!filterDescriptor(FilterType::Slope).takes(3));
  }

  void statisticsHaveTheSeeds() {
    const auto environment = Soup().floor(0, 0, 4, 4, 0).floor(5, 0, 6, 4, 0).environment();
    const RunResult result = run(environment, "ReachableFilter 1 1 0 2 2 0.5\n", nullptr);
    QString json = QString::fromStdString(formatStatistics(*environment, result));
    QVERIFY2(json.simplified().remove(' ').contains("\"seeds\":[[1.0,1.0,0.0],[2.0,2.0,0.5]]"), qPrintable(json));
    QVERIFY(json.contains("1 of 2 regions removed"));
  }

  void whyNamesIt() {
    const auto environment = Soup().floor(0, 0, 4, 4, 0).floor(5, 0, 6, 4, 0).environment();
    const Pipeline pipeline = parsePipeline("VerticalClearanceFilter 2\nReachableFilter 1 1 0\n", "p");
    RunContext context;
    const RunResult result = runPipeline(environment, pipeline, context);
    const Inspector inspector(environment, pipeline, result.mesh);
    const PlaceExplanation gone = inspector.explain(*inspector.placeBelow({5.5, 1, 1}));
    QVERIFY(gone.verdict == PlaceVerdict::Unreachable && gone.step == std::size_t{1});
    QVERIFY(inspector.explain(*inspector.placeBelow({1, 1, 1})).verdict == PlaceVerdict::Walkable);
  }

  void aThousandSeeds() {
    // A board of 64 x 64 islands; one seed on every fourth of them, written as one line of a file.
    Soup soup;
    std::vector<Vec3> seeds;
    for (int x = 0; x < 64; ++x)
      for (int y = 0; y < 64; ++y) {
        soup.floor(2 * x, 2 * y, 2 * x + 1, 2 * y + 1, (x + y) % 3);
        if (x % 2 == 0 && y % 2 == 0) seeds.push_back({2 * x + 0.3, 2 * y + 0.4, (x + y) % 3 + 0.5});
      }
    QVERIFY(seeds.size() > 1000);
    QCOMPARE(areaOf(soup, minimalPipeline(1) + seedsText(seeds)), static_cast<double>(seeds.size()));
    seeds[900].x += 1;
    const std::string message = errorOf(soup, minimalPipeline(1) + seedsText(seeds));
    QVERIFY2(message.starts_with("seed 901 at "), message.c_str());
  }
};

QTEST_GUILESS_MAIN(TestReachableFilter)
#include "test_reachable_filter.moc"
