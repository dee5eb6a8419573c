// A second view of the same level, whose camera and switches are those of the first.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// Links two views for as long as it lives. Either camera moves the other one; everything else (level, mode, parts,
/// heights, cut plane, backdrop) follows the first view. Cells, hidden layers and colours that belong to one result are
/// not taken over.
class LinkedView : public QObject {
  Q_OBJECT

 public:
  LinkedView(LevelView& first, LevelView& second, QObject* parent);

 private:
  void follow(LevelView& from, LevelView& to);
  void mirror();

  LevelView& first_;
  LevelView& second_;
  bool isMoving_ = false;  ///< one camera is being moved after the other
};

}  // namespace footfall::ui
