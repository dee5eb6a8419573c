// Sentences for people that can be translated: an English pattern and what stands in its places.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace footfall {

/// An English sentence with places %1 to %9, in the program for as long as it runs. FOOTFALL_TEXT marks those that have
/// words to translate; patterns of punctuation alone are made without it.
struct Pattern {
  const char* english;
};

/// A pattern that translators get to see (translations/update.sh looks for this name). Takes string literals only.
#define FOOTFALL_TEXT(literal) (::footfall::Pattern{literal})

/// A sentence or a part of one: either a pattern with a text for each of its places, or a plain text that is the same
/// in all languages, such as a name, a number or a message of another library.
class Text {
 public:
  Text() = default;
  // A plain text; placeholders in it stay as they are.
  Text(std::string plain) : pattern_(std::move(plain)) {}
  Text(std::string_view plain) : pattern_(plain) {}
  Text(const char* plain) : pattern_(plain) {}
  Text(std::integral auto number) : pattern_(std::to_string(number)) {}
  Text(Pattern pattern) : pattern_(pattern.english), isPattern_(true) {}
  /// `arguments` are for %1, %2 and so on: texts, strings or integers.
  template <class... Arguments>
  requires(sizeof...(Arguments) > 0) Text(Pattern pattern, Arguments&&... arguments)
      : pattern_(pattern.english), arguments_{Text(std::forward<Arguments>(arguments))...}, isPattern_(true) {}

  /// A number of things: the same in English as the plain number; elsewhere it may be shown in groups of thousands.
  static Text count(std::uint64_t number) {
    Text text(number);
    text.isCount_ = true;
    return text;
  }

  [[nodiscard]] bool empty() const { return pattern_.empty(); }
  /// False: pattern() is the text itself, and a percent sign in it is one.
  [[nodiscard]] bool isPattern() const { return isPattern_; }
  /// pattern() is the digits of a count.
  [[nodiscard]] bool isCount() const { return isCount_; }
  [[nodiscard]] const std::string& pattern() const { return pattern_; }
  [[nodiscard]] const std::vector<Text>& arguments() const { return arguments_; }

  /// The text in English. A place without an argument stays as it is written.
  [[nodiscard]] std::string str() const;
  /// The text in English with a blank for every control character, line breaks among them.
  [[nodiscard]] Text inOneLine() const;

  bool operator==(const Text& other) const;

 private:
  std::string pattern_;
  std::vector<Text> arguments_;
  bool isPattern_ = false;
  bool isCount_ = false;
};

/// `pattern` with `argument(i)` in the place %(i + 1), for i below `count`. Arguments are not searched for places.
template <class Argument>
std::string fillPlaces(std::string_view pattern, std::size_t count, const Argument& argument) {
  std::string filled;
  for (std::size_t at = 0; at < pattern.size(); ++at) {
    const bool isPlace = pattern[at] == '%' && at + 1 < pattern.size() && pattern[at + 1] >= '1' &&
                         pattern[at + 1] <= '9' && static_cast<std::size_t>(pattern[at + 1] - '1') < count;
    if (isPlace)
      filled += argument(static_cast<std::size_t>(pattern[++at] - '1'));
    else
      filled += pattern[at];
  }
  return filled;
}

}  // namespace footfall
