// Several ranks (threads in place of MPI): whatever their number, the strategy and what of the shares is there already,
// the bytes are those of one process.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <latch>

#include "core/distributed/share_file.hpp"
#include "core/io/export.hpp"
#include "core/io/import.hpp"
#include "footfall/errors.hpp"
#include "tests/support/rank_runs.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using EnvironmentPtr = std::shared_ptr<const Environment>;

const std::vector<std::string> kStrategies{"GridStrategy 1 1",
                                           "GridStrategy 3 4",
                                           "GridStrategy 13 7",
                                           "RecursiveStrategy 1 3 true",
                                           "SortedRecursiveStrategy 2 6 false",
                                           "HeightAwareStrategy 1 5",
                                           "AutoStrategy"};

/// S stands for the strategy: one pass, tests before and in the block, a second clearance, a filter that moves
/// vertices, one that sees all cells, two blocks, a block without a clearance behind the last pass, and no block.
const std::vector<std::string> kPipelines{
    "S\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\nLayerSubdivisionFilter\n",
    "DegeneracyFilter\nSlopeFilter 50\nS\nVerticalClearanceFilter 1.5\nCollapse\nAreaFilter 0.5\n"
    "SimplificationFilter\nLayerSubdivisionFilter\n",
    "S\nDegeneracyFilter\nSlopeFilter 60\nSlopeFilter 45\nVerticalClearanceFilter 1\nVerticalClearanceFilter 2\n"
    "Collapse\n",
    "VerticalClearanceFilter 1\nAreaFilter 0.7\nS\nVerticalClearanceFilter 2\nSlopeFilter 40\nCollapse\n",
    "S\nVerticalClearanceFilter 1\nRoundingFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n",
    "SlopeFilter 45\nS\nVerticalClearanceFilter 2\nStepFilter 0.4 0.3\nRoundingFilter\nCollapse\nAreaFilter 0.1\n",
    "S\nVerticalClearanceFilter 1\nCollapse\nSimplificationFilter\nS\nSlopeFilter 45\nVerticalClearanceFilter 2\n"
    "Collapse\nS\nSlopeFilter 40\nCollapse\n",
    "SlopeFilter 45\nVerticalClearanceFilter 2\n"};

std::string replaced(std::string text, const std::string& strategy) {
  for (std::size_t at = text.find("S\n"); at != text.npos; at = text.find("S\n", at + strategy.size()))
    if (at == 0 || text[at - 1] == '\n') text.replace(at, 1, strategy);
  return text;
}

rc::Gen<Soup> anySoup() {
  return rc::gen::oneOf(rc::gen::map(gridTriangles(20, 3, 3), [](const auto& numbers) { return soupOf(numbers); }),
                        rc::gen::map(gridTriangles(24, 1000, 20), [](const auto& numbers) { return soupOf(numbers); }),
                        rc::gen::map(buildingParts(12), [](const auto& numbers) { return buildingOf(numbers); }),
                        rc::gen::map(upTo(20, below(64)), [](const auto& steps) { return walkOf(steps); }));
}

template <class List>
const auto& oneOf(const List& list) {
  return list[static_cast<std::size_t>(*below(static_cast<int>(list.size())))];
}

std::string bytes(const RunResult& result) { return result.mesh ? formatObj(*result.mesh, {}) : std::string(); }

std::string bytesOfOne(const EnvironmentPtr& environment, const Pipeline& pipeline) {
  RunContext context;
  return bytes(runPipeline(environment, pipeline, context, nullptr, 1));
}

EnvironmentPtr sample(const char* name) {
  return std::make_shared<Environment>(
      load(std::string(FOOTFALL_SOURCE_DIR) + "/samples/" + name + "/" + name + ".obj"));
}

Pipeline pipelineOf(const std::string& strategy) {
  return parsePipeline(strategy +
                           "\nDegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n"
                           "AreaFilter 1\nSimplificationFilter\nLayerSubdivisionFilter\n",
                       "test");
}

/// Fails at its k-th call, by any rank but 0.
std::function<void(int)> failingAt(std::atomic<int>& calls, int k) {
  return [&calls, k](int rank) {
    if (rank != 0 && ++calls == k) throw RunError("killed");
  };
}

QStringList sharesIn(const QString& folder) { return QDir(folder).entryList({"*.share"}, QDir::Files, QDir::Name); }

}  // namespace

class TestRankExchange : public QObject {
  Q_OBJECT

 private slots:
  void randomSoups() {
    QVERIFY(check("ranks give the bytes of one process", 250, [] {
      const Soup soup = *rc::gen::noShrink(anySoup());
      const EnvironmentPtr environment = soup.environment(*below(4) == 0);
      const Pipeline pipeline = parsePipeline(replaced(oneOf(kPipelines), oneOf(kStrategies)), "test");
      RankOptions options;
      options.ranks = 1 + *below(4);
      options.threads = 1 + *below(2);
      RC_LOG() << formatPipeline(pipeline) << options.ranks << " ranks\n" << toText(*environment);
      const RankOutcome outcome = runOnRanks(environment, pipeline, options);
      if (!outcome.error.empty()) RC_FAIL(outcome.error);
      if (bytes(outcome.result) != bytesOfOne(environment, pipeline)) RC_FAIL("not the same");
    }));
  }

  void samplesAndStatistics() {
    const EnvironmentPtr house = sample("house");
    for (const std::string& strategy : kStrategies) {
      const Pipeline pipeline = pipelineOf(strategy);
      const std::string one = bytesOfOne(house, pipeline);
      for (const int ranks : {1, 2, 3, 4}) {
        RankOptions options;
        options.ranks = ranks;
        const RankOutcome outcome = runOnRanks(house, pipeline, options);
        QCOMPARE(outcome.error, std::string());
        QVERIFY2(bytes(outcome.result) == one, strategy.c_str());
        QCOMPARE(outcome.result.threads, ranks);
        // Only rank 0 goes on; every cell ran once; who had cells sent something.
        std::uint64_t cells = 0;
        for (int rank = 0; rank < ranks; ++rank) {
          const auto r = static_cast<std::size_t>(rank);
          QCOMPARE(bool(outcome.hasResult[r]), rank == 0);
          cells += outcome.ranks[r].cells;
          QCOMPARE(outcome.ranks[r].bytesSent > 0, rank != 0 && outcome.ranks[r].cells > 0);
        }
        const BlockReport& block = outcome.result.blocks.at(0);
        QCOMPARE(cells, block.cells.size());
        for (const CellReport& cell : block.cells) {
          QVERIFY(cell.thread < ranks && cell.startMs <= cell.endMs);
          for (const CellSpan& span : cell.spans) QVERIFY(span.thread >= 0 && span.thread < ranks);
        }
      }
    }
  }

  // A rank that dies takes the run with it, but not what is finished.
  void whatIsFinishedIsNotRunAgain() {
    QTemporaryDir folder;
    const EnvironmentPtr house = sample("house");
    const Pipeline pipeline = pipelineOf("GridStrategy 4 4");
    const std::string one = bytesOfOne(house, pipeline);
    std::atomic<int> calls{0};
    RankOptions options;
    options.ranks = 3;
    options.workFolder = folder.path().toStdString();
    options.cellDone = failingAt(calls, 2);
    const RankOutcome broken = runOnRanks(house, pipeline, options);
    QVERIFY(broken.error.find("killed") != std::string::npos && broken.error.find("rank ") == 0);
    QVERIFY(!broken.result.mesh);
    const auto kept = static_cast<std::uint64_t>(sharesIn(folder.path()).size());
    QVERIFY(kept > 0 && kept < 16);

    options.ranks = 2;  // another number
    options.cellDone = [](int) {};
    const RankOutcome outcome = runOnRanks(house, pipeline, options);
    QCOMPARE(outcome.error, std::string());
    QVERIFY(bytes(outcome.result) == one);
    QCOMPARE(outcome.ranks[0].cells + outcome.ranks[1].cells, 16 - kept);
    QVERIFY(sharesIn(folder.path()).isEmpty());  // a run that ended well needs them no more
  }

  // Two passes: the second one's shares are those of other numbers, and all ranks need the first one's.
  void severalPassesGoOn() {
    QTemporaryDir folder;
    const EnvironmentPtr house = sample("house");
    const Pipeline pipeline = parsePipeline(replaced(kPipelines[6], "GridStrategy 3 3"), "test");
    const std::string one = bytesOfOne(house, pipeline);
    for (const int k : {1, 4, 8, 12, 16}) {
      std::atomic<int> calls{0};
      RankOptions options;
      options.ranks = 3;
      options.workFolder = folder.path().toStdString();
      options.cellDone = failingAt(calls, k);
      runOnRanks(house, pipeline, options);
    }
    QVERIFY(!sharesIn(folder.path()).isEmpty());
    RankOptions options;
    options.ranks = 4;
    options.workFolder = folder.path().toStdString();
    const RankOutcome outcome = runOnRanks(house, pipeline, options);
    QCOMPARE(outcome.error, std::string());
    QVERIFY(bytes(outcome.result) == one);
  }

  void damagedAndForeignSharesRunAgain() {
    QTemporaryDir folder;
    const EnvironmentPtr house = sample("house");
    const Pipeline pipeline = pipelineOf("GridStrategy 4 4");
    const std::string one = bytesOfOne(house, pipeline);
    RankOptions options;
    options.ranks = 1;
    options.workFolder = folder.path().toStdString();
    // A rank 0 that dies as its last cell is done leaves them all.
    std::atomic<int> calls{0};
    options.cellDone = [&calls](int) {
      if (++calls == 16) throw RunError("killed");
    };
    runOnRanks(house, pipeline, options);
    const QStringList names = sharesIn(folder.path());
    QVERIFY(names.size() >= 15);
    const auto change = [&](int i, const std::function<QByteArray(QByteArray)>& changed) {
      QFile file(folder.filePath(names[i]));
      QVERIFY(file.open(QIODevice::ReadWrite));
      const QByteArray content = changed(file.readAll());
      QVERIFY(file.resize(0) && file.seek(0));
      QCOMPARE(file.write(content), content.size());
    };
    change(0, [](QByteArray b) { return b.left(b.size() / 2); });
    change(1, [](QByteArray b) {
      b[b.size() - 1] = static_cast<char>(b[b.size() - 1] ^ 1);
      return b;
    });
    change(2, [](const QByteArray&) { return QByteArray("hello"); });
    change(3, [](const QByteArray&) { return QByteArray(); });
    QVERIFY(QFile::remove(folder.filePath(names[4])));
    QVERIFY(QFile::copy(folder.filePath(names[5]), folder.filePath(names[4])));  // The share is of another cell.
    QVERIFY(QFile::remove(folder.filePath(names[6])));
    QVERIFY(QDir(folder.path()).mkdir(names[6]));
    // The seal is sound: no share at all, and one of another cell.
    const auto sealedAnew = [](const QByteArray& original, const std::string& content) {
      const ShareName name = openShare(original.toStdString()).name;
      return QByteArray::fromStdString(sealShare(name, content));
    };
    change(7, [&](const QByteArray& b) { return sealedAnew(b, "hello"); });
    std::string largest;  // it has floors that no other cell has
    for (const QString& name : names) {
      QFile file(folder.filePath(name));
      QVERIFY(name == names[6] || file.open(QIODevice::ReadOnly));
      if (const QByteArray b = file.isOpen() ? file.readAll() : QByteArray();
          static_cast<std::size_t>(b.size()) > largest.size() + kShareHead && name > names[8])
        largest = openShare(b.toStdString()).bytes;
    }
    change(8, [&](const QByteArray& b) { return sealedAnew(b, largest); });
    options.ranks = 2;
    options.cellDone = [](int) {};
    const RankOutcome outcome = runOnRanks(house, pipeline, options);
    QCOMPARE(outcome.error, std::string());
    QVERIFY(bytes(outcome.result) == one);
    std::string told;
    for (const Text& note : outcome.notes) told += note.str() + '\n';
    for (const char* what : {"is cut off; its cell", "is damaged; its cell", "is no share; its cell",
                             "is a share of another cell or run; its cell", "is no file; its cell",
                             "is no share that can be used (a list is longer than the bytes); its cell",
                             "is no share that can be used (it has a"})
      QVERIFY2(told.find(what) != std::string::npos, (told + "lacks: " + what).c_str());
    QCOMPARE(outcome.ranks[0].cells + outcome.ranks[1].cells, 16 - names.size() + std::uint64_t{8});
  }

  // The name of a share is all that it depends on: with another environment, filter or border nothing is taken over.
  void sharesOfOtherRunsAreNotTaken() {
    QTemporaryDir folder;
    const EnvironmentPtr house = sample("house");
    RankOptions options;
    options.ranks = 1;
    options.workFolder = folder.path().toStdString();
    std::atomic<int> calls{0};
    options.cellDone = [&calls](int) {
      if (++calls == 16) throw RunError("killed");
    };
    runOnRanks(house, pipelineOf("GridStrategy 4 4"), options);
    QVERIFY(sharesIn(folder.path()).size() >= 15);
    options.cellDone = [](int) {};
    auto moved = std::make_shared<Environment>(*house);
    moved->vertices[0].z = std::nextafter(moved->vertices[0].z, 1e9);
    auto obstacle = std::make_shared<Environment>(*house);
    obstacle->obstacleOnly.assign(obstacle->triangles.size(), 0);
    obstacle->obstacleOnly[0] = 1;
    Pipeline lower = pipelineOf("GridStrategy 4 4");
    lower.steps[3].values[0] = 1.9;
    Pipeline flatter = pipelineOf("GridStrategy 4 4");
    flatter.steps[2].values[0] = 44;
    const std::vector<std::pair<EnvironmentPtr, Pipeline>> others{{moved, pipelineOf("GridStrategy 4 4")},
                                                                  {obstacle, pipelineOf("GridStrategy 4 4")},
                                                                  {house, lower},
                                                                  {house, flatter},
                                                                  {house, pipelineOf("GridStrategy 8 2")}};
    for (const auto& [environment, pipeline] : others) {
      const RankOutcome outcome = runOnRanks(environment, pipeline, options);
      QCOMPARE(outcome.error, std::string());
      QCOMPARE(outcome.ranks[0].cells, std::uint64_t{16});
      QVERIFY(bytes(outcome.result) == bytesOfOne(environment, pipeline));
    }
    // The filters behind the block may differ.
    Pipeline longer = pipelineOf("GridStrategy 4 4");
    longer.steps.pop_back();
    const RankOutcome outcome = runOnRanks(house, longer, options);
    QVERIFY(outcome.ranks[0].cells <= 1);
    QVERIFY(bytes(outcome.result) == bytesOfOne(house, longer));
  }

  void ranksWithAnotherEnvironmentAreTold() {
    const EnvironmentPtr house = sample("house"), rooms = sample("rooms");
    RankOptions options;
    options.ranks = 3;
    options.environmentOf = [&](int rank) { return rank == 2 ? rooms : house; };
    const RankOutcome outcome = runOnRanks(house, pipelineOf("GridStrategy 4 4"), options);
    QVERIFY2(outcome.error.find("rank 2: this rank has other inputs") == 0, outcome.error.c_str());
  }

  // Whoever has more passes than the others must not wait for their shares.
  void ranksWithOtherNumbersOfPassesAreTold() {
    const EnvironmentPtr house = sample("house");
    const auto withPasses = [](int count) {
      std::string text = "SlopeFilter 45\n";
      for (int i = 0; i < count; ++i) text += "GridStrategy 3 3\nVerticalClearanceFilter 2\nCollapse\n";
      return parsePipeline(text, "test");
    };
    for (const auto& [ofFirst, ofOthers] : std::vector<std::pair<int, int>>{{1, 2}, {2, 1}, {2, 3}, {0, 1}, {1, 0}}) {
      RankOptions options;
      options.ranks = 3;
      options.pipelineOf = [&, first = ofFirst, others = ofOthers](int rank) {
        return withPasses(rank == 0 ? first : others);
      };
      const RankOutcome outcome = runOnRanks(house, withPasses(1), options);
      QVERIFY2(outcome.error.find("this rank has other inputs") != std::string::npos,
               (std::to_string(ofFirst) + ' ' + std::to_string(ofOthers) + ": " + outcome.error).c_str());
    }
  }

  // Rank 0 cannot be stopped for a while as it reads. A rank that fails waits for it, and counts as cut off only when
  // that takes too long.
  void aRankThatFailsWhileRankZeroReads() {
    const EnvironmentPtr house = sample("house");
    for (const bool isPatient : {true, false}) {
      std::latch fails(1), isOver(1);
      RankOptions options;
      options.ranks = 3;
      options.environmentOf = [&](int rank) {
        if (rank == 0) (isPatient ? fails : isOver).wait();
        if (rank != 1) return house;
        fails.count_down();
        throw RunError("cannot be read");
      };
      options.patienceMs = [&](int rank) { return rank == 1 && !isPatient ? 100.0 : 60000.0; };
      options.ended = [&](int rank) {
        if (rank == 1) isOver.count_down();
      };
      const RankOutcome outcome = runOnRanks(house, pipelineOf("GridStrategy 4 4"), options);
      QCOMPARE(outcome.error, std::string("rank 1: cannot be read"));
      QVERIFY(!outcome.isCutOff[0] && !outcome.isCutOff[2]);
      QCOMPARE(bool(outcome.isCutOff[1]), !isPatient);
    }
  }

  void aFolderThatCannotBeHadIsAnError() {
    QTemporaryDir folder;
    RankOptions options;
    options.workFolder = folder.filePath("missing/work").toStdString();
    const RankOutcome outcome = runOnRanks(sample("rooms"), pipelineOf("GridStrategy 4 4"), options);
    QVERIFY2(outcome.error.find("this folder for shares cannot be made") != std::string::npos, outcome.error.c_str());
    // The folder of another process, which has removed it.
    options.workFolder = folder.filePath("gone").toStdString();
    options.leavesShares = true;
    QVERIFY(!runOnRanks(sample("rooms"), pipelineOf("GridStrategy 4 4"), options).error.empty());
    QVERIFY(QDir(folder.path()).isEmpty());
  }
};

QTEST_GUILESS_MAIN(TestRankExchange)
#include "test_rank_exchange.moc"
