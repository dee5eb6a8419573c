// The window of all keys and mouse actions (F1), with a search field.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QTreeWidget>

namespace footfall::ui {

class CommandRegistry;

/// Lists commands with keys by menu, then commands without keys, then the keys and mouse actions of the view and the
/// list. It is filled when it opens, because commands change.
class ShortcutWindow : public QDialog {
  Q_OBJECT

 public:
  ShortcutWindow(const CommandRegistry& commands, QWidget* parent);

  [[nodiscard]] QLineEdit* search() const { return search_; }
  [[nodiscard]] QTreeWidget* table() const { return table_; }

 private:
  void fill(const CommandRegistry& commands);
  void filter(const QString& text);

  QLineEdit* search_;
  QTreeWidget* table_;
};

}  // namespace footfall::ui
