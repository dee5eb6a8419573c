// A pipeline: an ordered list of filters with parameters, and its text form (the thesis's files, 5.4).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "footfall/environment.hpp"
#include "footfall/text.hpp"

namespace footfall {

struct FilterDescriptor;
struct ParameterDescriptor;

/// A filter with its parameters.
struct PipelineStep {
  const FilterDescriptor* filter = nullptr;
  /// One for each parameter of the descriptor (FilterDescriptor::takes()); lengths in the environment's units, places
  /// in the file's frame.
  std::vector<double> values;
  bool enabled = true;         ///< the editor can switch a step off; in text a disabled step is a comment
  int line = 0;                ///< line in a file, 1-based; 0 when it came from elsewhere
  std::vector<int> columns{};  ///< columns of the values in that line, 1-based, for messages; may be empty or too short
  bool operator==(const PipelineStep& o) const {
    return filter == o.filter && values == o.values && enabled == o.enabled;
  }
};

/// Filters in the order in which they run.
struct Pipeline {
  std::vector<PipelineStep> steps;
  bool operator==(const Pipeline&) const = default;
};

/// Parses a pipeline: one filter a line, name then parameters, `#` comments. `source` names the text in messages.
/// Throws InputError "SOURCE:LINE:COLUMN: what; what to do" on an unknown name, a wrong number of parameters, a value
/// out of range, a global filter inside a parallel block, or a strategy and Collapse that do not match.
Pipeline parsePipeline(std::string_view text, const std::string& source);

/// Reads and parses a file. Throws InputError.
Pipeline readPipelineFile(const std::string& path);

/// The text form; parsePipeline gives the same pipeline back. Values are the shortest text that reads back equal.
std::string formatPipeline(const Pipeline& pipeline);
/// One line of it, without its end.
std::string formatStep(const PipelineStep& step);

/// A step with default values, lengths and areas converted from metres to the environment's units; without any of the
/// groups that repeat.
PipelineStep defaultStep(const FilterDescriptor& filter, double metresPerUnit);

/// Checks values against the descriptor; returns an empty text when valid, else what is wrong and what to do.
Text checkValue(const ParameterDescriptor& parameter, double value);

/// Duplication 0, degeneracy, slope 45, clearance 2 m, steps of 0.4 m, area, simplification, layers, in the
/// environment's units.
Pipeline defaultPipeline(const Environment& environment);

}  // namespace footfall
