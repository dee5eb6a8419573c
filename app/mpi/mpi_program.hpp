// `footfall-mpi run`: as `footfall run`, by several processes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/mpi/mpi_transport.hpp"
#include "app/run_program.hpp"
#include "core/base/process_usage.hpp"

namespace footfall::app {

class MpiProgram : public RunProgram {
 public:
  ~MpiProgram() override;

  void addOptions(CLI::App& command) override;
  void begin(int threads) override;
  /// Replaces run() for the command `cells`: leaves the shares of a job in its folder. Calls all of the above and
  /// end().
  void runCells(const std::string& job, int threads);
  [[nodiscard]] bool showsProgress() const override { return showsProgress_; }
  void setContext(RunContext* context) override;
  [[nodiscard]] bool isForOnePipeline() const override { return true; }
  [[nodiscard]] bool writes() const override { return transport_->rank() == 0; }
  [[nodiscard]] detail::RankGroup* group() override { return exchange_.get(); }
  void dropAtEnd(std::shared_ptr<void> thing) override { dropped_.push_back(std::move(thing)); }
  RunResult run(CommandSession& session, const std::shared_ptr<const Environment>& environment,
                const Pipeline& pipeline, const PipelineOptions& options, double loadMs) override;
  std::string statistics(std::string json) override;
  std::string trace(std::string json) override;
  std::string summary(std::string text) override;
  void end() override;

  /// True when this process is rank 0, judged before MPI is there by the variables of the starting program. Wrong
  /// options are then reported once.
  [[nodiscard]] static bool isFirstByName();
  /// The command failed: notifies the other ranks. Returns true when this process has to report to the user.
  bool fail(const std::string& problem, detail::RankFailure kind);
  /// The rank that failed, and the reason, if that ended the run.
  [[nodiscard]] std::optional<std::string> failure() const;
  /// True when it failed because of wrong input.
  [[nodiscard]] bool failedByInput() const;
  /// True when the exit code of this process counts: that of rank 0, of a rank that rank 0 does not answer, or of any
  /// before there are ranks.
  [[nodiscard]] bool hasExitCode() const { return !transport_ || writes() || (exchange_ && exchange_->isCutOff()); }
  /// The command is over: waits for the other ranks, or ends them all where one does not answer. Behind that, the
  /// process has nothing to do but to return `exitCode`.
  void leave(int exitCode);

 private:
  void tell(const Text& note) const;
  void meetOthers();
  void drop();
  [[nodiscard]] double overheadMs() const;

  const detail::Stopwatch total_{};
  std::string workFolder_;
  bool leavesShares_ = false;
  bool isBegun_ = false;
  bool showsProgress_ = false;
  std::unique_ptr<MpiTransport> transport_;
  std::unique_ptr<detail::RankExchange> exchange_;
  std::mutex contextMutex_;
  RunContext* context_ = nullptr;  ///< context of the run, as long as it lives
  std::atomic<bool> isStopped_{false};
  std::vector<std::shared_ptr<void>> dropped_;
  std::vector<detail::RankStatistics> ranks_;
  double mergingMs_ = 0;
};

}  // namespace footfall::app
