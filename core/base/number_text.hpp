// Numbers as text that reads back to the same number, in any locale.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <concepts>
#include <string>

namespace footfall::detail {

/// Appends the shortest decimal text that reads back to the same double; zero of either sign is "0".
inline void appendNumber(std::string& text, double value) {
  char buffer[32];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value + 0.0).ptr);
}

inline void appendNumber(std::string& text, std::integral auto value) {
  char buffer[24];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

}  // namespace footfall::detail
