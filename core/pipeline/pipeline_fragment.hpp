// A few steps out of a pipeline as text: what is copied from one list and pasted into another.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "footfall/pipeline.hpp"

namespace footfall::detail {

/// Parses as parsePipeline() does, but a strategy without its Collapse (or the other way round) and a global filter
/// between them are no errors here: whether they fit is known when the steps are in their place. Throws InputError
/// "SOURCE:LINE:COLUMN: what; what to do".
Pipeline parsePipelineFragment(std::string_view text, const std::string& source);

}  // namespace footfall::detail
