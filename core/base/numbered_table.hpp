// A table that numbers distinct keys in the order of their arrival.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace footfall::detail {

/// Open addressing over plain keys without padding. Clearing takes constant time, and a table that was large once costs
/// small ones no more: slots carry the number of the filling that they belong to.
template <class Key>
class NumberedTable {
 public:
  using Number = std::int32_t;

  NumberedTable() { startFilling(); }

  void clear() {
    keys_.clear();
    bits_ = kFirstBits;
    startFilling();
  }
  /// Makes room for so many keys.
  void reserve(std::size_t count) {
    if (isCrowdedBy(count)) growFor(count);
  }
  /// The number of `key`, and whether it is new.
  std::pair<Number, bool> insert(const Key& key) {
    if (isCrowdedBy(keys_.size())) growFor(keys_.size());
    Slot* slot = find(key);
    if (slot->filling == filling_) return {slot->number, false};
    *slot = {filling_, static_cast<Number>(keys_.size())};
    keys_.push_back(key);
    return {slot->number, true};
  }
  /// Numbers a key that insert() is never called with.
  Number append(const Key& key) {
    keys_.push_back(key);
    return static_cast<Number>(keys_.size() - 1);
  }
  /// Equal for equal keys, of no order; bits 16 to 31 are not those by which the table finds keys.
  static std::uint64_t hashOf(const Key& key) { return hash(wordsOf(key)); }
  const Key& operator[](Number i) const { return keys_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] std::size_t size() const { return keys_.size(); }

 private:
  static constexpr int kFirstBits = 6;
  struct Slot {
    std::uint32_t filling = 0;
    Number number = 0;
  };

  static constexpr std::size_t kWords = (sizeof(Key) + 7) / 8;
  using Words = std::array<std::uint64_t, kWords>;

  static Words wordsOf(const Key& key) {
    static_assert(std::has_unique_object_representations_v<Key>);
    Words words{};
    std::memcpy(words.data(), &key, sizeof(Key));
    return words;
  }
  static bool areEqual(const Words& a, const Words& b) {
    std::uint64_t difference = 0;
    for (std::size_t i = 0; i < kWords; ++i) difference |= a[i] ^ b[i];
    return difference == 0;
  }
  // Sums of products with odd numbers (the fractions of pi), of which the top bits are used.
  static std::uint64_t hash(const Words& words) {
    constexpr std::uint64_t kFactors[] = {0x243F6A8885A308D3ULL, 0x13198A2E03707345ULL, 0xA4093822299F31D1ULL,
                                          0x082EFA98EC4E6C89ULL, 0x452821E638D01377ULL};
    static_assert(kWords <= std::size(kFactors));
    std::uint64_t h = 0;
    for (std::size_t i = 0; i < kWords; ++i) h += words[i] * kFactors[i];
    h ^= h >> 32;
    return h * 0x9E3779B97F4A7C15ULL;
  }
  Slot* find(const Key& key) {
    const std::size_t mask = (std::size_t{1} << bits_) - 1;
    const Words words = wordsOf(key);
    std::size_t slot = hash(words) >> (64 - bits_);
    while (slots_[slot].filling == filling_ &&
           !areEqual(wordsOf(keys_[static_cast<std::size_t>(slots_[slot].number)]), words))
      slot = (slot + 1) & mask;
    return &slots_[slot];
  }
  void startFilling() {
    if (slots_.size() < (std::size_t{1} << bits_)) slots_.resize(std::size_t{1} << bits_);
    if (++filling_ != 0) return;
    slots_.assign(slots_.size(), {});  // the numbers of fillings begin again
    filling_ = 1;
  }
  [[nodiscard]] bool isCrowdedBy(std::size_t count) const { return count * 2 >= (std::size_t{1} << bits_); }
  void growFor(std::size_t count) {
    while (isCrowdedBy(count)) ++bits_;
    startFilling();
    for (std::size_t i = 0; i < keys_.size(); ++i) *find(keys_[i]) = {filling_, static_cast<Number>(i)};
  }

  int bits_ = kFirstBits;
  std::uint32_t filling_ = 0;
  std::vector<Key> keys_;
  std::vector<Slot> slots_;
};

}  // namespace footfall::detail
