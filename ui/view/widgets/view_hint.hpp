// A hint over the view about its content, shown until it is closed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QLabel>
#include <QString>

namespace footfall::ui {

/// A hint that the user has closed is not shown again: the settings remember that under `setting`.
class ViewHint : public QFrame {
  Q_OBJECT

 public:
  ViewHint(const QString& setting, QWidget* view);

  /// Shows the text, unless it has been closed once.
  /// Shows the text unless it has been shown for another level already; close or not, once is enough.
  void showOnce(const QString& text);
  void showText(const QString& text);
  /// Makes the hint as wide as its lines, but not wider than `room`: longer lines are broken.
  void fitInto(int room);

 private:
  QString setting_;
  QLabel* text_;
};

}  // namespace footfall::ui
