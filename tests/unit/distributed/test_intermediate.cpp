// The environment between two filters as bytes: exact bytes lose nothing, rounded ones lose what they say, and whatever
// else is read is refused.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QTest>
#include <cmath>

#include "core/io/export.hpp"
#include "footfall/io.hpp"
#include "tests/support/intermediate.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

std::shared_ptr<const Environment> house() {
  return std::make_shared<Environment>(load(FOOTFALL_SOURCE_DIR "/samples/house/house.obj"));
}

constexpr const char* kFirst = "DegeneracyFilter\nSlopeFilter 50\nVerticalClearanceFilter 2\n";
constexpr const char* kRest =
    "VerticalClearanceFilter 2.5\nStepFilter 0.4 0.3\nAreaFilter 0.5\nSimplificationFilter\nLayerSubdivisionFilter\n";

std::string finished(const StatePtr& state) { return formatObj(navigationMesh(runFilters(state, kRest)), {}); }

template <class Read>
std::string refusal(const Read& read) {
  try {
    read();
    return {};
  } catch (const BadBytes& error) {
    return error.what();
  }
}

}  // namespace

class TestIntermediate : public QObject {
  Q_OBJECT

 private slots:
  void exactGivesTheSameBytesDownstream() {
    RunContext context;
    const StatePtr state = runFilters(house(), kFirst);
    const StatePtr read = readExact(writeExact(*state), *runFilters(house(), ""), context);
    QVERIFY(finished(read) == finished(state));
    QVERIFY(writeExact(*read) == writeExact(*state));
    QVERIFY(check("exact bytes lose nothing", 300, [] {
      const Soup soup = *rc::gen::noShrink(
          rc::gen::oneOf(rc::gen::map(gridTriangles(20, 6, 2), [](const auto& numbers) { return soupOf(numbers); }),
                         rc::gen::map(buildingParts(12), [](const auto& numbers) { return buildingOf(numbers); })));
      const auto environment = soup.environment();
      RunContext context;
      const StatePtr before =
          runFilters(environment, "SlopeFilter 50\nVerticalClearanceFilter 1\nVerticalClearanceFilter 2\n");
      const StatePtr after = readExact(writeExact(*before), *runFilters(environment, ""), context);
      RC_LOG() << toText(*environment);
      if (finished(after) != finished(before)) RC_FAIL("not the same");
    }));
  }

  // A wall across a floor at a slant makes vertices that no double has.
  void roundedFormatsLoseWhatTheySay() {
    RunContext context;
    const StatePtr grid = runFilters(Soup().floor(0, 0, 8, 8, 0).environment(), kFirst);
    QCOMPARE(roundState(*grid, context).inexact, std::uint64_t{0});
    const StatePtr slant = runFilters(Soup().floor(0, 0, 8, 8, 0).ramp(1, 1, 8, 5, 0.5, 3).environment(), kFirst);
    const RoundedState rounded = roundState(*slant, context);
    QVERIFY(roundState(*runFilters(house(), kFirst), context).triangles.triangles.size() > 100);
    QVERIFY(rounded.triangles.triangles.size() == slant->mesh->triangles.size());
    for (const TriangleSoup& again :
         {readAscii(writeAscii(rounded.triangles)), readBinary(writeBinary(rounded.triangles))}) {
      QVERIFY(again.vertices == rounded.triangles.vertices);
      QVERIFY(again.triangles == rounded.triangles.triangles);
    }
    const StatePtr thirds =
        runFilters(Soup().floor(0, 0, 9, 9, 0).wall(0, 1, 9, 4, 0, 1).wall(1, 0, 2, 9, 0, 1).environment(), kFirst);
    QVERIFY(roundState(*thirds, context).inexact > 0);
  }

  void anyDamageIsSeen() {
    RunContext context;
    const StatePtr source = runFilters(house(), "");
    const std::string exact = writeExact(*runFilters(house(), kFirst));
    for (std::size_t i = 0; i < exact.size(); i += 7) {
      std::string damaged = exact;
      damaged[i] = static_cast<char>(damaged[i] ^ 4);
      QVERIFY(!refusal([&] { readExact(damaged, *source, context); }).empty());
      QVERIFY(!refusal([&] { readExact(std::string_view(exact).substr(0, i), *source, context); }).empty());
    }
    QCOMPARE(refusal([&] { readExact(exact + 'x', *source, context); }), std::string("is damaged"));
    const StatePtr other = runFilters(Soup().floor(0, 0, 1, 1, 0).environment(), "");
    QCOMPARE(refusal([&] { readExact(exact, *other, context); }), std::string("is of another environment"));
  }

  void badRoundedBytesAreRefused() {
    const TriangleSoup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 1e-300}}, {{0, 1, 2}}};
    const std::string binary = writeBinary(soup);
    for (std::size_t size = 0; size < binary.size(); ++size)
      QVERIFY(!refusal([&] { readBinary(std::string_view(binary).substr(0, size)); }).empty());
    QCOMPARE(refusal([&] { readBinary(binary + '\0'); }), std::string("there are bytes behind the end"));
    TriangleSoup wrong = soup;
    wrong.triangles[0][2] = 3;
    QCOMPARE(refusal([&] { readBinary(writeBinary(wrong)); }),
             std::string("a triangle has a vertex that is not there"));
    QCOMPARE(refusal([&] { readAscii(writeAscii(wrong)); }), std::string("a triangle has a vertex that is not there"));
    wrong = soup;
    wrong.vertices[1].y = INFINITY;
    QCOMPARE(refusal([&] { readBinary(writeBinary(wrong)); }), std::string("a coordinate is not finite"));
    QVERIFY(!refusal([&] { readAscii("v 0 0 inf\n"); }).empty());
    QVERIFY(!refusal([&] { readAscii("v 0 0\n"); }).empty());
    QVERIFY(!refusal([&] { readAscii("f 0 1 2\n"); }).empty());
    QVERIFY(!refusal([&] { readAscii("vt 0 0\n"); }).empty());
    QVERIFY(!refusal([&] { readAscii("v 0 0 0"); }).empty());
    std::string huge = binary;
    huge[23] = '\x7f';
    QCOMPARE(refusal([&] { readBinary(huge); }), std::string("a list is longer than the bytes"));
  }
};

QTEST_APPLESS_MAIN(TestIntermediate)
#include "test_intermediate.moc"
