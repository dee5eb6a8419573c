// Freeing what is large where nobody waits for it: taking down a gigabyte takes longer than a cancelled run may last.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

namespace footfall::detail {

/// Drops a reference on another thread of the library's own, soon. Where that cannot be arranged it is dropped at once.
void releaseInBackground(std::shared_ptr<const void> thing) noexcept;

/// Gives memory that was freed back to the system, as far as the allocator keeps whole pages of it. Takes a millisecond
/// for some tens of megabytes.
void returnFreedMemory() noexcept;

/// From now on the process keeps most of what it frees for what it needs next, up to returnFreedMemory(); blocks above
/// 32 MB and what threads had alone may still go. New pages are up to a fifth of a run over a million triangles. For
/// programs that compute once and end; not for those that wait for a person, or keep within a bound of memory.
void keepFreedMemory() noexcept;

/// Holds references to things that may be large. When an exception passes, the references that are the last to a thing
/// are dropped in the background, otherwise on this thread. To be declared before all others that hold the things.
class ReleaseOnException {
 public:
  /// `isLarge`: whether freeing the things is worth another thread.
  explicit ReleaseOnException(bool isLarge) : isLarge_(isLarge), exceptions_(std::uncaught_exceptions()) {}
  ~ReleaseOnException() {
    if (std::uncaught_exceptions() == exceptions_) return;
    for (std::shared_ptr<const void>& thing : things_) {
      // Others may drop theirs meanwhile; whoever is last frees it.
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

/// Freeing what was made of at least so many triangles is worth another thread.
inline constexpr std::size_t kLargeRelease = 1 << 14;

}  // namespace footfall::detail
