// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/unit_tools.hpp"

#include <QActionGroup>
#include <array>
#include <nlohmann/json.hpp>

#include "footfall/errors.hpp"
#include "ui/window/editor_window.hpp"

namespace footfall::ui {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("footfall::ui", text); }

struct Entry {
  LengthUnit unit;
  QString text, help;
};

void addMenu(EditorWindow& window) {
  const QString lengths = QStringLiteral("lengths");
  window.commands().addSubmenu(CommandMenu::View, tr("Len&gths in"), {lengths});
  const std::array<Entry, 3> entries = {
      {{LengthUnit::Metres, tr("&Metres"),
        tr("Show and type lengths in metres, where the scale of the level is known")},
       {LengthUnit::Feet, tr("&Feet"), tr("Show and type lengths in feet, where the scale of the level is known")},
       {LengthUnit::FileUnits, tr("File's &units"), tr("Show and type lengths as the file has them")}}};
  auto* group = new QActionGroup(&window);
  for (const Entry& entry : entries) {
    Command command;
    command.id = QStringLiteral("view.lengths.") + QLatin1String(nameOf(entry.unit));
    command.menu = CommandMenu::View;
    command.group = lengths;
    command.text = entry.text;
    command.help = entry.help;
    command.checkable = true;
    QAction* action = window.commands().add(command, [&window, unit = entry.unit](bool on) {
      if (!on || window.units().units().wanted == unit) return;  // checked by a session, not by the user
      window.units().choose(unit);
      window.keepSoon();
    });
    group->addAction(action);
    const auto follow = [&window, action, unit = entry.unit] {
      action->setChecked(window.units().units().wanted == unit);
    };
    QObject::connect(&window.units(), &UnitChoice::changed, action, follow);
    follow();
  }
}

void load(EditorWindow& window, const std::string& text) {
  if (text.empty()) {
    window.units().useForSession(std::nullopt);
    return;
  }
  const auto name = nlohmann::json::parse(text).value("lengths", std::string());
  const auto unit = lengthUnitFrom(QString::fromStdString(name));
  if (!unit) throw InputError(FOOTFALL_TEXT("lengths are in '%1'; give metres, feet or file"), name);
  window.units().useForSession(unit);
}

}  // namespace

void installUnitTools(EditorWindow& window) {
  addMenu(window);
  window.addSessionSection({QStringLiteral("units"),
                            [&window] {
                              return nlohmann::json{{"lengths", nameOf(window.units().units().wanted)}}.dump();
                            },
                            [&window](const std::string& text) { load(window, text); }});
}

}  // namespace footfall::ui
