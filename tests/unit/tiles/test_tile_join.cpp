// Runs within a bound of memory: whatever the cells, the tiles joined are the bytes of a run with everything in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QTest>
#include <filesystem>
#include <map>
#include <set>

#include "core/base/worker_arena.hpp"
#include "core/environment/part_rules.hpp"
#include "core/io/export.hpp"
#include "core/tiles/cell_tile.hpp"
#include "core/tiles/tile_join.hpp"
#include "core/tiles/tile_run.hpp"
#include "footfall/edit.hpp"
#include "footfall/errors.hpp"
#include "footfall/run.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/packed_round_trip.hpp"
#include "tests/unit/program_run.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

constexpr std::uint64_t kEnough = std::uint64_t{4} << 30;

/// Tests before and behind a clearance, two clearances, blocks, no clearance, nothing at all.
const std::vector<std::string> kPipelines{
    "SlopeFilter 45\nVerticalClearanceFilter 2\n",
    "DuplicationFilter 0\nDegeneracyFilter\nSlopeFilter 50\nVerticalClearanceFilter 1.5\nSlopeFilter 30\n",
    "VerticalClearanceFilter 1\nSlopeFilter 60\nDegeneracyFilter\nVerticalClearanceFilter 2\n",
    "GridStrategy 3 2\nSlopeFilter 45\nVerticalClearanceFilter 1\nCollapse\nVerticalClearanceFilter 3\n",
    "VerticalClearanceFilter 0.5\n",
    "SlopeFilter 40\n",
    "",
    "SlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 2.5\n",
    "SlopeFilter 60\nAreaFilter 1\nAreaFilter 0.25\n",
    "SlopeFilter 60\nLayerSubdivisionFilter\n",
    "SlopeFilter 45\nVerticalClearanceFilter 1\nAreaFilter 1\nLayerSubdivisionFilter\n",
    "SlopeFilter 60\nSimplificationFilter\n",
    "SlopeFilter 45\nVerticalClearanceFilter 1\nAreaFilter 1\nSimplificationFilter\nLayerSubdivisionFilter\n",
    "VerticalClearanceFilter 1\nLayerSubdivisionFilter\nSimplificationFilter\nSimplificationFilter\n"};

/// Steps small and large, one that is more than the clearance, before and behind areas, in a block.
const std::vector<std::string> kStepPipelines{
    "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.5 0\n",
    "SlopeFilter 60\nVerticalClearanceFilter 1\nStepFilter 1 0\nAreaFilter 2.5\n",
    "SlopeFilter 60\nVerticalClearanceFilter 1\nAreaFilter 0.75\nStepFilter 1 0\nAreaFilter 3\nAreaFilter 4\n",
    "VerticalClearanceFilter 0.5\nStepFilter 2.5 0\n",
    "GridStrategy 2 2\nVerticalClearanceFilter 0.25\nStepFilter 1 0\nCollapse\nAreaFilter 1\n"};

/// With filters over borders behind them.
const std::vector<std::string> kLinkedPipelines{
    "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.5 0\nSimplificationFilter\nLayerSubdivisionFilter\n",
    "SlopeFilter 60\nVerticalClearanceFilter 1\nStepFilter 1 0\nAreaFilter 1\nLayerSubdivisionFilter\n",
    "SlopeFilter 60\nVerticalClearanceFilter 1\nAreaFilter 0.75\nStepFilter 1 1\nAreaFilter 2\nSimplificationFilter\n",
    "VerticalClearanceFilter 0.5\nStepFilter 2.5 2\nLayerSubdivisionFilter\nSimplificationFilter\n"};

const std::string kDefault =
    "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4 0.05\nAreaFilter 1\nSimplificationFilter\n"
    "LayerSubdivisionFilter\n";
const std::string kUsualSteps = "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4 0.05\nAreaFilter 1\n";

/// The same with gaps.
const std::vector<std::string> kGapPipelines{
    "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.5 0.3\n",
    "SlopeFilter 60\nVerticalClearanceFilter 1\nStepFilter 1 1.5\nAreaFilter 2.5\n",
    "SlopeFilter 60\nVerticalClearanceFilter 1\nAreaFilter 0.75\nStepFilter 1 1\nAreaFilter 3\n",
    "VerticalClearanceFilter 0.5\nStepFilter 2.5 2\n"};

rc::Gen<Soup> anySoup() {
  return rc::gen::oneOf(rc::gen::map(gridTriangles(20, 3, 3), [](const auto& numbers) { return soupOf(numbers); }),
                        rc::gen::map(gridTriangles(24, 1000, 20), [](const auto& numbers) { return soupOf(numbers); }),
                        rc::gen::map(buildingParts(12), [](const auto& numbers) { return buildingOf(numbers); }),
                        rc::gen::map(upTo(20, below(64)), [](const auto& steps) { return walkOf(steps); }));
}

void pack(const Environment& environment, const std::string& target) {
  EnvironmentPacker packer("a soup", target, nullptr, kLittle);
  for (const Vec3& vertex : environment.vertices) packer.addVertex(vertex);
  for (std::size_t t = 0; t < environment.triangles.size(); ++t)
    packer.addFace(environment.triangles[t], environment.partOf.empty() ? 0 : environment.partOf[t]);
  packer.finish(environment);
}

/// In a folder of its own; the bytes of all files there.
std::map<std::string, QByteArray> makeTiles(const PackedEnvironment& environment, const std::string& pipeline,
                                            const std::string& folder, std::uint64_t mostFaces, int threads = 0) {
  std::filesystem::create_directory(folder);
  RunContext context;
  OneRank ranks;
  onThreads(threads, [&](int) {
    return runIntoTiles(environment, parsePipeline(pipeline, "test"), folder, {kEnough, mostFaces}, ranks, context);
  });
  std::map<std::string, QByteArray> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files[entry.path().filename().string()] = readAll(entry.path().string());
  return files;
}

std::string bytesOf(const NavigationMesh& mesh) {
  return formatObj(mesh, {}) + std::to_string(mesh.sourceTriangles.size()) + ' ' + std::to_string(mesh.layerCount);
}

/// The bytes of tiles.
class TilesInMemory : public TileStore {
 public:
  void add(const Tile& tile) override { tiles.push_back(encodeTile(tile)); }
  Tile read(std::size_t number) override { return decodeTile(tiles[number]); }
  void replace(std::size_t number, const Tile& tile) override { tiles[number] = encodeTile(tile); }
  std::string write(const std::string& /*name*/, const Tile& tile) override { return encodeTile(tile); }
  void take(std::size_t number, const std::string& written) override {
    tiles.resize(std::max(tiles.size(), number + 1));
    tiles[number] = written;
  }

  std::vector<std::string> tiles;
};

/// Empty when tiles of cells with at most so many triangles of their own, in any order, are joined to the same bytes.
QString differenceOf(const PackedEnvironment& environment, const std::string& pipeline,
                     const std::vector<std::uint64_t>& cells) {
  RunContext context;
  const Pipeline parsed = parsePipeline(pipeline, "test");
  const auto level = applyPartRules(std::make_shared<Environment>(environment.readAll()), {});
  if (level->triangles.empty()) return {};
  const RunResult whole = runPipeline(level, parsed, context, nullptr, 1);
  std::vector<std::uint32_t> sources = whole.mesh->sourceTriangles;
  if (level->edit)
    for (std::uint32_t& source : sources) source = level->edit->keptTriangles[source];
  TileRunOptions options{kEnough};
  options.roles = rolesOf(environment.head(), {});
  for (const std::uint64_t most : cells) {
    TilesInMemory store;
    OneRank ranks;
    options.mostFaces = most;
    runCells(environment, parsed, options, store, ranks, context);
    TileJoiner joiner;
    for (auto tile = store.tiles.rbegin(); tile != store.tiles.rend(); ++tile) joiner.add(decodeTile(*tile));
    std::shared_ptr<NavigationMesh> joined = joiner.join(context);
    joined->frame = environment.head().frame();
    if (bytesOf(*joined) != bytesOf(*whole.mesh) || joined->sourceTriangles != sources ||
        joined->layers != whole.mesh->layers || joined->connections != whole.mesh->connections ||
        joined->links.size() != whole.mesh->links.size())
      return QString("cells of %1: %2").arg(most).arg(QString::fromStdString(pipeline));
  }
  return {};
}

/// The file of an environment, packed; empty where it is not there.
std::string packed(const std::string& path, const TemporaryFolder& folder) {
  if (!std::filesystem::exists(path)) return {};
  const std::string target = folder.path("level.ffenv");
  packEnvironment(path, target, {}, nullptr);
  return target;
}

std::string sample(const std::string& name) {
  return std::string(FOOTFALL_SOURCE_DIR) + "/samples/" + name + "/" + name + ".obj";
}

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

/// Any soups, in cells of few triangles and of all, with each pipeline.
bool checkSoups(const char* title, int count, const std::vector<std::string>& pipelines) {
  return check(title, count, [&pipelines] {
    const auto environment = (*anySoup()).environment();
    if (environment->triangles.empty()) return;
    const TemporaryFolder folder;
    pack(*environment, folder.path("soup.ffenv"));
    const PackedEnvironment opened(folder.path("soup.ffenv"));
    for (const std::string& pipeline : pipelines) {
      const QString difference = differenceOf(opened, pipeline, {1, 3, 1000});
      if (!difference.isEmpty()) RC_FAIL(toText(*environment) + difference.toStdString());
    }
  });
}

}  // namespace

class TestTileJoin : public QObject {
  Q_OBJECT

 private slots:
  void soups();
  void soupsOfBothSides();
  void soupsWithRoles();
  void steps();
  void gaps();
  void stepsThenOverBorders();
  void samples_data();
  void samples();
  void environments_data();
  void environments();
  void areasNearTheMinimum();
  void obstaclesPartRegions();
  void stepsUniteRegions();
  void stepsComeAfterAreas();
  void linksInARowGoOn();
  void bordersHaveOneNameAndPlace();
  void theSameTilesOnAnyThreads_data();
  void theSameTilesOnAnyThreads();
  void aBoundThatIsTooLittleSaysWhatItNeeds_data();
  void aBoundThatIsTooLittleSaysWhatItNeeds();
  void globalFiltersAreNamed();
  void whatFailsLeavesNothing();
};

void TestTileJoin::soups() { QVERIFY(checkSoups("tiles of soups", 120, kPipelines)); }

void TestTileJoin::soupsOfBothSides() {
  QVERIFY(check("tiles of soups, both sides up", 30, [] {
    const auto environment = (*anySoup()).environment(true);
    if (environment->triangles.empty()) return;
    const TemporaryFolder folder;
    pack(*environment, folder.path("soup.ffenv"));
    const QString difference = differenceOf(PackedEnvironment(folder.path("soup.ffenv")), kPipelines[0], {1, 4});
    if (!difference.isEmpty()) RC_FAIL(toText(*environment) + difference.toStdString());
  }));
}

void TestTileJoin::soupsWithRoles() {
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

void TestTileJoin::steps() { QVERIFY(checkSoups("steps between tiles of soups", 100, kStepPipelines)); }

void TestTileJoin::stepsThenOverBorders() {
  QVERIFY(checkSoups("steps, simplified and in layers, between tiles of soups", 100, kLinkedPipelines));
}

void TestTileJoin::gaps() { QVERIFY(checkSoups("gaps between tiles of soups", 60, kGapPipelines)); }

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
  // The sum of six roots lies between two doubles, nearer to both than sums of doubles can tell; each triangle is a
  // tile.
  // The same with a gap between both halves.
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
  // Over a wall of another tile, and beside one.
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
  // What lies between the others goes before, and nothing is linked, or nothing goes.
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
  // What it says is enough, or the next one says more.
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
