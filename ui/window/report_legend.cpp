// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/report_legend.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "core/filters/filter_traits.hpp"
#include "footfall/filter.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

constexpr QSize kReportSwatch{30, 15};
constexpr double kRatio = 2;  // reports are also read on large screens
constexpr std::uint32_t kMostLayers = 12;

using Images = std::vector<CaptionedImage>;

void addPaint(Images& images, const std::string& caption, const Paint& paint) {
  images.emplace_back(caption, paintSwatch(paint, kReportSwatch, kRatio).toImage());
}

void addLine(Images& images, const std::string& caption, const QColor& colour) {
  images.emplace_back(caption, lineSwatch(colour, 3, kReportSwatch, kRatio).toImage());
}

void addWalkable(Images& images, const ViewContent& content, const SceneParts& parts) {
  if (content.walkable.empty() || !parts.walkable || isHeatMap(parts.mode)) return;
  if (parts.mode == ViewMode::RejectedBy) return addPaint(images, "Walkable", paleWalkablePaint());
  if (parts.mode == ViewMode::SourceTriangles)
    return addPaint(images, "Walkable; each colour is a triangle of the environment", sourcePaint(0));
  std::uint32_t layers = 0;
  for (const auto& mesh : content.walkable) layers = std::max(layers, mesh->layers);
  if (layers == 0) return addPaint(images, "Walkable", walkablePaint());
  for (std::uint32_t layer = 0; layer < std::min(layers, kMostLayers); ++layer)
    addPaint(images, "Walkable, layer_" + std::to_string(layer), layerPaint(layer));
  if (layers > kMostLayers) {
    images.back().first += "; the others have colours of their own, which come again";
  }
}

void addRemoved(Images& images, const ViewContent& content, const SceneParts& parts) {
  const bool vivid = parts.mode == ViewMode::RejectedBy;
  if (!parts.removed || (parts.mode != ViewMode::Result && !vivid)) return;
  std::vector<const RemovalStyle*> styles;
  if (content.firstRemoval) styles.push_back(content.firstRemoval);
  for (const ViewContent::Removed& removed : content.removed)
    if (std::ranges::find(styles, removed.style) == styles.end()) styles.push_back(removed.style);
  for (const RemovalStyle* style : styles) {
    if (!parts.shows(*style)) continue;
    std::string caption = "Not walkable: removed by " + std::string(filterDescriptor(style->filter).name);
    if (style != removalStyle(style->filter)) caption += ": " + Text(style->removal->legend).str();
    addPaint(images, caption, vivid ? style->vivid : style->paint);
  }
}

}  // namespace

std::vector<CaptionedImage> reportLegend(const ViewContent& content, const SceneParts& parts) {
  Images images;
  addWalkable(images, content, parts);
  const auto has = [&](auto member) {
    return std::ranges::any_of(content.walkable, [member](const auto& mesh) { return !((*mesh).*member).empty(); });
  };
  if (parts.obstacleEdges && has(&NavigationMeshGeometry::obstacleEdges))
    addLine(images, "Obstacle edge: agents cannot cross it", obstacleEdgeColour());
  if (parts.connections && has(&NavigationMeshGeometry::connections))
    addLine(images, "Connection of two layers", connectionColour());
  if (parts.steps && has(&NavigationMeshGeometry::steps)) addLine(images, "Step: agents climb it", stepColour());
  if (parts.gaps && has(&NavigationMeshGeometry::gaps)) addLine(images, "Gap: agents step over it", gapColour());
  if (parts.drops && has(&NavigationMeshGeometry::drops)) addLine(images, "Drop: one way down", dropColour());
  addRemoved(images, content, parts);
  if (parts.environment && parts.mode != ViewMode::WalkableOnly)
    addPaint(images, "Walls, ceilings and the rest", wallPaint());
  return images;
}

}  // namespace footfall::ui
