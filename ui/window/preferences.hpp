// All settings of the program in one dialog.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTreeWidget>

#include "ui/base/commands/commands.hpp"
#include "ui/base/commands/user_keys.hpp"
#include "ui/base/text/unit_choice.hpp"
#include "ui/run/run_threads.hpp"

namespace footfall::ui {

/// Every choice takes effect at once, except the language and the size of the interface, which apply from the next
/// start on.
class Preferences : public QDialog {
  Q_OBJECT

 public:
  Preferences(CommandRegistry& commands, UserKeys& keys, UnitChoice& units, RunThreads& threads, QWidget* parent);

  [[nodiscard]] QTreeWidget* keyTable() const { return table_; }
  [[nodiscard]] QKeySequenceEdit* keyField() const { return key_; }
  [[nodiscard]] QString keyProblem() const { return problem_->text(); }

 private:
  QWidget* makeGeneral(UnitChoice& units, RunThreads& threads);
  QWidget* makeKeys();
  void fillKeys();
  void showKey();
  void takeKey(const QKeySequence& key);
  [[nodiscard]] QString current() const;

  CommandRegistry& commands_;
  UserKeys& keys_;
  QTreeWidget* table_;
  QKeySequenceEdit* key_;
  QPushButton *usual_, *none_;
  QLabel* problem_;
};

/// The chosen size of the interface in percent of the system's.
int interfaceScale();
/// Called before the application is made.
void applyInterfaceScale();

}  // namespace footfall::ui
