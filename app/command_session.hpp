// The objects that every command of `footfall` needs while it works.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "app/command_options.hpp"
#include "app/interrupt_watcher.hpp"
#include "app/progress_bar.hpp"
#include "core/base/worker_arena.hpp"
#include "core/distributed/cell_exchange.hpp"
#include "footfall/agent_list.hpp"
#include "footfall/run.hpp"

namespace footfall::app {

/// A progress bar on a terminal's stderr, a context that SIGINT and SIGTERM cancel, and a limit for threads. Its
/// functions throw InputError, RunError or Cancelled.
class CommandSession {
 public:
  /// `threads` 0: as many as the machine has. `showsBar`: the bar needs no terminal.
  explicit CommandSession(int threads = 0, bool quiet = false, bool showsBar = false);

  [[nodiscard]] RunContext& context() { return context_; }

  /// The progress bar starts again for a task of `steps` steps and an ending.
  void begin(const std::string& task, std::size_t steps = 0) { bar_.begin(task, steps); }
  /// Wipes the progress bar.
  void end() { bar_.clear(); }

  /// Imports the environment and gives its parts their roles. InputError also when a name means nothing or nothing is
  /// left.
  std::shared_ptr<const Environment> load(const EnvironmentOptions& options);
  /// Runs the pipeline, with `exchange` as runTogether(); errors name its file.
  RunResult run(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                const PipelineOptions& options, ResultCache* cache = nullptr, detail::CellExchange* exchange = nullptr);
  /// Runs the agents as footfall::runAgents() does, and calls `finished` with each.
  void runAgents(const std::shared_ptr<const Environment>& environment, std::span<const Agent> agents,
                 const std::function<void(std::size_t agent, const AgentRun& run)>& finished);

 private:
  int threads_;
  bool quiet_;
  std::optional<detail::ThreadLimit> limit_;
  ProgressBar bar_;
  RunContext context_;
  std::shared_ptr<const Environment> file_;  ///< environment as read: floor plans look for its doors
  InterruptWatcher watcher_;
};

/// Writes to stdout. Throws RunError when that fails.
void print(const std::string& text);

}  // namespace footfall::app
