// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/work/frame_watchdog.hpp"

#include <QAbstractEventDispatcher>
#include <QCoreApplication>
#include <QEvent>
#include <QMetaEnum>
#include <QThread>
#include <algorithm>
#include <iterator>
#include <utility>

namespace footfall::ui {
namespace {

FrameWatchdog* theRunning = nullptr;  // watchdog of the one QCoreApplication
constexpr double kKeptFromMs = 16;    // shorter stalls cost no frame
constexpr std::size_t kMostKept = 1000;

}  // namespace

FrameWatchdog::FrameWatchdog(QObject* parent) : QObject(parent) {}

FrameWatchdog::~FrameWatchdog() { stop(); }

FrameWatchdog* FrameWatchdog::running() { return theRunning; }

void FrameWatchdog::start() {
  stop();
  longest_ = {};
  stalls_.clear();
  levels_.clear();
  depths_.clear();
  depth_ = 0;
  measuring_ = false;
  theRunning = this;
  if (QAbstractEventDispatcher* dispatcher = QAbstractEventDispatcher::instance(thread())) {
    connect(dispatcher, &QAbstractEventDispatcher::aboutToBlock, this, &FrameWatchdog::closeStretch);
    // A loop inside an event has ended; the rest of that event is measured from here.
    connect(dispatcher, &QAbstractEventDispatcher::awake, this, [this] {
      closeStretch();
      if (levels_.empty()) return;
      measuring_ = true;
      from_ = Clock::now();
    });
  }
}

void FrameWatchdog::stop() {
  if (theRunning != this) return;
  theRunning = nullptr;
  if (QAbstractEventDispatcher* dispatcher = QAbstractEventDispatcher::instance(thread())) dispatcher->disconnect(this);
}

std::vector<FrameWatchdog::Stall> FrameWatchdog::stallsOver(double milliseconds) const {
  std::vector<Stall> found;
  std::ranges::copy_if(stalls_, std::back_inserter(found),
                       [=](const Stall& stall) { return stall.milliseconds >= milliseconds; });
  return found;
}

void FrameWatchdog::closeStretch() {
  if (!std::exchange(measuring_, false) || levels_.empty()) return;
  const double milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - from_).count();
  if (milliseconds <= longest_.milliseconds && milliseconds < kKeptFromMs) return;
  const Level& level = levels_.back();
  const char* name = QMetaEnum::fromType<QEvent::Type>().valueToKey(level.type);
  const Stall stall{milliseconds,
                    QStringLiteral("%1 in %2")
                        .arg(name ? QLatin1String(name) : QLatin1String("event ") + QString::number(level.type),
                             QString::fromLatin1(level.className))};
  if (milliseconds > longest_.milliseconds) longest_ = stall;
  if (milliseconds >= kKeptFromMs && stalls_.size() < kMostKept) stalls_.push_back(stall);
}

void FrameWatchdog::begin(const QObject* receiver, const QEvent* event) {
  ++depth_;
  const int loop = QThread::currentThread()->loopLevel();
  if (!levels_.empty() && loop <= levels_.back().loop) return;  // the handler of that event has sent it
  // A loop has dispatched the event. The receiver may be gone at the end, so its name is recorded now.
  QByteArray name = receiver->metaObject()->className();
  if (!receiver->objectName().isEmpty()) name += " '" + receiver->objectName().toUtf8() + '\'';
  closeStretch();
  levels_.push_back({loop, receiver, std::move(name), event->type()});
  depths_.push_back(depth_);
  measuring_ = true;
  from_ = Clock::now();
}

void FrameWatchdog::end() {
  if (depth_ == 0) return;  // the event began before start()
  if (!depths_.empty() && depths_.back() == depth_) {
    closeStretch();
    levels_.pop_back();
    depths_.pop_back();
  }
  --depth_;
}

FrameWatchdog::Handling::Handling(const QObject* receiver, const QEvent* event)
    : watchdog_(theRunning && QThread::currentThread() == theRunning->thread() ? theRunning : nullptr) {
  if (watchdog_) watchdog_->begin(receiver, event);
}

FrameWatchdog::Handling::~Handling() {
  if (watchdog_ && watchdog_ == theRunning) watchdog_->end();
}

}  // namespace footfall::ui
