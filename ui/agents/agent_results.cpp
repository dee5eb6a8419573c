// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/agents/agent_results.hpp"

#include <algorithm>
#include <exception>
#include <utility>
#include <vector>

#include "footfall/inspect.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/document/agent_rules.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kKnown = 200;  // entries of a few words each

}  // namespace

AgentFigures figuresOf(const FinishedRun& run, const RunContext& context) {
  const NavigationMesh& mesh = *run.result.mesh;
  const Components components = findComponents(mesh, &context);
  return {run.result.summary.area, mesh.layerCount, components.list.size(), mesh.connections.size()};
}

AgentResults::AgentResults(Document& document, RunController& controller, QObject* parent)
    : QObject(parent), document_(document), controller_(controller), counting_(std::make_shared<RunContext>()) {
  connect(&controller_, &RunController::finished, this, &AgentResults::look);
  connect(&controller_, &RunController::aheadChanged, this, &AgentResults::look);
  connect(&document_, &Document::agentsChanged, this, &AgentResults::look);
  connect(&document_, &Document::filtersChanged, this, &AgentResults::look);
}

AgentResults::~AgentResults() { counting_->cancel(); }

std::optional<AgentFigures> AgentResults::figures(int agent) const {
  const auto found = known_.find(keyOf(pipelineFor(document_.state(), agent)));
  return found == known_.end() || environment_ != controller_.environment() ? std::nullopt : found->second;
}

bool AgentResults::ready(int agent) const {
  return controller_.finishedRunOf(pipelineFor(document_.state(), agent)) != nullptr;
}

void AgentResults::computeAll() {
  std::vector<Pipeline> wanted;
  for (const NamedAgent& agent : document_.state().agents) {
    if (!ready(agent.id)) wanted.push_back(pipelineFor(document_.state(), agent.id));
  }
  controller_.runAhead(std::move(wanted));
}

// Counts results that have become available.
void AgentResults::look() {
  if (environment_ != controller_.environment() || known_.size() > kKnown) {
    environment_ = controller_.environment();
    known_.clear();
    counting_->cancel();
    counting_ = std::make_shared<RunContext>();
  }
  for (const NamedAgent& agent : document_.state().agents) {
    const Pipeline pipeline = pipelineFor(document_.state(), agent.id);
    const std::string key = keyOf(pipeline);
    const auto run = controller_.finishedRunOf(pipeline);
    if (!run || known_.contains(key)) continue;
    known_[key] = std::nullopt;
    queue_.post([this, key, run, context = counting_] {
      AgentFigures figures;
      try {
        figures = figuresOf(*run, *context);
      } catch (const std::exception&) {
        return;  // counting was cancelled, or memory ran out: there are no figures
      }
      const auto keep = [this, key, figures, context] {
        if (context != counting_) return;
        known_[key] = figures;
        emit changed();
      };
      QMetaObject::invokeMethod(this, keep, Qt::QueuedConnection);
    });
  }
  emit changed();
}

}  // namespace footfall::ui
