// Parts that are ignored, or obstacles only: what rules do, that the result is exact, and that edits of rules give what
// a run from nothing gives.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QtTest>
#include <array>
#include <string>
#include <vector>

#include "core/environment/environment_diff.hpp"
#include "core/environment/part_rules.hpp"
#include "footfall/errors.hpp"
#include "tests/reference/product_check.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

constexpr int kParts = 4;

EnvironmentPart nameOf(int part) {
  return {std::string("mesh").append(std::to_string(part / 2)), std::string("m").append(std::to_string(part))};
}

/// Each triangle, or pair of triangles, in one of four parts.
std::shared_ptr<const Environment> withParts(const Soup& soup, int seed, bool bothSides = false) {
  const auto environment = soup.environment(bothSides);
  for (int p = 0; p < kParts; ++p) environment->parts.push_back(nameOf(p));
  for (std::size_t t = 0; t < environment->triangles.size(); ++t)
    environment->partOf.push_back(static_cast<std::uint32_t>((t / 2 * 7 + static_cast<std::size_t>(seed)) % kParts));
  return environment;
}

std::vector<PartRule> rulesFrom(const std::array<int, kParts>& numbers) {
  std::vector<PartRule> rules;
  for (int p = 0; p < kParts; ++p) {
    const PartRole role =
        std::array{PartRole::Floor, PartRole::ObstacleOnly,
                   PartRole::Ignored}[static_cast<std::size_t>(numbers[static_cast<std::size_t>(p)]) % 3];
    rules.push_back({nameOf(p).mesh, nameOf(p).material, role});
  }
  return rules;
}

std::shared_ptr<const Environment> marked(const Soup& soup, int every, bool bothSides) {
  const auto environment = soup.environment(bothSides);
  for (std::size_t t = 0; t < environment->triangles.size(); ++t)
    environment->obstacleOnly.push_back(static_cast<std::uint8_t>(t % static_cast<std::size_t>(every) == 0));
  return environment;
}

void expectExact(const std::shared_ptr<const Environment>& environment, double slope, double clearance) {
  RC_LOG() << "slope " << slope << ", clearance " << clearance << "\n" << toText(*environment);
  const auto error = reference::checkProduct(*environment, slope, clearance, reference::Rounding::Harmless);
  if (!error.empty()) RC_FAIL(error);
}

const std::array<std::string, 7> kPipelines{
    "SlopeFilter 45\nVerticalClearanceFilter 2\n",
    defaultFilters(45, 1),
    "VerticalClearanceFilter 1\nVerticalClearanceFilter 2\nRoundingFilter\nSlopeFilter 30\n",
    "SlopeFilter 60\nAreaFilter 1\nVerticalClearanceFilter 1.5\nLayerSubdivisionFilter\n",
    "SimplificationFilter\nVerticalClearanceFilter 1\nSimplificationFilter true 0.01\nLayerSubdivisionFilter\n",
    "GridStrategy 2 3\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\nSimplificationFilter\n",
    "SlopeFilter 50\nHeightAwareStrategy 1 4\nVerticalClearanceFilter 1\nCollapse\nLayerSubdivisionFilter\n"};

}  // namespace

class TestPartRules : public QObject {
  Q_OBJECT
 private slots:
  void rolesAndWhatIsLeft() {
    const auto base = withParts(Soup().floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, 1).floor(0, 0, 4, 4, 5), 0);
    QVERIFY(applyPartRules(base, {}) == base);
    QVERIFY(applyPartRules(base, {{"mesh0", "elsewhere", PartRole::Ignored}}) == base);
    QVERIFY(applyPartRules(base, {{"mesh0", "m0", PartRole::Floor}}) == base);
    const auto ignored = applyPartRules(base, {{"mesh0", "m0", PartRole::Ignored}});
    QCOMPARE(ignored->triangles.size(), std::size_t{4});
    QVERIFY(ignored->obstacleOnly.empty() && ignored->parts == base->parts);
    QVERIFY(ignored->partOf == (std::vector<std::uint32_t>{3, 3, 2, 2}));
    const auto last = applyPartRules(
        base, {{"mesh0", "m0", PartRole::Ignored}, {"mesh1", "m3", PartRole::ObstacleOnly}, {"mesh0", "m0", {}}});
    QVERIFY(last->obstacleOnly == (std::vector<std::uint8_t>{0, 0, 1, 1, 0, 0}));
    QCOMPARE(last->triangles.size(), std::size_t{6});
  }

  void oneUnnamedPart() {
    const std::shared_ptr<const Environment> base = Soup().floor(0, 0, 4, 4, 0).environment();
    QCOMPARE(rolesOf(*base, {}).size(), std::size_t{1});
    QVERIFY(applyPartRules(base, {{"", "", PartRole::ObstacleOnly}})->obstacleOnly ==
            (std::vector<std::uint8_t>{1, 1}));
    const auto nothing = applyPartRules(base, {{"", "", PartRole::Ignored}});
    QVERIFY(nothing->triangles.empty() && nothing->vertices.empty());
    ResultCache cache;
    for (const std::string& pipeline : kPipelines) QVERIFY(agrees(nothing, pipeline, cache));
  }

  void namesMeanMeshesMaterialsOrBoth() {
    const auto base = withParts(Soup().floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, 1), 0);
    QCOMPARE(rulesForName(*base, "mesh1", PartRole::Ignored, "--ignore").size(), std::size_t{2});
    QCOMPARE(rulesForName(*base, "m2", PartRole::Ignored, "--ignore").size(), std::size_t{1});
    QVERIFY((rulesForName(*base, "mesh1/m3", PartRole::Ignored, "--ignore") ==
             std::vector<PartRule>{{"mesh1", "m3", PartRole::Ignored}}));
    QVERIFY_EXCEPTION_THROWN(rulesForName(*base, "mesh1/m0", PartRole::Ignored, "--ignore"), InputError);
    QVERIFY_EXCEPTION_THROWN(rulesForName(*base, "", PartRole::Ignored, "--ignore"), InputError);
  }

  // Parts that are never walkable are still obstacles: by the definitions, exactly.
  void obstaclesOnlyInRandomSoups() {
    QVERIFY(check("obstacles only in a tiny grid", 100, [] {
      const auto soup = soupOf(*gridTriangles(14, 3, 3));
      expectExact(marked(soup, 2 + *below(3), *below(4) == 3), std::array{45.0, 60.0, 80.0}[*below(3)], 1 + *below(2));
    }));
    QVERIFY(check("obstacles only in one plane", 60,
                  [] { expectExact(marked(soupOf(*gridTriangles(12, 4, 1)), 2 + *below(2), *below(2) == 1), 45, 1); }));
    QVERIFY(check("obstacles only in buildings", 40,
                  [] { expectExact(marked(buildingOf(*buildingParts(8)), 2 + *below(4), false), 60, 1); }));
  }

  // A copy of a floor that is an obstacle only takes nothing from it, whichever comes first.
  void coplanarCopies() {
    for (const bool first : {true, false}) {
      const auto environment = Soup().floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, 0).environment();
      environment->obstacleOnly = first ? std::vector<std::uint8_t>{1, 1, 0, 0} : std::vector<std::uint8_t>{0, 0, 1, 1};
      QCOMPARE(run(environment, "VerticalClearanceFilter 1\n", nullptr).summary.area, 16.0);
    }
  }

  // Rules that come and go, and obstacles among them.
  void rulesInRandomBuildings() {
    QVERIFY(check("rules in random buildings", 200, [] {
      const auto base = withParts(buildingOf(*buildingParts(12)), *below(8), *below(4) == 0);
      const std::string pipeline = kPipelines[static_cast<std::size_t>(*below(static_cast<int>(kPipelines.size())))];
      ResultCache cache;
      RC_ASSERT(agrees(base, pipeline, cache));
      std::shared_ptr<const Environment> shown = base;
      for (int i = 0; i < 4; ++i) {
        const auto ruled = applyPartRules(base, rulesFrom(*numbersBelow<kParts>(3)));
        RC_ASSERT(agrees(ruled, pipeline, cache));
        shown = diffEnvironments(shown, ruled);
        RC_ASSERT(agrees(shown, pipeline, cache));
        if (*below(2) == 0) continue;
        shown = editEnvironment(shown, {}, soupFor(buildingOf(*buildingParts(1))));
        RC_ASSERT(agrees(shown, pipeline, cache));
      }
    }));
  }

  void rulesInRandomSoups() {
    QVERIFY(check("rules in random soups", 150, [] {
      const auto base = withParts(soupOf(*gridTriangles(20, 4, 3)), *below(8));
      ResultCache cache;
      RC_ASSERT(agrees(base, defaultFilters(60, 1), cache));
      std::shared_ptr<const Environment> shown = base;
      for (int i = 0; i < 4; ++i) {
        shown = diffEnvironments(shown, applyPartRules(base, rulesFrom(*numbersBelow<kParts>(3))));
        RC_ASSERT(agrees(shown, defaultFilters(60, 1), cache));
      }
    }));
  }

  void sameBytesInParallelBlocks() {
    QVERIFY(check("rules and parallel blocks", 60, [] {
      const auto ruled =
          applyPartRules(withParts(buildingOf(*buildingParts(14)), *below(8)), rulesFrom(*numbersBelow<kParts>(3)));
      const std::string filters = "SlopeFilter 45\nVerticalClearanceFilter 1.5\n";
      const std::string rest = "SimplificationFilter\nLayerSubdivisionFilter\n";
      const std::string expected = exported(run(ruled, filters + rest, nullptr, 1));
      for (const char* strategy : {"GridStrategy 3 4", "SortedRecursiveStrategy 1 3 true", "HeightAwareStrategy 1 4"})
        for (const int threads : {1, 3})
          RC_ASSERT(exported(run(ruled, strategy + ("\n" + filters) + "Collapse\n" + rest, nullptr, threads)) ==
                    expected);
    }));
  }

  // Obstacles that an edit adds belong to no part and have no role.
  void editsCarryPartsAndRoles() {
    const auto base = withParts(Soup().floor(0, 0, 4, 4, 0).floor(0, 0, 4, 4, 1), 0);
    const auto ruled = applyPartRules(base, {{"mesh0", "m0", PartRole::ObstacleOnly}});
    const auto edited = editEnvironment(ruled, {1, 3}, soupFor(Soup().floor(1, 1, 2, 2, 2)));
    QVERIFY(edited->partOf == (std::vector<std::uint32_t>{0, 3, 4, 4}));
    QVERIFY(edited->parts.back() == EnvironmentPart{});
    QVERIFY(edited->obstacleOnly == (std::vector<std::uint8_t>{1, 0, 0, 0}));
  }
};

QTEST_GUILESS_MAIN(TestPartRules)
#include "test_part_rules.moc"
