// The command palette (Ctrl+K): finds every command by a few letters.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QIcon>
#include <QLineEdit>
#include <QListView>
#include <QStandardItemModel>
#include <functional>
#include <vector>

namespace footfall::ui {

class CommandRegistry;

struct PaletteEntry {
  QString title;     ///< searched first
  QString detail;    ///< where the entry belongs, in grey behind the title; searched too
  QString shortcut;  ///< shown at the right
  QIcon icon;
  bool enabled = true;  ///< a disabled entry is shown in grey and does nothing
  QString help;         ///< tool tip
  std::function<void()> run;
};

/// Sources are called whenever the palette opens. Enter or a click closes the palette and runs the selected entry; Up,
/// Down, Page Up and Page Down move the selection while the user types; Esc closes.
class CommandPalette : public QDialog {
  Q_OBJECT

 public:
  using Source = std::function<std::vector<PaletteEntry>()>;

  explicit CommandPalette(QWidget* parent);

  void addSource(Source source) { sources_.push_back(std::move(source)); }
  /// Opens over the upper middle of the parent.
  void openUp();

  [[nodiscard]] QLineEdit* field() const { return field_; }
  [[nodiscard]] QListView* list() const { return list_; }
  /// The titles that are shown, the best first.
  [[nodiscard]] QStringList titles() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showMatches();
  void runMarked();
  void moveMark(int rows);

  std::vector<Source> sources_;
  std::vector<PaletteEntry> entries_;
  QLineEdit* field_;
  QListView* list_;
  QStandardItemModel* model_;
};

/// The commands of a registry as entries: titles without mnemonics, with their place in the menus.
std::vector<PaletteEntry> commandEntries(const CommandRegistry& commands);

/// The text of a menu without its mnemonic: "Open..." for "&Open...".
QString plainText(const QString& menuText);

}  // namespace footfall::ui
