// A run whose cells other processes run: it takes their shares from a folder as they come.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "core/base/poll.hpp"
#include "core/base/process_usage.hpp"
#include "core/distributed/cell_exchange.hpp"
#include "core/distributed/job_folder.hpp"
#include "core/distributed/work_folder.hpp"

namespace footfall::detail {

/// One object for one run. The processes are started when there are cells to run, and not before: a run that finds
/// everything in a cache needs none.
class FolderExchange : public CellExchange {
 public:
  struct Options {
    /// The folder that all processes see. It is made here (its parents are not) and removed with its content at the
    /// end.
    std::string folder;
    int threads = 1;  ///< threads of this process
    /// Starts the processes, waits for their end, and returns an error; empty: none. Called on a thread of its own. It
    /// must call `poll` regularly; `poll` throws when the run is over, which ends the processes: Cancelled where their
    /// results are not wanted, another std::exception where all have arrived.
    std::function<Text(const std::string& folder, Poll poll)> work;
    /// Called by begin() with the number of threads of each process (threadsOfRanks()).
    std::function<void(const std::vector<int>&)> ranksKnown = [](const std::vector<int>&) {};
    /// The longest time that shares may be under way after their process has ended: network folders are slow.
    double patienceMs = 10000;
    /// The longest time from the written job until its processes have begun (sayBegun()); 0: no limit.
    double startMs = 0;
  };
  explicit FolderExchange(Options options);
  /// Ends the processes.
  ~FolderExchange() override;
  FolderExchange(const FolderExchange&) = delete;
  FolderExchange& operator=(const FolderExchange&) = delete;

  std::vector<char> begin(const CellPhase& phase, RunContext& context) override;
  [[nodiscard]] bool merges() const override { return true; }
  [[nodiscard]] bool wantsOwn() const override { return false; }
  void give(Index /*cell*/, std::string /*bytes*/) override {}
  std::optional<ArrivedShare> take() override;
  void ownFinished() override {}
  void throwFailure() const override;
  [[nodiscard]] int threads() const override;

  /// The number of threads of each process, by rank; empty while no cells were to be run. In reports they are numbered
  /// behind those of this process.
  [[nodiscard]] std::vector<int> threadsOfRanks() const;

 private:
  void start();
  void checkFailed() const;
  void awaitRanks(std::unique_lock<std::mutex>& lock, RunContext& context);
  void look();
  /// The time (by clock_) of the next look into the folder, given that the last one began at `begunMs`.
  [[nodiscard]] double nextLook(double begunMs, double atLeastMs) const;

  Options options_;
  std::optional<WorkFolder> folder_;
  CellPhase phase_;
  double beganMs_ = 0;  ///< start of this run by the system's clock

  mutable std::mutex mutex_;  ///< guards all that follows
  std::condition_variable changed_;
  std::vector<JobRank> ranks_;
  std::vector<int> rankOf_;    ///< rank of each cell of the pass
  std::vector<char> hasCome_;  ///< likewise
  std::size_t left_ = 0;       ///< cells of the pass that did not come
  std::set<Index> seen_;       ///< cells whose file is there, to be read
  double nextLookMs_ = 0;      ///< earliest next look, by clock_
  double endedMs_ = -1;        ///< time by clock_ at which all processes had ended
  Text failure_;
  bool isStopping_ = false;
  const Stopwatch clock_;
  std::thread worker_;
};

}  // namespace footfall::detail
