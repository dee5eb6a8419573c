// All colours, paints and patterns of the view, its legend and the tests.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPixmap>
#include <QString>
#include <cstdint>

#include "core/base/fill_pattern.hpp"
#include "footfall/place_verdict.hpp"

namespace footfall {
enum class FilterType : std::uint8_t;
namespace detail {
struct Removal;
}
}  // namespace footfall

namespace footfall::ui {

using detail::FillPattern;

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

/// How floors are shown that a filter removed for one reason: by the descriptor of the filter.
struct RemovalStyle {
  unsigned number = 0;  ///< its place among all styles
  FilterType filter{};
  const detail::Removal* removal = nullptr;
  QString reason;  ///< for the legend, e.g. "Too steep"
  Paint paint;
  Paint vivid;  ///< paint in modes that show only the reasons
};

/// The style of the most general reason for which a filter removes floors. A RadiusFilter without a clearance before it
/// does not know walls from ledges, and has that one. Null for filters that remove no places, or none that are worth a
/// colour.
const RemovalStyle* removalStyle(FilterType filter);
/// Null for a removal without a paint.
const RemovalStyle* removalStyle(const detail::Removal& removal);
/// The style of a verdict that one filter alone has; never Removed.
const RemovalStyle& removalStyle(PlaceVerdict verdict);

/// A small picture of a paint, with the pattern of the view, for legends.
QPixmap paintSwatch(const Paint& paint, const QSize& size, qreal devicePixelRatio);
/// A small picture of a line.
QPixmap lineSwatch(const QColor& colour, qreal width, const QSize& size, qreal devicePixelRatio,
                   Qt::PenStyle style = Qt::SolidLine);

}  // namespace footfall::ui
