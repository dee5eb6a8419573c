// The thesis's experiments as Markdown tables.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/bench/isolated.hpp"

namespace footfall::bench {

/// Formats results as runThesisExperiments() returns them.
std::string formatThesisReport(const Json& results);

}  // namespace footfall::bench
