// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/files/file_watch.hpp"

#include <sys/stat.h>

#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QUrl>

#include "core/io/folder_reader.hpp"

namespace footfall::ui {
namespace {

// Buffers are named near the beginning or the end of a .gltf file; any amount of data may lie between.
constexpr qint64 kSearched = qint64{1} << 20;
constexpr int kMostCompanions = 64, kMostFiles = 1000;

}  // namespace

FileWatch::FileWatch(QObject* parent) : QObject(parent) {
  settle_.setSingleShot(true);
  retry_.setSingleShot(true);
  setTimings({});
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, &FileWatch::look);
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, &FileWatch::look);
  connect(&poll_, &QTimer::timeout, this, &FileWatch::look);
  connect(&settle_, &QTimer::timeout, this, &FileWatch::settled);
  connect(&retry_, &QTimer::timeout, this, [this] {
    if (enabled_ && stamps() == known_) emit changed();
  });
}

void FileWatch::setTimings(const Timings& timings) {
  timings_ = timings;
  poll_.setInterval(timings.poll);
  settle_.setInterval(timings.settle);
}

FileWatch::Stamp FileWatch::stampOf(const QString& path) {
  struct stat status {};
  if (::stat(QFile::encodeName(path).constData(), &status) != 0) return {};
  return {true, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_ino};
}

FileWatch::Stamps FileWatch::stamps() const {
  Stamps stamps;
  for (const QString& file : files_) stamps.push_back(stampOf(file));
  return stamps;
}

QStringList FileWatch::companions() const {
  QStringList files;
  if (QFileInfo(path_).isDir()) {  // new files change the folder itself
    for (const std::string& mesh : detail::meshesInFolder(QFile::encodeName(path_).toStdString()))
      if (files.size() < kMostFiles) files << QFile::decodeName(QByteArray::fromStdString(mesh));
    return files;
  }
  QFile file(path_);
  if (!path_.endsWith(QStringLiteral(".gltf"), Qt::CaseInsensitive) || !file.open(QIODevice::ReadOnly)) return files;
  QByteArray text = file.read(kSearched);
  if (file.size() > 2 * kSearched) file.seek(file.size() - kSearched);
  text += file.read(kSearched);
  static const QRegularExpression uri(QStringLiteral("\"uri\"\\s*:\\s*\"([^\":]{1,255}\\.bin)\""),
                                      QRegularExpression::CaseInsensitiveOption);
  for (auto match = uri.globalMatch(QString::fromUtf8(text)); match.hasNext() && files.size() < kMostCompanions;) {
    const QString name = QUrl::fromPercentEncoding(match.next().captured(1).toUtf8());
    const QString path = QFileInfo(path_).path() + QLatin1Char('/') + name;
    if (!files.contains(path)) files << path;
  }
  return files;
}

// Watches all files again. Editors that replace or remove a file remove it from the system's watch.
void FileWatch::listen() {
  files_ = QStringList(path_) + companions();
  QStringList wanted = files_ + QStringList(QFileInfo(path_).path());
  const QStringList watched = watcher_.files() + watcher_.directories();
  for (const QString& path : watched)
    if (!wanted.contains(path)) watcher_.removePath(path);
  for (const QString& path : wanted)
    if (!watched.contains(path) && QFileInfo::exists(path)) watcher_.addPath(path);
}

void FileWatch::watch(const QString& path) {
  settle_.stop();
  retry_.stop();
  failures_ = 0;
  gone_ = false;
  path_ = path;
  if (path_.isEmpty()) {
    poll_.stop();
    files_.clear();
    const QStringList watched = watcher_.files() + watcher_.directories();
    if (!watched.isEmpty()) watcher_.removePaths(watched);
    return;
  }
  listen();
  known_ = seen_ = stamps();
  poll_.start();
}

void FileWatch::setEnabled(bool on) {
  enabled_ = on;
  if (on)
    look();
  else
    settle_.stop();
}

void FileWatch::acknowledge() {
  if (path_.isEmpty()) return;
  settle_.stop();
  known_ = seen_ = stamps();
}

void FileWatch::look() {
  if (path_.isEmpty() || !enabled_) return;
  const Stamps now = stamps();
  if (!now.front().exists) {
    // The file may be about to be replaced; it counts as gone when it is still missing after a while.
    if (!gone_ && !settle_.isActive()) settle_.start();
    seen_ = now;
    return;
  }
  if (now == known_) {
    gone_ = false;
    settle_.stop();
  } else if (now != seen_ || !settle_.isActive()) {
    settle_.start();
  }
  seen_ = now;
}

void FileWatch::settled() {
  const Stamps now = stamps();
  if (now != seen_) {
    seen_ = now;
    settle_.start();
    return;
  }
  if (!now.front().exists) {
    if (!gone_) emit vanished();
    gone_ = true;
    return;
  }
  gone_ = false;
  if (now == known_) return;
  listen();
  if (now.front().size == 0) return;  // the file has just been created; a later check sees it grow
  retry_.stop();
  failures_ = 0;
  known_ = seen_ = stamps();
  emit changed();
}

void FileWatch::readSucceeded() {
  failures_ = 0;
  retry_.stop();
  look();  // it may have changed while it was read
}

void FileWatch::readFailed(const QString& message) {
  const Stamps now = stamps();
  if (now != known_) {  // it was still being written
    look();
    return;
  }
  if (failures_ >= kRetries) {
    emit givenUp(message);
    return;
  }
  retry_.start(timings_.retry * (1 << failures_));
  ++failures_;
}

}  // namespace footfall::ui
