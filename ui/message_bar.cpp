// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/message_bar.hpp"

#include <QHBoxLayout>
#include <QStyle>
#include <QToolButton>
#include <utility>

namespace footfall {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("messageBar"));
  text_ = new QLabel(this);
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  button_ = new QPushButton(this);
  auto* close = new QToolButton(this);
  close->setText(QStringLiteral("✕"));
  close->setAutoRaise(true);
  close->setToolTip(tr("Close this message"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 6, 6, 6);
  layout->addWidget(text_, 1);
  layout->addWidget(button_);
  layout->addWidget(close);
  connect(close, &QToolButton::clicked, this, &MessageBar::clear);
  connect(button_, &QPushButton::clicked, this, [this] {
    const std::function<void()> action = std::exchange(action_, nullptr);
    clear();
    if (action) action();
  });
  hide();
}

void MessageBar::showError(const QString& text) { showText(QStringLiteral("error"), text, {}, {}); }

void MessageBar::showHint(const QString& text, const QString& label, std::function<void()> action) {
  showText(QStringLiteral("hint"), text, label, std::move(action));
}

void MessageBar::showText(const QString& kind, const QString& text, const QString& label,
                          std::function<void()> action) {
  setProperty("kind", kind);
  style()->unpolish(this);
  style()->polish(this);
  text_->setText(text);
  button_->setText(label);
  button_->setVisible(!label.isEmpty());
  action_ = std::move(action);
  show();
}

void MessageBar::clear() {
  action_ = nullptr;
  text_->clear();
  hide();
}

QString MessageBar::text() const { return text_->text(); }

}  // namespace footfall
