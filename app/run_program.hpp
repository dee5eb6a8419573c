// The differences between programs that have the command `run`.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "app/command_session.hpp"
#include "core/distributed/rank_group.hpp"

namespace footfall::app {

/// The base is `footfall run`. The functions are called in their order, once each.
class RunProgram {
 public:
  RunProgram() = default;
  virtual ~RunProgram() = default;
  RunProgram(const RunProgram&) = delete;
  RunProgram& operator=(const RunProgram&) = delete;

  /// Adds options behind those of the command itself.
  virtual void addOptions(CLI::App& /*command*/) {}
  /// Called before anything is read.
  virtual void begin(int /*threads*/) {}
  /// True when progress is shown even if standard error is no terminal.
  [[nodiscard]] virtual bool showsProgress() const { return false; }
  /// Sets the context of the run that follows; null: it is over.
  virtual void setContext(RunContext* /*context*/) {}
  /// True when it runs one pipeline only.
  [[nodiscard]] virtual bool isForOnePipeline() const { return false; }
  /// False when another process prints and writes the results.
  [[nodiscard]] virtual bool writes() const { return true; }
  /// The processes that share a run within a bound of memory; null: there are no others.
  [[nodiscard]] virtual detail::RankGroup* group() { return nullptr; }
  /// Drops what the run must leave behind it: at once, or where other processes work with it, when all of them are
  /// over.
  virtual void dropAtEnd(std::shared_ptr<void> /*thing*/) {}
  /// The result's mesh may be null in a process that does not write.
  virtual RunResult run(CommandSession& session, const std::shared_ptr<const Environment>& environment,
                        const Pipeline& pipeline, const PipelineOptions& options, double /*loadMs*/) {
    return session.run(environment, pipeline, options);
  }
  // The texts that are written, or printed, about a run:
  virtual std::string statistics(std::string json) { return json; }
  virtual std::string trace(std::string json) { return json; }
  virtual std::string summary(std::string text) { return text; }
  /// Everything is written.
  virtual void end() {}
};

}  // namespace footfall::app
