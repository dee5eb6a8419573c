// Options of the commands that write a walkable area to a file of any format, and the writing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "core/io/write_targets.hpp"
#include "footfall/io.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run_context.hpp"

namespace footfall::app {

struct ExportCommandOptions {
  std::string output;  ///< file in one of exportFormats(); empty: nothing is written
  ExportOptions options;
  std::string up;          ///< a name of nameOf(UpAxis), or empty
  std::uint32_t part = 0;  ///< number from 1; 0: all

  /// Returns the option of the file's name.
  CLI::Option* addTo(CLI::App& command, const std::string& outputHelp = {});
  /// Names of options that mean nothing without a file.
  [[nodiscard]] static const std::vector<std::string>& names();
  /// Turns the parsed options into `options`. Call this when all options are read, and before anything else.
  void finish();
  /// Throws InputError for options that mean nothing to the format, and for a file that must not be replaced.
  void check() const;
};

/// Returns by how much rounding moved coordinates, in metres. Throws what formatExport() and writeFilesSafely() throw,
/// and InputError where a file would be one that `targets` protects.
double writeExport(const ExportCommandOptions& options, const NavigationMesh& mesh, const Pipeline& pipeline,
                   const detail::WriteTargets& targets, const RunContext& context);

/// Prints one line on stderr about the parts of the result that the file does not hold.
void printLosses(const NavigationMesh& mesh, const ExportCommandOptions& options, double error);

}  // namespace footfall::app
