// Words and numbers of text formats, read as Assimp reads them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <assimp/fast_atof.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
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

/// Whether a word is digits with a sign, a point and an exponent at most, as few as nobody can read in two ways.
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

/// What Assimp throws where there is no number, which isPlainNumber() keeps from happening.
struct NoPlainNumber {
  template <class... Words>
  explicit NoPlainNumber(Words&&... /*words*/) {}
};

/// The number that Assimp makes of a word: not always the nearest one. False where the word is not plain. Something
/// that is no digit must follow the word in memory.
template <class Number>
bool readAsAssimp(std::string_view word, Number& number) {
  if (!isPlainNumber(word)) return false;
  Assimp::fast_atoreal_move<Number, NoPlainNumber>(word.data(), number);
  return std::isfinite(number);
}

/// Plain digits, nothing else.
template <class Number>
bool readWhole(std::string_view word, Number& number) {
  const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
  return read.ec == std::errc{} && read.ptr == word.data() + word.size();
}

}  // namespace footfall::detail
