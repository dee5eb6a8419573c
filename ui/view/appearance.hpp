// All colours, paints and patterns of the view, its legend and the tests.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPixmap>
#include <QString>
#include <cstdint>

namespace footfall {
enum class FilterType : std::uint8_t;
}

namespace footfall::ui {

/// Patterns are drawn over a paint, so that removed floors differ from layers in more than colour. The numbers are
/// those of shaders/surface.frag.
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

/// The paint of walls, ceilings and all other surfaces that face sideways or down.
Paint wallPaint();
/// The paint of floors for which no filter has decided yet.
Paint undecidedPaint();
/// The paint of walkable area without layers.
Paint walkablePaint();
/// The paints of layers: six colours that people with the common colour deficiencies can distinguish (Okabe and Ito
/// 2008, without the vermilion, which is kept for obstacle edges), then the same ones darker and lighter.
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

/// The paint of walkable area in modes that show the reasons of removals.
Paint paleWalkablePaint();
/// The paint of pieces of one triangle of the environment. Neighbours may share a colour, so their border needs a line.
Paint sourcePaint(std::uint32_t triangle);
/// The colours of edges and of the area between them, in wireframes and hidden-line pictures.
QColor wireColour();
QColor hiddenLineFill();
/// The colour of a value from 0 (dark) to 1 (light): viridis, perceptually uniform also with the common colour
/// deficiencies (Smith and van der Walt 2015).
QColor heatColour(double value);

/// The reasons why floors are not walkable: the filter that removed them, and for a RadiusFilter the kind of border
/// that is too near. A RadiusFilter without a clearance before it does not distinguish walls from ledges (NearBorder).
enum class Removal : std::uint8_t { TooSteep, TooLow, NearBorder, NearWall, NearLedge, Unreachable, TooSmall };

/// The display of floors that were removed for one reason.
struct RemovalStyle {
  Removal removal{};
  FilterType filter{};
  QString reason;  ///< name in the legend, e.g. "Too steep"
  Paint paint;
  Paint vivid;  ///< paint in modes that show only the reasons
};

const RemovalStyle& removalStyle(Removal removal);
/// The style of a filter's removals; NearBorder for a RadiusFilter. Null for filters that remove no places, or none
/// that need a colour.
const RemovalStyle* removalStyle(FilterType filter);

/// A small picture of a paint, with the pattern of the view, for legends.
QPixmap paintSwatch(const Paint& paint, const QSize& size, qreal devicePixelRatio);
/// A small picture of a line.
QPixmap lineSwatch(const QColor& colour, qreal width, const QSize& size, qreal devicePixelRatio,
                   Qt::PenStyle style = Qt::SolidLine);

}  // namespace footfall::ui
