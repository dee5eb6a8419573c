// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/look/system_colours.hpp"

#include <QFileInfo>
#include <QGuiApplication>
#include <QPalette>
#include <QSettings>
#include <QtDBus/QDBusConnection>
#include <QtDBus/QDBusMessage>
#include <QtDBus/QDBusPendingCallWatcher>
#include <QtDBus/QDBusPendingReply>

namespace footfall::ui {
namespace {

const auto kService = QStringLiteral("org.freedesktop.portal.Desktop");
const auto kPath = QStringLiteral("/org/freedesktop/portal/desktop");
const auto kInterface = QStringLiteral("org.freedesktop.portal.Settings");
const auto kGroup = QStringLiteral("org.freedesktop.appearance");
const auto kSchemeKey = QStringLiteral("color-scheme");
const auto kLastAnswer = QStringLiteral("systemColours");

// Connecting to the bus without an address would start a bus.
bool hasSessionBus() {
  return qEnvironmentVariableIsSet("DBUS_SESSION_BUS_ADDRESS") ||
         QFileInfo::exists(qEnvironmentVariable("XDG_RUNTIME_DIR") + QStringLiteral("/bus"));
}

}  // namespace

std::optional<bool> darkFromPortal(QVariant value) {
  while (value.canConvert<QDBusVariant>()) value = value.value<QDBusVariant>().variant();
  bool number = false;
  const unsigned int scheme = value.toUInt(&number);
  if (number && scheme == 1) return true;
  if (number && scheme == 2) return false;
  return std::nullopt;
}

SystemColours::SystemColours(QObject* parent)
    : QObject(parent), paletteDark_(QGuiApplication::palette().color(QPalette::Window).lightnessF() < 0.5F) {
  if (!hasSessionBus()) return;
  portal_ = darkFromPortal(QSettings().value(kLastAnswer));
  QDBusConnection bus = QDBusConnection::sessionBus();
  if (!bus.isConnected()) return;
  bus.connect(kService, kPath, kInterface, QStringLiteral("SettingChanged"), this,
              SLOT(portalChanged(QString, QString, QDBusVariant)));
  QDBusMessage question = QDBusMessage::createMethodCall(kService, kPath, kInterface, QStringLiteral("Read"));
  question << kGroup << kSchemeKey;
  auto* watcher = new QDBusPendingCallWatcher(bus.asyncCall(question), this);
  connect(watcher, &QDBusPendingCallWatcher::finished, this, [this, watcher] {
    const QDBusPendingReply<QDBusVariant> reply = *watcher;
    take(reply.isValid() ? QVariant::fromValue(reply.value()) : QVariant());
    watcher->deleteLater();
  });
}

void SystemColours::portalChanged(const QString& group, const QString& key, const QDBusVariant& value) {
  if (group == kGroup && key == kSchemeKey) take(value.variant());
}

void SystemColours::take(const QVariant& value) {
  const bool before = dark();
  portal_ = darkFromPortal(value);
  QSettings().setValue(kLastAnswer, portal_ ? (*portal_ ? 1 : 2) : 0);
  if (dark() != before) emit changed();
}

}  // namespace footfall::ui
