// Tables for people to read in a terminal.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace footfall::detail {

/// Rows of equal length, the first with the titles. Columns as wide as their widest cell; the first to the left, the
/// others but the last to the right.
std::string formatTable(const std::vector<std::vector<std::string>>& rows);

}  // namespace footfall::detail
