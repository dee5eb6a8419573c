// Running other programs, which read or write formats that Footfall itself does not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/base/poll.hpp"

namespace footfall::detail {

/// The limits of a program, which is ended when it passes one. Its resident memory is watched; its address space has no
/// limit.
struct ChildLimits {
  double wallMs = std::numeric_limits<double>::infinity();
  std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();  ///< bound of resident memory, and of output
};
enum class ChildEnd { Itself, Time, Memory };

struct ChildResult {
  int status = 0;      ///< exit status; 128 + n when signal n ended the program; 127 when it could not be started
  std::string output;  ///< standard output
  std::string errors;  ///< standard error, 64 KiB at most
  ChildEnd end = ChildEnd::Itself;  ///< the limit that the program passed; there is no status then
};

/// How a program is ended when its result is no longer needed.
enum class ChildEnding {
  Killed,  ///< at once
  Asked    ///< it receives SIGTERM, and is killed when it has not ended in time
};
constexpr double kChildGraceMs = 5000;  ///< time that an ending program gets

/// Runs `arguments[0]`, looked for in PATH, with the other arguments and without input, and waits for its end. `poll`
/// is called at least every 20 ms; when it throws, the program and the processes of its group are ended first, as
/// `ending` says. A program that passes `limits` is killed. Throws RunError when the system gives no pipe or no
/// process.
ChildResult runChild(const std::vector<std::string>& arguments, Poll poll, ChildEnding ending = ChildEnding::Killed,
                     double graceMs = kChildGraceMs, const ChildLimits& limits = {});

}  // namespace footfall::detail
