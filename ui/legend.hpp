// What the colours and lines of the view mean; each entry can be switched off.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QFrame>
#include <vector>

#include "ui/render_geometry.hpp"
#include "ui/scene_renderer.hpp"

namespace footfall {

/// Lies in a corner of the view.
class Legend : public QFrame {
  Q_OBJECT

 public:
  explicit Legend(QWidget* parent);

  /// Names what `content` shows.
  void describe(const ViewContent& content);
  /// Cells have a legend of their own; this one only passes on that they are shown.
  void showCells(bool on);
  [[nodiscard]] const SceneParts& parts() const { return parts_; }

 signals:
  void partsChanged(const footfall::SceneParts& parts);

 private:
  QCheckBox* addEntry(const QString& label, bool SceneParts::*part, const QString& help);

  SceneParts parts_;
  QCheckBox *walkable_, *obstacleEdges_, *connections_, *removed_, *environment_;
  QWidget* reasons_;
  std::vector<const RemovalStyle*> shownReasons_;
};

}  // namespace footfall
