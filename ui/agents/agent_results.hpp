// The known results of each agent, for comparison.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "ui/base/work/background_queue.hpp"
#include "ui/document/document.hpp"
#include "ui/run/run_controller.hpp"

namespace footfall::ui {

struct AgentFigures {
  double area = 0;             ///< walkable area of the surface, in square units
  std::size_t layers = 0;      ///< number of layers; 0: no filter made any
  std::size_t components = 0;  ///< components connected over shared edges: areas that an agent does not leave
  std::size_t connections = 0;
};

/// Counts in the background. Figures are kept after their result has been dropped.
class AgentResults : public QObject {
  Q_OBJECT

 public:
  AgentResults(Document& document, RunController& controller, QObject* parent = nullptr);
  ~AgentResults() override;

  /// The figures of the list's filters for this agent; empty while they are not known.
  [[nodiscard]] std::optional<AgentFigures> figures(int agent) const;
  /// Returns whether the agent's result can be shown without a run.
  [[nodiscard]] bool ready(int agent) const;
  /// Runs all agents that are not ready, in the background.
  void computeAll();

 signals:
  void changed();

 private:
  void look();

  Document& document_;
  RunController& controller_;
  std::shared_ptr<const Environment> environment_;            // environment that all figures belong to
  std::map<std::string, std::optional<AgentFigures>> known_;  // by enabled steps; empty: being counted
  std::shared_ptr<RunContext> counting_;
  BackgroundQueue queue_;  // declared last: its thread ends before the other members are destroyed
};

AgentFigures figuresOf(const FinishedRun& run, const RunContext& context);

}  // namespace footfall::ui
