// Background work of which only the latest request counts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <exception>
#include <memory>
#include <type_traits>
#include <utility>

#include "footfall/errors.hpp"
#include "footfall/run_context.hpp"
#include "ui/base/work/background_queue.hpp"

namespace footfall::ui {

/// A member of an object on the window's thread, declared last, so that the background thread ends before the other
/// members are destroyed. Only the destructor waits for the work, which it cancels first.
class LatestWork {
 public:
  LatestWork() = default;
  ~LatestWork() { stop(); }
  LatestWork(const LatestWork&) = delete;
  LatestWork& operator=(const LatestWork&) = delete;

  /// Stops the running work, and calls work(context) in the background. done(result) or failed(exception) follows on
  /// the thread of `owner`; neither is called when the work was stopped or replaced meanwhile.
  template <class Work, class Done, class Failed>
  void start(QObject& owner, Work work, Done done, Failed failed);
  /// Cancels the running work, which ends soon.
  void stop() {
    if (context_) context_->cancel();
    context_.reset();
  }
  [[nodiscard]] bool busy() const { return context_ != nullptr; }
  /// The queue of the work. Jobs that are posted here follow the work, and stop() does not affect them.
  [[nodiscard]] BackgroundQueue& queue() { return queue_; }

 private:
  std::shared_ptr<RunContext> context_;  ///< context of the running work; null when there is none
  BackgroundQueue queue_;                // declared last: its thread ends before the other members are destroyed
};

template <class Work, class Done, class Failed>
void LatestWork::start(QObject& owner, Work work, Done done, Failed failed) {
  using Result = std::invoke_result_t<const Work&, RunContext&>;
  stop();
  context_ = std::make_shared<RunContext>();
  queue_.post(
      [this, &owner, context = context_, work = std::move(work), done = std::move(done), failed = std::move(failed)] {
        std::shared_ptr<const Result> result;
        std::exception_ptr problem;
        try {
          context->checkCancelled();
          result = std::make_shared<const Result>(work(*context));
        } catch (const Cancelled&) {
          return;  // stop() was called
        } catch (const std::exception&) {
          problem = std::current_exception();
        }
        const auto finish = [this, context, result, problem, done, failed] {
          if (context != context_) return;
          context_.reset();
          if (!problem) {
            done(*result);
            return;
          }
          try {
            std::rethrow_exception(problem);
          } catch (const std::exception& error) {
            failed(error);
          }
        };
        QMetaObject::invokeMethod(&owner, finish, Qt::QueuedConnection);
      });
}

}  // namespace footfall::ui
