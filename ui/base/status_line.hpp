// What the status bar says, and for how long.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QTimer>
#include <vector>

#include "ui/base/fitted_labels.hpp"

namespace footfall::ui {

/// Whom a text in the status bar is about.
enum class StatusSubject {
  State,    ///< the level: the last result, a run that was cancelled
  Drawing,  ///< the result is there and its picture is not
  Work,     ///< loading, running, writing; ends with it
  Tool,     ///< the tool that has the mouse; ends with it
  Note      ///< something that was done; ends after a while
};

/// The text that came last is shown, until its subject ends: then the one before it is shown again.
class StatusLine : public ElidedLabel {
  Q_OBJECT

 public:
  explicit StatusLine(QWidget* parent = nullptr);

  /// Replaces what was said of the same subject. An empty text ends it.
  void say(StatusSubject subject, const QString& text);
  void end(StatusSubject subject);
  /// The State, with all of it in the tool tip.
  void setState(const QString& text, const QString& toolTip = {});
  /// The State, whatever is shown at present.
  [[nodiscard]] QString state() const;
  /// Stands before whatever is said of a Tool; empty: nothing does.
  void setToolRemark(const QString& remark);
  void setNoteDuration(int ms) { noteTimer_.setInterval(ms); }

 private:
  struct Said {
    StatusSubject subject;
    QString text;
  };
  void showLast();

  std::vector<Said> said_;  ///< the latest at the end
  QString stateToolTip_, toolRemark_;
  QTimer noteTimer_;
};

}  // namespace footfall::ui
