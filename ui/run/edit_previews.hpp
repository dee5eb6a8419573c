// What can be shown of edits without a run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "footfall/run_context.hpp"
#include "ui/base/background_queue.hpp"
#include "ui/run/run_job.hpp"
#include "ui/view/edit_preview.hpp"

namespace footfall::ui {

/// Previews of edits of the last finished run's steps, prepared in the background once its result is on the screen. A
/// step is named by the steps before it and its filter. An edit of one step's values stands for most of what somebody
/// does here while looking at the view.
class EditPreviews : public QObject {
  Q_OBJECT

 public:
  EditPreviews() = default;
  ~EditPreviews() override { stop(); }

  /// Whether the step has one, by the steps before it.
  [[nodiscard]] bool knows(const std::string& prefix, const PipelineStep& step) const;
  /// What a job changes over the result of an earlier run, where they differ in the values of one step; else
  /// nothing.
  [[nodiscard]] EditPreview::Surfaces changes(const RunJob& job, const Pipeline& earlier) const;
  /// Another run has finished: what suits its steps is kept, what is missing is for prepare().
  void follow(const RunJob& job, const std::shared_ptr<const NavigationMesh>& result);
  /// Prepares previews in the background, until stop() is called.
  void prepare(const std::shared_ptr<const Environment>& environment, const Vec3& centre);
  /// Stops preparing, as a run wants the processors.
  void stop();
  void clear();

 private:
  std::map<std::string, std::shared_ptr<const EditPreview>> known_;
  std::vector<std::pair<std::string, EditedStep>> missing_;
  std::shared_ptr<RunContext> context_ = std::make_shared<RunContext>();
  BackgroundQueue queue_;  // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
