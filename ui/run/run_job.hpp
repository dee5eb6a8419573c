// A run: what it computes, and the events that it has published so far.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/distributed/run_place.hpp"
#include "core/pipeline/runner.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/processor_use.hpp"
#include "ui/base/time_estimate.hpp"
#include "ui/run/finished_runs.hpp"
#include "ui/run/run_event_buffer.hpp"
#include "ui/run/step_meshes.hpp"
#include "ui/view/edit_preview.hpp"
#include "ui/view/render_geometry.hpp"

namespace footfall::ui {

/// The steps so far and one more, as a key.
inline std::string extendPrefix(const std::string& prefix, const PipelineStep& step) {
  return prefix + formatStep(step) + '\n';
}
/// The same with each step switched off that needs a Vertical clearance filter and has none before it.
Pipeline withoutSkipped(Pipeline pipeline);
/// The enabled steps, in order.
std::vector<const PipelineStep*> enabledSteps(const Pipeline& pipeline);
/// The enabled steps as a key.
std::string keyOf(const Pipeline& pipeline);

/// Pictures of whole steps, made by the threads that compute: on large levels not of all of them, as the next step
/// would wait for each. Thread-safe.
class StepPictures {
 public:
  /// Null while the last one was not long ago for what it took.
  std::shared_ptr<const NavigationMeshGeometry> make(const NavigationMesh& mesh, const Vec3& centre);

 private:
  std::mutex mutex_;
  RunEventBuffer::Clock::time_point next_;
};

/// Shared by the window and the threads that work on it.
struct RunJob {
  std::shared_ptr<const Environment> environment;
  Vec3 centre;
  Pipeline pipeline;
  int threads = 0;  ///< at most; 0: as many as there are
  RunPlace place;   ///< where its cells are run
  std::shared_ptr<StepMeshes> stepMeshes;
  std::shared_ptr<ResultCache> cache;
  std::string key;
  std::vector<int> ids;                    ///< of the enabled steps
  std::vector<const PipelineStep*> steps;  ///< the enabled ones, inside `pipeline`
  std::vector<std::string> prefixes;       ///< prefixes[i]: steps before the enabled step i, and one more for all
  RunEventBuffer::Clock::time_point begun = RunEventBuffer::Clock::now();
  bool follows = false;         ///< there is an earlier result, which is shown until more is known
  bool sameEnvironment = true;  ///< as the last finished run; numbers of triangles mean the same then
  std::vector<StepTime>
      times;  ///< of the steps, and of making the mesh where that is known; empty before they are known
  std::size_t firstChanged = 0;  ///< the first step that is not the same as in the last finished run
  std::shared_ptr<const NavigationMesh> changedBefore;  ///< what that step gave then, where it is known
  /// Over the last result: known from the edit itself, or else from the first step that differs once it has run.
  EditPreview::Surfaces changes;
  EditPreview::Surfaces changesOfStep;  ///< written by the thread that computes, before the event of that step
  StepPictures stepPictures;
  std::unique_ptr<RunEventBuffer> events;
  std::unique_ptr<RunContext> context;
  std::unique_ptr<ProcessorWatch> processors;  ///< made when it begins
};

struct RunOutcome {
  std::shared_ptr<const FinishedRun> finished;
  ViewContent content;
  QString error;  ///< empty: finished or cancelled
};

/// Fills in what follows from the pipeline: steps, prefixes and key.
std::shared_ptr<RunJob> makeRunJob(const Pipeline& pipeline);
/// Gives the job its context, and a buffer of events that calls `notify` (RunEventBuffer). Meshes of steps are kept.
void listenTo(RunJob& job, std::function<void()> notify);
/// Gives the job a context that keeps meshes of steps and buffers no events.
void keepStepMeshes(RunJob& job);
/// Finds the first step that differs from those of an earlier run, and what it gave then.
void compareWithEarlier(RunJob& job, const Pipeline& earlier);
/// Runs it, on any thread. Does not throw.
RunOutcome compute(RunJob& job);

}  // namespace footfall::ui
