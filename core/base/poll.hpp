// How long loops ask whether they were cancelled.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Throws Cancelled once `context` (may be null) is cancelled, which must live as long as the function.
inline std::function<void()> pollOf(const RunContext* context) {
  return [context] {
    if (context != nullptr) context->checkCancelled();
  };
}

}  // namespace footfall::detail
