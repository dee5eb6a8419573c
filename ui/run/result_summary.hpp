// The last result in a line of the status bar.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include "ui/base/messages/status_line.hpp"
#include "ui/base/text/unit_choice.hpp"
#include "ui/run/run_controller.hpp"

namespace footfall::ui {

/// Written anew with each result, and when the unit changes while the status bar still shows it.
class ResultSummary : public QObject {
  Q_OBJECT

 public:
  ResultSummary(RunController& controller, UnitChoice& units, StatusLine& status);

 private:
  void show();

  RunController& controller_;
  UnitChoice& units_;
  StatusLine& status_;
  QString text_;
};

}  // namespace footfall::ui
