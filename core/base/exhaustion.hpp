// Errors of the system that say that something ran out, as sentences for people.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <optional>

#include "footfall/text.hpp"

namespace footfall::detail {

/// What ran out and what to do, where an error of the system or of a library means that: open files, threads, memory,
/// disk. Empty for all others.
std::optional<Text> exhaustionText(const std::exception& error);

}  // namespace footfall::detail
