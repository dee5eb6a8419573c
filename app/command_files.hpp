// What commands do with the files that are named: pipelines to read, and files to write.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/io/write_targets.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run_context.hpp"

namespace footfall::app {
using namespace detail;

/// The environment that is named, and what of it is meant.
struct EnvironmentChoice {
  std::string path;
  ImportOptions import;
  /// Meshes, materials or MESH/MATERIAL.
  std::vector<std::string> ignored, obstacleOnly;
};

/// Imports the environment and gives its parts their roles. Throws InputError, also when a name means nothing or
/// nothing is left, or Cancelled.
std::shared_ptr<const Environment> loadEnvironment(const EnvironmentChoice& choice, RunContext* context = nullptr);

/// The pipeline of a file or of steps, one line of a pipeline file each; empty when neither is given and the default
/// pipeline is meant, which needs the environment's scale. Throws InputError.
std::optional<Pipeline> givenPipeline(const std::string& file, const std::vector<std::string>& steps);

/// runPipeline() whose errors name the pipeline's file, where there is one.
RunResult runNamingFile(const std::string& pipelineFile, std::shared_ptr<const Environment> environment,
                        const Pipeline& pipeline, RunContext& context, int threads);

/// What a command reads, which it must not write over.
WriteTargets targetsBeside(const EnvironmentChoice& environment, const std::string& pipelineFile);

}  // namespace footfall::app
