// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/commands/translations.hpp"

#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>

#include "ui/base/commands/commands.hpp"

namespace footfall::ui {
namespace {

struct Language {
  Q_DECLARE_TR_FUNCTIONS(footfall::ui::Language)
};

const auto kLanguageKey = QStringLiteral("language");
const auto kFolder = QStringLiteral(":/translations");
const auto kPrefix = QStringLiteral("footfall_");

void install(const QLocale& locale, const QString& file, const QString& folder) {
  auto* translator = new QTranslator(qApp);
  if (translator->load(locale, file, QString(), folder)) {
    QCoreApplication::installTranslator(translator);
  } else {
    delete translator;
  }
}

// The language's name in itself, such as "Deutsch".
QString nameOf(const QString& code) {
  QString name = QLocale(code).nativeLanguageName();
  // Qt names it "American English" where there is only one English.
  if (code == QLatin1String("en")) name = QStringLiteral("English");
  return name.isEmpty() ? code : name;
}

}  // namespace

QStringList languages() {
  QStringList codes;
  for (const QString& name : QDir(kFolder).entryList({kPrefix + QStringLiteral("*.qm")}, QDir::Files, QDir::Name))
    codes << name.mid(kPrefix.size(), name.size() - kPrefix.size() - 3);
  return codes;
}

QString chosenLanguage() {
  const QString code = QSettings().value(kLanguageKey).toString();
  return languages().contains(code) ? code : QString();
}

void chooseLanguage(const QString& code) { QSettings().setValue(kLanguageKey, code); }

void loadTranslations(const QString& forced) {
  const QString code = forced.isEmpty() ? chosenLanguage() : forced;
  const QLocale locale = code.isEmpty() ? QLocale::system() : QLocale(code);
  QLocale::setDefault(locale);  // numbers and dates follow the language
  const QString qtFolder = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
  install(locale, QStringLiteral("qtbase_"), qtFolder);
  // English has a translation for its plurals; every other language falls back to it.
  install(QLocale(QLocale::English), kPrefix, kFolder);
  if (locale.language() != QLocale::English) install(locale, kPrefix, kFolder);
}

void addLanguageCommands(CommandRegistry& commands) {
  auto* group = new QActionGroup(&commands);
  const auto add = [&](const QString& code, const QString& text, const QString& help) {
    Command command{QStringLiteral("view.language.") + (code.isEmpty() ? QStringLiteral("system") : code),
                    CommandMenu::View,
                    QStringLiteral("theme"),
                    text,
                    help,
                    {},
                    {},
                    true};
    command.submenu = Language::tr("&Language");
    QAction* action = commands.add(command, [](bool) {});
    action->setChecked(chosenLanguage() == code);
    group->addAction(action);
    // The action is connected to triggered(), because the initial state is not a choice.
    QObject::connect(action, &QAction::triggered, action, [code] { chooseLanguage(code); });
  };
  const QString help = Language::tr("Takes effect when Footfall is started the next time");
  add({}, Language::tr("Language: as the &system"), help);
  for (const QString& code : languages()) add(code, Language::tr("Language: %1").arg(nameOf(code)), help);
}

}  // namespace footfall::ui
