// An array whose elements are constructed when they are first written, so that threads can fill it together.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

namespace footfall::detail {

/// The array does not clear its memory, as a vector would on one thread; the threads that fill it also touch the pages
/// first. Every element must be filled before it is read.
template <class T>
class UnfilledArray {
 public:
  static_assert(std::is_trivially_destructible_v<T> && alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);

  UnfilledArray() = default;
  explicit UnfilledArray(std::size_t size)
      : memory_(std::make_unique_for_overwrite<std::byte[]>(size * sizeof(T))), size_(size) {}

  void fill(std::size_t i, const T& value) { new (memory_.get() + i * sizeof(T)) T(value); }

  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  [[nodiscard]] T* data() const { return std::launder(reinterpret_cast<T*>(memory_.get())); }

  std::unique_ptr<std::byte[]> memory_;
  std::size_t size_ = 0;
};

}  // namespace footfall::detail
