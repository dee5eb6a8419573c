// Freeing large objects in the background. Freeing a gigabyte takes longer than cancelling a run may take.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

namespace footfall::detail {

/// Drops a reference soon, on a thread of the library's own. The reference is dropped at once where no such thread can
/// be had.
void releaseInBackground(std::shared_ptr<const void> thing) noexcept;

/// Returns freed memory to the system, as far as the allocator holds whole pages of it. This takes about a millisecond
/// for some tens of megabytes.
void returnFreedMemory() noexcept;

/// Makes the process keep most of the memory that it frees for later allocations, until returnFreedMemory() is called.
/// Blocks above 32 MB and memory of single threads may still be returned. Fresh pages cost up to a fifth of a run over
/// a million triangles. This suits programs that compute once and end, and not programs that wait for a person or keep
/// within a bound of memory.
void keepFreedMemory() noexcept;

/// Holds references to objects that may be large. When an exception passes, each last reference is dropped in the
/// background; otherwise it is dropped on this thread. Declare it before everything else that holds the objects.
class ReleaseOnException {
 public:
  /// `isLarge` is true when freeing the objects is worth another thread.
  explicit ReleaseOnException(bool isLarge) : isLarge_(isLarge), exceptions_(std::uncaught_exceptions()) {}
  ~ReleaseOnException() {
    if (std::uncaught_exceptions() == exceptions_) return;
    for (std::shared_ptr<const void>& thing : things_) {
      // Other holders may drop their references meanwhile; the last holder frees the object.
      if (thing.use_count() == 1) releaseInBackground(std::move(thing));
    }
  }
  ReleaseOnException(const ReleaseOnException&) = delete;
  ReleaseOnException& operator=(const ReleaseOnException&) = delete;

  void hold(std::shared_ptr<const void> thing) {
    if (isLarge_) things_.push_back(std::move(thing));
  }

 private:
  bool isLarge_;
  int exceptions_;
  std::vector<std::shared_ptr<const void>> things_;
};

/// Objects made of at least this many triangles are worth freeing on another thread.
inline constexpr std::size_t kLargeRelease = 1 << 14;

}  // namespace footfall::detail
