// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/unit_tools.hpp"

#include <QActionGroup>
#include <array>
#include <nlohmann/json.hpp>

#include "footfall/errors.hpp"
#include "ui/base/text/translated.hpp"
#include "ui/view/feature_host.hpp"

namespace footfall::ui {
namespace {

struct Entry {
  LengthUnit unit;
  QString text, help;
};

void addMenu(const FeatureHost& host) {
  const QString lengths = QStringLiteral("lengths");
  host.commands.addSubmenu(CommandMenu::View, tr("Len&gths in"), {lengths});
  const std::array<Entry, 4> entries = {
      {{LengthUnit::Metres, tr("&Metres"),
        tr("Show and type lengths in metres, where the scale of the level is known")},
       {LengthUnit::Millimetres, tr("M&illimetres"),
        tr("Show and type lengths in millimetres, and areas in square metres, where the scale of the level is known")},
       {LengthUnit::Feet, tr("&Feet"), tr("Show and type lengths in feet, where the scale of the level is known")},
       {LengthUnit::FileUnits, tr("File's &units"), tr("Show and type lengths as the file has them")}}};
  auto* group = new QActionGroup(&host.window);
  for (const Entry& entry : entries) {
    Command command;
    command.id = QStringLiteral("view.lengths.") + QLatin1String(nameOf(entry.unit));
    command.menu = CommandMenu::View;
    command.group = lengths;
    command.text = entry.text;
    command.help = entry.help;
    command.checkable = true;
    QAction* action =
        host.commands.add(command, [&units = host.units, &sections = host.sections, unit = entry.unit](bool on) {
          if (!on || units.units().wanted == unit) return;  // a session has checked the action, and not the user
          units.choose(unit);
          emit sections.changed();
        });
    group->addAction(action);
    const auto follow = [&units = host.units, action, unit = entry.unit] {
      action->setChecked(units.units().wanted == unit);
    };
    QObject::connect(&host.units, &UnitChoice::changed, action, follow);
    follow();
  }
}

void load(UnitChoice& units, const std::string& text) {
  if (text.empty()) {
    units.useForSession(std::nullopt);
    return;
  }
  const auto name = nlohmann::json::parse(text).value("lengths", std::string());
  const auto unit = lengthUnitFrom(QString::fromStdString(name));
  if (!unit) throw InputError(FOOTFALL_TEXT("lengths are in '%1'; give metres, millimetres, feet or file"), name);
  units.useForSession(unit);
}

}  // namespace

void installUnitTools(const FeatureHost& host) {
  addMenu(host);
  host.sections.add({QStringLiteral("units"),
                     [&units = host.units] {
                       return nlohmann::json{{"lengths", nameOf(units.units().wanted)}}.dump();
                     },
                     [&units = host.units](const std::string& text) { load(units, text); }});
}

}  // namespace footfall::ui
