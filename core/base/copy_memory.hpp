// Many small objects in few blocks of memory that are freed together.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <memory_resource>
#include <new>

namespace footfall::detail {

/// Memory for copies made by one thread that are freed together; every copy keeps the whole memory alive.
using CopyMemory = std::shared_ptr<std::pmr::monotonic_buffer_resource>;

[[nodiscard]] inline CopyMemory makeCopyMemory() {
  constexpr std::size_t kFirstBlock = 1 << 16;
  return std::make_shared<std::pmr::monotonic_buffer_resource>(kFirstBlock);
}

/// Returns a copy that is never destroyed. Everything that it owns lies in the memory as well, without room to grow.
template <class T>
T* copyInto(const CopyMemory& memory, const T& value) {
  return new (memory->allocate(sizeof(T), alignof(T))) T(value, memory.get());
}

/// Returns the copy as a shared pointer that keeps the memory alive.
template <class T>
std::shared_ptr<const T> keptIn(const CopyMemory& memory, const T& value) {
  return {memory, copyInto(memory, value)};
}

}  // namespace footfall::detail
