// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level_geometry.hpp"

#include "ui/obstacle_geometry.hpp"

namespace footfall {

LevelGeometry::LevelGeometry(LevelComposer& composer, LevelView& view, QObject* parent)
    : QObject(parent), composer_(composer), view_(view) {
  connect(&composer_, &LevelComposer::edited, this, &LevelGeometry::follow);
  connect(&composer_.parts(), &PartLevel::geometryChanged, this, &LevelGeometry::follow);
}

void LevelGeometry::follow() {
  const auto& base = composer_.parts().geometry();
  if (!composer_.level() || !base) return;
  const std::size_t first = composer_.base()->triangles.size();
  if (base->surface.size() != 3 * first) return;  // of a file with ignored parts: it is still to come
  const auto geometry = withObstacles(base, *composer_.level(), first);
  if (geometry != view_.environmentGeometry()) view_.replaceEnvironment(geometry);
}

}  // namespace footfall
