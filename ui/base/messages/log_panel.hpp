// The dock Log: earlier messages, to search, copy and save.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QLineEdit>
#include <QListView>
#include <QSortFilterProxyModel>
#include <QToolButton>
#include <QWidget>

#include "ui/base/messages/message_log.hpp"

namespace footfall::ui {

class LogPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LogPanel(MessageLog& log, QWidget* parent = nullptr);

  /// The selected messages, or all shown ones when none is selected, one a line.
  [[nodiscard]] QString text() const;
  [[nodiscard]] QListView* list() const { return list_; }
  [[nodiscard]] QComboBox* levels() const { return levels_; }
  [[nodiscard]] QLineEdit* search() const { return search_; }
  [[nodiscard]] QToolButton* copyButton() const { return copy_; }
  [[nodiscard]] QToolButton* saveButton() const { return save_; }
  [[nodiscard]] QToolButton* clearButton() const { return clear_; }

 signals:
  /// Emitted when the user chooses to save text() in a file.
  void saveRequested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QToolButton* makeButton(const QString& name, const QString& iconName, const QString& text, const QString& help);
  void copy() const;

  MessageLog& log_;
  QSortFilterProxyModel* shown_;
  QComboBox* levels_;
  QLineEdit* search_;
  QToolButton *copy_, *save_, *clear_;
  QListView* list_;
};

}  // namespace footfall::ui
