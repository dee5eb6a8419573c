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
#include "ui/view/edit_preview.hpp"

namespace footfall::ui {

/// Previews of edits of the last finished run's steps, prepared in the background once its result is on the screen. A
/// step is named by the steps before it and its filter.
class EditPreviews : public QObject {
  Q_OBJECT

 public:
  EditPreviews() = default;
  ~EditPreviews() override { stop(); }

  /// Null while there is none.
  [[nodiscard]] const EditPreview* find(const std::string& step) const;
  /// Another run has finished: what suits its steps is kept, what is missing is for prepare().
  void follow(std::vector<std::pair<std::string, EditedStep>> steps);
  /// As long as nobody calls stop().
  void prepare(const std::shared_ptr<const Environment>& environment, const Vec3& centre);
  /// A run wants the processors.
  void stop();
  void clear();

 private:
  std::map<std::string, std::shared_ptr<const EditPreview>> known_;
  std::vector<std::pair<std::string, EditedStep>> missing_;
  std::shared_ptr<RunContext> context_ = std::make_shared<RunContext>();
  BackgroundQueue queue_;  // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
