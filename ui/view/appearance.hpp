// What things look like, in one place: the view, the legend and the tests ask here.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPixmap>
#include <QString>
#include <cstdint>

#include "footfall/filter.hpp"

namespace footfall::ui {

/// Drawn over a paint, so that what was removed differs from layers in more than colour. The numbers are those of
/// shaders/surface.frag.
enum class FillPattern : std::uint8_t {
  Plain = 0,
  RisingStripes = 1,
  FallingStripes = 2,
  Dots = 3,
  Grid = 4,
  LevelStripes = 5,
  UprightStripes = 6
};

struct Paint {
  QColor colour;
  FillPattern pattern = FillPattern::Plain;
  bool operator==(const Paint&) const = default;
};

/// Walls, ceilings and whatever else faces sideways or down.
Paint wallPaint();
/// Floors for which no filter has decided yet.
Paint undecidedPaint();
/// Walkable area without layers.
Paint walkablePaint();
/// Layers: six colours that people with the common colour deficiencies can tell apart (Okabe and Ito 2008, without
/// the vermilion, which is kept for obstacle edges), then the same ones darker and lighter.
Paint layerPaint(std::uint32_t layer);

QColor obstacleEdgeColour();
QColor connectionColour();
QColor stepColour();
QColor gapColour();
QColor dropColour();
QColor outlineColour();
QColor creaseColour();
QColor cellBorderColour();
QColor hoveredCellColour();
QColor selectedCellColour();
QColor backgroundLower();
QColor backgroundUpper();

/// Walkable area where the reasons for what is not are of interest.
Paint paleWalkablePaint();
/// Pieces of one triangle of the environment; neighbours may share a colour, so their border needs a line.
Paint sourcePaint(std::uint32_t triangle);
/// In wireframes and hidden-line pictures: edges, and what lies between them.
QColor wireColour();
QColor hiddenLineFill();
/// From 0 (dark) to 1 (light): viridis, evenly spaced to the eye also with the common colour deficiencies (Smith and
/// van der Walt 2015).
QColor heatColour(double value);

/// Why floors are not walkable: by the filter that removed them, and for a RadiusFilter by what is too near. Without a
/// clearance before it, it does not know walls from ledges (NearBorder).
enum class Removal : std::uint8_t { TooSteep, TooLow, NearBorder, NearWall, NearLedge, Unreachable, TooSmall };

/// How floors are shown that were removed for one reason.
struct RemovalStyle {
  Removal removal{};
  FilterType filter{};
  QString reason;  ///< for the legend, e.g. "Too steep"
  Paint paint;
  Paint vivid;  ///< where only the reasons are of interest
};

const RemovalStyle& removalStyle(Removal removal);
/// Null for filters that remove no places (or none that are worth a colour); NearBorder for a RadiusFilter.
const RemovalStyle* removalStyle(FilterType filter);

/// A small picture of a paint, with the pattern of the view, for legends.
QPixmap paintSwatch(const Paint& paint, const QSize& size, qreal devicePixelRatio);
/// A small picture of a line.
QPixmap lineSwatch(const QColor& colour, qreal width, const QSize& size, qreal devicePixelRatio,
                   Qt::PenStyle style = Qt::SolidLine);

}  // namespace footfall::ui
