// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/replace_question.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <utility>

namespace footfall::ui {
namespace {

/// The struct is the context of the translations.
struct ReplaceTexts {
  Q_DECLARE_TR_FUNCTIONS(footfall::ui::ReplaceTexts)
};

}  // namespace

void askReplacing(QWidget* parent, const QString& path, std::function<void()> replace, std::function<void()> keep) {
  askReplacing(parent, QStringList(path), std::move(replace), std::move(keep));
}

void askReplacing(QWidget* parent, const QStringList& paths, std::function<void()> replace,
                  std::function<void()> keep) {
  QList<QFileInfo> files;
  for (const QString& path : paths)
    if (QFileInfo(path).isFile()) files << QFileInfo(path);
  if (files.isEmpty()) {
    replace();
    return;
  }
  const QFileInfo& file = files.front();
  const QString question = files.size() == 1 ? ReplaceTexts::tr("Replace %1?").arg(file.fileName())
                                             : ReplaceTexts::tr("Replace up to %1 files?").arg(files.size());
  auto* box =
      new QMessageBox(QMessageBox::Warning, ReplaceTexts::tr("Replace a file"), question, QMessageBox::Cancel, parent);
  box->setObjectName(QStringLiteral("replaceQuestion"));
  const QString folder = QFileInfo(file.canonicalFilePath()).path();
  if (files.size() == 1) {
    box->setInformativeText(ReplaceTexts::tr("This file is in %1 (%2, last changed %3). Its content will be lost.")
                                .arg(folder, QLocale().formattedDataSize(file.size()),
                                     QLocale().toString(file.lastModified(), QLocale::ShortFormat)));
  } else {
    constexpr qsizetype kNamed = 6;
    QStringList names;
    for (const QFileInfo& other : files.first(std::min(files.size(), kNamed))) names << other.fileName();
    if (files.size() > kNamed) names << QStringLiteral("...");
    box->setInformativeText(ReplaceTexts::tr("They are in %1: %2. Their content will be lost.")
                                .arg(folder, names.join(QStringLiteral(", "))));
  }
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
