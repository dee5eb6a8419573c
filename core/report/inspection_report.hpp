// Numbers in explanations (footfall/report.hpp has the rest).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace footfall::detail {

/// A value that is known to differ from a limit, with as many digits as it takes to see that; the same text where even
/// 17 do not tell.
std::string textBeside(double value, double limit);

}  // namespace footfall::detail
