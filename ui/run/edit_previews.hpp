// Previews of edits that need no run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "footfall/run_context.hpp"
#include "ui/base/work/background_queue.hpp"
#include "ui/run/run_job.hpp"
#include "ui/view/previews/edit_preview.hpp"

namespace footfall::ui {

/// Previews of edits of the last finished run's steps, prepared in the background once its result is on the screen. A
/// step is identified by the steps before it and its filter. Edits of one step's values are most of the edits that
/// users make while they look at the view.
class EditPreviews : public QObject {
  Q_OBJECT

 public:
  EditPreviews() = default;
  ~EditPreviews() override { stop(); }

  /// Returns whether the step has a preview, identified by the steps before it.
  [[nodiscard]] bool knows(const std::string& prefix, const PipelineStep& step) const;
  /// The changes of a job over the result of an earlier run, where they differ in the values of one step; else none.
  [[nodiscard]] EditPreview::Surfaces changes(const RunJob& job, const Pipeline& earlier) const;
  /// Called when another run has finished. Previews that suit its steps are kept; prepare() makes the missing ones.
  void follow(const RunJob& job, const std::shared_ptr<const NavigationMesh>& result);
  /// Prepares previews in the background until stop() is called.
  void prepare(const std::shared_ptr<const Environment>& environment, const Vec3& centre);
  /// Stops preparing, because a run needs the processors.
  void stop();
  void clear();

 private:
  struct Missing {
    std::string name;
    EditedStep step;
    /// Makes EditedStep::product; empty for filters that do not need it. May throw.
    std::function<std::shared_ptr<const NavigationMesh>(RunContext&)> makeProduct;
    std::shared_ptr<RunContext> asked = nullptr;  ///< of the preparation that is under way; another one was stopped
  };

  std::map<std::string, std::shared_ptr<const EditPreview>> known_;
  std::vector<Missing> missing_;
  std::shared_ptr<RunContext> context_ = std::make_shared<RunContext>();
  BackgroundQueue queue_;  // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
