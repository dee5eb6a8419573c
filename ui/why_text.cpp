// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/why_text.hpp"

#include <QLocale>
#include <QStringList>

#include "core/environment/up_axis.hpp"
#include "core/metrics/inspection_report.hpp"

namespace footfall {
namespace {

QString number(double value, int digits = 6) { return QLocale(QLocale::English).toString(value + 0.0, 'g', digits); }

QString coordinate(double value) {
  const QString text = QLocale(QLocale::English).toString(value, 'f', 3);
  return text == QLatin1String("-0.000") ? text.mid(1) : text;
}

}  // namespace

QString WhyText::length(double length, double metresPerUnit) {
  if (metresPerUnit == 1) return tr("%1 m").arg(number(length));
  return tr("%1 units (%2 m)").arg(number(length), number(length * metresPerUnit, 4));
}

QString WhyText::area(double area, double metresPerUnit) {
  if (metresPerUnit == 1) return tr("%1 m²").arg(number(area));
  return tr("%1 units² (%2 m²)").arg(number(area), number(area * metresPerUnit * metresPerUnit, 4));
}

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

QString WhyText::reason(const Inspector& inspector, const PlaceExplanation& told) {
  const double scale = inspector.environment().metresPerUnit;
  QString text;
  switch (told.verdict) {
    case PlaceVerdict::Walkable: {
      const std::size_t count = inspector.components().list.size();
      text = tr("It belongs to component %1 of %2, with an area of %3.")
                 .arg(told.component + 1)
                 .arg(count)
                 .arg(area(told.componentArea, scale));
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
                 .arg(QString::fromStdString(textBeside(told.movedSlope.value_or(told.slope), told.limit)),
                      number(told.limit));
      break;
    case PlaceVerdict::TooLow:
      if (!told.obstacle) {
        text = tr("Something is above it within the %1 that agents need.").arg(length(told.limit, scale));
      } else {
        const QString height = QString::fromStdString(textBeside(told.obstacle->height, told.limit));
        text = tr("Triangle %1 is %2 above it; agents need %3.")
                   .arg(triangle(inspector, told.obstacle->triangle),
                        scale == 1 ? tr("%1 m").arg(height) : tr("%1 units").arg(height), length(told.limit, scale));
      }
      break;
    case PlaceVerdict::RegionTooSmall:
      text = tr("The connected region around it has an area of %1; it must have more than %2.")
                 .arg(area(told.regionArea, scale), area(told.limit, scale));
      break;
    case PlaceVerdict::Moved:
      text = tr("The filter moved vertices, and no triangle is here any more.");
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
  return told.verdict == PlaceVerdict::NoArea ? tr("none") : tr("%1°").arg(number(told.slope));
}

QString WhyText::headroom(const Inspector& inspector, const PlaceExplanation& told) {
  if (told.verdict == PlaceVerdict::NoArea || told.verdict == PlaceVerdict::Vertical) return tr("none");
  if (!told.above) return tr("unlimited: nothing is above");
  return tr("%1, below triangle %2")
      .arg(length(told.above->height, inspector.environment().metresPerUnit),
           triangle(inspector, told.above->triangle));
}

QString WhyText::place(const Inspector& inspector, const Vec3& place) {
  const Vec3 p = inFileFrame(place, inspector.environment().up);
  return tr("x %1, y %2, z %3").arg(coordinate(p.x), coordinate(p.y), coordinate(p.z));
}

Paint WhyText::paint(const Inspector& inspector, const PlaceExplanation& told) {
  if (told.verdict == PlaceVerdict::Walkable) return told.layer ? layerPaint(*told.layer) : walkablePaint();
  if (!told.step) return wallPaint();
  const RemovalStyle* style = removalStyle(inspector.pipeline().steps[*told.step].filter->name);
  return style != nullptr ? style->paint : wallPaint();
}

}  // namespace footfall
