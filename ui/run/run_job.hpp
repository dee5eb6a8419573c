// A run under way and what it gave; for the files of RunController alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/pipeline/state_size.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/time_estimate.hpp"
#include "ui/run/run_controller.hpp"

namespace footfall::ui {

/// Results of single steps for display, beside the states in the cache, by steps so far. Thread-safe; the least
/// recently used goes first.
class RunController::PreviewCache {
 public:
  void store(const std::string& prefix, MeshPtr mesh) {
    const std::scoped_lock lock(mutex_);
    entries_.remove_if([&](const auto& entry) { return entry.first == prefix; });
    entries_.emplace_front(prefix, std::move(mesh));
    std::size_t bytes = 0;
    for (const auto& entry : entries_) bytes += entry.second ? sizeOf(*entry.second) : 0;
    while (entries_.size() > kEntries || (bytes > kMostBytes && entries_.size() > kLeastEntries)) {
      bytes -= entries_.back().second ? sizeOf(*entries_.back().second) : 0;
      entries_.pop_back();
    }
  }
  MeshPtr find(const std::string& prefix) {
    const std::scoped_lock lock(mutex_);
    for (auto it = entries_.begin(); it != entries_.end(); ++it) {
      if (it->first != prefix) continue;
      entries_.splice(entries_.begin(), entries_, it);
      return it->second;
    }
    return nullptr;
  }

 private:
  static constexpr std::size_t kEntries = 32;       // as many as ResultCache keeps states
  static constexpr std::size_t kLeastEntries = 12;  // a run of a usual pipeline
  static constexpr std::size_t kMostBytes = std::size_t{256} << 20;
  std::mutex mutex_;
  std::list<std::pair<std::string, MeshPtr>> entries_;
};

/// Pictures of whole steps, made by the threads that compute: on large levels not of all of them, as the next step
/// would wait for each.
class RunController::StepPictures {
 public:
  /// Null while the last one was not long ago for what it took.
  std::shared_ptr<const NavigationMeshGeometry> make(const NavigationMesh& mesh, const Vec3& centre) {
    using Clock = RunEventBuffer::Clock;
    constexpr int kShare = 10;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    const Clock::time_point begun = Clock::now();
    if (!lock || begun < next_) return nullptr;
    std::shared_ptr<const NavigationMeshGeometry> made = makeMeshGeometry(mesh, centre);
    next_ = Clock::now() + kShare * (Clock::now() - begun);
    return made;
  }

 private:
  std::mutex mutex_;
  RunEventBuffer::Clock::time_point next_;
};

/// One run: shared by the window and the threads that work on it.
struct RunController::Job {
  std::shared_ptr<const Environment> environment;
  Vec3 centre;
  Pipeline pipeline;
  int threads = 0;  // at most; 0: as many as there are
  std::string key;
  std::vector<int> ids;                    // of the enabled steps
  std::vector<const PipelineStep*> steps;  // the enabled ones, inside `pipeline`
  std::vector<std::string> prefixes;       // prefixes[i]: steps before the enabled step i, and one more for all
  RunEventBuffer::Clock::time_point begun = RunEventBuffer::Clock::now();
  bool follows = false;  // there is an earlier result, which is shown until more is known
  // What the window shows of the run while it goes on; only the window's thread uses it.
  std::size_t shownStep = static_cast<std::size_t>(-1), shownParts = 0;
  std::optional<RunEventBuffer::Clock::time_point> lastPicture;
  // Over the last result: known from the edit itself, or else from the first step that differs once it has run.
  EditPreview::Surfaces changes;
  std::vector<StepTime> times;  // of the steps, and of making the mesh where that is known; empty before they are told
  std::size_t cellsTold = 0;    // events of cells that the window has heard of
  bool sameEnvironment = true;  // as the last finished run; numbers of triangles mean the same then
  bool settling = false;        // edits may follow; it has not begun
  bool waiting = false;         // for the frame that shows what is known from the edit
  // The first step that is not the same as in the last finished run, and what it gave there.
  std::size_t firstChanged = 0;
  MeshPtr changedBefore;
  EditPreview::Surfaces changesOfStep;  // written by the thread that computes, before the event of that step
  StepPictures stepPictures;
  std::shared_ptr<PreviewCache> previews;
  std::unique_ptr<RunEventBuffer> events;
  std::unique_ptr<RunContext> context;
};

struct RunController::Outcome {
  std::shared_ptr<const FinishedRun> finished;
  ViewContent content;
  QString error;  // empty: finished or cancelled
};

/// The steps so far and one more, as a key.
inline std::string extendPrefix(const std::string& prefix, const PipelineStep& step) {
  return prefix + formatStep(step) + '\n';
}

}  // namespace footfall::ui
