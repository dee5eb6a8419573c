// Writes runs and levels into the log, and makes its panel.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/base/messages/log_panel.hpp"
#include "ui/base/messages/message_log.hpp"
#include "ui/document/document.hpp"
#include "ui/level/level_file.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/feature_host.hpp"
#include "ui/window/file_writer.hpp"

namespace footfall::ui {

/// Writes messages, opened levels and runs into the log.
class RunLog : public QObject {
  Q_OBJECT

 public:
  RunLog(const FeatureHost& host, MessageLog& log, const Document& document, const LevelFile& file,
         RunController& controller, FileWriter& writer);

  [[nodiscard]] LogPanel& panel() { return *panel_; }

 private:
  void addRun();
  void askForTarget();

  QWidget& window_;
  StatusLine& status_;
  MessageLog& log_;
  const Document& document_;
  const LevelFile& file_;
  RunController& controller_;
  FileWriter& writer_;
  LogPanel* panel_;
};

}  // namespace footfall::ui
