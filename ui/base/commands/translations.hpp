// The language of the program.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace footfall::ui {

class CommandRegistry;

/// The codes of languages with a translation, among them "en". They are found among the resources.
QStringList languages();

/// The user's choice; empty: the system's language.
QString chosenLanguage();
/// Saves the choice in the settings; it applies from the next start on.
void chooseLanguage(const QString& code);

/// Loads the texts in the chosen language (the system's where none is chosen), including Qt's own, before any window is
/// made. `forced` overrides the choice without changing it. Texts without a translation stay English.
void loadTranslations(const QString& forced = {});

/// Adds the submenu Language to the menu View.
void addLanguageCommands(CommandRegistry& commands);

}  // namespace footfall::ui
