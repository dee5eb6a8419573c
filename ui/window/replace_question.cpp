// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/replace_question.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <utility>

namespace footfall::ui {
namespace {

/// For the translations.
struct ReplaceTexts {
  Q_DECLARE_TR_FUNCTIONS(footfall::ui::ReplaceTexts)
};

}  // namespace

void askReplacing(QWidget* parent, const QString& path, std::function<void()> replace, std::function<void()> keep) {
  const QFileInfo file(path);
  if (!file.isFile()) {
    replace();
    return;
  }
  auto* box = new QMessageBox(QMessageBox::Warning, ReplaceTexts::tr("Replace a file"),
                              ReplaceTexts::tr("Replace %1?").arg(file.fileName()), QMessageBox::Cancel, parent);
  box->setObjectName(QStringLiteral("replaceQuestion"));
  box->setInformativeText(ReplaceTexts::tr("This file is in %1 (%2, last changed %3). What is in it is lost.")
                              .arg(QFileInfo(file.canonicalFilePath()).path(), QLocale().formattedDataSize(file.size()),
                                   QLocale().toString(file.lastModified(), QLocale::ShortFormat)));
  box->setTextFormat(Qt::PlainText);
  QPushButton* yes = box->addButton(ReplaceTexts::tr("&Replace"), QMessageBox::AcceptRole);
  yes->setObjectName(QStringLiteral("replaceAccept"));
  box->setDefaultButton(QMessageBox::Cancel);
  box->setEscapeButton(QMessageBox::Cancel);
  box->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(box, &QMessageBox::finished, parent,
                   [box, yes, replace = std::move(replace), keep = std::move(keep)] {
                     if (box->clickedButton() == yes) {
                       replace();
                     } else if (keep) {
                       keep();
                     }
                   });
  box->open();
}

}  // namespace footfall::ui
