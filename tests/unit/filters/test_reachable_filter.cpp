// ReachableFilter: against the definition on random soups, places where regions meet, and what users get wrong.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "core/assembly/walkable_state.hpp"
#include "core/base/number_text.hpp"
#include "footfall/errors.hpp"
#include "footfall/inspect.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/report.hpp"
#include "footfall/run.hpp"
#include "footfall/up_axis.hpp"
#include "tests/reference/reach.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/pipeline_case.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::test;
using reference::FloorPiece;
using reference::Point2;
using reference::Point3;
using reference::Rational;

namespace {

std::string seedsText(const std::vector<Vec3>& seeds) {
  std::string text = "ReachableFilter";
  for (const Vec3& s : seeds)
    for (const double number : {s.x, s.y, s.z}) {
      text += ' ';
      appendNumber(text, number);
    }
  return text + "\n";
}

double areaOf(const Soup& soup, const std::string& filters) {
  return area(*run(soup.environment(), filters, nullptr).mesh);
}

/// The message of a run; empty when it is done.
std::string errorOf(const Soup& soup, const std::string& filters) {
  try {
    runFilters(soup.environment(), filters);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

Rational twicePlanArea(const WalkableState& state) {
  Rational sum;
  for (const MeshTriangle& t : state.mesh->triangles) {
    std::array<Point2, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const MeshVertex& v = state.mesh->vertices[t.corners[k]];
      const auto place = state.kernel->exactPosition(v.point, v.face);
      p[k] = {place[0], place[1]};
    }
    sum += reference::twiceArea(p[0], p[1], p[2]);
  }
  return sum;
}

/// The triangles of a state's mesh, and which of them one can walk between: over an edge that both have and no obstacle
/// stands on, or over a link.
struct Walked {
  std::vector<FloorPiece> pieces;
  std::vector<std::array<std::size_t, 2>> crossings;
};

Walked walkedOf(const WalkableState& state) {
  const WalkableMesh& mesh = *state.mesh;
  Walked walked;
  struct Side {
    std::size_t piece;
    bool isBlocked;
  };
  std::map<std::array<Index, 2>, std::vector<Side>> sides;
  const auto key = [](Index a, Index b) { return std::array{std::min(a, b), std::max(a, b)}; };
  std::map<std::array<Index, 2>, std::size_t> directed;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const MeshTriangle& triangle = mesh.triangles[t];
    std::array<Point3, 3> corners;
    for (int k = 0; k < 3; ++k) {
      const MeshVertex& v = mesh.vertices[triangle.corners[k]];
      const auto place = state.kernel->exactPosition(v.point, v.face);
      corners[k] = {place[0], place[1], place[2]};
      const Index from = triangle.corners[k], to = triangle.corners[next(k)];
      sides[key(from, to)].push_back({t, (triangle.obstacleEdges >> k & 1) != 0});
      directed[{from, to}] = t;
    }
    walked.pieces.push_back({reference::planTriangle(corners), *reference::planeThrough(corners)});
  }
  for (const auto& [edge, here] : sides)
    if (std::ranges::none_of(here, &Side::isBlocked))
      for (const Side& side : here) walked.crossings.push_back({here[0].piece, side.piece});
  for (const MeshLink& link : mesh.links) walked.crossings.push_back({directed.at(link.from), directed.at(link.to)});
  return walked;
}

/// Where seeds are worth placing: corners, middles of edges and of triangles, and anywhere; at the floor, a little and
/// exactly the clearance above it, and lower or higher than that.
Vec3 seedFor(const Environment& environment, double clearance, std::mt19937_64& random) {
  const auto below = [&](int count) { return static_cast<int>(random() % static_cast<std::uint64_t>(count)); };
  const Triangle& t = environment.triangles[random() % environment.triangles.size()];
  const Vec3 &a = environment.vertices[t[0]], &b = environment.vertices[t[1]], &c = environment.vertices[t[2]];
  const auto between = [&](double u, double v) {
    return Vec3{a.x + u * (b.x - a.x) + v * (c.x - a.x), a.y + u * (b.y - a.y) + v * (c.y - a.y),
                a.z + u * (b.z - a.z) + v * (c.z - a.z)};
  };
  Vec3 place = below(3) == 0 ? a : below(3) == 0 ? between(0.5, 0) : between(0.25, below(2) * 0.5);
  place.z += clearance * std::array{0.0, 0.0, 0x1p-10, 0.5, 1.0, 1.0, 1.5, -0.25}[static_cast<std::size_t>(below(8))];
  return place;
}

}  // namespace

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
    QCOMPARE(areaOf(soup, clearance + seed + "StepFilter 0.3\n"), 4.0);  // before: no links yet
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
    QCOMPARE(areaAt("2 1 0"), 8.0);    // on the obstacle edge: both sides of it
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
    QCOMPARE(areaAt("2 1 3"), 12.0);  // on the upper one's edge: the lower one is not meant
    QCOMPARE(areaAt("3 1 2"), 16.0);  // under the upper one
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
    QCOMPARE(areaOf(soup, seed), 16.0);  // without a clearance: however far
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
    // A house whose roof and table nobody reaches; they stay obstacles.
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
                                << "p:2:1: ReachableFilter sees across cells";
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
    QVERIFY(!filterDescriptor(FilterType::Slope).takes(2));
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
      // In the gap of the wall, where it parts the rooms, and off it.
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

QTEST_GUILESS_MAIN(TestReachableFilter)
#include "test_reachable_filter.moc"
