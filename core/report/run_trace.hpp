// The timeline of a run for trace viewers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/pipeline/runner.hpp"

namespace footfall::detail {

/// JSON in the Chrome trace event format, which Perfetto and chrome://tracing open: one lane for the run's steps and
/// phases, and one for each thread with the cells that it worked on and their filters inside. Complete events ("X") in
/// microseconds since the run began.
std::string formatTrace(const RunResult& result);

}  // namespace footfall::detail
