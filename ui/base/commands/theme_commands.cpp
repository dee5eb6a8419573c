// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/commands/theme_commands.hpp"

#include <QActionGroup>
#include <QCoreApplication>

#include "ui/base/look/theme.hpp"

namespace footfall::ui {
namespace {

struct ThemeCommands {
  Q_DECLARE_TR_FUNCTIONS(footfall::ui::ThemeCommands)
};

}  // namespace

void addThemeCommands(CommandRegistry& commands) {
  Theme* theme = Theme::instance();
  if (!theme) return;
  auto* group = new QActionGroup(&commands);
  const auto add = [&](ThemeChoice choice, const char* id, const QString& text, const QString& help,
                       const QString& icon) {
    Command command{QString::fromLatin1(id), CommandMenu::View, QStringLiteral("theme"), text, help, {}, icon, true};
    command.submenu = ThemeCommands::tr("T&heme");
    QAction* action = commands.add(command, [choice](bool on) {
      Theme* theme = Theme::instance();
      // A theme that is shown for this session only must not become the user's choice.
      if (on && theme && theme->choice() != choice) theme->setChoice(choice);
    });
    group->addAction(action);
    const auto show = [theme, action, choice] { action->setChecked(theme->choice() == choice); };
    QObject::connect(theme, &Theme::choiceChanged, action, show);
    show();
  };
  add(ThemeChoice::System, "view.theme.system", ThemeCommands::tr("Theme: as the &system"),
      ThemeCommands::tr("Light or dark, as the desktop is, and with it when it changes"), {});
  add(ThemeChoice::Light, "view.theme.light", ThemeCommands::tr("Theme: &light"),
      ThemeCommands::tr("Dark text on light ground"), QStringLiteral("light"));
  add(ThemeChoice::Dark, "view.theme.dark", ThemeCommands::tr("Theme: &dark"),
      ThemeCommands::tr("Light text on dark ground"), QStringLiteral("dark"));
}

}  // namespace footfall::ui
