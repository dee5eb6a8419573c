// The level that runs compute on: the loaded environment with what the document changes about it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "core/environment/environment.hpp"
#include "ui/document.hpp"
#include "ui/part_level.hpp"

namespace footfall {

/// Follows the document's part rules and obstacles. Each level is an edit of the one before it (EnvironmentEdit), so
/// that runs compute only what a change can affect.
class LevelComposer : public QObject {
  Q_OBJECT

 public:
  explicit LevelComposer(Document& document, QObject* parent = nullptr);

  /// Starts anew from an environment as its file gave it (null: none), with the document as it is; tells nobody.
  void setLoaded(std::shared_ptr<const Environment> loaded,
                 std::shared_ptr<const EnvironmentGeometry> geometry = nullptr);
  /// The same file, read again; edited() follows when something differs.
  void replaceLoaded(std::shared_ptr<const Environment> loaded);
  /// The loaded environment with the roles of its parts, before obstacles.
  [[nodiscard]] PartLevel& parts() { return parts_; }
  /// Roles are being worked in: edited() is still to come.
  [[nodiscard]] bool busy() const { return parts_.busy(); }
  /// Null when nothing is loaded.
  [[nodiscard]] const std::shared_ptr<const Environment>& level() const { return level_; }

 signals:
  /// An edit of the document has made another level.
  void edited(const std::shared_ptr<const footfall::Environment>& level);

 private:
  void compose();

  void recompose();

  Document& document_;
  PartLevel parts_;
  std::shared_ptr<const Environment> level_;
};

}  // namespace footfall
