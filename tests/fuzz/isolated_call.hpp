// Calling something that may crash or hang, in a process of its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace footfall::fuzz {

/// The result of the call, or in words how its process ended: by a signal, by an exit code that is not 0, or killed
/// because it took longer than `limit`. With `quiet`, what it prints to standard error is dropped. Call this from a
/// process with one thread only.
std::string callIsolated(const std::function<std::string()>& call, std::chrono::seconds limit, bool quiet);

}  // namespace footfall::fuzz
