// Reading input files as a whole or in pieces, with a message for every failure of a path.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Throws InputError "PATH: what; what to do", or "PATH:LINE: what; what to do" when `line` is not 0. Line breaks and
/// other control characters in the texts are replaced, so that the message is always one line.
[[noreturn]] void failInput(const std::string& path, std::size_t line, const Text& what, const Text& todo);

/// An open input file. Its functions throw InputError as checkInputFile() does, and when reading fails.
class InputFile {
 public:
  explicit InputFile(const std::string& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// The size of the file when it was opened.
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// Returns the number of bytes read from `offset` on; it is less than `size` only where the file ends.
  std::size_t read(std::uint64_t offset, char* bytes, std::size_t size) const;

 private:
  std::string path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

/// Throws InputError unless `path` is a readable, non-empty regular file.
void checkInputFile(const std::string& path);

/// Returns the bytes of a file. Throws InputError as checkInputFile() does and when reading fails; Cancelled when
/// `context` (may be null) was cancelled.
std::string readInputFile(const std::string& path, RunContext* context);

}  // namespace footfall::detail
