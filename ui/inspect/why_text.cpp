// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/why_text.hpp"

#include <QStringList>

#include "core/inspect/removal_text.hpp"
#include "core/report/inspection_report.hpp"
#include "footfall/filter.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

/// A number of a place in the unit of people, with as many digits as it takes to see that it differs from a limit.
QString measureBeside(double measure, double limit, Unit unit, const LevelUnits& units) {
  const double factor = units.factor(unit);
  const QString number = QString::fromStdString(textBeside(measure * factor, limit * factor))
                             .replace(QLatin1Char('.'), numberLocale().decimalPoint());
  if (unit == Unit::Degrees) return number + QChar(0xB0);
  return unit == Unit::Length ? number + QLatin1Char(' ') + units.name() : number;
}

QString limitText(double limit, Unit unit, const LevelUnits& units) {
  switch (unit) {
    case Unit::Degrees:
      return shortText(limit) + QChar(0xB0);
    case Unit::Length:
      return units.length(limit);
    case Unit::Area:
      return units.area(limit);
    case Unit::Count:
    case Unit::None:
      break;
  }
  return shortText(limit);
}

}  // namespace

QString WhyText::headline(const Inspector& inspector, const PlaceExplanation& told) {
  switch (told.verdict) {
    case PlaceVerdict::Walkable:
      return told.walls.empty() ? tr("Walkable") : tr("Walkable, on an obstacle edge");
    case PlaceVerdict::Vertical:
      return tr("Not walkable: a wall");
    case PlaceVerdict::FacesDown:
      return tr("Not walkable: faces down");
    case PlaceVerdict::NeverFloor:
      return tr("Not walkable: an obstacle only");
    case PlaceVerdict::NoArea:
    case PlaceVerdict::TooSteep:
    case PlaceVerdict::TooLow:
    case PlaceVerdict::RegionTooSmall:
    case PlaceVerdict::Moved:
    case PlaceVerdict::Unreachable:
    case PlaceVerdict::TooNearWall:
    case PlaceVerdict::TooNearLedge:
    case PlaceVerdict::Removed:
      break;
  }
  const Removal* removal = removalOf(inspector.pipeline(), told);
  return removal ? coreText(removal->headline) : tr("Not walkable");
}

QString WhyText::triangle(const Inspector& inspector, std::uint32_t triangle) {
  const Environment& environment = inspector.environment();
  QStringList names;
  if (triangle < environment.partOf.size()) {
    const EnvironmentPart& part = environment.parts[environment.partOf[triangle]];
    for (const std::string& name : {part.mesh, part.material})
      if (!name.empty()) names << QString::fromStdString(name);
  }
  return names.isEmpty() ? QString::number(triangle)
                         : tr("%1 (%2)").arg(QString::number(triangle), names.join(QStringLiteral(", ")));
}

QString WhyText::removalReason(const Inspector& inspector, const PlaceExplanation& told, const LevelUnits& units) {
  const Removal* removal = removalOf(inspector.pipeline(), told);
  if (!removal) return tr("The filter of this step removed it.");
  Unit unit = Unit::None;
  if (removal->limit && told.step)
    unit = inspector.pipeline().steps[*told.step].filter->parameters[*removal->limit].unit;
  QString measure;
  if (const auto measured = measureOf(*removal, told))
    measure = unit == Unit::Area ? units.area(*measured) : measureBeside(*measured, told.limit, unit, units);
  const QString obstacle = told.obstacle ? triangle(inspector, told.obstacle->triangle) : QString();
  return coreText(reasonText(*removal, measure.toStdString(), limitText(told.limit, unit, units).toStdString(),
                             obstacle.toStdString()));
}

QString WhyText::reason(const Inspector& inspector, const PlaceExplanation& told, const LevelUnits& units) {
  QString text;
  switch (told.verdict) {
    case PlaceVerdict::Walkable: {
      const std::size_t count = inspector.components().list.size();
      text = tr("It belongs to component %1 of %2, with an area of %3.")
                 .arg(told.component + 1)
                 .arg(count)
                 .arg(units.area(told.componentArea));
      if (told.layer) text = tr("Layer %1.").arg(*told.layer) + QLatin1Char(' ') + text;
      break;
    }
    case PlaceVerdict::Vertical:
      text = tr("The triangle stands upright; nobody can stand on it. What it crosses becomes obstacle edges.");
      break;
    case PlaceVerdict::FacesDown:
      text =
          tr("Only triangles that face up are floors. If the file's winding is unreliable, let both sides count as "
             "up.");
      break;
    case PlaceVerdict::NeverFloor:
      text = tr("This part of the environment is marked as an obstacle only.");
      break;
    case PlaceVerdict::NoArea:
    case PlaceVerdict::TooSteep:
    case PlaceVerdict::TooLow:
    case PlaceVerdict::RegionTooSmall:
    case PlaceVerdict::Moved:
    case PlaceVerdict::Unreachable:
    case PlaceVerdict::TooNearWall:
    case PlaceVerdict::TooNearLedge:
    case PlaceVerdict::Removed:
      text = removalReason(inspector, told, units);
      break;
  }
  if (told.floor)
    text += QLatin1Char(' ') +
            tr("The floor here is triangle %1, in the same plane.").arg(triangle(inspector, *told.floor));
  if (!told.walls.empty()) {
    QStringList walls;
    for (const std::uint32_t wall : told.walls) walls << triangle(inspector, wall);
    text += QLatin1Char(' ') + tr("Exactly here stands a wall: triangle %1.").arg(walls.join(QStringLiteral(", ")));
  }
  return text;
}

QString WhyText::slope(const PlaceExplanation& told) {
  return told.verdict == PlaceVerdict::NoArea ? tr("none") : tr("%1°").arg(shortText(told.slope));
}

QString WhyText::headroom(const Inspector& inspector, const PlaceExplanation& told, const LevelUnits& units) {
  if (told.verdict == PlaceVerdict::NoArea || told.verdict == PlaceVerdict::Vertical) return tr("none");
  if (!told.above) return tr("unlimited: nothing is above");
  return tr("%1, below triangle %2").arg(units.length(told.above->height), triangle(inspector, told.above->triangle));
}

QString WhyText::borders(const PlaceExplanation& told, const LevelUnits& units) {
  QStringList parts;
  if (told.wallDistance) parts << tr("a wall at %1").arg(units.length(*told.wallDistance));
  if (told.ledgeDistance) parts << tr("a ledge at %1").arg(units.length(*told.ledgeDistance));
  return parts.isEmpty() ? tr("none") : parts.join(tr(", ", "between two borders"));
}

Paint WhyText::paint(const Inspector& inspector, const PlaceExplanation& told) {
  if (told.verdict == PlaceVerdict::Walkable) return told.layer ? layerPaint(*told.layer) : walkablePaint();
  if (!told.step) return wallPaint();
  const Removal* removal = removalOf(inspector.pipeline(), told);
  const RemovalStyle* style = removal ? removalStyle(*removal) : nullptr;
  return style != nullptr ? style->paint : wallPaint();
}

}  // namespace footfall::ui
