// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_session.hpp"

#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "core/base/worker_arena.hpp"
#include "core/environment/part_rules.hpp"
#include "core/io/ifc_reader.hpp"
#include "core/io/import.hpp"
#include "footfall/errors.hpp"

namespace footfall::app {
using namespace detail;
namespace {

/// Nobody walks on the furniture of a building; rules by name come afterwards.
std::vector<PartRule> usualRules(const Environment& environment) {
  std::vector<PartRule> rules;
  for (const EnvironmentPart& part : environment.parts)
    if (isIfcFurniture(part.material)) rules.push_back({part.mesh, part.material, PartRole::ObstacleOnly});
  return rules;
}

}  // namespace

CommandSession::CommandSession(int threads, bool quiet)
    : threads_(threads),
      quiet_(quiet),
      bar_(!quiet && isatty(STDERR_FILENO) != 0),
      context_([this](const RunEvent& event) { bar_.show(event); }),
      watcher_(context_) {
  if (threads > 0) limit_.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
}

std::shared_ptr<const Environment> CommandSession::load(const EnvironmentOptions& options) {
  begin("loading");
  const auto environment =
      onThreads(threads_, [&](int) { return importEnvironment(options.path, options.import(), &context_); });
  if (const Text note = missingIfcConverter(options.path); !quiet_ && !note.empty()) {
    end();
    std::cerr << "footfall: note: " << options.path << ": " << note.str() << '\n';
  }
  std::vector<PartRule> rules = usualRules(*environment);
  const auto add = [&](const std::vector<std::string>& names, PartRole role, const char* option) {
    for (const std::string& name : names) {
      const std::vector<PartRule> named = rulesForName(*environment, name, role, option);
      rules.insert(rules.end(), named.begin(), named.end());
    }
  };
  add(options.obstacleOnly, PartRole::ObstacleOnly, "--obstacle-only");
  add(options.ignored, PartRole::Ignored, "--ignore");
  auto chosen = applyPartRules(environment, rules);
  if (chosen->triangles.empty())
    throw InputError("--ignore: nothing of " + options.path + " is left; ignore fewer meshes or materials");
  return chosen;
}

RunResult CommandSession::run(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                              const PipelineOptions& options, ResultCache* cache) {
  begin("starting", static_cast<std::size_t>(std::ranges::count(pipeline.steps, true, &PipelineStep::enabled)));
  try {
    return runPipeline(environment, pipeline, context_, cache, threads_);
  } catch (const InputError& error) {
    // The runner knows the line, but not the file that it is in.
    if (options.file.empty()) throw;
    throw InputError(options.file + ": " + error.what());
  }
}

void print(const std::string& text) {
  if (!(std::cout << text).flush()) throw RunError("standard output cannot be written; check where it leads");
}

}  // namespace footfall::app
