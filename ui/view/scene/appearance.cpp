// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/appearance.hpp"

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/filters/filter_traits.hpp"
#include "footfall/filter.hpp"
#include "ui/base/look/core_colours.hpp"
#include "ui/base/look/theme.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"

namespace footfall::ui {
namespace {

// The pattern of shaders/surface.frag, where y points down; here it points up.
bool inked(FillPattern pattern, double x, double y) {
  const auto wrap = [](double value, double period) { return value - period * std::floor(value / period); };
  switch (pattern) {
    case FillPattern::Plain:
      return false;
    case FillPattern::RisingStripes:
      return wrap(x + y, 8) <= 2.5;
    case FillPattern::FallingStripes:
      return wrap(x - y, 8) <= 2.5;
    case FillPattern::Dots:
      return std::hypot(wrap(x, 6) - 3, wrap(y, 6) - 3) <= 1.6;
    case FillPattern::Grid:
      return wrap(x, 8) <= 2 || wrap(y, 8) <= 2;
    case FillPattern::LevelStripes:
      return wrap(y, 8) <= 2.5;
    case FillPattern::UprightStripes:
      return wrap(x, 8) <= 2.5;
  }
  return false;
}

}  // namespace

Paint wallPaint() { return {QColor(196, 199, 203), FillPattern::Plain}; }
Paint undecidedPaint() { return {QColor(222, 224, 227), FillPattern::Plain}; }
Paint walkablePaint() { return {toColour(kBluishGreen), FillPattern::Plain}; }

Paint layerPaint(std::uint32_t layer) { return {numberedColour(kLayerColours, layer), FillPattern::Plain}; }

QColor obstacleEdgeColour() { return {213, 60, 0}; }
QColor connectionColour() { return {255, 255, 255}; }
QColor stepColour() { return {255, 220, 60}; }
QColor gapColour() { return {250, 170, 60}; }    // drawn as dashes
QColor dropColour() { return {240, 110, 190}; }  // drawn as arrows, so that the shape differs as well
QColor outlineColour() { return {28, 40, 48}; }
QColor creaseColour() { return {118, 123, 130}; }
QColor cellBorderColour() { return {255, 255, 255}; }
QColor hoveredCellColour() { return {255, 255, 255}; }
QColor selectedCellColour() { return {255, 196, 0}; }
QColor backgroundLower() { return isDarkTheme() ? QColor(44, 49, 55) : QColor(247, 248, 250); }
QColor backgroundUpper() { return isDarkTheme() ? QColor(24, 27, 31) : QColor(221, 227, 234); }

Paint paleWalkablePaint() { return {QColor(226, 238, 233), FillPattern::Plain}; }

Paint sourcePaint(std::uint32_t triangle) {
  // Neighbours in the file are often neighbours in space, so their numbers are scattered.
  return layerPaint((triangle * 2654435761U >> 16U) % 18);
}

QColor wireColour() { return {70, 78, 88}; }
QColor hiddenLineFill() { return {250, 250, 251}; }

QColor heatColour(double value) {
  static const std::array<QColor, 11> kViridis = {
      QColor(0x44, 0x01, 0x54), QColor(0x48, 0x24, 0x75), QColor(0x41, 0x44, 0x87), QColor(0x35, 0x5F, 0x8D),
      QColor(0x2A, 0x78, 0x8E), QColor(0x21, 0x90, 0x8C), QColor(0x22, 0xA8, 0x84), QColor(0x44, 0xBF, 0x70),
      QColor(0x7A, 0xD1, 0x51), QColor(0xBB, 0xDF, 0x27), QColor(0xFD, 0xE7, 0x25)};
  const double place = std::clamp(value, 0.0, 1.0) * (kViridis.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
  const auto part = static_cast<float>(place - static_cast<double>(first));
  const QColor& a = kViridis[first];
  const QColor& b = kViridis[first + 1];
  const auto mixed = [part](float from, float to) { return from + part * (to - from); };
  return QColor::fromRgbF(mixed(a.redF(), b.redF()), mixed(a.greenF(), b.greenF()), mixed(a.blueF(), b.blueF()));
}

namespace {

// The styles of all removals with a paint, in the order of the filters.
const std::vector<RemovalStyle>& removalStyles() {
  static const std::vector<RemovalStyle> kStyles = [] {
    std::vector<RemovalStyle> styles;
    for (const FilterDescriptor& filter : filterDescriptors()) {
      for (const Removal& removal : filter.traits->removals) {
        if (!removal.paint) continue;
        const auto& [pale, vivid, pattern] = *removal.paint;
        styles.push_back({static_cast<unsigned>(styles.size()),
                          filter.type,
                          &removal,
                          coreText(removal.legend),
                          {toColour(pale), pattern},
                          {toColour(vivid), pattern}});
      }
    }
    return styles;
  }();
  return kStyles;
}

template <class Test>
const RemovalStyle* findStyle(const Test& test) {
  const auto found = std::ranges::find_if(removalStyles(), test);
  return found == removalStyles().end() ? nullptr : &*found;
}

}  // namespace

const RemovalStyle* removalStyle(FilterType filter) {
  return findStyle([filter](const RemovalStyle& style) { return style.filter == filter; });
}

const RemovalStyle* removalStyle(const Removal& removal) {
  return findStyle([&removal](const RemovalStyle& style) { return style.removal == &removal; });
}

const RemovalStyle& removalStyle(PlaceVerdict verdict) {
  return *findStyle([verdict](const RemovalStyle& style) { return style.removal->verdict == verdict; });
}

QPixmap paintSwatch(const Paint& paint, const QSize& size, qreal devicePixelRatio) {
  QImage image(size * devicePixelRatio, QImage::Format_RGB32);
  const QColor ink =
      QColor::fromRgbF(paint.colour.redF() * 0.55F, paint.colour.greenF() * 0.55F, paint.colour.blueF() * 0.55F);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const bool dark = inked(paint.pattern, (x + 0.5) / devicePixelRatio, (y + 0.5) / devicePixelRatio);
      const bool border = x == 0 || y == 0 || x == image.width() - 1 || y == image.height() - 1;
      image.setPixelColor(x, y, border ? outlineColour() : dark ? ink : paint.colour);
    }
  }
  image.setDevicePixelRatio(devicePixelRatio);
  return QPixmap::fromImage(image);
}

QPixmap lineSwatch(const QColor& colour, qreal width, const QSize& size, qreal devicePixelRatio, Qt::PenStyle style) {
  QPixmap pixmap(size * devicePixelRatio);
  pixmap.setDevicePixelRatio(devicePixelRatio);
  // Lines are seen on walkable area.
  pixmap.fill(walkablePaint().colour.darker(125));
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colour, width, style, Qt::FlatCap));
  painter.drawLine(QPointF(0, size.height() / 2.0), QPointF(size.width(), size.height() / 2.0));
  return pixmap;
}

}  // namespace footfall::ui
