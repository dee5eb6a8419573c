// Errors that a user can cause. Each message says what, where and what to do, in one line.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace footfall {

/// A file, a pipeline or a parameter is wrong (exit code 2 of the command line).
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The result cannot be written, or memory or disk ran out (exit code 1).
struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The user cancelled the run (exit code 1). Nothing is lost.
struct Cancelled : std::runtime_error {
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace footfall
