// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/text/level_units.hpp"

#include <cmath>

#include "footfall/up_axis.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

constexpr double kMetresPerFoot = 0.3048, kMillimetresPerMetre = 1000;
constexpr double kMostWithoutExponent = 1e9;  // larger numbers use an exponent, because nobody reads their last digits

// Rounds to twelve digits: 2 and not 1.9999999999999998, which a change of unit would leave.
double tidy(double value) { return QString::number(value, 'g', 12).toDouble(); }

}  // namespace

double LevelUnits::factor() const {
  switch (unit()) {
    case LengthUnit::Metres:
      return metresPerUnit;
    case LengthUnit::Millimetres:
      return metresPerUnit * kMillimetresPerMetre;
    case LengthUnit::Feet:
      return metresPerUnit / kMetresPerFoot;
    case LengthUnit::FileUnits:
      break;
  }
  return 1;
}

double LevelUnits::factor(Unit unit) const {
  if (unit == Unit::Length) return factor();
  if (unit != Unit::Area) return 1;
  return this->unit() == LengthUnit::Millimetres ? metresPerUnit * metresPerUnit : factor() * factor();
}

double LevelUnits::shown(double value, Unit unit) const {
  const double scale = factor(unit);
  return scale == 1 ? value : tidy(value * scale);
}

double LevelUnits::stored(double shown, Unit unit) const {
  const double scale = factor(unit);
  if (scale == 1) return shown;
  // Rounds as defaults are converted (core/pipeline/pipeline.cpp), where that gives the same value.
  const double rounded = tidy(shown / scale);
  return tidy(rounded * scale) == shown ? rounded : shown / scale;
}

QString LevelUnits::name() const {
  switch (unit()) {
    case LengthUnit::Metres:
      return tr("m");
    case LengthUnit::Millimetres:
      return tr("mm");
    case LengthUnit::Feet:
      return tr("ft");
    case LengthUnit::FileUnits:
      break;
  }
  return tr("units");
}

QString LevelUnits::areaName() const {
  return (unit() == LengthUnit::Millimetres ? tr("m") : name()) + QStringLiteral("²");
}

QString LevelUnits::lengthNumber(double length) const { return measureText(length * factor()); }

QString LevelUnits::areaNumber(double area) const {
  const double shown = area * factor(Unit::Area);
  const double size = std::abs(shown);
  if (size != 0 && (size < 1 || size >= kMostWithoutExponent)) return shortText(shown, 4);
  return fixedText(shown, size < 1000 ? 2 : 0);
}

QString LevelUnits::length(double length) const {
  const QString number = lengthNumber(length);
  const bool isOne = unit() == LengthUnit::FileUnits && number == QLatin1String("1");
  return number + QLatin1Char(' ') + (isOne ? tr("unit") : name());
}

QString LevelUnits::area(double area) const { return areaNumber(area) + QLatin1Char(' ') + areaName(); }

QString LevelUnits::size(const Vec3& size) const {
  return QStringLiteral("%1 × %2 × %3 %4")
      .arg(lengthNumber(size.x), lengthNumber(size.y), lengthNumber(size.z), name());
}

Vec3 LevelUnits::shownPlace(const Vec3& place) const {
  const Vec3 p = inFileFrame(place, up);
  const double scale = factor();
  // Rounding leaves a residue where a coordinate of a picked place should be 0; it is shown as 0.
  const double residue = 1e-9 * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z));
  const auto shown = [&](double x) { return std::isfinite(residue) && std::abs(x) < residue ? 0 : x * scale; };
  return {shown(p.x), shown(p.y), shown(p.z)};
}

Vec3 LevelUnits::storedPlace(const Vec3& shown) const {
  const double scale = factor();
  return fromFileFrame({shown.x / scale, shown.y / scale, shown.z / scale}, up);
}

QString LevelUnits::placeNumbers(const Vec3& place) const {
  const Vec3 p = shownPlace(place);
  return listText({measureText(p.x), measureText(p.y), measureText(p.z)});
}

QString LevelUnits::place(const Vec3& place) const {
  const Vec3 p = shownPlace(place);
  return listText({QStringLiteral("x ") + measureText(p.x), QStringLiteral("y ") + measureText(p.y),
                   QStringLiteral("z ") + measureText(p.z)}) +
         QLatin1Char(' ') + name();
}

double LevelUnits::shownHeight(double z) const {
  const Vec3 p = shownPlace({0, 0, z});
  return p.x + p.y + p.z;  // two of them are 0
}

QString LevelUnits::upText() const { return upAxisText(up); }

QString LevelUnits::frameText() const { return tr("Places are in the file's frame (%1), in %2").arg(upText(), name()); }

LevelUnits::FileAxis LevelUnits::fileAxis(int levelAxis) const {
  const footfall::FileAxis file = fileAxes(up)[static_cast<std::size_t>(levelAxis)];
  return {static_cast<int>(file.axis), file.sign > 0};
}

QString axisName(int axis) { return QString(QLatin1Char(static_cast<char>('X' + axis))); }

QString upAxisText(UpAxis up) { return LevelUnits::tr("%1 up").arg(QString::fromStdString(shownName(up))); }

}  // namespace footfall::ui
