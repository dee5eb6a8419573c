// Edits the document's obstacles: the selected one, edits with names for undo, and drags whose result follows.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <optional>

#include "core/environment/placed_obstacle.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/document/document.hpp"
#include "ui/level/level_composer.hpp"
#include "ui/run/run_controller.hpp"

namespace footfall::ui {

/// Edits obstacles for the tools in the view and for the panel, which share it. During a drag, the document gets the
/// newest place whenever no run is under way, or when the mouse has rested for 150 ms. The next movement thus cancels
/// no run, and at most one run waits. A drag is one entry of the undo stack.
class ObstacleEditor : public QObject {
  Q_OBJECT

 public:
  ObstacleEditor(Document& document, LevelComposer& composer, RunController& controller, QObject* parent = nullptr);

  [[nodiscard]] const std::vector<PlacedObstacle>& obstacles() const { return document_.state().obstacles; }
  /// An obstacle at its place under the mouse while it is dragged; null when there is none with this id.
  [[nodiscard]] const PlacedObstacle* find(std::uint32_t id) const;
  [[nodiscard]] const PlacedObstacle* selected() const { return selected_ ? find(*selected_) : nullptr; }
  void select(std::optional<std::uint32_t> id);

  /// A new obstacle of one metre each way, in the environment's units.
  [[nodiscard]] PlacedObstacle makeDefault(PlacedObstacle::Shape shape) const;
  /// The step to which dragged lengths are rounded, about a centimetre; with `coarse`, about a quarter of a metre.
  [[nodiscard]] double step(bool coarse) const;

  /// Sets the unit in which steps and sizes of new obstacles are round.
  void setUnits(const LevelUnits& units) { units_ = units; }
  [[nodiscard]] const LevelUnits& units() const { return units_; }

  // Edits that can be undone. Each of them ends a drag first.

  /// Adds an obstacle with a new id, and with a name where it has none, and selects it. Returns the id.
  std::uint32_t add(PlacedObstacle obstacle);
  /// Adds a copy at the same place plus `offset`, and selects it.
  std::optional<std::uint32_t> duplicate(std::uint32_t id, const Vec3& offset);
  void remove(std::uint32_t id);
  /// Replaces the obstacle with the id of `next`. `text` names the edit, with %1 for the obstacle; consecutive edits
  /// with the same merge key are one.
  void change(const PlacedObstacle& next, const QString& text, const QString& mergeKey = {});

  /// Changes an obstacle like change(), for edits that follow each other quickly (a key that is held, a number that is
  /// typed). They count as a drag, which ends when no further edit follows for a while. Without a merge key, the edits
  /// between two pauses are one.
  void changeSoon(const PlacedObstacle& next, const QString& text, const QString& mergeKey = {});

  // Drags of the mouse.

  /// `text` is as for change().
  void beginDrag(std::uint32_t id, const QString& text);
  /// Begins to drag a copy, which is made with the first movement.
  void beginDragOfCopy(std::uint32_t id);
  void dragTo(const PlacedObstacle& next);
  void endDrag();
  /// Restores the state before the drag.
  void cancelDrag();
  [[nodiscard]] bool dragging() const { return drag_.has_value(); }

  static QString nameOf(PlacedObstacle::Shape shape);

 signals:
  /// Emitted when obstacles or the selection changed, or the dragged obstacle moved.
  void changed();

 private:
  struct Drag {
    std::uint32_t id = 0;
    QString text, mergeKey;
    PlacedObstacle live;
    DocumentState before;
    bool committed = false;  ///< the document has an entry for it
  };

  [[nodiscard]] double roundShown(double metres) const;
  [[nodiscard]] const PlacedObstacle* inDocument(std::uint32_t id) const;
  [[nodiscard]] QString newName(const QString& stem) const;
  [[nodiscard]] std::uint32_t newId() const;
  void startDrag(const PlacedObstacle& live, const QString& text, const QString& mergeKey = {});
  void commit();
  void documentChanged();

  Document& document_;
  LevelComposer& composer_;
  RunController& controller_;
  LevelUnits units_;
  std::optional<std::uint32_t> selected_;
  std::optional<Drag> drag_;
  bool committing_ = false;
  int drags_ = 0;
  QTimer rest_;   ///< rest of the mouse
  QTimer pause_;  ///< ends an edit of changeSoon()
};

}  // namespace footfall::ui
