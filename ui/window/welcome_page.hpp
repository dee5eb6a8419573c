// The page that is shown before anything is loaded: samples, recent files, the last session.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QFrame>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QStringList>
#include <QToolButton>
#include <optional>
#include <vector>

#include "ui/window/recent/recent_pictures.hpp"

namespace footfall::ui {

struct Sample {
  QString path;      ///< path of the environment
  QString pipeline;  ///< pipeline that fits it; empty when there is none
  QString title;
  QString description;  ///< one line
  QString picture;      ///< name in the resources; empty: none
};

/// The samples in a folder, in the order in which they should be tried; none when the folder does not exist.
std::vector<Sample> findSamples(const QString& folder);

/// Covers the view. All controls can be reached with Tab and triggered with Enter; Delete removes a recent file from
/// the list.
class WelcomePage : public QFrame {
  Q_OBJECT

 public:
  explicit WelcomePage(QWidget* parent);

  struct LastSession {
    QString name;  ///< name of its environment
    QDateTime time;
  };

  void setSamples(const std::vector<Sample>& samples);
  /// Files that are not there any more are told so, and can only be taken off the list.
  void setRecentFiles(const QStringList& paths, const RecentPictures& pictures);
  void setLastSession(const std::optional<LastSession>& session);
  /// Sets whether the page can be closed, which needs a level behind it.
  void setClosable(bool closable);

  [[nodiscard]] QPushButton* openButton() const { return open_; }
  [[nodiscard]] QPushButton* continueButton() const { return continue_; }
  [[nodiscard]] QPushButton* removeButton() const { return remove_; }
  [[nodiscard]] QToolButton* closeButton() const { return close_; }
  [[nodiscard]] QListWidget* recentList() const { return recent_; }
  [[nodiscard]] const std::vector<QToolButton*>& sampleButtons() const { return sampleButtons_; }

 signals:
  void openRequested();
  void continueRequested();
  void fileChosen(const QString& path);
  void sampleChosen(const QString& path, const QString& pipeline);
  void removeRequested(const QString& path);
  void closeRequested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  /// A picture of a file, or a small icon in its place.
  [[nodiscard]] QIcon recentIcon(const QImage& picture, const QString& otherwise) const;
  QWidget* makeFiles();
  QWidget* makeSamples();
  void chooseRecent();
  void removeRecent();
  void updateRemove();

  QPushButton *open_, *continue_, *remove_;
  QToolButton* close_;
  QListWidget* recent_;
  QLabel* noRecent_;
  QWidget* samples_;
  std::vector<QToolButton*> sampleButtons_;
};

}  // namespace footfall::ui
