// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_session.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iostream>

#include "core/environment/part_rules.hpp"
#include "core/io/import.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/errors.hpp"

namespace footfall::app {
using namespace detail;
namespace {

std::size_t enabledSteps(const Pipeline& pipeline) {
  return static_cast<std::size_t>(std::ranges::count(pipeline.steps, true, &PipelineStep::enabled));
}

}  // namespace

CommandSession::CommandSession(int threads, bool quiet, bool showsBar)
    : threads_(threads),
      quiet_(quiet),
      bar_(!quiet && (showsBar || isatty(STDERR_FILENO) != 0)),
      context_([this](const RunEvent& event) { bar_.show(event); }),
      watcher_(context_) {
  if (threads > 0) limit_.emplace(threads);
}

std::shared_ptr<const Environment> CommandSession::load(const EnvironmentOptions& options) {
  begin("loading");
  const auto environment =
      onThreads(threads_, [&](int) { return importEnvironment(options.path, options.import(), &context_); });
  bar_.clear();
  file_ = environment;
  if (!quiet_)
    for (const Text& note : environment->notes) std::cerr << "footfall: note: " << note.str() << '\n';
  auto chosen = applyPartRules(environment, options.rules(*environment));
  if (chosen->triangles.empty())
    throw InputError("--ignore: nothing of " + options.path + " is left; ignore fewer meshes or materials");
  return chosen;
}

RunResult CommandSession::run(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                              const PipelineOptions& options, ResultCache* cache, CellExchange* exchange) {
  begin("starting", enabledSteps(pipeline));
  try {
    if (exchange != nullptr) return runTogether(environment, pipeline, context_, *exchange, threads_);
    return runPipeline(environment, pipeline, context_, cache, threads_);
  } catch (const InputError& error) {
    // The runner has the line, but not the name of the file.
    if (options.file.empty()) throw;
    throw InputError(options.file + ": " + error.what());
  }
}

void CommandSession::runAgents(const std::shared_ptr<const Environment>& environment, std::span<const Agent> agents,
                               const std::function<void(std::size_t agent, const AgentRun& run)>& finished) {
  AgentRunEvents events;
  events.started = [this](std::size_t /*agent*/, const Pipeline& pipeline) {
    begin("starting", enabledSteps(pipeline));
  };
  events.finished = finished;
  footfall::runAgents(environment, agents, context_, events, nullptr, threads_);
}

void print(const std::string& text) {
  errno = 0;
  if ((std::cout << text).flush()) return;
  if (errno == EPIPE) throw RunError("standard output was closed by its reader before all was written");
  throw RunError("standard output cannot be written; check where it leads");
}

}  // namespace footfall::app
