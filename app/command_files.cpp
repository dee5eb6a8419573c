// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_files.hpp"

#include <utility>

#include "core/environment/part_rules.hpp"
#include "core/io/import.hpp"
#include "footfall/errors.hpp"

namespace footfall::app {
using namespace detail;

std::shared_ptr<const Environment> loadEnvironment(const EnvironmentChoice& choice, RunContext* context) {
  const auto environment = importEnvironment(choice.path, choice.import, context);
  std::vector<PartRule> rules;
  const auto add = [&](const std::vector<std::string>& names, PartRole role, const char* option) {
    for (const std::string& name : names) {
      const std::vector<PartRule> named = rulesForName(*environment, name, role, option);
      rules.insert(rules.end(), named.begin(), named.end());
    }
  };
  add(choice.obstacleOnly, PartRole::ObstacleOnly, "--obstacle-only");
  add(choice.ignored, PartRole::Ignored, "--ignore");
  auto chosen = applyPartRules(environment, rules);
  if (chosen->triangles.empty())
    throw InputError("--ignore: nothing of " + choice.path + " is left; ignore fewer meshes or materials");
  return chosen;
}

std::optional<Pipeline> givenPipeline(const std::string& file, const std::vector<std::string>& steps) {
  if (!file.empty()) return readPipelineFile(file);
  if (steps.empty()) return std::nullopt;
  std::string text;
  for (const std::string& step : steps) text += step + '\n';
  return parsePipeline(text, "--filter");
}

RunResult runNamingFile(const std::string& pipelineFile, std::shared_ptr<const Environment> environment,
                        const Pipeline& pipeline, RunContext& context, int threads) {
  try {
    return runPipeline(std::move(environment), pipeline, context, nullptr, threads);
  } catch (const InputError& error) {
    // The runner knows the line, but not the file that it is in.
    if (pipelineFile.empty()) throw;
    throw InputError(pipelineFile + ": " + error.what());
  }
}

WriteTargets targetsBeside(const EnvironmentChoice& environment, const std::string& pipelineFile) {
  WriteTargets targets;
  targets.protectEnvironment(environment.path);
  targets.protect(pipelineFile, FOOTFALL_TEXT("the pipeline"));
  return targets;
}

}  // namespace footfall::app
