// Checks what must hold for a random environment with random filters.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/support/pipeline_case.hpp"

namespace footfall::fuzz {

/// The first thing that is wrong, in words; empty when nothing is:
/// - slope and clearance give exactly what the reference says (reference::checkProduct);
/// - so does a longer list of filters that keep the set: nothing twice, conforming, no overlap within a layer;
/// - any list of filters gives the same bytes on one thread, on two and with the input shuffled.
std::string findPipelineError(const PipelineCase& experiment);

}  // namespace footfall::fuzz
