// A fingerprint of bytes. It detects damage and differences, and is no protection against forgery.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace footfall::detail {

/// Two lanes of 64 bits that take eight bytes at a time. Each step is a bijection of either lane, so that a change of a
/// single word always shows.
class Digest {
 public:
  using Value = std::array<std::uint64_t, 2>;

  Digest& add(std::string_view bytes) {
    word(bytes.size());  // marks the border between two texts
    while (bytes.size() >= sizeof(std::uint64_t)) {
      std::uint64_t next;
      std::memcpy(&next, bytes.data(), sizeof(next));
      word(next);
      bytes.remove_prefix(sizeof(next));
    }
    std::uint64_t rest = 0;
    if (!bytes.empty()) std::memcpy(&rest, bytes.data(), bytes.size());
    word(rest);
    return *this;
  }
  template <class Number>
  requires std::is_arithmetic_v<Number> Digest& add(Number number) {
    return add(std::string_view(reinterpret_cast<const char*>(&number), sizeof(number)));
  }
  /// Adds items of a type without padding.
  template <class Item>
  requires std::is_trivially_copyable_v<Item> Digest& add(std::span<const Item> items) {
    return add(std::string_view(reinterpret_cast<const char*>(items.data()), items.size_bytes()));
  }

  [[nodiscard]] Value value() const { return {mixed(lanes_[0]), mixed(lanes_[1] ^ std::rotl(lanes_[0], 17))}; }

 private:
  void word(std::uint64_t word) {
    lanes_[0] = std::rotl((lanes_[0] ^ word) * 0x9e3779b97f4a7c15U, 29);
    lanes_[1] = std::rotl((lanes_[1] + word) * 0xd1342543de82ef95U, 31);
  }
  // The last step of SplitMix64 (Steele, Lea, Flood 2014).
  static std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
  }

  Value lanes_{0x243f6a8885a308d3U, 0x13198a2e03707344U};
};

}  // namespace footfall::detail
