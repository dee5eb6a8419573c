// The level that runs compute on: the loaded environment with what the document changes about it.
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

/// Follows the document's part rules and obstacles. Obstacles are solid and come after all other triangles. However
/// many of them an edit changes (undo and sessions change several), the level is one edit (EnvironmentEdit) of the last
/// one that has results, so that runs compute only what the change can affect and runs that were overtaken cost
/// nothing later.
class LevelComposer : public QObject {
  Q_OBJECT

 public:
  explicit LevelComposer(Document& document, QObject* parent = nullptr);

  /// Starts anew from an environment as its file gave it (null: none), with the document as it is; emits no signal.
  void setLoaded(std::shared_ptr<const Environment> loaded,
                 std::shared_ptr<const EnvironmentGeometry> geometry = nullptr);
  /// The same file, read again; edited() follows when something differs. `whole`: what it is a part of, null for all of
  /// it.
  void replaceLoaded(std::shared_ptr<const Environment> loaded, std::shared_ptr<const WholeBounds> whole = nullptr);
  /// The loaded environment with the roles of its parts, before obstacles.
  [[nodiscard]] PartLevel& parts() { return parts_; }
  /// Roles are being worked in: edited() is still to come.
  [[nodiscard]] bool busy() const { return parts_.busy(); }
  /// The level; null when nothing is loaded.
  [[nodiscard]] const std::shared_ptr<const Environment>& level() const { return current_.level; }
  /// The same without obstacles; its triangles are the first ones of the level.
  [[nodiscard]] const std::shared_ptr<const Environment>& base() const { return base_; }
  /// A run on this level has finished. Levels that are not known any more are ignored.
  void setComputed(const std::shared_ptr<const Environment>& level);

  /// Triangles of the level, from the first one on.
  struct Triangles {
    std::uint32_t first = 0, count = 0;
  };
  /// The triangles of an obstacle; none when the level does not have it.
  [[nodiscard]] Triangles trianglesOf(std::uint32_t obstacle) const;
  /// Id of the obstacle that a triangle of the level belongs to.
  [[nodiscard]] std::optional<std::uint32_t> obstacleOf(std::uint32_t triangle) const;

 signals:
  /// An edit of the document has made another level.
  void edited(const std::shared_ptr<const footfall::Environment>& level);
  /// An obstacle cannot be part of the level; the others are.
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
