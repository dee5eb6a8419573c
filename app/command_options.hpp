// Options that several commands of `footfall` have, and what they mean.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/environment/part_rules.hpp"
#include "core/io/write_targets.hpp"
#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run_context.hpp"

namespace footfall::app {

/// The environment, and what of it is meant.
struct EnvironmentOptions {
  std::string path;
  std::string up;  ///< a name of nameOf(UpAxis), or empty
  std::optional<double> metresPerUnit;
  bool bothSides = false;
  std::string grid;  ///< auto, on, off, or a step; empty: auto
  bool withoutImportLimits = false;
  std::vector<std::string> ignored, obstacleOnly, asUsual;  ///< meshes, materials or MESH/MATERIAL

  void addTo(CLI::App& command);
  /// Adds the file's options, without those that leave parts out.
  void addFileTo(CLI::App& command);
  /// Throws InputError for a scale or a step of the grid that is none.
  [[nodiscard]] ImportOptions import() const;
  /// The rules for parts of that environment. Throws InputError for names of none.
  [[nodiscard]] std::vector<detail::PartRule> rules(const Environment& environment) const;
};

/// The pipeline: a file, or steps; neither means the default pipeline.
struct PipelineOptions {
  std::string file;
  std::vector<std::string> steps;  ///< one line of a pipeline file each

  /// The helps of both options, which differ by what the pipeline is for.
  void addTo(CLI::App& command, const std::string& fileHelp, const std::string& stepHelp);
  /// Empty where the default pipeline is meant, which needs the environment's scale. Throws InputError, and
  /// Cancelled while a pipe is waited for.
  [[nodiscard]] std::optional<Pipeline> given(const RunContext* context = nullptr) const;
};

void addThreads(CLI::App& command, int& threads,
                const std::string& help = "Threads to use at most; as many as there are processors by default");
/// `--up` and options like it.
void addUpAxis(CLI::App& command, const std::string& name, std::string& up, const std::string& help);
/// `--part` (from 1; 0 where it is not given) and `--crs`, for polygons.
void addPolygonOptions(CLI::App& command, std::uint32_t& part, std::string& coordinateSystem);
/// A check for options that name a file to write: an empty name is an error and does not mean "no file".
CLI::Validator hasName();
/// An option with three coordinates.
CLI::Option* addPlace(CLI::App& command, const std::string& name, std::array<double, 3>& place,
                      const std::string& help);

/// The files that a command reads and must not overwrite.
detail::WriteTargets targetsBeside(const EnvironmentOptions& environment, const PipelineOptions& pipeline);

}  // namespace footfall::app
