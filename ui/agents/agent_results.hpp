// What is known of the results of each agent, to compare them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "ui/base/background_queue.hpp"
#include "ui/document/document.hpp"
#include "ui/run/run_controller.hpp"

namespace footfall::ui {

struct AgentFigures {
  double area = 0;             ///< walkable, of the surface, in square units
  std::size_t layers = 0;      ///< 0: no filter made any
  std::size_t components = 0;  ///< that hang together over shared edges: where an agent gets to without leaving it
  std::size_t connections = 0;
};

/// Counts in the background. Figures stay known when the result itself had to go.
class AgentResults : public QObject {
  Q_OBJECT

 public:
  AgentResults(Document& document, RunController& controller, QObject* parent = nullptr);
  ~AgentResults() override;

  /// What the filters, as the list has them, give for this agent; nothing while that is not known.
  [[nodiscard]] std::optional<AgentFigures> figures(int agent) const;
  /// Whether switching to the agent shows its result without a run.
  [[nodiscard]] bool ready(int agent) const;
  /// Runs all agents that are not ready, in the background.
  void computeAll();

 signals:
  void changed();

 private:
  void look();

  Document& document_;
  RunController& controller_;
  std::shared_ptr<const Environment> environment_;            // that all of this belongs to
  std::map<std::string, std::optional<AgentFigures>> known_;  // by enabled steps; empty: being counted
  std::shared_ptr<RunContext> counting_;
  BackgroundQueue queue_;  // last: its thread ends before the rest goes
};

AgentFigures figuresOf(const FinishedRun& run, const RunContext& context);

}  // namespace footfall::ui
