// The code that the fuzz targets share: the entry point, and the end of the program when a promise is broken.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "footfall/errors.hpp"

/// Takes any bytes and returns 0. libFuzzer calls it with what it makes up, replay_corpus.cpp with files.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace footfall::fuzz {

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Ends the program, so that the fuzzer keeps the input.
inline void require(bool promise, const std::string& what) {
  if (promise) return;
  std::fprintf(stderr, "broken promise: %s\n", what.c_str());
  std::abort();
}

/// Checks the form of a message to a user: one line that begins with the file's name and says what to do.
inline void requireGoodMessage(std::string_view message, std::string_view file) {
  require(message.starts_with(file), "the message does not begin with the file: " + std::string(message));
  // "A needs B before it" also says what to do.
  const bool saysWhatToDo = message.find("; ") != message.npos || message.ends_with(" before it");
  require(saysWhatToDo, "the message does not say what to do: " + std::string(message));
  for (const char c : message)
    require(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f, "the message is not one line: " + std::string(message));
}

}  // namespace footfall::fuzz
