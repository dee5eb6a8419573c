// Divides the margins of a shown result into those of walls and those of ledges.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "ui/base/work/latest_work.hpp"
#include "ui/run/run_content.hpp"

namespace footfall::ui {

/// Finds in the background which of a run's margins are too near a wall, and which too near a ledge. The run itself
/// shows both as too near a border, so that it need not wait for this.
class MarginKinds : public QObject {
  Q_OBJECT

 public:
  /// Sets the margins of another result: its job, and its shown content. Ends the present work and begins none.
  void setResult(const std::shared_ptr<const RunJob>& job, const RunOutcome& outcome);
  void clear();
  /// Begins the work, or continues it after stop(); has no effect where all is found or the work runs.
  void find();
  /// Stops the work, because a run needs the processors.
  void stop() { work_.stop(); }
  /// Returns whether some kinds are not known yet.
  [[nodiscard]] bool pending() const { return job_ != nullptr; }

 signals:
  /// Emitted with the content of the result, its margins divided by kind.
  void found(const footfall::ui::RunOutcome& outcome, const std::string& key);

 private:
  std::shared_ptr<const RunJob> job_;  ///< null: there is nothing to find
  RunOutcome outcome_;
  LatestWork work_;  // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
