// A few steps out of a pipeline as text: what is copied from one list and pasted into another. And reading pipelines
// from pipes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "footfall/pipeline.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Parses as parsePipeline() does, except that a strategy without its Collapse (or the reverse) and a global filter
/// between them are no errors: they can only be checked when the steps are in their place. Throws InputError
/// "SOURCE:LINE:COLUMN: what; what to do".
Pipeline parsePipelineFragment(std::string_view text, const std::string& source);

/// Reads a pipeline as readPipelineFile() does, also from a pipe. Throws Cancelled when `context` (may be null) was
/// cancelled, also while a pipe has no writer.
Pipeline readPipeline(const std::string& path, const RunContext* context);

}  // namespace footfall::detail
