// What is told before a run: steps that miss risers, agents larger than the level, scales that cannot be.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "core/inspect/parameter_check.hpp"
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

QString notesOf(const Environment& level, const std::string& pipeline) {
  QStringList lines;
  for (const ParameterNote& note : checkParameters(measureLevel(level), parsePipeline(pipeline, "test")))
    lines << (note.step ? QString::number(*note.step) : QStringLiteral("scale")) + ": " +
                 QString::fromStdString(note.text.str());
  return lines.join('\n');
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

  // Walls 0.25 thick and 3 high in a row, with doors of a height between them.
  void doorsThatAreTooLowAreTold() {
    const auto rooms = [](int doors, double height) {
      Soup soup = Soup().floor(-1, -4, 40, 4, 0);
      for (int i = 0; i < doors; ++i) {
        const double x = 3 * i;
        soup.box({x, -3, 0}, {x + 0.25, -0.5, 3})
            .box({x, 0.5, 0}, {x + 0.25, 3, 3})
            .box({x, -0.5, height}, {x + 0.25, 0.5, 3});
      }
      return soup.environment();
    };
    const auto notes = [](const std::shared_ptr<Environment>& level) {
      return notesOf(*level, "VerticalClearanceFilter 2\n");
    };
    QCOMPARE(measureLevel(*rooms(3, 1.875)).openings, (std::vector<double>(6, 1.875)));
    QCOMPARE(
        notes(rooms(3, 1.875)),
        QString(
            "0: agents are 2 high, and the highest of some 3 doors and other openings here is 1.875: none is passed"));
    QCOMPARE(notes(rooms(3, 2)), QString());      // exactly as high is passed
    QCOMPARE(notes(rooms(1, 1.875)), QString());  // one door
    QCOMPARE(notes(rooms(3, 1.25)), QString());   // windows, rather
    Soup mixed;
    mixed.floor(0, 0, 8, 8, 0);
    for (const double z : {1.875, 1.875, 1.875, 2.125}) mixed.box({z, 1, z}, {z + 0.25, 2, 3});
    QCOMPARE(notes(mixed.environment()), QString());  // one is high enough
    // A table is none, nor is a wide ceiling.
    QVERIFY(
        measureLevel(*Soup().floor(0, 0, 8, 8, 0).box({1, 1, 0.75}, {2, 3, 0.8}).ceiling(0, 0, 8, 8, 2.5).environment())
            .openings.empty());
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

  void agentsLargerThanTheLevel() {
    const Soup room = Soup().floor(0, 0, 30, 20, 0).wall(0, 0, 30, 0, 0, 10);
    QCOMPARE(notesOf(*room.environment(), "VerticalClearanceFilter 40\n"),
             QString("0: agents are 40 high, and the whole level is no larger than 30; check the scale"));
    QCOMPARE(notesOf(*room.environment(), "VerticalClearanceFilter 30\n"), QString());
    QCOMPARE(notesOf(*room.environment(), "#off VerticalClearanceFilter 40\n"), QString());
  }

  void dropsDeeperThanTheLevel() {
    const Soup room = Soup().floor(0, 0, 30, 20, 0).wall(0, 0, 30, 0, 0, 10);
    QCOMPARE(notesOf(*room.environment(), "VerticalClearanceFilter 2\nDropFilter 12\n"),
             QString("1: drops are 12 deep at most, and the whole level is no higher than 10; check the scale"));
    QCOMPARE(notesOf(*room.environment(), "VerticalClearanceFilter 2\nDropFilter 10\n"), QString());
  }

  void scalesThatCannotBe() {
    const auto level = Soup().floor(0, 0, 1280, 544, 0).wall(0, 0, 1280, 0, 0, 30).environment();
    level->scaleGuessed = false;
    QCOMPARE(notesOf(*level, "SlopeFilter 45\n"), QString());  // somebody has said so
    level->scaleGuessed = true;
    QCOMPARE(notesOf(*level, "SlopeFilter 45\n"),
             QString("scale: the scale is a guess that makes the level 1280 m long; give the metres of a unit, perhaps "
                     "0.01"));
    level->metresPerUnit = 0.01;
    QCOMPARE(notesOf(*level, "SlopeFilter 45\n"), QString());
  }

  void cancels() {
    RunContext context;
    context.cancel();
    QVERIFY_EXCEPTION_THROWN(measureLevel(*stairs(3, 1), context), Cancelled);
  }
};

QTEST_GUILESS_MAIN(TestParameterCheck)
#include "test_parameter_check.moc"
