// How loops find out whether they were cancelled.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <memory>
#include <type_traits>

#include "footfall/run_context.hpp"

namespace footfall::detail {

class Poll;
template <class Function>
concept PollFunction = !std::same_as<std::remove_cvref_t<Function>, Poll> && std::invocable<Function&>;

/// Long work calls its poll now and then, from any of its threads; a call throws Cancelled to end the work. A poll is
/// two pointers and refers to what it was made from, which must live as long as the poll is used.
class Poll {
 public:
  /// A poll that never cancels.
  Poll() = default;
  Poll(const RunContext& context) : Poll(&context) {}
  /// Polls a context; without one the poll never cancels.
  explicit Poll(const RunContext* context) : object_(context), call_(context != nullptr ? checkContext : nothing) {}
  /// Calls a function, which may throw anything.
  template <PollFunction Function>
  Poll(Function&& function)
      : object_(std::addressof(function)),
        call_([](const void* f) { (*static_cast<std::remove_reference_t<Function>*>(const_cast<void*>(f)))(); }) {}

  void operator()() const { call_(object_); }

 private:
  static void nothing(const void* /*object*/) {}
  static void checkContext(const void* context) { static_cast<const RunContext*>(context)->checkCancelled(); }

  const void* object_ = nullptr;
  void (*call_)(const void* object) = nothing;
};

}  // namespace footfall::detail
