// The tables of scenes and turned levels, the worst and the mean first, and what is due for them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/bench/isolated.hpp"

namespace footfall::bench {

/// What is due for the results of measureScenes(), as judgeTargets() gives it. A scene that could not be measured
/// misses everything that is due for it.
Json judgeScenes(const Json& results);

/// The tables as Markdown, for `results` with their `targets`.
std::string formatScenes(const Json& results);

}  // namespace footfall::bench
