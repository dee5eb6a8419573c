// Names of temporary files, and the removal of files that killed processes have left.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace footfall::detail {

/// A name for a new file of this process, beside its target: ".footfall-HOST-PROCESS-START-NUMBER.tmp". The host
/// distinguishes machines that share a folder, and the start distinguishes processes that had the same number.
std::string temporaryName(unsigned number);

/// Removes temporary files in `folder` whose processes ran on this machine and have ended, once for each folder and
/// process. Files that cannot be removed stay.
void removeStaleFiles(const std::string& folder);

}  // namespace footfall::detail
