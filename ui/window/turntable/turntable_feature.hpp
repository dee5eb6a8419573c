// The command "Turntable": dialog, progress, messages.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/base/commands/commands.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/messages/message_log.hpp"
#include "ui/base/messages/status_line.hpp"
#include "ui/level/level_file.hpp"
#include "ui/window/turntable/turntable.hpp"

namespace footfall::ui {

class TurntableFeature : public QObject {
  Q_OBJECT

 public:
  struct Uses {
    QWidget& window;  ///< parent of the dialog
    CommandRegistry& commands;
    const LevelFile& level;
    RunController& controller;
    LevelView& view;
    BackgroundQueue& queue;
    MessageBar& messages;
    MessageLog& log;
    StatusLine& status;
  };
  explicit TurntableFeature(const Uses& uses);

  [[nodiscard]] Turntable& turntable() { return turntable_; }
  void showDialog();

 private:
  Uses uses_;
  Turntable turntable_;
  TurntableSettings last_;  ///< of the dialog
};

}  // namespace footfall::ui
