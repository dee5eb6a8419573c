// The cells of a parallel block at work: as tasks, largest first, with idle threads helping where work is left. The
// thread pool is that of thesis 4.1; its 4.3.4 (longest processing time) is about nodes, see load_balancing.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/process_usage.hpp"
#include "core/distributed/cell_exchange.hpp"
#include "core/distributed/cell_share.hpp"
#include "core/filters/clearance/clearance_pass.hpp"
#include "core/partitioning/strategies.hpp"
#include "core/pipeline/cell_reuse.hpp"
#include "core/pipeline/cell_share_reader.hpp"
#include "footfall/run_context.hpp"
#include "footfall/statistics.hpp"

namespace footfall::detail {

/// The filters that run on every cell: tests of single faces, then perhaps a clearance.
struct CellFilters {
  std::vector<std::string> names;  ///< names of the tests, then of the clearance
  std::vector<FaceTest> tests;
  ClearancePass* clearance = nullptr;
};

/// Cells that other processes run.
struct CellsElsewhere {
  CellExchange* exchange = nullptr;  ///< null: there are none
  std::vector<char> isMine;          ///< one flag per cell, once the exchange has begun the pass
  std::shared_ptr<const CellShareReader> reader;
};

/// One phase of a block. Reports are those of the block's cells and grow with each phase.
class BlockRun {
 public:
  /// `walkable`: which triangles are floors before the first test; `floors` may list others. `clock` runs since the run
  /// began.
  BlockRun(const Partition& partition, const CellFloors& floors, const SourceMesh& mesh,
           const std::vector<char>& walkable, CellFilters filters, std::vector<CellReport>& reports,
           const Stopwatch& clock, RunContext& context, CellsElsewhere elsewhere = {});

  /// Runs all cells on the threads of the present arena.
  void run();

  /// The number of tests that each triangle passed in a row.
  [[nodiscard]] const std::vector<std::uint8_t>& passed() const { return passed_; }
  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }
  /// For each cell; to be called when all have run. Without a clearance filter nothing is reused.
  [[nodiscard]] std::vector<CellReuse> reuse() const;
  /// Time that all threads together spent on one of the filters, and on all.
  [[nodiscard]] double workMs(std::size_t filter) const;
  [[nodiscard]] double workMs() const;

 private:
  /// The state of the work behind the shared floors of a cell.
  enum class Rest : std::uint8_t { Unready, Ready, Wanted };
  struct CellState {
    std::vector<Index> floors;  ///< floors that passed all tests
    std::size_t shared = 0;     ///< number of floors, at the front, of which other cells have a part
    std::size_t large = 0;      ///< number of floors, at the front, that are taken one by one
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> left{1};  ///< items that are not done, plus 1 until all of them are known
    std::atomic<bool> open{false};     ///< others may help
    std::atomic<Rest> rest{Rest::Unready};
    std::atomic<std::uint64_t> trianglesOut{0};
    std::mutex mutex;                       ///< guards the report and the following members
    std::vector<Index> smallCut, largeCut;  ///< floors that are clipped and not yet triangulated
    std::vector<FacePart> parts;            ///< parts for other processes
  };
  /// The shares of one face; those on which nothing stands are only counted. Giants have one in each of thousands of
  /// cells.
  struct Shares {
    Index cells = 0;
    Index counted = -1;  ///< the cell whose triangles they are in reports: the first one
    std::atomic<Index> begun{0};
    std::atomic<Index> arrived{0};
    std::mutex mutex;
    std::vector<FaceShare> shares;
  };
  struct Join {
    Index face = -1;
    Index cell = -1;
  };
  /// The record of a thread: its last cell and filter, and the time spent on each filter in all.
  struct ThreadRecord {
    Index cell = -1;
    std::size_t filter = 0;
    std::vector<double> workMs;
  };

  void work();
  void begin(Index cell, int thread);
  void sortOut(CellState& work) const;
  void runRest(Index cell, int thread);
  void runItems(Index cell, int thread);
  bool takeAndRun(Index cell, int thread);
  static bool takeFloors(CellState& work, std::vector<Index>& floors);
  static bool takeCutFloors(CellState& work, std::vector<Index>& floors);
  std::size_t clipFloors(Index cell, const std::vector<Index>& floors, int thread, double startMs);
  std::size_t meshFloors(Index cell, const std::vector<Index>& floors, ClearancePass::Worker& own);
  void clipShare(Index cell, Index face, ClearancePass::Worker& own);
  void addShare(Index cell, Index face, FaceShare share);
  void addJoin(Index cell, Index face);
  void join(const Join& join, int thread);
  bool takeJoin(Join& join);
  [[nodiscard]] Index cellToHelp();
  [[nodiscard]] bool isMine(Index cell) const { return elsewhere_.exchange == nullptr || elsewhere_.isMine[cell] != 0; }
  [[nodiscard]] bool merges() const { return elsewhere_.exchange == nullptr || elsewhere_.exchange->merges(); }
  [[nodiscard]] bool isWholeOf(Index cell, Index face) const;
  bool takeArrived(int thread);
  void addArrived(const ArrivedShare& arrived, int thread);
  void addFaces(Index cell, CellShare& share);
  void addTimes(Index cell, const ShareTimes& times, const ArrivedShare& arrived, int thread);
  void give(Index cell);
  void done(Index cell, std::size_t items);
  void reportItems(std::size_t done) const;
  void record(Index cell, std::size_t filter, int thread, double startMs);
  void finish(Index cell);

  const Partition& partition_;
  const CellFloors& floors_;
  const SourceMesh& mesh_;
  const std::vector<char>& walkable_;
  CellFilters filters_;
  std::vector<CellReport>& reports_;
  const Stopwatch& clock_;
  RunContext& context_;
  CellsElsewhere elsewhere_;

  std::vector<std::size_t> order_;  ///< order of cells: own ones first; those of others only if they are merged here
  std::atomic<std::size_t> ownLeft_{0}, othersToTest_{0};
  std::vector<CellState> cells_;
  std::vector<Index> sharesOf_;  ///< number in shares_ of each face, or -1
  std::vector<Shares> shares_;
  std::vector<std::vector<CellSide>> sides_;  ///< sides of each cell
  std::vector<std::uint8_t> passed_;
  ExactFallbacks fallbacks_;

  std::atomic<std::size_t> nextCell_{0}, nextRest_{0};
  std::atomic<std::size_t> itemsDone_{0};
  std::size_t itemsExpected_ = 0;
  std::vector<std::atomic<Index>> current_;      ///< cell that each thread took last, or -1
  std::vector<ClearancePass::Worker*> workers_;  ///< one per thread
  std::vector<ThreadRecord> records_;            ///< one per thread
  std::mutex mutex_;                             ///< guards the following members
  std::condition_variable changed_;
  std::deque<Join> joins_;
  std::size_t cellsLeft_ = 0;
  bool failed_ = false;
};

}  // namespace footfall::detail
