// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

/// The group of one loop or of functions side by side. It is part of the group that started it, and cancelled with it.
class Group {
 public:
  tbb::task_group_context& context() { return context_; }
  /// Throws Cancelled when some of the work may be missing. An exception of the work itself was thrown before.
  void check() {
    if (context_.is_group_execution_cancelled()) throw Cancelled();
  }

 private:
  tbb::task_group_context context_;
};

}  // namespace

void runRanges(std::size_t count, std::size_t grain, RangeBody body) {
  Group group;
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, grain), [body](const auto& range) { body(range.begin(), range.end()); },
      group.context());
  group.check();
}

void forRanges(std::size_t count, std::size_t size, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  if (count <= size) return body(0, count);
  Group group;
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, size), [&body](const auto& range) { body(range.begin(), range.end()); },
      tbb::simple_partitioner(), group.context());
  group.check();
}

void runTogether(std::span<const InvokedBody> bodies) {
  Group group;
  // This thread runs the last function that the library is given.
  switch (bodies.size()) {
    case 2:
      tbb::parallel_invoke(bodies[1], bodies[0], group.context());
      break;
    case 3:
      tbb::parallel_invoke(bodies[1], bodies[2], bodies[0], group.context());
      break;
    default:
      tbb::parallel_invoke(bodies[1], bodies[2], bodies[3], bodies[0], group.context());
  }
  group.check();
}

void runIsolated(InvokedBody body) {
  tbb::this_task_arena::isolate([body] { body(); });
}

}  // namespace footfall::detail
