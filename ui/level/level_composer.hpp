// The level that runs compute on: the loaded environment with the document's part roles and obstacles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/environment/placed_obstacle.hpp"
#include "footfall/environment.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/document/document.hpp"
#include "ui/level/part_level.hpp"

namespace footfall::ui {

/// Applies the document's part rules and obstacles. Obstacles are solid, and their triangles come after all others.
/// Even if an edit changes several obstacles (undo and sessions do), the level is one edit (EnvironmentEdit) of the
/// last level that has results, so that runs compute only the difference, and overtaken runs cost nothing later.
class LevelComposer : public QObject {
  Q_OBJECT

 public:
  explicit LevelComposer(Document& document, QObject* parent = nullptr);

  /// Sets an environment as its file gave it (null: none), with the present document; emits no signal.
  void setLoaded(std::shared_ptr<const Environment> loaded,
                 std::shared_ptr<const EnvironmentGeometry> geometry = nullptr);
  /// Sets the same file, read again; edited() follows when something differs. `whole` is the environment that it is a
  /// part of, null for all of it.
  void replaceLoaded(std::shared_ptr<const Environment> loaded, std::shared_ptr<const WholeBounds> whole = nullptr);
  /// The loaded environment with the roles of its parts, before obstacles.
  [[nodiscard]] PartLevel& parts() { return parts_; }
  /// Returns whether roles are being applied; edited() follows.
  [[nodiscard]] bool busy() const { return parts_.busy(); }
  /// The level; null when nothing is loaded.
  [[nodiscard]] const std::shared_ptr<const Environment>& level() const { return current_.level; }
  /// The level without obstacles; its triangles are the first ones of the level.
  [[nodiscard]] const std::shared_ptr<const Environment>& base() const { return base_; }
  /// Called when a run on this level has finished. Levels that are no longer known are ignored.
  void setComputed(const std::shared_ptr<const Environment>& level);

  /// A range of triangles of the level.
  struct Triangles {
    std::uint32_t first = 0, count = 0;
  };
  /// The triangles of an obstacle; none when the level does not have it.
  [[nodiscard]] Triangles trianglesOf(std::uint32_t obstacle) const;
  /// Id of the obstacle that a triangle of the level belongs to.
  [[nodiscard]] std::optional<std::uint32_t> obstacleOf(std::uint32_t triangle) const;

 signals:
  /// Emitted when an edit of the document has made another level.
  void edited(const std::shared_ptr<const footfall::Environment>& level);
  /// Emitted when an obstacle cannot be part of the level; the others are.
  void failed(const QString& message);

 private:
  struct Placed {
    PlacedObstacle obstacle;
    Triangles triangles;
  };
  struct Composed {
    std::shared_ptr<const Environment> level;
    std::vector<Placed> placed;  ///< in the order of their triangles
  };

  void recompose();
  void compose();
  [[nodiscard]] Composed withObstacles(const Composed& from, const std::vector<PlacedObstacle>& wanted);
  static bool holds(const Composed& composed, const std::vector<PlacedObstacle>& wanted);

  Document& document_;
  PartLevel parts_;
  std::shared_ptr<const Environment> base_;
  Composed current_;
  Composed computed_;  ///< no level: none has results
};

}  // namespace footfall::ui
