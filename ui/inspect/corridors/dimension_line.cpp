// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/corridors/dimension_line.hpp"

#include <algorithm>

#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

constexpr float kLinePixels = 4, kMarkPixels = 11;

}  // namespace

void addDimension(ViewOverlay& overlay, const Passage& passage, const QColor& colour, const QString& text) {
  overlay.lines.push_back({{{passage.left, passage.right}}, colour, kLinePixels, outlineColour()});
  overlay.marks.push_back({passage.left, colour, kMarkPixels});
  overlay.marks.push_back({passage.right, colour, kMarkPixels});
  overlay.labels.push_back({passage.place, text});
}

SceneBox boxAround(const Passage& passage, double margin) {
  SceneBox box{passage.place, passage.place};
  for (const Vec3& p : {passage.left, passage.right}) {
    box.lower = {std::min(box.lower.x, p.x), std::min(box.lower.y, p.y), std::min(box.lower.z, p.z)};
    box.upper = {std::max(box.upper.x, p.x), std::max(box.upper.y, p.y), std::max(box.upper.z, p.z)};
  }
  box.lower = {box.lower.x - margin, box.lower.y - margin, box.lower.z};
  box.upper = {box.upper.x + margin, box.upper.y + margin, box.upper.z};
  return box;
}

}  // namespace footfall::ui
