// The files that were opened last, kept in the user's settings.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <QObject>
#include <QStringList>

namespace footfall::ui {

class RecentFiles : public QObject {
  Q_OBJECT

 public:
  explicit RecentFiles(QObject* parent = nullptr);

  /// The menu is filled whenever it opens.
  void attachTo(QMenu* menu);
  /// Puts a file first; the oldest file after the tenth is dropped.
  void add(const QString& path);
  void remove(const QString& path);
  [[nodiscard]] QStringList paths() const;

 signals:
  void chosen(const QString& path);
  void changed();
};

}  // namespace footfall::ui
