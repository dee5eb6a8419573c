// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/recent/recent_pictures.hpp"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QImageReader>
#include <QSaveFile>
#include <QSet>
#include <QStandardPaths>

namespace footfall::ui {

RecentPictures RecentPictures::ofUser() {
  return RecentPictures(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) +
                        QStringLiteral("/recent"));
}

QString RecentPictures::pathOf(const QString& file) const {
  const QByteArray path = QFileInfo(file).absoluteFilePath().toUtf8();
  const QByteArray hash = QCryptographicHash::hash(path, QCryptographicHash::Sha1).toHex();
  return folder_ + QLatin1Char('/') + QString::fromLatin1(hash) + QStringLiteral(".png");
}

QImage RecentPictures::find(const QString& file) const {
  // Looked at before it is unpacked: something else may lie there.
  QImageReader reader(pathOf(file), "png");
  const QSize size = reader.size();
  if (size.isEmpty() || size.width() > kSize.width() || size.height() > kSize.height()) return {};
  return reader.read();
}

bool RecentPictures::store(const QString& file, const QImage& picture) const {
  if (picture.isNull() || !QDir().mkpath(folder_)) return false;
  QImage image = picture.scaled(kSize, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  image = image.copy((image.width() - kSize.width()) / 2, (image.height() - kSize.height()) / 2, kSize.width(),
                     kSize.height());
  image.setDevicePixelRatio(1);
  QSaveFile target(pathOf(file));
  return target.open(QIODevice::WriteOnly) && image.convertToFormat(QImage::Format_RGB32).save(&target, "PNG") &&
         target.commit();
}

void RecentPictures::keepOnly(const QStringList& files) const {
  QSet<QString> kept;
  for (const QString& file : files) kept << QFileInfo(pathOf(file)).fileName();
  const QDir folder(folder_);
  for (const QString& name : folder.entryList({QStringLiteral("*.png*")}, QDir::Files))
    if (!kept.contains(name)) QFile::remove(folder.filePath(name));
}

}  // namespace footfall::ui
