// Shows the welcome page, and handles its actions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/base/commands/commands.hpp"
#include "ui/base/files/recent_files.hpp"
#include "ui/view/level_view.hpp"
#include "ui/window/level_opening.hpp"
#include "ui/window/session_files.hpp"
#include "ui/window/welcome_page.hpp"

namespace footfall::ui {

/// The page lies over the view until a level is opened, and when the user opens it.
class Welcome : public QObject {
  Q_OBJECT

 public:
  Welcome(WelcomePage& page, LevelView& view, CommandRegistry& commands, LevelFile& file, RecentFiles& recent,
          SessionFiles& sessions, LevelOpening& opening);

  /// Shows or hides the page. Without a level the page stays, because there is nothing behind it.
  void show(bool on);
  /// What the page offers may be another: shows that, if the page is shown.
  void refresh();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void update();

  WelcomePage& page_;
  LevelView& view_;
  LevelFile& file_;
  RecentFiles& recent_;
  SessionFiles& sessions_;
};

}  // namespace footfall::ui
