// Ctrl+K: everything that can be done, found by a few letters.
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
  QString title;     ///< what is searched first
  QString detail;    ///< where it comes from, in grey behind the title; searched too
  QString shortcut;  ///< at the right
  QIcon icon;
  bool enabled = true;  ///< else it says so and does nothing
  QString help;         ///< tool tip
  std::function<void()> run;
};

/// Sources are asked whenever the palette opens. Enter, or a click, does the marked entry, once the palette is closed;
/// Up, Down, Page Up and Page Down move the mark while one types; Esc closes.
class CommandPalette : public QDialog {
  Q_OBJECT

 public:
  using Source = std::function<std::vector<PaletteEntry>()>;

  explicit CommandPalette(QWidget* parent);

  void addSource(Source source) { sources_.push_back(std::move(source)); }
  /// Over the upper middle of the parent.
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

/// The commands of a registry as entries: titles without mnemonics, with where they are in the menus.
std::vector<PaletteEntry> commandEntries(const CommandRegistry& commands);

/// "Open..." for "&Open...": a menu's text without its mnemonic.
QString plainText(const QString& menuText);

}  // namespace footfall::ui
