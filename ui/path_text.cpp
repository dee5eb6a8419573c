// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path_text.hpp"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace footfall {
namespace {

/// For the translations.
struct PathText {
  Q_DECLARE_TR_FUNCTIONS(footfall::PathText)
};

QString seconds(double time) {
  if (time < 60) return PathText::tr("%1 s").arg(QString::number(time, 'f', 1));
  const int whole = static_cast<int>(std::lround(std::min(time, 1e8)));
  return PathText::tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
}

QString degrees(double angle) { return QString::number(angle, 'f', 1) + QStringLiteral("°"); }

}  // namespace

QString measureText(double value) {
  const double size = std::fabs(value);
  if (size != 0 && (size < 1e-4 || size >= 1e7)) return QString::number(value, 'g', 6);
  const int decimals = size >= 1000 ? 1 : size >= 10 ? 2 : 3;
  QString text = QString::number(value, 'f', size < 0.1 ? 5 : decimals);
  while (text.contains(QLatin1Char('.')) && text.endsWith(QLatin1Char('0'))) text.chop(1);
  if (text.endsWith(QLatin1Char('.'))) text.chop(1);
  return text == QLatin1String("-0") ? QStringLiteral("0") : text;
}

QString placeText(const Vec3& place) {
  return QStringLiteral("%1, %2, %3").arg(measureText(place.x), measureText(place.y), measureText(place.z));
}

QString failureText(const PathResult& result) {
  switch (result.status) {
    case PathStatus::Found:
      return {};
    case PathStatus::NothingWalkable:
      return PathText::tr("Nothing is walkable here.");
    case PathStatus::StartNotWalkable:
      return PathText::tr("The start is not walkable. The nearest place that is lies %1 away, at %2.")
          .arg(measureText(result.start->distance), placeText(result.start->position));
    case PathStatus::TargetNotWalkable:
      return PathText::tr("The target is not walkable. One can come as near as %1 to it, at %2.")
          .arg(measureText(result.end->distance), placeText(result.end->position));
    case PathStatus::NotConnected:
      return PathText::tr(
                 "No way leads there: start and target are on separate parts. One can come as near as %1, at %2.")
          .arg(measureText(result.end->distance), placeText(result.end->position));
  }
  return {};
}

QString pathText(const PathResult& result, double metresPerUnit, double speed) {
  if (!result.hasPath()) return {};
  QStringList lines;
  const double metres = result.length * metresPerUnit;
  lines << (metresPerUnit == 1
                ? PathText::tr("Length %1 m").arg(measureText(result.length))
                : PathText::tr("Length %1 units (%2 m)").arg(measureText(result.length), measureText(metres)));
  lines
      << (result.bends.size() == 1
              ? PathText::tr("In the plan %1, 1 bend").arg(measureText(result.planLength))
              : PathText::tr("In the plan %1, %2 bends").arg(measureText(result.planLength)).arg(result.bends.size()));
  if (speed > 0) lines << PathText::tr("%1 at %2 m/s").arg(seconds(metres / speed), measureText(speed));
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
  lines << PathText::tr("Slope up to %1, climbs or falls up to %2")
               .arg(degrees(result.maxSlopeDegrees), degrees(result.maxInclineDegrees));
  return lines.join(QLatin1Char('\n'));
}

}  // namespace footfall
