// The texts of the status bar, and how long each is shown.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QTimer>
#include <vector>

#include "ui/base/widgets/fitted_labels.hpp"

namespace footfall::ui {

/// The subject of a text in the status bar.
enum class StatusSubject {
  State,    ///< the level: the last result, a cancelled run
  Drawing,  ///< the result is computed but not drawn yet
  Work,     ///< loading, running, writing; ends with the work
  Tool,     ///< the active tool; ends with the tool
  Note      ///< a finished action; ends after a while
};

/// Shows the latest text until its subject ends, and then the text before it.
class StatusLine : public ElidedLabel {
  Q_OBJECT

 public:
  explicit StatusLine(QWidget* parent = nullptr);

  /// Replaces the text of the same subject. An empty text ends the subject.
  void say(StatusSubject subject, const QString& text);
  void end(StatusSubject subject);
  /// Sets the text of State, with the whole text in the tool tip.
  void setState(const QString& text, const QString& toolTip = {});
  /// The text of State, whatever is shown at present.
  [[nodiscard]] QString state() const;
  /// A remark in front of any text of Tool; empty: none.
  void setToolRemark(const QString& remark);
  void setNoteDuration(int ms) { noteTimer_.setInterval(ms); }

 private:
  struct Said {
    StatusSubject subject;
    QString text;
  };
  void showLast();

  std::vector<Said> said_;  ///< the latest is at the end
  QString stateToolTip_, toolRemark_;
  QTimer noteTimer_;
};

}  // namespace footfall::ui
