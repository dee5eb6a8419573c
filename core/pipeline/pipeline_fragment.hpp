// A few steps out of a pipeline as text: what is copied from one list and pasted into another. And reading pipelines
// from pipes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "footfall/pipeline.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Parses as parsePipeline() does, but a strategy without its Collapse (or the other way round) and a global filter
/// between them are no errors here: whether they fit is known when the steps are in their place. Throws InputError
/// "SOURCE:LINE:COLUMN: what; what to do".
Pipeline parsePipelineFragment(std::string_view text, const std::string& source);

/// readPipelineFile(), of a pipe as well. Throws Cancelled when `context` (may be null) was cancelled, as while nobody
/// writes.
Pipeline readPipeline(const std::string& path, const RunContext* context);

}  // namespace footfall::detail
