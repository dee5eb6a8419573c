// The notes before a run: steps that miss risers, agents larger than the level, scales that cannot be.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "core/inspect/parameter_check.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

/// Treads of 1 x 2 with risers between them, at the heights that adding `rise` again and again gives, and walls 3 high.
std::shared_ptr<Environment> stairs(int count, double rise) {
  Soup soup;
  double z = 0, before = 0;
  for (int i = 0; i < count; ++i, before = z, z += rise) {
    soup.floor(i, 0, i + 1, 2, z);
    if (i > 0) soup.wall(i, 0, i, 2, before, z);
    soup.wall(i, 2, i + 1, 2, z, z + 3);
    soup.wall(i, 0, i + 1, 0, z, z + 3);
  }
  return soup.environment();
}

/// Rooms of 8 x 8 in a row; a wall of 0.25 between two has a doorway, 3 from its begin, of this width and height.
std::shared_ptr<Environment> rooms(const std::vector<std::array<double, 2>>& doorways) {
  const double length = 8, thickness = 0.25;
  double widest = 0, highest = 0;
  for (const auto& [width, height] : doorways) widest = std::max(widest, width), highest = std::max(highest, height);
  const double depth = std::max(8.0, 2 * widest), top = std::max(3.0, 2 * highest);
  Soup soup;
  soup.floor(0, 0, length + static_cast<double>(doorways.size()) * (length + thickness), depth, 0);
  for (std::size_t i = 0; i < doorways.size(); ++i) {
    const auto& [width, height] = doorways[i];
    const double x = length + static_cast<double>(i) * (length + thickness), end = x + thickness;
    soup.box({x, 0, 0}, {end, 3, top}).box({x, 3 + width, 0}, {end, depth, top});
    soup.wall(x, 3, end, 3, 0, height).wall(x, 3 + width, end, 3 + width, 0, height);
    soup.ceiling(x, 3, end, 3 + width, height)
        .wall(x, 3, x, 3 + width, height, top)
        .wall(end, 3, end, 3 + width, height, top);
  }
  return soup.environment();
}

QStringList allNotesOf(const Environment& level, const std::string& pipeline) {
  QStringList lines;
  for (const ParameterNote& note : checkParameters(measureLevel(level), parsePipeline(pipeline, "test")))
    lines << (note.step       ? QString::number(*note.step)
              : note.isOnGrid ? QStringLiteral("grid")
                              : QStringLiteral("scale")) +
                 ": " + QString::fromStdString(note.text.str());
  return lines;
}

/// The note on the level's size is left out, because most test levels are smaller than real ones.
QString notesOf(const Environment& level, const std::string& pipeline) {
  QStringList lines = allNotesOf(level, pipeline);
  lines.removeIf([](const QString& line) { return line.contains("the whole level is no larger than"); });
  return lines.join('\n');
}

/// A ramp that is 100 long and 20 wide, and rises by `rise` in each of them, beside a floor of the same size.
std::shared_ptr<Environment> ramp(double rise) {
  auto level = Soup().floor(0, 0, 100, 20, 0).environment();
  level->scaleGuessed = false;
  const auto first = static_cast<std::uint32_t>(level->vertices.size());
  for (const Vec3& p : {Vec3{0, 20, 0}, Vec3{100, 20, 100 * rise}, Vec3{100, 40, 100 * rise}, Vec3{0, 40, 0}})
    level->vertices.push_back(p);
  level->triangles.push_back({first, first + 1, first + 2});
  level->triangles.push_back({first, first + 2, first + 3});
  return level;
}

QString stepNoteOf(const Environment& level, const std::string& step) {
  return notesOf(level, "VerticalClearanceFilter 2\nStepFilter " + step + "\n");
}

}  // namespace

class TestParameterCheck : public QObject {
  Q_OBJECT
 private slots:
  void levelsAreMeasured() {
    const LevelMeasures measures = measureLevel(*stairs(5, 0.25));
    QCOMPARE(measures.size.x, 5.0);
    QCOMPARE(measures.size.y, 2.0);
    QCOMPARE(measures.size.z, 4.0);
    QCOMPARE(measures.wallHeights.size(), std::size_t{2 * (4 + 10)});
    QCOMPARE(measures.wallHeights.front(), 0.25);
    QCOMPARE(measures.wallHeights[8], 3.0);
    QVERIFY(measureLevel(Environment{}).wallHeights.empty());
  }

  void exactRisersAreFine() {
    QCOMPARE(stepNoteOf(*stairs(9, 0.25), "0.25"), QString());
    QCOMPARE(stepNoteOf(*stairs(9, 0.25), "0.4"), QString());
    QCOMPARE(stepNoteOf(*stairs(9, 0.25), "0.1"), QString());  // not meant to climb them
  }

  void roundedRisersAreTold() {
    const QString note = stepNoteOf(*stairs(12, 0.2), "0.2");
    QVERIFY2(note.startsWith("1: most risers here are 0.2 high, as the step is, and roundings make "),
             qPrintable(note));
    QVERIFY2(note.contains(" of 11 a little higher, which are not climbed; give 0.21"), qPrintable(note));
    QVERIFY(!note.contains("make 0 of"));
    QCOMPARE(stepNoteOf(*stairs(12, 0.2), "0.21"), QString());
  }

  void risersALittleHigherAreTold() {
    QCOMPARE(stepNoteOf(*stairs(9, 0.25), "0.245"),
             QString("1: most risers here are 0.25 high, a little more than the step, and are not climbed; give 0.26"));
    QCOMPARE(stepNoteOf(*stairs(3, 0.25), "0.245"), QString());  // two are no stairs
  }

  void whatIsHigherThanHalfAnAgentIsNoRiser() {
    QCOMPARE(notesOf(*stairs(9, 0.25), "VerticalClearanceFilter 0.4\nStepFilter 0.245\n"), QString());
    QVERIFY(!notesOf(*stairs(9, 0.25), "VerticalClearanceFilter 0.5\nStepFilter 0.245\n").isEmpty());
    QCOMPARE(notesOf(*stairs(9, 0.25), "VerticalClearanceFilter 2\n#off StepFilter 0.245\n"), QString());
  }

  void levelsWhoseSizeMakesNoSense() {
    const auto level = Soup().floor(0, 0, 30, 20, 0).wall(0, 0, 30, 0, 0, 10).environment();
    const auto notes = [&](const char* text) { return allNotesOf(*level, text).join('\n'); };
    QCOMPARE(
        notes("VerticalClearanceFilter 3.25\n"),
        QString("0: the whole level is no larger than 30 m, less than ten times an agent's height of 3.25 m; if its "
                "unit is larger, give the metres of a unit, perhaps 10"));
    QCOMPARE(notes("VerticalClearanceFilter 3\n"), QString());
    QCOMPARE(notes("#off VerticalClearanceFilter 40\n"), QString());
    level->scaleGuessed = false;
    level->metresPerUnit = 0.01;
    QCOMPARE(notes("VerticalClearanceFilter 200\n"),
             QString("0: the whole level is no larger than 0.3 m, less than ten times an agent's height of 2 m; if its "
                     "unit is larger, give the metres of a unit, perhaps 0.3048"));  // the wall is a storey in feet
    level->metresPerUnit = 1000;
    QCOMPARE(notes("VerticalClearanceFilter 0.002\n"),
             QString("0: the level is 30000 m large; if its unit is smaller, give the metres of a unit, perhaps 100"));
  }

  // Small, but with storeys of people: stairs of 5 x 2 with walls 3 high, and the same in centimetres.
  void smallLevelsForPeopleAreFine() {
    const auto size = [](const Environment& level, const char* text) {
      return allNotesOf(level, text).filter("the whole level is no larger than").join('\n');
    };
    const auto house = stairs(5, 0.175);
    house->scaleGuessed = false;
    QCOMPARE(size(*house, "VerticalClearanceFilter 2\n"), QString());
    house->metresPerUnit = 0.01;  // a model of it: the level itself has the better scale
    QCOMPARE(size(*house, "VerticalClearanceFilter 200\n"),
             QString("0: the whole level is no larger than 0.05 m, less than ten times an agent's height of 2 m; if "
                     "its unit is larger, give the metres of a unit, perhaps 1"));
    // Nothing in it is of anybody's size.
    const auto bare = Soup().floor(0, 0, 5, 2, 0).environment();
    QVERIFY(!size(*bare, "VerticalClearanceFilter 2\n").isEmpty());
  }

  void notesHaveTheChangeThatMends() {
    const auto mends = [](const Environment& level, const char* text) {
      const Pipeline pipeline = parsePipeline(text, "test");
      const std::vector<ParameterNote> notes = checkParameters(measureLevel(level), pipeline);
      return notes.empty() ? std::optional<ParameterMend>() : notes.back().mend;
    };
    const auto steeper = ramp(1 + 1e-5);
    const auto slope = mends(*steeper, "SlopeFilter 45 0\n");
    QVERIFY(slope && slope->value == 1U);
    QCOMPARE(slope->to, 0.0003);
    const auto step = mends(*stairs(9, 0.25), "VerticalClearanceFilter 2\nStepFilter 0.245\n");
    QVERIFY(step && step->value == 0U);
    QCOMPARE(step->to, 0.26);
    const auto scale = mends(*Soup().floor(0, 0, 5, 2, 0).environment(), "VerticalClearanceFilter 2\n");
    QVERIFY(scale && !scale->value);
    QCOMPARE(scale->to, 10.0);
    QVERIFY(!mends(*rooms({{0.9, 2.1}}), "VerticalClearanceFilter 2.25\n"));
  }

  void groundJustBeyondTheSlope() {
    const double tan45 = 1;
    QCOMPARE(notesOf(*ramp(tan45), "SlopeFilter 45 0\n"), QString());
    const auto steeper = ramp(1 + 1e-5);  // by 0.0003 degrees
    QCOMPARE(notesOf(*steeper, "SlopeFilter 45\n"), QString());
    QCOMPARE(
        notesOf(*steeper, "SlopeFilter 45 0\n"),
        QString("0: 2828.44 square metres of ramps are steeper than 45 degrees by less than 0.0003 degrees, and are "
                "not walkable; for a tolerance of 0.0003 give SlopeFilter 45 0.0003"));
    QCOMPARE(area(navigationMesh(runFilters(steeper, "SlopeFilter 45 0\n"))), 2000.0);
    QVERIFY(area(navigationMesh(runFilters(steeper, "SlopeFilter 45 0.0003\n"))) > 4828);
    QVERIFY(area(navigationMesh(runFilters(steeper, "SlopeFilter 45\n"))) > 4828);
    QCOMPARE(notesOf(*ramp(1.01), "SlopeFilter 45 0\n"), QString());  // that is another slope
  }

  void doorwaysAreFound() {
    const std::vector<Doorway> doorways = measureLevel(*rooms({{0.9, 2.1}, {1.25, 1.5}})).doorways;
    QCOMPARE(doorways.size(), std::size_t{2});
    QVERIFY(std::fabs(doorways[0].width - 0.9) < 1e-12 || std::fabs(doorways[1].width - 0.9) < 1e-12);
    QCOMPARE(std::max(doorways[0].height, doorways[1].height), 2.1);
    QCOMPARE(std::min(doorways[0].height, doorways[1].height), 1.5);
    QVERIFY(measureLevel(*rooms({{0.9, 1.3}})).doorways.empty());  // a hatch
    QVERIFY(measureLevel(*rooms({{5, 2.1}})).doorways.empty());    // a passage
    const auto small = rooms({{90, 210}});
    QVERIFY(measureLevel(*small).doorways.empty());
    small->metresPerUnit = 0.01;
    QCOMPARE(measureLevel(*small).doorways.size(), std::size_t{1});
    // Undersides without jambs are none.
    QVERIFY(measureLevel(*Soup().floor(0, 0, 9, 9, 0).ceiling(3, 3, 3.25, 4, 2.1).environment()).doorways.empty());
  }

  void agentsHigherThanEachDoorway() {
    const auto level = rooms({{0.9, 2.1}, {1.25, 1.75}});
    QCOMPARE(notesOf(*level, "VerticalClearanceFilter 2.1\n"), QString());
    QCOMPARE(notesOf(*level, "VerticalClearanceFilter 2.25\n"),
             QString("0: agents are 2.25 high, and the highest doorway here is 2.1: nobody gets through one; give 2.1 "
                     "or less"));
    QCOMPARE(notesOf(*rooms({}), "VerticalClearanceFilter 2.25\n"), QString());
  }

  void agentsWiderThanEachDoorway() {
    const auto level = rooms({{0.875, 2.25}, {1.25, 1.75}});
    const auto notes = [&](const char* text) { return notesOf(*level, text); };
    QCOMPARE(notes("VerticalClearanceFilter 1.5\nRadiusFilter 0.6\n"), QString());
    QCOMPARE(notes("VerticalClearanceFilter 1.5\nRadiusFilter 0.625\n"),  // a single point does not connect
             QString("1: agents are 1.25 wide, and the widest doorway here is 1.25: nobody gets through one; give a "
                     "radius below 0.625"));
    QCOMPARE(notes("VerticalClearanceFilter 2\nRadiusFilter 0.5\n"),  // too high for the wide one
             QString("1: agents are 1 wide, and the widest doorway here is 0.875: nobody gets through one; give a "
                     "radius below 0.4375"));
    QCOMPARE(notes("VerticalClearanceFilter 2\nRadiusFilter 0.4\n"), QString());
    QCOMPARE(notes("VerticalClearanceFilter 2\n#off RadiusFilter 0.5\n"), QString());
    // The prediction comes true.
    for (const double radius : {0.4, 0.4375}) {
      const std::string pipeline = minimalPipeline(2) + "\nRadiusFilter " + std::to_string(radius) + "\nAreaFilter 1\n";
      QCOMPARE(countParts(navigationMesh(runFilters(level, pipeline))),
               radius < 0.43 ? std::size_t{2} : std::size_t{3});
    }
  }

  void aRadiusLargerThanTheLevel() {
    const auto room = Soup().floor(0, 0, 30, 4, 0).environment();
    QCOMPARE(notesOf(*room, "VerticalClearanceFilter 2\nRadiusFilter 2\n"),
             QString("1: agents are 4 wide, and the whole level is no wider than 4: nothing will be left; check the "
                     "scale"));
    QCOMPARE(area(navigationMesh(runFilters(room, minimalPipeline(2) + "\nRadiusFilter 2\n"))), 0.0);
    QCOMPARE(notesOf(*room, "VerticalClearanceFilter 2\nRadiusFilter 1.9\n"), QString());
  }

  void dropsDeeperThanTheLevel() {
    const Soup room = Soup().floor(0, 0, 30, 20, 0).wall(0, 0, 30, 0, 0, 10);
    QCOMPARE(notesOf(*room.environment(), "VerticalClearanceFilter 2\nDropFilter 12\n"),
             QString("1: drops are 12 deep at most, and the whole level is no higher than 10; check the scale"));
    QCOMPARE(notesOf(*room.environment(), "VerticalClearanceFilter 2\nDropFilter 10\n"), QString());
  }

  void scalesThatCannotBe() {
    const auto level = Soup().floor(0, 0, 1280, 544, 0).wall(0, 0, 1280, 0, 0, 300).environment();
    level->scaleGuessed = false;
    QCOMPARE(notesOf(*level, "SlopeFilter 45\n"), QString());  // the user has confirmed it
    level->scaleGuessed = true;
    QCOMPARE(notesOf(*level, "SlopeFilter 45\n"),
             QString("scale: the scale is a guess that makes the level 1280 m long; give the metres of a unit, perhaps "
                     "0.01"));
    level->metresPerUnit = 0.01;
    QCOMPARE(notesOf(*level, "SlopeFilter 45\n"), QString());
  }

  void coordinatesOfManyBits() {
    const auto notesWith = [](double x) {
      return notesOf(*Soup().floor(0, 0, 30, 20, 0).floor(x, 0, 30, 20, 3).environment(), "SlopeFilter 45\n");
    };
    QCOMPARE(notesWith(0x1p-50 / 3), QString());  // a rounding error about zero
    QVERIFY(notesWith(0x1p-80 / 3).startsWith("grid: coordinates of very different sizes need 139 bits together"));
  }

  void verticesThatNearlyMeet() {
    // A row of tiles, each with vertices of its own, which miss those of the next one by a rounding error.
    const auto notesWith = [](double off, double grid) {
      Soup soup;
      for (int i = 0; i < 20; ++i) soup.floor(3 * i + off * (i % 7), 0, 3 * i + 3 + off * (i % 5), 20, 0);
      const auto environment = soup.environment();
      environment->grid.step = grid;
      return notesOf(*environment, "SlopeFilter 45\n");
    };
    QCOMPARE(notesWith(0, 0), QString());
    QCOMPARE(notesWith(0.125, 0), QString());
    QCOMPARE(notesWith(0x1p-24, 0).left(78),
             QString("grid: about 38 vertices lie within 3.8147e-06 m of others without meeting them"));
    QCOMPARE(notesWith(0x1p-24, 0x1p-18), QString());  // a grid is in use
  }

  void cancels() {
    RunContext context;
    context.cancel();
    QVERIFY_EXCEPTION_THROWN(measureLevel(*stairs(3, 1), context), Cancelled);
  }
};

QTEST_GUILESS_MAIN(TestParameterCheck)
#include "test_parameter_check.moc"
