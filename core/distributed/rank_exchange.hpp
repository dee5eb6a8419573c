// The exchange of shares between ranks: processes that run the same pipeline over the same environment, of which rank 0
// goes on behind the last block (thesis 4.1.1; algorithm 4 in 5.7).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/base/process_usage.hpp"
#include "core/distributed/cell_exchange.hpp"
#include "core/distributed/group_mail.hpp"
#include "core/distributed/rank_group.hpp"
#include "core/distributed/rank_messages.hpp"
#include "core/distributed/work_folder.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// The interface that carries messages. All functions are called by one thread, and return at once.
class Transport {
 public:
  struct Message {
    int from = 0;
    std::string bytes;
  };

  virtual ~Transport() = default;
  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;
  /// Messages between two ranks arrive in their order.
  virtual void send(int to, std::string bytes) = 0;
  virtual std::optional<Message> receive() = 0;
  /// True when everything was sent.
  virtual bool isIdle() = 0;
};

/// One object for one run. Its thread sends and receives; Transport is used by that thread only.
class RankExchange : public CellExchange, public RankGroup {
 public:
  struct Options {
    int threads = 1;         ///< threads of this rank
    double startUpMs = 0;    ///< see RankStatistics
    std::string workFolder;  ///< empty: none
    /// The shares stay in the work folder for another process, which has made it and goes on (FolderExchange); no rank
    /// does.
    bool leavesShares = false;
    /// The longest time that an ending rank waits for the good-bye of the others, before isCutOff().
    double patienceMs = 10000;
    /// Receives notes for the user; called by any thread.
    std::function<void(const Text&)> note = [](const Text&) {};
    /// Called by the exchange's thread when another rank ended the run.
    std::function<void()> stop = [] {};
  };
  /// Throws RunError when the work folder cannot be had.
  RankExchange(Transport& transport, Options options);
  /// Ends the run as a failure unless it has ended.
  ~RankExchange() override;
  RankExchange(const RankExchange&) = delete;
  RankExchange& operator=(const RankExchange&) = delete;

  void setReadingMs(double ms) { own_.readingMs = ms; }

  std::vector<char> begin(const CellPhase& phase, RunContext& context) override;
  [[nodiscard]] bool merges() const override { return !phase_.isLast() || (rank_ == 0 && !options_.leavesShares); }
  [[nodiscard]] bool wantsOwn() const override;
  void give(Index cell, std::string bytes) override;
  std::optional<ArrivedShare> take() override;
  void ownFinished() override;
  void throwFailure() const override;
  [[nodiscard]] int threads() const override;

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return size_; }
  [[nodiscard]] bool hasFailed() const override;
  std::vector<std::string> gather(std::string own, RunContext& context) override;
  std::string fromFirst(std::string own, RunContext& context) override;
  void beginTasks(std::size_t count) override;
  std::optional<std::size_t> nextTask(RunContext& context) override;

  /// The statistics of all ranks, by rank. Rank 0 waits for them; other ranks return their own only and send them to
  /// rank 0.
  std::vector<RankStatistics> collect(RunContext& context);
  /// Rank 0: the run ended well, and its shares are not needed any more. Others: waits for the end message of rank 0.
  /// Throws RunError or Cancelled.
  void end(RunContext& context);
  /// Ends the run for all ranks: with `problem`, which rank 0 reports, or because it was cancelled.
  void fail(const std::string& problem, RankFailure kind = RankFailure::Run) noexcept;
  /// True when another rank ended the run; this rank then reports nothing.
  [[nodiscard]] bool wasStopped() const;
  /// The rank that failed first, and the reason; none while none has failed.
  [[nodiscard]] std::optional<std::string> failure() const;
  /// True when it failed because of wrong input.
  [[nodiscard]] bool failedByInput() const;
  /// After end() or fail(): true when another rank stopped answering.
  [[nodiscard]] bool isCutOff() const;

 private:
  enum class Kind : char { Hello, Plan, Share, Done, Failed, End, Stop, Bye, Group };
  using Hello = RankHello;
  using Plan = RankPlan;
  struct Failure {
    int rank = 0;
    std::string problem;
    RankFailure kind = RankFailure::Run;
  };
  struct Incoming {
    int from = -1;  ///< -1: the folder
    ShareName name;
    std::string sealed;
  };

  void pump();
  bool sendOutgoing();
  bool receiveAll();
  void close() noexcept;
  void handle(const Transport::Message& message);
  void post(int to, std::string bytes);
  void postToOthers(const std::string& bytes);
  /// Waits until `ready` holds; throws what ended the run meanwhile. `lock` holds mutex_.
  void wait(std::unique_lock<std::mutex>& lock, RunContext& context, const std::function<bool()>& ready);
  void checkFailed() const;
  void failHere(Failure failure);
  [[noreturn]] static void throwAs(const Failure& failure);
  [[noreturn]] void throwDiffers(int rank) const;
  void greet(const CellPhase& phase);
  Plan makePlan(std::unique_lock<std::mutex>& lock, const CellPhase& phase, RunContext& context);
  void sendPlan(const Plan& plan);
  void sayRanks(const Plan& plan) const;
  Plan awaitPlan(std::unique_lock<std::mutex>& lock, const CellPhase& phase, RunContext& context);
  [[nodiscard]] std::vector<char> schedule(const Plan& plan) const;

  Transport& transport_;
  const int rank_, size_;
  Options options_;
  std::optional<WorkFolder> folder_;
  CellPhase phase_;
  std::vector<Hello> ranks_;
  std::vector<Digest::Value> keys_;  ///< keys of all passes so far
  const Stopwatch clock_;

  mutable std::mutex mutex_;  ///< guards all that follows
  RankStatistics own_;
  double phaseMs_ = 0, finishedMs_ = 0;  ///< times by clock_ at which the pass began and the own cells were done
  std::size_t cellsExpected_ = 0;        ///< cells of other ranks that have not arrived
  std::condition_variable changed_;
  std::deque<std::pair<int, std::string>> outgoing_;
  std::vector<std::optional<Hello>> hellos_;
  std::deque<Plan> plans_;
  std::deque<Incoming> shares_;
  std::vector<std::optional<RankStatistics>> done_;
  std::optional<Failure> failure_;
  GroupMail group_;
  bool hasPlanned_ = false;
  std::size_t byes_ = 0;  ///< other ranks that say nothing more
  bool isEnded_ = false, isStopped_ = false, isClosing_ = false, isCutOff_ = false, folderFails_ = false;
  std::thread pump_;
};

}  // namespace footfall::detail
