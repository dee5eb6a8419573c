// Writing to what is no file: pipes, terminals, devices.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/base/poll.hpp"

namespace footfall::detail {

/// Opens `path` and writes all of it. Nothing waits without calling `poll` at least every 20 ms: a FIFO for its reader,
/// a full pipe for room. A reader that goes away is an error and no signal. Returns the error number, or 0; throws what
/// `poll` throws.
int writeToPipe(const std::string& path, std::string_view text, const Poll& poll);

/// Reads all of a FIFO or device up to its end, as writeToPipe() waits: a writer may come late and pause. `most`: where
/// it has more bytes than that, reading ends behind them. Returns the error number, or 0.
int readFromPipe(const std::string& path, std::size_t most, std::string& text, const Poll& poll);

}  // namespace footfall::detail
