// Keeps the picture of the file that is open up to date.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>

#include "ui/base/files/recent_files.hpp"
#include "ui/base/work/background_queue.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/level_view.hpp"
#include "ui/window/recent/recent_pictures.hpp"

namespace footfall::ui {

/// Takes a picture of the view some time after each result, once the view shows all of it, and stores it in the
/// background. Pictures of files that leave the list of recent files go with them.
class RecentPhotographer : public QObject {
  Q_OBJECT

 public:
  /// `openFile` returns the recent file that the window shows; empty: none that is remembered. `writing` must do all
  /// its jobs at its end.
  RecentPhotographer(LevelView& view, RunController& controller, RecentFiles& recent, std::function<QString()> openFile,
                     BackgroundQueue& writing, QObject* parent);

  /// The time between a result and its picture.
  void setDelay(int ms) { timer_.setInterval(ms); }
  /// Takes the picture now, if there is a result and the view shows all of it.
  void take();

 signals:
  /// The picture of a file is another, or it has gone.
  void changed();

 private:
  LevelView& view_;
  RunController& controller_;
  RecentFiles& recent_;
  std::function<QString()> openFile_;
  BackgroundQueue& writing_;
  QTimer timer_;
};

}  // namespace footfall::ui
