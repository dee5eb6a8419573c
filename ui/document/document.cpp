// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/document.hpp"

#include <QUndoCommand>
#include <algorithm>
#include <utility>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "ui/document/agent_rules.hpp"
#include "ui/document/edit_text.hpp"

namespace footfall::ui {
bool sameImport(const ImportOptions& a, const ImportOptions& b) {
  return a.up == b.up && a.metresPerUnit == b.metresPerUnit && a.bothSides == b.bothSides && a.grid == b.grid &&
         a.gridStep == b.gridStep;
}

bool operator==(const DocumentState& a, const DocumentState& b) {
  return a.filters == b.filters && sameImport(a.import, b.import) && a.agents == b.agents && a.agent == b.agent &&
         a.partRules == b.partRules && a.obstacles == b.obstacles;
}

/// Stores the document before and after an edit: a few hundred bytes, and nothing that could become inconsistent. Texts
/// of value edits name the first and the last value, also when several edits were merged.
class DocumentCommand : public QUndoCommand {
 public:
  DocumentCommand(Document& document, DocumentState after, const QString& text, QString mergeKey)
      : document_(document),
        before_(document.state()),
        after_(std::move(after)),
        mergeKey_(std::move(mergeKey)),
        ofValue_(text.isEmpty()) {
    setText(ofValue_ ? valueEditText(before_, after_, document_.units()) : text);
  }

  void undo() override { document_.setState(before_); }
  void redo() override { document_.setState(after_); }
  [[nodiscard]] int id() const override { return mergeKey_.isEmpty() ? -1 : 1; }
  [[nodiscard]] const QString& mergeKey() const { return mergeKey_; }
  [[nodiscard]] const DocumentState& before() const { return before_; }
  [[nodiscard]] const DocumentState& after() const { return after_; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const DocumentCommand*>(other);  // the same id means the same class
    if (next->mergeKey_ != mergeKey_) return false;
    after_ = next->after_;
    setText(ofValue_ ? valueEditText(before_, after_, document_.units()) : next->text());
    setObsolete(before_ == after_);
    return true;
  }

 private:
  Document& document_;
  DocumentState before_, after_;
  QString mergeKey_;
  bool ofValue_;
};

Document::Document(QObject* parent) : QObject(parent) {}

Pipeline Document::pipeline() const {
  Pipeline pipeline;
  for (const FilterEntry& entry : state_.filters) pipeline.steps.push_back(entry.step);
  return pipeline;
}

std::size_t Document::indexOf(int id) const {
  const auto at =
      std::find_if(state_.filters.begin(), state_.filters.end(), [id](const auto& e) { return e.id == id; });
  return static_cast<std::size_t>(at - state_.filters.begin());
}

std::vector<FilterEntry> Document::entriesOf(const Pipeline& pipeline) {
  std::vector<FilterEntry> entries;
  for (const PipelineStep& step : pipeline.steps) {
    entries.push_back({nextId_++, step});
    entries.back().step.line = 0;  // from here on, its row is its place
    entries.back().step.columns.clear();
  }
  return entries;
}

void Document::push(DocumentState next, const QString& text, const QString& mergeKey) {
  if (!activeAgent(next) || !followsAgent(next)) next.agent = 0;
  if (next == state_) return;
  undoStack_.push(new DocumentCommand(*this, std::move(next), text, mergeKey));  // the stack owns it
}

const DocumentState& Document::stateBefore(const QString& mergeKey) const {
  const int last = undoStack_.index() - 1;
  if (mergeKey.isEmpty() || last < 0 || undoStack_.isClean()) return state_;
  // the stack has no other commands
  const auto* command = static_cast<const DocumentCommand*>(undoStack_.command(last));
  return command->mergeKey() == mergeKey ? command->before() : state_;
}

void Document::setState(const DocumentState& state) {
  if (restoring_) {
    state_ = state;
    return;
  }
  const bool filters = !(state.filters == state_.filters);
  const bool import = !sameImport(state.import, state_.import);
  const bool agents = !(state.agents == state_.agents && state.agent == state_.agent);
  const bool level = !(state.partRules == state_.partRules && state.obstacles == state_.obstacles);
  state_ = state;
  if (import) emit importChanged();
  if (agents) emit agentsChanged();
  if (level) emit levelChanged();
  if (filters) emit filtersChanged();
}

void Document::addFilter(const FilterDescriptor& filter, double metresPerUnit) {
  DocumentState next = state_;
  next.filters.push_back({nextId_++, defaultStep(filter, metresPerUnit)});
  writeSizes(next);
  const QString text = tr("Add %1").arg(labelOf(next.filters.back().step));
  push(std::move(next), text);
}

void Document::removeFilter(int id) {
  const std::size_t index = indexOf(id);
  if (index == state_.filters.size()) return;
  DocumentState next = state_;
  const QString text = tr("Remove %1").arg(labelOf(next.filters[index].step));
  next.filters.erase(next.filters.begin() + static_cast<std::ptrdiff_t>(index));
  push(std::move(next), text);
}

void Document::moveFilter(int id, std::size_t index) {
  const std::size_t from = indexOf(id);
  if (from == state_.filters.size()) return;
  DocumentState next = state_;
  const FilterEntry moved = next.filters[from];
  next.filters.erase(next.filters.begin() + static_cast<std::ptrdiff_t>(from));
  next.filters.insert(next.filters.begin() + static_cast<std::ptrdiff_t>(std::min(index, next.filters.size())), moved);
  push(std::move(next), (index < from ? tr("Move %1 up") : tr("Move %1 down")).arg(labelOf(moved.step)));
}

void Document::setEnabled(int id, bool enabled) {
  const std::size_t index = indexOf(id);
  if (index == state_.filters.size()) return;
  DocumentState next = state_;
  next.filters[index].step.enabled = enabled;
  const QString text = enabled ? tr("Switch on %1") : tr("Switch off %1");
  push(std::move(next), text.arg(labelOf(state_.filters[index].step)));
}

void Document::setValue(int id, std::size_t parameter, double value, int editSession) {
  const std::size_t index = indexOf(id);
  if (index == state_.filters.size() || parameter >= state_.filters[index].step.values.size()) return;
  const QString mergeKey =
      editSession < 0 ? QString() : QStringLiteral("%1/%2/%3").arg(id).arg(parameter).arg(editSession);
  // Values that follow another one do so from the beginning of the edit: intermediate values have no effect.
  DocumentState next = stateBefore(mergeKey);
  PipelineStep& step = next.filters[index].step;
  const double before = std::exchange(step.values[parameter], value);
  for (std::size_t i = 0; i < step.values.size(); ++i)
    if (step.filter->parameterOf(i).follows == static_cast<int>(parameter) && step.values[i] == before)
      step.values[i] = value;
  const auto size = agentSizeOf(*step.filter, parameter);
  const auto agent = std::ranges::find(next.agents, next.agent, &NamedAgent::id);
  if (size && agent != next.agents.end()) {
    setSizeOf(*agent, *size, value);
    writeSizes(next);
  }
  push(std::move(next), {}, mergeKey);
}

bool Document::addParallelBlock() {
  const std::vector<FilterEntry>& filters = state_.filters;
  struct Stretch {
    std::size_t first = 0, end = 0, weight = 0;
  };
  Stretch best, current;
  bool inBlock = false;
  for (std::size_t i = 0; i < filters.size(); ++i) {
    const PipelineStep& step = filters[i].step;
    if (!step.enabled) continue;
    if (step.filter->kind != FilterKind::Filter) inBlock = step.filter->kind == FilterKind::Strategy;
    // A StepFilter may stand in a block, but runs on all cells together.
    if (step.filter->kind != FilterKind::Filter || step.filter->scope == Scope::Global || inBlock ||
        step.filter->type == FilterType::Step) {
      current = {};
      continue;
    }
    if (current.weight == 0) current.first = i;
    current.end = i + 1;
    // Clearance is nearly all of the work.
    current.weight += step.filter->type == FilterType::VerticalClearance ? filters.size() : 1;
    if (current.weight > best.weight) best = current;
  }
  if (best.weight == 0) return false;
  DocumentState next = state_;
  const auto insert = [&](std::size_t index, FilterType type) {
    next.filters.insert(next.filters.begin() + static_cast<std::ptrdiff_t>(index),
                        {nextId_++, defaultStep(filterDescriptor(type), 1)});
  };
  insert(best.end, FilterType::Collapse);
  insert(best.first, FilterType::AutoStrategy);
  push(std::move(next), tr("Run in parallel"));
  return true;
}

void Document::replacePipeline(const Pipeline& pipeline, const QString& text) {
  setImportAndPipeline(state_.import, pipeline, text);
}

void Document::setImportAndPipeline(const ImportOptions& options, const Pipeline& pipeline, const QString& text,
                                    const QString& mergeKey, const std::optional<std::vector<NamedAgent>>& agents) {
  DocumentState next = state_;
  next.import = options;
  if (agents) next.agents = *agents;
  if (!(pipeline == this->pipeline())) {
    std::vector<FilterEntry> entries = entriesOf(pipeline);
    // Rows whose filter stays in place keep their identity.
    for (std::size_t i = 0; i < entries.size() && i < state_.filters.size(); ++i) {
      if (entries[i].step.filter == state_.filters[i].step.filter) entries[i].id = state_.filters[i].id;
    }
    next.filters = std::move(entries);
  }
  if (agents) writeSizes(next);
  push(std::move(next), text, mergeKey);
}

void Document::edit(DocumentState next, const QString& text, const QString& mergeKey) {
  push(std::move(next), text, mergeKey);
}

void Document::reset(const Pipeline& pipeline, const ImportOptions& import) { reset(pipeline, import, {}); }

void Document::reset(const Pipeline& pipeline, const ImportOptions& import, DocumentState rest) {
  undoStack_.clear();
  state_ = std::move(rest);
  state_.import = import;
  state_.filters = entriesOf(pipeline);
  if (!followsAgent(state_)) state_.agent = 0;
  emit importChanged();
  emit agentsChanged();
  emit levelChanged();
  emit filtersChanged();
}

EditHistory Document::history() const {
  EditHistory history;
  history.first = state_;
  history.index = undoStack_.index();
  history.clean = undoStack_.cleanIndex();
  for (int i = 0; i < undoStack_.count(); ++i) {
    // the stack has no other commands
    const auto* command = static_cast<const DocumentCommand*>(undoStack_.command(i));
    if (i == 0) history.first = command->before();
    history.edits.push_back({command->text(), command->after()});
  }
  return history;
}

bool Document::restoreHistory(const EditHistory& history) {
  const auto index = static_cast<std::size_t>(history.index);
  const DocumentState& there = index == 0 ? history.first : history.edits[index - 1].after;
  const auto isSame = [](const FilterEntry& a, const FilterEntry& b) { return a.step == b.step; };
  DocumentState expected = there;
  expected.filters = state_.filters;
  if (!(expected == state_) || !std::ranges::equal(there.filters, state_.filters, isSame)) return false;
  const DocumentState present = there;  // its rows have the numbers that they have in all other states
  undoStack_.clear();
  restoring_ = true;
  state_ = history.first;
  for (const EditHistory::Edit& edit : history.edits)
    undoStack_.push(new DocumentCommand(*this, edit.after, edit.text, {}));  // the stack owns it
  if (history.clean >= 0 && history.clean <= undoStack_.count()) {
    undoStack_.setIndex(history.clean);
    undoStack_.setClean();
  } else {
    undoStack_.resetClean();
  }
  undoStack_.setIndex(history.index);
  restoring_ = false;
  state_ = present;
  const auto note = [this](const DocumentState& state) {
    for (const FilterEntry& entry : state.filters) nextId_ = std::max(nextId_, entry.id + 1);
  };
  note(history.first);
  for (const EditHistory::Edit& edit : history.edits) note(edit.after);
  emit filtersChanged();
  return true;
}

Pipeline rescaleLengths(const Pipeline& pipeline, double fromMetresPerUnit, double toMetresPerUnit) {
  if (fromMetresPerUnit == toMetresPerUnit) return pipeline;
  Pipeline rescaled = rescaleDefaults(pipeline, fromMetresPerUnit, toMetresPerUnit);
  LevelUnits from, to;
  from.metresPerUnit = fromMetresPerUnit;
  to.metresPerUnit = toMetresPerUnit;
  from.scaleKnown = to.scaleKnown = true;
  for (std::size_t s = 0; s < rescaled.steps.size(); ++s) {
    PipelineStep& step = rescaled.steps[s];
    const PipelineStep defaults = defaultStep(*step.filter, fromMetresPerUnit);
    for (std::size_t i = 0; i < defaults.values.size(); ++i) {  // the places behind the defaults are left out
      const double before = pipeline.steps[s].values[i];
      const Unit unit = step.filter->parameters[i].unit;
      if (before == defaults.values[i] || (unit != Unit::Length && unit != Unit::Area)) continue;
      const double value = to.stored(from.shown(before, unit), unit);
      if (checkValue(step.filter->parameters[i], value).empty()) step.values[i] = value;
    }
  }
  return rescaled;
}

Pipeline rescaleDefaults(const Pipeline& pipeline, double fromMetresPerUnit, double toMetresPerUnit) {
  Pipeline rescaled = pipeline;
  for (PipelineStep& step : rescaled.steps) {
    const PipelineStep before = defaultStep(*step.filter, fromMetresPerUnit);
    const PipelineStep after = defaultStep(*step.filter, toMetresPerUnit);
    for (std::size_t i = 0; i < before.values.size(); ++i) {
      if (step.values[i] == before.values[i]) step.values[i] = after.values[i];
    }
  }
  return rescaled;
}

}  // namespace footfall::ui
