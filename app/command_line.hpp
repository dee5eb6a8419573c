// What the user typed: options are read here, the work is done in core.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace footfall::app {

/// Reads the arguments and does what they ask for; results go to stdout and to the files that are named. Returns when
/// done. Throws InputError (usage or input), RunError or Cancelled.
void runCommandLine(int argc, const char* const* argv);

}  // namespace footfall::app
