// Runs within a bound of memory, over random soups: whatever the cells, the tiles joined are the bytes of a run with
// everything in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QTest>

#include "tests/unit/tiles/tile_cases.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

class TestTileSoups : public QObject {
  Q_OBJECT

 private slots:
  void soups();
  void soupsOfBothSides();
  void soupsWithRoles();
  void steps();
  void gaps();
  void stepsThenOverBorders();
};

void TestTileSoups::soups() { QVERIFY(checkSoups("tiles of soups", 120, kPipelines)); }

void TestTileSoups::soupsOfBothSides() {
  QVERIFY(check("tiles of soups, both sides up", 30, [] {
    const auto environment = (*anySoup()).environment(true);
    if (environment->triangles.empty()) return;
    const TemporaryFolder folder;
    pack(*environment, folder.path("soup.ffenv"));
    const QString difference = differenceOf(PackedEnvironment(folder.path("soup.ffenv")), kPipelines[0], {1, 4});
    if (!difference.isEmpty()) RC_FAIL(toText(*environment) + difference.toStdString());
  }));
}

void TestTileSoups::soupsWithRoles() {
  QVERIFY(check("tiles of soups of which parts have roles", 60, [] {
    const auto environment = (*anySoup()).environment();
    if (environment->triangles.empty()) return;
    environment->parts = {{"a", ""}, {"b", ""}, {"c", ""}, {"d", ""}};
    environment->usualRoles = {PartRole::Floor, PartRole::ObstacleOnly, PartRole::Ignored, PartRole::Floor};
    for (std::size_t t = 0; t < environment->triangles.size(); ++t)
      environment->partOf.push_back(static_cast<std::uint32_t>(*below(4)));
    const TemporaryFolder folder;
    pack(*environment, folder.path("soup.ffenv"));
    const PackedEnvironment opened(folder.path("soup.ffenv"));
    for (const std::size_t pipeline : {0, 5, 12}) {
      const QString difference = differenceOf(opened, kPipelines[pipeline], {1, 4});
      if (!difference.isEmpty()) RC_FAIL(toText(*environment) + difference.toStdString());
    }
  }));
}

void TestTileSoups::steps() { QVERIFY(checkSoups("steps between tiles of soups", 100, kStepPipelines)); }

void TestTileSoups::gaps() { QVERIFY(checkSoups("gaps between tiles of soups", 60, kGapPipelines)); }

void TestTileSoups::stepsThenOverBorders() {
  QVERIFY(checkSoups("steps, simplified and in layers, between tiles of soups", 100, kLinkedPipelines));
}

QTEST_APPLESS_MAIN(TestTileSoups)
#include "test_tile_soups.moc"
