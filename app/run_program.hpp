// What programs that have the command `run` do differently.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "app/command_session.hpp"

namespace footfall::app {

/// As it stands, `footfall run`. The functions are called in their order, once each.
class RunProgram {
 public:
  RunProgram() = default;
  virtual ~RunProgram() = default;
  RunProgram(const RunProgram&) = delete;
  RunProgram& operator=(const RunProgram&) = delete;

  virtual void addOptions(CLI::App& /*command*/) {}
  /// Whether it can run within a bound of memory, by itself.
  [[nodiscard]] virtual bool hasBound() const { return true; }
  /// Nothing is read yet.
  virtual void begin(int /*threads*/) {}
  /// Whether progress is shown where standard error is no terminal, too.
  [[nodiscard]] virtual bool showsProgress() const { return false; }
  /// That of the run that follows; null: it is over.
  virtual void setContext(RunContext* /*context*/) {}
  /// False: another process tells and writes what there is.
  [[nodiscard]] virtual bool writes() const { return true; }
  /// The result's mesh may be null in a process that does not write.
  virtual RunResult run(CommandSession& session, const std::shared_ptr<const Environment>& environment,
                        const Pipeline& pipeline, const PipelineOptions& options, double /*loadMs*/) {
    return session.run(environment, pipeline, options);
  }
  // What is written, or printed, of a run.
  virtual std::string statistics(std::string json) { return json; }
  virtual std::string trace(std::string json) { return json; }
  virtual std::string summary(std::string text) { return text; }
  /// Everything is written.
  virtual void end() {}
};

}  // namespace footfall::app
