// A run: its inputs, and the events that it has published so far.
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
#include "ui/base/work/processor_use.hpp"
#include "ui/base/work/time_estimate.hpp"
#include "ui/run/finished_runs.hpp"
#include "ui/run/run_event_buffer.hpp"
#include "ui/run/step_meshes.hpp"
#include "ui/view/geometry/render_geometry.hpp"
#include "ui/view/previews/edit_preview.hpp"

namespace footfall::ui {

/// The key of the steps so far and one more.
inline std::string extendPrefix(const std::string& prefix, const PipelineStep& step) {
  return prefix + formatStep(step) + '\n';
}
/// The pipeline with each step switched off that needs a Vertical clearance filter and has none before it.
Pipeline withoutSkipped(Pipeline pipeline);
/// The enabled steps, in order.
std::vector<const PipelineStep*> enabledSteps(const Pipeline& pipeline);
/// The enabled steps as a key.
std::string keyOf(const Pipeline& pipeline);

/// Makes geometry of whole steps on the threads that compute. On large levels some steps are left out, because the next
/// step would wait for the geometry. Thread-safe.
class StepPictures {
 public:
  /// Returns null when the last geometry was made recently, compared with the time it took.
  std::shared_ptr<const NavigationMeshGeometry> make(const NavigationMesh& mesh, const Vec3& centre);

 private:
  std::mutex mutex_;
  RunEventBuffer::Clock::time_point next_;
};

/// Shared by the window and the threads that run the job.
struct RunJob {
  std::shared_ptr<const Environment> environment;
  Vec3 centre;
  Pipeline pipeline;
  int threads = 0;  ///< largest number; 0: all of the machine
  RunPlace place;   ///< where its cells run
  std::shared_ptr<StepMeshes> stepMeshes;
  std::shared_ptr<ResultCache> cache;
  std::string key;
  std::vector<int> ids;                    ///< ids of the enabled steps
  std::vector<const PipelineStep*> steps;  ///< the enabled steps, inside `pipeline`
  std::vector<std::string> prefixes;       ///< prefixes[i]: steps before the enabled step i, and one more for all
  RunEventBuffer::Clock::time_point begun = RunEventBuffer::Clock::now();
  bool follows = false;         ///< an earlier result is shown until more is known
  bool sameEnvironment = true;  ///< the environment is that of the last finished run, so numbers of triangles agree
  std::vector<StepTime>
      times;  ///< times of the steps, and of making the mesh where that is known; empty before they are known
  std::size_t firstChanged = 0;  ///< first step that differs from the last finished run
  /// result of that step in the last finished run, where it is known
  std::shared_ptr<const NavigationMesh> changedBefore;
  /// Changes over the last result: known from the edit itself, or from the first step that differs once it has run.
  EditPreview::Surfaces changes;
  EditPreview::Surfaces changesOfStep;  ///< written by the computing thread before the event of that step
  StepPictures stepPictures;
  std::unique_ptr<RunEventBuffer> events;
  std::unique_ptr<RunContext> context;
  std::unique_ptr<ProcessorWatch> processors;  ///< made when the run begins
};

struct RunOutcome {
  std::shared_ptr<const FinishedRun> finished;
  ViewContent content;
  QString error;  ///< empty: finished or cancelled
};

/// Makes a job with the data that follows from the pipeline: steps, prefixes and key.
std::shared_ptr<RunJob> makeRunJob(const Pipeline& pipeline);
/// Sets the job's context, and a buffer of events that calls `notify` (RunEventBuffer). Meshes of steps are kept.
void listenTo(RunJob& job, std::function<void()> notify);
/// Sets a context that keeps meshes of steps and buffers no events.
void keepStepMeshes(RunJob& job);
/// Finds the first step that differs from those of an earlier run, and its earlier result.
void compareWithEarlier(RunJob& job, const Pipeline& earlier);
/// Runs the job, on any thread. Does not throw.
RunOutcome compute(RunJob& job);

}  // namespace footfall::ui
