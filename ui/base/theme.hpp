// Light and dark: the palette, the style sheet, and who decides which of them holds.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPalette>
#include <QString>
#include <optional>

namespace footfall::ui {

class SystemColours;

enum class ThemeChoice { System, Light, Dark };

/// Whether the program is dark at the moment: what draws with colours of its own asks here, whenever it draws. Widgets
/// hear of a change through QEvent::PaletteChange.
bool isDarkTheme();

/// Colours of all widgets. Text has a contrast of at least 4.5 to 1 to what it stands on (WCAG 2.1, 1.4.3).
QPalette themePalette(bool dark);

/// theme.qss with its names (@error, @rowEdge, ...) replaced by colours.
QString themeStyleSheet(bool dark);

/// Text on the palette's colours that belongs to no role: problems and notes.
QColor errorTextColour();
QColor fainterTextColour();

/// The user's choice, kept in the settings, and what follows from it; one for the program. Needs a QApplication.
class Theme : public QObject {
  Q_OBJECT

 public:
  explicit Theme(QObject* parent);
  ~Theme() override;

  [[nodiscard]] ThemeChoice choice() const { return choice_; }
  /// Takes effect at once, in all windows.
  void setChoice(ThemeChoice choice);
  /// The same without keeping it, for pictures.
  void show(ThemeChoice choice);
  /// The one of the program; null before prepareApplication().
  static Theme* instance();

 signals:
  void choiceChanged();

 private:
  void apply();

  ThemeChoice choice_ = ThemeChoice::System;
  SystemColours* system_;
  std::optional<bool> applied_;
};

}  // namespace footfall::ui
