// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/messages/progress_display.hpp"

#include <QGuiApplication>
#include <QHBoxLayout>
#include <QtDBus/QDBusConnection>
#include <QtDBus/QDBusMessage>
#include <algorithm>
#include <cmath>

#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

constexpr double kTellAfterSeconds = 1.5;  // an earlier guess would be wild
constexpr double kTellFromFraction = 0.03;
constexpr int kTickMs = 500;
constexpr int kMoveMs = 250;
constexpr double kSmoothing = 0.3;  // weight of the newest estimate

}  // namespace

void showTaskbarProgress(double fraction) {
  // Connecting to the bus without an address would start a bus.
  if (!qEnvironmentVariableIsSet("DBUS_SESSION_BUS_ADDRESS")) return;
  QDBusConnection bus = QDBusConnection::sessionBus();
  if (!bus.isConnected()) return;
  QDBusMessage update = QDBusMessage::createSignal(
      QStringLiteral("/com/canonical/unity/launcherentry/%1").arg(QCoreApplication::applicationPid()),
      QStringLiteral("com.canonical.Unity.LauncherEntry"), QStringLiteral("Update"));
  QVariantMap properties;
  properties[QStringLiteral("progress")] = std::clamp(fraction, 0.0, 1.0);
  properties[QStringLiteral("progress-visible")] = fraction >= 0;
  const QString desktop = QGuiApplication::desktopFileName();
  update << QStringLiteral("application://%1.desktop")
                .arg(desktop.isEmpty() ? QStringLiteral("org.footfall.Editor") : desktop)
         << properties;
  bus.send(update);
}

void TimeLeft::begin() { shown_.reset(); }

std::optional<double> TimeLeft::estimate(double elapsedSeconds, double fraction) {
  if (elapsedSeconds < kTellAfterSeconds || fraction < kTellFromFraction || fraction > 1) return std::nullopt;
  const double now = elapsedSeconds * (1 - fraction) / fraction;
  // The earlier estimate has shrunk by the time since.
  shown_ = shown_ ? (1 - kSmoothing) * std::max(0.0, *shown_ - (elapsedSeconds - at_)) + kSmoothing * now : now;
  at_ = elapsedSeconds;
  return shown_;
}

QString timeLeftText(double seconds) {
  if (seconds < 1) return ProgressDisplay::tr("nearly done");
  if (seconds < 10) return ProgressDisplay::tr("about %1 s left").arg(fixedText(std::ceil(seconds), 0));
  if (seconds < 90) return ProgressDisplay::tr("about %1 s left").arg(fixedText(5 * std::ceil(seconds / 5), 0));
  if (seconds < 5400) return ProgressDisplay::tr("about %1 min left").arg(fixedText(std::ceil(seconds / 60), 0));
  return ProgressDisplay::tr("about %1 h left").arg(fixedText(seconds / 3600, 1));
}

QString timeLeftText(const EndEstimate::Told& told) {
  switch (told.kind) {
    case EndEstimate::Kind::Left:
      return timeLeftText(told.seconds);
    case EndEstimate::Kind::Late:
      return ProgressDisplay::tr("longer than estimated");
    case EndEstimate::Kind::Unknown:
      return ProgressDisplay::tr("time left unknown");
    case EndEstimate::Kind::Nothing:
      break;
  }
  return {};
}

ProgressDisplay::ProgressDisplay(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("progressDisplay"));
  time_ = new QLabel(this);
  time_->setObjectName(QStringLiteral("timeLeft"));
  time_->hide();
  bar_ = new QProgressBar(this);
  bar_->setObjectName(QStringLiteral("progressBar"));
  bar_->setAccessibleName(tr("Progress"));
  bar_->setFixedWidth(200);
  bar_->setTextVisible(false);
  bar_->installEventFilter(this);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(time_);
  layout->addWidget(bar_);
  tick_.setInterval(kTickMs);
  connect(&tick_, &QTimer::timeout, this, &ProgressDisplay::showTime);
  hide();
}

void ProgressDisplay::showProgress(double fraction, std::optional<double> secondsLeft) {
  // Other work has begun, or the same work again.
  if (isHidden() || fraction < 0 || fraction < lastFraction_) {
    elapsed_.start();
    left_.begin();
    end_.begin(0);
  }
  lastFraction_ = fraction;
  bar_->setRange(0, fraction < 0 ? 0 : 1000);
  if (fraction >= 0) bar_->setValue(static_cast<int>(fraction * 1000));
  const double now = static_cast<double>(elapsed_.elapsed()) / 1000;
  if (!secondsLeft && fraction >= 0) secondsLeft = left_.estimate(now, fraction);
  end_.update(now, fraction, secondsLeft);
  showTime();
  tick_.start();
  show();
  showTaskbarProgress(std::max(0.0, fraction));
}

// The style moves a busy indicator 60 times a second, and each time Qt composes the whole window. Without graphics
// hardware, that took half of a processor from the work itself.
bool ProgressDisplay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::StyleAnimationUpdate) {
    if (sinceMoved_.isValid() && sinceMoved_.elapsed() < kMoveMs) {
      event->accept();
      return true;
    }
    sinceMoved_.start();
  }
  return QWidget::eventFilter(watched, event);
}

void ProgressDisplay::showTime() {
  // The bar suffices for work without a measure, such as reading a file.
  const double now = static_cast<double>(elapsed_.elapsed()) / 1000;
  const QString text = lastFraction_ < 0 ? QString() : timeLeftText(end_.at(now));
  if (text == time_->text() && time_->isHidden() == text.isEmpty()) return;
  time_->setText(text);
  time_->setVisible(!text.isEmpty());
  bar_->setAccessibleDescription(text);
}

void ProgressDisplay::finish() {
  if (isHidden()) return;
  tick_.stop();
  hide();
  lastFraction_ = -1;
  showTaskbarProgress(-1);
}

}  // namespace footfall::ui
