// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/agent_results.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <utility>
#include <vector>

#include "core/filters/disjoint_sets.hpp"
#include "ui/agent_rules.hpp"

namespace footfall {
namespace {

constexpr std::size_t kKnown = 200;  // figures: a few words each

std::string keyOf(Pipeline pipeline) {
  std::erase_if(pipeline.steps, [](const PipelineStep& step) { return !step.enabled; });
  return formatPipeline(pipeline);
}

std::size_t countComponents(const NavigationMesh& mesh, const RunContext& context) {
  std::vector<std::pair<std::array<std::uint32_t, 2>, Index>> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[i][k];
      const std::uint32_t b = mesh.triangles[i][(k + 1) % 3];
      sides.push_back({{std::min(a, b), std::max(a, b)}, static_cast<Index>(i)});
    }
  }
  context.checkCancelled();
  std::ranges::sort(sides);
  context.checkCancelled();
  DisjointSets sets(mesh.triangles.size());
  std::size_t count = mesh.triangles.size();
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i].first != sides[i - 1].first) continue;
    const Index a = sets.find(sides[i - 1].second);
    const Index b = sets.find(sides[i].second);
    if (a == b) continue;
    sets.unite(a, b);
    --count;
  }
  return count;
}

}  // namespace

AgentFigures figuresOf(const FinishedRun& run, const RunContext& context) {
  const NavigationMesh& mesh = *run.result.mesh;
  return {run.result.summary.area, mesh.layerCount, countComponents(mesh, context), mesh.connections.size()};
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
  for (const Agent& agent : document_.state().agents) {
    if (!ready(agent.id)) wanted.push_back(pipelineFor(document_.state(), agent.id));
  }
  controller_.runAhead(std::move(wanted));
}

// Counts what has become known.
void AgentResults::look() {
  if (environment_ != controller_.environment() || known_.size() > kKnown) {
    environment_ = controller_.environment();
    known_.clear();
    counting_->cancel();
    counting_ = std::make_shared<RunContext>();
  }
  for (const Agent& agent : document_.state().agents) {
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
        return;  // cancelled, or memory ran out: then there are none
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

}  // namespace footfall
