// The results as Markdown tables.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/bench/isolated.hpp"

namespace footfall::bench {

/// Formats results as runBenchmark() returns them, with the `targets` of judgeTargets().
std::string formatReport(const Json& results);

/// The table of what is due and what was measured.
std::string formatTargets(const Json& targets);

}  // namespace footfall::bench
