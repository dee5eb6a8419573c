// What the desktop says about light and dark; Qt itself tells from version 6.5 on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QVariant>
#include <QtDBus/QDBusVariant>
#include <optional>

class QDBusPendingCallWatcher;

namespace footfall::ui {

/// Asks the desktop portal (org.freedesktop.appearance, color-scheme), which GNOME, KDE and others answer, and follows
/// it. Where there is no portal or it has no preference, the palette that the desktop gave Qt decides. Never waits: the
/// last answer, kept in the settings, holds until the portal has answered.
class SystemColours : public QObject {
  Q_OBJECT

 public:
  /// Before the program sets a palette of its own.
  explicit SystemColours(QObject* parent = nullptr);

  [[nodiscard]] bool dark() const { return portal_.value_or(paletteDark_); }

 signals:
  void changed();

 private slots:
  void portalChanged(const QString& group, const QString& key, const QDBusVariant& value);

 private:
  void take(const QVariant& value);

  bool paletteDark_;
  std::optional<bool> portal_;
};

/// What a value of color-scheme means: 1 dark, 2 light, all else no preference. Portals wrap it in variants.
std::optional<bool> darkFromPortal(QVariant value);

}  // namespace footfall::ui
