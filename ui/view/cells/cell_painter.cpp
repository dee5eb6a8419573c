// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/cells/cell_painter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {

QString CellPainter::initialize() {
  const QString problem = buildProgram(cells_.program(), QStringLiteral("cell"));
  if (problem.isEmpty()) cells_.initialize();
  return problem;
}

void CellPainter::release() {
  borders_.reset();
  cells_.release();
}

void CellPainter::setCells(std::shared_ptr<const CellGeometry> geometry, CellColours colours) {
  cells_.setGeometry(std::move(geometry));
  cells_.setColours(std::move(colours));
  marked_ = {};
  bordersPending_ = true;
}

void CellPainter::uploadBorders() {
  if (!std::exchange(bordersPending_, false)) return;
  borders_ = geometry() ? strokes_.batches().makeLines(geometry(), geometry()->borders) : nullptr;
  if (borders_) strokes_.batches().uploadNow(*borders_);
}

void CellPainter::updateKinds(const SceneContent& scene) {
  Kinds kinds{scene.environment, scene.content.environmentLayers, strokes_.batches().hiddenLayers()};
  if (kinds == kinds_) return;
  kinds_ = std::move(kinds);
  cells_.setKinds([kinds = kinds_](std::uint32_t source) {
    const bool cover = kinds.environment && kinds.environment->isCover(source);
    const bool hidden = kinds.layers && source < kinds.layers->size() && kinds.hidden.contains((*kinds.layers)[source]);
    return (cover ? kCellOnCover : 0) | (hidden ? kCellHidden : 0);
  });
}

void CellPainter::draw(const SceneContent& scene, const SceneCamera& camera, bool outlines) {
  updateKinds(scene);
  cells_.draw({camera.modelViewProjection, camera.clip, camera.devicePixelRatio, strokes_.leaveCovers()},
              strokes_.slice());
  lines_.begin(camera);
  // Many cells get thin borders, which would hide everything else otherwise.
  constexpr float kMany = 40;
  const auto count = static_cast<float>(geometry()->boxes.size());
  const float pixel = camera.devicePixelRatio * std::clamp(std::sqrt(kMany / count), 0.35F, 1.0F);
  if (outlines) lines_.draw(borders_, outlineColour(), 3.6F * pixel, 1.1e-4F);
  lines_.draw(borders_, cellBorderColour(), 2.0F * pixel, 1.2e-4F);
  lines_.end();
}

void CellPainter::drawMarked(const SceneCamera& camera) {
  SceneBatches& batches = strokes_.batches();
  for (const auto& [cell, colour] :
       {std::pair{marked_.selected, selectedCellColour()}, std::pair{marked_.hovered, hoveredCellColour()}}) {
    if (!cell || *cell >= geometry()->boxes.size()) continue;
    strokes_.beginClip(camera);
    cells_.drawCell({camera.modelViewProjection, camera.clip, camera.devicePixelRatio}, *cell, colour, 0.35F);
    strokes_.endClip();
    const std::vector<LineSegment> box = edgesOf(geometry()->boxes[*cell]);
    const SceneBatchPtr edges = batches.makeLines(nullptr, box);
    batches.uploadNow(*edges);
    strokes_.glDisable(GL_DEPTH_TEST);
    lines_.begin(camera);
    lines_.draw(edges, outlineColour(), 4.4F * camera.devicePixelRatio, 0);
    lines_.draw(edges, colour, 2.4F * camera.devicePixelRatio, 0);
    lines_.end();
    strokes_.glEnable(GL_DEPTH_TEST);
  }
}

}  // namespace footfall::ui
