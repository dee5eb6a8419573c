// The language of the program.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace footfall::ui {

class CommandRegistry;

/// Languages that there are translations for, as codes: "en" and others. Found among the resources.
QStringList languages();

/// The user's choice; empty: as the system.
QString chosenLanguage();
/// Kept in the settings; holds from the next start on.
void chooseLanguage(const QString& code);

/// Loads the texts in the chosen language (the system's where none is chosen), Qt's own included, before any window is
/// made. `forced` overrules the choice without changing it. Texts without a translation stay English.
void loadTranslations(const QString& forced = {});

/// The submenu Language in the menu View.
void addLanguageCommands(CommandRegistry& commands);

}  // namespace footfall::ui
