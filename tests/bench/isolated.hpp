// Measuring in a process of its own: what it allocates, breaks or never ends stays there.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace footfall::bench {

using Json = nlohmann::ordered_json;

struct Limits {
  std::chrono::seconds time{300};
  std::uint64_t memoryBytes = 0;  ///< address space beyond what the process has at its start; 0: no limit
};

/// Forks, runs `work` in the child and returns what it gives. When it throws, crashes or exceeds a limit the result is
/// {"fails": "why"}. The caller must not have started any threads yet: a fork has only the thread that called it.
Json runIsolated(const std::function<Json()>& work, const Limits& limits = {});

/// Runs a program with its standard output read; returns {"output": text, "peak_bytes": n}, or {"fails": "why"}.
Json runProgram(const std::vector<std::string>& command, const Limits& limits = {});

/// The measurements in `results` that have {"fails": "why"} in the place of their figures, a line each: the name of the
/// environment, the keys that lead there, and the reason. Those of Recast are left out: its failures are findings.
std::vector<std::string> failuresIn(const Json& results);

/// Writes these lines to standard error after the name of the program. Returns the exit code: 1 when there are any.
int reportFailures(const std::string& program, const Json& results);

/// The memory of this process in bytes: what it holds now, and the most it ever held.
struct ResidentMemory {
  std::uint64_t now = 0, peak = 0;
};
ResidentMemory residentMemory();

}  // namespace footfall::bench
