// Several ranks (threads in place of MPI) share a run within a bound of memory: whatever their number, the folder is
// that of one process.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QTest>
#include <array>
#include <atomic>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>

#include "core/tiles/cell_plan.hpp"
#include "core/tiles/tile_folder.hpp"
#include "footfall/errors.hpp"
#include "tests/support/rank_runs.hpp"
#include "tests/unit/tiles/tile_cases.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using Files = std::map<std::string, QByteArray>;

/// Local filters, an area, links, gaps, cells that run twice, and everything together.
const std::vector<std::string> kOfRanks{kPipelines[0],    kPipelines[7],    kStepPipelines[0],   kStepPipelines[2],
                                        kGapPipelines[0], kGapPipelines[2], kLinkedPipelines[0], kDefault};

Files filesIn(const std::string& folder) {
  Files files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files[entry.path().filename().string()] = readAll(entry.path().string());
  return files;
}

/// The files that ranks leave in a folder of its own. Each opens the file itself, as processes do.
Files filesOfRanks(const std::string& environment, const std::string& pipeline, const std::string& folder, int ranks,
                   const TileRunOptions& options, TileRunResult* result = nullptr) {
  std::filesystem::create_directory(folder);
  const auto errors = runAsGroup(ranks, [&](RankGroup& group, RunContext& context) {
    const PackedEnvironment opened(environment);
    TileRunResult made = runIntoTiles(opened, parsePipeline(pipeline, "test"), folder, options, group, context);
    if (group.isFirst() && result != nullptr) *result = std::move(made);
  });
  Files files = filesIn(folder);
  for (const std::string& error : errors)
    if (!error.empty()) files["error"] += error.c_str();
  return files;
}

}  // namespace

class TestTileRanks : public QObject {
  Q_OBJECT

 private slots:
  void soups();
  void samples();
  void ranksSayWhatTheyDid();
  void theGroupGivesEachTaskOnce();
  void otherThingsAreRefused();
  void aRankThatFailsLeavesNothing();
  void aRunThatWasKilledGoesOn_data();
  void aRunThatWasKilledGoesOn();
  void wrongInputIsToldAsSuch();
  void whoWaitsIsCancelledWithTheOthers();
  void cellsOfAPlanAreAlike();
};

void TestTileRanks::soups() {
  QVERIFY(check("ranks leave the tiles of one process", 40, [] {
    const auto environment = (*anySoup()).environment();
    if (environment->triangles.empty()) return;
    const TemporaryFolder folder;
    const std::string level = folder.path("soup.ffenv");
    pack(*environment, level);
    const std::string& pipeline = kOfRanks[static_cast<std::size_t>(*below(static_cast<int>(kOfRanks.size())))];
    TileRunOptions options{kEnough, static_cast<std::uint64_t>(1 + *below(5))};
    const int ranks = 2 + *below(3);
    RC_LOG() << pipeline << ranks << " ranks, cells of " << options.mostFaces << '\n' << toText(*environment);
    if (filesOfRanks(level, pipeline, folder.path("many"), ranks, options) !=
        makeTiles(PackedEnvironment(level), pipeline, folder.path("one"), options.mostFaces))
      RC_FAIL("not the same");
  }));
}

void TestTileRanks::samples() {
  const TemporaryFolder folder;
  const std::string level = packed(sample("villa"), folder);
  for (std::size_t i = 0; i < kOfRanks.size(); ++i) {
    const auto named = [&](const char* name) { return folder.path((name + std::to_string(i)).c_str()); };
    const Files one = makeTiles(PackedEnvironment(level), kOfRanks[i], named("one-"), 900);
    QVERIFY(one.size() > 3);
    for (const int ranks : {2, 3}) {
      const std::string name = std::to_string(ranks) + "-";
      const Files many = filesOfRanks(level, kOfRanks[i], named(name.c_str()), ranks, {kEnough, 900});
      QVERIFY2(many == one, kOfRanks[i].c_str());
    }
  }
}

void TestTileRanks::ranksSayWhatTheyDid() {
  const TemporaryFolder folder;
  const std::string level = packed(sample("docks"), folder);
  TileRunResult one, many;
  filesOfRanks(level, kPipelines[0], folder.path("one"), 1, {kEnough, 2500}, &one);
  filesOfRanks(level, kPipelines[0], folder.path("many"), 3, {kEnough, 2500}, &many);
  QCOMPARE(one.ranks.size(), std::size_t{1});
  QCOMPARE(many.ranks.size(), std::size_t{3});
  QCOMPARE(many.counts.cells, one.counts.cells);
  QCOMPARE(many.counts.collected, one.counts.collected);
  QCOMPARE(many.counts.largestCell, one.counts.largestCell);
  std::uint64_t cells = 0;
  for (const TileRankStatistics& rank : many.ranks) {
    cells += rank.counts.cells;
    QVERIFY(rank.bytesRead > 0 && rank.peakBytes > 0);
    QVERIFY(rank.bytesRead < one.ranks[0].bytesRead);
  }
  QCOMPARE(cells, one.counts.cells);
}

void TestTileRanks::theGroupGivesEachTaskOnce() {
  std::mutex mutex;
  std::array<std::multiset<std::size_t>, 3> seen;
  const std::array<std::size_t, 3> counts{100, 0, 7};
  const auto errors = runAsGroup(4, [&](RankGroup& group, RunContext& context) {
    for (std::size_t round = 0; round < counts.size(); ++round) {
      group.beginTasks(counts[round]);
      while (const auto task = group.nextTask(context)) {
        const std::lock_guard lock(mutex);
        seen[round].insert(*task);
      }
      const auto all = group.gather(std::string(static_cast<std::size_t>(group.rank()), 'x'), context);
      if (group.isFirst() && all != std::vector<std::string>{"", "x", "xx", "xxx"}) throw RunError("gathered");
      if (group.fromFirst(std::to_string(group.rank()), context) != "0") throw RunError("from the first");
    }
  });
  QVERIFY(errors == std::vector<std::string>(4));
  for (std::size_t round = 0; round < counts.size(); ++round) {
    QCOMPARE(seen[round].size(), counts[round]);
    for (std::size_t task = 0; task < counts[round]; ++task) QCOMPARE(seen[round].count(task), std::size_t{1});
  }
}

void TestTileRanks::otherThingsAreRefused() {
  const TemporaryFolder folder;
  const PackedEnvironment environment(packed(sample("house"), folder));
  std::filesystem::create_directory(folder.path("tiles"));
  const auto errors = runAsGroup(2, [&](RankGroup& group, RunContext& context) {
    const Pipeline pipeline = parsePipeline(group.isFirst() ? kPipelines[0] : kPipelines[2], "test");
    runIntoTiles(environment, pipeline, folder.path("tiles"), {kEnough, 20}, group, context);
  });
  QVERIFY2(errors[0].starts_with("rank 1: this rank has other inputs than rank 0"), errors[0].c_str());
  removeUnfinished(folder.path("tiles"));
  QVERIFY(std::filesystem::is_empty(folder.path("tiles")));
}

void TestTileRanks::aRankThatFailsLeavesNothing() {
  const TemporaryFolder folder;
  const PackedEnvironment environment(packed(sample("house"), folder));
  for (const int failing : {0, 1, 2}) {
    std::filesystem::create_directory(folder.path("tiles"));
    std::atomic<int> left = 3;
    const auto errors = runAsGroup(
        3,
        [&](RankGroup& group, RunContext& context) {
          runIntoTiles(environment, parsePipeline(kDefault, "test"), folder.path("tiles"), {kEnough, 10}, group,
                       context);
        },
        [&](int rank, const RunEvent& event) {
          if (rank == failing && event.kind == RunEvent::Kind::StepStarted && --left == 0) throw RunError("killed");
        });
    QCOMPARE(errors[0], failing == 0 ? std::string("killed") : "rank " + std::to_string(failing) + ": killed");
    removeUnfinished(folder.path("tiles"));
    QVERIFY(std::filesystem::is_empty(folder.path("tiles")));
  }
}

void TestTileRanks::aRunThatWasKilledGoesOn_data() {
  QTest::addColumn<int>("steps");
  QTest::addColumn<int>("pipeline");
  // Cancels in the cells, in those that run once more, and behind all of them.
  for (const int steps : {6, 20, 40, 74}) QTest::addRow("cells, step %d", steps) << steps << 3;
  for (const int steps : {6, 20, 38, 39, 40}) QTest::addRow("default pipeline, step %d", steps) << steps << 7;
}

void TestTileRanks::aRunThatWasKilledGoesOn() {
  QFETCH(int, steps);
  QFETCH(int, pipeline);
  const std::string& filters = kOfRanks[static_cast<std::size_t>(pipeline)];
  const TemporaryFolder folder;
  const std::string level = packed(sample("house"), folder), tiles = folder.path("tiles");
  const TileRunOptions options{kEnough, 8};
  TileRunResult whole;
  const Files one = filesOfRanks(level, filters, folder.path("one"), 1, options, &whole);
  std::filesystem::create_directory(tiles);
  std::atomic<int> left = steps;
  runAsGroup(
      3,
      [&](RankGroup& group, RunContext& context) {
        const PackedEnvironment opened(level);
        runIntoTiles(opened, parsePipeline(filters, "test"), tiles, options, group, context);
      },
      [&](int, const RunEvent& event) {
        if (event.kind == RunEvent::Kind::StepStarted && --left == 0) throw RunError("killed");
      });
  QVERIFY(std::filesystem::exists(tiles + '/' + kUnfinishedRun));
  // Something else does not go on there, and leaves what there is.
  const Files before = filesIn(tiles);
  const auto errors = runAsGroup(1, [&](RankGroup& group, RunContext& context) {
    const PackedEnvironment opened(level);
    runIntoTiles(opened, parsePipeline(kPipelines[0], "test"), tiles, options, group, context);
  });
  QVERIFY2(errors[0].find("has a run that did not end") != std::string::npos, errors[0].c_str());
  QVERIFY(filesIn(tiles) == before);
  // One of its tiles is damaged.
  std::size_t cells = 0;
  bool isDamaged = false;
  for (const auto& [name, bytes] : before) {
    cells += name.ends_with(".cell") ? 1 : 0;
    if (isDamaged || !name.starts_with("cell-") || !name.ends_with(".fftile")) continue;
    isDamaged = true;
    std::filesystem::resize_file(tiles + '/' + name, static_cast<std::uintmax_t>(bytes.size()) / 2);
  }
  TileRunResult result;
  QVERIFY(filesOfRanks(level, filters, tiles, 2, options, &result) == one);
  QVERIFY(result.counts.takenOver < cells + 1);
  QVERIFY(result.counts.takenOver + (isDamaged ? 1 : 0) >= cells);
  QVERIFY(cells > 1);
}

void TestTileRanks::wrongInputIsToldAsSuch() {
  std::atomic<bool> wasInput = false;
  runAsGroup(2, [&](RankGroup& group, RunContext& context) {
    if (!group.isFirst()) throw InputError("damaged");
    try {
      group.gather({}, context);
    } catch (const InputError&) {
      wasInput = true;
      throw;
    } catch (const Cancelled&) {
      wasInput = dynamic_cast<RankExchange&>(group).failedByInput();
      throw;
    }
  });
  QVERIFY(wasInput);
}

// Then the folder stays for the next run; after a failure it does not.
void TestTileRanks::whoWaitsIsCancelledWithTheOthers() {
  for (const bool isTask : {false, true}) {
    std::atomic<bool> wasCancelled = false;
    runAsGroup(2, [&](RankGroup& group, RunContext& context) {
      if (isTask) group.beginTasks(2);
      if (!group.isFirst()) {
        if (isTask) group.nextTask(context);
        throw Cancelled();
      }
      try {
        while (isTask && group.nextTask(context)) {
        }
        group.gather({}, context);
      } catch (const Cancelled&) {
        wasCancelled = !group.hasFailed();
        throw;
      }
    });
    QVERIFY(wasCancelled);
  }
}

void TestTileRanks::cellsOfAPlanAreAlike() {
  std::vector<PackedBlock> blocks(5);
  const std::vector<std::uint32_t> floors{1000, 0, 500, 0, 10};
  for (PackedBlock& block : blocks) block.faces = 1000;
  blocks[3].faces = 0;
  const CellLimits limits{600000, 500, 1000, 0};
  const std::vector<FaceRange> cells = planCells(blocks, floors, {0, 4000}, limits);
  QCOMPARE(cells.size(), std::size_t{6});
  std::uint64_t next = 0;
  for (const FaceRange& cell : cells) {
    QCOMPARE(cell.first, next);
    QVERIFY(cell.size() > 0 && cell.size() <= 1200);
    next = cell.last;
  }
  QCOMPARE(next, std::uint64_t{4000});
  // The range is a part, and tests make cells small.
  const std::vector<FaceRange> few = planCells(blocks, floors, {900, 1203}, {~0ULL, 500, 1000, 0, 100});
  QCOMPARE(few.size(), std::size_t{4});
  QCOMPARE(few.front().first, std::uint64_t{900});
  QCOMPARE(few.back().last, std::uint64_t{1203});
  QCOMPARE(planCells(blocks, floors, {0, 4000}, {~0ULL, 500, 1000, 0}).size(), std::size_t{1});
  QVERIFY(planCells({}, {}, {0, 0}, limits).empty());
}

QTEST_APPLESS_MAIN(TestTileRanks)
#include "test_tile_ranks.moc"
