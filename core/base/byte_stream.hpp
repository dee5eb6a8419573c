// Writing numbers as bytes and reading them back. Small numbers take few bytes, and the reader checks every number
// against its range and the bytes that are left.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace footfall::detail {

/// Thrown for bytes that no writer can have written.
struct BadBytes : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class ByteWriter {
 public:
  /// Seven bits a byte, the lowest first.
  void number(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) bytes.push_back(static_cast<char>(value | 0x80));
    bytes.push_back(static_cast<char>(value));
  }
  /// Numbers near zero, of either sign, take few bytes.
  void signedNumber(std::int64_t value) {
    number((static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63));
  }
  /// Eight bytes, the lowest first.
  void fixed(std::uint64_t value) {
    for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<char>(value >> (8 * i)));
  }
  void real(double value) { fixed(std::bit_cast<std::uint64_t>(value)); }
  void text(std::string_view text) {
    number(text.size());
    bytes.append(text);
  }

  std::string bytes;
};

/// Every function throws BadBytes where the bytes end too early or a number is out of range.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const auto byte = static_cast<unsigned char>(take(1)[0]);
      if (shift == 63 && byte > 1) break;
      value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
      if (byte < 0x80) return value;
    }
    throw BadBytes("a number is too long");
  }
  std::int64_t signedNumber() {
    const std::uint64_t value = number();
    return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
  }
  /// A number of at least 0 and below `end`.
  std::int32_t below(std::int64_t end) {
    const std::uint64_t value = number();
    if (end <= 0 || value >= static_cast<std::uint64_t>(end)) throw BadBytes("a number is out of range");
    return static_cast<std::int32_t>(value);
  }
  /// The length of a list whose items take at least `least` bytes each; it is never more than the remaining bytes can
  /// hold.
  std::size_t count(std::size_t least) {
    const std::uint64_t value = number();
    if (value > bytes_.size() / least) throw BadBytes("a list is longer than the bytes");
    return static_cast<std::size_t>(value);
  }
  std::uint64_t fixed() {
    const std::string_view eight = take(8);
    std::uint64_t value = 0;
    for (int i = 0; i < 8; ++i)
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(eight[static_cast<std::size_t>(i)])) << (8 * i);
    return value;
  }
  double real() { return std::bit_cast<double>(fixed()); }
  std::string text() { return std::string(take(count(1))); }
  std::string_view take(std::size_t size) {
    if (size > bytes_.size()) throw BadBytes("the bytes end too early");
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }
  [[nodiscard]] std::string_view rest() const { return bytes_; }
  void expectEnd() const {
    if (!bytes_.empty()) throw BadBytes("there are bytes behind the end");
  }

 private:
  std::string_view bytes_;
};

}  // namespace footfall::detail
