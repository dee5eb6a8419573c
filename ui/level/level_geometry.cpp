// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/level_geometry.hpp"

#include <QMetaObject>
#include <cstddef>
#include <new>

#include "ui/view/geometry/obstacle_geometry.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kAtOnce = 250'000;  // triangles, which take 5 ms

}  // namespace

LevelGeometry::LevelGeometry(LevelComposer& composer, LevelView& view, QObject* parent)
    : QObject(parent), composer_(composer), view_(view) {
  connect(&composer_, &LevelComposer::edited, this, &LevelGeometry::follow);
  connect(&composer_.parts(), &PartLevel::geometryChanged, this, &LevelGeometry::follow);
}

void LevelGeometry::show(const std::shared_ptr<const EnvironmentGeometry>& geometry) {
  if (geometry != view_.environmentGeometry()) view_.replaceEnvironment(geometry);
}

void LevelGeometry::follow() {
  const auto& base = composer_.parts().geometry();
  const auto& level = composer_.level();
  if (!level || !base) return;
  const std::size_t first = composer_.base()->triangles.size();
  if (base->surface.size() != 3 * first) return;  // the geometry of a file with ignored parts is not ready yet
  if (first <= kAtOnce || level->triangles.size() == first) {
    show(withObstacles(base, *level, first));
    return;
  }
  queue_.post([this, base, level, first] {
    std::shared_ptr<const EnvironmentGeometry> made;
    try {
      made = withObstacles(base, *level, first);
    } catch (const std::bad_alloc&) {
      return;  // the run reports it
    }
    QMetaObject::invokeMethod(
        this,
        [this, level, made] {
          if (composer_.level() == level) show(made);  // else it was overtaken
        },
        Qt::QueuedConnection);
  });
}

}  // namespace footfall::ui
