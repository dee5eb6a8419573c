// An array whose copies share its elements until one of them changes its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace footfall::detail {

/// Reading is as fast as reading a vector; copying the array copies a pointer.
template <class T>
class SharedArray {
 public:
  SharedArray() = default;
  explicit SharedArray(std::vector<T> values) : values_(std::make_shared<std::vector<T>>(std::move(values))) {
    data_ = values_->data();
    size_ = values_->size();
  }
  /// An array of `size` default elements.
  explicit SharedArray(std::size_t size) : SharedArray(std::vector<T>(size)) {}
  SharedArray(const SharedArray&) = default;
  SharedArray& operator=(const SharedArray&) = default;
  SharedArray(SharedArray&& other) noexcept
      : values_(std::move(other.values_)),
        data_(std::exchange(other.data_, nullptr)),
        size_(std::exchange(other.size_, 0)) {}
  SharedArray& operator=(SharedArray&& other) noexcept {
    values_ = std::move(other.values_);
    data_ = std::exchange(other.data_, nullptr);
    size_ = std::exchange(other.size_, 0);
    return *this;
  }
  ~SharedArray() = default;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  [[nodiscard]] const T* data() const { return data_; }
  [[nodiscard]] const T* begin() const { return data_; }
  [[nodiscard]] const T* end() const { return data_ + size_; }
  operator std::span<const T>() const { return {data_, size_}; }  // NOLINT(google-explicit-constructor)

  /// Returns the elements for writing. They are copied first where another array shares them. Threads may call it at
  /// the same time when no other array shares them.
  T* own() {
    if (values_.use_count() > 1) *this = SharedArray(*values_);
    return data_;
  }

  friend bool operator==(const SharedArray& a, const SharedArray& b) {
    return a.values_ == b.values_ || (a.values_ && b.values_ && *a.values_ == *b.values_) || (a.empty() && b.empty());
  }

 private:
  std::shared_ptr<std::vector<T>> values_;
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace footfall::detail
