// Runs within a bound of memory: whatever the cells, the tiles joined are the bytes of a run with everything in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <bit>
#include <filesystem>
#include <map>
#include <set>

#include "core/tiles/cell_tile.hpp"
#include "footfall/errors.hpp"
#include "tests/unit/tiles/tile_cases.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

template <class Error, class Call>
QString wordsOf(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

/// Fails unless so many triangles are left, whatever the cells.
void expectKept(const Soup& soup, const std::string& pipeline, std::size_t triangles) {
  const TemporaryFolder folder;
  pack(*soup.environment(), folder.path("soup.ffenv"));
  const PackedEnvironment environment(folder.path("soup.ffenv"));
  QCOMPARE(differenceOf(environment, pipeline, {1, 3, 1000}), QString());
  RunContext context;
  TilesInMemory store;
  OneRank ranks;
  runCells(environment, parsePipeline(pipeline, "test"), {kEnough, 1}, store, ranks, context);
  std::size_t kept = 0;
  for (const std::string& tile : store.tiles) kept += decodeTile(tile).triangles.size();
  QCOMPARE(kept, triangles);
}

}  // namespace

class TestTileJoin : public QObject {
  Q_OBJECT

 private slots:
  void samples_data();
  void samples();
  void environments_data();
  void environments();
  void areasNearTheMinimum();
  void obstaclesPartRegions();
  void stepsUniteRegions();
  void stepsComeAfterAreas();
  void linksInARowGoOn();
  void gapsRunInPieces();
  void bordersHaveOneNameAndPlace();
  void theSameTilesOnAnyThreads_data();
  void theSameTilesOnAnyThreads();
  void aBoundThatIsTooLittleSaysWhatItNeeds_data();
  void aBoundThatIsTooLittleSaysWhatItNeeds();
  void globalFiltersAreNamed();
  void whatFailsLeavesNothing();
};

void TestTileJoin::samples_data() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"house", "rooms", "villa", "arena", "tower", "docks"}) QTest::newRow(name) << name;
}

void TestTileJoin::samples() {
  QFETCH(QString, name);
  const TemporaryFolder folder;
  const std::string level = packed(sample(name.toStdString()), folder);
  if (level.empty()) QSKIP("not there");
  const PackedEnvironment environment(level);
  for (const std::size_t pipeline : {0, 1, 5, 7, 9, 12})
    QCOMPARE(differenceOf(environment, kPipelines[pipeline], {700, 5000}), QString());
  for (const std::size_t pipeline : {0, 2})
    QCOMPARE(differenceOf(environment, kStepPipelines[pipeline], {700, 5000}), QString());
  QCOMPARE(differenceOf(environment, kUsualSteps, {700, 5000}), QString());
  QCOMPARE(differenceOf(environment, kDefault, {700, 5000}), QString());
}

void TestTileJoin::environments_data() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"nav_test", "steelribs", "complex", "fortitude", "level"}) QTest::newRow(name) << name;
}

void TestTileJoin::environments() {
  QFETCH(QString, name);
  const TemporaryFolder folder;
  const std::string level = packed((sharedEnvironments() + '/' + name + ".obj").toStdString(), folder);
  if (level.empty()) QSKIP("real environments are not there");
  const PackedEnvironment environment(level);
  for (const std::size_t pipeline : {0, 7, 9, 12})
    QCOMPARE(differenceOf(environment, kPipelines[pipeline], {3000}), QString());
  QCOMPARE(differenceOf(environment, kStepPipelines[1], {3000}), QString());
  QCOMPARE(differenceOf(environment, kUsualSteps, {3000}), QString());
}

void TestTileJoin::areasNearTheMinimum() {
  // The sum of six roots lies between two doubles, nearer to both than sums of doubles resolve; each triangle is a
  // tile. The same with a gap between both halves.
  Soup ramps, halves;
  double height = 0;
  for (int i = 0; i < 6; ++i) {
    const double before = std::exchange(height, height + std::array{0.5, 1.0, 0.75, 0.25, 0.375, 0.625}[i]);
    ramps.ramp(i, 0, i + 1, 1, before, height);
    const double x = i < 3 ? i : i + 0.03125;
    halves.ramp(x, 0, x + 1, 1, before, height);
  }
  expectKept(ramps, "SlopeFilter 45\nAreaFilter 7.060272067199172\n", 12);
  expectKept(ramps, "SlopeFilter 45\nAreaFilter 7.060272067199173\n", 0);
  const std::string linked = "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.25 0.05\n";
  expectKept(halves, linked + "AreaFilter 7.060272067199172\n", 12);
  expectKept(halves, linked + "AreaFilter 7.060272067199173\n", 0);
}

void TestTileJoin::obstaclesPartRegions() {
  // The link is over a wall of another tile, and beside one.
  const Soup room = Soup().floor(0, 0, 1, 4, 0).floor(1, 0, 4, 4, 0).wall(1, 0, 1, 4, 0, 1);
  expectKept(room, "SlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 3\n", 4);
  expectKept(room, "SlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 4\n", 2);
  expectKept(room, "SlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 12\n", 0);
}

void TestTileJoin::stepsUniteRegions() {
  // Three stairs of 1 m2, of which each triangle is a tile, and one that is too high.
  const Soup stairs = Soup().floor(0, 0, 1, 1, 0).floor(1, 0, 2, 1, 0.25).floor(2, 0, 3, 1, 0.5).floor(3, 0, 4, 1, 1.5);
  const std::string walkable = "SlopeFilter 45\nVerticalClearanceFilter 2\n";
  expectKept(stairs, walkable + "StepFilter 0.25 0\nAreaFilter 2.5\n", 6);
  expectKept(stairs, walkable + "StepFilter 0.25 0\nAreaFilter 3\n", 0);
  expectKept(stairs, walkable + "StepFilter 1 0\nAreaFilter 3\n", 8);
  expectKept(stairs, walkable + "StepFilter 0.2 0\nAreaFilter 1\n", 0);
}

void TestTileJoin::stepsComeAfterAreas() {
  // The floor between the others goes first, and nothing is linked, or nothing goes.
  const Soup stairs = Soup().floor(0, 0, 2, 2, 0).floor(2, 0, 3, 1, 0.25).floor(3, 0, 5, 2, 0.5).floor(2, 1, 3, 2, 9);
  const std::string walkable = "SlopeFilter 45\nVerticalClearanceFilter 2\n";
  expectKept(stairs, walkable + "AreaFilter 2\nStepFilter 0.25 0\n", 4);
  expectKept(stairs, walkable + "AreaFilter 2\nStepFilter 0.25 0\nAreaFilter 5\n", 0);
  expectKept(stairs, walkable + "AreaFilter 0.5\nStepFilter 0.25 0\nAreaFilter 5\n", 8);
}

void TestTileJoin::linksInARowGoOn() {
  // Storeys of the height of a step, with borders over each other: the last one ends in the middle, and so all have a
  // vertex there.
  for (const int storeys : {2, 3, 4, 6, 9, 18}) {
    Soup stack;
    for (int i = 0; i < storeys; ++i) stack.floor(i % 2, 0, i % 2 + 1, i + 1 == storeys ? 1 : 2, 0.75 * i);
    const std::string pipeline = "VerticalClearanceFilter 0.125\nStepFilter 0.75 0\n";
    expectKept(stack, pipeline, static_cast<std::size_t>(3 * storeys - 1));
  }
}

void TestTileJoin::gapsRunInPieces() {
  // Floors with gaps between them, two by two, and three in a row with steps; all of them together do not fit.
  Soup rows;
  for (int i = 0; i < 40; ++i)
    for (int k = 0; k < 40; ++k) {
      const double x = 4 * i, y = 2 * k;
      rows.floor(x, y, x + 1, y + 1, 0).floor(x + 1.0625, y, x + 2, y + 0.75, 0.25);
      if (k % 3 == 0) rows.floor(x + 2, y + 0.25, x + 3, y + 1, 0.5);
    }
  const TemporaryFolder folder;
  pack(*rows.environment(), folder.path("rows.ffenv"));
  const PackedEnvironment environment(folder.path("rows.ffenv"));
  const std::string pipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.25 0.125\n";
  RunContext context;
  OneRank ranks;
  const auto tilesWithin = [&](std::uint64_t memory) {
    TilesInMemory store;
    runCells(environment, parsePipeline(pipeline, "test"), {memory}, store, ranks, context);
    return store.tiles.size();
  };
  // The least bound, to 256 kB: cells are small, and so are the pieces of what gaps change.
  std::uint64_t memory = std::uint64_t{65} << 20;
  while (!wordsOf<InputError>([&] { tilesWithin(memory); }).isEmpty()) memory += std::uint64_t{256} << 10;
  QVERIFY(memory < std::uint64_t{70} << 20);
  QVERIFY(tilesWithin(memory) > tilesWithin(kEnough));
  QCOMPARE(differenceOf(environment, pipeline, {std::uint64_t{1} << 40}, memory), QString());
}

void TestTileJoin::bordersHaveOneNameAndPlace() {
  const TemporaryFolder folder;
  const PackedEnvironment environment(packed(sample("house"), folder));
  const std::string tiles = folder.path("tiles");
  makeTiles(environment, kPipelines[0], tiles, 40);
  RunContext context;
  const TileSet set = readTileIndex(tiles, &context);
  QVERIFY(set.tiles.size() > 3);
  // Every border vertex is in another tile, too; the same place under another name is another vertex.
  std::map<std::string, int> seen;
  for (const TileEntry& entry : set.tiles) {
    const Tile tile = readTile(tiles, entry, &context);
    QCOMPARE(tile.borders.size(), entry.borders);
    std::set<std::string> own;
    for (const TileBorder& border : tile.borders) {
      const Vec3& p = tile.places[static_cast<std::size_t>(border.vertex)];
      std::string name = std::to_string(border.face) + ' ' + border.exact;
      for (const double x : {p.x, p.y, p.z}) name += ' ' + std::to_string(std::bit_cast<std::uint64_t>(x));
      QVERIFY(own.insert(name).second);
      ++seen[name];
      QCOMPARE(border.exact.empty(), tile.exact[static_cast<std::size_t>(border.vertex)] != 0);
    }
  }
  QVERIFY(!seen.empty());
  for (const auto& [name, count] : seen) QVERIFY2(count > 1, name.c_str());
}

void TestTileJoin::theSameTilesOnAnyThreads_data() {
  QTest::addColumn<int>("steps");
  QTest::newRow("local") << 0;
  QTest::newRow("simplification and layers") << 12;
}

void TestTileJoin::theSameTilesOnAnyThreads() {
  QFETCH(int, steps);
  const std::string& pipeline = kPipelines[static_cast<std::size_t>(steps)];
  const TemporaryFolder folder;
  const PackedEnvironment environment(packed(sample("house"), folder));
  const auto one = makeTiles(environment, pipeline, folder.path("one"), 30, 1);
  QVERIFY(one == makeTiles(environment, pipeline, folder.path("four"), 30, 4));
  QVERIFY(one.contains(kTileIndex));
}

void TestTileJoin::aBoundThatIsTooLittleSaysWhatItNeeds_data() {
  QTest::addColumn<int>("steps");
  QTest::newRow("local") << 0;
  QTest::newRow("layers") << 10;
  QTest::newRow("simplification") << 12;
}

void TestTileJoin::aBoundThatIsTooLittleSaysWhatItNeeds() {
  QFETCH(int, steps);
  const TemporaryFolder folder;
  const PackedEnvironment environment(packed(sample("villa"), folder));
  RunContext context;
  const Pipeline pipeline = parsePipeline(kPipelines[static_cast<std::size_t>(steps)], "test");
  const auto cellsWithin = [&](std::uint64_t megabytes) {
    TilesInMemory store;
    OneRank ranks;
    return runCells(environment, pipeline, {megabytes << 20}, store, ranks, context).counts.cells;
  };
  const auto refused = [&](std::uint64_t megabytes) { return wordsOf<InputError>([&] { cellsWithin(megabytes); }); };
  std::uint64_t megabytes = 1;
  QString message = refused(megabytes);
  QVERIFY2(message.contains("a memory of 1 MB is too little; give "), qPrintable(message));
  // The suggested bound is enough, or the next one is larger.
  for (int i = 0; i < 20 && !message.isEmpty(); ++i) {
    const std::uint64_t more = message.section("give ", 1).section(" MB", 0, 0).toULongLong();
    QVERIFY(more > megabytes);
    megabytes = more;
    message = refused(megabytes);
  }
  QCOMPARE(message, QString());
  QVERIFY(cellsWithin(megabytes) > 1);
  QCOMPARE(cellsWithin(4096), std::uint64_t{1});
}

void TestTileJoin::globalFiltersAreNamed() {
  const auto messageFor = [](const char* step) {
    return wordsOf<InputError>([&] { stepsOfCells(parsePipeline(kPipelines[0] + step, "test")); });
  };
  for (const char* step : {"RadiusFilter 0.3", "DropFilter 2", "ReachableFilter 0 0 0"}) {
    const QString message = messageFor(step);
    QVERIFY2(message.startsWith("line 3: ") && message.contains(" sees across cells"), qPrintable(message));
    QVERIFY(message.contains("run without the bound"));
  }
  QCOMPARE(messageFor("StepFilter 0.4"), QString());
  QCOMPARE(messageFor("StepFilter 0.4 0"), QString());
  QCOMPARE(messageFor("AreaFilter 1\nStepFilter 0.4 0\nAreaFilter 2"), QString());
  QVERIFY(messageFor("StepFilter 0.4 0\nStepFilter 0.5 0").startsWith("line 4: a second StepFilter"));
  QVERIFY(messageFor("StepFilter 0.4 0\nSlopeFilter 30").startsWith("line 4: SlopeFilter stands behind a StepFilter"));
  QVERIFY(messageFor("RoundingFilter").contains("RoundingFilter moves vertices"));
  QVERIFY(messageFor("DuplicationFilter 0.1").contains("DuplicationFilter joins vertices across cells"));
  QCOMPARE(messageFor("DuplicationFilter 0"), QString());
  QVERIFY(
      messageFor("SimplificationFilter true 0.01").contains("SimplificationFilter keeps to a bound of memory exactly"));
  QCOMPARE(messageFor("AreaFilter 1\nAreaFilter 2"), QString());
  QCOMPARE(messageFor("AreaFilter 1\nSimplificationFilter\nLayerSubdivisionFilter"), QString());
  const std::string simplified = "StepFilter 0.4 0\nSimplificationFilter\nLayerSubdivisionFilter\n";
  QCOMPARE(messageFor(simplified.c_str()), QString());
  QVERIFY(
      messageFor((simplified + "SimplificationFilter").c_str()).startsWith("line 6: a second SimplificationFilter"));
  for (const char* step : {"AreaFilter 1", "SlopeFilter 30"})
    QVERIFY(messageFor((std::string("SimplificationFilter\n") + step).c_str())
                .contains("stands behind a filter that needs all cells"));
  QVERIFY(messageFor("AreaFilter 1\nSlopeFilter 30").startsWith("line 4: SlopeFilter stands behind an AreaFilter"));
}

void TestTileJoin::whatFailsLeavesNothing() {
  const TemporaryFolder folder;
  const PackedEnvironment environment(packed(sample("house"), folder));
  const std::string tiles = folder.path("tiles");
  std::filesystem::create_directory(tiles);
  int left = 3;
  RunContext* running = nullptr;
  RunContext context([&](const RunEvent& event) {
    if (event.kind == RunEvent::Kind::StepStarted && --left == 0) running->cancel();
  });
  running = &context;
  OneRank ranks;
  QVERIFY_EXCEPTION_THROWN(
      runIntoTiles(environment, parsePipeline(kPipelines[0], "test"), tiles, {kEnough, 20}, ranks, context), Cancelled);
  QVERIFY(std::filesystem::is_empty(tiles));
}

QTEST_APPLESS_MAIN(TestTileJoin)
#include "test_tile_join.moc"
