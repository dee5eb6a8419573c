// The document that the user edits, with undo: filters, agents, import options, the roles of parts, and obstacles.
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
#include "ui/base/namespaces.hpp"
#include "ui/base/text/level_units.hpp"
#include "ui/document/named_agent.hpp"

namespace footfall::ui {

/// A step with an identity that is kept while it is moved and edited, so that its row and its state belong to it.
struct FilterEntry {
  int id = 0;  ///< unique in its document, never used again
  PipelineStep step;
  bool operator==(const FilterEntry&) const = default;
};

struct DocumentState {
  std::vector<FilterEntry> filters;
  ImportOptions import;
  std::vector<NamedAgent> agents;
  int agent = 0;  ///< id of the agent whose sizes the filters have; 0: none
  std::vector<PartRule> partRules;
  std::vector<PlacedObstacle> obstacles;
};

/// The edits of a document, which can be undone.
struct EditHistory {
  struct Edit {
    QString text;
    DocumentState after;
  };
  DocumentState first;      ///< state before all edits
  std::vector<Edit> edits;  ///< includes edits that were undone
  int index = 0;            ///< number of edits in force
  int clean = -1;           ///< index when the document was saved last; -1: that state is gone
};

bool sameImport(const ImportOptions& a, const ImportOptions& b);
bool operator==(const DocumentState& a, const DocumentState& b);

/// Every edit is one entry of the undo stack; an edit that changes nothing makes no entry. Consecutive edits with the
/// same merge key become one entry. The active agent is deactivated by an edit that leaves filters with other sizes
/// than its own (ui/document/agent_rules.hpp).
class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(QObject* parent = nullptr);

  [[nodiscard]] const DocumentState& state() const { return state_; }
  [[nodiscard]] const std::vector<FilterEntry>& filters() const { return state_.filters; }
  [[nodiscard]] Pipeline pipeline() const;
  [[nodiscard]] QUndoStack* undoStack() { return &undoStack_; }
  /// The units of lengths in the texts of edits.
  void setUnits(const LevelUnits& units) { units_ = units; }
  [[nodiscard]] const LevelUnits& units() const { return units_; }

  void addFilter(const FilterDescriptor& filter, double metresPerUnit);
  void removeFilter(int id);
  /// `index` counts in the list without the moved entry.
  void moveFilter(int id, std::size_t index);
  void setEnabled(int id, bool enabled);
  /// `value` must be valid (checkValue). Values of one edit session of the same field are one edit; a negative session
  /// makes an edit of its own. A size of the active agent changes that agent, and with it all filters that have the
  /// size.
  void setValue(int id, std::size_t parameter, double value, int editSession);
  /// Puts an AutoStrategy and a Collapse around the longest sequence of local filters (with a clearance among them,
  /// where there is one), as one edit. Returns false when no local filter outside of a block is on.
  bool addParallelBlock();
  void replacePipeline(const Pipeline& pipeline, const QString& text);
  /// Sets import options, the pipeline and, where given, the sizes of the agents, as one edit.
  void setImportAndPipeline(const ImportOptions& options, const Pipeline& pipeline, const QString& text,
                            const QString& mergeKey = {},
                            const std::optional<std::vector<NamedAgent>>& agents = std::nullopt);

  /// Applies any edit as one entry; consecutive edits with the same non-empty merge key become one. An empty text is
  /// made from the value that differs.
  void edit(DocumentState next, const QString& text, const QString& mergeKey = {});
  /// An id for a filter that an edit() adds.
  [[nodiscard]] int newFilterId() { return nextId_++; }

  /// Replaces the document, without undo. The overload replaces filters and import options and takes the rest from
  /// `rest`.
  void reset(const Pipeline& pipeline, const ImportOptions& import);
  void reset(const Pipeline& pipeline, const ImportOptions& import, DocumentState rest);

  [[nodiscard]] EditHistory history() const;
  /// Restores the edits that led to the present state, without changing the state. Returns false, with nothing changed,
  /// where they lead to another state.
  bool restoreHistory(const EditHistory& history);

 signals:
  void filtersChanged();
  void importChanged();
  void agentsChanged();
  /// Emitted when the roles of parts or the obstacles changed: runs then compute on another environment.
  void levelChanged();

 private:
  friend class DocumentCommand;
  std::vector<FilterEntry> entriesOf(const Pipeline& pipeline);
  void push(DocumentState next, const QString& text, const QString& mergeKey = {});
  /// The state before the edit that an edit with this key would be merged with.
  [[nodiscard]] const DocumentState& stateBefore(const QString& mergeKey) const;
  void setState(const DocumentState& state);
  [[nodiscard]] std::size_t indexOf(int id) const;

  DocumentState state_;
  QUndoStack undoStack_;
  int nextId_ = 1;
  bool restoring_ = false;  ///< edits that are already applied are being put on the stack
  LevelUnits units_;
};

/// Values of lengths and areas that are defaults at one scale become the defaults at the other.
Pipeline rescaleDefaults(const Pipeline& pipeline, double fromMetresPerUnit, double toMetresPerUnit);
/// All lengths and areas stay the same in metres. Places (repeated values) keep their coordinates in the file.
Pipeline rescaleLengths(const Pipeline& pipeline, double fromMetresPerUnit, double toMetresPerUnit);

}  // namespace footfall::ui
