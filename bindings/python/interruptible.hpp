// Long work that Python can interrupt: Ctrl-C cancels it, other threads of Python go on meanwhile.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

#include "footfall/run_context.hpp"

namespace footfall::python {

/// Does `work` on a thread of its own. The calling thread gives the interpreter lock away and, some 100 times a second,
/// takes it back to look for signals and to call `progress` (None: nothing) with a step's number from 0, its name, and
/// how much of it is done, 0 to 1. When a signal handler or `progress` raises, as Ctrl-C makes it, the work is
/// cancelled and the exception goes on to the caller. Throws what `work` throws.
void doInterruptibly(const pybind11::object& progress, const std::function<void(RunContext&)>& work);

/// The same for work with a result.
template <class Work>
auto interruptible(const pybind11::object& progress, const Work& work) {
  std::optional<std::invoke_result_t<const Work&, RunContext&>> result;
  doInterruptibly(progress, [&](RunContext& context) { result.emplace(work(context)); });
  return *std::move(result);
}

}  // namespace footfall::python
