// The desktop's preference for light or dark colours; Qt itself reports it only from version 6.5 on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QVariant>
#include <QtDBus/QDBusVariant>
#include <optional>

class QDBusPendingCallWatcher;

namespace footfall::ui {

/// Reads the preference from the desktop portal (org.freedesktop.appearance, color-scheme), which GNOME, KDE and others
/// implement, and follows its changes. Where there is no portal or no preference, the palette that the desktop gave Qt
/// decides. Reading never waits: the last value, kept in the settings, applies until the portal has replied.
class SystemColours : public QObject {
  Q_OBJECT

 public:
  /// Construct it before the program sets a palette of its own.
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

/// The meaning of a color-scheme value: 1 is dark, 2 is light, all others are no preference. Portals wrap the value in
/// variants.
std::optional<bool> darkFromPortal(QVariant value);

}  // namespace footfall::ui
