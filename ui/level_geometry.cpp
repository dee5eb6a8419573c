// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level_geometry.hpp"

#include <new>
#include <utility>

#include "core/environment/environment_edit.hpp"
#include "ui/obstacle_geometry.hpp"

namespace footfall {
namespace {

/// Of `edited`, an edit of what `of` shows: the surfaces that were kept, all lines as they were.
std::shared_ptr<const EnvironmentGeometry> keptOf(const EnvironmentGeometry& of, const Environment& edited) {
  auto kept = std::make_shared<EnvironmentGeometry>(of);
  kept->surface.clear();
  for (const std::uint32_t t : edited.edit->keptTriangles) {
    const auto first = of.surface.begin() + 3 * static_cast<std::ptrdiff_t>(t);
    kept->surface.insert(kept->surface.end(), first, first + 3);
  }
  return kept;
}

}  // namespace

LevelGeometry::LevelGeometry(LevelComposer& composer, LevelView& view, QObject* parent)
    : QObject(parent), composer_(composer), view_(view) {
  connect(&composer_, &LevelComposer::edited, this, &LevelGeometry::follow);
}

void LevelGeometry::setLoaded(std::shared_ptr<const Environment> environment) {
  loaded_ = base_ = std::move(environment);
  ofLoaded_ = ofBase_ = view_.environmentGeometry();
  follow();
}

void LevelGeometry::follow() {
  const auto& level = composer_.level();
  if (!level || !ofLoaded_) return;
  if (composer_.base() != base_) makeBase();
  const auto geometry = withObstacles(ofBase_, *level, composer_.base()->triangles.size());
  if (geometry != view_.environmentGeometry()) view_.replaceEnvironment(geometry);
}

void LevelGeometry::makeBase() {
  base_ = composer_.base();
  if (base_ == loaded_) {
    ofBase_ = ofLoaded_;
    return;
  }
  const bool ofEdit = base_->edit && base_->edit->base.lock() == loaded_;
  ofBase_ = ofEdit ? keptOf(*ofLoaded_, *base_) : makeEnvironmentGeometry(*base_, ofLoaded_->centre);
  if (!ofEdit) return;
  queue_.post([this, base = base_, centre = ofLoaded_->centre] {
    std::shared_ptr<const EnvironmentGeometry> made;
    try {
      made = makeEnvironmentGeometry(*base, centre);
    } catch (const std::bad_alloc&) {
      return;  // some lines too many
    }
    QMetaObject::invokeMethod(
        this,
        [this, base, made] {
          if (base != base_) return;
          ofBase_ = made;
          follow();
        },
        Qt::QueuedConnection);
  });
}

}  // namespace footfall
