// A mark in the view while its content is older than the filter list.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>

#include "ui/run/run_controller.hpp"

namespace footfall::ui {

/// Stands at the top of `view`, in the middle. Hidden during runs, which update the content.
class StaleBadge : public QFrame {
  Q_OBJECT

 public:
  StaleBadge(RunController& controller, QWidget* view);

  [[nodiscard]] QPushButton* runButton() const { return run_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow();
  void place();

  RunController& controller_;
  QWidget* view_;
  QLabel* mark_;
  QPushButton* run_;
};

}  // namespace footfall::ui
