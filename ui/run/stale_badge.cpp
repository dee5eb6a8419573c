// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/stale_badge.hpp"

#include <QEvent>
#include <QHBoxLayout>

#include "ui/run/step_status.hpp"

namespace footfall::ui {
namespace {

constexpr int kMark = 16;

}  // namespace

StaleBadge::StaleBadge(RunController& controller, QWidget* view) : QFrame(view), controller_(controller), view_(view) {
  setObjectName(QStringLiteral("staleBadge"));
  setAccessibleName(tr("Out of date"));
  mark_ = new QLabel(this);
  auto* words = new QLabel(tr("Out of date: the filters have changed"), this);
  run_ = new QPushButton(tr("Run (F5)"), this);
  run_->setToolTip(tr("Run the filters as they are now"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 4, 4, 4);
  layout->addWidget(mark_);
  layout->addWidget(words);
  layout->addWidget(run_);
  connect(run_, &QPushButton::clicked, &controller_, &RunController::runNow);
  connect(&controller_, &RunController::statusChanged, this, &StaleBadge::follow);
  connect(&controller_, &RunController::started, this, &StaleBadge::follow);
  connect(&controller_, &RunController::finished, this, &StaleBadge::follow);
  connect(&controller_, &RunController::cancelled, this, &StaleBadge::follow);
  connect(&controller_, &RunController::failed, this, &StaleBadge::follow);
  view_->installEventFilter(this);
  follow();
}

void StaleBadge::follow() {
  const bool stale = controller_.environment() && !controller_.busy() && !controller_.upToDate();
  if (stale) {
    mark_->setPixmap(stateMark(StepState::Stale, palette(), kMark, devicePixelRatioF()));
    place();
  }
  setVisible(stale);
}

void StaleBadge::place() {
  adjustSize();
  move((view_->width() - width()) / 2, 10);
  raise();
}

bool StaleBadge::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::Resize && isVisible()) place();
  return QFrame::eventFilter(watched, event);
}

}  // namespace footfall::ui
