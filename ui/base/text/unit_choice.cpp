// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/text/unit_choice.hpp"

#include <QSettings>
#include <array>
#include <utility>

namespace footfall::ui {
namespace {

constexpr std::array<std::pair<const char*, LengthUnit>, 4> kNames = {{{"metres", LengthUnit::Metres},
                                                                       {"feet", LengthUnit::Feet},
                                                                       {"file", LengthUnit::FileUnits},
                                                                       {"millimetres", LengthUnit::Millimetres}}};
const QString kSetting = QStringLiteral("lengthUnit");

LengthUnit unitOfUser() { return lengthUnitFrom(QSettings().value(kSetting).toString()).value_or(LengthUnit::Metres); }

}  // namespace

const char* nameOf(LengthUnit unit) { return kNames[static_cast<std::size_t>(unit)].first; }

std::optional<LengthUnit> lengthUnitFrom(const QString& name) {
  for (const auto& [known, unit] : kNames)
    if (name == QLatin1String(known)) return unit;
  return std::nullopt;
}

UnitChoice::UnitChoice(QObject* parent) : QObject(parent) { units_.wanted = unitOfUser(); }

void UnitChoice::choose(LengthUnit unit) {
  QSettings().setValue(kSetting, QLatin1String(nameOf(unit)));
  useForSession(unit);
}

void UnitChoice::useForSession(std::optional<LengthUnit> unit) {
  LevelUnits next = units_;
  next.wanted = unit.value_or(unitOfUser());
  set(next);
}

void UnitChoice::setLevel(const Environment& level) {
  LevelUnits next = units_;
  next.up = level.up;
  next.metresPerUnit = level.metresPerUnit;
  next.scaleKnown = !level.scaleGuessed;
  set(next);
}

void UnitChoice::set(const LevelUnits& units) {
  if (std::exchange(units_, units) == units) return;
  emit changed();
}

}  // namespace footfall::ui
