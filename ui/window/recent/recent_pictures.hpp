// Small pictures of recent files, for the welcome page.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QSize>
#include <QString>
#include <QStringList>

namespace footfall::ui {

/// One PNG of at most kSize for each file, in a folder of its own under the settings, named by a hash of the file's
/// path. Pictures are for looking at only: where one cannot be read or written, there is none.
class RecentPictures {
 public:
  static constexpr QSize kSize{336, 188};

  /// Files in `folder`, which is made when the first one is stored.
  explicit RecentPictures(QString folder) : folder_(std::move(folder)) {}
  /// In the program's settings folder.
  static RecentPictures ofUser();

  /// Null where there is none, or what is there is no picture of that size.
  [[nodiscard]] QImage find(const QString& file) const;
  /// Replaces the picture of a file by the middle of `picture`, scaled down. Any thread may call it. False where it
  /// cannot be written.
  bool store(const QString& file, const QImage& picture) const;
  /// Removes the pictures of all other files, and what an interrupted store() has left.
  void keepOnly(const QStringList& files) const;

  [[nodiscard]] QString pathOf(const QString& file) const;

 private:
  QString folder_;
};

}  // namespace footfall::ui
