// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/why_text.hpp"

#include <QStringList>

#include "core/report/inspection_report.hpp"
#include "footfall/filter.hpp"
#include "ui/base/localized_numbers.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {
namespace {

/// A length that differs from a limit, with enough digits to show the difference.
QString lengthBeside(double length, double limit, const LevelUnits& units) {
  const double factor = units.factor();
  return QString::fromStdString(textBeside(length * factor, limit * factor))
             .replace(QLatin1Char('.'), numberLocale().decimalPoint()) +
         QLatin1Char(' ') + units.name();
}

}  // namespace

QString WhyText::headline(const PlaceExplanation& told) {
  switch (told.verdict) {
    case PlaceVerdict::Walkable:
      return told.walls.empty() ? tr("Walkable") : tr("Walkable, on an obstacle edge");
    case PlaceVerdict::NoArea:
      return tr("Not walkable: without area");
    case PlaceVerdict::Vertical:
      return tr("Not walkable: a wall");
    case PlaceVerdict::FacesDown:
      return tr("Not walkable: faces down");
    case PlaceVerdict::NeverFloor:
      return tr("Not walkable: an obstacle only");
    case PlaceVerdict::TooSteep:
      return tr("Not walkable: too steep");
    case PlaceVerdict::TooLow:
      return tr("Not walkable: too low");
    case PlaceVerdict::RegionTooSmall:
      return tr("Not walkable: too small an area");
    case PlaceVerdict::Moved:
      return tr("Not walkable: merged away");
    case PlaceVerdict::Unreachable:
      return tr("Not walkable: unreachable");
    case PlaceVerdict::TooNearWall:
      return tr("Not walkable: too near a wall");
    case PlaceVerdict::TooNearLedge:
      return tr("Not walkable: too near a ledge");
  }
  return {};
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
    case PlaceVerdict::NoArea:
      text = tr("The corners of this triangle lie on one line.");
      break;
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
    case PlaceVerdict::TooSteep:
      text = tr("It rises by %1°; at most %2° are allowed.")
                 .arg(QString::fromStdString(textBeside(told.movedSlope.value_or(told.slope), told.limit))
                          .replace(QLatin1Char('.'), numberLocale().decimalPoint()),
                      shortText(told.limit));
      break;
    case PlaceVerdict::TooLow:
      if (!told.obstacle) {
        text = tr("Something is above it within the %1 that agents need.").arg(units.length(told.limit));
      } else {
        text = tr("Triangle %1 is %2 above it; agents need %3.")
                   .arg(triangle(inspector, told.obstacle->triangle),
                        lengthBeside(told.obstacle->height, told.limit, units), units.length(told.limit));
      }
      break;
    case PlaceVerdict::RegionTooSmall:
      text = tr("The connected region around it has an area of %1; it must have more than %2.")
                 .arg(units.area(told.regionArea), units.area(told.limit));
      break;
    case PlaceVerdict::Moved:
      text = tr("The filter moved vertices, and no triangle is here any more.");
      break;
    case PlaceVerdict::Unreachable:
      text = tr("It cannot be reached from the seeds.");
      break;
    case PlaceVerdict::TooNearWall:
      text = tr("Agents stay %1 away from walls.").arg(units.length(told.limit));
      break;
    case PlaceVerdict::TooNearLedge:
      text = tr("Agents stay %1 away from ledges: drops and the ends of the level.").arg(units.length(told.limit));
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
  if (told.verdict == PlaceVerdict::TooNearWall) return removalStyle(Removal::NearWall).paint;
  if (told.verdict == PlaceVerdict::TooNearLedge) return removalStyle(Removal::NearLedge).paint;
  const RemovalStyle* style = removalStyle(inspector.pipeline().steps[*told.step].filter->type);
  return style != nullptr ? style->paint : wallPaint();
}

}  // namespace footfall::ui
