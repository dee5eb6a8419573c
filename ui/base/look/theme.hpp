// The light and dark themes: their palettes, their style sheet, and the choice between them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPalette>
#include <QString>
#include <optional>

namespace footfall::ui {

class SystemColours;

enum class ThemeChoice { System, Light, Dark };

/// Returns whether the program is dark at the moment. Code that draws with colours of its own calls this whenever it
/// draws; a change sends QEvent::PaletteChange to widgets.
bool isDarkTheme();

/// The colours of all widgets. Text has a contrast of at least 4.5 to 1 to its background (WCAG 2.1, 1.4.3).
QPalette themePalette(bool dark);

/// theme.qss with its names (@error, @rowEdge, ...) replaced by colours.
QString themeStyleSheet(bool dark);

/// Colours of problems and notes, for which palettes have no role.
QColor errorTextColour();
QColor fainterTextColour();

/// The user's choice of a theme, kept in the settings, and its application. The program has one. Needs a QApplication.
class Theme : public QObject {
  Q_OBJECT

 public:
  explicit Theme(QObject* parent);
  ~Theme() override;

  [[nodiscard]] ThemeChoice choice() const { return choice_; }
  /// Takes effect at once, in all windows.
  void setChoice(ThemeChoice choice);
  /// Shows a theme without saving the choice, for pictures.
  void show(ThemeChoice choice);
  /// The program's theme; null before prepareApplication().
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
