// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/exhaustion.hpp"

#include <cerrno>
#include <new>
#include <string_view>
#include <system_error>

namespace footfall::detail {
namespace {

constexpr Pattern kMemory = FOOTFALL_TEXT("memory ran out; close other programs or use a smaller environment");
constexpr Pattern kThreads = FOOTFALL_TEXT(
    "no more threads can be started; close other programs, raise the limit (ulimit -u), or give fewer "
    "threads (--threads)");

}  // namespace

std::optional<Text> exhaustionText(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return kMemory;
  const std::string_view what = error.what();
  // TBB has no error codes for this failure.
  if (what.find("pthread_create") != std::string_view::npos) return kThreads;
  if (what.find("bad_alloc") != std::string_view::npos) return kMemory;
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  if (system == nullptr) return std::nullopt;
  switch (system->code().value()) {
    case EMFILE:
    case ENFILE:
      return FOOTFALL_TEXT("too many files are open; close other programs, or raise the limit (ulimit -n)");
    case EAGAIN:
      return kThreads;
    case ENOMEM:
      return kMemory;
    case ENOSPC:
    case EDQUOT:
      return FOOTFALL_TEXT("the disk is full; free some space");
    default:
      return std::nullopt;
  }
}

}  // namespace footfall::detail
