// All work on several threads starts here: loops, functions side by side, sums, a value for each thread.
//
// A group of work ends early when one of its parts throws. Work that was started by another part of that group ends
// early then, too, although nothing went wrong in it. Each function here throws Cancelled in that case, so that code
// behind it never reads results that are missing. The exception that ended the group reaches whoever started the group.
// Sorting is in parallel_sort.hpp, the number of threads in worker_arena.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <thread>
#include <utility>

namespace footfall::detail {

/// Numbers from begin() up to end(), without end() itself.
template <class Number>
class NumberRange {
 public:
  NumberRange(Number begin, Number end) : begin_(begin), end_(end) {}
  [[nodiscard]] Number begin() const { return begin_; }
  [[nodiscard]] Number end() const { return end_; }

 private:
  Number begin_, end_;
};

/// A reference to a function, which must outlive it; calls it with ranges of numbers.
class RangeBody {
 public:
  template <class Body>
  explicit RangeBody(const Body& body)
      : object_(std::addressof(body)), call_([](const void* object, std::size_t first, std::size_t last) {
          (*static_cast<const Body*>(object))(first, last);
        }) {}
  void operator()(std::size_t first, std::size_t last) const { call_(object_, first, last); }

 private:
  const void* object_;
  void (*call_)(const void* object, std::size_t first, std::size_t last);
};

/// A reference to a function without arguments, which must outlive it.
class InvokedBody {
 public:
  template <class Body>
  explicit InvokedBody(const Body& body)
      : object_(std::addressof(body)), call_([](const void* object) { (*static_cast<const Body*>(object))(); }) {}
  void operator()() const { call_(object_); }

 private:
  const void* object_;
  void (*call_)(const void* object);
};

/// The loop behind parallelRanges() and parallelFor().
void runRanges(std::size_t count, std::size_t grain, RangeBody body);
/// Runs two to four functions; the first of them on this thread.
void runTogether(std::span<const InvokedBody> bodies);
/// The function behind isolated().
void runIsolated(InvokedBody body);

/// Calls body(range), where `range` is a NumberRange<Number>, for ranges that together are 0 to `count`, on any thread
/// and in any order. The ranges are about `grain` numbers long or longer.
template <class Number, class Body>
void parallelRanges(Number count, std::size_t grain, const Body& body) {
  if (count <= 0) return;
  runRanges(static_cast<std::size_t>(count), grain, RangeBody([&](std::size_t first, std::size_t last) {
              body(NumberRange<Number>(static_cast<Number>(first), static_cast<Number>(last)));
            }));
}

/// Calls body(number) for each number from 0 to `count`, on any thread and in any order.
template <class Number, class Body>
void parallelFor(Number count, const Body& body) {
  if (count <= 0) return;
  runRanges(static_cast<std::size_t>(count), 1, RangeBody([&](std::size_t first, std::size_t last) {
              for (std::size_t i = first; i != last; ++i) body(static_cast<Number>(i));
            }));
}

/// Calls body(first, last) for ranges that together are 0 to `count`, on any thread and in any order. Ranges are longer
/// than half of `size`, and at most `size` long. A `count` up to `size` is one call on this thread.
void forRanges(std::size_t count, std::size_t size, const std::function<void(std::size_t, std::size_t)>& body);

/// Calls two to four functions, each on any thread, and returns when all have returned.
template <class... Bodies>
void parallelInvoke(const Bodies&... bodies) {
  static_assert(sizeof...(Bodies) >= 2 && sizeof...(Bodies) <= 4);
  const std::array<InvokedBody, sizeof...(Bodies)> all{InvokedBody(bodies)...};
  runTogether(all);
}

/// Calls work(). While this thread waits for parallel work inside it, it does not start other tasks of the group.
template <class Work>
void isolated(const Work& work) {
  runIsolated(InvokedBody(work));
}

/// One T for each thread that calls local(), which any thread may call. Everything else needs all threads to be done.
template <class T>
class PerThread {
 public:
  /// Each T is made by its default constructor.
  PerThread() : make_([] { return T(); }) {}
  /// Each T is what `make()` returns, which may be called by several threads at a time.
  template <class Make>
  explicit PerThread(Make make) : make_(std::move(make)) {}
  ~PerThread() {
    for (Node* node = first_.load(std::memory_order_acquire); node != nullptr;) delete std::exchange(node, node->next);
  }
  PerThread(const PerThread&) = delete;
  PerThread& operator=(const PerThread&) = delete;

  /// The value of this thread, made at its first call. When making it throws, the next call makes it again.
  T& local() {
    const std::thread::id self = std::this_thread::get_id();
    for (Node* node = first_.load(std::memory_order_acquire); node != nullptr; node = node->next)
      if (node->thread == self) return node->value;
    auto* const made = new Node(self, make_);
    made->next = first_.load(std::memory_order_relaxed);
    while (!first_.compare_exchange_weak(made->next, made, std::memory_order_release, std::memory_order_relaxed)) {
    }
    return made->value;
  }

 private:
  struct alignas(64) Node {  // a cache line: threads change their values all the time
    Node(std::thread::id self, const std::function<T()>& make) : thread(self), value(make()) {}
    std::thread::id thread;
    T value;
    Node* next = nullptr;
  };

 public:
  template <class Value>
  class Iterator {
   public:
    explicit Iterator(Node* node) : node_(node) {}
    Value& operator*() const { return node_->value; }
    Iterator& operator++() {
      node_ = node_->next;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return node_ != other.node_; }

   private:
    Node* node_;
  };
  /// The values that were made, in any order.
  [[nodiscard]] Iterator<T> begin() { return Iterator<T>(first_.load(std::memory_order_acquire)); }
  [[nodiscard]] Iterator<T> end() { return Iterator<T>(nullptr); }
  [[nodiscard]] Iterator<const T> begin() const { return Iterator<const T>(first_.load(std::memory_order_acquire)); }
  [[nodiscard]] Iterator<const T> end() const { return Iterator<const T>(nullptr); }

 private:
  std::function<T()> make_;
  std::atomic<Node*> first_{nullptr};
};

/// Joins the values of ranges that together are 0 to `count`: work(range, nothing) returns the value of a range, and
/// join(a, b) that of two. The order of joining varies, so join() must not depend on it.
template <class Number, class Value, class Work, class Join>
Value parallelReduce(Number count, std::size_t grain, const Value& nothing, const Work& work, const Join& join) {
  PerThread<Value> sums([&] { return nothing; });
  parallelRanges(count, grain, [&](const auto& range) {
    const Value part = work(range, nothing);
    Value& sum = sums.local();
    sum = join(sum, part);
  });
  Value result = nothing;
  for (const Value& sum : sums) result = join(result, sum);
  return result;
}

}  // namespace footfall::detail
