// Writing to pipes, terminals and devices.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/base/poll.hpp"

namespace footfall::detail {

/// Opens `path` and writes all of the text. Every wait calls `poll` at least every 20 ms: the wait for a FIFO's reader,
/// and for room in a full pipe. A closed pipe is an error and sends no signal. Returns the error number, or 0; throws
/// what `poll` throws.
int writeToPipe(const std::string& path, std::string_view text, const Poll& poll);

/// Reads all of a FIFO or device up to its end. It waits as writeToPipe() does: a writer may come late and pause.
/// Reading ends behind `most` bytes where there are more. Returns the error number, or 0.
int readFromPipe(const std::string& path, std::size_t most, std::string& text, const Poll& poll);

}  // namespace footfall::detail
