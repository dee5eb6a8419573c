// Floor plans: scale and paper, pages, cut walls, flights of stairs, the files and the command that writes them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/environment/part_rules.hpp"
#include "core/report/floor_plan.hpp"
#include "core/report/plan_doors.hpp"
#include "core/report/plan_label.hpp"
#include "core/report/plan_layout.hpp"
#include "core/report/plan_pages.hpp"
#include "core/report/plan_stairs.hpp"
#include "core/report/plan_walls.hpp"
#include "footfall/corridor_map.hpp"
#include "footfall/errors.hpp"
#include "footfall/run.hpp"
#include "tests/support/soup.hpp"
#include "tests/unit/program_run.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

constexpr const char* kFilters =
    "DuplicationFilter 0\nSlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4\nSimplificationFilter\n"
    "LayerSubdivisionFilter\n";

// The tops of walls, pillars and tables are no floors.
constexpr const char* kNoTops = "AreaFilter 8\n";

struct Level {
  std::shared_ptr<const Environment> environment;
  Pipeline pipeline;
  std::shared_ptr<const NavigationMesh> mesh;

  explicit Level(const Soup& soup, const std::string& extra = {})
      : environment(soup.environment()), pipeline(parsePipeline(kFilters + extra, "test")) {
    RunContext context;
    mesh = runPipeline(environment, pipeline, context).mesh;
  }
  [[nodiscard]] std::vector<Sheet> draw(const PlanOptions& options = {}) const {
    return drawFloorPlan(*environment, pipeline, *mesh, options);
  }
};

/// A room of 10 by 6 with walls 0.2 thick round it and a pillar.
Soup room() {
  Soup soup;
  soup.floor(0, 0, 10, 6, 0);
  soup.box({-0.2, -0.2, 0}, {10.2, 0, 3}).box({-0.2, 6, 0}, {10.2, 6.2, 3});
  soup.box({-0.2, 0, 0}, {0, 6, 3}).box({10, 0, 0}, {10.2, 6, 3}).box({4, 2, 0}, {5, 3, 3});
  return soup;
}

/// `count` risers of 0.2 with treads of 0.3 along x, from a floor to a floor.
Soup stairs(int count) {
  Soup soup;
  soup.floor(-4, 0, 0, 2, 0);
  for (int i = 0; i < count; ++i) {
    soup.wall(0.3 * i, 0, 0.3 * i, 2, 0.2 * i, 0.2 * (i + 1));
    soup.floor(0.3 * i, 0, i + 1 == count ? 0.3 * i + 4 : 0.3 * (i + 1), 2, 0.2 * (i + 1));
  }
  return soup;
}

std::vector<std::uint32_t> allOf(const NavigationMesh& mesh) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) all.push_back(t);
  return all;
}

std::vector<std::string> wordsOf(const Sheet& sheet) {
  std::vector<std::string> words;
  for (const auto& shapes : {sheet.drawing, sheet.frame})
    for (const SheetShape& shape : shapes)
      if (const auto* text = std::get_if<SheetText>(&shape)) words.push_back(text->text);
  return words;
}

bool says(const Sheet& sheet, const std::string& words) {
  const auto all = wordsOf(sheet);
  return std::any_of(all.begin(), all.end(),
                     [&](const std::string& text) { return text.find(words) != std::string::npos; });
}

double areaOf(const PlanLineString& line) {
  double sum = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const PlanPlace &a = line[i], &b = line[(i + 1) % line.size()];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum / 2;
}

}  // namespace

class TestFloorPlan : public QObject {
  Q_OBJECT

 private slots:
  // A file's doors are open, so their triangles are not in the environment that is drawn.
  void doorsAreFoundByTheirClass() {
    Soup soup = room();
    Environment file = *soup.environment();
    file.parts = {{"IfcWall", "Ground: Wall"}, {"IfcDoor", "Ground: Door"}, {"IfcDoor", "Ground: Hatch"}};
    file.usualRoles = {PartRole::Floor, PartRole::Ignored, PartRole::Ignored};
    file.partOf.assign(file.triangles.size(), 0);
    const auto add = [&](std::uint32_t part, const std::vector<Vec3>& corners) {
      const auto first = static_cast<std::uint32_t>(file.vertices.size());
      file.vertices.insert(file.vertices.end(), corners.begin(), corners.end());
      for (std::uint32_t i = 0; i + 2 < corners.size(); ++i) {
        file.triangles.push_back({first, first + i + 1, first + i + 2});
        file.partOf.push_back(part);
      }
    };
    // Two doors of one name: one along x, with a handle, and one that is turned by 3:4.
    add(1, {{2, -0.2, 0}, {2, 0, 0}, {2, 0, 2}, {2, -0.2, 2}});
    add(1, {{3, -0.2, 0}, {3, 0, 0}, {3, 0, 2}, {3, -0.2, 2}});
    add(1, {{2, -0.1, 0}, {3, -0.1, 0}, {3, -0.1, 2}, {2, -0.1, 2}});
    add(1, {{2.1, -0.05, 1}, {2.15, 0.08, 1}, {2.15, -0.04, 1.02}});
    add(1, {{7, 3, 0}, {7.8, 3.6, 0}, {7.68, 3.76, 2}, {6.88, 3.16, 2}});
    add(2, {{5, 5, 0}, {6, 5, 0}, {6, 5, 0.3}});  // too low for a door
    if (!file.obstacleOnly.empty()) file.obstacleOnly.resize(file.triangles.size(), 0);
    auto base = std::make_shared<const Environment>(std::move(file));
    Level level(soup, kNoTops);
    level.environment = applyPartRules(base, {});
    QVERIFY(level.environment->triangles.size() < base->triangles.size());
    const std::vector<PlanDoor> doors = findDoors(*level.environment);
    QCOMPARE(doors.size(), std::size_t{2});
    const auto length = [](const PlanPlace& a, const PlanPlace& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); };
    for (const PlanDoor& door : doors) {
      QVERIFY(std::abs(length(door.corners[0], door.corners[1]) - 1) < 1e-9);
      QVERIFY(std::abs(length(door.corners[1], door.corners[2]) - 0.2) < 1e-9);
      QCOMPARE(door.lower, 0.0);
      QCOMPARE(door.upper, 2.0);
    }
    const Sheet sheet = level.draw().front();
    QVERIFY(says(sheet, "door"));
    QVERIFY(!says(Level(soup, kNoTops).draw().front(), "door"));
    base.reset();  // no reference to the file is left
    QVERIFY(findDoors(*level.environment).empty());
  }

  void scaleAndPaper_data() {
    QTest::addColumn<double>("width");
    QTest::addColumn<double>("metresPerUnit");
    QTest::addColumn<double>("given");
    QTest::addColumn<double>("scale");
    QTest::addColumn<double>("paper");  // its longer side
    QTest::newRow("a room on A4") << 6.0 << 1.0 << 0.0 << 50.0 << 297.0;
    QTest::newRow("the most that 1:50 holds") << 13.85 << 1.0 << 0.0 << 50.0 << 297.0;
    QTest::newRow("a little more") << 13.86 << 1.0 << 0.0 << 100.0 << 297.0;
    QTest::newRow("millimetres") << 6000.0 << 0.001 << 0.0 << 50.0 << 297.0;
    QTest::newRow("a house on A3") << 36.0 << 1.0 << 0.0 << 100.0 << 420.0;
    QTest::newRow("a town on A3") << 3000.0 << 1.0 << 0.0 << 10000.0 << 420.0;
    QTest::newRow("1:50 on A1") << 36.0 << 1.0 << 50.0 << 50.0 << 841.0;
    QTest::newRow("a scale of one's own") << 6.0 << 1.0 << 75.0 << 75.0 << 297.0;
  }
  void scaleAndPaper() {
    QFETCH(double, width);
    QFETCH(double, metresPerUnit);
    QFETCH(double, given);
    QFETCH(double, scale);
    QFETCH(double, paper);
    PlanOptions options;
    if (given > 0) options.scale = given;
    const PlanLayout layout = layOutPlan({{0, 0}, {width, width / 2}}, metresPerUnit, options);
    QCOMPARE(layout.scale, scale);
    QCOMPARE(std::max(layout.width, layout.height), paper);
    // The box lies inside, and a metre has the length of the scale.
    const SheetPoint lower = layout.at(0, 0), upper = layout.at(width, width / 2);
    QVERIFY(lower.x >= layout.window.lower.x - 1e-9 && upper.x <= layout.window.upper.x + 1e-9);
    QVERIFY(lower.y >= layout.window.lower.y - 1e-9 && upper.y <= layout.window.upper.y + 1e-9);
    QVERIFY(std::abs((upper.x - lower.x) - width * metresPerUnit * 1000 / scale) < 1e-6);
  }

  void scaleThatDoesNotFit() {
    PlanOptions options;
    options.scale = 50;
    options.paper = Paper::A4;
    try {
      layOutPlan({{0, 0}, {36, 10}}, 1, options);
      QFAIL("fits");
    } catch (const InputError& error) {
      QCOMPARE(QByteArray(error.what()),
               QByteArray("the plan does not fit the paper at 1:50; choose 1:200 or a larger paper"));
    }
    options.paper.reset();
    options.scale = 1;
    QVERIFY_EXCEPTION_THROWN(layOutPlan({{0, 0}, {36, 10}}, 1, options), InputError);
  }

  void paperNames() {
    QVERIFY(paperFrom("A4") == Paper::A4 && paperFrom("a0") == Paper::A0);
    for (const char* name : {"", "A", "A5", "B4", "A44"}) QVERIFY(!paperFrom(name));
  }

  // Walls are cut in one plane; a pillar is a solid, and a table below the cut is not in it.
  void wallsAreCut() {
    const Level level(room().box({7, 2, 0}, {8, 3, 0.8}), kNoTops);
    const PlanWalls walls = cutWalls(*level.environment, *level.mesh, allOf(*level.mesh), {});
    QVERIFY(walls.openLines.empty() && walls.closedLines.empty());
    double area = 0;
    for (const auto& solid : walls.solids) area += areaOf(solid.lines[0]);
    QVERIFY(std::abs(area - (1 + 2 * 10.4 * 0.2 + 2 * 6 * 0.2)) < 1e-9);
    // No wall stands near a part of the floor that is farther away than the margin.
    QVERIFY(cutWalls(*level.environment, *level.mesh, {}, {}).solids.empty());
  }

  // The floor goes on under the pillar, which is high enough to stand in.
  void insideOfWallsIsNoFloor() {
    const Level level(Soup().floor(0, 0, 10, 6, 0).box({4, 2, 0}, {6, 3, 3}));
    QVERIFY(level.mesh->obstacleEdges.size() >= 4);
    PlanOptions options;
    options.colours = PlanColours::Colour;
    const Sheet sheet = level.draw(options)[0];
    QVERIFY(!says(sheet, "thin wall"));
    QVERIFY(says(sheet, "walkable 58.0 m\u00b2") && !says(sheet, "60.0"));
    // A wall that is no body stays a thin wall.
    QVERIFY(says(Level(Soup().floor(0, 0, 10, 6, 0).wall(3, 1, 3, 4, 0, 3)).draw()[0], "thin wall"));
  }

  void thinAndHollowWalls() {
    // A wall without a thickness, and a room whose walls are seen from inside alone.
    Soup soup;
    soup.floor(0, 0, 10, 6, 0).wall(3, 1, 3, 4, 0, 3);
    soup.wall(0, 0, 10, 0, 0, 3).wall(10, 0, 10, 6, 0, 3).wall(10, 6, 0, 6, 0, 3).wall(0, 6, 0, 0, 0, 3);
    const Level level(soup);
    const PlanWalls walls = cutWalls(*level.environment, *level.mesh, allOf(*level.mesh), {});
    QCOMPARE(walls.openLines.size(), std::size_t{1});
    QCOMPARE(walls.solids.size() + walls.closedLines.size(), std::size_t{1});
  }

  void wallsOfOtherFloorsAreLeftOut() {
    const Level level(
        Soup().floor(0, 0, 4, 4, 0).floor(10, 0, 14, 4, 5).box({11, 1, 0}, {12, 2, 4}).box({1, 1, 0}, {2, 2, 3}));
    std::vector<std::uint32_t> lower;
    for (const std::uint32_t t : allOf(*level.mesh))
      if (level.mesh->vertices[level.mesh->triangles[t][0]].x < 5 &&
          level.mesh->vertices[level.mesh->triangles[t][0]].z == 0)
        lower.push_back(t);
    QCOMPARE(cutWalls(*level.environment, *level.mesh, lower, {}).solids.size(), std::size_t{1});
  }

  // One arrow for a flight, through the middles of its risers and upwards.
  void flights() {
    const Level level(stairs(6));
    const auto flights = findFlights(*level.mesh, 1.2);
    QCOMPARE(flights.size(), std::size_t{1});
    QCOMPARE(flights[0].risers.size(), std::size_t{6});
    for (std::size_t i = 0; i < 6; ++i) {
      const auto& riser = flights[0].risers[i];
      QVERIFY(std::abs(riser.middle[0] - 0.3 * double(i)) < 1e-9 && std::abs(riser.middle[1] - 1) < 1e-9);
      QVERIFY(riser.up[0] > 0.999 && std::abs(riser.length - 2) < 1e-9);
    }
    // A landing that is longer than a tread parts two flights.
    QCOMPARE(findFlights(*level.mesh, 0.2).size(), std::size_t{6});
  }

  void storeys() {
    Soup soup;
    for (const double z : {0.0, 3.0, 6.0}) soup.floor(0, 0, 10, 10, z);
    soup.floor(20, 0, 21, 1, 4.5);  // too small for a storey
    const Level level(soup);
    const auto pages = makePlanPages(*level.mesh, PlanPages::Storeys, 2, 0.4);
    QCOMPARE(pages.size(), std::size_t{3});
    QCOMPARE(pages[1].name, std::string("storey 2"));
    for (const std::uint32_t t : pages[1].triangles) {
      const double z = level.mesh->vertices[level.mesh->triangles[t][0]].z;
      QVERIFY(z == 3.0 || z == 4.5);
    }
    QCOMPARE(makePlanPages(*level.mesh, PlanPages::Layers, 2, 0.4).size(), std::size_t{level.mesh->layerCount});
  }

  void passagesToOtherPages() {
    // Up a ramp and over what is below.
    const Level level(
        Soup().floor(0, 0, 10, 4, 0).ramp(10, 0, 16, 4, 0, 3).floor(16, 0, 20, 4, 3).floor(16, 0, 20, 4, 0));
    const auto pages = makePlanPages(*level.mesh, PlanPages::Storeys, 2, 0.4);
    QCOMPARE(pages.size(), std::size_t{2});
    QVERIFY(!pages[0].passages.empty() && pages[0].passages.size() == pages[1].passages.size());
    QVERIFY(pages[0].passages[0].page == 1 && pages[1].passages[0].page == 0);
  }

  void roomiestPlace() {
    // An L, and a square with a hole.
    const std::vector<std::vector<SheetPoint>> corner{{{0, 0}, {30, 0}, {30, 10}, {4, 10}, {4, 30}, {0, 30}}};
    const RoomiestPlace place = findRoomiestPlace(corner, 0.1);
    QVERIFY(std::abs(place.radius - 5) < 0.3 && std::abs(place.at.y - 5) < 0.3 && place.at.x > 4);
    const std::vector<std::vector<SheetPoint>> ring{{{0, 0}, {10, 0}, {10, 10}, {0, 10}},
                                                    {{1, 1}, {1, 9}, {7, 9}, {7, 1}}};
    QVERIFY(findRoomiestPlace(ring, 0.1).at.x > 7);
  }

  void sheetSaysWhatItShows() {
    const auto sheets = Level(room(), kNoTops).draw();
    QCOMPARE(sheets.size(), std::size_t{1});
    for (const char* words :
         {"Layer 0", "1:50", "slope 45 degrees, height 2 m, step 0.4 m, gap 0.05 m", "59.0 m\u00b2", "walls, cut"})
      QVERIFY2(says(sheets[0], words), words);
    for (const char* words : {"drop", "to layer", "part 1"}) QVERIFY2(!says(sheets[0], words), words);
    const auto all = wordsOf(sheets[0]);
    QVERIFY(std::find(all.begin(), all.end(), "gap") == all.end());  // no entry; the agent has one
    const auto flight = Level(stairs(6)).draw();
    QVERIFY(says(flight[0], "step; arrow: up"));
    const auto drops = Level(Soup().floor(0, 0, 4, 4, 2).floor(4, 0, 9, 4, 0), "DropFilter 3\n").draw();
    QVERIFY(says(drops[0], "drop") && says(drops[0], "part 2"));
  }

  void bottlenecksAreDimensionLines() {
    // Two rooms, and between them a passage of 1 and one of 2.
    const Level level(Soup().floor(0, 0, 4, 6, 0).floor(4, 0.5, 6, 1.5, 0).floor(4, 3, 6, 5, 0).floor(6, 0, 10, 6, 0));
    const auto countOf = [](const Sheet& sheet, const char* words) {
      const auto all = wordsOf(sheet);
      return std::count(all.begin(), all.end(), words);
    };
    PlanOptions options;
    const Sheet without = level.draw(options)[0];
    QVERIFY(!says(without, "1.00 m") && !says(without, "narrow passage") && !says(without, "middle of passages"));
    options.narrowerThan = 1.5;
    const Sheet one = level.draw(options)[0];
    QCOMPARE(countOf(one, "1.00 m"), 1);
    QCOMPARE(countOf(one, "2.00 m"), countOf(without, "2.00 m"));
    QVERIFY(says(one, "narrow passage") && !says(one, "middle of passages"));
    // The line goes from border to border: 1 m at 1:50 is 20 mm.
    const bool hasLine = std::any_of(one.drawing.begin(), one.drawing.end(), [](const SheetShape& shape) {
      const auto* path = std::get_if<SheetPath>(&shape);
      if (path == nullptr || path->lines.size() != 3 || path->lines[0].size() != 2) return false;
      const SheetPoint &a = path->lines[0][0], &b = path->lines[0][1];
      return std::fabs(std::hypot(a.x - b.x, a.y - b.y) - 20) < 1e-9;
    });
    QVERIFY(hasLine);
    options.narrowerThan = 3;
    options.hasCorridors = true;
    const Sheet both = level.draw(options)[0];
    QCOMPARE(countOf(both, "1.00 m"), 1);
    QVERIFY(says(both, "2.00 m") && says(both, "middle of passages"));
    options.widerThan = 1.2;
    QCOMPARE(countOf(level.draw(options)[0], "1.00 m"), 0);
  }

  void bendsOfOnePassageAreOneBottleneck() {
    // Halfway, the passage has a niche on either side, in which it is 2 % wider.
    const Level level(Soup()
                          .floor(0, 0, 4, 6, 0)
                          .floor(4, 0.5, 4.9, 1.5, 0)
                          .floor(4.9, 0.49, 5.1, 1.51, 0)
                          .floor(5.1, 0.5, 6, 1.5, 0)
                          .floor(6, 0, 10, 6, 0));
    QCOMPARE(makeCorridorMap(*level.mesh).bottlenecks.size(), std::size_t{2});
    PlanOptions options;
    options.narrowerThan = 1.5;
    const auto words = wordsOf(level.draw(options)[0]);
    QCOMPARE(std::count(words.begin(), words.end(), "1.00 m"), 1);
  }

  void corridorsCanBeCancelled() {
    const Level level(room());
    const auto pollsOf = [&level](const PlanOptions& options) {
      std::atomic<int> count = 0;
      drawFloorPlan(*level.environment, level.pipeline, *level.mesh, options, [&count] { ++count; });
      return count.load();
    };
    PlanOptions options;
    const int without = pollsOf(options);
    options.hasCorridors = true;
    QVERIFY(pollsOf(options) > without);
  }

  void nothingWalkable() { QVERIFY_EXCEPTION_THROWN(Level(Soup().wall(0, 0, 1, 0, 0, 1)).draw(), InputError); }

  void svgIsXmlAndTheSameTwice() {
    const Level level(room(), kNoTops);
    const std::string svg = formatSheetSvg(level.draw()[0]);
    QXmlStreamReader reader(QByteArray::fromStdString(svg));
    int paths = 0, words = 0;
    while (!reader.atEnd()) {
      if (reader.readNext() != QXmlStreamReader::StartElement) continue;
      paths += int(reader.name() == QLatin1String("path"));
      words += int(reader.name() == QLatin1String("text"));
    }
    QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
    QVERIFY(paths > 10 && words > 8);
    QVERIFY(svg.find("width=\"297mm\" height=\"210mm\"") != std::string::npos);
    QVERIFY(svg == formatSheetSvg(level.draw()[0]));
    Sheet sheet;
    sheet.title = "a<b>&\"";
    QVERIFY(formatSheetSvg(sheet).find("a&lt;b&gt;&amp;") != std::string::npos);
  }

  void pdfHasAPageForEachSheetAndNoDate() {
    const Level level(room(), kNoTops);
    std::vector<Sheet> sheets = level.draw();
    sheets.push_back(sheets.front());
    sheets[0].title = "Geb\u00e4ude \u4e2d";
    const std::string pdf = formatSheetsPdf(sheets);
    QVERIFY(pdf.starts_with("%PDF-") && pdf.find("%%EOF") != std::string::npos);
    QVERIFY(pdf.find("/Count 2") != std::string::npos);
    QVERIFY(pdf.find("Date") == std::string::npos);
    QVERIFY(pdf.find("Geb\\344ude ?") != std::string::npos);
    QVERIFY(pdf == formatSheetsPdf(sheets));
  }

  void command() {
    QTemporaryDir folder;
    const auto path = [&folder](const char* name) { return folder.filePath(name); };
    const QString house = FOOTFALL_SOURCE_DIR "/samples/house/house.obj";
    Outcome outcome = runProgram({"plan", house, "-o", path("a.pdf")});
    QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    QCOMPARE(outcome.out, path("a.pdf").toUtf8() + '\n');
    QVERIFY(contentOf(path("a.pdf")).startsWith("%PDF-"));
    outcome = runProgram({"plan", house, "-o", path("b.svg"), "--quiet", "--threads", "1"});
    QVERIFY2(outcome.exitCode == 0 && outcome.out.isEmpty(), outcome.err.constData());
    QVERIFY(contentOf(path("b-0.svg")).contains("house.obj") && contentOf(path("b-1.svg")).contains("Layer 1"));
    QVERIFY(!QFile::exists(path("b.svg")));
    outcome = runProgram({"plan", house, "-o", path("c.svg"), "--threads", "2", "--quiet"});
    QCOMPARE(contentOf(path("c-0.svg")), contentOf(path("b-0.svg")));
    outcome =
        runProgram({"plan", house, "-o", path("d.svg"), "--storeys", "--black-and-white", "--plan-scale", "1:500"});
    QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    const QByteArray storey = contentOf(path("d-0.svg"));
    QVERIFY(storey.contains("Storey 1") && storey.contains("1:500") && !storey.contains("#d6f0e6"));
    outcome = runProgram({"plan", house, "-o", path("e.wkt"), "--part", "1"});
    QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    QVERIFY(contentOf(path("e-0.wkt")).startsWith("POLYGON ((") && contentOf(path("e-links.wkt")).startsWith("GEOM"));
    outcome = runProgram({"plan", house, "-o", path("f.geojson"), "--crs", "EPSG:25832"});
    QVERIFY(contentOf(path("f.geojson")).contains("EPSG::25832"));
  }

  void wrongUsage_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("no target") << QStringList{} << QByteArray("-o");
    QTest::newRow("ending") << QStringList{"-o", "plan.png"} << QByteArray("ends in .svg, .pdf, .wkt or .geojson");
    QTest::newRow("scale") << QStringList{"-o", "p.pdf", "--plan-scale", "1:0"} << QByteArray("--plan-scale: must be");
    QTest::newRow("letters") << QStringList{"-o", "p.pdf", "--plan-scale", "100x"}
                             << QByteArray("--plan-scale: must be");
    QTest::newRow("paper") << QStringList{"-o", "p.pdf", "--paper", "A9"} << QByteArray("--paper");
    QTest::newRow("fit") << QStringList{"-o", "p.pdf", "--paper", "A4", "--plan-scale", "10"}
                         << QByteArray("does not fit");
    QTest::newRow("system") << QStringList{"-o", "p.geojson", "--crs", "here"} << QByteArray("EPSG:25832");
    QTest::newRow("width") << QStringList{"-o", "p.svg", "--narrower-than", "0"} << QByteArray("--narrower-than");
    QTest::newRow("polygons") << QStringList{"-o", "p.wkt", "--corridors"} << QByteArray("footfall corridors -o");
    QTest::newRow("part") << QStringList{"-o", "p.wkt", "--part", "0"} << QByteArray("--part");
  }
  void wrongUsage() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, says);
    const QTemporaryDir folder;
    const qsizetype target = arguments.indexOf("-o") + 1;
    if (target > 0) arguments[target] = folder.filePath(arguments[target]);
    const Outcome outcome = runProgram(QStringList{"plan", FOOTFALL_SOURCE_DIR "/samples/rooms/rooms.obj"} + arguments);
    QCOMPARE(outcome.exitCode, 2);
    QVERIFY2(outcome.err.contains(says), outcome.err.constData());
    QVERIFY(QDir(folder.path()).isEmpty());
  }

  void nothingHalfWritten() {
    QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir("b-1.svg"));
    const Outcome outcome =
        runProgram({"plan", FOOTFALL_SOURCE_DIR "/samples/house/house.obj", "-o", folder.filePath("b.svg")});
    QCOMPARE(outcome.exitCode, 1);
    QVERIFY(!QFile::exists(folder.filePath("b-0.svg")));
  }
};

QTEST_GUILESS_MAIN(TestFloorPlan)
#include "test_floor_plan.moc"
