// Messages for exhausted resources: open files, threads, memory, disk.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <optional>

#include "footfall/text.hpp"

namespace footfall::detail {

/// The message for an error of the system or of a library that means an exhausted resource (open files, threads,
/// memory, disk); empty for all other errors. The message names the resource and what to do.
std::optional<Text> exhaustionText(const std::exception& error);

}  // namespace footfall::detail
