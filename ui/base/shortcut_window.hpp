// F1: every key and what the mouse does, searchable.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QTreeWidget>

namespace footfall::ui {

class CommandRegistry;

/// Commands with keys by menu, then those without, and what the mouse and the keys do in the view and in the list.
/// Filled when it opens: commands come and go.
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
