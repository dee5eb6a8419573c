// Names of files that are only there while they are written, and what is left of them by processes that were killed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace footfall::detail {

/// A name for a new file of this process, beside its target: ".footfall-HOST-PROCESS-START-NUMBER.tmp". The host keeps
/// those of other machines apart, which share a folder, and the start those of a process that had the number before.
std::string temporaryName(unsigned number);

/// Removes the temporary files in `folder` whose processes were on this machine and are gone, once for each folder and
/// process. What cannot be removed stays.
void removeStaleFiles(const std::string& folder);

}  // namespace footfall::detail
