// Words and numbers of text formats.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace footfall::detail {

inline void splitWords(std::string_view line, std::vector<std::string_view>& words) {
  words.clear();
  for (std::size_t start = 0; (start = line.find_first_not_of(" \t", start)) != std::string_view::npos;) {
    const std::size_t stop = std::min(line.find_first_of(" \t", start), line.size());
    words.push_back(line.substr(start, stop - start));
    start = stop;
  }
}

/// Returns whether a word consists of digits with at most a sign, a point and an exponent, so few that it cannot be
/// read in two ways.
inline bool isPlainNumber(std::string_view word) {
  constexpr std::size_t kMostDigits = 18;
  const auto skip = [&word](std::string_view characters) {
    const bool found = !word.empty() && characters.find(word[0]) != std::string_view::npos;
    if (found) word.remove_prefix(1);
    return found;
  };
  const auto digits = [&word] {
    const std::size_t count = std::min(word.find_first_not_of("0123456789"), word.size());
    word.remove_prefix(count);
    return count;
  };
  skip("+-");
  const std::size_t whole = digits();
  if (whole == 0 || whole > kMostDigits) return false;
  if (skip(".") && digits() == 0) return false;
  if (!skip("eE")) return word.empty();
  skip("+-");
  const std::size_t exponent = digits();
  return exponent > 0 && exponent < 4 && word.empty();
}

/// The double nearest to a plain number. False where the word is not plain, or too large for a double.
inline bool readNearest(std::string_view word, double& number) {
  if (!isPlainNumber(word)) return false;
  if (word[0] == '+') word.remove_prefix(1);
  const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
  if (read.ec == std::errc::result_out_of_range) number = std::strtod(std::string(word).c_str(), nullptr);
  return std::isfinite(number);
}

/// Reads a number of plain digits only.
template <class Number>
bool readWhole(std::string_view word, Number& number) {
  const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
  return read.ec == std::errc{} && read.ptr == word.data() + word.size();
}

}  // namespace footfall::detail
