// What the user edits, with undo: filters, agents, import options, the roles of parts, and obstacles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/environment/part_rules.hpp"
#include "core/environment/placed_obstacle.hpp"
#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"
#include "ui/base/level_units.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/document/agent.hpp"

namespace footfall::ui {

/// A step that keeps its identity while it is moved and edited, so that its row and its state can follow it.
struct FilterEntry {
  int id = 0;  ///< unique in its document, never used again
  PipelineStep step;
  bool operator==(const FilterEntry&) const = default;
};

struct DocumentState {
  std::vector<FilterEntry> filters;
  ImportOptions import;
  std::vector<NamedAgent> agents;
  int agent = 0;  ///< id of the one whose filters these are; 0: none
  std::vector<PartRule> partRules;
  std::vector<PlacedObstacle> obstacles;
};

/// The edits of a document, which can be undone.
struct EditHistory {
  struct Edit {
    QString text;
    DocumentState after;
  };
  DocumentState first;      ///< before all edits
  std::vector<Edit> edits;  ///< also those that were undone
  int index = 0;            ///< so many of them are in force
  int clean = -1;           ///< so many were, when the document was saved last; -1: that state is gone
};

bool sameImport(const ImportOptions& a, const ImportOptions& b);
bool operator==(const DocumentState& a, const DocumentState& b);

/// Every edit is one entry of the undo stack; an edit that changes nothing is none. Edits with the same merge key that
/// follow each other become one entry. No agent is active any more after an edit that leaves filters with other sizes
/// than the active one's (ui/document/agent_rules.hpp).
class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(QObject* parent = nullptr);

  [[nodiscard]] const DocumentState& state() const { return state_; }
  [[nodiscard]] const std::vector<FilterEntry>& filters() const { return state_.filters; }
  [[nodiscard]] Pipeline pipeline() const;
  [[nodiscard]] QUndoStack* undoStack() { return &undoStack_; }
  /// The units in which texts of edits give lengths.
  void setUnits(const LevelUnits& units) { units_ = units; }
  [[nodiscard]] const LevelUnits& units() const { return units_; }

  void addFilter(const FilterDescriptor& filter, double metresPerUnit);
  void removeFilter(int id);
  /// `index` counts in the list without the moved entry.
  void moveFilter(int id, std::size_t index);
  void setEnabled(int id, bool enabled);
  /// `value` must be valid (checkValue). Values of one edit session of the same field are one edit; a negative one is
  /// an edit of its own. A size of the active agent changes that agent, and with it all filters that take the size.
  void setValue(int id, std::size_t parameter, double value, int editSession);
  /// Puts an AutoStrategy and a Collapse around the most local filters in a row (with a clearance among them, where
  /// there is one), one edit. False when there is no local filter that is switched on outside of a block.
  bool addParallelBlock();
  void replacePipeline(const Pipeline& pipeline, const QString& text);
  /// Import options, pipeline and, where given, the sizes of the agents together, one edit.
  void setImportAndPipeline(const ImportOptions& options, const Pipeline& pipeline, const QString& text,
                            const QString& mergeKey = {},
                            const std::optional<std::vector<NamedAgent>>& agents = std::nullopt);

  /// Any edit as one entry; entries with the same merge key (not empty) that follow each other become one. An empty
  /// text is made from the value that is different.
  void edit(DocumentState next, const QString& text, const QString& mergeKey = {});
  /// An id for a filter that an edit() adds.
  [[nodiscard]] int newFilterId() { return nextId_++; }

  /// Starts anew, without undo. The overload replaces filters and import options and takes the rest from `rest`.
  void reset(const Pipeline& pipeline, const ImportOptions& import);
  void reset(const Pipeline& pipeline, const ImportOptions& import, DocumentState rest);

  [[nodiscard]] EditHistory history() const;
  /// Takes over the edits that led to the present state, without changing that. False, and nothing is done, where they
  /// lead to another one.
  bool restoreHistory(const EditHistory& history);

 signals:
  void filtersChanged();
  void importChanged();
  void agentsChanged();
  /// The roles of parts or the obstacles are others: what runs compute on is another environment.
  void levelChanged();

 private:
  friend class DocumentCommand;
  std::vector<FilterEntry> entriesOf(const Pipeline& pipeline);
  void push(DocumentState next, const QString& text, const QString& mergeKey = {});
  /// Before the edit that one with this key would become one with.
  [[nodiscard]] const DocumentState& stateBefore(const QString& mergeKey) const;
  void setState(const DocumentState& state);
  [[nodiscard]] std::size_t indexOf(int id) const;

  DocumentState state_;
  QUndoStack undoStack_;
  int nextId_ = 1;
  bool restoring_ = false;  ///< edits are put on the stack that have been made already
  LevelUnits units_;
};

/// Values of lengths and areas that are defaults at one scale become the defaults of the other.
Pipeline rescaleDefaults(const Pipeline& pipeline, double fromMetresPerUnit, double toMetresPerUnit);
/// All lengths and areas stay the same in metres. Places (values that repeat) stay where they are in the file.
Pipeline rescaleLengths(const Pipeline& pipeline, double fromMetresPerUnit, double toMetresPerUnit);

}  // namespace footfall::ui
