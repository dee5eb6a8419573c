// Walls and ledges told apart in the margins of a result that is shown already.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "ui/base/latest_work.hpp"
#include "ui/run/run_content.hpp"

namespace footfall::ui {

/// Finds in the background which of a run's margins are too near a wall, and which too near a ledge: the run itself
/// shows both as too near a border, and does not wait for that.
class MarginKinds : public QObject {
  Q_OBJECT

 public:
  /// The margins of another result: its job, and what is shown of it. Ends what is under way; begins nothing.
  void setResult(const std::shared_ptr<const RunJob>& job, const RunOutcome& outcome);
  void clear();
  /// Begins to look, or again after stop(); nothing where all is found or it looks already.
  void find();
  /// The processors are wanted for something else.
  void stop() { work_.stop(); }
  /// Not all kinds are known.
  [[nodiscard]] bool pending() const { return job_ != nullptr; }

 signals:
  /// The content of the result, with its margins by kind.
  void found(const footfall::ui::RunOutcome& outcome, const std::string& key);

 private:
  std::shared_ptr<const RunJob> job_;  ///< null: there is nothing to find
  RunOutcome outcome_;
  LatestWork work_;  // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
