// What an export says about how it was made.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/io/export.hpp"
#include "footfall/pipeline.hpp"

namespace footfall::detail {

/// The agent that can walk wherever the enabled steps leave: "slope 45 degrees, height 2" (the environment's units).
/// Where a filter occurs more than once, the strictest counts; "any" where there is no such filter.
std::string describeAgent(const Pipeline& pipeline);

/// The header of an export: the enabled steps and the agent.
ExportHeader makeExportHeader(const Pipeline& pipeline);

}  // namespace footfall::detail
