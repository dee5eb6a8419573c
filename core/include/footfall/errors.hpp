// Errors that a user can cause. Each message says what, where and what to do, in one line.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <stdexcept>
#include <utility>

#include "footfall/text.hpp"

namespace footfall {

/// The base of the errors below: what() is the message in English, text() the one to be translated.
class TextError : public std::runtime_error {
 public:
  explicit TextError(Text text)
      : std::runtime_error(text.str()), text_(std::make_shared<const Text>(std::move(text))) {}
  /// A pattern and what stands in its places.
  template <class... Arguments>
  requires(sizeof...(Arguments) > 0) explicit TextError(Pattern pattern, Arguments&&... arguments)
      : TextError(Text(pattern, std::forward<Arguments>(arguments)...)) {}

  [[nodiscard]] const Text& text() const noexcept { return *text_; }

 private:
  std::shared_ptr<const Text> text_;  ///< shared, because copies of an exception must not throw
};

/// A file, a pipeline or a parameter is wrong (exit code 2 of the command line).
struct InputError : TextError {
  using TextError::TextError;
};

/// The result cannot be written, or memory or disk ran out (exit code 1).
struct RunError : TextError {
  using TextError::TextError;
};

/// The user cancelled the run (exit code 1). Nothing is lost.
struct Cancelled : std::runtime_error {
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace footfall
