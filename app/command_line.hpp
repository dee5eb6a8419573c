// The command line: options are read here, the work is done in core.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace footfall::app {

/// Reads the arguments and runs the command; results go to stdout and to the given files. Returns when done. Throws
/// InputError (usage or input), RunError or Cancelled.
void runCommandLine(int argc, const char* const* argv);

}  // namespace footfall::app
