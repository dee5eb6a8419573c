// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/messages/message_bar.hpp"

#include <QHBoxLayout>
#include <QStyle>
#include <QToolButton>
#include <utility>

#include "ui/base/look/icon.hpp"

namespace footfall::ui {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("messageBar"));
  icon_ = new QLabel(this);
  text_ = new QLabel(this);
  text_->setObjectName(QStringLiteral("messageText"));
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* close = new QToolButton(this);
  close->setObjectName(QStringLiteral("messageClose"));
  close->setText(QStringLiteral("✕"));
  close->setAutoRaise(true);
  close->setFocusPolicy(Qt::StrongFocus);
  close->setToolTip(tr("Close this message; the log keeps it"));
  close->setAccessibleName(tr("Close this message"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 6, 6, 6);
  layout->addWidget(icon_);
  layout->addWidget(text_, 1);
  for (Choice& choice : choices_) {
    choice.button = new QPushButton(this);
    choice.button->setAutoDefault(true);
    layout->addWidget(choice.button);
    connect(choice.button, &QPushButton::clicked, this, [this, &choice] {
      const std::function<void()> action = std::exchange(choice.action, nullptr);
      clear();
      if (action) action();
    });
  }
  layout->addWidget(close);
  connect(close, &QToolButton::clicked, this, &MessageBar::clear);
  hide();
}

void MessageBar::showError(const QString& text) {
  for (Choice& choice : choices_) offer(choice, {}, {});
  showText(MessageLevel::Error, text);
}

void MessageBar::showErrorOf(MessageSubject subject, const QString& text) {
  showError(text);
  subject_ = subject;
}

void MessageBar::finish(MessageSubject subject) {
  if (subject_ == subject) clear();
}

void MessageBar::showHint(const QString& text, const QString& label, std::function<void()> action,
                          const QString& secondLabel, std::function<void()> secondAction) {
  offer(choices_[0], label, std::move(action));
  offer(choices_[1], secondLabel, std::move(secondAction));
  showText(MessageLevel::Hint, text);
}

void MessageBar::offer(Choice& choice, const QString& label, std::function<void()> action) {
  choice.button->setText(label);
  choice.button->setVisible(!label.isEmpty());
  choice.action = std::move(action);
}

void MessageBar::showText(MessageLevel level, const QString& text) {
  subject_ = MessageSubject::Other;
  const bool error = level == MessageLevel::Error;
  setProperty("kind", error ? QStringLiteral("error") : QStringLiteral("hint"));
  style()->unpolish(this);
  style()->polish(this);
  const int side = style()->pixelMetric(QStyle::PM_SmallIconSize, nullptr, this);
  icon_->setPixmap(
      icon(error ? QStringLiteral("error") : QStringLiteral("info")).pixmap(QSize(side, side), devicePixelRatioF()));
  text_->setText(text);
  setAccessibleName(error ? tr("Error: %1").arg(text) : text);
  show();
  emit told(level, text);
}

void MessageBar::clear() {
  for (Choice& choice : choices_) choice.action = nullptr;
  subject_ = MessageSubject::Other;
  text_->clear();
  hide();
}

QString MessageBar::text() const { return text_->text(); }

}  // namespace footfall::ui
