// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/widgets/view_hint.hpp"

#include <QHBoxLayout>
#include <QSettings>
#include <QToolButton>

namespace footfall::ui {

ViewHint::ViewHint(const QString& setting, QWidget* view) : QFrame(view), setting_(setting) {
  setObjectName(QStringLiteral("viewHint"));
  setAttribute(Qt::WA_StyledBackground);
  setCursor(Qt::ArrowCursor);
  text_ = new QLabel(this);
  auto* close = new QToolButton(this);
  close->setObjectName(QStringLiteral("hintClose"));
  close->setText(QStringLiteral("✕"));
  close->setAccessibleName(tr("Close"));
  close->setToolTip(tr("Do not show this again"));
  close->setAutoRaise(true);
  close->setFocusPolicy(Qt::TabFocus);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 5, 5, 5);
  layout->addWidget(text_);
  layout->addWidget(close, 0, Qt::AlignTop);
  connect(close, &QToolButton::clicked, this, [this] {
    QSettings().setValue(setting_, true);
    hide();
  });
  hide();
}

void ViewHint::showText(const QString& text) {
  text_->setText(text);
  setVisible(!QSettings().value(setting_).toBool());
}

void ViewHint::showOnce(const QString& text) {
  const QString seen = setting_ + QStringLiteral("-seen");
  if (QSettings().value(seen).toBool()) return hide();
  showText(text);
  QSettings().setValue(seen, true);
}

void ViewHint::fitInto(int room) {
  text_->setWordWrap(false);
  layout()->activate();
  const QSize whole = sizeHint();
  if (whole.width() <= room) return resize(whole);
  text_->setWordWrap(true);
  layout()->activate();
  resize(room, layout()->heightForWidth(room));
}

}  // namespace footfall::ui
