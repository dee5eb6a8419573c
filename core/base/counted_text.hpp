// Numbers in sentences for people: "1 layer" and "2 layers", and never "-0.00".
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include "footfall/text.hpp"

namespace footfall::detail {

/// Returns a text that can be translated: `one`, or `many` with the number in its place %1.
inline Text countedText(std::uint64_t n, Pattern one, Pattern many) {
  return n == 1 ? Text(one) : Text(many, Text::count(n));
}

/// Returns English text for output that is never translated: "1 layer", "2 layers".
inline std::string counted(std::uint64_t n, std::string_view one, std::string_view many) {
  return std::to_string(n) + ' ' + std::string(n == 1 ? one : many);
}

/// Formats a number with a printf() format that has one place for a double. A number that is rounded to zero has no
/// sign.
inline std::string formatted(double value, const char* format) {
  std::array<char, 400> buffer;
  std::snprintf(buffer.data(), buffer.size(), format, value);
  std::string text = buffer.data();
  const std::size_t stop = text.find_first_not_of("-0.");
  const bool hasDigit = stop != std::string::npos && text[stop] >= '1' && text[stop] <= '9';
  if (text.starts_with("-0") && !hasDigit) text.erase(0, 1);
  return text;
}

}  // namespace footfall::detail
