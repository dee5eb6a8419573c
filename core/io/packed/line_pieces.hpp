// Reading the lines of a file piece by piece.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/io/input_file.hpp"

namespace footfall::detail {

class LinePieces {
 public:
  explicit LinePieces(const std::string& path, std::uint64_t offset = 0) : file_(path), offset_(offset) {}

  /// The next line without its end; empty at the end of the file, and where a line is too long.
  std::optional<std::string_view> next() {
    for (;;) {
      const std::size_t end = text_.find('\n', used_);
      if (end != std::string::npos) return take(end, end + 1);
      if (isAtEnd_) return used_ == text_.size() ? std::nullopt : take(text_.size(), text_.size());
      if (!more()) return std::nullopt;
    }
  }
  /// Returns whether the file was read to its end; false where a line was too long.
  [[nodiscard]] bool isAtEnd() const { return isAtEnd_ && used_ == text_.size(); }
  [[nodiscard]] double done() const {
    return static_cast<double>(offset_) / static_cast<double>(std::max<std::uint64_t>(file_.size(), 1));
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 20, kLongest = std::size_t{16} << 20;

  std::optional<std::string_view> take(std::size_t end, std::size_t next) {
    std::string_view line(text_.data() + used_, end - used_);
    used_ = next;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }
  bool more() {
    text_.erase(0, used_);
    used_ = 0;
    if (text_.size() > kLongest) return false;
    const std::size_t kept = text_.size();
    text_.resize(kept + kPiece);
    const std::size_t count = file_.read(offset_, text_.data() + kept, kPiece);
    text_.resize(kept + count);
    offset_ += count;
    isAtEnd_ = count < kPiece;
    return true;
  }

  InputFile file_;
  std::uint64_t offset_;
  std::string text_;
  std::size_t used_ = 0;
  bool isAtEnd_ = false;
};

}  // namespace footfall::detail
