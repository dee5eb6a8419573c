// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/messages/status_line.hpp"

#include <algorithm>

namespace footfall::ui {
namespace {

constexpr int kNoteMs = 10'000;

}  // namespace

StatusLine::StatusLine(QWidget* parent) : ElidedLabel(parent) {
  setObjectName(QStringLiteral("statusLine"));
  setTextFormat(Qt::PlainText);
  noteTimer_.setSingleShot(true);
  noteTimer_.setInterval(kNoteMs);
  connect(&noteTimer_, &QTimer::timeout, this, [this] { end(StatusSubject::Note); });
}

void StatusLine::say(StatusSubject subject, const QString& text) {
  std::erase_if(said_, [subject](const Said& said) { return said.subject == subject; });
  if (!text.isEmpty()) said_.push_back({subject, text});
  if (subject == StatusSubject::Note && !text.isEmpty()) noteTimer_.start();
  showLast();
}

void StatusLine::end(StatusSubject subject) { say(subject, {}); }

void StatusLine::setState(const QString& text, const QString& toolTip) {
  stateToolTip_ = toolTip;
  say(StatusSubject::State, text);
}

void StatusLine::setToolRemark(const QString& remark) {
  toolRemark_ = remark;
  showLast();
}

QString StatusLine::state() const {
  const auto found = std::ranges::find(said_, StatusSubject::State, &Said::subject);
  return found == said_.end() ? QString() : found->text;
}

void StatusLine::showLast() {
  const bool any = !said_.empty();
  const bool isTool = any && said_.back().subject == StatusSubject::Tool;
  const QString remark = isTool && !toolRemark_.isEmpty() ? toolRemark_ + QLatin1Char(' ') : QString();
  setText(any ? remark + said_.back().text : QString());
  setToolTip(any && said_.back().subject == StatusSubject::State ? stateToolTip_ : QString());
}

}  // namespace footfall::ui
