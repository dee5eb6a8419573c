// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/path_text.hpp"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "ui/base/text/localized_numbers.hpp"
#include "ui/path/walk/walk_track.hpp"

namespace footfall::ui {
namespace {

/// The struct is the context of the translations.
struct PathText {
  Q_DECLARE_TR_FUNCTIONS(footfall::ui::PathText)
};

QString seconds(double time) {
  if (time < 60) return PathText::tr("%1 s").arg(fixedText(time, 1));
  const int whole = static_cast<int>(std::lround(std::min(time, 1e8)));
  return PathText::tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
}

QString degrees(double angle) { return fixedText(angle, 1) + QStringLiteral("°"); }

}  // namespace

QString failureText(const PathResult& result, const LevelUnits& units) {
  switch (result.status) {
    case PathStatus::Found:
      return {};
    case PathStatus::NothingWalkable:
      return PathText::tr("Nothing is walkable here.");
    case PathStatus::StartNotWalkable:
      return PathText::tr("The start is not walkable. The nearest walkable place is %1 away, at %2.")
          .arg(units.length(result.start->distance), units.place(result.start->position));
    case PathStatus::TargetNotWalkable:
      return PathText::tr("The target is not walkable. The nearest place that can be reached is %1 away, at %2.")
          .arg(units.length(result.end->distance), units.place(result.end->position));
    case PathStatus::NotConnected:
      if (result.leadsBack) {
        return PathText::tr(
                   "Drops lead from the target to the start, but no way leads back up. The nearest place that can be "
                   "reached is %1 away, at %2.")
            .arg(units.length(result.end->distance), units.place(result.end->position));
      }
      return PathText::tr(
                 "There is no way: start and target are on separate parts. The nearest place that can be reached is %1 "
                 "away, at %2.")
          .arg(units.length(result.end->distance), units.place(result.end->position));
  }
  return {};
}

QString bodyFailureText(const BodyPath& path, const LevelUnits& units) {
  const QString lacking = units.length(path.lacking);
  const QString room = path.admissible
                           ? PathText::tr("A place with enough room is at %1.").arg(units.place(*path.admissible))
                           : PathText::tr("No place around it has enough room.");
  switch (path.status) {
    case BodyPathStatus::Found:
      return {};
    case BodyPathStatus::NoPath:
      return PathText::tr("Only drops lead to the target, and a body with a radius takes none.");
    case BodyPathStatus::StartTooNear:
      return PathText::tr("The start is %1 from the border, %2 less than the radius.")
                 .arg(units.length(path.startDistance), lacking) +
             QLatin1Char(' ') + room;
    case BodyPathStatus::TargetTooNear:
      return PathText::tr("The target is %1 from the border, %2 less than the radius.")
                 .arg(units.length(path.targetDistance), lacking) +
             QLatin1Char(' ') + room;
    case BodyPathStatus::TooNarrow:
      if (!path.narrowest) return PathText::tr("No passage leads from the start to the target.");
      return PathText::tr(
                 "Every way is too narrow. The widest one has a passage of %1 at %2; the body is %3 wide, "
                 "which is %4 too much.")
          .arg(units.length(path.narrowest->width), units.place(path.narrowest->place),
               units.length(path.narrowest->width + path.lacking), lacking);
  }
  return {};
}

QString narrowestText(const BodyPath& path, const LevelUnits& units) {
  if (!path.reached() || !path.narrowest) return {};
  return PathText::tr("Narrowest passage %1").arg(units.length(path.narrowest->width));
}

QString pathText(const PathResult& result, const LevelUnits& units, double speed) {
  if (!result.hasPath()) return {};
  QStringList lines;
  lines << PathText::tr("Length %1").arg(units.length(result.length));
  lines << (result.bends.size() == 1 ? PathText::tr("In the plan %1, 1 bend").arg(units.length(result.planLength))
                                     : PathText::tr("In the plan %1, %2 bends")
                                           .arg(units.length(result.planLength), countText(result.bends.size())));
  if (speed > 0) {
    const double time = walkSeconds(result, units.metresPerUnit, speed);
    lines << PathText::tr("%1 at %2 m/s").arg(seconds(time), measureText(speed));
  }
  if (!result.layers.empty()) {
    QStringList layers;
    for (const std::uint32_t layer : result.layers) layers << QString::number(layer);
    if (layers.size() > 12) layers = layers.mid(0, 11) << QStringLiteral("…") << layers.last();
    const QString walked = layers.join(QStringLiteral(" → "));
    lines << (result.layers.size() == 1 ? PathText::tr("On layer %1").arg(walked)
              : result.connections == 1
                  ? PathText::tr("Layers %1 (1 connection)").arg(walked)
                  : PathText::tr("Layers %1 (%2 connections)").arg(walked).arg(result.connections));
  }
  if (!result.steps.empty()) {
    const QString all =
        PathText::tr("%1 up and %2 down in all").arg(units.length(result.climb), units.length(result.descent));
    lines << (result.steps.size() == 1 ? PathText::tr("1 step, %1").arg(all)
                                       : PathText::tr("%1 steps, %2").arg(countText(result.steps.size()), all));
  }
  if (!result.gaps.empty())
    lines << (result.gaps.size() == 1 ? PathText::tr("1 gap stepped over")
                                      : PathText::tr("%1 gaps stepped over").arg(countText(result.gaps.size())));
  if (!result.drops.empty()) {
    const QString deepest = units.length(result.deepestDrop);
    lines << (result.drops.size() == 1
                  ? PathText::tr("1 drop of %1, one way").arg(deepest)
                  : PathText::tr("%1 drops, one way, the deepest %2").arg(countText(result.drops.size()), deepest));
  }
  lines << PathText::tr("Slope up to %1, climbs or falls up to %2")
               .arg(degrees(result.maxSlopeDegrees), degrees(result.maxInclineDegrees));
  return lines.join(QLatin1Char('\n'));
}

}  // namespace footfall::ui
