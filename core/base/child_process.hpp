// Another program that reads or writes what Footfall does not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/base/poll.hpp"

namespace footfall::detail {

/// What a program may use before it is ended. Its resident memory is watched; its address space has no limit.
struct ChildLimits {
  double wallMs = std::numeric_limits<double>::infinity();
  std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();  ///< resident; and of its output
};
enum class ChildEnd { Itself, Time, Memory };

struct ChildResult {
  int status = 0;                   ///< exit status; 128 + n when signal n ended it; 127 when it could not be started
  std::string output;               ///< what it wrote to standard output
  std::string errors;               ///< the same of standard error, 64 KiB at most
  ChildEnd end = ChildEnd::Itself;  ///< the limit that it was ended for; then there is no status
};

/// How a program ends that is not waited for any more.
enum class ChildEnding {
  Killed,  ///< at once
  Asked    ///< it is asked to end, and killed when it has not done so in time
};
constexpr double kChildGraceMs = 5000;  ///< the time for that

/// Runs `arguments[0]`, looked for in PATH, with the others and without input, and waits for its end. `poll` is called
/// at least every 20 ms; what it throws ends the program first, as `ending` says, and those that it has started and
/// that stayed in its group of processes. A program beyond `limits` is killed, too. Throws RunError when the system
/// gives no pipe or no process.
ChildResult runChild(const std::vector<std::string>& arguments, Poll poll, ChildEnding ending = ChildEnding::Killed,
                     double graceMs = kChildGraceMs, const ChildLimits& limits = {});

}  // namespace footfall::detail
