// Many small things in few blocks of memory, which go together.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <memory_resource>
#include <new>

namespace footfall::detail {

/// Where copies of one thread lie, that are let go together: each holds all of it.
using CopyMemory = std::shared_ptr<std::pmr::monotonic_buffer_resource>;

[[nodiscard]] inline CopyMemory makeCopyMemory() {
  constexpr std::size_t kFirstBlock = 1 << 16;
  return std::make_shared<std::pmr::monotonic_buffer_resource>(kFirstBlock);
}

/// A copy that is never destroyed: all that it has lies in the memory as well, without room to grow.
template <class T>
T* copyInto(const CopyMemory& memory, const T& value) {
  return new (memory->allocate(sizeof(T), alignof(T))) T(value, memory.get());
}

/// The same as a value of many that are kept.
template <class T>
std::shared_ptr<const T> keptIn(const CopyMemory& memory, const T& value) {
  return {memory, copyInto(memory, value)};
}

}  // namespace footfall::detail
