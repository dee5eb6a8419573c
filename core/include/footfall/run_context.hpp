// The one object that carries progress, cancelling and events through a run. The core publishes, the editor listens.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "footfall/errors.hpp"

namespace footfall {

struct NavigationMesh;  // footfall/navigation_mesh.hpp
struct BlockReport;     // footfall/statistics.hpp
struct CellReport;

/// An event of a run. Steps are counted from 0.
struct RunEvent {
  enum class Kind {
    StepStarted,  ///< `step`, `text` = filter name
    Progress,     ///< `step`, `fraction` in [0, 1] of that step
    PartReady,    ///< `step`, `part` = a piece of the step's result, good enough to be shown while the rest is computed
    StepFinished,  ///< `step`; `part` may hold the step's whole result for display
    CellsMade,     ///< `block`: the cells of a parallel block that is about to run; nothing in them has run yet
    CellFinished,  ///< `cell` and its `cellReport`; `part` may hold what its filters left, for display. Comes again
                   ///< with each pass over the cells
  };
  Kind kind = Kind::Progress;
  std::size_t step = 0;
  double fraction = 0;
  std::string text = {};
  std::shared_ptr<const NavigationMesh> part = nullptr;
  std::shared_ptr<const BlockReport> block = nullptr;
  std::size_t cell = 0;  ///< number in the block that ran last
  std::shared_ptr<const CellReport> cellReport = nullptr;
};

/// Shared by the thread that started a run and all threads that work on it; every member may be called from any
/// thread. Long loops call checkCancelled() at least every few milliseconds, so that cancelling takes less than 50 ms.
class RunContext {
 public:
  /// Called from worker threads, one call at a time is NOT guaranteed: a listener must be thread-safe and quick.
  using Listener = std::function<void(const RunEvent&)>;

  RunContext() = default;
  /// `wantsParts`: events come with meshes to show, which takes time to make.
  explicit RunContext(Listener listener, bool wantsParts = false)
      : listener_(std::move(listener)), wantsParts_(wantsParts) {}

  /// Makes every call that has this object throw Cancelled, soon and for good.
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }
  /// Throws Cancelled when cancel() was called.
  void checkCancelled() const {
    if (cancelled()) throw Cancelled();
  }

  // The members below are called by runs.

  /// The step that the following progress() and part() calls belong to; set by the runner.
  void beginStep(std::size_t step, const std::string& name) {
    step_ = step;
    publish({.kind = RunEvent::Kind::StepStarted, .step = step, .text = name});
  }
  void endStep(std::shared_ptr<const NavigationMesh> result = nullptr) {
    publish({.kind = RunEvent::Kind::StepFinished, .step = step_, .fraction = 1, .part = std::move(result)});
  }
  /// Ends one of several steps that run at the same time, as those of a parallel block do.
  void endStep(std::size_t step, std::shared_ptr<const NavigationMesh> result) {
    publish({.kind = RunEvent::Kind::StepFinished, .step = step, .fraction = 1, .part = std::move(result)});
  }
  void progress(double fraction) { publish({.kind = RunEvent::Kind::Progress, .step = step_, .fraction = fraction}); }
  [[nodiscard]] bool wantsParts() const noexcept { return wantsParts_; }
  void part(std::shared_ptr<const NavigationMesh> mesh) {
    publish({.kind = RunEvent::Kind::PartReady, .step = step_, .part = std::move(mesh)});
  }
  void cellsMade(std::shared_ptr<const BlockReport> block) {
    publish({.kind = RunEvent::Kind::CellsMade, .step = step_, .block = std::move(block)});
  }
  void cellFinished(std::size_t cell, std::shared_ptr<const CellReport> report,
                    std::shared_ptr<const NavigationMesh> mesh) {
    publish({.kind = RunEvent::Kind::CellFinished,
             .step = step_,
             .part = std::move(mesh),
             .cell = cell,
             .cellReport = std::move(report)});
  }

 private:
  void publish(const RunEvent& event) const {
    if (listener_) listener_(event);
  }
  std::atomic<bool> cancelled_{false};
  Listener listener_;
  bool wantsParts_ = false;
  std::size_t step_ = 0;
};

}  // namespace footfall
