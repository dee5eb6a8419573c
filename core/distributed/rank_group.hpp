// The messages between processes that share one run, whatever the run is.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "footfall/run_context.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// Why a rank ended a run: what it was given is wrong, it was cancelled, or anything else.
enum class RankFailure : char { Run, Input, Cancelled };

/// Ranks from 0 on. All of them call the same functions in the same order, each on one thread; only the number of calls
/// of nextTask() differs between ranks. Functions that wait throw Cancelled, and the error of another rank.
class RankGroup {
 public:
  RankGroup() = default;
  virtual ~RankGroup() = default;
  RankGroup(const RankGroup&) = delete;
  RankGroup& operator=(const RankGroup&) = delete;

  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;
  [[nodiscard]] bool isFirst() const { return rank() == 0; }
  /// True on rank 0 when another rank has failed and was not cancelled.
  [[nodiscard]] virtual bool hasFailed() const { return false; }

  /// Rank 0 returns what all gave, by rank; others return nothing, at once.
  virtual std::vector<std::string> gather(std::string own, RunContext& context) = 0;
  /// Returns what rank 0 gave.
  virtual std::string fromFirst(std::string own, RunContext& context) = 0;
  /// Begins tasks 0, 1, ... below `count`, which is the same for all ranks.
  virtual void beginTasks(std::size_t count) = 0;
  /// A task that no rank has, mostly the one behind that of before; empty when there is none. Until then the rank calls
  /// no other function of these.
  virtual std::optional<std::size_t> nextTask(RunContext& context) = 0;
};

/// A process by itself.
class OneRank : public RankGroup {
 public:
  [[nodiscard]] int rank() const override { return 0; }
  [[nodiscard]] int size() const override { return 1; }
  std::vector<std::string> gather(std::string own, RunContext& /*context*/) override { return {std::move(own)}; }
  std::string fromFirst(std::string own, RunContext& /*context*/) override { return own; }
  void beginTasks(std::size_t count) override {
    next_ = 0;
    count_ = count;
  }
  std::optional<std::size_t> nextTask(RunContext& /*context*/) override {
    return next_ < count_ ? std::optional(next_++) : std::nullopt;
  }

 private:
  std::size_t next_ = 0, count_ = 0;
};

/// The message of a rank whose input differs from that of rank 0.
inline Text differsFromFirst() {
  return Text(
      FOOTFALL_TEXT("this rank has other inputs than rank 0: another file of the environment, another pipeline or "
                    "another version of the program; give all ranks the same"));
}

}  // namespace footfall::detail
