// Checks what must hold for a random environment with random filters.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/support/pipeline_case.hpp"

namespace footfall::fuzz {

/// Describes the first error; empty when there is none:
/// - slope and clearance give exactly the result of the reference (reference::checkProduct);
/// - a longer list of filters that keep the set does too: no duplicates, conforming, no overlap within a layer;
/// - any list of filters gives the same bytes on one thread, on two and with the input shuffled.
std::string findPipelineError(const PipelineCase& experiment);

}  // namespace footfall::fuzz
